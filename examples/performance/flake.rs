//! Whole pictures of the flake.

use whit::{Object, Shape, scenes};

use crate::aim::{Aim, Limit};
use crate::contest::{self, Contest, Layout};
use crate::effort::{Effort, LONGEST_LIST};
use crate::programs::{BUILDS, Programs};
use crate::section::Section;

/// How many times as fast as POV-Ray, with the most spheres.
const AIM: Limit = Limit::AtLeast(5.0);

/// How the spheres lie in memory.
pub const LAYOUTS: [Layout; 3] =
    [("packed", "packed list"), ("boxes", "hierarchy"), ("packed-boxes", "hierarchy of packed")];

/// The spheres of the largest.
const MOST: usize = 7381;

pub fn measure(programs: &Programs, effort: &Effort) -> Result<Section, String> {
    let mut section = Section::new("The sphere-flake");
    section.line(&format!(
        "The sphere-flake of the Standard Procedural Databases: mirroring spheres on a plane under three lights, {0}×{0} pixels of \
         one sample, 5 reflections. Nanoseconds of processor time a ray, of whole pictures on one thread. The spheres are packed \
         by eights or objects of their own, in a list or in a hierarchy of boxes. POV-Ray computes in double precision.",
        effort.picture,
    ));
    let contests = effort.flakes.iter().map(|&count| contest(programs, effort, count));
    let contests = contests.collect::<Result<Vec<_>, String>>()?;
    contest::write(&mut section, &["spheres"], &LAYOUTS, &contests);
    if let (Some(largest), Some(count)) = (contests.last().filter(|last| last.has_peer()), effort.flakes.last()) {
        section.aims.push(Aim {
            what: format!("a flake of {count}: POV-Ray's time a ray, by whit's"),
            limit: AIM,
            measured: BUILDS.map(|(build, _, title)| (title, largest.ratio(build))).into(),
        });
    }
    Ok(section)
}

fn contest<'a>(programs: &'a Programs, effort: &Effort, count: usize) -> Result<Contest<'a>, String> {
    let [floor, ball] = scenes::FLAKE.objects else { return Err("the flake has other objects now".to_owned()) };
    let spheres = scenes::flake_spheres::<MOST>();
    let balls = spheres.iter().take(count).map(|sphere| Object { shape: Shape::Sphere(*sphere), ..*ball });
    let objects: Vec<_> = std::iter::once(*floor).chain(balls).collect();
    let scene = scenes::FLAKE.with_objects(&objects);
    let is_short = |(layout, _): &Layout| *layout != "packed" || count <= LONGEST_LIST;
    let layouts: Vec<Layout> = LAYOUTS.into_iter().filter(is_short).collect();
    let (name, count) = (format!("flake-{count}"), count.to_string());
    Contest::run(
        programs,
        effort,
        (&name, &scene, &["render", "flake", &count]),
        &layouts,
        std::slice::from_ref(&count),
    )
}
