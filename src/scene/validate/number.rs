//! Ranges of numbers, checked in constant evaluation.

use crate::math::{Rgb, Vec3};
use crate::scene::Index;

/// The largest coordinate or length: its cube is still far from overflow in `f32`.
pub(super) const FARTHEST: f32 = 1e12;
/// The largest factor or intensity.
pub(super) const BRIGHTEST: f32 = 1e12;

pub(super) const LENGTH: &str = "a finite number of at most 1e12";
pub(super) const POSITIVE: &str = "a number from 1e-12 to 1e12";
pub(super) const AMOUNT: &str = "a number from 0 to 1e12";
pub(super) const SHARE: &str = "a number from 0 to 1";
pub(super) const DIRECTION: &str = "finite numbers, not all zero";

/// A field and what it must be.
pub(in crate::scene) type Fault = (&'static str, &'static str);

pub(super) const fn check(ok: bool, field: &'static str, expected: &'static str) -> Result<(), Fault> {
    if ok { Ok(()) } else { Err((field, expected)) }
}

/// `?` for constant evaluation.
macro_rules! ensure {
    ($result:expr) => {
        if let Err(fault) = $result {
            return Err(fault);
        }
    };
}
pub(super) use ensure;

pub(super) const fn within(x: f32, low: f32, high: f32) -> bool {
    x >= low && x <= high
}

#[inline(never)]
pub(super) const fn length(x: f32, field: &'static str) -> Result<(), Fault> {
    check(within(x, -FARTHEST, FARTHEST), field, LENGTH)
}

#[inline(never)]
pub(super) const fn positive(x: f32, field: &'static str) -> Result<(), Fault> {
    check(within(x, 1e-12, FARTHEST), field, POSITIVE)
}

#[inline(never)]
pub(super) const fn amount(x: f32, field: &'static str) -> Result<(), Fault> {
    check(within(x, 0.0, BRIGHTEST), field, AMOUNT)
}

#[inline(never)]
pub(in crate::scene) const fn point(v: Vec3<f32>, field: &'static str) -> Result<(), Fault> {
    ensure!(length(v.x, field));
    ensure!(length(v.y, field));
    length(v.z, field)
}

#[inline(never)]
pub(in crate::scene) const fn color(c: Rgb<f32>, field: &'static str) -> Result<(), Fault> {
    ensure!(amount(c.r, field));
    ensure!(amount(c.g, field));
    amount(c.b, field)
}

#[inline(never)]
pub(super) const fn share(c: Rgb<f32>, field: &'static str) -> Result<(), Fault> {
    check(within(c.r, 0.0, 1.0) && within(c.g, 0.0, 1.0) && within(c.b, 0.0, 1.0), field, SHARE)
}

pub(super) const fn dot(a: Vec3<f32>, b: Vec3<f32>) -> f32 {
    a.x * b.x + a.y * b.y + a.z * b.z
}

pub(super) const fn minus(a: Vec3<f32>, b: Vec3<f32>) -> Vec3<f32> {
    Vec3::new(a.x - b.x, a.y - b.y, a.z - b.z)
}

/// A direction whose square neither underflows nor overflows.
#[inline(never)]
pub(in crate::scene) const fn direction(v: Vec3<f32>, field: &'static str) -> Result<(), Fault> {
    ensure!(point(v, field));
    check(dot(v, v) > 1e-24, field, DIRECTION)
}

pub(super) const fn unit(v: Vec3<f32>, field: &'static str) -> Result<(), Fault> {
    check(within(dot(v, v), 0.999, 1.001), field, "a vector of length 1")
}

#[inline(never)]
pub(super) const fn refraction(index: &Index<f32>, field: &'static str) -> Result<(), Fault> {
    match *index {
        Index::Constant(n) => refraction_of(n, field),
        Index::Dispersive(n) => {
            ensure!(refraction_of(n.r, field));
            ensure!(refraction_of(n.g, field));
            refraction_of(n.b, field)
        }
        // Of the profile itself, and that it is there, the scene's own check sees to.
        Index::Profile(_) => Ok(()),
    }
}

#[inline(never)]
pub(super) const fn refraction_of(index: f32, field: &'static str) -> Result<(), Fault> {
    check(within(index, 1e-3, 1e3), field, "an index of refraction from 1e-3 to 1e3")
}
