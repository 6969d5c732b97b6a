//! Transparent bodies that reach into each other: light is attenuated by the one of the highest priority, for every ray.

use whit::{Rgb, Vec3};

use crate::regions::{Body, Filled, wrong_rays};

const GLASS: Rgb<f32> = Rgb::new(0.5, 0.0, 0.0);
const WATER: Rgb<f32> = Rgb::new(0.0, 0.5, 0.1);

/// A cup of glass with water in it, which reaches into the glass by `overlap`.
pub fn cup(overlap: f32) -> [Filled; 3] {
    [
        (Body::Pillar { radius: 1.0, bottom: 0.0, top: 2.0 }, GLASS, Some(1)),
        (Body::Pillar { radius: 0.8, bottom: 0.2, top: 2.5 }, Rgb::BLACK, Some(2)),
        (Body::Pillar { radius: 0.8 + overlap, bottom: 0.2 - overlap, top: 1.3 }, WATER, Some(3)),
    ]
}

/// A tank, the same with corners.
pub fn tank(overlap: f32) -> [Filled; 3] {
    let block = |side: f32, bottom: f32, top: f32| Body::Block {
        min: Vec3::new(-side, bottom, -side),
        max: Vec3::new(side, top, side),
    };
    [
        (block(1.0, 0.0, 2.0), GLASS, Some(1)),
        (block(0.8, 0.2, 2.5), Rgb::BLACK, Some(2)),
        (block(0.8 + overlap, 0.2 - overlap, 1.3), WATER, Some(3)),
    ]
}

/// Water in a glass needs to reach into the wall by no more than the hundred-thousandth part of its size.
#[test]
fn a_slight_overlap_is_enough() {
    for overlap in [1e-5, 1e-4, 1e-3, 1e-2] {
        for mut bodies in [cup(overlap), tank(overlap)] {
            for _ in 0..2 {
                assert_eq!(wrong_rays(&bodies, 4.0, [0.0, 1.0, 0.0], 1.2, 3000), 0, "from outside, {bodies:?}");
                assert_eq!(wrong_rays(&bodies, 0.1, [0.0, 1.0, 0.0], 1.2, 3000), 0, "from inside, {bodies:?}");
                bodies.reverse();
            }
        }
    }
}

#[test]
fn balls_that_cut_each_other_have_a_part_in_common() {
    let ball = |y: f32, radius| Body::Ball { center: Vec3::new(0.0, y, 0.0), radius };
    for (y, radius) in [(1.2, 0.5), (0.8, 0.5), (0.0, 0.3), (0.9, 1.4)] {
        for priorities in [[Some(1), Some(2)], [Some(2), Some(1)], [None, None]] {
            let bodies = [(ball(0.0, 1.0), GLASS, priorities[0]), (ball(y, radius), WATER, priorities[1])];
            assert_eq!(wrong_rays(&bodies, 4.0, [0.0, 0.5, 0.0], 1.5, 3000), 0, "{bodies:?}");
            assert_eq!(wrong_rays(&bodies, 0.1, [0.0, 0.5, 0.0], 1.5, 3000), 0, "{bodies:?}");
        }
    }
}
