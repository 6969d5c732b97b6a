//! Whole pictures of files of the Standard Procedural Databases.

use std::path::Path;

use crate::contest::{self, Contest, Layout};
use crate::effort::Effort;
use crate::files::{self, FILES};
use crate::programs::Programs;
use crate::section::Section;

const LAYOUTS: [Layout; 2] = [("list", "list"), ("boxes", "hierarchy")];

pub fn measure(programs: &Programs, effort: &Effort) -> Result<Section, String> {
    let mut section = Section::new("The Standard Procedural Databases");
    section.line(&format!(
        "Files in the Neutral File Format, [tests/data/nff](../tests/data/nff), {0}×{0} pixels of one sample, 5 bounces: \
         nanoseconds of processor time a ray, of whole pictures on one thread, by a tracer for all that such a file can call \
         for. Its polygons are triangles, here and for POV-Ray, where those of one surface are a mesh.",
        effort.picture,
    ));
    let contests = FILES.iter().map(|name| contest(programs, effort, name)).collect::<Result<Vec<_>, String>>()?;
    contest::write(&mut section, &["file", "objects"], &LAYOUTS, &contests);
    if contests.iter().any(Contest::has_peer) {
        section.line(
            "The backs of opaque surfaces are not there in such a file, which is one comparison more for whit and not to be had \
             from POV-Ray. Its light gets through the glass of the gears and before the mountain, where in such a file, and by whit, there \
             is a shadow.",
        );
    }
    Ok(section)
}

fn contest<'a>(programs: &'a Programs, effort: &Effort, name: &str) -> Result<Contest<'a>, String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/nff").join(name);
    let stored = files::read(&path)?;
    let scene = stored.as_scene();
    let cells = [format!("`{name}`"), scene.objects.len().to_string()];
    let file = path.to_str().ok_or_else(|| format!("{}: expected a path that is text", path.display()))?;
    Contest::run(programs, effort, (name, &scene, &["file", file]), &LAYOUTS, &cells)
}
