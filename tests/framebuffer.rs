//! The framebuffer adapters, driven by hand: against the formulas of the standard library and the mock display.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, missing_docs)]

#[path = "support/framebuffers.rs"]
mod framebuffers;

use std::convert::Infallible;

use framebuffers::{Counting, Failing, draw_coarse_to_fine, draw_rows};
use whit::Rgb;
use whit::render::{
    ByteOrder, Encoding, ForEach, Framebuffer, Grey8, LinearRgb, Mono, Pixel, Preview, Rgb565, Rgb888, Rgba8888, Size,
    SizeError,
};

/// Odd in both directions, over one 8×8 tile.
const SIZE: Size = Size::new(13, 11);
const PIXELS: usize = 143;

/// Each pixel differs from its neighbours and exceeds the range here and there.
fn color(x: u32, y: u32) -> Rgb<f32> {
    Rgb::new(x as f32 / 12.0, y as f32 / 9.0, (x * 7 + y * 5) as f32 % 11.0 / 10.0 - 0.1)
}

/// The transfer function as IEC 61966-2-1 has it.
fn srgb(light: f32) -> u8 {
    let light = f64::from(light).clamp(0.0, 1.0);
    let encoded = if light <= 0.0031308 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
    (encoded * 255.0).round() as u8
}

#[test]
fn srgb_is_the_formula_correctly_rounded() {
    for i in -1000..=1_001_000 {
        let light = i as f32 * 1e-6;
        assert_eq!(Encoding::Srgb.encode8(Rgb::grey(light)), [srgb(light); 3], "{light}");
    }
}

#[test]
fn srgb_is_the_formula_in_the_dark_too() {
    let mut light = f32::MIN_POSITIVE;
    while light < 1.0 {
        assert_eq!(Encoding::Srgb.encode8(Rgb::grey(light)), [srgb(light); 3], "{light}");
        light *= 1.0001;
    }
}

#[test]
fn memory_holds_each_pixel_at_its_place() {
    let mut bytes = [0; PIXELS * 3];
    draw_rows(&mut Rgb888::new(SIZE, &mut bytes, Encoding::Srgb).unwrap(), color);
    for (i, pixel) in (0..).zip(bytes.chunks_exact(3)) {
        let Rgb { r, g, b } = color(i % SIZE.width, i / SIZE.width);
        assert_eq!(pixel, [srgb(r), srgb(g), srgb(b)]);
    }
}

/// Fills memory by both orders and compares.
fn assert_order_does_not_matter(mut draw: impl FnMut(&mut [u8], bool), length: usize) {
    let (mut rows, mut cells) = (vec![0; length], vec![0; length]);
    draw(&mut rows, false);
    draw(&mut cells, true);
    assert_eq!(rows, cells);
}

fn draw<F: Framebuffer>(mut framebuffer: F, coarse_to_fine: bool) {
    if coarse_to_fine {
        draw_coarse_to_fine(&mut framebuffer, color)
    } else {
        draw_rows(&mut framebuffer, color)
    };
}

#[test]
fn memory_takes_pixels_in_any_order() {
    let srgb = Encoding::Srgb;
    assert_order_does_not_matter(|bytes, order| draw(Rgb888::new(SIZE, bytes, srgb).unwrap(), order), PIXELS * 3);
    assert_order_does_not_matter(|bytes, order| draw(Rgba8888::new(SIZE, bytes, srgb).unwrap(), order), PIXELS * 4);
    assert_order_does_not_matter(|bytes, order| draw(Grey8::new(SIZE, bytes, srgb).unwrap(), order), PIXELS);
    assert_order_does_not_matter(|bytes, order| draw(Mono::new(SIZE, bytes).unwrap(), order), 22);
    assert_order_does_not_matter(
        |bytes, order| draw(Rgb565::new(SIZE, bytes, srgb, ByteOrder::LittleEndian).unwrap().dithered(), order),
        PIXELS * 2,
    );
}

#[test]
fn the_last_preview_is_the_picture() {
    let (mut rows, mut preview) = ([0; PIXELS], [0; PIXELS]);
    draw(Grey8::new(SIZE, &mut rows, Encoding::Srgb).unwrap(), false);
    draw(Preview(Grey8::new(SIZE, &mut preview, Encoding::Srgb).unwrap()), true);
    assert_eq!(rows, preview);
}

#[test]
fn the_first_preview_covers_the_picture() {
    let mut pixels = [Rgb::BLACK; PIXELS];
    let mut preview = Preview(LinearRgb::new(SIZE, &mut pixels).unwrap());
    for (x, y) in [(0, 0), (8, 0), (0, 8), (8, 8)] {
        let Ok(()) = preview.put(Pixel { x, y, cell: 8, color: Rgb::WHITE });
    }
    assert_eq!(pixels, [Rgb::WHITE; PIXELS]);
}

#[test]
fn errors_say_what_length_is_needed() {
    let error = Rgba8888::new(SIZE, &mut [0; 3], Encoding::Srgb).unwrap_err();
    assert_eq!(error.to_string(), "the picture needs a buffer of 572 bytes, not of 3");
    let error = LinearRgb::new(SIZE, &mut [Rgb::BLACK; 144]).unwrap_err();
    assert_eq!(error, SizeError { expected: 143, found: 144, unit: "pixels" });
    let error: Box<dyn std::error::Error> = Box::new(error);
    assert_eq!(error.to_string(), "the picture needs a buffer of 143 pixels, not of 144");
}

/// The wrappers that other tests rely on.
mod wrappers {
    use super::*;

    fn sink() -> ForEach<impl FnMut(Pixel) -> Result<(), Infallible>> {
        ForEach::new(SIZE, |_| Ok(()))
    }

    #[test]
    fn counting_counts_each_pixel_once() {
        for coarse_to_fine in [false, true] {
            let mut counting = Counting::new(sink());
            draw(&mut counting, coarse_to_fine);
            assert!(counting.pixels.iter().all(|&count| count == 1));
            // From coarse to fine row 8 belongs to all four passes, row 1 to the last one only.
            assert_eq!([counting.rows[8], counting.rows[1]], if coarse_to_fine { [4, 1] } else { [1, 1] });
        }
        let mut counting = Counting::new(sink());
        counting.put(Pixel { x: 3, y: 2, cell: 1, color: Rgb::BLACK }).unwrap();
        assert_eq!([counting.pixel(3, 2), counting.pixel(2, 3)], [1, 0]);
    }

    #[test]
    fn failing_fails_once() {
        let calls = (SIZE.width as u64 + 1) * SIZE.height as u64;
        for fail_on in 0..calls {
            let mut failing = Failing::new(Counting::new(sink()), fail_on);
            assert_eq!(draw_rows(&mut failing, color), 1);
            assert_eq!(failing.calls(), calls + 1);
            assert!(failing.inner.pixels.iter().all(|&count| count == 1));
        }
    }
}

#[cfg(feature = "embedded-graphics")]
mod draw_targets {
    use embedded_graphics::Pixel as DrawnPixel;
    use embedded_graphics::mock_display::MockDisplay;
    use embedded_graphics::pixelcolor::{BinaryColor, Rgb565 as Color565, RgbColor};
    use embedded_graphics::prelude::{Dimensions, DrawTarget, DrawTargetExt, Point, PointsIter, Size as Extent};
    use embedded_graphics::primitives::Rectangle;
    use whit::render::{DisplayColor, Dithered, DrawTargetCells, DrawTargetLines, LineError, PlacementError};

    use super::*;

    const AT: Point = Point::new(20, 31);

    /// What the display must show: `color` encoded by the formula, at `AT` and nowhere else.
    fn assert_shows_the_picture(display: &MockDisplay<Color565>) {
        let to = |light, max: f64| (f64::from(srgb(light)) * max / 255.0).round() as u8;
        for point in display.bounding_box().points() {
            let Point { x, y } = point - AT;
            let inside = (0..SIZE.width as i32).contains(&x) && (0..SIZE.height as i32).contains(&y);
            let expected = inside.then(|| {
                let Rgb { r, g, b } = color(x as u32, y as u32);
                Color565::new(to(r, 31.0), to(g, 63.0), to(b, 31.0))
            });
            assert_eq!(display.get_pixel(point), expected, "{point}");
        }
    }

    fn lines<'a, D: DrawTarget<Color = Color565>>(
        display: &'a mut D,
        line: &'a mut [Color565],
    ) -> DrawTargetLines<'a, D> {
        DrawTargetLines::new(display, SIZE, line, Encoding::Srgb).unwrap().at(AT).unwrap()
    }

    /// The mock display panics when a pixel is drawn twice or outside.
    #[test]
    fn lines_draw_each_pixel_once() {
        let mut display = MockDisplay::new();
        // The line is longer than needed.
        draw(lines(&mut display, &mut [Color565::RED; 20]), false);
        assert_shows_the_picture(&display);
    }

    #[test]
    fn lines_may_start_at_any_row() {
        let mut display = MockDisplay::new();
        let mut line = [Color565::RED; 13];
        let mut picture = lines(&mut display, &mut line);
        for y in (5..11).chain(0..5) {
            for x in 0..13 {
                picture.put(Pixel { x, y, cell: 1, color: color(x, y) }).unwrap();
            }
            picture.end_row(y).unwrap();
        }
        assert_shows_the_picture(&display);
    }

    #[test]
    fn a_new_adapter_goes_on_in_the_middle_of_a_row() {
        let mut display = MockDisplay::new();
        let mut line = [Color565::RED; 13];
        for y in 0..11 {
            for x in 0..13 {
                let pixel = Pixel { x, y, cell: 1, color: color(x, y) };
                lines(&mut display, &mut line).put(pixel).unwrap();
            }
            lines(&mut display, &mut line).end_row(y).unwrap();
        }
        assert_shows_the_picture(&display);
    }

    /// Draws by `fill_contiguous` only; fails when its turn comes.
    struct Unreliable {
        inner: MockDisplay<Color565>,
        calls: u32,
        fail_on: u32,
    }

    impl Dimensions for Unreliable {
        fn bounding_box(&self) -> Rectangle {
            self.inner.bounding_box()
        }
    }

    impl DrawTarget for Unreliable {
        type Color = Color565;
        type Error = &'static str;

        fn draw_iter<I: IntoIterator<Item = DrawnPixel<Color565>>>(&mut self, _: I) -> Result<(), Self::Error> {
            panic!("rows are sent as rows");
        }

        fn fill_contiguous<I: IntoIterator<Item = Color565>>(
            &mut self,
            area: &Rectangle,
            colors: I,
        ) -> Result<(), Self::Error> {
            self.calls += 1;
            if self.calls == self.fail_on {
                return Err("bus");
            }
            self.inner.fill_contiguous(area, colors).map_err(|never| match never {})
        }
    }

    #[test]
    fn a_row_that_failed_is_sent_again() {
        for fail_on in 1..=SIZE.height {
            let mut display = Unreliable { inner: MockDisplay::new(), calls: 0, fail_on };
            let mut line = [Color565::RED; 13];
            let failures = draw_rows(&mut lines(&mut display, &mut line), color);
            assert_eq!((failures, display.calls), (1, SIZE.height + 1));
            assert_shows_the_picture(&display.inner);
        }
    }

    #[test]
    fn errors_are_those_of_the_target() {
        let mut display = Unreliable { inner: MockDisplay::new(), calls: 0, fail_on: 1 };
        let error = lines(&mut display, &mut [Color565::RED; 13]).end_row(0).unwrap_err();
        assert_eq!(error, LineError::Target("bus"));
        assert_eq!(error.to_string(), "draw target: bus");
    }

    #[test]
    fn lines_refuse_coarse_pixels() {
        let mut display = MockDisplay::new();
        let mut line = [Color565::RED; 13];
        let mut picture = lines(&mut display, &mut line);
        for cell in [8, 4, 2] {
            let pixel = Pixel { x: 0, y: 0, cell, color: Rgb::WHITE };
            assert_eq!(picture.put(pixel), Err(LineError::CoarsePixel));
        }
        assert_eq!(line, [Color565::RED; 13]);
    }

    #[test]
    fn lines_ignore_what_is_outside() {
        let mut display = MockDisplay::new();
        let mut line = [Color565::RED; 14];
        let mut picture = lines(&mut display, &mut line);
        for x in [13, u32::MAX] {
            picture.put(Pixel { x, y: 0, cell: 1, color: Rgb::WHITE }).unwrap();
        }
        for y in [11, u32::MAX] {
            picture.end_row(y).unwrap();
        }
        assert_eq!(line, [Color565::RED; 14]);
        assert_eq!(display.affected_area(), Rectangle::zero());
    }

    #[test]
    fn cells_end_with_the_picture() {
        let mut display = MockDisplay::new();
        display.set_allow_overdraw(true);
        draw(DrawTargetCells::new(&mut display, SIZE, Encoding::Srgb).unwrap().at(AT).unwrap(), true);
        assert_shows_the_picture(&display);
    }

    #[test]
    fn cells_draw_each_pixel_once_row_by_row() {
        let mut display = MockDisplay::new();
        draw(DrawTargetCells::new(&mut display, SIZE, Encoding::Srgb).unwrap().at(AT).unwrap(), false);
        assert_shows_the_picture(&display);
    }

    /// Without overdraw allowed: the cells of one pass must not overlap.
    #[test]
    fn cells_preview_the_picture_and_stay_inside() {
        let mut display = MockDisplay::new();
        let mut picture =
            DrawTargetCells::new(&mut display, SIZE, Encoding::Srgb).unwrap().at(Point::new(51, 53)).unwrap();
        for (x, y) in [(0, 0), (8, 0), (0, 8), (8, 8), (13, 0), (0, 11), (16, 16)] {
            picture.put(Pixel { x, y, cell: 8, color: color(x, y) }).unwrap();
        }
        let area = Rectangle::new(Point::new(51, 53), Extent::new(13, 11));
        assert_eq!(display.affected_area(), area);
        let first: Color565 = Encoding::Srgb.display_color(&Pixel { x: 0, y: 0, cell: 8, color: color(0, 0) });
        assert_eq!(display.get_pixel(Point::new(58, 60)), Some(first));
        assert!(area.points().all(|point| display.get_pixel(point).is_some()));
    }

    /// Coarse pixels are at multiples of 8, where the threshold is the lowest one.
    #[test]
    fn dithered_cells_keep_the_mean() {
        let mut display = MockDisplay::<BinaryColor>::new();
        let mut picture = DrawTargetCells::new(&mut display, SIZE, Encoding::Srgb).unwrap();
        picture.put(Pixel { x: 0, y: 0, cell: 8, color: Rgb::grey(0.25) }).unwrap();
        picture.put(Pixel { x: 8, y: 0, cell: 8, color: Rgb::grey(0.5) }).unwrap();
        // The 16 lowest ranks of Bayer's matrix are in its even rows and columns, the next 16 in the odd ones.
        let rows = ["#.#.#.#.#.#.#", ".........#.#."];
        display.assert_pattern(&[rows, rows, rows, rows].concat());
    }

    /// The target's coordinates need not begin at (0, 0).
    #[test]
    fn the_default_place_is_the_upper_left_of_the_target() {
        let mut display = MockDisplay::<BinaryColor>::new();
        let mut part = display.clipped(&Rectangle::new(Point::new(2, 1), Extent::new(3, 2)));
        let mut line = [BinaryColor::Off; 3];
        let size = Size::new(3, 2);
        draw_rows(&mut DrawTargetLines::new(&mut part, size, &mut line, Encoding::Srgb).unwrap(), |_, _| Rgb::WHITE);
        display.assert_pattern(&["     ", "  ###", "  ###"]);
    }

    #[test]
    fn one_bit_is_dithered_by_the_picture_s_own_coordinates() {
        let mut display = MockDisplay::<BinaryColor>::new();
        let mut line = [BinaryColor::Off; 4];
        let size = Size::new(4, 4);
        let mut picture =
            DrawTargetLines::new(&mut display, size, &mut line, Encoding::Srgb).unwrap().at(Point::new(1, 1)).unwrap();
        draw_rows(&mut picture, |_, _| Rgb::grey(0.5));
        // Ranks below 32 of Bayer's matrix are lit.
        display.assert_pattern(&["     ", " #.#.", " .#.#", " #.#.", " .#.#"]);
    }

    #[test]
    fn dithering_and_closures_are_colors_too() {
        let mut line = [Color565::RED; 8];
        let size = Size::new(8, 8);
        let mut display = MockDisplay::new();
        let mut picture = DrawTargetLines::new(&mut display, size, &mut line, Dithered(Encoding::Display)).unwrap();
        draw_rows(&mut picture, |_, _| Rgb::grey(128.0 / 255.0));
        let mut sum = 0;
        for point in Rectangle::new(Point::zero(), Extent::new(8, 8)).points() {
            sum += u32::from(display.get_pixel(point).unwrap().g());
        }
        assert!((f64::from(sum) / 64.0 - 128.0 / 255.0 * 63.0).abs() <= 1.0 / 64.0);

        let mut display = MockDisplay::new();
        let column = |pixel: &Pixel| Color565::new(pixel.x as u8, 0, 0);
        draw_rows(&mut DrawTargetLines::new(&mut display, size, &mut line, column).unwrap(), |_, _| Rgb::BLACK);
        assert_eq!(display.get_pixel(Point::new(5, 3)), Some(Color565::new(5, 0, 0)));
    }

    #[test]
    fn pictures_that_do_not_fit_are_errors() {
        let mut display = MockDisplay::<Color565>::new(); // 64 × 64
        let mut line = [Color565::RED; 100];
        let error = DrawTargetLines::new(&mut display, Size::new(65, 64), &mut line, Encoding::Srgb).map(|_| ());
        assert!(matches!(error, Err(PlacementError::Outside { .. })));
        let error = DrawTargetLines::new(&mut display, SIZE, &mut line[..12], Encoding::Srgb).map(|_| ()).unwrap_err();
        assert_eq!(error, PlacementError::Line(SizeError { expected: 13, found: 12, unit: "pixels" }));
        let picture = DrawTargetLines::new(&mut display, SIZE, &mut line, Encoding::Srgb).unwrap();
        assert!(picture.at(Point::new(52, 0)).is_err());
        assert!(DrawTargetCells::new(&mut display, Size::new(64, 65), Encoding::Srgb).is_err());
        let picture = DrawTargetCells::new(&mut display, SIZE, Encoding::Srgb).unwrap();
        assert!(picture.at(Point::new(0, -1)).is_err());
    }
}
