//! The settings that are worth their cost: no other one is both cheaper and better.

/// Costs and errors that differ by less than these shares are taken to be equal.
#[derive(Clone, Copy, Debug)]
pub struct Tolerance {
    pub cost: f64,
    pub error: f64,
}

/// The frontier of points (cost, error), by their places in the list, from the cheapest to the most exact.
///
/// From the cheapest on: of the points that cost the same, to the tolerance, the one of the least error; then the cheapest
/// of those that are better than that one by more than the tolerance, and so on. Of points that are equal in both, to the
/// tolerance, the first one of the list counts: put the plain ones first. So costs rise and errors fall along it, and no point is
/// better than one of it by more than the tolerances.
pub fn frontier(points: &[(f64, f64)], tolerance: Tolerance) -> Vec<usize> {
    let mut frontier = Vec::new();
    let mut limit = f64::INFINITY;
    loop {
        let better = || points.iter().enumerate().filter(|(_, (_, error))| *error < limit);
        let Some(least) = better().map(|(_, (cost, _))| *cost).min_by(f64::total_cmp) else { return frontier };
        let affordable = better().filter(|(_, (cost, _))| *cost <= least * (1.0 + tolerance.cost));
        let errors = || affordable.clone().map(|(_, (_, error))| *error);
        let best = errors().min_by(f64::total_cmp).unwrap_or(limit);
        let mut as_good = affordable.clone().filter(|(_, (_, error))| *error <= best * (1.0 + tolerance.error));
        let Some((place, (_, error))) = as_good.next() else { return frontier };
        frontier.push(place);
        limit = best.min(*error) / (1.0 + tolerance.error);
        if best <= 0.0 {
            return frontier;
        }
    }
}

/// The cheapest point of a list, or the first one that costs as much to the tolerance, that is better than this one in cost or in
/// error by more than the tolerance, and not worse in the other one.
pub fn dominating(points: &[(f64, f64)], (cost, error): (f64, f64), tolerance: Tolerance) -> Option<usize> {
    let (less_cost, less_error) = (cost / (1.0 + tolerance.cost), error / (1.0 + tolerance.error));
    let better = |&(_, &(c, e)): &(usize, &(f64, f64))| c <= cost && e <= error && (c < less_cost || e < less_error);
    let better = || points.iter().enumerate().filter(better);
    let least = better().map(|(_, (cost, _))| *cost).min_by(f64::total_cmp)?;
    better().find(|(_, (cost, _))| *cost <= least * (1.0 + tolerance.cost)).map(|(place, _)| place)
}
