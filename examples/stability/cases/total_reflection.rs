//! Total reflections that cannot happen.

use whit::{Background, Budget, Camera, Effects, Material, Object, Ray, Rgb, Scene, Shape, Stats, Tracer, Vec3};

use crate::leaving::unit_vector;
use crate::naive::glass_ball::{self, Way};
use crate::page::Page;

const EFFECTS: u64 = Effects::SPHERE.with(Effects::DIELECTRIC).with(Effects::FRESNEL).bits();
const RAYS: u32 = 200_000;

/// Rays that graze a ball of the given index: how many are reflected totally inside, by the naive form and by whit.
fn count(index: f32) -> Result<[u32; 2], String> {
    let (center, radius) = (Vec3::new(3.0, -2.0, 5.0), 1.0);
    let camera = Camera::look_at(Vec3::ZERO, center, Vec3::new(0.0, 1.0, 0.0), 40.0);
    let objects = [Object::new(Shape::sphere(center, radius), Material::dielectric(index))];
    let scene = Scene::new(camera, Background::Solid(Rgb::WHITE)).with_objects(&objects);
    let tracer = Tracer::<f32, EFFECTS, 2>::try_new(&scene).map_err(|error| error.to_string())?;
    let mut random = fastrand::Rng::with_seed(11);
    let (mut naive, mut stats) = (0, Stats::default());
    for _ in 0..RAYS {
        let direction = unit_vector(&mut random);
        let aside = direction.cross(unit_vector(&mut random)).normalized();
        // The distance of the line from the centre, from 0.9 to one rounding below 1.
        let impact = 1.0 - 10.0_f32.powf(-1.0 - 6.0 * random.f32());
        let ray = Ray { origin: center + aside * impact - direction * 4.0, direction };
        let array = |v: Vec3<f32>| [v.x, v.y, v.z];
        let way = glass_ball::follow(array(ray.origin), array(direction), array(center), radius, index);
        naive += u32::from(way == Way::Inside);
        let _ = tracer.trace(ray, &Budget::with_depth(2), &mut stats);
    }
    Ok([naive, stats.total_internal as u32])
}

pub fn write(page: &mut Page) -> Result<(), String> {
    page.text(
        "
## False total reflection

Light that gets into a ball of glass meets the other side at the angle it got in with, so it cannot be reflected totally.
Rays that graze the ball come next to the critical angle, and rounding takes some past it: dark specks at the rim. Of
200,000 grazing rays:
",
    );
    let mut rows = vec![["index of refraction", "textbook formulas", "whit"].map(str::to_owned).to_vec()];
    for index in [1.1, 1.333, 1.5, 2.417] {
        let [naive, ours] = count(index)?;
        rows.push(vec![index.to_string(), naive.to_string(), ours.to_string()]);
    }
    page.table(&rows);
    page.text(
        "whit knows how far the cosine may be off (8u for each bounce so far) and takes a reflection for total only where it is \
         beyond that. Balls, panes and pairs of planes of ten indices, at sizes from 1e-6 to 1e6, report none for more than two \
         million rays (`tests/hard_cases_optics/false_total_reflection.rs`). The neighbouring faces of a box of glass do reflect \
         totally, in reality too.",
    );
    Ok(())
}
