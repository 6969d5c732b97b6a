//! What the page measures: media and holes, the paths through them, and how far off a path is.

use std::f64::consts::TAU;

use whit::scene::Profile;

use crate::exact::deflection::deflection;
use crate::exact::{glass, mirage};
use crate::way::{Kind, Way};
use crate::world::{Bend, End, Start, Target, World};

/// A path, and how far off its end is.
pub struct Case {
    pub world: World<'static>,
    pub start: Start,
    pub error: Error,
}

/// How far off an end is; `None` where it is at something else.
type Error = Box<dyn Fn(&End) -> Option<f64>>;

/// A medium or a hole.
pub struct System {
    pub title: &'static str,
    pub about: String,
    /// How the file of its picture is called.
    pub name: &'static str,
    pub ways: Vec<Way>,
    pub cases: fn(Way) -> Vec<Case>,
}

fn ways(controlled: &[f64], fixed: &[f64], layers: &[f64]) -> Vec<Way> {
    let of = |kind, steps: &[f64]| steps.iter().map(|&step| Way { kind, step }).collect::<Vec<_>>();
    [of(Kind::Controlled, controlled), of(Kind::Fixed, fixed), of(Kind::Layers, layers)].concat()
}

const TOLERANCES: [f64; 6] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7];

/// All of them.
pub fn all() -> Vec<System> {
    let lengths = [0.1, 0.05, 0.02, 0.01, 0.005, 0.002];
    let shares = [0.2, 0.1, 0.05, 0.02, 0.01, 0.005];
    vec![
        System {
            title: "A mirage",
            about: about_road(),
            name: "mirage",
            ways: ways(&TOLERANCES[1..], &[4.0, 2.0, 1.0, 0.5, 0.2], &[4e-3, 1e-3, 2.5e-4, 6e-5]),
            cases: road,
        },
        System {
            title: "A lens",
            about: "Luneburg's, n² = 2 − r² inside of the radius 1, which brings parallel light to a point of its rim. Light comes \
                    at heights from 0 to 0.99 over the axis. The error is the distance from that point.".to_owned(),
            name: "lens",
            ways: ways(&TOLERANCES, &lengths, &[0.05, 0.02, 0.005, 1e-3, 2e-4]),
            cases: lens,
        },
        System {
            title: "An atmosphere",
            about: "Air whose index falls off with height as n = e^(−y), much faster than any real one's. Light starts at the height \
                    0, 15° to 75° upwards, and is bent down again. The error is that of its height, three quarters of the way \
                    to where it is back at 0.".to_owned(),
            name: "atmosphere",
            ways: ways(&TOLERANCES, &lengths, &[0.05, 0.02, 0.005, 1e-3, 2e-4]),
            cases: atmosphere,
        },
        System {
            title: "A black hole, from near",
            about: "Light with the impact parameters 5.25, 5.5, 6 and 8 times the mass (below 3√3 it is captured), from a million \
                    times the mass away. The error is that of its last direction, in radians; exact are elliptic integrals. \
                    Lengths of steps are shares of the distance from the hole.".to_owned(),
            name: "hole",
            ways: ways(&TOLERANCES, &shares, &[]),
            cases: |way| hole(way, &[5.25, 5.5, 6.0, 8.0]),
        },
        System {
            title: "A black hole, from far",
            about: "The same with impact parameters of 20, 100 and 1000 times the mass: most pixels of a picture with a hole in it.".to_owned(),
            name: "weak",
            ways: ways(&TOLERANCES, &shares, &[]),
            cases: |way| hole(way, &[20.0, 100.0, 1000.0]),
        },
    ]
}

fn about_road() -> String {
    let turn =
        |angle: Option<&f64>| angle.and_then(|&angle| mirage::turning(EYE, angle)).map_or(f64::NAN, |turn| turn.1);
    let (first, last) = (MIRAGE_ANGLES.first(), MIRAGE_ANGLES.last());
    format!(
        "Air of 300 K over a road 30 K hotter, n = 1 + 0.0789 K/T with T = 300 K + 30 K·e^(−y/2 cm), up to {} m. Light starts \
         {EYE} m above the road, {} to {} thousandths of a radian downwards, turns above the road after {:.0} to {:.0} m and is \
         back at that height after twice as many. The error is that of the height there, in metres; exact is a quadrature. \
         Lengths are in metres.",
        mirage::TOP,
        first.map_or(f64::NAN, |angle| 1e3 * angle),
        last.map_or(f64::NAN, |angle| 1e3 * angle),
        turn(first),
        turn(last),
    )
}

/// A wall across the x axis.
pub fn wall(x: f64) -> Target {
    Target::Plane { point: [x, 0.0, 0.0], normal: [-1.0, 0.0, 0.0] }
}

/// In the plane z = 0, at an angle above the x axis.
pub fn start(x: f64, y: f64, angle: f64) -> Start {
    Start { origin: [x, y, 0.0], direction: [angle.cos(), angle.sin(), 0.0] }
}

/// A path that ends at a wall, at a known height.
fn to_wall(profile: Profile<'static, f64>, start: Start, x: f64, height: f64) -> Case {
    let world = World { bend: Bend::Medium(profile), targets: vec![wall(x)] };
    let error = move |end: &End| match end {
        End::Surface { object: 0, point, .. } => Some((point[1] - height).abs().max(point[2].abs())),
        _ => None,
    };
    Case { world, start, error: Box::new(error) }
}

/// The angles at which light over the road turns.
pub const MIRAGE_ANGLES: [f64; 8] = [1e-3, 2e-3, 3e-3, 4e-3, 5e-3, 6e-3, 6.5e-3, 6.8e-3];

/// The height of the eye over the road.
pub const EYE: f64 = 1.5;

fn road(way: Way) -> Vec<Case> {
    let paths = MIRAGE_ANGLES.iter().filter_map(|&angle| Some((angle, mirage::turning(EYE, angle)?)));
    paths
        .map(|(angle, (_, away))| {
            let mut case = to_wall(mirage::air(way.method()), start(0.0, EYE, -angle), 2.0 * away, EYE);
            case.world.targets.push(Target::Plane { point: [0.0; 3], normal: [0.0, 1.0, 0.0] });
            case
        })
        .collect()
}

fn lens(way: Way) -> Vec<Case> {
    let heights = [0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99];
    heights.map(|h| to_wall(glass::luneburg(way.method()), start(-2.0, h, 0.0), 1.0, 0.0)).into()
}

fn atmosphere(way: Way) -> Vec<Case> {
    let path = |degrees: f64| {
        let angle = degrees.to_radians();
        let x = 1.5 * angle;
        let height = glass::exponential_height(angle, x);
        to_wall(glass::exponential(way.method()), start(0.0, 0.0, angle), x, height)
    };
    [15.0, 30.0, 45.0, 60.0, 75.0].map(path).into()
}

fn hole(way: Way, impact_parameters: &[f64]) -> Vec<Case> {
    let path = |&b: &f64| {
        let exact = deflection(b);
        let error = move |end: &End| {
            let &End::Away([x, y, _]) = end else { return None };
            let error = (-y).atan2(x) - exact;
            Some((error - (error / TAU).round() * TAU).abs())
        };
        let world = World { bend: Bend::Hole { mass: 1.0, steps: way.steps() }, targets: vec![] };
        Case { world, start: start(-1e6, b, 0.0), error: Box::new(error) }
    };
    impact_parameters.iter().map(path).collect()
}
