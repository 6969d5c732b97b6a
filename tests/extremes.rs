//! Whatever validation accepts renders finite pixels: materials, media and what bends light at the ends of their ranges.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing)]

use whit::optics::{Band, bands};
use whit::render::{LinearRgb, Size};
use whit::scene::{BlackHole, Film, Law, Level, Medium, Method, Profile, Spectrum, Steps, Thickness};
use whit::{
    Background, Budget, Camera, Destination, Effects, Frame, Fresnel, Interface, Intersection, Light, Material, Object,
    Ray, Real, Rgb, Scene, SceneBuf, Settings, Shape, Tracer, Vec3,
};

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const INDICES: [f32; 6] = [1e-3, 0.6, 1.0, 1.000_000_1, 2.5, 1e3];
static BANDS: [Band; 8] = bands();
static WRONG_BANDS: [Band; 2] =
    [Band { wavelength: 1.0, weight: Rgb::grey(1e3) }, Band { wavelength: 1e6, weight: Rgb::grey(-1e3) }];

fn assert_finite(material: Material<f32>, around: Medium<f32>, fresnel: Fresnel) {
    let camera = Camera::look_at(Vec3::new(0.2, 0.7, 3.0), Vec3::ZERO, UP, 60.0);
    let objects = [
        Object::new(Shape::sphere(Vec3::new(-0.6, 0.0, 0.0), 0.8), material),
        Object::new(Shape::axis_box(Vec3::new(0.0, -0.7, -0.6), Vec3::new(0.9, 0.5, 0.4)), material),
        Object::new(Shape::plane(UP * -0.7, UP), Material::matte(Rgb::grey(0.5)).with_coat(1.5)),
    ];
    let lights = [Light::point(Vec3::new(2.0, 4.0, 3.0), Rgb::WHITE)];
    let scene = Scene::new(camera, Background::Solid(Rgb::WHITE)).with_objects(&objects).with_lights(&lights);
    let scene = scene.with_medium(around).with_fresnel(fresnel);
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 8, 4>::try_new(&scene).unwrap();
    let mut pixels = [Rgb::BLACK; 10 * 8];
    let mut target = LinearRgb::new(Size::new(10, 8), &mut pixels).unwrap();
    Frame::new(&tracer, Settings::new(10, 8).with_depth(6)).unwrap().render(&mut target).unwrap();
    for pixel in pixels {
        let fine = [pixel.r, pixel.g, pixel.b].iter().all(|channel| (0.0..=20.0).contains(channel));
        assert!(fine, "{pixel:?}: {material:?} in {around:?}, {fresnel:?}");
    }
}

#[test]
fn interfaces() {
    for n in INDICES {
        for m in INDICES {
            let around = Medium::new(m);
            let constant =
                Interface::Constant { reflected: Rgb::grey(0.5), transmitted: Rgb::grey(0.5), medium: Medium::new(n) };
            let materials = [
                Material::dielectric(n),
                Material::transparent(Medium::dispersive(Rgb::new(n, m, 1.5))),
                Material::matte(Rgb::grey(0.5)).with_coat(n),
                Material::dielectric(n).with_interface(constant),
                Material::conductor(Rgb::new(n, m, n), Rgb::new(0.0, 1e3, m)),
                Material::conductor(Rgb::grey(n), Rgb::grey(0.0)).with_balance(1.0, 1.0),
            ];
            for material in materials {
                for fresnel in [Fresnel::Exact, Fresnel::Schlick] {
                    assert_finite(material, around, fresnel);
                }
            }
        }
    }
}

#[test]
fn attenuation() {
    for c in [0.0, 1e-38, 1.0, 1e12] {
        let tinted = Medium::new(1.5).with_attenuation(Rgb::new(c, 0.0, 1.0));
        for around in [Medium::VACUUM, tinted] {
            assert_finite(Material::transparent(tinted.with_priority(255)), around, Fresnel::Exact);
        }
    }
}

#[test]
fn films() {
    let spectra = [Spectrum::Wavelengths, Spectrum::Bands(&BANDS), Spectrum::Bands(&WRONG_BANDS), Spectrum::Table];
    for n in INDICES {
        for index in INDICES {
            for base in INDICES {
                for thickness in [0.0, 1e-30, 300.0, 1e5] {
                    for spectrum in spectra {
                        assert_finite_film(Film::new(index, thickness).with_spectrum(spectrum), base, n);
                    }
                }
            }
        }
    }
}

fn assert_finite_film(film: Film<f32>, base: f32, around: f32) {
    let varying = Thickness::Radial { from: 0.0, to: 1e5, center: Vec3::ZERO, radius: 1e-12 };
    let conductor = Material::conductor(Rgb::grey(base), Rgb::new(0.0, 3.0, 1e3));
    assert_finite(Material::dielectric(base).with_film(film), Medium::new(around), Fresnel::Exact);
    assert_finite(conductor.with_film(film.with_thickness(varying)), Medium::new(around), Fresnel::Exact);
}

/// A scene of things about as large as `scale`, far from the origin or not, in `f32` and in `f64`. `true` if it is accepted.
fn assert_bent_finite(
    at: f32,
    scale: f32,
    bend: impl Fn(Scene<'_, f32>, &dyn Fn(Scene<'_, f32>) -> bool) -> bool,
) -> bool {
    let place = |x: f32, y: f32, z: f32| Vec3::new(at, at, -at) + Vec3::new(x, y, z) * scale;
    if place(1.0, 1.0, 1.0) == place(0.0, 0.0, 0.0) {
        return false;
    }
    let camera = Camera::look_at(place(0.2, 0.7, 3.0), place(0.0, 0.0, 0.0), UP, 60.0);
    let objects = [
        Object::new(Shape::sphere(place(-0.6, 0.0, 0.0), 0.8 * scale), Material::transparent(Medium::graded(0))),
        Object::new(Shape::axis_box(place(0.0, -0.7, -0.6), place(0.9, 0.5, 0.4)), Material::mirror(Rgb::grey(0.5))),
        Object::new(Shape::plane(place(0.0, -0.7, 0.0), UP), Material::matte(Rgb::grey(0.5)).with_coat(1.5)),
    ];
    let lights = [Light::point(place(2.0, 4.0, 3.0), Rgb::WHITE), Light::directional(UP, Rgb::WHITE)];
    let scene = Scene::new(camera, Background::Solid(Rgb::WHITE)).with_objects(&objects).with_lights(&lights);
    bend(scene.with_medium(Medium::graded(0)).with_bent_shadows(), &|scene| {
        if scene.validate().is_err() {
            return false;
        }
        for (i, profile) in (0..64).flat_map(|i| scene.profiles.iter().map(move |profile| (i, profile))) {
            let n = profile.index(place(0.0, i as f32 / 63.0, 0.0));
            assert!((5e-4..=2e3).contains(&n), "{n}: {profile:?}");
        }
        assert_finite_pixels(&scene);
        let wide = SceneBuf::<f64, 4, 2, 1>::from_scene(&scene, f64::from).unwrap();
        assert_finite_pixels(&wide.as_scene());
        true
    })
}

fn assert_finite_pixels<T: Real>(scene: &Scene<'_, T>) {
    let tracer = Tracer::<T, { Effects::ALL.bits() }, 8, 4>::try_new(scene).unwrap();
    for steps_per_ray in [3, 100] {
        let mut pixels = [Rgb::BLACK; 6 * 5];
        let mut target = LinearRgb::new(Size::new(6, 5), &mut pixels).unwrap();
        let budget = Budget { steps_per_ray, ..Budget::with_depth(4) };
        Frame::new(&tracer, Settings { budget, ..Settings::new(6, 5) }).unwrap().render(&mut target).unwrap();
        for pixel in pixels {
            let fine = [pixel.r, pixel.g, pixel.b].iter().all(|channel| (0.0..=60.0).contains(channel));
            assert!(fine, "{pixel:?}: {:?} {:?}", scene.profiles, scene.black_hole);
        }
        // A pixel does not show what is not a number.
        for i in 0..9 {
            let number = |i: i32| T::from_f32(0.3 * i as f32);
            let aside = Vec3::new(number(i % 3 - 1), number(i / 3 - 1), T::ZERO);
            let forward = (scene.camera.target - scene.camera.eye).normalized();
            let ray = Ray { origin: scene.camera.eye, direction: (forward + aside).normalized() };
            let light = tracer.trace(ray, &budget, &mut ());
            let fine = |x: T| x >= T::ZERO && x <= T::from_f32(60.0);
            assert!(
                fine(light.r) && fine(light.g) && fine(light.b),
                "{light:?}: {:?} {:?}",
                scene.profiles,
                scene.black_hole
            );
            if let Destination::Away(direction) | Destination::Surface(Intersection { direction, .. }) =
                tracer.destination(&ray, steps_per_ray)
            {
                let off = (direction.length() - T::ONE).abs();
                assert!(off < T::from_f32(1e-5), "{direction:?}: {:?} {:?}", scene.profiles, scene.black_hole);
            }
        }
    }
}

const SCALES: [f32; 3] = [1e-9, 1.0, 1e9];
const PLACES: [f32; 3] = [0.0, 1e6, 1e11];

fn methods(scale: f32) -> [Method<f32>; 8] {
    let fixed = |length| Method::Steps(Steps::Fixed { length });
    let controlled = |tolerance| Method::Steps(Steps::Controlled { tolerance });
    [
        Method::Layers { thickness: 2e-4 * scale },
        Method::Layers { thickness: 1e12 },
        fixed(1e-12),
        fixed(0.05 * scale),
        fixed(10.0 * scale),
        fixed(1e12),
        controlled(1e-7),
        controlled(0.1),
    ]
}

/// Laws whose indices go from one end of their range to the other between the levels 0 and `span`, or nearly.
fn laws(span: f32) -> Vec<Law<'static, f32>> {
    static UP_AND_DOWN: [f32; 5] = [9.0, 4.5, 9.0, 4.5, 9.0];
    static DOWN: [f32; 7] = [5.4, 2.2, 0.6, -0.2, -0.6, -0.8, -0.9];
    let polynomial = |constant, linear: f32, quadratic: f32| Law::Polynomial {
        constant,
        linear: linear / span,
        quadratic: quadratic / span / span,
    };
    vec![
        polynomial(-0.999_999, 0.0, 0.0),
        polynomial(999_998.0, 0.0, 0.0),
        polynomial(-0.999_99, 9.9e5, 0.0),
        polynomial(9.9e5, -9.9e5, 0.0),
        polynomial(9.9e5, -3.96e6, 3.96e6),
        polynomial(-0.999, 0.0, 9.9e5),
        Law::Exponential { far: 1.0, excess: 998.0, scale: span },
        Law::Exponential { far: 1.0, excess: 998.0, scale: 1e-12 },
        Law::Exponential { far: 0.0, excess: 999.0, scale: span * 0.08 },
        Law::Exponential { far: 1.0, excess: -0.998, scale: 1e12 },
        Law::Exponential { far: -2e17, excess: 2e17, scale: 1e12 },
        Law::Thermal { excess: 0.9, ratio: -0.998, scale: span },
        Law::Thermal { excess: 998.0, ratio: 1e11, scale: span * 0.1 },
        Law::Inversion { below: -0.998, above: 998.0, height: span * 0.5, thickness: span * 0.01 },
        Law::Inversion { below: 998.0, above: -0.998, height: span * 0.5, thickness: 1e-12 },
        Law::FishEye { index: 1e3, radius: span * 0.01 },
        Law::FishEye { index: 1e3, radius: 1e12 },
        Law::Table { spacing: span * 0.25, values: &UP_AND_DOWN },
        Law::Table { spacing: span * 0.2, values: &DOWN },
        Law::Table { spacing: 1e12, values: &DOWN },
    ]
}

#[test]
fn profiles() {
    let mut accepted = 0;
    for at in PLACES {
        for scale in SCALES {
            let place = Vec3::new(at, at, -at);
            let levels = [
                Level::Height { origin: place, up: UP },
                Level::Radius { center: place, radius: 0.0 },
                Level::Radius { center: place - UP * 1e3 * scale, radius: 1e3 * scale },
            ];
            for (level, span) in levels.into_iter().flat_map(|level| [1e-3, 1.0, 100.0].map(|span| (level, span))) {
                for law in laws(span * scale) {
                    for method in methods(scale) {
                        let profile = [Profile { level, from: 0.0, to: span * scale, law, method }];
                        let is_table = matches!(law, Law::Table { .. });
                        accepted += u32::from(assert_bent_finite(at, scale, |scene, check| {
                            let scene = scene.with_profiles(&profile);
                            // A table is not copied into another number type.
                            if is_table && scene.validate().is_ok() {
                                assert_finite_pixels(&scene);
                                return true;
                            }
                            !is_table && check(scene)
                        }));
                    }
                }
            }
        }
    }
    println!("{accepted} were accepted");
    assert!(accepted > 1000);
}

/// Levels far from 0, where the terms of a law nearly cancel out.
#[test]
fn profiles_at_high_levels() {
    let mut accepted = 0;
    for (scale, height) in
        SCALES.into_iter().flat_map(|scale| [1e2, 1e4, 1e6, 1e8].map(|height| (scale, height * scale)))
    {
        let rising = (0..60).map(|i| (0.002, 1.0 + 0.37 * i as f32, 0.0));
        let others = [(1.0, 0.5, 0.0), (1.0, 0.0, 0.5), (0.002, 0.0, 0.0), (900.0, -1e3, 100.0)];
        for (n, slope, bow) in others.into_iter().chain(rising) {
            // n² = n + slope·x + bow·x², at x = (level − height)/scale.
            let (linear, quadratic) = (slope / scale, bow / scale / scale);
            let law = Law::Polynomial {
                constant: n * n - 1.0 - linear * height + quadratic * height * height,
                linear: linear - 2.0 * quadratic * height,
                quadratic,
            };
            for method in methods(scale) {
                let level = Level::Height { origin: -UP * height, up: UP };
                let profile = [Profile { level, from: height, to: height + scale, law, method }];
                accepted +=
                    u32::from(assert_bent_finite(0.0, scale, |scene, check| check(scene.with_profiles(&profile))));
            }
        }
    }
    println!("{accepted} were accepted");
    assert!(accepted > 50);
}

#[test]
fn black_holes() {
    let mut accepted = 0;
    for at in PLACES {
        for scale in SCALES {
            for mass in [1e-9, 1e-3 * scale, 0.3 * scale, 1.4 * scale, 1e9] {
                for steps in [
                    Steps::Fixed { length: 1e-4 },
                    Steps::Fixed { length: 0.5 },
                    Steps::Controlled { tolerance: 1e-7 },
                    Steps::Controlled { tolerance: 0.1 },
                ] {
                    for near in [0.0, 0.999, 5.0] {
                        let center = Vec3::new(at, at, -at) + Vec3::new(0.2, 0.7, 3.0 * (1.0 - near)) * scale;
                        let hole = BlackHole { center, mass, steps };
                        accepted += u32::from(assert_bent_finite(at, scale, |scene, check| {
                            let glass = [
                                Object { material: Material::dielectric(1.5), ..scene.objects[0] },
                                scene.objects[1],
                                scene.objects[2],
                            ];
                            check(scene.with_objects(&glass).with_medium(Medium::VACUUM).with_black_hole(hole))
                        }));
                    }
                }
            }
        }
    }
    println!("{accepted} were accepted");
    assert!(accepted > 100);
}
