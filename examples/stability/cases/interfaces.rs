//! Glass at its critical angle, and Schlick's approximation on the wrong side.

use whit::Rgb;
use whit::optics::{fresnel_dielectric, schlick_dielectric, transmitted_cosine};

use crate::naive::{schlick_incident, snell};
use crate::page::Page;
use crate::picture::{HEIGHT, WIDTH, picture};

const GLASS: f32 = 1.5;

/// The reflectance from inside of glass at an angle: exact, Schlick's, and Schlick's at the angle of incidence.
fn reflectances(angle: f32) -> [f32; 3] {
    let cosine = angle.cos();
    [
        fresnel_dielectric(GLASS, 1.0, cosine).map_or(1.0, |(polarized, _)| polarized.mean()),
        schlick_dielectric(GLASS, 1.0, cosine).map_or(1.0, |(reflectance, _)| reflectance),
        if angle.sin() * GLASS > 1.0 { 1.0 } else { schlick_incident::schlick(GLASS, 1.0, cosine) },
    ]
}

/// Of the cosines within `ulps` of the critical one, for many indices: how many are taken to the wrong side of it.
fn misjudged(ulps: u32, transmits: impl Fn(f32, f32) -> bool) -> (u32, u32) {
    let (mut wrong, mut count) = (0, 0);
    for step in 1..400 {
        let n = 1.0 + 0.005 * step as f32;
        let critical = (1.0 - f64::from(n).powi(-2)).sqrt() as f32;
        for bits in critical.to_bits() - ulps..=critical.to_bits() + ulps {
            let cosine = f32::from_bits(bits);
            // Exact in f64: the squares have 48 digits each.
            let exact = 1.0 - f64::from(n).powi(2) * (1.0 - f64::from(cosine).powi(2)) >= 0.0;
            wrong += u32::from(transmits(n, cosine) != exact);
            count += 1;
        }
    }
    (wrong, count)
}

pub fn write(page: &mut Page) -> Result<(), String> {
    let strips = picture(|x, y| {
        let strip = (y / HEIGHT as f32 * 3.0) as usize;
        let value = reflectances(x / WIDTH as f32 * core::f32::consts::FRAC_PI_4).get(strip).copied();
        Rgb::grey(value.unwrap_or(0.0))
    });
    let mut worst = [0.0_f32; 2];
    for step in 0..90_000 {
        let [exact, schlick, naive] = reflectances((step as f32 / 1000.0).to_radians());
        worst = [worst[0].max((schlick - exact).abs()), worst[1].max((naive - exact).abs())];
    }
    let (naive, count) = misjudged(4, |n, cosine| snell::transmitted_cosine(n, 1.0, cosine).is_some());
    let (ours, _) = misjudged(4, |n, cosine| transmitted_cosine(n, 1.0, cosine).is_some());
    page.text(
        "
## Interfaces: the critical angle

What light that leaves glass is reflected, black to white, over the angle of incidence from 0° to 45°. From 41.8° on all
is. Schlick's approximation has to be taken at the angle on the less dense side.
",
    );
    let caption = format!(
        "From above: exact; Schlick at the transmitted angle, off by up to {:.3}; at the angle of incidence, by up to {:.3}.",
        worst[0], worst[1]
    );
    page.pictures("schlick", &caption, &[&strips])?;
    page.text(&format!(
        "Next to the critical angle the radicand 1 − η²(1 − c²) of Snell's law is the difference of two numbers near 1. For 399 \
         indices from 1.005 to 2.995 and the 9 cosines next to the critical one, {naive} of {count} are taken to the wrong side \
         by the textbook formula, and {ours} by `optics::transmitted_cosine`, which takes twice the digits there. In \
         `tests/data/oracles/fresnel.csv`, made with 50 digits, the reflectance is right to 3e-7, and to 1.1e-3 within 1e-3 of the \
         critical cosine, where its last bit counts as much (`tests/oracles.rs`). Between equal media nothing is reflected \
         and nothing bent, to the bit; indices from 1e-3 to 1e3 on both sides, and any angle, keep R and T from 0 to 1 and R + T = 1 \
         (`tests/hard_cases_optics/interfaces.rs`)."
    ));
    Ok(())
}
