//! The view: the block of lines after `v`.

use super::lines::{Line, Lines};
use super::{Found, NffError};
use crate::math::{Vec3, tangent_of_degrees};
use crate::render::Size;
use crate::scene::{Camera, Extent};

/// What a view says.
#[derive(Clone, Copy)]
pub(super) struct View {
    pub(super) camera: Camera<f32>,
    pub(super) size: Size,
}

/// The lines that are there so far.
#[derive(Default)]
struct Parts {
    from: Option<Vec3<f32>>,
    at: Option<Vec3<f32>>,
    up: Option<Vec3<f32>>,
    angle: Option<f32>,
    hither: Option<f32>,
    size: Option<Size>,
}

impl View {
    /// Reads the lines after the line `v`, whose number is `line`, up to the first that is not of a view.
    pub(super) fn read(lines: &mut Lines<'_>, line: usize) -> Result<Self, NffError> {
        let mut parts = Parts::default();
        loop {
            let mut ahead = lines.clone();
            let Some(mut part) = ahead.next() else {
                return parts.view(line, ahead.last_number(), || Found::EndOfFile);
            };
            let word = part.word().unwrap_or_default();
            let number = part.number;
            if !parts.take(word, part)? {
                return parts.view(line, number, || Found::Word(word.into()));
            }
            *lines = ahead;
        }
    }
}

impl Parts {
    /// Reads the line that starts with `word`, if it is of a view.
    fn take(&mut self, word: &str, mut line: Line<'_>) -> Result<bool, NffError> {
        let once = |is_there: bool| {
            let expected = "one line each of from, at, up, angle, hither and resolution";
            let error = || NffError::unexpected(line.number, expected, Found::Word(word.into()));
            if is_there { Err(error()) } else { Ok(()) }
        };
        match word {
            "from" => {
                once(self.from.is_some())?;
                self.from = Some(line.point()?);
            }
            "at" => {
                once(self.at.is_some())?;
                self.at = Some(line.point()?);
            }
            "up" => {
                once(self.up.is_some())?;
                self.up = Some(line.point()?);
            }
            "angle" => {
                once(self.angle.is_some())?;
                let expected = "a number above 0 and below 180";
                self.angle = Some(line.number_within("angle", expected, |angle| angle > 0.0 && angle < 180.0)?);
            }
            "hither" => {
                once(self.hither.is_some())?;
                self.hither = Some(line.number("hither")?);
            }
            "resolution" => {
                once(self.size.is_some())?;
                let expected = "a whole number above 0";
                self.size = Some(Size::new(line.whole("width", expected, 1)?, line.whole("height", expected, 1)?));
            }
            _ => return Ok(false),
        }
        line.end()?;
        Ok(true)
    }

    /// The view from line `line`, if all is there at its end, which is in line `end` before `found`.
    fn view(self, line: usize, end: usize, found: impl Fn() -> Found) -> Result<View, NffError> {
        let missing = |expected| NffError::unexpected(end, expected, found());
        let from = self.from.ok_or_else(|| missing("`from`"))?;
        let at = self.at.ok_or_else(|| missing("`at`"))?;
        let up = self.up.ok_or_else(|| missing("`up`"))?;
        let angle = self.angle.ok_or_else(|| missing("`angle`"))?;
        let size = self.size.ok_or_else(|| missing("`resolution`"))?;
        let half_height = tangent_of_degrees(f64::from(angle) / 2.0) as f32;
        let camera = Camera { extent: Extent::PixelCentres, ..Camera::with_half_height(from, at, up, half_height) };
        camera
            .check()
            .map_err(|(field, expected)| (name_in_file(field), expected))
            .map_err(NffError::out_of_range(line))?;
        Ok(View { camera, size })
    }
}

/// What a field of the camera is called in the file.
fn name_in_file(field: &'static str) -> &'static str {
    match field {
        "eye" => "from",
        "target" => "at",
        "half_height" => "angle",
        other => other,
    }
}
