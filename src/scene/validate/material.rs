//! Materials.

use super::number::{
    Fault, SHARE, amount, check, color, ensure, point, positive, refraction, refraction_of, share, within,
};
use crate::math::Rgb;
use crate::optics::Band;
use crate::scene::{Exponent, Film, Index, Interface, Material, Medium, Pattern, Spectrum, Thickness};

impl Material<f32> {
    pub(in crate::scene) const fn check(&self) -> Result<(), Fault> {
        if let Some(body) = &self.body {
            ensure!(body.color.check());
            ensure!(amount(body.emission, "body.emission"));
            ensure!(amount(body.ambient, "body.ambient"));
            ensure!(amount(body.diffuse, "body.diffuse"));
        }
        if let Some(highlight) = &self.highlight {
            ensure!(color(highlight.color, "highlight.color"));
            if let Exponent::Real(s) = highlight.exponent {
                ensure!(amount(s, "highlight.exponent"));
            }
        }
        if let Some(balance) = &self.balance {
            ensure!(check(within(balance.ratio, 0.0, 1.0), "balance.ratio", SHARE));
            ensure!(amount(balance.brightness, "balance.brightness"));
            let product = balance.ratio * balance.brightness;
            ensure!(check(
                product <= 1.0,
                "balance.brightness",
                "at most 1/ratio, so that no light comes from nowhere"
            ));
        }
        self.interface.check()
    }
}

impl Interface<f32> {
    const fn check(&self) -> Result<(), Fault> {
        match self {
            Interface::Opaque => Ok(()),
            Interface::Mirror { reflected } => share(*reflected, "interface.reflected"),
            Interface::Metal { r0 } => share(*r0, "interface.r0"),
            Interface::Conductor { index, extinction, film } => {
                ensure!(refraction(&Index::Dispersive(*index), "interface.index"));
                ensure!(check_extinction(*extinction));
                check_film(film)
            }
            Interface::Coat { index } => refraction_of(*index, "interface.index"),
            Interface::Constant { reflected, transmitted, medium } => {
                ensure!(share(*reflected, "interface.reflected"));
                ensure!(share(*transmitted, "interface.transmitted"));
                check_medium(medium)
            }
            Interface::Dielectric { medium, film } => {
                ensure!(check_medium(medium));
                check_film(film)
            }
        }
    }
}

const fn check_medium(medium: &Medium<f32>) -> Result<(), Fault> {
    ensure!(refraction(&medium.index, "interface.medium.index"));
    attenuation(&medium.attenuation, "interface.medium.attenuation")
}

pub(super) const fn attenuation(constant: &Option<Rgb<f32>>, field: &'static str) -> Result<(), Fault> {
    match constant {
        Some(constant) => color(*constant, field),
        None => Ok(()),
    }
}

const fn check_extinction(k: Rgb<f32>) -> Result<(), Fault> {
    let ok = within(k.r, 0.0, 1e3) && within(k.g, 0.0, 1e3) && within(k.b, 0.0, 1e3);
    check(ok, "interface.extinction", "an extinction coefficient from 0 to 1e3")
}

const fn check_film(film: &Option<Film<f32>>) -> Result<(), Fault> {
    let Some(film) = film else { return Ok(()) };
    ensure!(refraction_of(film.index, "interface.film.index"));
    ensure!(match film.thickness {
        Thickness::Uniform(thickness) => nanometres(thickness),
        Thickness::Gradient { from, to, origin, axis } => {
            ensure!(nanometres(from));
            ensure!(nanometres(to));
            ensure!(point(origin, "interface.film.thickness.origin"));
            point(axis, "interface.film.thickness.axis")
        }
        Thickness::Radial { from, to, center, radius } => {
            ensure!(nanometres(from));
            ensure!(nanometres(to));
            ensure!(point(center, "interface.film.thickness.center"));
            positive(radius, "interface.film.thickness.radius")
        }
    });
    match film.spectrum {
        Spectrum::Bands(bands) => check_bands(bands),
        Spectrum::Wavelengths | Spectrum::Table => Ok(()),
    }
}

const fn nanometres(thickness: f32) -> Result<(), Fault> {
    check(within(thickness, 0.0, 1e5), "interface.film.thickness", "a thickness from 0 to 1e5 nm")
}

#[allow(clippy::indexing_slicing)] // In range by the loop's condition; iterators are not const.
const fn check_bands(bands: &[Band]) -> Result<(), Fault> {
    ensure!(check(!bands.is_empty(), "interface.film.spectrum", "at least one band"));
    let mut i = 0;
    while i < bands.len() {
        let Band { wavelength, weight } = bands[i];
        let weighted = within(weight.r, -1e3, 1e3) && within(weight.g, -1e3, 1e3) && within(weight.b, -1e3, 1e3);
        let expected = "wavelengths from 1 to 1e6 nm with weights from -1e3 to 1e3";
        ensure!(check(within(wavelength, 1.0, 1e6) && weighted, "interface.film.spectrum", expected));
        i += 1;
    }
    Ok(())
}

impl Pattern<f32> {
    const fn check(&self) -> Result<(), Fault> {
        match *self {
            Pattern::Solid(c) => color(c, "body.color"),
            Pattern::Checker { even, odd, u, v } => {
                ensure!(color(even, "body.color.even"));
                ensure!(color(odd, "body.color.odd"));
                ensure!(point(u, "body.color.u"));
                point(v, "body.color.v")
            }
            Pattern::Gradient { from, to, origin, axis } => {
                ensure!(color(from, "body.color.from"));
                ensure!(color(to, "body.color.to"));
                ensure!(point(origin, "body.color.origin"));
                point(axis, "body.color.axis")
            }
            Pattern::Rings { even, odd, center, width } => {
                ensure!(color(even, "body.color.even"));
                ensure!(color(odd, "body.color.odd"));
                ensure!(point(center, "body.color.center"));
                positive(width, "body.color.width")
            }
        }
    }
}
