//! Transparent bodies whose surfaces coincide or touch: where light gets out of one it gets into the other, and none of
//! them is forgotten.

use whit::{Rgb, Vec3};

use crate::overlapping_media::{cup, tank};
use crate::regions::{Body, Filled, wrong_rays};

const FIRST: Rgb<f32> = Rgb::new(0.5, 0.0, 0.0);
const SECOND: Rgb<f32> = Rgb::new(0.0, 0.5, 0.1);

fn slab(from: f32, to: f32) -> Body {
    Body::Block { min: Vec3::new(from, -1.0, -1.0), max: Vec3::new(to, 1.0, 1.0) }
}

/// Rays from outside and from inside, whichever body is first in the list.
fn wrong(name: &str, mut bodies: Vec<Filled>, target: [f64; 3], reach: f64) -> usize {
    let mut sum = 0;
    for _ in 0..2 {
        let from = [4.0, 0.1].map(|away| wrong_rays(&bodies, away, target, reach, 2000));
        println!("{name}: {} of 2000 rays from outside are wrong, {} from inside", from[0], from[1]);
        sum += from[0] + from[1];
        bodies.reverse();
    }
    sum
}

#[test]
fn side_by_side() {
    let sum = [[None, None], [Some(1), Some(2)]].map(|priorities| {
        let bodies = vec![(slab(0.0, 0.5), FIRST, priorities[0]), (slab(0.5, 1.5), SECOND, priorities[1])];
        wrong("side by side", bodies, [0.5, 0.0, 0.0], 1.0)
    });
    assert_eq!(sum, [0; 2]);
}

#[test]
fn one_in_the_end_of_another() {
    let sum = [(0.0, 0.5), (0.5, 1.0)].map(|(from, to)| {
        let bodies = vec![(slab(0.0, 1.0), FIRST, Some(1)), (slab(from, to), SECOND, Some(2))];
        wrong("one in the end of another", bodies, [0.5, 0.0, 0.0], 1.0)
    });
    assert_eq!(sum, [0; 2]);
}

#[test]
fn the_same() {
    let slabs = vec![(slab(0.0, 1.0), FIRST, Some(1)), (slab(0.0, 1.0), SECOND, Some(2))];
    let ball = Body::Ball { center: Vec3::new(0.5, 0.1, 0.0), radius: 0.9 };
    let balls = vec![(ball, FIRST, Some(1)), (ball, SECOND, Some(2))];
    assert_eq!([wrong("slabs", slabs, [0.5, 0.0, 0.0], 1.0), wrong("balls", balls, [0.5, 0.0, 0.0], 1.0)], [0; 2]);
}

/// Water whose wall is the inner wall of the glass.
#[test]
fn water_in_a_glass() {
    let sums = [("cup", cup(0.0)), ("tank", tank(0.0))]
        .map(|(name, bodies)| wrong(name, bodies.to_vec(), [0.0, 1.0, 0.0], 1.2));
    assert_eq!(sums, [0; 2]);
}

/// Balls that touch from inside and from outside, seen near where they touch.
#[test]
fn touching_balls() {
    let big = Body::Ball { center: Vec3::ZERO, radius: 1.0 };
    let sums = [0.5, 1.5].map(|y| {
        let small = Body::Ball { center: Vec3::new(0.0, y, 0.0), radius: 0.5 };
        let bodies = vec![(big, FIRST, Some(1)), (small, SECOND, Some(2))];
        [0.1, 0.01].map(|reach| wrong("touching balls", bodies.clone(), [0.0, 1.0, 0.0], reach))
    });
    assert_eq!(sums, [[0; 2]; 2]);
}
