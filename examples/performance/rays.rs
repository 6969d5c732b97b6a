//! The rays of a picture and its objects, in files, for all who replay them.

use std::fs;
use std::path::PathBuf;

use crate::programs::{Programs, numbers};

/// Files that one of whit's programs has written.
pub struct RayFiles {
    /// Eight numbers a ray: origin, direction, distance of a light (infinite for none) and one that is not used.
    pub rays: PathBuf,
    /// Four numbers a sphere, or nine a triangle.
    pub shapes: PathBuf,
    /// How many rays look for the nearest surface; they come first.
    pub closest: usize,
    /// How many look for any surface before a light.
    pub shadow: usize,
}

impl RayFiles {
    pub fn write(programs: &Programs, scene: &str, count: usize, size: u32) -> Result<Self, String> {
        let (rays, shapes) = (programs.file("rays"), programs.file("shapes"));
        let mut command = programs.measured("any");
        command.args(["rays", scene, &count.to_string(), &size.to_string()]).args([&rays, &shapes]);
        let [closest, shadow] = numbers(&mut command)?.map(|count: f64| count as usize);
        Ok(Self { rays, shapes, closest, shadow })
    }
}

/// The numbers of a file, by so many.
pub fn records<const N: usize>(path: &std::path::Path) -> Result<Vec<[f32; N]>, String> {
    let bytes = fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let number = |bytes: &[u8]| bytes.try_into().map(f32::from_le_bytes).unwrap_or(f32::NAN);
    let numbers: Vec<f32> = bytes.chunks_exact(4).map(number).collect();
    Ok(numbers.chunks_exact(N).filter_map(|record| record.try_into().ok()).collect())
}
