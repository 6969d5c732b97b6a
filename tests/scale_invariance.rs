//! A scene in another unit of length gives the same bits: there is no length in the library that is not the scene's.
//!
//! Every built-in scene, one of every kind of shape, light, pattern, medium and film, and scenes in which light is bent, are
//! multiplied by powers of two, which change no digit of a number.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing)]

#[path = "support/bent.rs"]
mod bent;
#[path = "support/scaled.rs"]
mod scaled;

use rayon::prelude::*;
use scaled::Scaled;
use whit::optics::{Band, bands, materials};
use whit::render::{LinearRgb, Sampling, Size};
use whit::scene::{
    Aperture, Emitter, Exponent, Falloff, Film, Fresnel, Hierarchy, HierarchyBuf, Highlight, Lens, Lobe, Medium,
    Offset, PackedSpheres, SmoothTriangle, Spectrum, Sphere, Thickness, Triangle,
};
use whit::trace::Sequence;
use whit::{
    Background, Camera, Effects, Frame, Interface, Light, Material, Object, Pattern, Ray, Rgb, Scene, Settings, Shape,
    Stats, Tone, Tracer, Vec3, scenes,
};

const PARTS: usize = scenes::SHOWCASE.parts();
static BOXES: HierarchyBuf<{ Hierarchy::nodes(PARTS) }, PARTS> = HierarchyBuf::of(&scenes::SHOWCASE);

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);

/// The bits of a picture of one sample a pixel and of a smaller one of four, which use lenses and lights with an area;
/// and the counts of rays.
fn pictures(scene: &Scene<'_, f32>) -> Result<(Vec<[u32; 3]>, String), String> {
    match scene.media() {
        0 => render::<0>(scene),
        _ => render::<8>(scene),
    }
}

fn render<const MEDIA: usize>(scene: &Scene<'_, f32>) -> Result<(Vec<[u32; 3]>, String), String> {
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 10, MEDIA>::try_new(scene).map_err(|e| e.to_string())?;
    let (mut bits, mut counts) = (Vec::new(), String::new());
    for (size, sampling) in [(Size::new(32, 24), Sampling::Grid(1)), (Size::new(12, 9), Sampling::Sequence(4))] {
        let settings = Settings::new(size.width, size.height).with_depth(6).with_sampling(sampling);
        let mut pixels = vec![Rgb::BLACK; size.pixels() as usize];
        let mut target = LinearRgb::new(size, &mut pixels).unwrap();
        let mut frame = Frame::observed(&tracer, settings, Stats::default()).unwrap();
        frame.render(&mut target).unwrap();
        counts += &format!("{:?}", frame.observer());
        bits.extend(pixels.iter().map(|color| [color.r, color.g, color.b].map(f32::to_bits)));
    }
    Ok((bits, counts))
}

/// Every scene there is.
fn all_scenes() -> Vec<(&'static str, Scene<'static, f32>)> {
    let every_kind = every_kind();
    let more = [
        ("every kind", every_kind[0]),
        ("every other kind", every_kind[1]),
        ("a fixed offset", scenes::SHOWCASE.with_offset(Offset::Fixed(1e-3))),
        ("a hierarchy", scenes::SHOWCASE.with_hierarchy(BOXES.view())),
    ];
    scenes::ALL.into_iter().chain(more).collect()
}

/// Every law, method and kind of shadow ray.
fn bent_scenes() -> Vec<(&'static str, Scene<'static, f32>)> {
    bent::scenes().into_iter().map(|(name, scene)| (&*name.leak(), scene)).collect()
}

#[test]
fn every_effect_is_in_a_scene() {
    let scenes = all_scenes().into_iter().chain(bent_scenes());
    let effects = scenes.fold(Effects::NONE, |all, (_, scene)| all.with(scene.effects()));
    assert!(Effects::ALL.without(effects).is_empty(), "missing: {}", Effects::ALL.without(effects));
}

/// Powers of two that take every scene past the limits of coordinates on both sides.
const POWERS: std::ops::RangeInclusive<i32> = -45..=45;

/// As far as validation goes with a scene, and from a millionth to a million times the size at least.
#[test]
fn scaled_scenes_have_the_same_bits() {
    assert_same_bits(&all_scenes(), POWERS);
}

/// What bends light has units too: levels, laws, steps, the mass of a black hole.
#[test]
fn scaled_scenes_that_bend_light_have_the_same_bits() {
    assert_same_bits(&bent_scenes(), POWERS.step_by(10));
}

fn assert_same_bits(scenes: &[(&str, Scene<'static, f32>)], powers: impl Iterator<Item = i32> + Clone) {
    let expected: Vec<_> = scenes.par_iter().map(|(_, scene)| pictures(scene).unwrap()).collect();
    let cases: Vec<_> = (0..scenes.len()).flat_map(|scene| powers.clone().map(move |k| (scene, k))).collect();
    let compare = |&(scene, k): &(usize, i32)| {
        let (name, original) = &scenes[scene];
        match pictures(&Scaled::new(original, 2.0_f32.powi(k)).scene()) {
            Err(error) if k.abs() <= 20 => Some(format!("{name} times 2^{k}: {error}")),
            Err(_) => None,
            Ok((bits, counts)) => {
                let off = bits.iter().zip(&expected[scene].0).filter(|(a, b)| a != b).count();
                let same = counts == expected[scene].1;
                (off > 0 || !same).then(|| format!("{name} times 2^{k}: {off} pixels, same rays: {same}"))
            }
        }
    };
    let differences: Vec<_> = cases.par_iter().filter_map(compare).collect();
    assert!(differences.is_empty(), "{}", differences.join("\n"));
    for (name, scene) in scenes {
        let is_accepted = |k: &i32| {
            let scaled = Scaled::new(scene, 2.0_f32.powi(*k));
            scaled.scene().validate().is_ok()
        };
        let accepted: Vec<_> = powers.clone().filter(is_accepted).collect();
        println!("{name:38} the same bits from 2^{} to 2^{}", accepted[0], accepted[accepted.len() - 1]);
    }
}

/// Numbers of what random rays meet of a shape of about the size 1, in units of `scale`.
fn hits(shape: &Shape<'_, f32>, scale: f32) -> Option<Vec<Option<[f32; 10]>>> {
    let number = |i: u32, dimension| Sequence::new(i, 7).point::<f32>(i, dimension).map(|x| x * 2.0 - 1.0);
    let original = Object::new(*shape, Material::matte(Rgb::WHITE));
    let scene = Scene::new(
        Camera::look_at(UP * 4.0, Vec3::ZERO, Vec3::new(1.0, 0.0, 0.0), 40.0),
        Background::Solid(Rgb::BLACK),
    );
    let objects = [original];
    let scaled = Scaled::new(&scene.with_objects(&objects), scale);
    let scene = scaled.scene();
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 0>::try_new(&scene).ok()?;
    let hit = |i| {
        let ([a, b], [c, d], [e, f]) = (number(i, 0), number(i, 1), number(i, 2));
        // From outside and from inside.
        let origin = Vec3::new(a, b, c) * if i % 2 == 0 { 3.0 } else { 0.5 };
        let ray = Ray { origin: origin * scale, direction: (Vec3::new(d, e, f) - origin).normalized() };
        let hit = tracer.intersect(&ray)?;
        let (p, n, o) = (hit.point * (1.0 / scale), hit.normal, hit.offset * (1.0 / scale));
        Some([hit.distance / scale, p.x, p.y, p.z, n.x, n.y, n.z, o.x, o.y, o.z])
    };
    Some((0..4000).map(hit).collect())
}

/// The same rays meet the same shapes, from 4·10⁻¹² to 10¹¹ units large.
#[test]
fn scaled_shapes_are_met_alike() {
    let v = Vec3::new;
    let corners = [v(-1.1, -0.7, 0.2), v(1.3, -0.5, -0.4), v(0.1, 1.2, 0.3)];
    let sliver = [v(-1.1, -0.7, 0.2), v(1.3, 0.5, -0.4), v(1.3, 0.55, -0.4)];
    let shapes = [
        ("sphere", Shape::sphere(v(0.1, -0.2, 0.3), 0.9)),
        ("plane", Shape::plane(v(0.1, -0.2, 0.3), v(0.4, 1.0, -0.2))),
        ("disc", Shape::disc(v(0.1, -0.2, 0.3), v(0.4, 1.0, -0.2), 0.9)),
        ("annulus", Shape::annulus(v(0.1, -0.2, 0.3), v(0.4, 1.0, -0.2), 0.3, 0.9)),
        ("box", Shape::axis_box(v(-0.7, -0.8, -0.2), v(0.6, 0.4, 0.9))),
        ("triangle", Shape::triangle(corners[0], corners[1], corners[2])),
        ("sliver", Shape::triangle(sliver[0], sliver[1], sliver[2])),
        ("cylinder", Shape::cylinder(v(-0.5, -0.8, 0.1), v(0.4, 0.9, -0.2), 0.6).capped()),
        ("cone", Shape::cone(v(-0.5, -0.8, 0.1), 0.7, v(0.4, 0.9, -0.2), 0.0).capped()),
    ];
    for (name, shape) in shapes {
        let expected = hits(&shape, 1.0).unwrap();
        let met = expected.iter().flatten().count();
        let same = |k: &i32| hits(&shape, 2.0_f32.powi(*k)).is_some_and(|hits| hits == expected);
        let alike: Vec<_> = POWERS.into_par_iter().filter(same).collect();
        println!("{name:8} {met} of 4000 met, alike from 2^{} to 2^{}", alike[0], alike[alike.len() - 1]);
        assert!(met > 10 && (-38..=37).all(|k| alike.contains(&k)), "{name}: {alike:?}");
    }
}

static SPECTRUM: [Band; 8] = bands();

/// What the built-in scenes leave out, and the rest once more.
fn every_kind() -> [Scene<'static, f32>; 2] {
    let v = Vec3::new;
    let plain = |r, g, b| Material::matte(Rgb::new(r, g, b)).with_shares(0.05, 0.1, 0.7);
    let shiny = |lobe, exponent| {
        let highlight = Some(Highlight { color: Rgb::grey(0.4), lobe, exponent });
        Material { highlight, ..plain(0.3, 0.5, 0.2).with_interface(Interface::Mirror { reflected: Rgb::grey(0.2) }) }
    };
    let fade =
        Pattern::Gradient { from: Rgb::new(0.9, 0.2, 0.1), to: Rgb::WHITE, origin: Vec3::ZERO, axis: v(0.3, 0.4, 0.1) };
    let checks =
        Pattern::Checker { even: Rgb::grey(0.8), odd: Rgb::grey(0.3), u: v(1.7, 0.1, 0.0), v: v(0.0, 0.3, 2.1) };
    let water = Medium::new(materials::WATER).with_attenuation(Rgb::new(0.4, 0.2, 0.1)).with_priority(2);
    let tinted =
        Interface::Constant { reflected: Rgb::new(0.2, 0.1, 0.3), transmitted: Rgb::new(0.7, 0.8, 0.5), medium: water };
    let fan = vec![
        Triangle { vertices: [v(-3.0, 0.0, -2.0), v(-2.0, 0.0, -2.5), v(-2.4, 1.6, -2.2)] },
        Triangle { vertices: [v(-2.0, 0.0, -2.5), v(-1.2, 0.2, -1.9), v(-2.4, 1.6, -2.2)] },
    ];
    let row = std::array::from_fn(|i| Sphere { center: v(0.4 * i as f32 - 2.0, 0.15, 2.4), radius: 0.17 });
    let packed: &PackedSpheres<f32, 1, 2> = Box::leak(Box::new(PackedSpheres::new::<10>(&row)));
    let smooth = SmoothTriangle {
        vertices: [v(0.4, 0.1, 1.2), v(1.4, 0.0, 1.0), v(0.9, 1.1, 0.9)],
        normals: [v(-0.6, 0.1, 1.0), v(0.5, 0.0, 1.0), v(0.0, 0.9, 0.7)],
    };
    let soap = Film::new(materials::SOAP_FILM, 300.0);
    let radial = Thickness::Radial { from: 100.0, to: 700.0, center: v(-1.0, 1.4, -0.6), radius: 0.5 };
    let gradient = Thickness::Gradient { from: 80.0, to: 600.0, origin: v(0.0, 0.9, 0.0), axis: v(0.1, 0.9, 0.2) };
    let gold = Material::conductor(materials::GOLD.index, materials::GOLD.extinction);
    let flint = Material::transparent(Medium::dispersive(materials::dispersive::FLINT_GLASS.channels()));
    let objects = vec![
        Object::new(Shape::disc(Vec3::ZERO, v(0.1, 2.0, 0.0), 4.0), Material::patterned(fade)),
        Object::new(Shape::plane(v(0.0, -0.3, 0.0), v(0.0, 3.0, 0.1)), Material::patterned(checks).with_coat(1.5)),
        Object::new(Shape::Triangles(fan.leak()), shiny(Lobe::Phong, Exponent::Real(17.5))),
        Object::new(Shape::triangle(v(2.2, 0.0, 1.4), v(3.0, 0.1, 0.6), v(2.5, 1.2, 0.9)), plain(0.8, 0.4, 0.3)),
        Object::new(Shape::SmoothTriangle(smooth), shiny(Lobe::Blinn, Exponent::Integer(40))),
        Object::new(Shape::Spheres(packed.view()), Material::metal(Rgb::new(0.9, 0.7, 0.4))),
        Object::new(Shape::sphere(v(-1.6, 0.9, 0.7), -0.6), plain(0.2, 0.3, 0.9)).one_sided(),
        Object::new(Shape::sphere(v(-0.3, 0.7, 0.2), 0.5), plain(0.2, 0.3, 0.9).with_interface(tinted))
            .with_tinted_shadow(),
        Object::new(Shape::sphere(v(0.1, 0.6, 0.5), 0.3), flint.with_priority(3)).with_tinted_shadow(),
        Object::new(
            Shape::sphere(v(-1.0, 1.4, -0.6), 0.4),
            Material::dielectric(1.0).with_film(soap.with_thickness(radial)),
        ),
        Object::new(
            Shape::sphere(v(0.8, 1.7, -0.8), 0.4),
            gold.with_film(soap.with_thickness(gradient).with_spectrum(Spectrum::Bands(&SPECTRUM))),
        ),
        Object::new(
            Shape::sphere(v(1.6, 1.9, -1.2), 0.3),
            Material::dielectric(1.4).with_film(soap.with_spectrum(Spectrum::Wavelengths)),
        ),
        Object::new(Shape::cone(v(1.9, 0.1, 0.0), 0.5, v(2.2, 1.4, -0.4), 0.2), plain(0.9, 0.8, 0.1)).without_shadow(),
        Object::new(Shape::cone(v(0.6, 0.3, -1.4), 0.4, v(1.8, 1.2, -2.2), 0.4).capped(), gold),
        Object::new(Shape::cone(v(-0.7, 0.1, 1.9), -0.4, v(-0.7, 0.9, 1.7), -0.1).capped(), plain(0.7, 0.2, 0.6))
            .one_sided(),
        Object::new(
            Shape::axis_box(v(-2.6, 0.2, 0.6), v(-2.2, 1.0, 1.3)),
            Material::mirror(Rgb::grey(0.9)).with_balance(0.6, 0.9),
        ),
    ];
    let falloff = Falloff { constant: 0.5, linear: 0.05, quadratic: 0.02 };
    let panel =
        Emitter::Parallelogram { corner: v(-2.0, 4.0, -1.0), edge_u: v(1.0, 0.0, 0.3), edge_v: v(0.0, 0.4, 1.0) };
    let lights = vec![
        Light::sphere(v(2.0, 5.0, 3.0), 0.8, Rgb::new(0.9, 0.8, 0.7)).with_falloff(falloff),
        Light::directional(v(-2.0, 3.0, 1.0), Rgb::grey(0.3)),
        Light::point(v(-3.0, 2.0, 4.0), Rgb::new(0.1, 0.2, 0.3)).with_falloff(falloff),
        Light { emitter: panel, color: Rgb::grey(0.4), falloff: Some(falloff) },
    ];
    let (objects, lights): (&'static [_], &'static [_]) = (objects.leak(), lights.leak());
    let camera = Camera::look_at(v(0.5, 2.2, 5.5), v(-0.2, 0.5, 0.0), UP, 48.0);
    let lens = |aperture| camera.with_lens(Lens { aperture, focus: 5.0 });
    let air = Medium::new(1.1).with_attenuation(Rgb::new(0.01, 0.02, 0.03));
    let sky = Background::Sky { horizon: Rgb::new(0.5, 0.6, 0.8), up: UP };
    let round = Scene::new(lens(Aperture::Disc { radius: 0.02 }), sky).with_objects(objects).with_lights(lights);
    let fading = Background::Gradient { below: Rgb::grey(0.3), above: Rgb::WHITE, up: UP };
    let square = Scene::new(lens(Aperture::Square { side: 0.03 }), fading).with_objects(objects).with_lights(lights);
    [
        round.with_medium(air),
        Scene {
            tone: Tone::Display { gain: 0.8, lift: 0.05 },
            ..square.with_medium(air).with_fresnel(Fresnel::Schlick)
        },
    ]
}

/// How many points of a floor under a ball are in the shadow of a lamp, for shadow rays that start as told.
fn shadowed(scale: f32, start: impl Fn(Vec3<f32>, Vec3<f32>, Vec3<f32>) -> Vec3<f32>) -> usize {
    let objects = [
        Object::new(Shape::plane(Vec3::ZERO, UP), Material::matte(Rgb::WHITE)),
        Object::new(Shape::sphere(Vec3::new(0.0, 0.5, 0.0) * scale, 0.5 * scale), Material::matte(Rgb::WHITE)),
    ];
    let eye = Vec3::new(3.0, 4.0, 5.0) * scale;
    let scene = Scene::new(Camera::look_at(eye, Vec3::ZERO, UP, 40.0), Background::Solid(Rgb::BLACK));
    let scene = scene.with_objects(&objects);
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 0>::try_new(&scene).unwrap();
    let lamp = Vec3::new(-2.0, 3.0, 1.0) * scale;
    let places = (0..2500).map(|i| Vec3::new(0.04 * (i % 50) as f32 - 1.0, 0.3, 0.04 * (i / 50) as f32 - 1.0) * scale);
    let is_shadowed = |place: &Vec3<f32>| {
        let hit = tracer.intersect(&Ray { origin: eye, direction: (*place - eye).normalized() }).unwrap();
        let direction = (lamp - hit.point).normalized();
        let origin = start(hit.point, hit.offset, direction);
        tracer.intersect(&Ray { origin, direction }).is_some()
    };
    places.filter(is_shadowed).count()
}

/// A shadow ray that starts a thousandth of a unit along its way is right for scenes of one size only: in large ones
/// it meets the surface that it leaves, in small ones it steps over what casts the shadow.
#[test]
fn a_fixed_epsilon_is_right_at_one_scale_only() {
    let scales = [-20, -10, -5, 0, 5, 10, 20];
    let offset = |point: Vec3<f32>, offset: Vec3<f32>, _: Vec3<f32>| point + offset;
    let epsilon = |point: Vec3<f32>, _: Vec3<f32>, direction: Vec3<f32>| point + direction * 1e-3;
    let [by_offset, by_epsilon] =
        [&offset as &dyn Fn(_, _, _) -> _, &epsilon].map(|start| scales.map(|k| shadowed(2.0_f32.powi(k), start)));
    println!("in the shadow of 2500, times 2^{scales:?}: {by_offset:?}; by an epsilon {by_epsilon:?}");
    assert!(by_offset.iter().all(|count| *count == by_offset[3]));
    assert_eq!(by_epsilon[3], by_offset[3]);
    assert!(by_epsilon.iter().any(|count| *count < by_offset[3] / 2));
    assert!(by_epsilon.iter().any(|count| *count > by_offset[3]));
}
