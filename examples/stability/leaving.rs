//! What becomes of rays that leave a surface, for each way to choose their origins.

use whit::{Background, Camera, Effects, Material, Object, Ray, Rgb, Scene, Shape, Tracer, Vec3};

use super::naive::origin::Origin;

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const SHAPES: Effects =
    Effects::SPHERE.with(Effects::BOX).with(Effects::PLANE).with(Effects::DISC).with(Effects::TRIANGLES);
const EFFECTS: u64 = SHAPES.with(Effects::BODY).bits();

/// What went wrong, for rays in a scene whose largest object has about the size `scale`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Failures {
    /// Rays that left a sphere to its outside.
    pub rays: u32,
    /// Of those, the ones that met it again.
    pub self_hits: u32,
    /// Rays that entered a slab of relative thickness 1e-4.
    pub entered: u32,
    /// Of those, the ones that did not meet its other face from inside.
    pub leaks: u32,
    /// Rays that left a sphere towards its neighbour, a gap of 32 roundings of its radius away.
    pub towards_neighbor: u32,
    /// Of those, the ones whose origin was inside of the neighbour or beyond.
    pub jumps: u32,
    /// Where a sphere rests on a plane: how far from the contact the first point in its shadow is, in radii.
    pub contact_gap: f32,
}

/// Sends about `rays` rays of each kind.
#[must_use]
pub fn failures(origin: Origin, scale: f32, rays: u32) -> Failures {
    let mut failures = Failures::default();
    let mut random = fastrand::Rng::with_seed(7);
    leave_a_sphere(&mut failures, origin, scale, rays, &mut random);
    enter_a_slab(&mut failures, origin, scale, rays, &mut random);
    approach_a_neighbor(&mut failures, origin, scale, rays, &mut random);
    failures.contact_gap = contact_gap(origin, scale);
    failures
}

/// A point of the unit sphere.
pub fn unit_vector(random: &mut fastrand::Rng) -> Vec3<f32> {
    loop {
        let v = Vec3::new(random.f32(), random.f32(), random.f32()) * 2.0 - Vec3::splat(1.0);
        if (0.01..1.0).contains(&v.length_squared()) {
            return v.normalized();
        }
    }
}

/// Runs `body` with a tracer of these shapes.
pub fn with_tracer<R>(shapes: &[Shape<'_, f32>], body: impl FnOnce(&Tracer<'_, f32, EFFECTS, 0>) -> R) -> R {
    let camera = Camera::look_at(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, UP, 40.0);
    let objects: Vec<_> = shapes.iter().map(|&shape| Object::new(shape, Material::matte(Rgb::WHITE))).collect();
    let scene = Scene::new(camera, Background::Solid(Rgb::BLACK)).with_objects(&objects);
    match Tracer::try_new(&scene) {
        Ok(tracer) => body(&tracer),
        Err(error) => unreachable!("{error}"),
    }
}

/// A direction on the outer side of a surface, in a fifth of all cases grazing it.
fn outwards(normal: Vec3<f32>, random: &mut fastrand::Rng) -> Vec3<f32> {
    let direction = unit_vector(random);
    let height = direction.dot(normal);
    if random.u32(..5) == 0 {
        let grazing = direction - normal * height;
        return (grazing.normalized() + normal * 10.0_f32.powf(-8.0 * random.f32())).normalized();
    }
    if height > 0.0 { direction } else { -direction }
}

fn leave_a_sphere(failures: &mut Failures, origin: Origin, scale: f32, rays: u32, random: &mut fastrand::Rng) {
    let center = unit_vector(random) * (scale * 3.0);
    with_tracer(&[Shape::sphere(center, scale)], |tracer| {
        for _ in 0..rays {
            let start = center + unit_vector(random) * (scale * (1.5 + 8.0 * random.f32()));
            let ray =
                Ray { origin: start, direction: (center + unit_vector(random) * (scale * 0.9) - start).normalized() };
            let Some(hit) = tracer.intersect(&ray) else { continue };
            let direction = outwards(hit.normal, random);
            if direction.dot(hit.normal) <= 0.0 {
                continue;
            }
            let next = origin.leave(&ray, &hit, direction);
            failures.rays += 1;
            failures.self_hits += u32::from(tracer.intersect(&next).is_some());
        }
    });
}

fn enter_a_slab(failures: &mut Failures, origin: Origin, scale: f32, rays: u32, random: &mut fastrand::Rng) {
    let corner = Vec3::new(scale * 0.3, scale * 0.7, scale * -0.2);
    let slab = Shape::axis_box(corner, corner + Vec3::new(scale, scale * 1e-4, scale));
    with_tracer(&[slab], |tracer| {
        for _ in 0..rays {
            let start = corner + Vec3::new(random.f32(), 0.2 + random.f32(), random.f32()) * scale;
            let target = corner + Vec3::new(0.01 + 0.98 * random.f32(), 1e-4, 0.01 + 0.98 * random.f32()) * scale;
            let ray = Ray { origin: start, direction: (target - start).normalized() };
            let Some(hit) = tracer.intersect(&ray).filter(|hit| hit.normal.y > 0.5) else { continue };
            let next = origin.leave(&ray, &hit, -outwards(hit.normal, random));
            failures.entered += 1;
            let inside = tracer.intersect(&next).is_some_and(|hit| !hit.from_outside && hit.normal.y < 0.5);
            // Near an edge, or along the slab, a ray leaves by another face.
            let reach = next.direction * (scale * 1e-4 / next.direction.y.abs());
            let edge = hit.point - corner + reach;
            let by_the_other_face = [edge.x, edge.z].iter().all(|x| (scale * 0.001..scale * 0.999).contains(x));
            failures.leaks += u32::from(!inside && by_the_other_face);
        }
    });
}

/// Rays that meet a sphere nearest to its neighbour, one beside it or one inside of it. Whether the origin of the next is
/// inside of that is worked out in `f64`.
fn approach_a_neighbor(failures: &mut Failures, origin: Origin, scale: f32, rays: u32, random: &mut fastrand::Rng) {
    let gap = 32.0 * f32::EPSILON / 2.0;
    let beside = (Vec3::new(scale * (2.0 + gap), 0.0, 0.0), scale);
    let inside = (Vec3::new(scale * (0.5 - gap), 0.0, 0.0), scale * 0.5);
    with_tracer(&[Shape::sphere(Vec3::ZERO, scale)], |tracer| {
        for i in 0..rays {
            let (neighbor, side) = if i % 2 == 0 { (beside, 1.0) } else { (inside, -1.0) };
            let away = unit_vector(random) * (scale * 1e-4 * random.f32());
            let from =
                Vec3::new(scale, away.y, away.z) + Vec3::new(0.1 * side, random.f32(), -random.f32()) * scale * 0.3;
            let target = Vec3::new(scale, away.y, away.z);
            let ray = Ray { origin: from, direction: (target - from).normalized() };
            let Some(hit) = tracer.intersect(&ray).filter(|hit| hit.from_outside == (side > 0.0)) else { continue };
            let next = origin.leave(&ray, &hit, hit.normal * side);
            let is_beyond = (next.origin.x - neighbor.0.x) * side > 0.0;
            failures.towards_neighbor += 1;
            failures.jumps += u32::from(distance(next.origin, neighbor.0) < f64::from(neighbor.1) || is_beyond);
        }
    });
}

/// The distance of two points, worked out in `f64`.
#[must_use]
pub fn distance(a: Vec3<f32>, b: Vec3<f32>) -> f64 {
    let (a, b) = (a.map(f64::from), b.map(f64::from));
    [a.x - b.x, a.y - b.y, a.z - b.z].iter().map(|d| d * d).sum::<f64>().sqrt()
}

/// Points of the plane, seen from the side, under a light from straight above: all within a radius are in the shadow.
fn contact_gap(origin: Origin, scale: f32) -> f32 {
    let shapes = [Shape::plane(Vec3::ZERO, UP), Shape::sphere(UP * scale, scale)];
    with_tracer(&shapes, |tracer| {
        let mut gap = 0.0;
        for step in 1..2000 {
            let distance = scale * 0.5 * (step as f32 / 2000.0).powi(4);
            let eye = Vec3::new(distance + scale * 2.0, scale * 0.01, 0.0);
            let target = Vec3::new(distance, 0.0, 0.0);
            let ray = Ray { origin: eye, direction: (target - eye).normalized() };
            let Some(hit) = tracer.intersect(&ray).filter(|hit| hit.object == 0) else { continue };
            let shadow = origin.leave(&ray, &hit, UP);
            if tracer.intersect(&shadow).is_none_or(|hit| hit.object == 0) {
                gap = hit.point.x / scale;
            }
        }
        gap
    })
}
