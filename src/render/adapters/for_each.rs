//! A closure as a framebuffer.

use crate::render::{Framebuffer, Pixel, Size};

/// Calls a closure with each pixel; it learns nothing of the ends of rows.
///
/// ```
/// use whit::Rgb;
/// use whit::render::{ForEach, Framebuffer, Pixel, Size};
/// let mut brightest = 0.0_f32;
/// let mut picture = ForEach::new(Size::new(320, 240), |pixel: Pixel| {
///     brightest = brightest.max(pixel.color.luminance());
///     Ok::<(), core::convert::Infallible>(())
/// });
/// picture.put(Pixel { x: 0, y: 0, cell: 1, color: Rgb::grey(0.5) })?;
/// assert_eq!(brightest, 0.5);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ForEach<F> {
    size: Size,
    call: F,
}

impl<F, E> ForEach<F>
where
    F: FnMut(Pixel) -> Result<(), E>,
{
    /// A picture of this size whose pixels are handed to `call`. After an error `call` gets the same pixel again when
    /// rendering goes on.
    pub const fn new(size: Size, call: F) -> Self {
        Self { size, call }
    }
}

impl<F, E> Framebuffer for ForEach<F>
where
    F: FnMut(Pixel) -> Result<(), E>,
{
    type Error = E;

    fn size(&self) -> Size {
        self.size
    }

    fn put(&mut self, pixel: Pixel) -> Result<(), E> {
        (self.call)(pixel)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    #[test]
    fn errors_are_those_of_the_closure() {
        let mut picture = ForEach::new(Size::new(2, 1), |pixel| if pixel.x == 0 { Ok(()) } else { Err(pixel.x) });
        let mut put = |x| picture.put(Pixel { x, y: 0, cell: 1, color: Rgb::BLACK });
        assert_eq!([put(0), put(1)], [Ok(()), Err(1)]);
    }
}
