//! Drawings of paths as the library follows them, and of what they cost.

use std::f64::consts::TAU;
use std::path::Path;

use whit::scene::{Method, Steps};

use crate::exact::deflection::CRITICAL;
use crate::exact::mirage::air;
use crate::page::Section;
use crate::plot::{Plot, Scale};
use crate::systems::{EYE, MIRAGE_ANGLES, start, wall};
use crate::way::Kind;
use crate::world::{Bend, ENOUGH, End, Start, Target, World};

const COLORS: [(Kind, &str); 3] = [(Kind::Controlled, "#0b6"), (Kind::Fixed, "#36c"), (Kind::Layers, "#c60")];

/// Writes all of them into a folder.
pub fn write(folder: &Path, sections: &[Section]) -> Result<(), String> {
    std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    hole(&folder.join("hole.svg"))?;
    mirage(&folder.join("mirage.svg"), 0.16)?;
    sections.iter().try_for_each(|section| cost(folder, section))
}

/// Error over evaluations.
fn cost(folder: &Path, Section { system, rows }: &Section) -> Result<(), String> {
    let points = |kind| {
        let rows = rows.iter().filter(move |row| row.way.kind == kind);
        let points = rows.filter_map(|row| Some((row.evaluations_per_path(), row.error.filter(|error| *error > 0.0)?)));
        points.collect::<Vec<_>>()
    };
    let all = COLORS.map(|(kind, color)| (color, points(kind)));
    let both = || all.iter().flat_map(|(_, points)| points);
    let (x, y) = (Scale::around(both().map(|point| point.0)), Scale::around(both().map(|point| point.1)));
    let mut plot = Plot::new(x, y, "evaluations a path", "error");
    for (color, points) in &all {
        plot.curve(points.iter().copied(), color, false);
        points.iter().for_each(|&(x, y)| plot.dot(x, y, color));
    }
    let named = COLORS.iter().filter(|(kind, _)| !points(*kind).is_empty());
    let names: Vec<_> = named.map(|&(kind, color)| (kind.name().trim_matches('`'), color)).collect();
    plot.legend(&names);
    plot.write(&folder.join(format!("cost-{}.svg", system.name)))
}

/// Light that comes from the left, with the hole in the middle of the picture.
fn hole(path: &Path) -> Result<(), String> {
    let (x, y) = (Scale::new(-16.0, 16.0), Scale::new(-8.0, 8.0));
    let mut plot = Plot::new(x, y, "x / mass", "y / mass");
    let circle = |radius: f64| {
        (0..=180).map(move |i| (TAU * f64::from(i) / 180.0).sin_cos()).map(move |(s, c)| (radius * c, radius * s))
    };
    for half in 0..=20 {
        let b = f64::from(half) * 0.5;
        let color = if b < CRITICAL { "#c33" } else { "#36c" };
        plot.curve(hops(&start(-100.0, b, 0.0), &start(-18.0, b, 0.0)), color, false);
    }
    for side in [-1.0, 1.0] {
        plot.curve([(-16.0, side * CRITICAL), (16.0, side * CRITICAL)], "#999", true);
    }
    plot.curve(circle(3.0), "#999", true);
    plot.area(circle(2.0), "black");
    plot.write(path)
}

/// Points of a path that starts so, from near another place on; found by letting the path meet small balls around it.
fn hops(far: &Start, near: &Start) -> Vec<(f64, f64)> {
    let steps = Steps::Controlled { tolerance: 1e-6 };
    let bend = Bend::Hole { mass: 1.0, steps };
    let to = |target, from: &Start| World { bend, targets: vec![target] }.follow::<f64>(from, ENOUGH);
    let mut points = Vec::new();
    let mut end = to(wall(near.origin[0]), far);
    while let End::Surface { point, direction, .. } = end {
        points.push((point[0], point[1]));
        let is_far = point.iter().any(|x| x.abs() > 20.0);
        if is_far || points.len() > 1000 {
            break;
        }
        end = to(Target::Sphere { center: point, radius: 0.25 }, &Start { origin: point, direction });
    }
    points
}

/// Light over a road: what is below a height.
fn mirage(path: &Path, top: f64) -> Result<(), String> {
    let (x, y) = (Scale::new(150.0, 550.0), Scale::new(0.0, top));
    let mut plot = Plot::new(x, y, "m away from the eye", "m above the road");
    let method = Method::Steps(Steps::Controlled { tolerance: 1e-6 });
    for angle in MIRAGE_ANGLES.into_iter().chain([7e-3, 8e-3]) {
        let height = |x: f64| {
            let road = Target::Plane { point: [0.0; 3], normal: [0.0, 1.0, 0.0] };
            let world = World { bend: Bend::Medium(air(method)), targets: vec![wall(x), road] };
            match world.follow::<f64>(&start(0.0, EYE, -angle), ENOUGH) {
                End::Surface { object: 0, point, .. } => Some((point[0], point[1])),
                _ => None,
            }
        };
        let points = (0..=400).map_while(|i| height(150.0 + f64::from(i)));
        plot.curve(points, if angle < 6.9e-3 { "#36c" } else { "#c33" }, false);
    }
    plot.write(path)
}
