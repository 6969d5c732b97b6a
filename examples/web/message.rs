//! Text for the page, put together without `core::fmt`, which would be a large part of a module.

/// What there is no room for is left out.
pub struct Message {
    bytes: [u8; 256],
    length: usize,
}

impl Message {
    pub const EMPTY: Self = Self { bytes: [0; 256], length: 0 };

    pub fn as_bytes(&self) -> &[u8] {
        self.bytes.get(..self.length).unwrap_or_default()
    }

    /// Replaces the text.
    pub fn set(&mut self, text: &str) -> &mut Self {
        self.length = 0;
        self.text(text)
    }

    pub fn text(&mut self, text: &str) -> &mut Self {
        text.bytes().for_each(|byte| self.byte(byte));
        self
    }

    pub fn number(&mut self, number: usize) -> &mut Self {
        let mut unit = 1;
        while number / unit >= 10 {
            unit *= 10;
        }
        while unit > 0 {
            self.byte(b'0' + (number / unit % 10) as u8);
            unit /= 10;
        }
        self
    }

    fn byte(&mut self, byte: u8) {
        if let Some(place) = self.bytes.get_mut(self.length) {
            *place = byte;
            self.length += 1;
        }
    }
}
