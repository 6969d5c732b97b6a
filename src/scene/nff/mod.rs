//! The reader of Neutral File Format (feature `nff`).
//!
//! [`read`] fills a [`SceneBuf`](super::SceneBuf) from text, without memory of its own but the stack: the text is read once to check and
//! count everything, and once more to fill the buffer. The stack holds one polygon, about 7 KB.
//!
//! ```
//! use whit::{Background, Camera, SceneBuf, Vec3};
//! let text = "
//! b 0.1 0.4 0.8
//! v
//! from 0 -5 1
//! at 0 0 0
//! up 0 0 1
//! angle 45
//! resolution 128 128
//! l 4 -3 5
//! f 0.7 0.7 0.7 1 0 0 0 0  # r g b Kd Ks Shine T ior
//! p 4
//! 9 9 -1
//! -9 9 -1
//! -9 -9 -1
//! 9 -9 -1
//! f 1 0.9 0.7 0.5 0.5 3 0 0
//! s 0 0 0 1
//! ";
//! let camera = Camera::look_at(Vec3::ZERO, Vec3::new(0.0, 0.0, -1.0), Vec3::new(0.0, 1.0, 0.0), 40.0);
//! let mut scene = SceneBuf::<f32, 8, 1>::new(camera, Background::Solid(whit::Rgb::BLACK));
//! let summary = whit::scene::nff::read(text, &mut scene)?;
//! assert_eq!((summary.size.width, summary.objects, summary.lights), (128, 3, 1)); // The square is two triangles.
//!
//! let error = whit::scene::nff::read(&text.replace("s 0 0 0 1", "s 0 0 0"), &mut scene).unwrap_err();
//! assert_eq!(error.to_string(), "line 17: expected a number for `radius`, found the end of the line");
//! # Ok::<(), whit::scene::nff::NffError>(())
//! ```
//!
//! # What becomes of an entity
//!
//! | entity | becomes |
//! |---|---|
//! | `v` | the camera, with [`Extent::PixelCentres`](super::Extent::PixelCentres), and [`Summary::size`]; `hither` is ignored |
//! | `b` | the background; black without it |
//! | `l` | a point light; without a colour, grey 1/√(number of lights) |
//! | `f` | a diffuse body with Kd, unless that is 0; a highlight ([`Lobe::Blinn`](super::Lobe::Blinn)) if Ks > 0; [`Interface::Constant`](super::Interface::Constant) if T > 0, else [`Interface::Mirror`](super::Interface::Mirror) if Ks > 0, both reflecting Ks; objects are seen from outside only unless T > 0 |
//! | `s`, `c` | a sphere, an open cone |
//! | `p`, `pp` | triangles, smooth triangles: n − 2 of them for n vertices |
//!
//! A polygon has at most [`MAX_VERTICES`] vertices. It may be concave; one without area is nothing to draw; of one that
//! crosses itself most is drawn. Lines may end in CR LF. There is one `v`, and at most one `b`.

mod entities;
mod error;
mod lines;
mod polygon;
mod surface;
mod view;

pub use error::{Found, NffError, Problem, Word};

use self::entities::{Item, Reader};
use self::view::View;
use super::{Background, Effects, Light, SceneStore};
use crate::math::{Real, Rgb};
use crate::render::Size;

/// All effects that a file can call for: a [`Tracer`](crate::Tracer) for these traces every scene that [`read`] makes.
pub const EFFECTS: Effects = Effects::SPHERE
    .with(Effects::TRIANGLE)
    .with(Effects::SMOOTH_TRIANGLE)
    .with(Effects::CONE)
    .with(Effects::ONE_SIDED)
    .with(Effects::BODY)
    .with(Effects::BLINN)
    .with(Effects::INTEGER_EXPONENT)
    .with(Effects::REAL_EXPONENT)
    .with(Effects::MIRROR)
    .with(Effects::CONSTANT)
    .with(Effects::POINT_LIGHT);

/// The most vertices of one polygon or patch.
pub const MAX_VERTICES: usize = 256;

// What the documentation of this module and of `read` says about the stack.
const _: () = assert!(size_of::<Reader<'_>>() < 7 * 1024);

/// What a file holds beside the scene itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Summary {
    /// The size of the picture.
    pub size: Size,
    /// How many objects the scene has, every triangle of a polygon counted.
    pub objects: usize,
    /// How many lights it has.
    pub lights: usize,
}

/// Replaces all of `scene` by what `text` describes.
///
/// # Errors
/// The first line that does not keep to the format or holds what no scene may hold. Of a text without such a line, the
/// first object, else the first light that there is no room for, with the number of objects or lights in all. The
/// scene is as before.
pub fn read(text: &str, scene: &mut impl SceneStore) -> Result<Summary, NffError> {
    let mut reader = Reader::new(text);
    let survey = Survey::of(&mut reader, scene.room())?;
    let (objects, lights) = (survey.objects.needed, survey.lights.needed);
    scene.restart(survey.view.camera, Background::Solid(survey.background));
    let grey = Rgb::grey(1.0 / Real::sqrt(lights as f32));
    reader.start_again(text);
    while let Some(item) = reader.next_item()? {
        let added = match item {
            Item::Object(object) => scene.add_object(object),
            Item::Light { position, color } => scene.add_light(Light::point(position, color.unwrap_or(grey))),
            Item::View(_) | Item::Background(_) => Ok(()),
        };
        // The survey has found the room sufficient.
        added.map_err(|full| NffError::no_room(reader.line(), full.what, full.capacity + 1, full.capacity))?;
    }
    Ok(Summary { size: survey.view.size, objects, lights })
}

/// The same as [`read`] for bytes of which nobody has checked that they are text.
///
/// # Errors
/// As for [`read`]; [`Problem::NotUtf8`] before anything else.
pub fn read_bytes(bytes: &[u8], scene: &mut impl SceneStore) -> Result<Summary, NffError> {
    match core::str::from_utf8(bytes) {
        Ok(text) => read(text, scene),
        Err(error) => {
            let line = 1 + bytes.iter().take(error.valid_up_to()).filter(|&&byte| byte == b'\n').count();
            Err(NffError { line, problem: Problem::NotUtf8 })
        }
    }
}

/// What must be known before the buffer is touched.
struct Survey {
    view: View,
    background: Rgb<f32>,
    objects: Demand,
    lights: Demand,
}

impl Survey {
    /// Reads all of a text, so that every error comes up.
    fn of(reader: &mut Reader<'_>, (room_for_objects, room_for_lights): (usize, usize)) -> Result<Self, NffError> {
        let (mut view, mut background) = (None, None);
        let (mut objects, mut lights) = (Demand::new(room_for_objects), Demand::new(room_for_lights));
        while let Some(item) = reader.next_item()? {
            let line = reader.line();
            match item {
                Item::View(v) => set_once(&mut view, v, line, "only one view", "v")?,
                Item::Background(color) => set_once(&mut background, color, line, "only one background", "b")?,
                Item::Light { .. } => lights.add(line),
                Item::Object(_) => objects.add(line),
            }
        }
        let view = view.ok_or_else(|| reader.missing("a view `v`"))?;
        objects.check("objects")?;
        lights.check("lights")?;
        Ok(Self { view, background: background.unwrap_or(Rgb::BLACK), objects, lights })
    }
}

fn set_once<T>(
    slot: &mut Option<T>,
    value: T,
    line: usize,
    expected: &'static str,
    found: &str,
) -> Result<(), NffError> {
    match slot.replace(value) {
        Some(_) => Err(NffError::unexpected(line, expected, Found::Word(found.into()))),
        None => Ok(()),
    }
}

/// How many of something there are, and where they exceed the room for them.
struct Demand {
    needed: usize,
    room: usize,
    first_without_room: usize,
}

impl Demand {
    fn new(room: usize) -> Self {
        Self { needed: 0, room, first_without_room: 0 }
    }

    fn add(&mut self, line: usize) {
        if self.needed == self.room {
            self.first_without_room = line;
        }
        self.needed += 1;
    }

    fn check(&self, what: &'static str) -> Result<(), NffError> {
        if self.needed <= self.room {
            return Ok(());
        }
        Err(NffError::no_room(self.first_without_room, what, self.needed, self.room))
    }
}
