//! What bends light: a medium whose index of refraction varies, or a black hole.

use super::level;
use super::piece::Phase;
use crate::math::{Real, Vec3};
use crate::scene::{BlackHole, Profile};

/// What bends light.
pub(super) trait Field<T: Real> {
    /// x″ = ½∇(n²) at a point.
    fn acceleration(&self, position: Vec3<T>) -> Vec3<T>;

    /// The longest step in τ that does not go past anything.
    fn longest(&self, phase: &Phase<T>) -> T;

    /// What [`Steps::Fixed`](crate::scene::Steps::Fixed) counts lengths in.
    fn unit(&self, position: Vec3<T>) -> T;
}

/// A profile, by a tracer of such effects.
pub(super) struct Graded<'p, 'a, T, const EFFECTS: u64>(pub &'p Profile<'a, T>);

impl<T: Real, const EFFECTS: u64> Field<T> for Graded<'_, '_, T, EFFECTS> {
    fn acceleration(&self, position: Vec3<T>) -> Vec3<T> {
        let (level, up) = level::with_gradient::<T, EFFECTS>(&self.0.level, position);
        up * (T::HALF * self.0.square::<EFFECTS>(level).slope)
    }

    /// A step changes the level by no more than the length over which the law changes its ways.
    fn longest(&self, phase: &Phase<T>) -> T {
        let feature = self.0.feature();
        let &Phase { position, momentum, acceleration } = phase;
        let (_, up) = level::with_gradient::<T, EFFECTS>(&self.0.level, position);
        let speed = momentum.dot(up).abs();
        let turn = level::curvature::<T, EFFECTS>(&self.0.level, position) * momentum.length_squared();
        let bend = ((acceleration.dot(up).abs() + turn) * feature * T::HALF).sqrt();
        let slowest = T::from_f32(1e-6) * momentum.length();
        // A level never changes by more than the way.
        (feature / (speed + bend).max(slowest)).max(feature / momentum.length())
    }

    fn unit(&self, _position: Vec3<T>) -> T {
        T::ONE
    }
}

/// A black hole and a path around it.
pub(super) struct Orbit<'h, T> {
    pub hole: &'h BlackHole<T>,
    /// |x × x′|, which the path keeps.
    pub angular_momentum: T,
}

impl<'h, T: Real> Orbit<'h, T> {
    pub(super) fn new(hole: &'h BlackHole<T>, position: Vec3<T>, momentum: Vec3<T>) -> Self {
        Self { hole, angular_momentum: (position - hole.center).cross(momentum).length() }
    }

    pub(super) fn distance(&self, position: Vec3<T>) -> T {
        (position - self.hole.center).length()
    }
}

impl<T: Real> Field<T> for Orbit<'_, T> {
    /// The orbits of light, u″ + u = 3M·u² for u = 1/r as a function of the angle, are those of x″ = −3M·h²·x/r⁵ with the
    /// angular momentum h: a medium with n² = 1 + 2M·h²/r³.
    fn acceleration(&self, position: Vec3<T>) -> Vec3<T> {
        let away = position - self.hole.center;
        let inverse = T::ONE / away.length();
        let rate = self.angular_momentum * inverse;
        away * (-T::from_f32(3.0) * self.hole.mass * inverse * rate * rate * inverse * inverse)
    }

    /// Half of the way to the centre.
    fn longest(&self, phase: &Phase<T>) -> T {
        T::HALF * self.distance(phase.position) / phase.momentum.length()
    }

    fn unit(&self, position: Vec3<T>) -> T {
        self.distance(position)
    }
}
