//! The library's own framebuffers, which take any pixel.

use whit::render::{ByteOrder, Encoding, Grey8, Mono, Pixel, Rgb565, Rgb888, Rgba8888, Size};
use whit::{Framebuffer, Rgb};

use super::{Fault, require};

/// Puts a colour into each of them, in both encodings: what is no more than black is black, and what is white or more is
/// white.
pub fn check_targets(color: Rgb<f32>) -> Result<(), Fault> {
    for encoding in [Encoding::Srgb, Encoding::Display] {
        let bytes = put(color, encoding).map_err(|error| error.to_string())?;
        let is_at = |ends: fn(f32) -> bool| ends(color.r) && ends(color.g) && ends(color.b);
        let expected = match color {
            _ if is_at(|x| x <= 0.0) => Some(0),
            _ if is_at(|x| x >= 1.0) => Some(255),
            _ => None,
        };
        let fits = expected.is_none_or(|byte| bytes.iter().all(|&found| found == byte));
        require(fits, || format!("{color:?} becomes {bytes:?}"))?;
    }
    Ok(())
}

/// The bytes of one pixel of each kind.
fn put(color: Rgb<f32>, encoding: Encoding) -> Result<Vec<u8>, Box<dyn std::error::Error>> {
    let (size, pixel) = (Size::new(1, 1), Pixel { x: 0, y: 0, cell: 1, color });
    let (mut rgb, mut rgba, mut short, mut grey, mut bit) = ([0; 3], [0; 4], [0; 2], [0; 1], [0; 1]);
    Rgb888::new(size, &mut rgb, encoding)?.put(pixel)?;
    Rgba8888::new(size, &mut rgba, encoding)?.put(pixel)?;
    Rgb565::new(size, &mut short, encoding, ByteOrder::LittleEndian)?.put(pixel)?;
    Grey8::new(size, &mut grey, encoding)?.put(pixel)?;
    Mono::new(size, &mut bit)?.put(pixel)?;
    let [r, g, b, _] = rgba;
    Ok([&rgb[..], &[r, g, b], &short, &grey].concat())
}
