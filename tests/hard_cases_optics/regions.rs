//! How far light goes in which of several bodies that may overlap, worked out in `f64` from what the bodies enclose; and
//! the same bodies as media that only attenuate, for the library to tell the same by what is left of the light.

use whit::scene::{Interface, Medium};
use whit::{Background, Material, Object, Ray, Rgb, Shape, Vec3};

use crate::support::{Nested, Random, dot, double, plus, scene, shoot, single};

/// A body around the y axis or in line with the axes.
#[derive(Clone, Copy, Debug)]
pub enum Body {
    Ball { center: Vec3<f32>, radius: f32 },
    Block { min: Vec3<f32>, max: Vec3<f32> },
    Pillar { radius: f32, bottom: f32, top: f32 },
}

/// A body, its attenuation and, if it has one, its priority.
pub type Filled = (Body, Rgb<f32>, Option<u8>);

impl Body {
    fn shape(&self) -> Shape<'static, f32> {
        match *self {
            Self::Ball { center, radius } => Shape::sphere(center, radius),
            Self::Block { min, max } => Shape::axis_box(min, max),
            Self::Pillar { radius, bottom, top } => {
                Shape::cylinder(Vec3::new(0.0, bottom, 0.0), Vec3::new(0.0, top, 0.0), radius).capped()
            }
        }
    }

    fn encloses(&self, p: [f64; 3]) -> bool {
        match *self {
            Self::Ball { center, radius } => {
                let from = plus(p, -1.0, double(center));
                dot(from, from) < f64::from(radius).powi(2)
            }
            Self::Block { min, max } => (0..3).all(|i| double(min)[i] < p[i] && p[i] < double(max)[i]),
            Self::Pillar { radius, bottom, top } => {
                p[0] * p[0] + p[2] * p[2] < f64::from(radius).powi(2)
                    && f64::from(bottom) < p[1]
                    && p[1] < f64::from(top)
            }
        }
    }

    /// Distances along a ray at which it may go in or out.
    fn crossings(&self, o: [f64; 3], d: [f64; 3]) -> Vec<f64> {
        let roots = |a: f64, b: f64, c: f64| {
            let root = (b * b - a * c).sqrt();
            [(-b - root) / a, (-b + root) / a]
        };
        match *self {
            Self::Ball { center, radius } => {
                let f = plus(o, -1.0, double(center));
                roots(dot(d, d), dot(f, d), dot(f, f) - f64::from(radius).powi(2)).to_vec()
            }
            Self::Block { min, max } => {
                (0..3).flat_map(|i| [min, max].map(|corner| (double(corner)[i] - o[i]) / d[i])).collect()
            }
            Self::Pillar { radius, bottom, top } => {
                let caps = [bottom, top].map(|y| (f64::from(y) - o[1]) / d[1]);
                let (across, b) = (d[0] * d[0] + d[2] * d[2], o[0] * d[0] + o[2] * d[2]);
                let side = roots(across, b, o[0] * o[0] + o[2] * o[2] - f64::from(radius).powi(2));
                [caps, side].concat()
            }
        }
    }
}

/// Objects that light goes straight through.
fn objects(bodies: &[Filled]) -> Vec<Object<'static, f32>> {
    let object = |&(body, attenuation, priority): &Filled| {
        let medium = Medium { priority, ..Medium::VACUUM.with_attenuation(attenuation) };
        let clear = Interface::Constant { reflected: Rgb::BLACK, transmitted: Rgb::WHITE, medium };
        Object::new(body.shape(), Material::dielectric(1.0).with_interface(clear))
    };
    bodies.iter().map(object).collect()
}

/// What is left of white light: in each part of the way, the body of the highest priority takes its share; of equal ones
/// the last.
fn left_of_light(bodies: &[Filled], ray: &Ray<f32>) -> [f64; 3] {
    let (o, d) = (double(ray.origin), double(ray.direction));
    let mut places: Vec<f64> = bodies.iter().flat_map(|(body, ..)| body.crossings(o, d)).collect();
    places.retain(|t| t.is_finite() && *t > 0.0);
    places.push(0.0);
    places.sort_by(f64::total_cmp);
    let mut exponent = [0.0; 3];
    for part in places.windows(2) {
        let middle = plus(o, f64::midpoint(part[0], part[1]), d);
        let inside = bodies.iter().filter(|(body, ..)| body.encloses(middle));
        // The last of equal ones.
        if let Some((_, attenuation, _)) = inside.max_by_key(|(.., priority)| *priority) {
            let c = [attenuation.r, attenuation.g, attenuation.b].map(f64::from);
            exponent = plus(exponent, part[1] - part[0], c);
        }
    }
    exponent.map(|x| (-x).exp())
}

/// How many rays from all around a place, so far away, to within reach of it do not have the light that they should.
pub fn wrong_rays(bodies: &[Filled], away: f64, place: [f64; 3], reach: f64, count: usize) -> usize {
    let objects = objects(bodies);
    let scene = scene(Background::Solid(Rgb::WHITE)).with_objects(&objects);
    let tracer = Nested::try_new(&scene).unwrap();
    let mut random = Random::new(85);
    let is_wrong = |_: &usize| {
        let origin = single(plus(place, away, random.direction()));
        let target = single(plus(place, reach * random.unit(), random.direction()));
        let ray = Ray { origin, direction: (target - origin).normalized() };
        let (light, exact) = (shoot(&tracer, ray, 30).0, left_of_light(bodies, &ray));
        // Where a ray grazes a surface, the length of its way is good to the root of a rounding.
        [light.r, light.g, light.b].into_iter().zip(exact).any(|(found, exact)| (f64::from(found) - exact).abs() > 1e-3)
    };
    (0..count).filter(is_wrong).count()
}
