//! Errors and times of settings on a scene.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::time::Duration;

use palette::LinSrgb;
use whit::Termination;

use crate::difference::Difference;
use crate::frontier::{Tolerance, frontier};
use crate::picture::{Subject, Taken};
use crate::record::Record;
use crate::setting::Setting;
use crate::sweep::{self, Knobs};

/// Differences that count as none. That of costs is raised to what times were seen to vary by.
pub const TOLERANCE: Tolerance = Tolerance { cost: 0.03, error: 0.03 };

/// An error at one sample a pixel below which more samples do more than a better sample.
const ENOUGH: f64 = 1e-3;

/// How many times as long as by default a setting may take that is tried with more samples.
const MOST: f64 = 64.0;

/// Runs of each setting, and how long all of them may take.
const RUNS: usize = 5;
const LONG: Duration = Duration::from_millis(200);

/// All that was measured of a scene.
pub struct Measured {
    pub name: &'static str,
    pub records: Vec<Record>,
    /// Number types that refuse the scene, and why.
    pub refusals: Vec<(String, String)>,
    /// By how much the second shortest time of a setting is longer than the shortest one, in the middle of all.
    pub noise: f64,
    /// The converged picture.
    pub converged: Vec<LinSrgb<f64>>,
}

/// A scene with its references.
pub struct Bench {
    pub subject: Subject,
    converged: Vec<LinSrgb<f64>>,
    /// The light at one sample a pixel.
    light: Vec<LinSrgb<f64>>,
    refusals: BTreeMap<String, String>,
    /// Times of the default setting.
    default: Vec<Duration>,
}

struct Entry {
    record: Record,
    /// Of the number type, the rays and all bits of the pixels.
    picture: u64,
    times: Vec<Duration>,
}

impl Bench {
    /// # Errors
    /// Why the reference cannot be made.
    pub fn new(mut subject: Subject) -> Result<Self, String> {
        let taken = subject.take_quickly(&sweep::converged(&subject))?;
        let converged = subject.shown(&taken.pixels);
        let taken = subject.take_quickly(&sweep::reference(&subject, Setting::DEFAULT.sampling))?;
        let light = subject.shown(&taken.pixels);
        Ok(Self { subject, converged, light, refusals: BTreeMap::new(), default: Vec::new() })
    }

    /// Errors of all settings, and their times if these are asked for.
    ///
    /// # Errors
    /// Why the default setting cannot be rendered.
    pub fn measure(mut self, timed: bool) -> Result<Measured, String> {
        let (alone, together) = (Knobs::alone(&self.subject), Knobs::together(&self.subject));
        let mut entries: Vec<Entry> = Vec::new();
        let mut settings = alone.each();
        settings.extend(together.product());
        self.add(&mut entries, &settings)?;
        self.time(&mut entries, timed)?;
        let promising = self.promising(&entries, timed);
        let affordable = |(setting, cost): &(Setting, f64)| {
            let cost = *cost;
            let sampled = alone.sampled(&[*setting]).into_iter();
            sampled.filter(move |sampled| cost * f64::from(sampled.sampling.most()) <= MOST)
        };
        let mut sampled: Vec<Setting> = promising.iter().flat_map(affordable).collect();
        let promising: Vec<Setting> = promising.into_iter().map(|(setting, _)| setting).collect();
        sampled.extend(Knobs::for_firmware(&promising));
        let before = entries.len();
        self.add(&mut entries, &sampled)?;
        let (_, later) = entries.split_at_mut(before);
        self.time(later, timed)?;
        Ok(self.finish(entries, timed))
    }

    /// Those on the frontier of light at one sample, up to the first that is good enough, and the default; with their costs
    /// as ratios to that of the default.
    fn promising(&self, entries: &[Entry], timed: bool) -> Vec<(Setting, f64)> {
        let default = (least(&self.default), entries[0].record.rays);
        let cost = |entry: &Entry| match timed {
            true => least(&entry.times) / default.0,
            false => entry.record.rays / default.1,
        };
        let light = |entry: &Entry| Some((entry.record.setting, cost(entry), entry.record.light?.rmse));
        let lights: Vec<_> = entries.iter().filter_map(light).collect();
        let points: Vec<_> = lights.iter().map(|&(_, cost, error)| (cost, error)).collect();
        let mut settings = vec![(Setting::DEFAULT, 1.0)];
        for place in frontier(&points, TOLERANCE) {
            let (setting, cost, error) = lights[place];
            settings.push((setting, cost));
            if error <= ENOUGH {
                break;
            }
        }
        settings
    }

    /// Errors of light by depth, from 0 to 10, with the background and with black for what is cut.
    ///
    /// # Errors
    /// Why the scene cannot be rendered.
    pub fn depths(&mut self) -> Result<[Vec<f64>; 2], String> {
        let mut series = [Vec::new(), Vec::new()];
        for (errors, termination) in series.iter_mut().zip([Termination::Background, Termination::Black]) {
            for depth in 0..=10 {
                let setting = Setting { depth, cutoff: 0.0, termination, ..Setting::DEFAULT };
                let taken = self.subject.take_quickly(&setting)?;
                errors.push(Difference::between(&self.subject.shown(&taken.pixels), &self.light).rmse);
            }
        }
        Ok(series)
    }

    /// Takes pictures by settings that are new, leaving out those that change nothing.
    fn add(&mut self, entries: &mut Vec<Entry>, settings: &[Setting]) -> Result<(), String> {
        for setting in settings {
            if entries.iter().any(|entry| entry.record.setting == *setting) {
                continue;
            }
            match self.subject.take(setting) {
                Ok(taken) => {
                    let entry = self.entry(setting, &taken);
                    if !entries.iter().any(|other| other.picture == entry.picture) {
                        entries.push(entry);
                    }
                }
                Err(reason) if setting.number != Setting::DEFAULT.number => {
                    self.refusals.insert(setting.number.to_string(), reason);
                }
                Err(reason) => return Err(format!("{}: {setting}: {reason}", self.subject.name)),
            }
        }
        Ok(())
    }

    fn entry(&self, setting: &Setting, taken: &Taken) -> Entry {
        let picture = self.subject.shown(&taken.pixels);
        let record = Record {
            scene: self.subject.name.to_owned(),
            setting: *setting,
            rays: taken.stats.rays() as f64 / self.subject.size.pixels() as f64,
            time: None,
            picture: Difference::between(&picture, &self.converged),
            light: is_single(setting).then(|| Difference::between(&picture, &self.light)),
            costs: BTreeMap::new(),
        };
        Entry { picture: fingerprint(setting, taken), record, times: vec![taken.time] }
    }

    /// Runs all settings in turn, several times; the default again and again in between.
    fn time(&mut self, entries: &mut [Entry], timed: bool) -> Result<(), String> {
        for _ in 0..if timed { RUNS } else { 0 } {
            for (i, entry) in entries.iter_mut().enumerate() {
                if i % 8 == 0 {
                    self.default.push(self.subject.take(&Setting::DEFAULT)?.time);
                }
                if entry.times.iter().sum::<Duration>() < LONG {
                    entry.times.push(self.subject.take(&entry.record.setting)?.time);
                }
            }
        }
        Ok(())
    }

    fn finish(self, entries: Vec<Entry>, timed: bool) -> Measured {
        let default = least(&self.default);
        let mut spreads: Vec<f64> = entries.iter().filter_map(|entry| spread(&entry.times)).collect();
        spreads.sort_by(f64::total_cmp);
        let noise = spreads.get(spreads.len() / 2).copied().unwrap_or(0.0);
        let record = |entry: Entry| Record { time: timed.then(|| least(&entry.times) / default), ..entry.record };
        Measured {
            name: self.subject.name,
            records: entries.into_iter().map(record).collect(),
            refusals: self.refusals.into_iter().collect(),
            noise,
            converged: self.converged,
        }
    }
}

fn is_single(setting: &Setting) -> bool {
    setting.sampling == Setting::DEFAULT.sampling
}

/// In seconds.
fn least(times: &[Duration]) -> f64 {
    times.iter().min().map_or(f64::NAN, Duration::as_secs_f64)
}

/// By how much the second least time is longer than the least one.
fn spread(times: &[Duration]) -> Option<f64> {
    let mut times = times.to_vec();
    times.sort();
    let &[least, second, ..] = times.as_slice() else { return None };
    Some(second.as_secs_f64() / least.as_secs_f64() - 1.0)
}

fn fingerprint(setting: &Setting, taken: &Taken) -> u64 {
    let mut hasher = DefaultHasher::new();
    setting.number.name().hash(&mut hasher);
    taken.stats.rays().hash(&mut hasher);
    for pixel in &taken.pixels {
        [pixel.r, pixel.g, pixel.b].map(f32::to_bits).hash(&mut hasher);
    }
    hasher.finish()
}
