//! Anodised titanium: colours without a pigment.

use super::UP;
use crate::math::{Rgb, Vec3};
use crate::optics::materials::{TITANIUM as METAL, TITANIUM_DIOXIDE};
use crate::optics::{Band, bands};
use crate::scene::{Background, Camera, Film, Material, Object, Scene, Shape, Spectrum, Thickness};

/// Titanium balls in front of a titanium bar, under a clear oxide that grows thicker from left to right.
///
/// The oxide of the bar goes from 0 to 180 nm, and each ball has the oxide of the place of the bar behind it. No dye is
/// in it: bronze, blue, pale steel, yellow, magenta and turquoise are what interference leaves, in the order in which
/// they come up when titanium is anodised with a rising voltage. Where one is seen at a slant, it has the colour of a
/// thinner oxide.
pub const TITANIUM: Scene<'static, f32> = Scene::new(CAMERA, ROOM).with_objects(&OBJECTS);

const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 3.5, 10.6), Vec3::new(0.0, 0.8, 0.0), UP, 31.5);

const ROOM: Background<f32> = Background::Gradient { below: Rgb::grey(0.02), above: Rgb::new(0.8, 0.84, 0.88), up: UP };

const BARE: Material<f32> = Material::conductor(METAL.index, METAL.extinction);

/// The oxide at x = 0, and how much thicker it is for each unit to the right, in nanometres.
const MIDDLE: f32 = 90.0;
const SLOPE: f32 = 25.0;

/// Enough of the spectrum for thin films. The table would take the metal's index for one in each channel; it changes
/// over each.
static BANDS: [Band; 16] = bands();
const OXIDE: Film<f32> = Film::new(TITANIUM_DIOXIDE, 0.0).with_spectrum(Spectrum::Bands(&BANDS));

const fn ball(x: f32) -> Object<'static, f32> {
    let film = OXIDE.with_thickness(Thickness::Uniform(MIDDLE + SLOPE * x));
    Object::new(Shape::sphere(Vec3::new(x, 0.45, 0.6), 0.45), BARE.with_film(film))
}

const SERIES: Film<f32> = OXIDE.with_thickness(Thickness::Gradient {
    from: 0.0,
    to: 2.0 * MIDDLE,
    origin: Vec3::new(-MIDDLE / SLOPE, 0.0, 0.0),
    axis: Vec3::new(0.5 * SLOPE / MIDDLE, 0.0, 0.0),
});
const BAR: Shape<'static, f32> = Shape::cylinder(Vec3::new(-3.6, 1.1, -1.2), Vec3::new(3.6, 1.1, -1.2), 1.1).capped();

const LAMP: Material<f32> = Material::matte(Rgb::grey(2.0)).with_shares(1.0, 0.0, 0.0);
const TABLE: Material<f32> = Material::matte(Rgb::BLACK).with_coat(1.5);

const OBJECTS: [Object<'static, f32>; 11] = [
    Object::new(Shape::plane(Vec3::ZERO, UP), TABLE),
    Object::new(Shape::axis_box(Vec3::new(-5.0, 6.0, -2.0), Vec3::new(5.0, 6.1, 1.0)), LAMP),
    Object::new(BAR, BARE.with_film(SERIES)),
    ball(-3.325),
    ball(-2.375),
    ball(-1.425),
    ball(-0.475),
    ball(0.475),
    ball(1.425),
    ball(2.375),
    ball(3.325),
];
