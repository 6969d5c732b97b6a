//! Curves through media of varying index that are known.

use super::reference::law::Law;
use super::reference::path::{Bend, Place};
use super::reference::vector::Vector;
use super::{Worst, X, after, ball, first, layered, number, rows, start, v};

const LUNEBURG: Law = Law::Polynomial { constant: 1.0, linear: 0.0, quadratic: -1.0 };

#[test]
fn the_table_of_closed_forms() {
    let linear = layered(-3.0, 3.0, Law::Polynomial { constant: 1.25, linear: -0.3, quadratic: 0.0 });
    let parabolic = layered(-1.0, 1.0, Law::Polynomial { constant: 1.56, linear: 0.0, quadratic: -2.56 * 0.64 });
    let exponential = layered(-1.0, 3.0, Law::Exponential { far: 0.0, excess: 1.5, scale: 1.0 });
    let luneburg = ball(0.0, 1.0, LUNEBURG);
    let mut worst = Worst::default();
    for row in rows(include_str!("../data/bending/graded.csv")) {
        let (case, angle) = (row[0].split(' ').next().unwrap(), number(row[1]).to_radians());
        let (profile, from) = match case {
            "linear_n2" => (&linear, start(Vector::ZERO, angle)),
            "parabolic" => (&parabolic, start(v(0.0, 0.3), angle)),
            "exponential" => (&exponential, start(Vector::ZERO, angle)),
            "luneburg" => (&luneburg, start(v(-0.5_f64.cos(), 0.5_f64.sin()), angle)),
            "focus" => (&luneburg, start(v(-2.0, number(&row[0][6..])), angle)),
            _ => panic!("{row:?}"),
        };
        let [x, y] = [3, 4].map(|column| number(row[column]));
        if x > 0.0 || case == "luneburg" {
            let place = first(Bend::Graded(profile), from, |place| place.point.x - x);
            // The table has 12 digits after the point.
            worst.note((place.point - v(x, y)).length(), 2e-12 + 1e-12 * slope(&place), &row);
        }
    }
    println!("table of closed forms: {:.1e}", worst.0);
}

/// What an error of x in the table makes of y.
fn slope(place: &Place) -> f64 {
    (place.direction.y / place.direction.x).abs()
}

/// n = 1 + 0.0789/T with T = 300 + 30·exp(−y/0.02).
#[test]
fn a_mirage_turns_where_it_must() {
    let air = layered(0.0, 3.0, Law::Thermal { excess: 0.0789 / 300.0, ratio: 0.1, scale: 0.02 });
    let bend = Bend::Graded(&air);
    let (mut heights, mut distances) = (Worst::default(), Worst::default());
    for row in rows(include_str!("../data/bending/mirage.csv")) {
        let from = start(v(0.0, number(row[0])), -number(row[1]));
        if row[2] == "hits ground" {
            first(bend, from, |place| -1e-6 - place.point.y);
            continue;
        }
        let turn = first(bend, from, |place| place.direction.y).point;
        heights.note((turn.y - number(row[2])).abs(), 1e-10, &row);
        let distance = number(row[3]);
        // The table has 10 digits.
        distances.note((turn.x - distance).abs() / distance, 6e-10, &row);
    }
    println!("mirage: {:.1e} in height, {:.1e} of the distance", heights.0, distances.0);
}

/// In Luneburg's lens x″ = −x by τ with dτ = ds/n: light leaves it at v₀ in the direction −x₀.
#[test]
fn luneburgs_lens_is_left_by_its_closed_form() {
    let lens = ball(0.0, 1.0, LUNEBURG);
    let mut worst = Worst::default();
    for i in -99..=99 {
        let enter =
            Place { point: v(-(1.0 - (0.01 * f64::from(i)).powi(2)).sqrt(), 0.01 * f64::from(i)), direction: X };
        let end = after(Bend::Graded(&lens), enter, 5.0);
        let expected = -enter.point;
        worst.note((end.direction - expected).length(), 1e-11, i);
        worst.note((end.point - X).cross(expected).length(), 1e-11, i);
    }
    println!("Luneburg's lens: {:.1e}", worst.0);
}

/// All light from p meets again in −p·R²/|p|², on circles.
#[test]
fn the_fish_eye_brings_a_point_to_its_conjugate() {
    let eye = ball(0.0, 100.0, Law::FishEye { index: 2.0, radius: 1.0 });
    let (p, conjugate) = (v(0.5, 0.0), v(-2.0, 0.0));
    let mut worst = Worst::default();
    for degrees in (5..=355).step_by(5).filter(|degrees| degrees % 180 != 0) {
        let from = start(p, f64::from(degrees).to_radians());
        // Through p and its conjugate, across the direction.
        let center = v(-0.75, 0.0) + v(0.0, 1.25 * from.direction.x / from.direction.y);
        let radius = (center - p).length();
        let bend = Bend::Graded(&eye);
        let there = first(bend, from, |place| {
            if place.point.x < -0.75 { (place.point - conjugate).dot(place.direction) } else { -1.0 }
        });
        worst.note((there.point - conjugate).length(), 1e-10, degrees);
        for share in [0.1, 0.3, 0.6, 0.9] {
            let place = after(bend, from, 2.0 * share * radius);
            worst.note(((place.point - center).length() - radius).abs() / radius, 1e-11, degrees);
        }
    }
    println!("fish-eye: {:.1e}", worst.0);
}

/// Through a layer where n² grows by 0.5 per unit between constant media: y = p·τ + τ²/8 with dτ = ds/n.
#[test]
fn a_layer_between_constant_media() {
    let layer = layered(0.0, 2.0, Law::Polynomial { constant: 0.5, linear: 0.5, quadratic: 0.0 });
    let bend = Bend::Graded(&layer);
    let mut worst = Worst::default();
    for degrees in [0.5_f64, 5.0, 30.0, 80.0] {
        let angle = degrees.to_radians();
        let [px, py] = [angle.cos(), angle.sin()].map(|component| 1.5_f64.sqrt() * component);
        let tau = 4.0 * ((py * py + 1.0).sqrt() - py);
        let from = Place { point: v(-3.0, -3.0 * angle.tan()), ..start(Vector::ZERO, angle) };
        let end = first(bend, from, |place| place.point.y - 5.0);
        let direction = v(px, py + 0.25 * tau).normalized();
        worst.note((end.direction - direction).length(), 1e-12, degrees);
        worst.note((end.point.x - px * tau - 3.0 * direction.x / direction.y).abs(), 1e-10, degrees);
        // Back from above, at an angle that does not get through.
        let down = Place { point: v(0.0, 2.0), direction: v(px, -0.3).normalized() };
        let sine = down.direction.y * 2.5_f64.sqrt();
        let cosine = down.direction.x * 2.5_f64.sqrt();
        if sine * sine < 1.0 {
            let up = first(bend, down, |place| if place.direction.y > 0.0 { place.point.y - 2.5 } else { -1.0 });
            worst.note((up.direction.y + down.direction.y).abs(), 1e-12, degrees);
            let expected = -8.0 * sine * cosine + 0.5 * up.direction.x / up.direction.y;
            worst.note((up.point.x - expected).abs(), 1e-10, degrees);
        }
    }
    println!("layer: {:.1e}", worst.0);
}

/// Where the curve through a table's values is the line itself.
#[test]
fn a_table_of_a_line_is_the_line() {
    let table =
        layered(-1.0, 1.0, Law::Table { spacing: 0.25, values: (0..9).map(|i| 0.5 + 0.025 * f64::from(i)).collect() });
    // n = 1.6 + 0.1·ℓ
    let line = layered(-1.0, 1.0, Law::Polynomial { constant: 1.56, linear: 0.32, quadratic: 0.01 });
    let mut worst = Worst::default();
    for degrees in [-80.0_f64, -30.0, -2.0, 0.0, 2.0, 45.0] {
        let from = start(v(-1.0, 0.2), degrees.to_radians());
        let [a, b] = [&table, &line].map(|profile| after(Bend::Graded(profile), from, 7.0));
        worst.note((a.point - b.point).length(), 1e-11, degrees);
        worst.note((a.direction - b.direction).length(), 1e-11, degrees);
    }
    println!("table: {:.1e}", worst.0);
}
