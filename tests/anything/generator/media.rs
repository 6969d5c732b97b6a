//! Media, films and interfaces.

use whit::scene::{Film, Index, Medium, Spectrum, Thickness};
use whit::{Interface, Rgb};

use super::span::{AMOUNT, EXTINCTION, INDEX, NANOMETRES, POSITIVE, SHARE};
use super::{Source, bands};

impl Source<'_> {
    pub fn medium(&mut self) -> Medium<f32> {
        let index = match self.below(4) {
            3 => Index::Dispersive(self.indices()),
            _ => Index::Constant(self.number(INDEX)),
        };
        let attenuation = if self.once_in(3) { Some(self.triple(AMOUNT)) } else { None };
        let priority = if self.once_in(3) { Some(self.byte() % 4) } else { None };
        Medium { index, attenuation, priority }
    }

    fn indices(&mut self) -> Rgb<f32> {
        Rgb::new(self.number(INDEX), self.number(INDEX), self.number(INDEX))
    }

    fn film(&mut self) -> Option<Film<f32>> {
        if !self.once_in(3) {
            return None;
        }
        let thickness = match self.below(4) {
            0 | 1 => Thickness::Uniform(self.number(NANOMETRES)),
            2 => Thickness::Gradient {
                from: self.number(NANOMETRES),
                to: self.number(NANOMETRES),
                origin: self.point(),
                axis: self.point(),
            },
            _ => Thickness::Radial {
                from: self.number(NANOMETRES),
                to: self.number(NANOMETRES),
                center: self.point(),
                radius: self.size(POSITIVE),
            },
        };
        let spectrum = match self.below(4) {
            0 => Spectrum::Table,
            1 => Spectrum::Wavelengths,
            _ => Spectrum::Bands(bands::random(self)),
        };
        Some(Film { index: self.number(INDEX), thickness, spectrum })
    }

    pub fn interface(&mut self) -> Interface<f32> {
        match self.below(12) {
            0 | 1 => Interface::Opaque,
            2 => Interface::Mirror { reflected: self.triple(SHARE) },
            3 => Interface::Metal { r0: self.triple(SHARE) },
            4 | 5 => Interface::Conductor {
                index: self.triple(INDEX),
                extinction: self.triple(EXTINCTION),
                film: self.film(),
            },
            6 => Interface::Coat { index: self.number(INDEX) },
            7 | 8 => Interface::Constant {
                reflected: self.triple(SHARE),
                transmitted: self.triple(SHARE),
                medium: self.medium(),
            },
            _ => Interface::Dielectric { medium: self.medium(), film: self.film() },
        }
    }
}
