//! Where two lines of a chart cross.

/// From where on a ratio is above 1.
#[derive(Debug, PartialEq)]
pub enum Crossing {
    /// From before the first place on.
    Before(f64),
    At(f64),
    /// Not up to the last place.
    After(f64),
}

/// Where a ratio rises above 1 for good, on straight lines between the points of the chart.
pub fn crossing(ratios: &[(f64, f64)]) -> Crossing {
    let Some(last) = ratios.iter().rposition(|&(_, ratio)| ratio < 1.0) else {
        return Crossing::Before(ratios.first().map_or(f64::NAN, |first| first.0));
    };
    let (before, below) = ratios[last];
    let Some(&(after, above)) = ratios.get(last + 1) else { return Crossing::After(before) };
    let share = -below.ln() / (above.ln() - below.ln());
    Crossing::At(before * (after / before).powf(share))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_cross() {
        let found = crossing(&[(10.0, 0.5), (1000.0, 2.0), (10_000.0, 4.0)]);
        assert!(matches!(found, Crossing::At(count) if (count - 100.0).abs() < 1e-9), "{found:?}");
        assert_eq!(crossing(&[(10.0, 2.0), (100.0, 4.0)]), Crossing::Before(10.0));
        assert_eq!(crossing(&[(10.0, 2.0), (100.0, 0.9)]), Crossing::After(100.0));
    }
}
