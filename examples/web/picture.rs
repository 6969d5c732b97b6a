//! The picture as the page shows it and as it is compared with others.

use core::convert::Infallible;

use whit::Rgb;
use whit::render::{Encoding, Framebuffer, Pixel, Size};

/// The most pixels a picture may have: 640×480.
pub const CAPACITY: usize = 640 * 480;

/// Memory for a picture of any size up to [`CAPACITY`] pixels.
pub struct Picture {
    pub size: Size,
    pub encoding: Encoding,
    /// How many pixels are not known yet.
    pub left: u32,
    /// Red, green, blue, alpha: the layout of `ImageData`.
    pub bytes: [[u8; 4]; CAPACITY],
    /// Linear light, or as the scene's tone says.
    pub values: [Rgb<f32>; CAPACITY],
}

impl Picture {
    /// Nothing yet. All bytes are 0, so that it takes no room in the module.
    pub const EMPTY: Self = Self {
        size: Size::new(0, 0),
        encoding: Encoding::Srgb,
        left: 0,
        bytes: [[0; 4]; CAPACITY],
        values: [Rgb::grey(0.0); CAPACITY],
    };

    /// Begins a picture of a size that there is room for.
    pub fn begin(&mut self, size: Size, encoding: Encoding) {
        (self.size, self.encoding) = (size, encoding);
        self.left = size.width * size.height;
    }
}

impl Framebuffer for Picture {
    type Error = Infallible;

    fn size(&self) -> Size {
        self.size
    }

    /// Shows a coarse pixel as a square.
    fn put(&mut self, pixel: Pixel) -> Result<(), Infallible> {
        let [r, g, b] = self.encoding.encode8(pixel.color);
        let (width, x) = (self.size.width as usize, pixel.x as usize);
        let columns = x..(x + pixel.cell as usize).min(width);
        for y in pixel.y..(pixel.y + pixel.cell).min(self.size.height) {
            let start = y as usize * width;
            if let Some(places) = self.bytes.get_mut(start + columns.start..start + columns.end) {
                places.fill([r, g, b, 255]);
            }
        }
        if let Some(place) = self.values.get_mut(pixel.y as usize * width + x) {
            *place = pixel.color;
        }
        self.left -= 1;
        Ok(())
    }
}
