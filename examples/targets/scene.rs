//! The built-in scenes on this machine: what every other has to give, to the last bit.

use whit::render::{Encoding, Framebuffer, Pixel, Rgb888, Size};
use whit::{Effects, Frame, Scene, Settings, Stats, Tracer};

use crate::checksum::Checksum;

/// Of the pictures. The slowest processor takes some seconds for one.
pub const SIZE: Size = Size::new(32, 24);
/// Bounces.
pub const DEPTH: u8 = 5;
const STACK: usize = DEPTH as usize + 2;

/// A scene, rendered.
pub struct Rendered {
    pub scene: &'static str,
    /// Of the linear pixels.
    pub checksum: u64,
    /// As a PPM file.
    pub file: Vec<u8>,
    /// Rays, shadow rays included.
    pub rays: u64,
}

/// Renders a scene by a tracer for all effects; the firmware has one for those of the scene.
pub fn render(name: &'static str, scene: &'static Scene<'static, f32>) -> Result<Rendered, String> {
    let mut bytes = vec![0; SIZE.pixels() as usize * 3];
    let picture = Rgb888::new(SIZE, &mut bytes, Encoding::of(scene)).map_err(|error| error.to_string())?;
    let mut target = Checked { picture, checksum: Checksum::EMPTY };
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, STACK, 8>::try_new(scene).map_err(|error| error.to_string())?;
    let settings = Settings::new(SIZE.width, SIZE.height).with_depth(DEPTH);
    let mut frame = Frame::observed(&tracer, settings, Stats::default()).map_err(|error| error.to_string())?;
    frame.render(&mut target).map_err(|error| format!("{error:?}"))?;
    let checksum = target.checksum.value();
    let header = format!("P6 {:06} {:06} 255\n", SIZE.width, SIZE.height);
    let file = [header.as_bytes(), &bytes].concat();
    Ok(Rendered { scene: name, checksum, file, rays: frame.observer().rays() })
}

/// A picture whose linear pixels are counted into a checksum.
struct Checked<'a> {
    picture: Rgb888<'a>,
    checksum: Checksum,
}

impl Framebuffer for Checked<'_> {
    type Error = std::convert::Infallible;

    fn size(&self) -> Size {
        self.picture.size()
    }

    fn put(&mut self, pixel: Pixel) -> Result<(), Self::Error> {
        self.checksum.add(&pixel);
        self.picture.put(pixel)
    }
}
