//! Where the instructions of the firmware for a scene go, on an emulated Cortex-M4F.

mod emulator;
mod firmware;
mod places;

use std::collections::HashMap;

use places::{Place, Places};

/// The processor.
pub const TARGET: &str = "thumbv7em-none-eabihf";
/// The board in the emulator that has one.
pub const BOARD: &str = "mps2-an386";
/// Of the pictures: of one sample a pixel, as for docs/targets.md.
pub const SIZE: [u32; 2] = [32, 24];
/// Bounces.
pub const DEPTH: u8 = 5;

/// The function of the firmware that renders, of which all is counted that is executed in it and below it.
const FUNCTION: &str = "draw_row";

/// How many instructions of what.
pub struct Profile {
    pub scene: String,
    counts: Vec<(Place, u64)>,
}

/// Builds the firmware for a scene, runs it and asks what each instruction is of.
pub fn profile(scene: &str) -> Result<Profile, String> {
    let program = firmware::build(scene)?;
    let failed = |error: String| format!("{}: {error}", program.display());
    let bytes = std::fs::read(&program).map_err(|error| failed(error.to_string()))?;
    let places = Places::of(&bytes).map_err(&failed)?;
    let start = places.address(FUNCTION).map_err(&failed)?;
    let executed = emulator::run(&program, start).map_err(&failed)?;
    let place = |(address, count)| Ok((places.find(address)?, count));
    let counts = executed.into_iter().map(place).collect::<Result<_, String>>().map_err(&failed)?;
    Ok(Profile { scene: scene.to_owned(), counts })
}

impl Profile {
    /// Of the whole picture.
    pub fn instructions(&self) -> u64 {
        self.counts.iter().map(|(_, count)| count).sum()
    }

    /// Instructions by file, once by the file that they are of, once with those of `src/math` counted for the file that
    /// computes something by them. The largest in the second sense come first.
    pub fn files(&self) -> Vec<(String, [u64; 2])> {
        let mut files = HashMap::<&str, [u64; 2]>::new();
        for (place, count) in &self.counts {
            files.entry(&place.file).or_default()[0] += count;
            files.entry(&place.user).or_default()[1] += count;
        }
        let mut files: Vec<_> = files.into_iter().map(|(file, counts)| (file.to_owned(), counts)).collect();
        files.sort_by(|(one, [own, all]), (other, [other_own, other_all])| {
            (other_all, other_own, one).cmp(&(all, own, other))
        });
        files
    }

    /// Instructions by line, the largest first.
    pub fn lines(&self) -> Vec<(String, u64)> {
        let mut lines = HashMap::<String, u64>::new();
        for (place, count) in &self.counts {
            *lines.entry(format!("{}:{} {}", place.file, place.line, place.function)).or_default() += count;
        }
        let mut lines: Vec<_> = lines.into_iter().collect();
        lines.sort_by(|(one, count), (other, other_count)| (other_count, one).cmp(&(count, other)));
        lines
    }
}
