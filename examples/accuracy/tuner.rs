//! The cheapest setting that is good enough, or the best that is cheap enough, of those that were measured.

use std::str::FromStr;

use crate::frontier::{Tolerance, frontier};
use crate::record::Record;

/// What counts as equal, so that nothing is paid for what cannot be told from noise.
const EQUAL: Tolerance = Tolerance { cost: 0.03, error: 0.03 };

/// What is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wish {
    /// The cheapest setting with an error of the picture (RMSE) of at most this.
    Error(f64),
    /// The setting of the least error with a cost of at most this.
    Cost(f64),
}

/// A setting on the frontier, and the ones beside it.
#[derive(Clone, Copy, Debug)]
pub struct Pick<'r> {
    pub record: &'r Record,
    pub cost: f64,
    /// The next cheaper one, if there is one.
    pub cheaper: Option<(&'r Record, f64)>,
    /// The next better one.
    pub better: Option<(&'r Record, f64)>,
}

/// Picks one of the records that have a cost, which is told in words.
///
/// # Errors
/// Says what the best there is can do, where none fulfils the wish.
pub fn pick<'r>(
    records: impl IntoIterator<Item = &'r Record>,
    cost: impl Fn(&Record) -> Option<f64>,
    in_words: impl Fn(f64) -> String,
    wish: Wish,
) -> Result<Pick<'r>, String> {
    let priced: Vec<(&Record, f64)> = records.into_iter().filter_map(|r| Some((r, cost(r)?))).collect();
    let points: Vec<_> = priced.iter().map(|(record, cost)| (*cost, record.picture.rmse)).collect();
    let line: Vec<_> = frontier(&points, EQUAL).into_iter().filter_map(|place| priced.get(place).copied()).collect();
    let (Some((_, least)), Some((best, _))) = (line.first(), line.last()) else {
        return Err("nothing was measured of this scene there".to_owned());
    };
    // Along the frontier costs rise and errors fall.
    let place = match wish {
        Wish::Error(most) => line
            .iter()
            .position(|(record, _)| record.picture.rmse <= most)
            .ok_or_else(|| format!("the least error that was measured is {:.2e}", best.picture.rmse)),
        Wish::Cost(most) => line
            .iter()
            .rposition(|(_, cost)| *cost <= most)
            .ok_or_else(|| format!("the least that was measured is {}", in_words(*least))),
    }?;
    let at = |place: Option<usize>| place.and_then(|place| line.get(place)).copied();
    let (record, cost) = at(Some(place)).ok_or("nothing was measured")?;
    Ok(Pick { record, cost, cheaper: at(place.checked_sub(1)), better: at(Some(place + 1)) })
}

impl Pick<'_> {
    /// What was picked and why, with costs in words.
    pub fn reasons(&self, in_words: impl Fn(f64) -> String) -> String {
        let describe = |record: &Record, cost: f64| {
            format!("{}: error {:.2e}, {}", record.setting, record.picture.rmse, in_words(cost))
        };
        let mut text = format!("picked   {}\n", describe(self.record, self.cost));
        match self.cheaper {
            Some((record, cost)) => text += &format!("cheaper  {}\n", describe(record, cost)),
            None => text += "cheaper  nothing that was measured\n",
        }
        match self.better {
            Some((record, cost)) => text += &format!("better   {}\n", describe(record, cost)),
            None => text += "better   nothing that was measured\n",
        }
        text
    }
}

/// A number, a fraction such as `1/255`, or one with `k`, `M` or `G` behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amount(pub f64);

impl FromStr for Amount {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.trim().parse::<f64>().ok();
        let scaled = |suffix: char, by: f64| Some(number(text.strip_suffix(suffix)?)? * by);
        let fraction = || {
            let (above, below) = text.split_once('/')?;
            Some(number(above)? / number(below)?)
        };
        let found = number(text)
            .or_else(fraction)
            .or_else(|| scaled('k', 1e3))
            .or_else(|| scaled('M', 1e6))
            .or_else(|| scaled('G', 1e9));
        match found {
            Some(value) if value.is_finite() && value > 0.0 => Ok(Self(value)),
            _ => Err(format!("expected a number above 0 such as 0.004, 1/255 or 100M, found `{text}`")),
        }
    }
}
