//! What the example `accuracy` finds, in small: pictures of a few pixels, with rays in place of time.
#![allow(missing_docs, dead_code, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

/// As few scenes as show all kinds of settings, so that this is soon compiled.
macro_rules! with_built_in {
    ($callback:ident($($arguments:tt)*)) => { $callback!($($arguments)* SHOWCASE BUBBLE MIRAGE) };
}

#[path = "../examples/accuracy/code.rs"]
mod code;
#[path = "../examples/accuracy/conversion.rs"]
mod conversion;
#[path = "../examples/accuracy/difference.rs"]
mod difference;
#[path = "../examples/accuracy/dispatch.rs"]
mod dispatch;
#[path = "../examples/accuracy/frontier.rs"]
mod frontier;
#[path = "../examples/accuracy/measure.rs"]
mod measure;
#[path = "../examples/accuracy/number.rs"]
mod number;
#[path = "../examples/accuracy/number_name.rs"]
mod number_name;
#[path = "../examples/accuracy/picture.rs"]
mod picture;
#[path = "../examples/accuracy/record.rs"]
mod record;
#[path = "../examples/accuracy/setting.rs"]
mod setting;
#[path = "../examples/accuracy/sweep.rs"]
mod sweep;
#[path = "../examples/accuracy/variant.rs"]
mod variant;

use frontier::{Tolerance, dominating, frontier};
use measure::{Bench, Measured, TOLERANCE};
use picture::Subject;
use record::Record;
use setting::Setting;
use sweep::Knobs;
use whit::render::{Sampling, Size};
use whit::{Rgb, Scene, Termination, scenes};

const SMALL: [(&str, Scene<'static, f32>); 3] =
    [("showcase", scenes::SHOWCASE), ("bubble", scenes::BUBBLE), ("mirage", scenes::MIRAGE)];

fn subject((name, scene): (&'static str, Scene<'static, f32>)) -> Subject {
    Subject::new(name, scene, Size::new(16, 12))
}

fn measured() -> Vec<Measured> {
    SMALL.into_iter().map(|scene| Bench::new(subject(scene)).unwrap().measure(false).unwrap()).collect()
}

fn points(measured: &Measured) -> Vec<(f64, f64)> {
    measured.records.iter().map(|record| (record.rays, record.picture.rmse)).collect()
}

/// Costs rise and errors fall along it; nothing that was tried is better in both, and everything is covered by a point of it.
fn assert_frontier(points: &[(f64, f64)], frontier: &[usize], tolerance: Tolerance) {
    assert!(!frontier.is_empty());
    for pair in frontier.windows(2) {
        let ((cost, error), (next_cost, next_error)) = (points[pair[0]], points[pair[1]]);
        assert!(next_cost > cost && next_error < error, "{:?} {:?}", points[pair[0]], points[pair[1]]);
    }
    let (more_cost, more_error) = (1.0 + tolerance.cost, 1.0 + tolerance.error);
    for &place in frontier {
        let (cost, error) = points[place];
        let better = |&&(c, e): &&(f64, f64)| c * more_cost < cost && e * more_error < error;
        assert_eq!(points.iter().find(better), None, "{:?}", points[place]);
    }
    for &(cost, error) in points {
        let covers = |&&place: &&usize| points[place].0 <= cost * more_cost && points[place].1 <= error * more_error;
        assert!(frontier.iter().any(|place| covers(&place)), "{cost} {error}");
    }
}

#[test]
fn small_report() {
    let measured = measured();
    for measured in &measured {
        let points = points(measured);
        let frontier = frontier(&points, TOLERANCE);
        assert_frontier(&points, &frontier, TOLERANCE);
        default_is_worth_its_rays(measured);
        more_depth_is_less_error(measured);
    }
    records_are_read_as_they_were_written(&measured);
}

/// The default is on the frontier, to a tenth of its rays: in its number type, no setting of so many fewer has light that is no
/// worse.
fn default_is_worth_its_rays(measured: &Measured) {
    let default = &measured.records[0];
    assert_eq!(default.setting, Setting::DEFAULT);
    let light = |record: &&Record| record.light.is_some() && record.setting.number == Setting::DEFAULT.number;
    let records: Vec<&Record> = measured.records.iter().filter(light).collect();
    let points: Vec<_> = records.iter().map(|record| (record.rays, record.light.unwrap().rmse)).collect();
    let better = dominating(&points, (default.rays / 1.1, default.light.unwrap().rmse), TOLERANCE);
    assert_eq!(better.map(|place| records[place].setting.to_string()), None, "{}", measured.name);
}

fn more_depth_is_less_error(measured: &Measured) {
    let at = |depth| Setting { depth, ..Setting::DEFAULT };
    let light = |depth| {
        let record = measured.records.iter().find(|record| record.setting == at(depth))?;
        Some(record.light?.rmse)
    };
    if let (Some(least), Some(most)) = (light(0), light(8)) {
        assert!(most < 0.5 * least, "{}: {least} {most}", measured.name);
    }
}

fn records_are_read_as_they_were_written(measured: &[Measured]) {
    let mut records: Vec<_> = measured.iter().flat_map(|measured| measured.records.clone()).collect();
    records[1].costs.insert("instructions_m4f".to_owned(), 1234.0);
    records[2].time = Some(1.5);
    let file = tempfile::Builder::new().suffix(".csv").tempfile().unwrap();
    record::write(file.path(), &records).unwrap();
    let mut read = record::read(file.path()).unwrap();
    assert_eq!(read.len(), records.len());
    for (read, written) in read.iter().zip(&records) {
        assert_eq!((&read.scene, read.setting), (&written.scene, written.setting));
        assert_eq!((&read.costs, read.time), (&written.costs, written.time));
        assert_eq!(read.light.is_some(), written.light.is_some());
        assert!((read.picture.rmse - written.picture.rmse).abs() <= 1e-3 * written.picture.rmse);
    }
    read[1].costs.clear();
    record::keep_costs(&mut read, &records);
    assert_eq!(read[1].costs, records[1].costs);
}

#[test]
fn settings_are_read_as_they_are_written() {
    let mut settings = vec![
        Setting { termination: Termination::Color(Rgb::new(0.1, 0.25, 1.0)), ..Setting::DEFAULT },
        Setting { sampling: Sampling::Adaptive { first: 3, most: 77, contrast: 0.3 }, ..Setting::DEFAULT },
        Setting { cutoff: 0.003, ..Setting::DEFAULT },
    ];
    for scene in SMALL {
        settings.extend(Knobs::alone(&subject(scene)).each());
        settings.extend(Knobs::together(&subject(scene)).product());
    }
    for setting in settings {
        assert_eq!(setting.to_string().parse(), Ok(setting), "{setting}");
        assert_eq!(setting.other_than(&Setting::DEFAULT).parse::<Setting>().unwrap_or(Setting::DEFAULT), setting);
    }
    assert_eq!(Setting::DEFAULT.to_string(), "f32 exact depth=8 cutoff=1/255 termination=background samples=1");
    assert!("f32 depth=x".parse::<Setting>().unwrap_err().contains('x'));
    assert!("f16".parse::<Setting>().unwrap_err().contains("f32"));
}

/// Lets the compiler see some code, and has its text.
macro_rules! with_text {
    ($text:ident: $($code:tt)*) => {
        let $text = stringify!($($code)*);
        $($code)*
    };
}

fn assert_code(text: &str, setting: &str, scene: &str) {
    let without_spaces = |text: &str| text.split_whitespace().collect::<String>();
    assert_eq!(without_spaces(&code::of(&setting.parse().unwrap(), scene)), without_spaces(text));
}

#[test]
fn code_to_paste_compiles() -> Result<(), Box<dyn std::error::Error>> {
    use whit::scene::Offset;
    use whit::{Budget, Effects, Frame, Fresnel, Real, SceneBuf, Settings, Tracer};

    let (width, height) = (8, 6);
    with_text! { text:
        const SCENE: Scene<'static, f32> = scenes::DEEP.with_fresnel(Fresnel::Schlick).with_offset(Offset::Fixed(0.001));
        let tracer = whit::tracer!(SCENE, 3);
        let budget = Budget { cutoff: 0.25, termination: Termination::Black, ..Budget::with_depth(3) };
        let settings = Settings { budget, sampling: Sampling::Grid(2), ..Settings::new(width, height) };
    }
    Frame::new(&tracer, settings)?;
    assert_code(text, "f32 schlick depth=3 cutoff=1/4 termination=black samples=2x2 offset=0.001", "deep");
    with_text! { text:
        const EFFECTS: Effects = scenes::SHOWCASE.effects().with(Effects::SPHERE).with(Effects::TRIANGLE);
        let copy = SceneBuf::<whit::math::Q16, 128, 8, 4>::from_scene(&scenes::SHOWCASE, whit::math::Q16::from_f32)?;
        let copy = copy.as_scene();
        let tracer = Tracer::<whit::math::Q16, { EFFECTS.bits() }, { scenes::SHOWCASE.stack(5) },
            { scenes::SHOWCASE.media() }>::try_new(&copy)?;
        let budget = Budget { cutoff: whit::math::Q16::from_f32(0.25), ..Budget::with_depth(5) };
        let settings = Settings { budget, sampling: Sampling::Adaptive {
            first: 4, most: 16, contrast: whit::math::Q16::from_f32(0.0625) }, ..Settings::new(width, height) };
    }
    Frame::new(&tracer, settings)?;
    assert_code(text, "q16 exact depth=5 cutoff=1/4 samples=4..16@1/16", "showcase");
    Ok(())
}

#[test]
fn frontiers_of_random_points() {
    let mut random = fastrand::Rng::with_seed(7);
    for _ in 0..200 {
        let count = random.usize(1..60);
        let points: Vec<_> = (0..count).map(|_| (random.f64() + 0.01, random.f64() + 0.001)).collect();
        for tolerance in [Tolerance { cost: 0.0, error: 0.0 }, TOLERANCE, Tolerance { cost: 0.2, error: 0.3 }] {
            let frontier = frontier(&points, tolerance);
            assert!(!frontier.is_empty());
            for &(cost, error) in &points {
                let covered = frontier.iter().any(|&place| {
                    points[place].0 <= cost * (1.0 + tolerance.cost)
                        && points[place].1 <= error * (1.0 + tolerance.error).powi(2)
                });
                assert!(covered, "{cost} {error} {tolerance:?}");
            }
        }
        assert_frontier(
            &points,
            &frontier(&points, Tolerance { cost: 0.0, error: 0.0 }),
            Tolerance { cost: 0.0, error: 0.0 },
        );
    }
}

#[test]
fn triangles_stay_lists_in_other_number_types() {
    for (name, scene) in scenes::ALL {
        let copy = conversion::converted::<f64>(&scene).unwrap();
        let effects = |effects: whit::Effects| effects.without(whit::Effects::SPHERES).without(whit::Effects::SPHERE);
        assert_eq!(effects(copy.effects()), effects(scene.effects()), "{name}");
        assert_eq!(copy.media(), scene.media(), "{name}");
    }
}
