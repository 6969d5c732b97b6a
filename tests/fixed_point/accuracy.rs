//! The built-in scenes against `f64`: the same rays, in pictures of 160×120 pixels with a sample each.
//!
//! What is off is at edges, where a ray falls on the one side or the other, and at the horizon: light is not followed beyond
//! eight times the largest coordinate, which is 512 in `Q20`. So besides the error and the share of pixels that are off, those
//! are counted whose light is nowhere near in the exact picture.

use rayon::prelude::*;
use whit::math::{Q16, Q20};
use whit::render::{LinearRgb, Size};
use whit::{Frame, Real, Rgb, Scene, Settings, Tracer, scenes};

use super::{ALL, Buffer};

const SIZE: Size = Size::new(160, 120);
const PIXELS: usize = 160 * 120;
/// The difference that a pixel of 8 bits shows.
const STEP: f32 = 1.0 / 255.0;

/// How far a picture is from the exact one; channels are held at 1.
#[derive(Clone, Copy, Debug)]
struct Distance {
    /// The root of the mean square.
    error: f32,
    /// The share of pixels of which a channel is off by more than a step, in percent.
    off: f32,
    /// The number of pixels of which a channel is off by more than two steps from all that the exact picture has in the nine
    /// pixels there.
    strange: usize,
}

/// What is expected of a scene in one number type.
#[derive(Clone, Copy)]
enum Expected {
    /// No more than this.
    Near(f32, f32, usize),
    /// This is what is said of it.
    Refused(&'static str),
}

use Expected::{Near, Refused};

const BENT: Expected = Refused("scene: profiles: expected nothing that bends light, in fixed point");
const HOLE: Expected = Refused("scene: black_hole: expected nothing that bends light, in fixed point");

/// For each scene, in `Q16` and in `Q20`.
const EXPECTED: [(&str, [Expected; 2]); 19] = [
    ("showcase", [Near(2.0e-02, 1.3, 17), Near(1.7e-02, 1.2, 0)]),
    ("spheres", [Near(9.9e-03, 0.41, 2), Near(9.7e-03, 0.52, 3)]),
    ("mirrors", [Near(1.5e-02, 0.4, 0), Near(3.2e-03, 0.026, 0)]),
    ("flake", [Near(9.6e-03, 1.1, 25), Near(5.8e-03, 0.16, 2)]),
    ("card", [Near(2.5e-02, 0.94, 31), Near(6.9e-02, 1.1, 142)]),
    ("metals", [Near(8.2e-03, 0.13, 2), Near(1.5e-05, 0.0, 0)]),
    ("window", [Near(3.4e-05, 0.0, 0), Refused("object 2: min: expected a number from -64 to 64")]),
    ("glass", [Near(8.7e-03, 0.45, 2), Near(2.2e-04, 0.013, 0)]),
    ("deep", [Near(7.9e-03, 0.11, 3), Near(7.7e-03, 0.013, 3)]),
    ("tints", [Near(6.1e-03, 0.057, 2), Near(1.6e-05, 0.0, 0)]),
    ("bubble", [Near(1.7e-03, 0.11, 0), Near(1.9e-05, 0.0, 0)]),
    ("oil", [Near(3.3e-03, 0.051, 2), Near(6.4e-06, 0.0, 0)]),
    ("titanium", [Near(2.0e-03, 0.12, 0), Near(1.3e-03, 1.1, 0)]),
    ("prism", [Near(9.6e-04, 0.13, 3), Near(3.6e-04, 0.013, 0)]),
    ("mirage", [BENT; 2]),
    ("ship", [BENT; 2]),
    ("sunset", [BENT; 2]),
    ("lenses", [BENT; 2]),
    ("hole", [HOLE; 2]),
];

fn render<T: Real>(scene: &Scene<'static, f32>) -> Result<Vec<[f32; 3]>, String> {
    let scene = Box::new(Buffer::<T>::from_scene(scene, T::from_f32).unwrap());
    let scene = scene.as_scene();
    let tracer = Tracer::<T, ALL, 10, 8>::try_new(&scene).map_err(|error| error.to_string())?;
    let mut pixels = vec![Rgb::BLACK; PIXELS];
    let mut target = LinearRgb::new(SIZE, &mut pixels).unwrap();
    Frame::new(&tracer, Settings::new(SIZE.width, SIZE.height).with_depth(5)).unwrap().render(&mut target).unwrap();
    Ok(pixels.into_iter().map(|Rgb { r, g, b }| [r, g, b].map(|x| x.clamp(0.0, 1.0))).collect())
}

fn distance(found: &[[f32; 3]], exact: &[[f32; 3]]) -> Distance {
    let off = |i: usize| (0..3).map(|c| (found[i][c] - exact[i][c]).abs()).fold(0.0, f32::max);
    let squares: f32 = (0..PIXELS).map(|i| off(i) * off(i)).sum();
    Distance {
        error: (squares / PIXELS as f32).sqrt(),
        off: (0..PIXELS).filter(|&i| off(i) > STEP).count() as f32 / PIXELS as f32 * 100.0,
        strange: (0..PIXELS).filter(|&i| is_strange(found[i], exact, i)).count(),
    }
}

fn is_strange(found: [f32; 3], exact: &[[f32; 3]], place: usize) -> bool {
    let (width, height) = (SIZE.width as usize, SIZE.height as usize);
    let (x, y) = (place % width, place / width);
    let around = |at: usize, end: usize| at.saturating_sub(1)..(at + 2).min(end);
    let near: Vec<_> =
        around(y, height).flat_map(|y| around(x, width).map(move |x| y * width + x)).map(|i| exact[i]).collect();
    (0..3).any(|c| {
        let [low, high] = [f32::min, f32::max].map(|f| near.iter().map(|pixel| pixel[c]).reduce(f).unwrap());
        found[c] < low - 2.0 * STEP || found[c] > high + 2.0 * STEP
    })
}

/// What is wrong.
fn fault<T: Real>(scene: &Scene<'static, f32>, exact: &[[f32; 3]], expected: Expected) -> Option<String> {
    let seen = render::<T>(scene).map(|found| distance(&found, exact));
    let is_held = match (&seen, expected) {
        (Ok(Distance { error, off, strange }), Near(a, b, c)) => *error <= a && *off <= b && *strange <= c,
        (Err(said), Refused(reason)) => said == reason,
        _ => false,
    };
    (!is_held).then(|| format!("{seen:?}"))
}

#[test]
fn built_in_scenes_are_near_the_exact_ones() {
    let names: Vec<_> = scenes::ALL.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, EXPECTED.map(|(name, _)| name), "every scene is decided upon");
    let faults: Vec<_> = scenes::ALL
        .par_iter()
        .zip(EXPECTED)
        .flat_map_iter(|((name, scene), (_, [q16, q20]))| {
            let exact = match q16 {
                Near(..) => render::<f64>(scene).unwrap(),
                Refused(_) => Vec::new(),
            };
            let of =
                |number: &'static str, fault: Option<String>| fault.map(|fault| format!("{name} {number}: {fault}"));
            [of("Q16", fault::<Q16>(scene, &exact, q16)), of("Q20", fault::<Q20>(scene, &exact, q20))]
        })
        .flatten()
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
