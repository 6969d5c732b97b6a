//! Effects: what scenes call for, and tracers that leave it out.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

#[path = "support/bent.rs"]
mod bent;
#[path = "../examples/effects/scenes.rs"]
#[allow(unused_macros, unused_imports)] // Here they are named one by one.
mod pairs;

use whit::render::{LinearRgb, Size};
use whit::trace::TracerError;
use whit::{Effects, Frame, Rgb, Scene, SceneBuf, Settings, Tracer, Vec3, scenes};

fn names(scene: &Scene<'_, f32>) -> String {
    scene.effects().to_string()
}

#[test]
fn scenes_call_for_what_they_hold() {
    assert_eq!(
        names(&scenes::CARD),
        "spheres, plane, body, checker, phong-highlight, integer-exponent, mirror, parallelogram-light, sky, lens, \
         display-tone"
    );
    assert_eq!(names(&scenes::FLAKE), "spheres, plane, body, blinn-highlight, real-exponent, mirror, point-light");
    // The effects are a constant.
    const { assert!(scenes::CARD.effects().has(Effects::LENS) && !scenes::FLAKE.effects().has(Effects::LENS)) };
}

/// The same bits come out of the code for a scene's own effects and the code for all.
#[test]
fn pruned_code_draws_the_same_picture() {
    fn draw<const EFFECTS: u64, const DEPTH: usize, const MEDIA: usize>(
        tracer: &Tracer<'_, f32, EFFECTS, DEPTH, MEDIA>,
    ) -> Vec<Rgb<f32>> {
        let mut pixels = vec![Rgb::BLACK; 48 * 36];
        let mut target = LinearRgb::new(Size::new(48, 36), &mut pixels).unwrap();
        Frame::new(tracer, Settings::new(48, 36).with_depth(6)).unwrap().render(&mut target).unwrap();
        pixels
    }
    macro_rules! same {
        ($scene:path) => {{
            let all = Tracer::<f32, { Effects::ALL.bits() }, { $scene.stack(6) }, { $scene.media() }>::try_new(&$scene)
                .unwrap();
            assert_eq!(draw(&whit::tracer!($scene, 6)), draw(&all));
        }};
    }
    same!(scenes::SHOWCASE);
    same!(scenes::SPHERES);
    same!(scenes::MIRRORS);
    same!(scenes::FLAKE);
    same!(scenes::CARD);
    same!(scenes::METALS);
    same!(scenes::WINDOW);
    same!(scenes::GLASS);
    same!(scenes::DEEP);
    same!(scenes::TINTS);
    same!(scenes::BUBBLE);
    same!(scenes::OIL);
    same!(scenes::TITANIUM);
    same!(scenes::PRISM);
    same!(pairs::OFFSET);
    same!(pairs::RINGS);
    same!(pairs::STARS);
    same!(pairs::ANNULUS);
    same!(pairs::HEIGHT);
    same!(pairs::RADIUS);
    same!(pairs::HEIGHT_AND_RADIUS);
    same!(pairs::HEIGHT_BY_LAYERS);
    same!(pairs::HEIGHT_IN_FIXED_STEPS);
    same!(pairs::POLYNOMIAL);
    same!(pairs::FISH_EYE);
    same!(pairs::TABULATED);
    same!(pairs::BENT_SHADOWS);
    same!(pairs::BLACK_HOLE);
    same!(NOTHING_TO_BEND);
}

/// Bent shadow rays in a scene that bends no light are straight, as they are without the effect.
const NOTHING_TO_BEND: Scene<'static, f32> = pairs::SPHERE.with_bent_shadows();

#[test]
fn missing_effects_are_named() {
    const FEWER: u64 = scenes::SHOWCASE.effects().without(Effects::CONE.with(Effects::GRADIENT)).bits();
    let error = Tracer::<f32, FEWER, 5>::try_new(&scenes::SHOWCASE).map(|_| ()).unwrap_err();
    assert_eq!(error, TracerError::MissingEffects(Effects::CONE.with(Effects::GRADIENT)));
    assert_eq!(error.to_string(), "the tracer was compiled without: cone, gradient");
}

/// A scene in a buffer, packed spheres taken apart, looks the same; and in `f64` nearly so.
#[test]
fn buffers_hold_copies_in_any_number_type() {
    let mut pixels = vec![Rgb::BLACK; 40 * 40];
    let mut pictures = Vec::new();
    let same = SceneBuf::<f32, 64, 2>::from_scene(&scenes::CARD, |x| x).unwrap();
    let wide = SceneBuf::<f64, 64, 2>::from_scene(&scenes::CARD, f64::from).unwrap();
    let mut target = LinearRgb::new(Size::new(40, 40), &mut pixels).unwrap();
    Frame::new(&whit::tracer!(scenes::CARD), Settings::new(40, 40).with_depth(5)).unwrap().render(&mut target).unwrap();
    pictures.push(pixels.clone());
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 5>::try_new(&same.as_scene()).unwrap().scene().objects.len();
    assert_eq!(tracer, 50);
    let scene = same.as_scene();
    let mut target = LinearRgb::new(Size::new(40, 40), &mut pixels).unwrap();
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 5>::try_new(&scene).unwrap();
    Frame::new(&tracer, Settings::new(40, 40).with_depth(5)).unwrap().render(&mut target).unwrap();
    assert_eq!(pixels, pictures[0]);
    let scene = wide.as_scene();
    let mut target = LinearRgb::new(Size::new(40, 40), &mut pixels).unwrap();
    let tracer = Tracer::<f64, { Effects::ALL.bits() }, 5>::try_new(&scene).unwrap();
    Frame::new(&tracer, Settings::new(40, 40).with_depth(5)).unwrap().render(&mut target).unwrap();
    let off = pixels.iter().zip(&pictures[0]).filter(|(a, b)| (a.r - b.r).abs() > 1.0 / 255.0).count();
    assert!(off <= 4, "{off} pixels differ between f32 and f64");
    let full = SceneBuf::<f32, 49, 2>::from_scene(&scenes::CARD, |x| x).map(|_| ()).unwrap_err();
    assert_eq!(full.to_string(), "no room for another object: the capacity is 49");
}

/// What bends light is copied too, but for tables; and it is bent in `f64` as it is in `f32`.
#[test]
fn buffers_hold_what_bends_light() {
    let draw = |scene: &Scene<'_, f32>| {
        let mut pixels = vec![Rgb::BLACK; 24 * 18];
        let mut target = LinearRgb::new(Size::new(24, 18), &mut pixels).unwrap();
        let tracer = Tracer::<f32, { Effects::ALL.bits() }, 5, 8>::try_new(scene).unwrap();
        Frame::new(&tracer, Settings::new(24, 18).with_depth(5)).unwrap().render(&mut target).unwrap();
        pixels
    };
    for (name, scene) in bent::scenes() {
        let copy = SceneBuf::<f32, 8, 2, 2>::from_scene(&scene, |x| x);
        let wide = SceneBuf::<f64, 8, 2, 2>::from_scene(&scene, f64::from);
        let (Ok(copy), Ok(wide)) = (copy, wide) else {
            assert!(scene.effects().has(Effects::TABLE_LAW), "{name}");
            continue;
        };
        assert_eq!(copy.as_scene(), scene, "{name}");
        let single = draw(&scene);
        let mut pixels = vec![Rgb::BLACK; 24 * 18];
        let mut target = LinearRgb::new(Size::new(24, 18), &mut pixels).unwrap();
        let wide = wide.as_scene();
        let tracer = Tracer::<f64, { Effects::ALL.bits() }, 5, 8>::try_new(&wide).unwrap();
        Frame::new(&tracer, Settings::new(24, 18).with_depth(5)).unwrap().render(&mut target).unwrap();
        let off = pixels.iter().zip(&single).filter(|(a, b)| (a.r - b.r).abs() > 2.0 / 255.0).count();
        println!("{name:38} {off} of 432 pixels differ between f32 and f64");
        assert!(off < 432 / 10, "{name}: {off} pixels differ between f32 and f64");
    }
    let few = SceneBuf::<f32, 8, 2, 1>::from_scene(&bent::scenes()[0].1, |x| x).map(|_| ()).unwrap_err();
    assert_eq!(few.to_string(), "no room for another profile: the capacity is 1");
    let table = bent::scenes().into_iter().find(|(_, scene)| scene.effects().has(Effects::TABLE_LAW)).unwrap().1;
    let error = SceneBuf::<f64, 8, 2, 2>::from_scene(&table, f64::from).map(|_| ()).unwrap_err();
    assert_eq!(error.what, "table in another number type");
}

/// Every number that is out of its range is refused by the name of its object and its field.
#[test]
fn senseless_numbers_are_refused() {
    type Change = dyn Fn(&mut Scene<'_, f32>, &mut Vec<whit::Object<'static, f32>>);
    let refused = |change: &Change| {
        let mut objects = scenes::SPHERES.objects.to_vec();
        let mut scene = scenes::SPHERES;
        change(&mut scene, &mut objects);
        let scene = Scene { objects: &objects, ..scene };
        Tracer::<f32, { Effects::ALL.bits() }, 5>::try_new(&scene).map(|_| ()).unwrap_err().to_string()
    };
    const NOWHERE: [whit::Light<f32>; 1] = [whit::Light::directional(Vec3::ZERO, Rgb::WHITE)];
    const NAN: f32 = f32::NAN;
    assert_eq!(
        refused(&|_, objects| objects[2].shape = whit::Shape::sphere(Vec3::new(0.0, NAN, 0.0), 1.0)),
        "object 2: center: expected a finite number of at most 1e12"
    );
    assert_eq!(
        refused(&|_, objects| objects[4].material = whit::Material::dielectric(0.0)),
        "object 4: interface.medium.index: expected an index of refraction from 1e-3 to 1e3"
    );
    assert_eq!(
        refused(&|_, objects| objects[1].material = whit::Material::mirror(Rgb::grey(1.5))),
        "object 1: interface.reflected: expected a number from 0 to 1"
    );
    assert_eq!(
        refused(&|scene, _| scene.camera.target = scene.camera.eye),
        "camera: target: expected a point away from the eye"
    );
    assert_eq!(
        refused(&|scene, _| scene.camera.up = Vec3::new(0.0, 0.0, 0.0)),
        "camera: up: expected finite numbers, not all zero"
    );
    assert_eq!(
        refused(&|scene, _| scene.background = whit::Background::Solid(Rgb::grey(f32::INFINITY))),
        "scene: background: expected a number from 0 to 1e12"
    );
    assert_eq!(refused(&|scene, _| scene.lights = &NOWHERE), "light 0: towards: expected finite numbers, not all zero");
}

/// A copy holds every part of every material.
#[test]
fn copies_are_complete() {
    use whit::scene::{Film, Medium, Thickness};
    use whit::{Fresnel, Interface, Material, Object, Shape};
    let color = |x: f32| Rgb::new(x, x + 0.01, x + 0.02);
    let medium = Medium::new(1.1).with_attenuation(color(0.3)).with_priority(7);
    let gradient = Thickness::Gradient { from: 1.0, to: 2.0, origin: Vec3::new(3.0, 4.0, 5.0), axis: Vec3::splat(0.5) };
    let radial = Thickness::Radial { from: 6.0, to: 7.0, center: Vec3::new(8.0, 9.0, 10.0), radius: 11.0 };
    let materials = [
        Material::transparent(medium).with_film(Film::new(1.2, 250.0)),
        Material::transparent(Medium::dispersive(color(1.5))).with_film(Film::new(1.3, 0.0).with_thickness(gradient)),
        Material::conductor(color(0.2), color(3.0)).with_film(Film::new(1.4, 0.0).with_thickness(radial)),
        Material::matte(color(0.6)).with_shares(0.1, 0.2, 0.3).with_coat(1.6).with_balance(0.4, 0.5),
        Material::mirror(color(0.7)).with_interface(Interface::Constant {
            reflected: color(0.1),
            transmitted: color(0.8),
            medium,
        }),
        Material::metal(color(0.9)).with_highlight(color(0.4), 12),
    ];
    let objects =
        materials.map(|material| Object::new(Shape::sphere(Vec3::new(1.0, 2.0, 3.0), 4.0), material).one_sided());
    let scene = scenes::SPHERES.with_objects(&objects).with_medium(medium).with_fresnel(Fresnel::Schlick);
    let copy = SceneBuf::<f32, 6, 2>::from_scene(&scene, |x| x).unwrap();
    assert_eq!(copy.as_scene(), scene);
    let wide = SceneBuf::<f64, 6, 2>::from_scene(&scene, f64::from).unwrap();
    let back = SceneBuf::<f32, 6, 2>::from_scene(&wide.as_scene(), |x| x as f32).unwrap();
    assert_eq!(back.as_scene(), scene);
}
