//! Pictures of bent light against closed forms.

use std::time::Instant;

use whit::scene::{
    Background, BlackHole, Camera, Law, Level, Light, Material, Medium, Method, Object, Pattern, Profile, Scene, Shape,
    Steps,
};
use whit::{Rgb, Vec3};

use super::reference::camera::eye_ray;
use super::reference::light::background;
use super::reference::shade::pattern;
use super::reference::vector::{Color, Vector};
use super::reference::{Samples, Settings, render};

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const STEPS: Steps<f32> = Steps::Controlled { tolerance: 1e-4 };
const WIDTH: u32 = 96;
const HEIGHT: u32 = 72;

fn timed(what: &str, scene: &Scene<'_, f32>, depth: u32) -> Vec<[f64; 3]> {
    let start = Instant::now();
    let (picture, counts) = render(scene, &Settings::new(WIDTH, HEIGHT, depth), &Samples::CENTRE);
    println!("{what}: {:.1} s, {counts:?}", start.elapsed().as_secs_f64());
    picture
}

fn rays(scene: &Scene<'_, f32>) -> impl Iterator<Item = super::reference::shapes::Ray> {
    let middle = |(x, y): (u32, u32)| [f64::from(x) + 0.5, f64::from(y) + 0.5];
    let pixels = (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y)));
    pixels.map(move |pixel| eye_ray(&scene.camera, [WIDTH, HEIGHT], middle(pixel), &|_| [0.5; 2]))
}

/// Light that enters Luneburg's lens of radius R at c + x in the direction d leaves it at c + R·d in the direction −x/R.
#[test]
fn a_checker_behind_luneburgs_lens() {
    const RADIUS: f32 = 1.25;
    const CENTER: Vec3<f32> = Vec3::new(0.25, 0.5, -1.0);
    let profiles = [Profile {
        level: Level::Radius { center: CENTER, radius: 0.0 },
        from: 0.0,
        to: RADIUS,
        law: Law::luneburg(RADIUS),
        method: Method::Layers { thickness: 0.1 },
    }];
    let checker = Pattern::Checker {
        even: Rgb::new(0.9, 0.8, 0.1),
        odd: Rgb::new(0.1, 0.2, 0.7),
        u: Vec3::new(2.0, 0.0, 0.0),
        v: Vec3::new(0.0, 2.0, 0.0),
    };
    let wall = -4.0;
    let objects = [
        Object::new(
            Shape::plane(Vec3::new(0.0, 0.0, wall), Vec3::new(0.0, 0.0, 1.0)),
            Material::patterned(checker).with_shares(1.0, 0.0, 0.0),
        ),
        Object::new(Shape::sphere(CENTER, RADIUS), Material::transparent(Medium::graded(0))),
    ];
    let camera = Camera::look_at(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, UP, 40.0);
    let sky = Background::Gradient { below: Rgb::new(0.3, 0.2, 0.1), above: Rgb::new(0.5, 0.7, 1.0), up: UP };
    let scene = Scene::new(camera, sky).with_objects(&objects).with_profiles(&profiles);
    let picture = timed("Luneburg's lens", &scene, 4);
    let (center, radius) = (Vector::from(CENTER), f64::from(RADIUS));
    let expected: Vec<Color> = rays(&scene)
        .map(|ray| {
            let to_center = center - ray.origin;
            let along = to_center.dot(ray.direction);
            let square = radius * radius - (to_center - ray.direction * along).length().powi(2);
            let (origin, direction) = if square > 0.0 {
                let entry = ray.at(along - square.sqrt()) - center;
                (center + ray.direction * radius, -entry.normalized())
            } else {
                (ray.origin, ray.direction)
            };
            let distance = (f64::from(wall) - origin.z) / direction.z;
            if distance > 0.0 { pattern(&checker, origin + direction * distance) } else { background(&sky, direction) }
        })
        .collect();
    let off =
        picture.iter().zip(&expected).filter(|(a, b)| a.iter().zip(b.0).any(|(a, b)| (a - b).abs() > 1e-9)).count();
    println!("{off} of {} pixels are off", picture.len());
    assert_eq!(off, 0);
}

/// From far away, its radius is 3√3·M.
#[test]
fn the_shadow_of_a_hole_and_a_ring_of_light() {
    let hole = BlackHole { center: Vec3::ZERO, mass: 1.0, steps: STEPS };
    let camera = Camera::with_half_height(Vec3::new(0.0, 0.0, 1000.0), Vec3::ZERO, UP, 0.01);
    // Its light comes around the hole on all sides: Einstein's ring.
    let lamp = [Object::new(
        Shape::sphere(Vec3::new(0.0, 0.0, -12.0), 0.5),
        Material::matte(Rgb::new(1.0, 0.5, 0.0)).with_shares(1.0, 0.0, 0.0),
    )];
    let scene =
        Scene::new(camera, Background::Solid(Rgb::new(0.2, 0.4, 0.6))).with_black_hole(hole).with_objects(&lamp);
    let picture = timed("hole", &scene, 0);
    let mut on_ring = 0;
    for (ray, pixel) in rays(&scene).zip(&picture) {
        let b = ray.origin.cross(ray.direction).length();
        let black = *pixel == [0.0; 3];
        assert_eq!(black, b < 27.0_f64.sqrt(), "{b}");
        on_ring += usize::from(pixel[0] == 1.0);
        // Light that goes round more than half is next to the shadow.
        assert!(pixel[0] != 1.0 || b > 6.0 && b < 9.0 || b < 5.3, "{b}");
    }
    assert!(on_ring > 200, "{on_ring}");
}

/// With the law of Snell, in layers and in shells: n·cos θ, or n·r·cos θ, is what it is at the eye, and where it is less
/// than at the ground a ray that goes down gets there. The ground is where the profile starts, so that none may get lost
/// between two pieces of its path.
#[test]
fn the_ground_ends_where_light_turns() {
    let shining = Material::matte(Rgb::new(1.0, 0.0, 0.0)).with_shares(1.0, 0.0, 0.0);
    let (radius, center) = (6.4e6, Vec3::new(0.0, -6.4e6, 0.0));
    let road = Profile {
        level: Level::Height { origin: Vec3::ZERO, up: UP },
        from: 0.0,
        to: 2.0,
        law: Law::warm_air(300.0, 30.0, 0.02),
        method: Method::Steps(STEPS),
    };
    let air = Law::Exponential { far: 1.0, excess: 2.8e-4, scale: 8e3 };
    let sky = Profile { level: Level::Radius { center, radius }, to: 8e4, law: air, ..road };
    let near = Camera::look_at(Vec3::new(0.0, 1.5, 0.0), Vec3::new(0.0, 0.0, -220.0), UP, 0.1);
    let far = Camera::look_at(Vec3::new(0.0, 1e3, 0.0), Vec3::new(0.0, -9e3, -5e5), UP, 1.0);
    for (what, profile, shape, camera) in
        [("road", road, Shape::plane(Vec3::ZERO, UP), near), ("planet's rim", sky, Shape::sphere(center, radius), far)]
    {
        let (profiles, objects) = ([profile], [Object::new(shape, shining)]);
        let medium = Medium::graded(0);
        let background = Background::Solid(Rgb::new(0.0, 0.0, 1.0));
        let scene = Scene::new(camera, background).with_profiles(&profiles).with_medium(medium).with_objects(&objects);
        let picture = timed(what, &scene, 0);
        let exact = super::reference::profile::Profile::from(&profile);
        let lever = |point: Vector| match profile.level {
            Level::Height { .. } => 1.0,
            Level::Radius { .. } => (point - center.into()).length(),
        };
        let mut met = 0;
        for (i, ray) in rays(&scene).enumerate() {
            let up = exact.level.gradient(ray.origin);
            let level = (ray.direction - up * ray.direction.dot(up)).length();
            let kept = exact.index(ray.origin) * lever(ray.origin) * level;
            let down = ray.direction.dot(up) < 0.0 && kept < exact.index(Vector::ZERO) * lever(Vector::ZERO);
            assert_eq!(picture[i] == [1.0, 0.0, 0.0], down, "{what}: {ray:?}");
            met += usize::from(down);
        }
        println!("{met} pixels show the ground");
        assert!(met > 1000 && met < 6000, "{what} {met}");
    }
}

/// Scenes as they will be compared, for the time that they take.
#[test]
fn pictures_are_made_in_time() {
    let floor = Pattern::Checker {
        even: Rgb::WHITE,
        odd: Rgb::BLACK,
        u: Vec3::new(0.01, 0.0, 0.0),
        v: Vec3::new(0.0, 0.0, 0.01),
    };
    let sky = Background::Gradient { below: Rgb::new(0.3, 0.2, 0.1), above: Rgb::new(0.5, 0.7, 1.0), up: UP };
    let road = [Profile {
        level: Level::Height { origin: Vec3::ZERO, up: UP },
        from: 0.0,
        to: 0.3,
        law: Law::warm_air(300.0, 30.0, 0.02),
        method: Method::Steps(STEPS),
    }];
    let objects = [
        Object::new(Shape::plane(Vec3::ZERO, UP), Material::patterned(floor)),
        Object::new(Shape::sphere(Vec3::new(0.0, 1.0, -600.0), 1.0), Material::matte(Rgb::new(0.9, 0.1, 0.1))),
        Object::new(Shape::sphere(Vec3::new(2.0, 0.7, -700.0), 0.5), Material::mirror(Rgb::WHITE)),
    ];
    let lights = [Light::directional(Vec3::new(1.0, 0.02, 0.3), Rgb::WHITE)];
    let camera = Camera::look_at(Vec3::new(0.0, 1.5, 0.0), Vec3::new(0.0, 0.8, -600.0), UP, 0.6);
    let mirage = Scene::new(camera, sky)
        .with_objects(&objects)
        .with_profiles(&road)
        .with_medium(Medium::graded(0))
        .with_lights(&lights);
    timed("mirage", &mirage, 2);
    timed("mirage with bent shadows", &mirage.with_bent_shadows(), 2);

    let sea = [Profile { to: 40.0, law: Law::inversion(276.0, 290.0, 15.0, 3.0), ..road[0] }];
    timed("superior mirage", &Scene { profiles: &sea, ..mirage }, 2);

    let planet = [Profile {
        level: Level::Radius { center: Vec3::new(0.0, -6.4e6, 0.0), radius: 6.4e6 },
        from: 0.0,
        to: 8e4,
        law: Law::Exponential { far: 1.0, excess: 2.8e-4, scale: 8e3 },
        method: Method::Steps(STEPS),
    }];
    let ball = [Object::new(Shape::sphere(Vec3::new(0.0, -6.4e6, 0.0), 6.4e6), Material::patterned(floor))];
    let camera = Camera::look_at(Vec3::new(0.0, 1e3, 0.0), Vec3::new(0.0, -1e4, -5e5), UP, 3.0);
    let planet = Scene { profiles: &planet, objects: &ball, camera, ..mirage };
    timed("planet", &planet, 2);
    timed("planet with bent shadows", &planet.with_bent_shadows(), 2);

    let rings =
        Pattern::Rings { even: Rgb::new(1.0, 0.6, 0.2), odd: Rgb::new(0.6, 0.2, 0.1), center: Vec3::ZERO, width: 0.5 };
    let disc = [
        Object::new(Shape::annulus(Vec3::ZERO, UP, 6.0, 14.0), Material::patterned(rings).with_shares(0.5, 0.1, 0.5)),
        Object::new(Shape::sphere(Vec3::new(-4.0, 5.0, -8.0), 1.5), Material::mirror(Rgb::WHITE)),
    ];
    let lights = [Light::point(Vec3::new(5.0, 20.0, 10.0), Rgb::WHITE)];
    let camera = Camera::look_at(Vec3::new(0.0, 4.0, 30.0), Vec3::ZERO, UP, 45.0);
    let stars = Background::Stars { sky: Rgb::BLACK, brightness: 1.0, cells: 30, radius: 0.3 };
    let hole = BlackHole { center: Vec3::ZERO, mass: 1.0, steps: STEPS };
    let scene = Scene::new(camera, stars).with_objects(&disc).with_black_hole(hole).with_lights(&lights);
    timed("hole with a disc", &scene, 3);
    timed("hole with a disc and bent shadows", &scene.with_bent_shadows(), 3);
}
