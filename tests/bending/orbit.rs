//! Light around a black hole of the mass 1 in the origin, by u″ + u = 3u² for u = 1/r as a function of the angle.

use std::f64::consts::TAU;

use crate::world::{End, Start, Vector};

/// An orbit in its plane.
#[derive(Clone, Copy, Debug)]
pub struct Orbit {
    /// Unit vectors of the plane: outwards at the start, and along the orbit there.
    frame: [Vector; 2],
    angle: f64,
    /// u and du/dφ.
    state: [f64; 2],
}

/// The angle of a step; the error of a step is of fifth order in it.
const STEP: f64 = 1e-3;

impl Orbit {
    /// The orbit of a path that does not go straight to the hole or away from it.
    pub fn new(start: &Start) -> Self {
        let r = length(start.origin);
        let out = start.origin.map(|x| x / r);
        let cosine = dot(out, start.direction);
        let across = plus(start.direction, -cosine, out);
        let sine = length(across);
        let state = [1.0 / r, -cosine / (r * sine)];
        Self { frame: [out, across.map(|x| x / sine)], angle: 0.0, state }
    }

    /// Where it ends, if nothing but a sphere around the hole is in its way; after ten times around it is out of steps. The
    /// distance is not worked out.
    pub fn end(mut self, sphere: Option<f64>) -> End {
        // The light comes from inside of the sphere.
        let rim = sphere.map_or(0.0, |radius| 1.0 / radius);
        while self.angle < 10.0 * TAU {
            let next = self.after(STEP);
            if next.state[0] <= rim {
                let there = self.after(root(STEP, |step| self.after(step).state[0] - rim));
                let (point, direction) = there.place();
                let away = End::Away(there.frame_vector([there.angle.cos(), there.angle.sin()]));
                return sphere.map_or(away, |_| End::Surface { object: 0, point, direction, distance: f64::NAN });
            }
            if next.state[0] >= 0.5 {
                return End::Captured;
            }
            self = next;
        }
        End::OutOfSteps
    }

    /// Where the orbit is, and where it goes there.
    pub fn place(&self) -> (Vector, Vector) {
        let ([u, slope], (sine, cosine)) = (self.state, self.angle.sin_cos());
        let point = self.frame_vector([cosine / u, sine / u]);
        // −u′·r̂ + u·φ̂
        let along = self.frame_vector([-slope * cosine - u * sine, -slope * sine + u * cosine]);
        let size = length(along);
        (point, along.map(|x| x / size))
    }

    /// The orbit after an angle, by the classical method of Runge and Kutta.
    pub fn after(&self, step: f64) -> Self {
        let slope = |[u, v]: [f64; 2]| [v, 3.0 * u * u - u];
        let moved = |s: f64, [u, v]: [f64; 2]| [self.state[0] + s * u, self.state[1] + s * v];
        let a = slope(self.state);
        let b = slope(moved(step / 2.0, a));
        let c = slope(moved(step / 2.0, b));
        let d = slope(moved(step, c));
        let mean = [0, 1].map(|i| (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) / 6.0);
        Self { angle: self.angle + step, state: moved(step, mean), ..*self }
    }

    fn frame_vector(&self, [x, y]: [f64; 2]) -> Vector {
        let [a, b] = self.frame;
        [0, 1, 2].map(|i| x * a[i] + y * b[i])
    }
}

/// Where a function that is above 0 at 0, and not at `end`, gets there: by halving.
fn root(end: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (0.0, end);
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        *(if f(middle) > 0.0 { &mut low } else { &mut high }) = middle;
    }
    high
}

/// The impact parameter of light at a place: what its closest distance would be, had it come straight from far away.
pub fn impact_parameter(point: Vector, direction: Vector) -> f64 {
    let r = length(point);
    let cosine = dot(point, direction) / r;
    let sine = length(plus(direction, -cosine / r, point));
    r * sine / (1.0 - 2.0 * sine * sine / r).sqrt()
}

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// a + s·b
pub fn plus(a: Vector, s: f64, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] + s * b[i])
}
