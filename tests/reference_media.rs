//! The reference tracer's media, against closed forms: what is where, and how light fades on its way.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

mod reference;

use reference::medium::{Border, Medium as Filling};
use reference::shapes::Ray;
use reference::vector::{Color, Vector};
use reference::world::World;
use reference::{Branch, Counts, Settings, Termination};
use whit::scene::{
    Background, Camera, Interface, Light, Material, Medium, Object, Scene, Shape, SmoothTriangle, Triangle,
};
use whit::{Rgb, Vec3};

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, UP, 40.0);
const WHITE: Background<f32> = Background::Solid(Rgb::WHITE);
/// 1/scene unit.
const FADING: Rgb<f32> = Rgb::new(0.0, 0.5, 2.0);

fn close(a: [f64; 3], b: [f64; 3], tolerance: f64) {
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance), "{a:?} is not {b:?} within {tolerance:e}");
}

/// The light along a ray, and the rays it took.
fn trace(scene: &Scene<'_, f32>, settings: &Settings, ray: &Ray) -> ([f64; 3], Counts) {
    let mut counts = Counts::default();
    (Branch::eye(&World::new(scene), settings, &|_| [0.5; 2]).trace(ray, &mut counts).0, counts)
}

/// What is left after a way through [`FADING`].
fn faded(distance: f64) -> [f64; 3] {
    [0.0, 0.5, 2.0].map(|c: f64| (-c * distance).exp())
}

/// Along the x axis.
fn forward(x: f64) -> Ray {
    Ray::new(Vector::new(x, 0.0, 0.0), Vector::new(1.0, 0.0, 0.0))
}

/// A box around the x axis from one place to another.
fn slab(from: f32, to: f32) -> Shape<'static, f32> {
    Shape::axis_box(Vec3::new(from, -9.0, -9.0), Vec3::new(to, 9.0, 9.0))
}

/// Light that shines by itself.
fn lamp() -> Material<f32> {
    Material::matte(Rgb::WHITE).with_shares(1.0, 0.0, 0.0)
}

/// With the reflectance r of each face and the share a that a passage leaves, (1 − r)²·a/(1 − r²a²) get through.
#[test]
fn a_slab_of_absorbing_glass() {
    let glass = Material::transparent(Medium::new(1.5).with_attenuation(FADING));
    let objects = [Object::new(slab(1.0, 2.5), glass), Object::new(slab(4.0, 5.0), lamp())];
    let scene = Scene::new(CAMERA, Background::Solid(Rgb::BLACK)).with_objects(&objects);
    let (light, counts) = trace(&scene, &Settings::new(1, 1, 40), &forward(0.0));
    let r: f64 = 0.04;
    close(light, faded(1.5).map(|a| (1.0 - r).powi(2) * a / (1.0 - (r * a).powi(2))), 1e-14);
    // 20 ways out at the far face, 20 ways back.
    assert_eq!((counts.transmitted, counts.reflected, counts.passed), (40, 40, 0));
}

#[test]
fn fog_fades_what_is_seen_and_hides_the_sky_in_its_channels() {
    let objects = [Object::new(slab(3.0, 4.0), lamp())];
    let scene = Scene::new(CAMERA, WHITE).with_objects(&objects);
    let scene = scene.with_medium(Medium::VACUUM.with_attenuation(FADING));
    let settings = Settings::new(1, 1, 1);
    close(trace(&scene, &settings, &forward(1.0)).0, faded(2.0), 1e-15);
    close(trace(&scene, &settings, &forward(5.0)).0, [1.0, 0.0, 0.0], 0.0);
}

#[test]
fn an_eye_inside_of_things() {
    let amber = Material::transparent(Medium::VACUUM.with_attenuation(FADING));
    let ball = Shape::sphere(Vec3::ZERO, 2.0);
    let triangles = block([-1.0, 1.0]);
    let lone = Triangle { vertices: [Vec3::ZERO, UP, Vec3::new(0.0, 0.0, 1.0)] };
    let smooth = SmoothTriangle { vertices: [Vec3::ZERO, UP, Vec3::new(0.0, 0.0, 1.0)], normals: [UP; 3] };
    // From where to where the half line from the origin along x is inside.
    let endless = f64::INFINITY;
    let cases = [
        (ball, 0.0, 2.0),
        (Shape::sphere(Vec3::ZERO, -2.0), 2.0, endless),
        (slab(-1.0, 1.5), 0.0, 1.5),
        (Shape::plane(Vec3::new(3.0, 0.0, 0.0), Vec3::new(2.0, 0.0, 0.0)), 0.0, 3.0),
        (Shape::plane(Vec3::new(3.0, 0.0, 0.0), Vec3::new(-2.0, 0.0, 0.0)), 3.0, endless),
        (Shape::cone(Vec3::new(-1.0, 0.0, 0.0), 2.0, Vec3::new(4.0, 0.0, 0.0), 1.0).capped(), 0.0, 4.0),
        (Shape::cone(Vec3::new(0.0, -1.0, 0.0), 1.0, Vec3::new(0.0, 1.0, 0.0), 2.0).capped(), 0.0, 1.5),
        (Shape::cone(Vec3::new(5.0, -1.0, 0.0), 1.0, Vec3::new(5.0, 1.0, 0.0), 2.0).capped(), 3.5, 6.5),
        (Shape::cone(Vec3::new(5.0, -1.0, 0.0), -1.0, Vec3::new(5.0, 1.0, 0.0), -2.0).capped(), 0.0, 3.5),
        (Shape::cone(Vec3::new(8.0, -1.0, 0.0), 9.0, Vec3::new(8.0, 1.0, 0.0), 1.0).capped(), 3.0, 13.0),
        (Shape::Triangles(&triangles), 0.0, 1.0),
        (Shape::Triangle(lone), 0.0, 0.0),
        (Shape::SmoothTriangle(smooth), 0.0, 0.0),
        (Shape::disc(Vec3::new(5.0, 0.0, 0.0), Vec3::new(1.0, 0.0, 0.0), 1.0), 0.0, 0.0),
    ];
    for (shape, from, to) in cases {
        let objects = [Object::new(shape, amber)];
        let scene = Scene::new(CAMERA, WHITE).with_objects(&objects);
        let world = World::new(&scene);
        for end in [0.5, 3.25, 6.0] {
            let Color(clarity) = world.clarity(&forward(0.0), end, |_| true);
            let inside = (to.min(end) - from).max(0.0);
            close(clarity, faded(inside), 1e-12);
        }
        let Color(clarity) = world.clarity(&forward(0.0), endless, |_| true);
        // The last cone is around the ray again past 6.5.
        let ends_outside = to != endless && to != 3.5;
        close(clarity, if ends_outside { faded(to - from) } else { [1.0, 0.0, 0.0] }, 1e-12);
    }
}

/// Objects along a line: every real border is met with the indices of the table, and the others are passed.
#[test]
fn nested_media_by_priority_as_in_the_table() {
    let table: serde_json::Value = serde_json::from_str(include_str!("data/oracles/nested_priority.json")).unwrap();
    let (mut real, mut passed) = (0, 0);
    for case in table.as_array().unwrap() {
        let events = case["events"].as_array().unwrap();
        let start = case["start_t"].as_f64().unwrap();
        let described = case["objects"].as_array().unwrap();
        // Where the line is inside of each object; what is left open ends somewhere behind the start or past the end.
        let pieces = |object: &serde_json::Value| -> Vec<[f32; 2]> {
            let within = case["initially_inside"].as_array().unwrap().contains(&object["id"]);
            let crossed = events.iter().filter(|event| event["obj"] == object["id"]);
            let mut ends: Vec<f32> = within.then_some(start as f32 - 1.0).into_iter().collect();
            ends.extend(crossed.map(|event| event["t"].as_f64().unwrap() as f32));
            if ends.len() % 2 == 1 {
                ends.push(17.0);
            }
            ends.chunks(2).map(|piece| [piece[0], piece[1]]).collect()
        };
        let pieces: Vec<Vec<[f32; 2]>> = described.iter().map(pieces).collect();
        let meshes: Vec<Vec<Triangle<f32>>> =
            pieces.iter().map(|pieces| pieces.iter().flat_map(|&piece| block(piece)).collect()).collect();
        let objects: Vec<_> = (0..described.len())
            .map(|i| {
                let shape = match pieces[i][..] {
                    [piece] if i % 4 < 3 => along(i, piece),
                    _ => Shape::Triangles(&meshes[i]),
                };
                let medium = Medium::new(described[i]["ior"].as_f64().unwrap() as f32);
                let priority = described[i]["priority"].as_u64().unwrap() as u8;
                Object::new(shape, Material::transparent(medium).with_priority(priority))
            })
            .collect();
        let scene = Scene::new(CAMERA, WHITE).with_objects(&objects);
        let world = World::new(&scene);
        let mut ray = forward(start);
        for event in events {
            let hit = world.nearest(&ray).unwrap();
            assert!((hit.point.x - event["t"].as_f64().unwrap()).abs() < 1e-5, "{event}");
            let border = world.border(&ray, &hit);
            assert_eq!(border.is_some(), event["real"].as_bool().unwrap(), "{event}");
            if let Some(Border { front, behind }) = border {
                let expected = [&event["n1"], &event["n2"]].map(|index| index.as_f64().unwrap());
                let found = [front, behind].map(|medium| medium.index(None));
                assert!((0..2).all(|i| (found[i] - expected[i]).abs() < 1e-6), "{event}: {found:?}");
            }
            *if border.is_some() { &mut real } else { &mut passed } += 1;
            ray = hit.leave(ray.direction);
        }
    }
    assert_eq!((real, passed), (658, 311));
}

/// A solid around a piece of the x axis.
fn along(kind: usize, [from, to]: [f32; 2]) -> Shape<'static, f32> {
    let x = |x| Vec3::new(x, 0.0, 0.0);
    match kind % 3 {
        0 => Shape::sphere(x(0.5 * (from + to)), 0.5 * (to - from)),
        1 => slab(from, to),
        _ => Shape::cone(x(from), 2.0, x(to), 1.0).capped(),
    }
}

/// The same of triangles, whose edges do not meet the axis.
fn block([from, to]: [f32; 2]) -> Vec<Triangle<f32>> {
    let corner = |i: usize| Vec3::new([from, to][i & 1], [-7.0, 9.0][i >> 1 & 1], [-9.0, 8.0][i >> 2]);
    let faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let halves = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    halves.map(|places| Triangle { vertices: places.map(corner) }).collect()
}

#[test]
fn of_equal_ranks_the_last_prevails_and_none_is_the_lowest() {
    let clear =
        |index| Interface::Constant { reflected: Rgb::BLACK, transmitted: Rgb::WHITE, medium: Medium::new(index) };
    let plain = |index| Material::dielectric(index);
    let cases = [
        ([plain(1.5), plain(1.25)], 1.25),
        ([plain(1.5).with_priority(0), plain(1.25)], 1.5),
        ([plain(1.5).with_priority(0), plain(1.25).with_interface(clear(1.75))], 1.5),
        ([plain(1.5).with_priority(7), plain(1.25).with_priority(7)], 1.25),
        ([plain(1.5).with_priority(8), plain(1.25).with_priority(7)], 1.5),
        ([plain(1.5).with_priority(7), plain(1.25).with_priority(255)], 1.25),
    ];
    // A place far off that has a priority, so that the scene keeps account of what is inside of what.
    let far = Object::new(Shape::sphere(Vec3::new(0.0, 99.0, 0.0), 1.0), plain(1.0).with_priority(1));
    for ([first, second], expected) in cases {
        let objects = [Object::new(slab(1.0, 3.0), first), Object::new(slab(2.0, 4.0), second), far];
        let scene = Scene::new(CAMERA, WHITE).with_objects(&objects);
        let world = World::new(&scene);
        let ray = forward(1.5);
        let hit = world.nearest(&ray).unwrap();
        let border = world.border(&ray, &hit);
        // The second slab is entered at 2.
        assert_eq!(border.map(|border| border.behind), (expected != 1.5).then_some(Filling::clear(expected)));
        let ray = hit.leave(ray.direction);
        let border = world.border(&ray, &world.nearest(&ray).unwrap());
        // The first one is left at 3.
        assert_eq!(border.is_some(), expected == 1.5);
    }
}

/// Without priorities and attenuation each object is taken to stand alone.
#[test]
fn clear_objects_stand_alone() {
    let objects = [1.5, 1.25].map(Material::dielectric);
    let objects = [Object::new(slab(1.0, 3.0), objects[0]), Object::new(slab(2.0, 4.0), objects[1])];
    let scene = Scene::new(CAMERA, WHITE).with_objects(&objects).with_medium(Medium::new(1.125));
    let world = World::new(&scene);
    let mut ray = forward(0.0);
    let (outside, first, second) = (Filling::clear(1.125), Filling::clear(1.5), Filling::clear(1.25));
    for (front, behind) in [(outside, first), (outside, second), (first, outside), (second, outside)] {
        let hit = world.nearest(&ray).unwrap();
        assert_eq!(world.border(&ray, &hit).unwrap(), Border { front, behind });
        ray = hit.leave(ray.direction);
    }
}

/// Where rays leave an object that is seen from outside only, nothing is met, but its medium ends.
#[test]
fn one_sided_glass_ends_unseen() {
    let glass = |index| Material::transparent(Medium::new(index).with_attenuation(FADING));
    let objects = [Object::new(slab(1.0, 3.0), glass(1.5)).one_sided(), Object::new(slab(4.0, 5.0), glass(1.25))];
    let scene = Scene::new(CAMERA, WHITE).with_objects(&objects);
    let world = World::new(&scene);
    let ray = forward(1.5);
    let hit = world.nearest(&ray).unwrap();
    let border = world.border(&ray, &hit).unwrap();
    assert_eq!((hit.distance, border.front.index(None), border.behind.index(None)), (2.5, 1.0, 1.25));
    close(world.clarity(&ray, hit.distance, |_| true).0, faded(1.5), 1e-15);
}

/// Passing is no bounce and has no weight, and light fades by what prevails.
#[test]
fn rays_pass_where_an_object_does_not_prevail() {
    let inner = Material::matte(Rgb::WHITE).with_shares(1.0, 0.0, 0.0).with_interface(Interface::Dielectric {
        medium: Medium::new(1.5).with_attenuation(Rgb::WHITE).with_priority(1),
        film: None,
    });
    let outer = Material::transparent(Medium::VACUUM.with_attenuation(FADING)).with_priority(2);
    let objects =
        [Object::new(slab(2.0, 3.0), inner), Object::new(slab(1.0, 4.0), outer), Object::new(slab(5.0, 6.0), lamp())];
    let scene = Scene::new(CAMERA, Background::Solid(Rgb::BLACK)).with_objects(&objects);
    // Two bounces: into the outer slab and out of it.
    let (light, counts) = trace(&scene, &Settings::new(1, 1, 2), &forward(0.0));
    close(light, faded(3.0), 1e-15);
    assert_eq!((counts.transmitted, counts.passed), (2, 2));
    assert_eq!(trace(&scene, &Settings::new(1, 1, 1), &forward(0.0)).0, [0.0; 3]);
}

#[test]
fn the_color_of_cut_branches_does_not_fade() {
    let glass = Material::transparent(Medium::VACUUM.with_attenuation(FADING));
    let objects = [Object::new(slab(1.0, 2.0), glass)];
    let scene = Scene::new(CAMERA, WHITE).with_objects(&objects);
    let color = Termination::Color([0.25, 0.5, 0.75]);
    for (depth, expected) in [(0, [0.25, 0.5, 0.75]), (1, [0.25, 0.5 * faded(1.0)[1], 0.75 * faded(1.0)[2]])] {
        let settings = Settings { termination: color, ..Settings::new(1, 1, depth) };
        close(trace(&scene, &settings, &forward(0.0)).0, expected, 1e-15);
    }
    // The throughput does, and the cutoff sees it.
    let settings = Settings { termination: color, cutoff: 0.5, ..Settings::new(1, 1, 9) };
    let grey = Material::transparent(Medium::VACUUM.with_attenuation(Rgb::WHITE));
    let objects = [Object::new(slab(1.0, 2.0), grey)];
    let (light, counts) = trace(&scene.with_objects(&objects), &settings, &forward(0.0));
    close(light, [0.25, 0.5, 0.75].map(|color| color * (-1.0_f64).exp()), 1e-15);
    assert_eq!(counts.transmitted, 1);
}

/// A floor at x = 0 under a light far along x, with things between.
fn lit(objects: &[Object<'_, f32>], medium: Medium<f32>, light: Light<f32>) -> ([f64; 3], Counts) {
    let floor = Object::new(Shape::disc(Vec3::ZERO, Vec3::new(-1.0, 0.0, 0.0), 1.0), Material::matte(Rgb::WHITE));
    let objects: Vec<_> = [floor].iter().chain(objects).copied().collect();
    let lights = [light];
    let scene = Scene::new(CAMERA, WHITE).with_objects(&objects).with_lights(&lights).with_medium(medium);
    let ray = Ray::new(Vector::new(0.125, 0.0, 0.0), Vector::new(-1.0, 0.0, 0.0));
    let (light, counts) = trace(&scene, &Settings::new(1, 1, 0), &ray);
    // What fades on the last bit of the way is the same for all.
    let Color(way) = World::new(&scene).clarity(&ray, 0.125, |_| true);
    ([0, 1, 2].map(|i| if way[i] > 0.0 { light[i] / way[i] } else { light[i] }), counts)
}

#[test]
fn tinted_shadows() {
    let point = Light::point(Vec3::new(9.0, 0.0, 0.0), Rgb::WHITE);
    let far = Light::directional(Vec3::new(1.0, 0.0, 0.0), Rgb::WHITE);
    let glass = |from, to, priority| {
        Object::new(
            slab(from, to),
            Material::transparent(Medium::new(1.5).with_attenuation(FADING)).with_priority(priority),
        )
    };
    let grey = |from, to, priority| {
        let medium = Medium::new(1.5).with_attenuation(Rgb::WHITE);
        Object::new(slab(from, to), Material::transparent(medium).with_priority(priority))
    };
    let fade = |colored: f64, grey: f64| faded(colored).map(|share| share * (-grey).exp());
    let fog = Medium::VACUUM.with_attenuation(Rgb::WHITE);
    let full = glass(1.0, 2.0, 1);
    let tinted = |object: Object<'static, f32>| object.with_tinted_shadow();
    let cases = [
        (vec![], Medium::VACUUM, point, [1.0; 3]),
        (vec![full], Medium::VACUUM, point, [0.0; 3]),
        (vec![full.without_shadow()], Medium::VACUUM, point, [1.0; 3]),
        (vec![tinted(full)], Medium::VACUUM, point, faded(1.0)),
        (vec![tinted(full)], Medium::VACUUM, far, faded(1.0)),
        (vec![tinted(full), glass(3.0, 4.0, 1)], Medium::VACUUM, point, [0.0; 3]),
        // The light is within the second one.
        (vec![tinted(full), tinted(glass(8.0, 10.0, 1))], Medium::VACUUM, point, faded(2.0)),
        // Overlapping ones by priority; what is not tinted is not there.
        (vec![tinted(glass(1.0, 4.0, 1)), tinted(grey(2.0, 3.0, 2))], Medium::VACUUM, point, fade(2.0, 1.0)),
        (vec![tinted(glass(1.0, 4.0, 3)), tinted(grey(2.0, 3.0, 2))], Medium::VACUUM, point, fade(3.0, 0.0)),
        (vec![tinted(glass(1.0, 4.0, 1)), grey(2.0, 3.0, 2).without_shadow()], Medium::VACUUM, point, faded(3.0)),
        // Fog is where no glass is.
        (vec![], fog, point, fade(0.0, 9.0)),
        (vec![], fog, far, [0.0; 3]),
        (vec![], Medium::VACUUM.with_attenuation(FADING), far, [1.0, 0.0, 0.0]),
        (vec![tinted(full)], fog, point, fade(1.0, 8.0)),
        (vec![full.without_shadow()], fog, point, fade(0.0, 9.0)),
    ];
    for (objects, medium, light, expected) in cases {
        let (light, counts) = lit(&objects, medium, light);
        close(light, expected, 1e-14);
        assert_eq!((counts.shadow, counts.passed), (1, 0));
    }
}
