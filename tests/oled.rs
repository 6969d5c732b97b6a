//! The `oled` example: its driver, and what an emulated board has on its display, pixel by pixel.
#![cfg(all(unix, feature = "embedded-graphics"))]
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

#[allow(dead_code)]
#[path = "../examples/firmware/choice.rs"]
mod choice;
#[path = "support/emulator.rs"]
mod emulator;
#[path = "../examples/oled/host.rs"]
mod host;
#[path = "../examples/oled/screen.rs"]
mod screen;
#[path = "../examples/oled/ssd0323.rs"]
mod ssd0323;

use std::cell::RefCell;
use std::convert::Infallible;
use std::io::{BufRead, BufReader, Write};
use std::os::unix::net::UnixStream;
use std::path::Path;
use std::process::Command;

use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::image::GetPixel;
use embedded_graphics::pixelcolor::Gray4;
use embedded_graphics::pixelcolor::raw::{BigEndian, RawU4};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::{Operation, SpiDevice};
use emulator::Emulator;
use ssd0323::Ssd0323;

const TARGET: &str = "thumbv7m-none-eabi";
const QEMU: &str = "qemu-system-arm";

/// The picture of the README is written by
///
///     WHIT_SCREENDUMP=docs/images/oled.png cargo test --all-features --test oled
#[test]
fn the_display_shows_what_is_drawn_in_memory() {
    if !emulator::is_installed(TARGET, QEMU) {
        return;
    }
    let firmware = emulator::build("oled", TARGET, &["--features", "embedded-graphics"]);
    let folder = tempfile::tempdir().unwrap();
    let (socket, dump) = (folder.path().join("qmp"), folder.path().join("dump.ppm"));
    let qemu = Emulator::start(
        Command::new(QEMU)
            .args(["-M", "lm3s6965evb", "-display", "none", "-serial", "none"])
            .args(["-semihosting-config", "enable=on,target=native"])
            .args(["-qmp", &format!("unix:{},server=on,wait=off", socket.display())])
            .arg("-kernel")
            .arg(firmware),
    );
    let lines = qemu.lines_until(|line| line == "drawn");
    assert_eq!(lines.last().map(String::as_str), Some("drawn"), "{lines:#?}");
    dump_screen(&socket, &dump);

    let shown = image::open(dump).unwrap().into_rgb8();
    if let Ok(name) = std::env::var("WHIT_SCREENDUMP") {
        image::DynamicImage::from(shown.clone()).into_luma8().save(name).unwrap();
    }
    let expected = host::picture().unwrap();
    assert_eq!(shown.dimensions(), expected.dimensions());
    let other = shown.enumerate_pixels().zip(expected.pixels()).filter(|((.., shown), grey)| shown.0 != [grey[0]; 3]);
    let other: Vec<_> = other.collect();
    assert!(other.is_empty(), "{} pixels differ, first {:?}", other.len(), other[0]);
}

/// By the QEMU Machine Protocol, which answers when the file is written; the display is updated for it.
fn dump_screen(socket: &Path, file: &Path) {
    let mut stream = UnixStream::connect(socket).unwrap();
    let mut answers = BufReader::new(stream.try_clone().unwrap()).lines();
    let dump = serde_json::json!({ "execute": "screendump", "arguments": { "filename": file } });
    for command in [serde_json::json!({ "execute": "qmp_capabilities" }), dump] {
        writeln!(stream, "{command}").unwrap();
        let answer = answers.find(|line| ["return", "error"].iter().any(|key| line.as_ref().unwrap().contains(key)));
        let answer: serde_json::Value = serde_json::from_str(&answer.unwrap().unwrap()).unwrap();
        assert!(answer.get("return").is_some(), "{answer}");
    }
}

#[test]
fn a_display_that_is_too_small_stays_as_it_was() {
    let mut display = Framebuffer::<Gray4, RawU4, BigEndian, 128, 48, { buffer_size::<Gray4>(128, 48) }>::new();
    display.clear(Gray4::new(5)).unwrap();
    let error = screen::draw(&mut display).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the picture of 128 × 56 pixels at (0, 0) is not within the target's 128 × 40 at (0, 0)"
    );
    assert!(display.bounding_box().points().all(|place| display.pixel(place) == Some(Gray4::new(5))));
}

/// What came over the bus, and whether each part of it was data.
#[derive(Default)]
struct Recorder {
    is_data: bool,
    writes: Vec<(bool, Vec<u8>)>,
}

struct Wire<'a>(&'a RefCell<Recorder>);

impl embedded_hal::digital::ErrorType for Wire<'_> {
    type Error = Infallible;
}

impl OutputPin for Wire<'_> {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().is_data = false;
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().is_data = true;
        Ok(())
    }
}

impl embedded_hal::spi::ErrorType for Wire<'_> {
    type Error = Infallible;
}

impl SpiDevice for Wire<'_> {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        let mut recorder = self.0.borrow_mut();
        for operation in operations {
            let Operation::Write(bytes) = operation else { panic!("nothing can be read from the display") };
            let is_data = recorder.is_data;
            recorder.writes.push((is_data, bytes.to_vec()));
        }
        Ok(())
    }
}

/// What is sent for a drawing on a display that shows level 5 everywhere.
fn sent(draw: impl FnOnce(&mut Ssd0323<'_, Wire<'_>, Wire<'_>>)) -> Vec<(bool, Vec<u8>)> {
    let recorder = RefCell::default();
    let mut memory = [0; ssd0323::BYTES];
    let mut display = Ssd0323::start(Wire(&recorder), Wire(&recorder), &mut memory).unwrap();
    display.clear(Gray4::new(5)).unwrap();
    recorder.borrow_mut().writes.clear();
    draw(&mut display);
    recorder.into_inner().writes
}

#[test]
fn a_row_is_one_window() {
    let row = Rectangle::new(Point::new(0, 9), Size::new(128, 1));
    let writes = sent(|display| display.fill_contiguous(&row, (0..128).map(|x| Gray4::new(x % 16))).unwrap());
    let pixels = [0x01, 0x23, 0x45, 0x67, 0x89, 0xAB, 0xCD, 0xEF].repeat(8);
    assert_eq!(writes, [(false, vec![0x15, 0, 63]), (false, vec![0x75, 9, 9]), (true, pixels)]);
}

#[test]
fn the_other_pixel_of_a_byte_stays() {
    let dot = |x, y| Pixel(Point::new(x, y), Gray4::new(15));
    let dots = [dot(6, 3), dot(9, 63), dot(-1, 3), dot(128, 3), dot(0, 64)];
    let writes = sent(|display| display.draw_iter(dots).unwrap());
    let expected =
        [[vec![0x15, 3, 3], vec![0x75, 3, 3], vec![0xF5]], [vec![0x15, 4, 4], vec![0x75, 63, 63], vec![0x5F]]];
    assert_eq!(writes.into_iter().map(|(_, bytes)| bytes).collect::<Vec<_>>(), expected.concat());
}

#[test]
fn areas_are_cut_off_at_the_edges() {
    let corner = Rectangle::new(Point::new(125, -1), Size::new(5, 2));
    let writes = sent(|display| display.fill_contiguous(&corner, (1..11).map(Gray4::new)).unwrap());
    assert_eq!(writes, [(false, vec![0x15, 62, 63]), (false, vec![0x75, 0, 0]), (true, vec![0x56, 0x78])]);
    assert!(sent(|display| display.fill_solid(&Rectangle::zero(), Gray4::new(1)).unwrap()).is_empty());
}
