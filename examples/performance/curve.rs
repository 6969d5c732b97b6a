//! Time by the number of objects, through a list of them and through a hierarchy.

use std::path::Path;

use crate::chart::{Line, chart};
use crate::crossing::{Crossing, crossing};
use crate::effort::{Effort, LONGEST_LIST, MOST_OBJECTS};
use crate::programs::{Programs, numbers};
use crate::rounds::Rounds;
use crate::section::Section;

/// What is searched: a scene, a layout, and how the page calls it.
const SERIES: [(&str, &str, &str); 7] = [
    ("balls", "list", "spheres, list"),
    ("balls", "packed", "packed spheres, list"),
    ("mesh", "list", "triangles, list"),
    ("balls", "boxes", "spheres, hierarchy"),
    ("balls", "packed-boxes", "packed spheres, hierarchy"),
    ("mesh", "boxes", "triangles, hierarchy"),
    ("flake", "boxes", "sphere-flake, hierarchy"),
];
/// Whole flakes.
const FLAKES: [usize; 4] = [10, 91, 820, 7381];
/// A list and the hierarchy of the same objects.
const PAIRS: [(usize, usize); 3] = [(0, 3), (1, 4), (2, 5)];
/// How often: the curve has many points.
const ROUNDS: usize = 5;

/// What is measured of a number of objects: nanoseconds a ray, and nanoseconds an object to build.
struct Point<'a> {
    count: usize,
    rounds: Rounds<'a, 2>,
}

pub fn measure(programs: &Programs, effort: &Effort, images: &Path) -> Result<Section, String> {
    let mut section = Section::new("List or hierarchy");
    section.line(&format!(
        "The scene of the flake, with spheres at random or a torus of triangles in place of its balls, {0}×{0} pixels: nanoseconds \
         of processor time a ray, of whole pictures on one thread, of the plain build. Lists end at {LONGEST_LIST}, single \
         spheres at {MOST_OBJECTS}, because a scene has 65534 objects at most; a list of triangles or packed spheres is one \
         object.",
        effort.curve
    ));
    let mut counts = [effort.counts, &FLAKES].concat();
    counts.sort_unstable();
    counts.dedup();
    let largest = effort.counts.last().copied().unwrap_or_default();
    let points = counts.into_iter().filter(|&count| count <= largest).map(|count| point(programs, effort, count));
    let points = points.collect::<Result<Vec<_>, String>>()?;
    draw(&points, &images.join("objects.svg"))?;
    section.line("![Nanoseconds a ray by the number of objects](images/performance/objects.svg)");
    section.list(PAIRS.into_iter().map(|(list, boxes)| pays(&points, list, boxes)));
    write_building(&mut section, &points);
    Ok(section)
}

/// Whether so many are measured.
fn has(effort: &Effort, scene: &str, layout: &str, count: usize) -> bool {
    let most = match (scene, layout) {
        (_, "list" | "packed") => LONGEST_LIST,
        ("mesh", _) | (_, "packed-boxes") => usize::MAX,
        _ => MOST_OBJECTS,
    };
    count <= most && if scene == "flake" { &FLAKES } else { effort.counts }.contains(&count)
}

fn point<'a>(programs: &'a Programs, effort: &Effort, count: usize) -> Result<Point<'a>, String> {
    eprintln!("{count} objects");
    let mut rounds = Rounds::new();
    for (scene, layout, title) in SERIES.into_iter().filter(|(scene, layout, _)| has(effort, scene, layout, count)) {
        let (number, size) = (count.to_string(), effort.curve.to_string());
        rounds.add(title, move || {
            let mut command = programs.measured("any");
            command.args(["render", scene, &number, layout, &size]).arg(programs.file("curve.ppm"));
            let [rays, time, build] = numbers(&mut command)?;
            Ok([time / rays, build / count as f64])
        });
    }
    rounds.run(effort.rounds.min(ROUNDS))?;
    Ok(Point { count, rounds })
}

impl Point<'_> {
    fn time(&self, series: usize) -> Option<f64> {
        Some(self.rounds.of(SERIES[series].2, 0).median).filter(|time| time.is_finite())
    }
}

fn draw(points: &[Point<'_>], path: &Path) -> Result<(), String> {
    let line = |series: usize| Line {
        name: SERIES[series].2,
        points: points.iter().filter_map(|point| Some((point.count as f64, point.time(series)?))).collect(),
        is_dashed: SERIES[series].1 == "list" || SERIES[series].1 == "packed",
    };
    let lines: Vec<Line<'_>> = (0..SERIES.len()).map(line).collect();
    chart(path, &lines, "objects", "nanoseconds a ray")
}

/// From how many objects on a hierarchy takes less time than a list.
fn pays(points: &[Point<'_>], list: usize, boxes: usize) -> String {
    let ratio = |point: &Point<'_>| Some((point.count as f64, point.time(list)? / point.time(boxes)?));
    let ratios: Vec<(f64, f64)> = points.iter().filter_map(ratio).collect();
    let place = match crossing(&ratios) {
        Crossing::Before(fewest) => {
            format!("faster than the list from {fewest} objects on, the fewest that were measured")
        }
        Crossing::At(count) => format!("faster than the list from about {count:.0} objects on"),
        Crossing::After(most) => format!("slower than the list up to {most} objects, the most that were measured"),
    };
    format!("{}: {place}.", SERIES[boxes].2)
}

fn write_building(section: &mut Section, points: &[Point<'_>]) {
    section.line("Building, microseconds an object on one thread; of packed spheres, packing included:");
    let titles = [3, 4, 5, 6].map(|series| SERIES[series].2);
    section.table(&[&["objects"], titles.as_slice()].concat(), "rrrrr");
    for Point { count, rounds } in points {
        let times = titles.map(|title| rounds.of(title, 1).median / 1e3);
        let cells = times.map(|time| if time.is_nan() { "–".to_owned() } else { format!("{time:.2}") });
        section.row(&[&[count.to_string()], cells.as_slice()].concat());
    }
}
