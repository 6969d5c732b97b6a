//! The scene of the business card.

use std::path::Path;

use whit::render::{Encoding, Rgb888, Sampling, Size};
use whit::{Budget, Frame, Settings, scenes};

use crate::files;

/// As the original: no branch is cut by its weight. Depth 15 is the deepest that is reached.
pub fn draw(side: u32, samples: u32, picture: &Path) -> Result<(), String> {
    const DEPTH: u8 = 15;
    let size = Size::new(side, side);
    let mut bytes = vec![0; size.pixels() as usize * 3];
    let tracer = whit::tracer!(scenes::CARD, DEPTH as usize);
    let settings = Settings {
        budget: Budget::with_depth(DEPTH),
        ..Settings::new(size.width, size.height).with_sampling(Sampling::Sequence(samples))
    };
    let mut target = Rgb888::new(size, &mut bytes, Encoding::Display).map_err(|error| error.to_string())?;
    let mut frame = Frame::new(&tracer, settings).map_err(|error| error.to_string())?;
    frame.render(&mut target).map_err(|error| error.to_string())?;
    files::write_picture(picture, side, &bytes)
}
