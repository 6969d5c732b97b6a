//! A smooth curve through a table of values.

use crate::math::Real;

/// The value and the slope at `place`, which counts values from 0, on the cubic curve through the values whose slope at
/// each of them is that between its neighbours (Catmull and Rom, "A Class of Local Interpolating Splines", 1974). Beyond
/// the ends the curve goes on as a line.
pub(super) fn at<T: Real>(values: &[T], place: T) -> (T, T) {
    let last = values.len().saturating_sub(1) as u32;
    let held = place.max(T::ZERO).min(T::from_u32(last));
    let whole = held.floor().min(T::from_u32(last.saturating_sub(1)));
    let index = whole.to_f32() as usize;
    let value = |i: usize| values.get(i).copied().unwrap_or(T::ZERO);
    // At the ends, the slope to the only neighbour.
    let slope = |i: usize| {
        let (before, after) = (i.saturating_sub(1), (i + 1).min(last as usize));
        let difference = value(after) - value(before);
        if after - before > 1 { difference * T::HALF } else { difference }
    };
    let (a, b, from, to) = (value(index), value(index + 1), slope(index), slope(index + 1));
    let t = held - whole;
    let rise = b - a;
    // a + t·from + t²·(3·rise − 2·from − to) + t³·(from + to − 2·rise)
    let three = T::TWO + T::ONE;
    let (square, cube) = (three * rise - T::TWO * from - to, from + to - T::TWO * rise);
    let result = a + t * (from + t * (square + t * cube));
    let slope = from + t * (T::TWO * square + t * three * cube);
    (result + slope * (place - held), slope)
}

#[cfg(test)]
mod tests {
    use super::at;

    /// Lines and parabolas come back as they are, with their slopes.
    #[test]
    fn a_parabola_is_itself() {
        let parabola = |x: f64| 1.0 + x * (0.5 - 0.25 * x);
        let values: Vec<f64> = (0..8).map(|i| parabola(f64::from(i))).collect();
        for i in 10..=60 {
            let x = f64::from(i) / 10.0;
            let (value, slope) = at(&values, x);
            assert!((value - parabola(x)).abs() < 1e-12 && (slope - (0.5 - 0.5 * x)).abs() < 1e-12, "{x}");
        }
    }

    #[test]
    fn two_values_make_a_line() {
        for x in [-1.0, 0.0, 0.3, 1.0, 2.0] {
            assert_eq!(at(&[1.0, 3.0], x), (1.0 + 2.0 * x, 2.0));
        }
    }
}
