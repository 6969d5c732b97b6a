//! Contestants in turn, so that what disturbs the machine disturbs all of them.

use std::fmt;

/// What several contestants took, each under its name and round by round: `N` measures.
pub struct Rounds<'a, const N: usize> {
    contestants: Vec<Contestant<'a, N>>,
}

struct Contestant<'a, const N: usize> {
    name: String,
    run: Box<dyn FnMut() -> Result<[f64; N], String> + 'a>,
    measures: Vec<[f64; N]>,
}

/// A median with its quartiles.
#[derive(Clone, Copy)]
pub struct Spread {
    pub low: f64,
    pub median: f64,
    pub high: f64,
}

impl<'a, const N: usize> Rounds<'a, N> {
    pub const fn new() -> Self {
        Self { contestants: Vec::new() }
    }

    pub fn add(&mut self, name: impl Into<String>, run: impl FnMut() -> Result<[f64; N], String> + 'a) {
        let (name, measures) = (name.into(), Vec::new());
        self.contestants.push(Contestant { name, run: Box::new(run), measures });
    }

    /// So many rounds of all.
    pub fn run(&mut self, rounds: usize) -> Result<(), String> {
        for _ in 0..rounds {
            for Contestant { run, measures, .. } in &mut self.contestants {
                measures.push(run()?);
            }
        }
        Ok(())
    }

    /// One measure of a contestant; not a number where there is no such contestant.
    pub fn of(&self, name: &str, measure: usize) -> Spread {
        Spread::of(self.measures(name).iter().map(|measures| measures[measure]))
    }

    /// One measure of a contestant by that of another in the same round.
    pub fn ratio(&self, one: &str, other: &str, measure: usize) -> Spread {
        let pairs = self.measures(one).iter().zip(self.measures(other));
        Spread::of(pairs.map(|(one, other)| one[measure] / other[measure]))
    }

    /// Of those whose name starts like this, the one with the least median of a measure.
    pub fn fastest(&self, start: &str, measure: usize) -> &str {
        let names = self.contestants.iter().map(|contestant| contestant.name.as_str());
        let median = |name: &&str| self.of(name, measure).median;
        let some = names.filter(|name| name.starts_with(start));
        some.min_by(|one, other| median(one).total_cmp(&median(other))).unwrap_or_default()
    }

    fn measures(&self, name: &str) -> &[[f64; N]] {
        self.contestants.iter().find(|contestant| contestant.name == name).map_or(&[], |found| &found.measures)
    }
}

impl Spread {
    fn of(values: impl Iterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values.collect();
        values.sort_by(f64::total_cmp);
        let at = |share: f64| {
            let place = share * values.len().saturating_sub(1) as f64;
            let value = |place: f64| values.get(place as usize).copied().unwrap_or(f64::NAN);
            let (below, above) = (value(place.floor()), value(place.ceil()));
            below + (above - below) * place.fract()
        };
        Self { low: at(0.25), median: at(0.5), high: at(0.75) }
    }
}

/// As a ratio is told.
impl fmt::Display for Spread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = if self.median < 10.0 { 2 } else { 1 };
        write!(f, "{:.digits$} ({:.digits$} to {:.digits$})", self.median, self.low, self.high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_are_of_the_same_round() {
        let mut rounds = Rounds::new();
        let mut slow_machine = [1.0, 10.0, 1.0].into_iter();
        let mut again = slow_machine.clone();
        rounds.add("one", move || slow_machine.next().map(|slow| [2.0 * slow]).ok_or_else(String::new));
        rounds.add("other", move || again.next().map(|slow| [4.0 * slow]).ok_or_else(String::new));
        rounds.run(3).unwrap();
        assert_eq!(rounds.ratio("one", "other", 0).to_string(), "0.50 (0.50 to 0.50)");
        assert_eq!(rounds.fastest("o", 0), "one");
        assert!(rounds.of("none", 0).median.is_nan());
        assert!(rounds.run(1).is_err());
    }

    #[test]
    fn medians_and_quartiles() {
        let Spread { low, median, high } = Spread::of([5.0, 1.0, 3.0, 2.0, 4.0].into_iter());
        assert_eq!((low, median, high), (2.0, 3.0, 4.0));
        assert_eq!(Spread::of([1.0, 2.0].into_iter()).median, 1.5);
    }
}
