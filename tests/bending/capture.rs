//! Where the light begins that a black hole keeps: at the impact parameter 3√3·M.

use whit::scene::Steps;

use crate::exact::deflection::CRITICAL;
use crate::orbit::impact_parameter;
use crate::support::{ENOUGH, assert_below, halved, hole, order, start};
use crate::world::{End, Number, Start, World};

/// Whether a path ends in the hole.
pub fn is_captured<T: Number>(world: &World<'_>, start: &Start) -> bool {
    match world.follow::<T>(start, ENOUGH) {
        End::Captured => true,
        End::Away(_) => false,
        other => panic!("{other:?}: {start:?}"),
    }
}

/// Between which two neighbouring starts, of those from `low`, which is captured, to `high`, the first goes away.
pub fn edge<T: Number>(world: &World<'_>, start: impl Fn(f64) -> Start, low: f64, high: f64) -> f64 {
    let (mut low, mut high) = (low, high);
    assert!(is_captured::<T>(world, &start(low)) && !is_captured::<T>(world, &start(high)));
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        *(if is_captured::<T>(world, &start(middle)) { &mut low } else { &mut high }) = middle;
    }
    high
}

/// The relative error of the edge for light that comes along the x axis.
fn error<T: Number>(steps: Steps<f64>, distance: f64) -> f64 {
    let at = |b| start(-distance, b, 0.0);
    let Start { origin, direction } = at(edge::<T>(&hole(steps), at, 4.0, 6.0));
    impact_parameter(origin, direction) / CRITICAL - 1.0
}

#[test]
fn the_edge_is_where_it_should_be() {
    for distance in [20.0, 1e3, 1e6] {
        for tolerance in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
            let steps = Steps::Controlled { tolerance };
            let name = format!("from {distance:e}, {steps:?}");
            assert_below(&format!("{name}, f64"), error::<f64>(steps, distance).abs(), 0.2 * tolerance);
            assert_below(&format!("{name}, f32"), error::<f32>(steps, distance).abs(), 0.2 * tolerance + 5e-6);
        }
        for length in [0.1, 0.05, 0.02, 0.01] {
            let steps = Steps::Fixed { length };
            let name = format!("from {distance:e}, {steps:?}");
            assert_below(&format!("{name}, f64"), error::<f64>(steps, distance).abs(), 0.2 * length * length);
            assert_below(&format!("{name}, f32"), error::<f32>(steps, distance).abs(), 0.2 * length * length + 1e-5);
        }
    }
}

#[test]
fn fixed_steps_are_of_second_order() {
    let order = order("edge", &halved(0.1, 5), |length| error::<f64>(Steps::Fixed { length }, 100.0).abs());
    assert!((1.9..2.1).contains(&order), "{order}");
}
