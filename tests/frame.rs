//! Frames: the same bits however they are cut into steps, rows, orders and workers; budgets and their counts.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

#[path = "support/bent.rs"]
mod bent;
#[path = "support/framebuffers.rs"]
mod framebuffers;

use framebuffers::{Counting, Failing, Failure};
use whit::render::{LinearRgb, Order, Progress, RenderError, Sampling, SettingsError, Size};
use whit::scene::ShadowRays;
use whit::trace::{Budget, Dropped, Termination};
use whit::{Effects, Frame, Medium, Rgb, Scene, Settings, Stats, Tracer, scenes};

const WIDTH: u32 = 40;
const HEIGHT: u32 = 30;
const ALL: u64 = Effects::ALL.bits();

fn settings() -> Settings<f32> {
    Settings::new(WIDTH, HEIGHT)
}

/// Renders with a function that drives the frame.
fn picture(
    scene: &Scene<'_, f32>,
    settings: Settings<f32>,
    drive: impl Fn(&mut Frame<'_, f32, ALL, 16, Stats, 8>, &mut LinearRgb<'_>),
) -> (Vec<Rgb<f32>>, Stats) {
    let mut pixels = vec![Rgb::grey(-1.0); settings.size.pixels() as usize];
    let mut target = LinearRgb::new(settings.size, &mut pixels).unwrap();
    let tracer = Tracer::try_new(scene).unwrap();
    let mut frame = Frame::observed(&tracer, settings, Stats::default()).unwrap();
    drive(&mut frame, &mut target);
    let stats = *frame.observer();
    (pixels, stats)
}

fn whole(scene: &Scene<'_, f32>, settings: Settings<f32>) -> (Vec<Rgb<f32>>, Stats) {
    picture(scene, settings, |frame, target| frame.render(target).unwrap())
}

fn bits(pixels: &[Rgb<f32>]) -> Vec<[u32; 3]> {
    pixels.iter().map(|color| [color.r.to_bits(), color.g.to_bits(), color.b.to_bits()]).collect()
}

#[test]
fn steps_do_not_change_a_bit() {
    for (name, scene) in scenes::ALL {
        for sampling in [Sampling::Grid(1), Sampling::Sequence(3)] {
            let settings = settings().with_sampling(sampling);
            let (expected, counted) = whole(&scene, settings.clone());
            for rays in [1, 2, 7, 1000] {
                let (stepped, stats) =
                    picture(
                        &scene,
                        settings.clone(),
                        |frame, target| {
                            while frame.step(rays, target).unwrap() == Progress::More {}
                        },
                    );
                assert_eq!(bits(&stepped), bits(&expected), "{name} by {rays}");
                assert_eq!(stats, counted, "{name} by {rays}");
            }
        }
    }
}

/// The steps of bent rays count as rays do; where the walk stops changes nothing.
#[test]
fn steps_do_not_change_a_bit_where_light_is_bent() {
    for (name, scene) in bent::scenes() {
        let settings = Settings::new(16, 12).with_sampling(Sampling::Sequence(2)).with_depth(4);
        let (expected, counted) = whole(&scene, settings.clone());
        assert!(counted.steps > counted.rays());
        for rays in [1, 7, 100, 20_000] {
            let (stepped, stats) =
                picture(
                    &scene,
                    settings.clone(),
                    |frame, target| while frame.step(rays, target).unwrap() == Progress::More {},
                );
            assert_eq!(bits(&stepped), bits(&expected), "{name} by {rays}");
            assert_eq!(stats, counted, "{name} by {rays}");
        }
    }
}

/// A step goes over the rays that it is given by no more than what one ray takes, to a surface or to a light.
#[test]
fn a_step_goes_over_by_the_steps_of_one_ray_at_most() {
    for (name, scene) in bent::scenes() {
        for (rays, steps_per_ray) in [(1, 3), (50, 40), (300, 500)] {
            let budget = Budget { steps_per_ray, ..Budget::with_depth(4) };
            let (_, stats) = picture(&scene, Settings { budget, ..Settings::new(16, 12) }, |frame, target| {
                let work = |stats: &Stats| stats.rays() + stats.steps;
                let mut before = 0;
                while frame.step(rays, target).unwrap() == Progress::More {
                    let now = work(frame.observer());
                    let most = u64::from(rays) + u64::from(steps_per_ray);
                    assert!(now > before && now - before <= most, "{name}: {} and not {most}", now - before);
                    before = now;
                }
            });
            assert!(stats.steps > 0);
        }
    }
}

/// A bent ray that takes all of its steps is cut: it is counted, and takes the termination colour.
#[test]
fn steps_per_ray_are_kept() {
    let render = |scene: &Scene<'_, f32>, steps_per_ray, termination| {
        let budget = Budget { steps_per_ray, termination, ..Budget::with_depth(4) };
        whole(scene, Settings { budget, ..Settings::new(16, 12) })
    };
    let color = Rgb::new(0.25, 0.5, 0.75);
    for (name, scene) in bent::scenes() {
        // With no steps at all, the eye rays are cut before they have turned.
        for (termination, expected) in [(Termination::Black, Rgb::BLACK), (Termination::Color(color), color)] {
            let (pixels, stats) = render(&scene, 0, termination);
            assert!(pixels.iter().all(|pixel| *pixel == expected), "{name}");
            assert_eq!((stats.steps, stats.cut_by_steps, stats.rays()), (0, 192, 192), "{name}");
        }
        let (pixels, _) = render(&scene, 0, Termination::Background);
        let empty = Scene { objects: &[], profiles: &[], black_hole: None, medium: Medium::VACUUM, ..scene };
        let straight = whole(&empty, Settings::new(16, 12)).0;
        assert!(
            pixels.iter().zip(&straight).all(|(a, b)| (a.r - b.r).abs() < 1e-5 && (a.b - b.b).abs() < 1e-5),
            "{name}"
        );

        let full = render(&scene, 10_000, Termination::Black).1;
        let few = render(&scene, 4, Termination::Black).1;
        assert!(few.cut_by_steps > full.cut_by_steps && few.steps < full.steps, "{name}: {few:?}");
        let surfaces = few.rays() - few.shadow;
        assert!(few.steps <= 4 * surfaces * (1 + scene.lights.len() as u64), "{name}: {few:?}");
    }
}

/// The steps of shadow rays are counted as well, also where the light is not seen.
#[test]
fn steps_to_lights_are_counted() {
    for (name, scene) in bent::scenes() {
        let settings = Settings::new(16, 12).with_depth(0);
        let straight = Scene { shadow_rays: ShadowRays::Straight, ..scene };
        let (with, without) =
            (whole(&scene.with_bent_shadows(), settings.clone()).1, whole(&straight, settings.clone()).1);
        let dark = Scene { lights: &[], ..scene };
        assert!(with.steps > without.steps, "{name}: {with:?}");
        assert_eq!(whole(&dark, settings).1.steps, without.steps, "{name}");
    }
}

/// Each step traces exactly as many rays as it was given, but for the last.
#[test]
fn a_step_keeps_to_its_rays() {
    let (_, stats) = picture(&scenes::SHOWCASE, settings(), |frame, target| {
        let mut steps = 0;
        while frame.step(5, target).unwrap() == Progress::More {
            steps += 1;
            assert_eq!(frame.observer().rays(), 5 * steps);
        }
    });
    assert!(stats.rays() > 1000);
}

#[test]
fn rows_orders_and_workers_do_not_change_a_bit() {
    let adaptive = Sampling::Adaptive { first: 2, most: 6, contrast: 0.05 };
    for sampling in [Sampling::Grid(2), Sampling::Sequence(4), adaptive] {
        let settings = settings().with_sampling(sampling);
        let (expected, _) = whole(&scenes::CARD, settings.clone());
        let coarse = Settings { order: Order::CoarseToFine, ..settings.clone() };
        assert_eq!(bits(&whole(&scenes::CARD, coarse).0), bits(&expected));
        let rows = |y: u32| {
            let settings = Settings { rows: y..(y + 7).min(HEIGHT), ..settings.clone() };
            std::thread::spawn(move || whole(&scenes::CARD, settings).0)
        };
        let workers: Vec<_> = (0..HEIGHT).step_by(7).rev().map(|y| (y as usize, rows(y))).collect();
        for (y, worker) in workers {
            let part = worker.join().unwrap();
            let range = y * WIDTH as usize..((y + 7) * WIDTH as usize).min(expected.len());
            assert_eq!(bits(&part[range.clone()]), bits(&expected[range.clone()]));
            assert!(part[..range.start].iter().all(|color| color.r == -1.0), "other rows are left alone");
        }
    }
}

#[test]
fn every_pixel_is_put_once_and_every_row_ended() {
    for (order, ends) in [(Order::Rows, 1), (Order::CoarseToFine, 0)] {
        let mut pixels = vec![Rgb::BLACK; settings().size.pixels() as usize];
        let mut target = Counting::new(LinearRgb::new(settings().size, &mut pixels).unwrap());
        let tracer = whit::tracer!(scenes::SHOWCASE);
        Frame::new(&tracer, Settings { order, ..settings() }).unwrap().render(&mut target).unwrap();
        assert!(target.pixels.iter().all(|&n| n == 1));
        assert!(target.rows.iter().all(|&n| n >= 1 && (ends == 0 || n == ends)));
    }
}

/// An error of the target at any call stops the frame there, is returned, and the frame goes on as if it had not been.
#[test]
fn a_failing_target_loses_nothing() {
    let size = Size::new(9, 4);
    let settings = || Settings { order: Order::CoarseToFine, ..Settings::new(size.width, size.height) };
    let (expected, stats) = {
        let mut pixels = [Rgb::BLACK; 36];
        let tracer = whit::tracer!(scenes::SPHERES);
        let mut frame = Frame::observed(&tracer, settings(), Stats::default()).unwrap();
        frame.render(&mut LinearRgb::new(size, &mut pixels).unwrap()).unwrap();
        (pixels, *frame.observer())
    };
    for call in 0..50 {
        let mut pixels = [Rgb::BLACK; 36];
        let tracer = whit::tracer!(scenes::SPHERES);
        let mut target = Failing::new(Counting::new(LinearRgb::new(size, &mut pixels).unwrap()), call);
        let mut frame = Frame::observed(&tracer, settings(), Stats::default()).unwrap();
        let failed = frame.render(&mut target);
        if target.calls() > call {
            assert_eq!(failed, Err(RenderError::Framebuffer(Failure::Planned)), "call {call}");
        }
        frame.render(&mut target).unwrap();
        assert!(target.inner.pixels.iter().all(|&n| n == 1), "call {call}");
        assert_eq!(pixels, expected, "call {call}");
        assert_eq!(*frame.observer(), stats, "call {call}: no ray is traced twice");
    }
}

#[test]
fn wrong_sizes_and_settings_are_named() {
    let tracer = whit::tracer!(scenes::SPHERES, 3);
    let refused = |settings| Frame::new(&tracer, settings).map(|_| ()).unwrap_err().to_string();
    assert_eq!(refused(Settings::new(0, 5)), "a picture of 0×5: expected 1 to 1048576 pixels a side");
    assert_eq!(refused(settings().with_depth(4)), "depth 4: the tracer's stack has room for 3");
    let rows = Settings { rows: 5..31, ..settings().with_depth(3) };
    assert_eq!(refused(rows), "rows 5..31: expected one row or more within 0..30");
    assert_eq!(
        refused(settings().with_depth(3).with_sampling(Sampling::Grid(0))),
        "samples: expected at least 1 a pixel"
    );
    let cutoff = Budget { cutoff: f32::NAN, ..Budget::with_depth(3) };
    let settings_with = |budget| Settings { budget, ..settings() };
    assert_eq!(refused(settings_with(cutoff)), "cutoff: expected a finite number of at least 0");
    let black = Budget { termination: Termination::Color(Rgb::new(0.0, f32::INFINITY, 0.0)), ..Budget::with_depth(3) };
    assert_eq!(Frame::new(&tracer, settings_with(black)).map(|_| ()), Err(SettingsError::NotAnAmount("termination")));

    let mut pixels = [Rgb::BLACK; 12];
    let mut small = LinearRgb::new(Size::new(4, 3), &mut pixels).unwrap();
    let error = Frame::new(&tracer, settings().with_depth(3)).unwrap().render(&mut small).unwrap_err();
    assert_eq!(error.to_string(), "the framebuffer has 4×3 pixels and the frame 40×30");
}

#[test]
fn depth_zero_is_eye_rays_alone() {
    let (_, stats) = whole(&scenes::SHOWCASE, settings().with_depth(0));
    assert_eq!((stats.eye, stats.reflected, stats.transmitted), (u64::from(WIDTH * HEIGHT), 0, 0));
    assert!(stats.cut_by_depth > 0 && stats.shadow > 0);
}

/// A pixel never takes more rays than its budget, shadow rays included, whatever the number of samples.
#[test]
fn rays_per_pixel_are_kept() {
    for rays_per_pixel in [0, 1, 3, 7, 20, 100] {
        for samples in [1, 3] {
            let budget = Budget { rays_per_pixel, ..Budget::with_depth(8) };
            let one_pixel = |x| Settings { budget, ..Settings::new(x, 1) }.with_sampling(Sampling::Sequence(samples));
            for width in 1..12 {
                let (pixels, stats) = whole(&scenes::SHOWCASE, one_pixel(width));
                assert!(stats.rays() <= u64::from(rays_per_pixel * width), "{stats:?}");
                assert!(pixels.iter().all(|color| color.max_channel().is_finite()));
            }
        }
    }
    let budget = Budget { rays_per_pixel: 7, ..Budget::with_depth(8) };
    let (_, stats) = whole(&scenes::SHOWCASE, Settings { budget, ..settings() });
    assert!(stats.cut_by_budget > 100, "{stats:?}");
}

/// With nothing but mirrors, what is seen and what was cut weigh 1 together: here everything but the cut is black.
#[test]
fn the_dropped_throughput_is_what_the_termination_shows() {
    let mut scene = scenes::MIRRORS;
    scene.background = whit::Background::Solid(Rgb::BLACK);
    scene.lights = &[];
    let objects: Vec<_> = scene
        .objects
        .iter()
        .map(|object| {
            let mut object = *object;
            if let Some(body) = &mut object.material.body {
                body.emission = 0.0;
            }
            object
        })
        .collect();
    scene.objects = &objects;
    for sampling in [Sampling::Grid(1), Sampling::Sequence(4)] {
        let budget = Budget { termination: Termination::Color(Rgb::WHITE), cutoff: 0.5, ..Budget::with_depth(4) };
        let settings = Settings { budget, ..settings() }.with_sampling(sampling);
        let mut pixels = vec![Rgb::BLACK; settings.size.pixels() as usize];
        let mut dropped = pixels.clone();
        let tracer = Tracer::<f32, ALL, 4>::try_new(&scene).unwrap();
        let keep = Dropped::new(|x, y, weight| dropped[(y * WIDTH + x) as usize] = weight);
        let mut target = LinearRgb::new(settings.size, &mut pixels).unwrap();
        Frame::observed(&tracer, settings, keep).unwrap().render(&mut target).unwrap();
        assert!(dropped.iter().any(|color| color.r > 0.0));
        for (shown, dropped) in pixels.iter().zip(&dropped) {
            assert!((shown.r - dropped.r).abs() < 1e-6 && (shown.b - dropped.b).abs() < 1e-6);
        }
    }
}

/// Contrast above the threshold takes all samples, and a flat pixel only the first ones.
#[test]
fn adaptive_samples_go_where_the_contrast_is() {
    let (_, stats) =
        whole(&scenes::SPHERES, settings().with_sampling(Sampling::Adaptive { first: 4, most: 16, contrast: 0.1 }));
    let pixels = u64::from(WIDTH * HEIGHT);
    assert!(stats.eye > 4 * pixels && stats.eye < 12 * pixels, "{stats:?}");
    let flat = Sampling::Adaptive { first: 4, most: 16, contrast: 1e9 };
    assert_eq!(whole(&scenes::SPHERES, settings().with_sampling(flat)).1.eye, 4 * pixels);
}

/// A constant interface without k_r reflects nothing but what is reflected totally.
#[test]
fn branches_without_weight_are_not_spawned() {
    use whit::{Interface, Material, Object, Shape, Vec3};
    let clear = Interface::Constant { reflected: Rgb::BLACK, transmitted: Rgb::WHITE, medium: Medium::new(1.5) };
    let ball = Shape::sphere(Vec3::new(0.0, 0.9, 0.4), 0.9);
    let objects = [Object::new(ball, Material::dielectric(1.5).with_interface(clear))];
    let (_, stats) = whole(&scenes::SPHERES.with_objects(&objects), settings());
    assert!(stats.transmitted > 100 && stats.reflected == stats.total_internal, "{stats:?}");
}

/// A whole frame onto a display that panics when a pixel is drawn twice or outside.
#[cfg(feature = "embedded-graphics")]
#[test]
fn a_display_is_drawn_once_pixel_by_pixel() {
    use embedded_graphics::mock_display::MockDisplay;
    use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
    use embedded_graphics::prelude::Point;
    use whit::render::{DrawTargetLines, Encoding, Rgb888 as Bytes};
    let size = Size::new(64, 64);
    let tracer = whit::tracer!(scenes::SHOWCASE);
    let mut display = MockDisplay::<Rgb888>::new();
    let mut line = [Rgb888::BLACK; 64];
    let mut target = DrawTargetLines::new(&mut display, size, &mut line, Encoding::Srgb).unwrap();
    Frame::new(&tracer, Settings::new(64, 64)).unwrap().render(&mut target).unwrap();
    let mut bytes = vec![0; 64 * 64 * 3];
    let mut target = Bytes::new(size, &mut bytes, Encoding::Srgb).unwrap();
    Frame::new(&tracer, Settings::new(64, 64)).unwrap().render(&mut target).unwrap();
    for (i, expected) in bytes.chunks_exact(3).enumerate() {
        let color = display.get_pixel(Point::new(i as i32 % 64, i as i32 / 64)).unwrap();
        assert_eq!([color.r(), color.g(), color.b()], expected);
    }
}

/// Lights at the limit of what validation accepts overflow on the way; the pixels do not.
#[test]
fn huge_lights_stay_finite() {
    use whit::scene::Falloff;
    use whit::{Light, SceneBuf};
    fn brightest<T: whit::Real>(convert: impl Fn(f32) -> T + Copy) -> f32 {
        let falloff = Falloff { constant: 1e-12, linear: 0.0, quadratic: 0.0 };
        let lights = [Light::point(scenes::SPHERES.camera.eye, Rgb::new(1e12, 0.0, 1e12)).with_falloff(falloff)];
        let buffer = SceneBuf::<T, 8, 1>::from_scene(&scenes::SPHERES.with_lights(&lights), convert).unwrap();
        let scene = buffer.as_scene();
        let tracer = Tracer::<T, ALL, 8>::try_new(&scene).unwrap();
        let mut pixels = vec![Rgb::BLACK; 40 * 30];
        let mut target = LinearRgb::new(Size::new(40, 30), &mut pixels).unwrap();
        let settings = Settings::new(40, 30).with_sampling(Sampling::Sequence(4));
        Frame::new(&tracer, settings).unwrap().render(&mut target).unwrap();
        assert!(pixels.iter().all(|c| c.r.is_finite() && c.g.is_finite() && c.b.is_finite()));
        pixels.iter().fold(0.0, |brightest, color| color.max_channel().max(brightest))
    }
    assert!(brightest(|x| x) > 1e20 && brightest(f64::from) > 1e20);
}
