//! Which settings are tried on a scene.

use whit::Termination;
use whit::render::Sampling;
use whit::scene::Fresnel;

use crate::dispatch::DEPTH;
use crate::number_name::NumberName;
use crate::picture::Subject;
use crate::setting::{Path, Setting, SpectrumName};
use crate::variant;

const QUARTER: Sampling<f32> = Sampling::Adaptive { first: 4, most: 16, contrast: 1.0 / 4.0 };
const SIXTEENTH: Sampling<f32> = Sampling::Adaptive { first: 4, most: 16, contrast: 1.0 / 16.0 };
const MANY: Sampling<f32> = Sampling::Adaptive { first: 16, most: 64, contrast: 1.0 / 16.0 };

/// The samples of the converged picture: none of them is one of another grid or of a sequence.
pub const SAMPLES: Sampling<f32> = Sampling::Grid(16);

/// The values of each knob.
pub struct Knobs {
    pub numbers: Vec<NumberName>,
    pub fresnel: Vec<Fresnel>,
    pub spectra: Vec<SpectrumName>,
    pub paths: Vec<Path>,
    pub offsets: Vec<Option<f32>>,
    pub depths: Vec<u8>,
    pub cutoffs: Vec<f32>,
    pub terminations: Vec<Termination<f32>>,
    pub samplings: Vec<Sampling<f32>>,
}

impl Knobs {
    /// All that each knob is tried at, alone.
    pub fn alone(subject: &Subject) -> Self {
        let (branches, together) = (variant::has_branches(&subject.scene), Self::together(subject));
        Self {
            depths: if branches { (0..=10).collect() } else { together.depths },
            cutoffs: if branches { vec![0.0, 1.0 / 1024.0, 1.0 / 255.0, 1.0 / 64.0] } else { together.cutoffs },
            terminations: vec![Termination::Background, Termination::Black],
            samplings: vec![
                Sampling::Grid(1),
                Sampling::Grid(2),
                Sampling::Grid(4),
                Sampling::Sequence(4),
                Sampling::Sequence(16),
                Sampling::Sequence(64),
                QUARTER,
                SIXTEENTH,
                MANY,
            ],
            // One distance for all scenes, as it is mostly set.
            offsets: vec![Some(1e-2), Some(1e-3), Some(1e-4)],
            ..together
        }
    }

    /// What is tried in all combinations.
    pub fn together(subject: &Subject) -> Self {
        let scene = &subject.scene;
        let branches = variant::has_branches(scene);
        let fresnel = match variant::has_fresnel(scene) {
            true => vec![Fresnel::Exact, Fresnel::Schlick],
            false => vec![Fresnel::Exact],
        };
        Self {
            numbers: NumberName::ALL.to_vec(),
            fresnel,
            spectra: with(variant::has_film(scene), SpectrumName::Own, spectra()),
            paths: with(variant::is_bent(scene), Path::Own, paths(subject.name)),
            depths: if branches { vec![1, 2, 3, 5, 8, 12] } else { vec![Setting::DEFAULT.depth] },
            cutoffs: if branches { vec![0.0, 1.0 / 255.0] } else { vec![0.0] },
            terminations: vec![Termination::Background],
            offsets: vec![None],
            samplings: vec![Sampling::Grid(1)],
        }
    }

    /// One knob after the other, the rest as by default.
    pub fn each(&self) -> Vec<Setting> {
        let d = Setting::DEFAULT;
        let mut settings = vec![d];
        settings.extend(self.numbers.iter().map(|&number| Setting { number, ..d }));
        settings.extend(self.fresnel.iter().map(|&fresnel| Setting { fresnel, ..d }));
        settings.extend(self.spectra.iter().map(|&spectrum| Setting { spectrum, ..d }));
        settings.extend(self.paths.iter().map(|&path| Setting { path, ..d }));
        settings.extend(self.cutoffs.iter().map(|&cutoff| Setting { cutoff, ..d }));
        settings.extend(self.samplings.iter().map(|&sampling| Setting { sampling, ..d }));
        settings.extend(self.offsets.iter().map(|&offset| Setting { offset, ..d }));
        for &termination in &self.terminations {
            settings.extend(self.depths.iter().map(|&depth| Setting { depth, termination, ..d }));
        }
        settings
    }

    /// Some settings with all samples.
    pub fn sampled(&self, settings: &[Setting]) -> Vec<Setting> {
        extended(settings, &self.samplings, |setting, &sampling| Setting { sampling, ..setting })
    }

    /// Some settings with a few samples, in the number types that firmware is written in; the first one with more.
    pub fn for_firmware(settings: &[Setting]) -> Vec<Setting> {
        let few = extended(settings, &[Sampling::Sequence(4)], |setting, &sampling| Setting { sampling, ..setting });
        let more = settings.first().map(|&first| Setting { sampling: Sampling::Sequence(16), ..first });
        let all: Vec<Setting> = few.into_iter().chain(more).filter(Setting::has_own_scene).collect();
        extended(&all, &NumberName::FIRMWARE, |setting, &number| Setting { number, ..setting })
    }

    /// All combinations, of number types besides the default one with the scene as it is.
    pub fn product(&self) -> Vec<Setting> {
        let mut settings = vec![Setting::DEFAULT];
        settings = extended(&settings, &self.numbers, |setting, &number| Setting { number, ..setting });
        settings = extended(&settings, &self.fresnel, |setting, &fresnel| Setting { fresnel, ..setting });
        settings = extended(&settings, &self.spectra, |setting, &spectrum| Setting { spectrum, ..setting });
        settings = extended(&settings, &self.paths, |setting, &path| Setting { path, ..setting });
        settings = extended(&settings, &self.depths, |setting, &depth| Setting { depth, ..setting });
        settings = extended(&settings, &self.cutoffs, |setting, &cutoff| Setting { cutoff, ..setting });
        settings.retain(|setting| setting.number == Setting::DEFAULT.number || setting.has_own_scene());
        extended(&settings, &self.samplings, |setting, &sampling| Setting { sampling, ..setting })
    }
}

fn extended<K>(settings: &[Setting], knob: &[K], set: impl Fn(Setting, &K) -> Setting) -> Vec<Setting> {
    settings.iter().flat_map(|setting| knob.iter().map(|value| set(*setting, value))).collect()
}

fn with<K>(applies: bool, own: K, others: Vec<K>) -> Vec<K> {
    let mut values = vec![own];
    if applies {
        values.extend(others);
    }
    values
}

fn spectra() -> Vec<SpectrumName> {
    vec![SpectrumName::Wavelengths, SpectrumName::Table, SpectrumName::Bands(8), SpectrumName::Bands(16)]
}

/// Tolerances for all, and lengths and thicknesses for each scene: in its units, or around the hole as shares of the distance.
fn paths(scene: &str) -> Vec<Path> {
    let lengths: &[f32] = match scene {
        "mirage" => &[4.0, 1.0],
        "ship" => &[100.0, 25.0],
        "sunset" => &[16.0, 4.0],
        "lenses" => &[0.1, 0.02],
        "hole" => &[0.1, 0.03],
        _ => &[],
    };
    let controlled = [1e-3, 1e-4, 1e-5, 1e-6].into_iter().map(Path::Controlled);
    let layers: &[f32] = match scene {
        "mirage" => &[0.01, 0.0025],
        "ship" => &[1.0, 0.25],
        "sunset" => &[1.0, 0.25],
        "lenses" => &[0.05, 0.0125],
        _ => &[],
    };
    let fixed = lengths.iter().map(|&length| Path::Fixed(length));
    controlled.chain(fixed).chain(layers.iter().map(|&thickness| Path::Layers(thickness))).collect()
}

/// What others are measured against, with the same samples: what is cut weighs less than 1e-5.
pub fn reference(subject: &Subject, sampling: Sampling<f32>) -> Setting {
    Setting {
        number: NumberName::F64,
        depth: DEPTH as u8,
        cutoff: 1e-5,
        sampling,
        spectrum: if variant::has_film(&subject.scene) { SpectrumName::Bands(128) } else { SpectrumName::Own },
        path: if variant::is_bent(&subject.scene) { Path::Controlled(1e-7) } else { Path::Own },
        ..Setting::DEFAULT
    }
}

/// What pictures are measured against. Where the error is mostly that of samples, what is cut may weigh ten times as much.
pub fn converged(subject: &Subject) -> Setting {
    Setting { cutoff: 1e-4, ..reference(subject, SAMPLES) }
}
