//! The rays of a picture, in a file.

use std::fs;
use std::path::Path;

use whit::scene::{Emitter, Extent};
use whit::{Camera, Intersection, Ray, Stats, Tracer, Vec3};

use crate::crowd::Crowd;
use crate::files::write;
use crate::layout::{DEPTH, Visitor};
use crate::render::picture;

/// Of a file: all rays that look for the nearest surface, and all that look for any before the light.
#[derive(Default)]
pub struct Rays {
    pub closest: Vec<Ray<f32>>,
    pub shadow: Vec<(Ray<f32>, f32)>,
}

/// Writes the rays that a picture of `size` pixels a side takes: their origin, direction and, up to a light, its distance, or
/// infinity; eight numbers a ray with one that is not used. And the numbers of the spheres or triangles.
pub struct Dump<'a> {
    pub size: u32,
    pub crowd: &'a Crowd,
    pub rays: &'a Path,
    pub shapes: &'a Path,
}

impl Visitor for Dump<'_> {
    fn visit<const EFFECTS: u64>(self, tracer: &Tracer<'_, f32, EFFECTS, DEPTH>, _: f64) -> Result<(), String> {
        let mut rays = Rays::default();
        for ray in eye_rays(&tracer.scene().camera, self.size)? {
            rays.follow(tracer, ray);
        }
        let (seen, _) = picture(tracer, self.size, Stats::default())?;
        let (closest, shadow) = ((seen.rays() - seen.shadow) as usize, seen.shadow as usize);
        let off = |found: usize, right: usize| found.abs_diff(right) > right / 10_000;
        if off(rays.closest.len(), closest) || off(rays.shadow.len(), shadow) {
            let found = (rays.closest.len(), rays.shadow.len());
            return Err(format!("the picture took {closest} and {shadow} rays, and these are {found:?}"));
        }
        let infinite = rays.closest.iter().map(|&ray| (ray, f32::INFINITY));
        let bytes: Vec<u8> = infinite.chain(rays.shadow.iter().copied()).flat_map(record).collect();
        write(self.rays, &bytes)?;
        let numbers = self.crowd.numbers().into_iter();
        write(self.shapes, &numbers.flat_map(f32::to_le_bytes).collect::<Vec<u8>>())?;
        println!("{} {}", rays.closest.len(), rays.shadow.len());
        Ok(())
    }
}

fn record((Ray { origin, direction }, distance): (Ray<f32>, f32)) -> [u8; 32] {
    let mut bytes = [0; 32];
    let numbers = [origin.x, origin.y, origin.z, direction.x, direction.y, direction.z, distance, 0.0];
    for (place, number) in bytes.chunks_exact_mut(4).zip(numbers) {
        place.copy_from_slice(&number.to_le_bytes());
    }
    bytes
}

pub fn read(file: &Path) -> Result<Rays, String> {
    let bytes = fs::read(file).map_err(|error| format!("{}: {error}", file.display()))?;
    let mut rays = Rays::default();
    for record in bytes.chunks_exact(32) {
        let number = |i: usize| f32::from_le_bytes([0, 1, 2, 3].map(|k| record[4 * i + k]));
        let vector = |i: usize| Vec3::new(number(i), number(i + 1), number(i + 2));
        let ray = Ray { origin: vector(0), direction: vector(3) };
        match number(6) {
            f32::INFINITY => rays.closest.push(ray),
            distance => rays.shadow.push((ray, distance)),
        }
    }
    Ok(rays)
}

/// Through the middles of the pixels, row by row.
fn eye_rays(camera: &Camera<f32>, size: u32) -> Result<impl Iterator<Item = Ray<f32>>, String> {
    if camera.extent != Extent::PixelCentres || camera.lens.is_some() {
        return Err("the flake has another camera now".to_owned());
    }
    let forward = (camera.target - camera.eye).normalized();
    let right = forward.cross(camera.up).normalized();
    let up = right.cross(forward);
    let (origin, scale) = (camera.eye, 2.0 * camera.half_height / (size - 1) as f32);
    let ray = move |x: u32, y: u32| {
        let place = |i: u32| (i as f32 + 0.5 - size as f32 / 2.0) * scale;
        let direction = (forward + right * place(x) - up * place(y)).normalized();
        Ray { origin, direction }
    };
    Ok((0..size).flat_map(move |y| (0..size).map(move |x| ray(x, y))))
}

impl Rays {
    /// A ray from the eye, what it needs at each surface, and its mirror images.
    fn follow<const EFFECTS: u64>(&mut self, tracer: &Tracer<'_, f32, EFFECTS, DEPTH>, mut ray: Ray<f32>) {
        for _ in 0..=DEPTH {
            self.closest.push(ray);
            let Some(there) = tracer.intersect(&ray) else { return };
            self.look_at_lights(tracer, &there, ray.direction);
            // The first object is the floor, which mirrors nothing.
            if there.object == 0 {
                return;
            }
            let mirrored = ray.direction - there.normal * (2.0 * ray.direction.dot(there.normal));
            ray = there.leave(mirrored);
        }
    }

    fn look_at_lights<const EFFECTS: u64>(
        &mut self,
        tracer: &Tracer<'_, f32, EFFECTS, DEPTH>,
        there: &Intersection<f32>,
        incident: Vec3<f32>,
    ) {
        let normal = if incident.dot(there.normal) < 0.0 { there.normal } else { -there.normal };
        let origin = there.leave(normal).origin;
        for light in tracer.scene().lights {
            let Emitter::Point { position } = light.emitter else { continue };
            let towards = position - origin;
            let (direction, distance) = (towards.normalized(), towards.length());
            if direction.dot(normal) > 0.0 {
                self.shadow.push((Ray { origin, direction }, distance));
            }
        }
    }
}
