//! Choices and numbers.
//!
//! A number is a handy one, or any of its range with an even distribution of exponents, or an end of the range, or one
//! that was there before, perhaps some units in the last place away. One run in sixteen is wild: its numbers may leave
//! their ranges, and some are any bits at all. Another one is spoiled: all is well but for a few that are not finite.

use arbitrary::Unstructured;
use whit::{Rgb, Vec3};

use super::span::{AMOUNT, Span};

/// Bytes on their way to becoming a run.
pub struct Source<'b> {
    bytes: Unstructured<'b>,
    /// Whether numbers may be out of their ranges.
    pub is_wild: bool,
    /// Whether a few numbers are not finite.
    pub is_spoiled: bool,
    /// The size of things in this run.
    pub scale: f32,
    numbers: Vec<f32>,
    /// Points and directions that were there before.
    pub vectors: Vec<Vec3<f32>>,
}

/// How many numbers are remembered.
const MEMORY: usize = 64;

impl<'b> Source<'b> {
    pub fn new(bytes: &'b [u8]) -> Self {
        let bytes = Unstructured::new(bytes);
        let mut source =
            Self { bytes, is_wild: false, is_spoiled: false, scale: 1.0, numbers: Vec::new(), vectors: Vec::new() };
        let kind = source.below(16);
        (source.is_wild, source.is_spoiled) = (kind == 15, kind == 14);
        source.scale = match source.below(8) {
            0..=4 => 1.0,
            5 => power_of_two(source.between(-39, 39)),
            6 => power_of_two(source.between(-12, 12)),
            _ => [1e-12, 1e-9, 1e9, 1e12].get(source.below(4)).copied().unwrap_or(1.0),
        };
        source
    }

    /// A number from 0 to before `count`; 0 when the bytes are used up.
    pub fn below(&mut self, count: usize) -> usize {
        usize::from(self.byte()) % count.max(1)
    }

    /// A number from `low` to `high`.
    pub fn between(&mut self, low: i32, high: i32) -> i32 {
        self.bytes.int_in_range(low..=high.max(low)).unwrap_or(low)
    }

    /// True once in so many times.
    pub fn once_in(&mut self, times: usize) -> bool {
        self.below(times) + 1 == times
    }

    pub fn byte(&mut self) -> u8 {
        self.bytes.arbitrary().unwrap_or(0)
    }

    pub fn word(&mut self) -> u32 {
        self.bytes.arbitrary().unwrap_or(0)
    }

    /// One of some things.
    pub fn pick<T: Copy>(&mut self, from: &[T], otherwise: T) -> T {
        let number = self.below(from.len());
        from.get(number).copied().unwrap_or(otherwise)
    }

    /// A number.
    pub fn number(&mut self, span: Span) -> f32 {
        let mode = self.byte();
        let x = match mode {
            0..=139 => span.usual.get(usize::from(mode) % span.usual.len().max(1)).copied().unwrap_or(span.low),
            140..=159 => f32::from(self.byte()) / 16.0,
            160..=183 => self.any(span),
            184..=199 => self.end(span),
            200..=249 => self.again(),
            _ => self.wild(span),
        };
        self.keep(x, span)
    }

    /// A number for a coordinate, which is mostly a multiple of a small fraction of the scale.
    pub fn coordinate(&mut self, span: Span) -> f32 {
        let mode = self.byte();
        let x = match mode {
            0..=191 => f32::from(self.byte().cast_signed()) / 16.0 * self.scale,
            192..=207 => self.any(span),
            208..=215 => self.end(span),
            216..=251 => self.again(),
            _ => self.wild(span),
        };
        self.keep(x, span)
    }

    /// A length above 0, mostly about as large as the scale.
    pub fn size(&mut self, span: Span) -> f32 {
        let x = self.coordinate(span);
        self.keep(x.abs(), span)
    }

    /// A number that does not keep to the range, in runs that may have them.
    fn wild(&mut self, span: Span) -> f32 {
        if self.is_wild {
            f32::from_bits(self.word())
        } else if self.is_spoiled {
            self.pick(&[f32::NAN, f32::INFINITY, -f32::INFINITY], f32::NAN)
        } else {
            self.any(span)
        }
    }

    /// Any number of a range, all exponents alike.
    fn any(&mut self, span: Span) -> f32 {
        let (low, high) = span.exponents();
        let magnitude = power_of_two(self.between(low, high)) * (1.0 + f32::from(self.byte()) / 256.0);
        if span.low < 0.0 && self.once_in(2) { -magnitude } else { magnitude }
    }

    /// An end of a range, or next to it.
    fn end(&mut self, span: Span) -> f32 {
        match self.below(if self.is_wild { 6 } else { 4 }) {
            0 => span.low,
            1 => span.high,
            2 => span.low.next_up(),
            3 => span.high.next_down(),
            4 => span.low.next_down(),
            _ => span.high.next_up(),
        }
    }

    /// A number that was there before, or nearly so, or one that is special everywhere.
    pub fn again(&mut self) -> f32 {
        let place = usize::from(self.byte());
        let old = self.numbers.get(place % self.numbers.len().max(1)).copied().unwrap_or(1.0);
        match self.below(12) {
            0..=3 => old,
            4 => self.nudged(old),
            5 => -old,
            6 => old * 0.5,
            7 => old * 2.0,
            8 => 0.0,
            9 => -0.0,
            10 => 1.0,
            _ => 1.0 / old,
        }
    }

    /// A number some units in the last place away.
    pub fn nudged(&mut self, x: f32) -> f32 {
        let steps = self.between(-4, 4);
        (0..steps.abs()).fold(x, |x, _| if steps < 0 { x.next_down() } else { x.next_up() })
    }

    /// The same, remembered.
    pub fn keep(&mut self, x: f32, span: Span) -> f32 {
        let x = self.fit(x, span);
        if self.numbers.len() < MEMORY {
            self.numbers.push(x);
        }
        x
    }

    /// A number as far as the range allows it.
    pub fn fit(&self, x: f32, span: Span) -> f32 {
        if self.is_wild || (self.is_spoiled && !x.is_finite()) { x } else { span.fit(x) }
    }

    /// Three numbers of a range.
    pub fn triple(&mut self, span: Span) -> Rgb<f32> {
        if self.once_in(4) {
            Rgb::new(self.number(span), self.number(span), self.number(span))
        } else {
            Rgb::grey(self.number(span))
        }
    }

    pub fn color(&mut self) -> Rgb<f32> {
        self.triple(AMOUNT)
    }
}

/// 2ⁿ, rounded to what `f32` has.
fn power_of_two(n: i32) -> f32 {
    2.0_f64.powi(n) as f32
}
