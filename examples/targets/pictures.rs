//! A picture from each processor, for the README.

use std::path::Path;

use rayon::prelude::*;

use crate::cargo::{example, folder};
use crate::library::run;
use crate::target::TARGETS;

/// A scene for each of the targets, in their order.
const SCENES: [&str; TARGETS.len()] = ["showcase", "metals", "spheres", "bubble"];

/// Renders them, and writes them as PNG into a folder.
pub fn write(images: &Path) -> Result<(), String> {
    std::fs::create_dir_all(images).map_err(|error| format!("{}: {error}", images.display()))?;
    TARGETS.par_iter().zip(SCENES).try_for_each(|(target, scene)| {
        let mut firmware = example("run", "firmware", target.name, "release");
        run(firmware.env("WHIT_SCENE", scene).env("WHIT_SIZE", "160x120").env("WHIT_DEPTH", "5"))?;
        let picture = folder(target.name).join("target/firmware.ppm");
        let picture = image::open(&picture).map_err(|error| format!("{}: {error}", picture.display()))?;
        let file = images.join(target.short.to_lowercase()).with_extension("png");
        picture.save(&file).map_err(|error| format!("{}: {error}", file.display()))
    })
}
