//! Schlick's approximation and the Fresnel equations, by the angle.

use whit::optics::materials::{self, Conductor};
use whit::optics::{fresnel_conductor, fresnel_dielectric, schlick, schlick_dielectric};

/// Two media.
#[derive(Clone, Copy)]
pub enum Pair {
    /// The indices of refraction in front and behind.
    Dielectric(f64, f64),
    /// The green channel of a metal.
    Conductor(Conductor),
}

/// All pairs that are drawn.
pub const PAIRS: [(&str, Pair); 8] = [
    ("air to water", Pair::Dielectric(1.0, 1.3333)),
    ("water to air", Pair::Dielectric(1.3333, 1.0)),
    ("air to glass", Pair::Dielectric(1.0, 1.5)),
    ("glass to air", Pair::Dielectric(1.5, 1.0)),
    ("air to diamond", Pair::Dielectric(1.0, 2.4173)),
    ("aluminium", Pair::Conductor(materials::ALUMINIUM)),
    ("gold", Pair::Conductor(materials::GOLD)),
    ("copper", Pair::Conductor(materials::COPPER)),
];

impl Pair {
    /// By the Fresnel equations and by Schlick, at an angle in degrees.
    pub fn reflectances(self, degrees: f64) -> [f64; 2] {
        let cosine = degrees.to_radians().cos();
        match self {
            Self::Dielectric(n1, n2) => [
                fresnel_dielectric(n1, n2, cosine).map_or(1.0, |(reflectance, _)| reflectance.mean()),
                schlick_dielectric(n1, n2, cosine).map_or(1.0, |(reflectance, _)| reflectance),
            ],
            Self::Conductor(metal) => {
                let exact = |cosine| fresnel_conductor(metal.index.g.into(), metal.extinction.g.into(), cosine).mean();
                [exact(cosine), schlick(exact(1.0), cosine)]
            }
        }
    }

    /// The largest difference in steps of a hundredth of a degree, and its angle.
    pub fn worst(self) -> (f64, f64) {
        let mut worst = (0.0, 0.0);
        for degrees in (0..9000).map(|i| f64::from(i) / 100.0) {
            let [exact, approximate] = self.reflectances(degrees);
            if (approximate - exact).abs() > worst.0 {
                worst = ((approximate - exact).abs(), degrees);
            }
        }
        worst
    }
}
