//! What was aimed at, and whether it was reached.

use std::fmt;

use crate::rounds::Spread;

/// An aim, and what was measured in several ways, each with a name.
pub struct Aim {
    pub what: String,
    pub limit: Limit,
    pub measured: Vec<(&'static str, Spread)>,
}

/// What a ratio should be.
#[derive(Clone, Copy)]
pub enum Limit {
    AtLeast(f64),
    AtMost(f64),
}

impl Limit {
    fn is_met(self, ratio: &Spread) -> bool {
        match self {
            Self::AtLeast(limit) => ratio.median >= limit,
            Self::AtMost(limit) => ratio.median <= limit,
        }
    }
}

impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AtLeast(limit) => write!(f, "at least {limit}"),
            Self::AtMost(limit) => write!(f, "at most {limit}"),
        }
    }
}

/// As a row of a table.
impl fmt::Display for Aim {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, limit, measured } = self;
        let told: Vec<String> = measured.iter().map(|(name, ratio)| format!("{name}: {ratio}")).collect();
        let met = measured.iter().filter(|(_, ratio)| limit.is_met(ratio));
        let met: Vec<&str> = met.map(|(name, _)| *name).collect();
        let reached = match met.len() {
            0 => "no".to_owned(),
            count if count == measured.len() => "yes".to_owned(),
            _ => format!("{} only", met.join(", ")),
        };
        write!(f, "| {what} | {limit} | {} | {reached} |", told.join("; "))
    }
}
