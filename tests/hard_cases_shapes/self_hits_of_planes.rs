//! Rays that leave planes and discs do not meet them again.

use whit::Shape;

use crate::exact::{exact, plus, rounded, times, unit};
use crate::random::Random;
use crate::self_hits::{Form, across, assert_never_met_again};

#[test]
fn planes() {
    let make = |random: &mut Random| {
        let (point, normal) = (random.point_of_decades(8.0), rounded(across(random)));
        let shape = Shape::plane(point, normal);
        let aside = unit(crate::exact::cross(exact(normal), random.direction()));
        (shape, plus(exact(point), times(aside, random.decades(8.0))))
    };
    assert_never_met_again((23, Form::Flat, false), make, |shape| *shape);
}

#[test]
fn discs() {
    let make = |random: &mut Random| {
        let (center, normal, radius) = (random.point_of_decades(8.0), rounded(across(random)), random.decades(8.0));
        let aside = unit(crate::exact::cross(exact(normal), random.direction()));
        let target = plus(exact(center), times(aside, radius * random.unit()));
        (Shape::disc(center, normal, radius as f32), target)
    };
    assert_never_met_again((24, Form::Flat, false), make, |shape| *shape);
}
