//! What the formats of displays cost: errors of the encoded picture, and the time of encoding.

use std::convert::Infallible;
use std::hint::black_box;
use std::time::Instant;

use palette::{LinSrgb, Srgb};
use whit::Rgb;
use whit::render::{ByteOrder, Encoding, Framebuffer, Grey8, Mono, Pixel, Rgb565, Rgb888, Size};

use crate::difference::Difference;

/// What a format makes of pictures.
pub struct Format {
    pub name: &'static str,
    pub code: &'static str,
    pub bits: u32,
    pub difference: Difference,
    /// RMSE of means over blocks of 4×4 pixels, as seen from afar.
    pub far: f64,
    /// How many times as long as for `Rgb888` a pixel takes.
    pub time: f64,
}

/// Encodes a picture and, back from the bytes, what a display shows.
type Encoder = fn(Size, &[Rgb<f32>], &mut [u8]);
type Decoder = fn(&[u8], u32, usize, usize) -> [f64; 3];

const FORMATS: [(&str, &str, u32, Encoder, Decoder); 5] = [
    ("24-bit colour", "Rgb888::new(size, bytes, encoding)", 24, rgb888, |bytes, width, x, y| {
        let at = 3 * (y * width as usize + x);
        [bytes[at], bytes[at + 1], bytes[at + 2]].map(|byte| light(f64::from(byte) / 255.0))
    }),
    ("16-bit colour", "Rgb565::new(size, bytes, encoding, order)", 16, rgb565, decode565),
    ("16-bit colour, dithered", "Rgb565::new(…).dithered()", 16, dithered565, decode565),
    ("8-bit grey", "Grey8::new(size, bytes, encoding)", 8, grey8, |bytes, width, x, y| {
        [light(f64::from(bytes[y * width as usize + x]) / 255.0); 3]
    }),
    ("1 bit, dithered", "Mono::new(size, bytes)", 1, mono, |bytes, width, x, y| {
        let byte = bytes[y * width.div_ceil(8) as usize + x / 8];
        [f64::from(byte >> (7 - x % 8) & 1); 3]
    }),
];

/// All formats, on these pictures in linear light.
pub fn measure(size: Size, pictures: &[Vec<LinSrgb<f64>>]) -> Vec<Format> {
    let mut formats = Vec::new();
    for (name, code, bits, encode, decode) in FORMATS {
        let (mut shown, mut wanted, mut far_shown, mut far_wanted) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for picture in pictures {
            let picture: Vec<_> = picture.iter().map(|&pixel| in_format(bits, pixel)).collect();
            let mut bytes = vec![0; size.pixels() as usize * 3];
            encode(size, &single(&picture), &mut bytes);
            let decoded: Vec<_> = (0..picture.len())
                .map(|i| decode(&bytes, size.width, i % size.width as usize, i / size.width as usize))
                .map(|[r, g, b]| LinSrgb::new(r, g, b))
                .collect();
            far_shown.extend(blocks(size, &decoded));
            far_wanted.extend(blocks(size, &picture));
            shown.extend(decoded);
            wanted.extend(picture);
        }
        let difference = Difference::between(&shown, &wanted);
        let far = Difference::between(&far_shown, &far_wanted).rmse;
        formats.push(Format { name, code, bits, difference, far, time: 1.0 });
    }
    time(size, pictures, &mut formats);
    formats
}

/// In turn, the least of several runs.
fn time(size: Size, pictures: &[Vec<LinSrgb<f64>>], formats: &mut [Format]) {
    let singles: Vec<_> = pictures.iter().map(|picture| single(picture)).collect();
    let mut bytes = vec![0; size.pixels() as usize * 3];
    let mut least = [f64::INFINITY; FORMATS.len()];
    for _ in 0..50 {
        for (least, (_, _, _, encode, _)) in least.iter_mut().zip(FORMATS) {
            let started = Instant::now();
            for picture in &singles {
                encode(size, black_box(picture), black_box(&mut bytes));
            }
            *least = least.min(started.elapsed().as_secs_f64());
        }
    }
    for (format, time) in formats.iter_mut().zip(least) {
        format.time = time / least[0];
    }
}

/// What a format without colour is to show: the luminance.
fn in_format(bits: u32, pixel: LinSrgb<f64>) -> LinSrgb<f64> {
    if bits > 8 {
        return pixel;
    }
    let grey = 0.2126 * pixel.red + 0.7152 * pixel.green + 0.0722 * pixel.blue;
    LinSrgb::new(grey, grey, grey)
}

fn single(picture: &[LinSrgb<f64>]) -> Vec<Rgb<f32>> {
    picture.iter().map(|pixel| Rgb::new(pixel.red as f32, pixel.green as f32, pixel.blue as f32)).collect()
}

fn light(encoded: f64) -> f64 {
    Srgb::new(encoded, encoded, encoded).into_linear().red
}

/// Means over blocks of 4×4 pixels.
fn blocks(size: Size, picture: &[LinSrgb<f64>]) -> Vec<LinSrgb<f64>> {
    let (columns, rows) = (size.width as usize / 4, size.height as usize / 4);
    let mut means = vec![LinSrgb::new(0.0, 0.0, 0.0); columns * rows];
    for (i, pixel) in picture.iter().enumerate() {
        let (x, y) = (i % size.width as usize / 4, i / size.width as usize / 4);
        if let Some(mean) = means.get_mut(y * columns + x).filter(|_| x < columns) {
            *mean += *pixel * (1.0 / 16.0);
        }
    }
    means
}

fn put(mut target: impl Framebuffer<Error = Infallible>, picture: &[Rgb<f32>]) {
    let width = target.size().width;
    for (i, &color) in (0..).zip(picture) {
        let Ok(()) = target.put(Pixel { x: i % width, y: i / width, cell: 1, color });
    }
}

fn rgb888(size: Size, picture: &[Rgb<f32>], bytes: &mut [u8]) {
    if let Ok(target) = Rgb888::new(size, bytes, Encoding::Srgb) {
        put(target, picture);
    }
}

fn rgb565(size: Size, picture: &[Rgb<f32>], bytes: &mut [u8]) {
    if let Ok(target) = Rgb565::new(size, room(bytes, size, 2), Encoding::Srgb, ByteOrder::BigEndian) {
        put(target, picture);
    }
}

fn dithered565(size: Size, picture: &[Rgb<f32>], bytes: &mut [u8]) {
    if let Ok(target) = Rgb565::new(size, room(bytes, size, 2), Encoding::Srgb, ByteOrder::BigEndian) {
        put(target.dithered(), picture);
    }
}

fn grey8(size: Size, picture: &[Rgb<f32>], bytes: &mut [u8]) {
    if let Ok(target) = Grey8::new(size, room(bytes, size, 1), Encoding::Srgb) {
        put(target, picture);
    }
}

fn mono(size: Size, picture: &[Rgb<f32>], bytes: &mut [u8]) {
    let count = size.width.div_ceil(8) as usize * size.height as usize;
    if let Ok(target) = Mono::new(size, &mut bytes[..count]) {
        put(target, picture);
    }
}

fn room(bytes: &mut [u8], size: Size, each: usize) -> &mut [u8] {
    &mut bytes[..size.pixels() as usize * each]
}

fn decode565(bytes: &[u8], width: u32, x: usize, y: usize) -> [f64; 3] {
    let at = 2 * (y * width as usize + x);
    let bits = u16::from_be_bytes([bytes[at], bytes[at + 1]]);
    [(bits >> 11, 31.0), (bits >> 5 & 63, 63.0), (bits & 31, 31.0)].map(|(level, most)| light(f64::from(level) / most))
}
