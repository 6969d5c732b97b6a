//! Whether the library in `f64` agrees with the independent tracer of the tests.

use whit::Scene;
use whit::render::Size;
use whit::trace::Sequence;

use crate::page::Agreement;
use crate::picture::Subject;
use crate::reference::compare::Difference;
use crate::reference::{Samples, Settings, render};
use crate::setting::Setting;
use crate::sweep;
use crate::variant;

/// Enough bounces for most light; the independent tracer takes twice the time for each more.
const DEPTH: u8 = 8;

/// The independent tracer tries every object, and follows bent light in steps that are very short.
const SIZE: Size = Size::new(48, 36);
const SMALL: Size = Size::new(12, 9);

/// At one sample a pixel.
///
/// # Errors
/// Why the scene cannot be rendered.
pub fn of(name: &'static str, scene: Scene<'static, f32>) -> Result<Agreement, String> {
    let mut subject = Subject::new(name, scene, if variant::is_bent(&scene) { SMALL } else { SIZE });
    let setting = Setting { depth: DEPTH, cutoff: 0.0, ..sweep::reference(&subject, Setting::DEFAULT.sampling) };
    let ours = subject.take_quickly(&setting)?;
    let pixels: Vec<[f64; 3]> = ours.pixels.iter().map(|p| [p.r, p.g, p.b].map(f64::from)).collect();
    let scene = variant::of(&subject.scene, &setting)?;
    let numbers = |x, y, sample, dimension| match dimension {
        Sequence::PIXEL => [0.5; 2],
        _ => Sequence::new(x, y).point(sample, dimension),
    };
    let settings = Settings::new(subject.size.width, subject.size.height, DEPTH.into());
    let (theirs, _) = render(&scene, &settings, &Samples { count: 1, numbers: &numbers });
    let difference = Difference::between(&pixels, &theirs);
    Ok(Agreement { name: subject.name, share: difference.share_over_1_255, rmse: difference.rmse_without_edges })
}
