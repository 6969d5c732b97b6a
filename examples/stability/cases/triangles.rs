//! Rays through the edges of a mesh.

use whit::scene::Triangle;
use whit::{Ray, Rgb, Shape, Vec3};

use crate::leaving::{unit_vector, with_tracer};
use crate::naive::moller_trumbore;
use crate::page::Page;
use crate::picture::picture;

/// An octahedron with corners of no round numbers.
fn octahedron() -> Vec<Triangle<f32>> {
    let [top, bottom] = [Vec3::new(0.013, 1.07, -0.021), Vec3::new(-0.017, -0.93, 0.011)];
    let ring = [(0.97, 0.03), (0.02, 1.03), (-1.01, -0.04), (-0.03, -0.98)].map(|(x, z)| Vec3::new(x, 0.019, z));
    let [a, b, c, d] = ring;
    [(a, b), (b, c), (c, d), (d, a)]
        .into_iter()
        .flat_map(|(p, q)| [Triangle { vertices: [top, q, p] }, Triangle { vertices: [bottom, p, q] }])
        .collect()
}

/// From inside to a point of an edge: along it by columns, from another place in each row.
fn ray(x: f32, y: f32, mesh: &[Triangle<f32>]) -> Ray<f32> {
    let edge = x as usize / 20;
    let [a, b, _] = mesh.get(edge % 8).map_or([Vec3::ZERO; 3], |triangle| triangle.vertices);
    let mut random = fastrand::Rng::with_seed(y as u64);
    let origin = unit_vector(&mut random) * 0.3;
    let target = a + (b - a) * ((x % 20.0 + random.f32()) / 21.0);
    Ray { origin, direction: (target - origin).normalized() }
}

pub fn write(page: &mut Page) -> Result<(), String> {
    let mesh = octahedron();
    let color = |is_met: bool| if is_met { Rgb::new(0.05, 0.1, 0.2) } else { Rgb::new(1.0, 0.95, 0.6) };
    let naive = picture(|x, y| {
        let array = |v: Vec3<f32>| [v.x, v.y, v.z];
        let Ray { origin, direction } = ray(x, y, &mesh);
        color(mesh.iter().any(|triangle| {
            let t = moller_trumbore::intersect(array(origin), array(direction), triangle.vertices.map(array));
            t.is_some_and(|t| t > 0.0)
        }))
    });
    let ours = with_tracer(&[Shape::Triangles(&mesh)], |tracer| {
        picture(|x, y| color(tracer.intersect(&ray(x, y, &mesh)).is_some()))
    });
    let leaks = |picture: &image::RgbImage| picture.pixels().filter(|pixel| pixel.0[0] > 128).count();
    page.text(
        "
## Triangles: cracks

Inside of a closed octahedron, each pixel is a ray to a point of an edge: along an edge from left to right, from another
place in each row. Bright is a ray that gets out between two triangles, which work out the side of their shared edge from different
numbers.
",
    );
    let caption = format!("Rays to edges: Möller and Trumbore, {} get out; whit, {} do.", leaks(&naive), leaks(&ours));
    page.pictures("cracks", &caption, &[&naive, &ours])?;
    page.text(
        "whit shears the corners into a space where the ray is an axis (Woop, Benthin and Wald, JCGT 2013): both triangles \
         see the same numbers with opposite signs, rounding never changes the sign of such a difference, and 0 counts as \
         inside. No ray of ten million to edges and corners of closed meshes gets out (`tests/hard_cases_shapes/triangles.rs`). On \
         which side of a near triangle the origin lies is worked out in twice the digits, so that a ray that leaves it does not meet \
         it again, and one that starts close above a long one does.",
    );
    Ok(())
}
