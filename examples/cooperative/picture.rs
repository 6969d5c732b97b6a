//! A picture that is rendered in steps; all that is kept of it is a checksum.

use core::convert::Infallible;

use whit::render::{ForEach, Pixel, Progress, Size};
use whit::{Frame, Settings};

use crate::checksum::Checksum;
use crate::choice::{DEPTH, SCENE, SIZE};

/// The state of the picture.
type Drawn = Frame<'static, f32, { SCENE.effects().bits() }, { SCENE.stack(DEPTH as usize) }, (), { SCENE.media() }>;

/// A picture in the making.
pub struct Picture {
    frame: Drawn,
    checksum: Checksum,
}

impl Picture {
    /// Nothing of it yet.
    pub fn new() -> Result<Self, &'static str> {
        let tracer = whit::tracer!(SCENE, DEPTH as usize);
        let settings = Settings::new(SIZE[0], SIZE[1]).with_depth(DEPTH);
        let frame = Frame::new(&tracer, settings).map_err(|_| "WHIT_SIZE: expected 1 to 1048576 pixels a side")?;
        Ok(Self { frame, checksum: Checksum::EMPTY })
    }

    /// That many more rays.
    pub fn step(&mut self, rays: u32) -> Result<Progress, &'static str> {
        let checksum = &mut self.checksum;
        let mut target = ForEach::new(Size::new(SIZE[0], SIZE[1]), |pixel: Pixel| {
            checksum.add(&pixel);
            Ok::<(), Infallible>(())
        });
        self.frame.step(rays, &mut target).map_err(|_| "the picture and the frame differ in size")
    }

    /// Of the pixels up to here.
    pub fn checksum(&self) -> u64 {
        self.checksum.value()
    }
}
