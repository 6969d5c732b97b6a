//! Materials, media and films.

use whit::optics::{Band, bands};
use whit::scene::{Balance, Body, Exponent, Film, Highlight, Index, Lobe, Medium, Spectrum, Thickness};
use whit::{Interface, Material, Pattern};

use super::Source;

static BANDS: [Band; 12] = bands();
static FEW: [Band; 1] = bands();
/// At the ends of what is accepted.
static ENDS: [Band; 3] = [
    Band { wavelength: 1.0, weight: whit::Rgb::new(1e3, -1e3, 0.0) },
    Band { wavelength: 1e6, weight: whit::Rgb::new(-1e3, 1e3, -1e3) },
    Band { wavelength: 550.0, weight: whit::Rgb::new(-1e3, 1e3, 1e3) },
];

impl Source {
    pub fn material(&mut self) -> Material<f32> {
        Material {
            body: if self.once_in(2) { Some(self.body()) } else { None },
            highlight: if self.once_in(3) { Some(self.highlight()) } else { None },
            interface: self.interface(),
            balance: if self.once_in(4) { Some(self.balance()) } else { None },
        }
    }

    /// As bright as may be, or less.
    fn body(&mut self) -> Body<f32> {
        let (emission, ambient) = (self.amount(), self.share());
        let (diffuse, color) = match self.below(3) {
            0 => (self.share(), self.color()),
            1 => (self.amount, self.triple(Self::share)),
            _ => (self.share(), self.triple(Self::share)),
        };
        let most = self.amount / (ambient + diffuse).max(1.0);
        let (color, other) = (color.map(|c| c.min(most)), self.color().map(|c| c.min(most)));
        let color = match self.below(5) {
            0 | 1 => Pattern::Solid(color),
            2 => Pattern::Checker { even: color, odd: other, u: self.point(), v: self.point() },
            3 => Pattern::Gradient { from: color, to: other, origin: self.point(), axis: self.point() },
            _ => Pattern::Rings { even: color, odd: other, center: self.point(), width: self.length() },
        };
        Body { color, emission, ambient, diffuse }
    }

    fn highlight(&mut self) -> Highlight<f32> {
        let exponent = match self.below(3) {
            0 => Exponent::Integer(self.pick(&[0, 1, 2, 50, 1000, u32::MAX])),
            1 => Exponent::Integer(self.below(100) as u32),
            _ => Exponent::Real(self.number(0.0, self.limit, &[0.0, 0.5, 3.0, 20.5])),
        };
        Highlight { color: self.color(), lobe: self.pick(&[Lobe::Blinn, Lobe::Phong]), exponent }
    }

    fn balance(&mut self) -> Balance<f32> {
        let brightness = self.amount();
        let ratio = self.share().min(0.999 / brightness.max(1.0));
        Balance { ratio, brightness }
    }

    fn interface(&mut self) -> Interface<f32> {
        match self.below(12) {
            0..=2 => Interface::Opaque,
            3 => Interface::Mirror { reflected: self.triple(Self::share) },
            4 => Interface::Metal { r0: self.triple(Self::share) },
            5 | 6 => Interface::Conductor {
                index: self.triple(|source| source.number(0.001, 12.0, &[0.05, 0.2, 1.0, 3.0])),
                extinction: self.triple(|source| source.number(0.0, 12.0, &[0.5, 1.0, 3.4, 7.0])),
                film: self.film(),
            },
            7 => Interface::Coat { index: self.index() },
            8 => {
                let reflected = self.triple(Self::share);
                let transmitted = reflected.map(|r| 1.0 - r) * if self.once_in(2) { 1.0 } else { self.share() };
                Interface::Constant { reflected, transmitted, medium: self.medium() }
            }
            _ => Interface::Dielectric { medium: self.medium(), film: self.film() },
        }
    }

    fn index(&mut self) -> f32 {
        self.number(0.5, 4.0, &[1.0, 1.33, 1.5, 1.51, 2.4, 0.6])
    }

    pub fn medium(&mut self) -> Medium<f32> {
        let index = match self.below(4) {
            0 => Index::Dispersive(self.triple(Self::index)),
            _ => Index::Constant(self.index()),
        };
        let attenuation = if self.once_in(3) {
            Some(self.triple(|source| source.number(0.0, source.limit, &[0.0, 0.1, 1.0])))
        } else {
            None
        };
        let priority = if self.once_in(3) { Some(self.below(3) as u8) } else { None };
        Medium { index, attenuation, priority }
    }

    fn film(&mut self) -> Option<Film<f32>> {
        if self.once_in(2) {
            return None;
        }
        let nanometres = |source: &mut Self| source.number(0.0, 15.0 * source.limit, &[0.0, 100.0, 380.0, 900.0]);
        let thickness = match self.below(4) {
            0 | 1 => Thickness::Uniform(nanometres(self)),
            2 => Thickness::Gradient {
                from: nanometres(self),
                to: nanometres(self),
                origin: self.point(),
                axis: self.point(),
            },
            _ => Thickness::Radial {
                from: nanometres(self),
                to: nanometres(self),
                center: self.point(),
                radius: self.length(),
            },
        };
        let spectrum = match self.below(6) {
            0 | 1 => Spectrum::Table,
            2 => Spectrum::Wavelengths,
            3 => Spectrum::Bands(&BANDS),
            4 => Spectrum::Bands(&ENDS),
            _ => Spectrum::Bands(&FEW),
        };
        Some(Film { index: self.index(), thickness, spectrum })
    }
}
