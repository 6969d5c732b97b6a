//! The scenes on this machine, whose pictures have the same bits as those of the board.

use std::path::Path;

use whit::render::{Encoding, Rgb888, Size};
use whit::{Effects, Frame, Stats, Tracer};

use super::checksum::{START, checksum};
use super::scenes::Peer;

/// The most bounces.
const DEPTH: usize = 15;

pub struct Rendered {
    size: Size,
    bytes: Vec<u8>,
    pub rays: u64,
}

pub fn render(peer: &Peer) -> Result<Rendered, String> {
    let size = Size::new(peer.size[0], peer.size[1]);
    let mut bytes = vec![0; size.pixels() as usize * 3];
    let mut picture = Rgb888::new(size, &mut bytes, Encoding::Display).map_err(|error| error.to_string())?;
    let tracer =
        Tracer::<f32, { Effects::ALL.bits() }, DEPTH>::try_new(&peer.scene).map_err(|error| error.to_string())?;
    let mut frame =
        Frame::observed(&tracer, peer.settings(0.0), Stats::default()).map_err(|error| error.to_string())?;
    frame.render(&mut picture).map_err(|error| format!("{error:?}"))?;
    let rays = frame.observer().rays();
    Ok(Rendered { size, bytes, rays })
}

impl Rendered {
    /// As on the board.
    pub fn checksum(&self) -> u64 {
        checksum(START, &self.bytes)
    }

    /// Writes it as a PNG file.
    pub fn save(&self, file: &Path) -> Result<(), String> {
        let saved =
            image::save_buffer(file, &self.bytes, self.size.width, self.size.height, image::ExtendedColorType::Rgb8);
        saved.map_err(|error| format!("{}: {error}", file.display()))
    }
}
