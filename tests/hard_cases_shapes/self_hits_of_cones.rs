//! Rays that leave cylinders and cones do not meet them again.

use whit::Shape;
use whit::scene::Cone;

use crate::exact::{Vector, exact, plus, rounded, times, unit};
use crate::random::Random;
use crate::self_hits::{Form, across, assert_never_met_again};

/// A cone and a place on its side or at an end.
fn cone(random: &mut Random, sign: f64, taper: f64, capped: bool) -> (Shape<'static, f32>, Vector) {
    let size = random.decades(8.0);
    let base = rounded(times(random.in_cube(), (size * random.decades(4.0)).min(1e11)));
    let (height, radius) = (size, size * random.decades(1.0));
    let up = across(random);
    let apex = rounded(plus(exact(base), times(up, height)));
    let (base_radius, apex_radius) = ((sign * radius) as f32, (sign * radius * taper) as f32);
    let aside = unit(crate::exact::cross(up, random.direction()));
    let (along, reach) = match random.below(4) {
        0 => (0.0, random.unit()),
        1 => (1.0, random.unit()),
        _ => (random.unit(), 1.0),
    };
    let around = plus(times(up, height * along), times(aside, reach * radius * (1.0 + (taper - 1.0) * along)));
    (Shape::Cone(Cone { base, apex, base_radius, apex_radius, capped }), plus(exact(base), around))
}

#[test]
fn cylinders() {
    assert_never_met_again((30, Form::Tube, false), |random| cone(random, 1.0, 1.0, false), |shape| *shape);
    assert_never_met_again((31, Form::Solid, false), |random| cone(random, 1.0, 1.0, true), |shape| *shape);
    assert_never_met_again((32, Form::Solid, true), |random| cone(random, -1.0, 1.0, true), |shape| *shape);
}

#[test]
fn pointed_cones() {
    assert_never_met_again((33, Form::Tube, false), |random| cone(random, 1.0, 0.0, false), |shape| *shape);
    assert_never_met_again((34, Form::Solid, false), |random| cone(random, 1.0, 0.0, true), |shape| *shape);
    assert_never_met_again((35, Form::Solid, true), |random| cone(random, -1.0, 0.0, true), |shape| *shape);
}

#[test]
fn cut_cones() {
    for (number, taper) in [0.99, 0.5, 3.0, 0.1].into_iter().enumerate() {
        let case = 36 + 3 * number as u64;
        assert_never_met_again((case, Form::Tube, false), |random| cone(random, 1.0, taper, false), |shape| *shape);
        assert_never_met_again((case + 1, Form::Solid, false), |random| cone(random, 1.0, taper, true), |shape| *shape);
        assert_never_met_again((case + 2, Form::Solid, true), |random| cone(random, -1.0, taper, true), |shape| *shape);
    }
}
