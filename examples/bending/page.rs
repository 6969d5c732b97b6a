//! The page docs/bending.md.

use std::fmt::Write;

use crate::measure::Row;
use crate::systems::System;
use crate::way::Kind;

/// What was measured of a system.
pub struct Section {
    pub system: System,
    pub rows: Vec<Row>,
}

/// Errors that the methods are compared at.
const WANTED: [f64; 4] = [1e-2, 1e-3, 1e-4, 1e-5];

const HEAD: &str = "\
# What accuracy costs where light is bent

Light goes along curves where the index of refraction varies ([`Profile`](../src/scene/profile/mod.rs)) and around a black hole
([`BlackHole`](../src/scene/profile/steps.rs)). How it is followed is a choice, [`Method`](../src/scene/profile/steps.rs) and
`Steps`: this page shows what each choice gets wrong and what it takes.

    cargo run --release --example bending

writes it. With `-- --check` it compares errors and steps with it, and fails where they differ. Which bounds the errors keep, in
`f32` and in `f64`, against closed forms, quadratures and elliptic integrals, is tested by `cargo test --test bending`.

- **Error**: the largest of all paths, in `f32`, against the exact value; \"lost\" where a path ends at something else.
- **Steps** a path, all of them counted: those that `Controlled` tries and finds too long, and straight stretches in front of a
  medium and behind it, too. `Budget::steps_per_ray` has to be as large as the most that a path of a picture takes.
- **Evaluations** of n² or of its gradient: one a step by `Fixed`, three by `Controlled`, and two by `Layers`.
- **Time** a path, as a ratio to that of a straight ray to a wall, the shortest there is, measured in turn in the same run, on
  the machine that wrote the page.

## Which method to take

- **`Controlled`** for whatever is to be right. Its steps are long where light goes nearly straight and short where it turns,
  never longer than the length over which the medium changes its ways, and its error goes with the tolerance: down to where
  `f32` has no digits left, from where on more steps are only more roundings. The first table says where that is. A larger
  tolerance is enough where light meets something soon after it was bent, a smaller one where it goes on for a long way, as over
  a road, or nearly around a hole.
- **`Fixed`** where each path has to take about the same time, and each step as little code as can be. Half the length is
  a quarter of the error. The length has to fit the smallest thing that bends light: too long a step goes through a thin
  layer of warm air and does not notice it. As each step is a single chord, objects are met at a distance from the path that goes
  with the square of the length.
- **`Layers`** to see what a stack of layers does, as in a textbook. In them n·sin θ stays to the last digit, and where light
  does not turn, half the thickness is a quarter of the error. Where it turns, the last layer decides, and the error only goes
  with the root of the thickness. Light that is level in a flat layer stays in it, and light that goes nearly along round ones
  may do so for ever: it ends out of steps.

";

/// The whole page.
pub fn page(sections: &[Section]) -> String {
    let mut page = HEAD.to_owned();
    best(&mut page, sections);
    page.push_str(
        "\n![Light around a black hole](images/bending/hole.svg)\n\nLight with impact parameters of 0 to 10 times the mass; \
         inside of 3√3, dashed, it is captured.\n",
    );
    page.push_str(
        "\n![Light over a hot road](images/bending/mirage.svg)\n\nLight of the next section where it is \
         lowest, and two steeper rays that meet the road; heights are stretched.\n",
    );
    sections.iter().for_each(|section| section.write(&mut page));
    page
}

/// The cheapest way to each error.
fn best(page: &mut String, sections: &[Section]) {
    page.push_str(
        "The fewest evaluations a path that keep the error below a bound, and the least error of all:\n\n| |",
    );
    WANTED.iter().for_each(|error| page.push_str(&format!(" {error:.0e} |")));
    let _ = writeln!(page, " least |\n|---|{}", "---|".repeat(WANTED.len() + 1));
    for Section { system, rows } in sections {
        let _ = write!(page, "| {} |", system.title);
        for wanted in WANTED {
            let good = rows.iter().filter(|row| row.error.is_some_and(|error| error <= wanted));
            let best = good.min_by(|a, b| a.evaluations_per_path().total_cmp(&b.evaluations_per_path()));
            let cell = best.map_or("–".to_owned(), |row| {
                format!("{} {}: {:.0}", row.way.kind.name(), step(row), row.evaluations_per_path())
            });
            let _ = write!(page, " {cell} |");
        }
        let least = rows.iter().filter_map(|row| Some((row, row.error?))).min_by(|a, b| a.1.total_cmp(&b.1));
        let cell =
            least.map_or(String::new(), |(row, error)| format!("{} {}: {error:.1e}", row.way.kind.name(), step(row)));
        let _ = writeln!(page, " {cell} |");
    }
}

impl Section {
    fn write(&self, page: &mut String) {
        let System { title, about, name, .. } = &self.system;
        let _ =
            write!(page, "\n## {title}\n\n{about}\n\n![Error over evaluations](images/bending/cost-{name}.svg)\n\n");
        page.push_str("| method | tolerance, length or thickness | error | steps | evaluations | time |\n");
        page.push_str("|---|--:|--:|--:|--:|--:|\n");
        for kind in Kind::ALL {
            for row in self.rows.iter().filter(|row| row.way.kind == kind) {
                let error = row.error.map_or("lost".to_owned(), |error| format!("{error:.1e}"));
                let time = row.time.map_or(String::new(), |ratio| format!("{ratio:.0}"));
                let (name, step) = (kind.name(), step(row));
                let (steps, evaluations) = (row.steps_per_path(), row.evaluations_per_path());
                let _ = writeln!(page, "| {name} | {step} | {error} | {steps:.1} | {evaluations:.0} | {time}× |");
            }
        }
    }
}

fn step(row: &Row) -> String {
    let step = row.way.step;
    if row.way.kind == Kind::Controlled || step < 0.01 { format!("{step:e}") } else { step.to_string() }
}

/// Lines of tables in which two pages differ, other than in times.
pub fn compare(page: &str, now: &str) -> Vec<String> {
    let (documented, found) = (rows(page), rows(now));
    let mut problems: Vec<String> = found.iter().filter(|row| !documented.contains(row)).cloned().collect();
    if found.len() != documented.len() {
        problems.push(format!("{} rows, not {}", found.len(), documented.len()));
    }
    problems
}

/// The lines of the tables, each with its section and without times.
fn rows(page: &str) -> Vec<String> {
    let mut section = "";
    let mut rows = Vec::new();
    for line in page.lines() {
        section = line.strip_prefix("## ").unwrap_or(section);
        if line.starts_with('|') {
            let cells = line.split('|').map(str::trim).filter(|cell| !cell.is_empty() && !cell.ends_with('×'));
            rows.push(format!("{section}: {}", cells.collect::<Vec<_>>().join(", ")));
        }
    }
    rows
}
