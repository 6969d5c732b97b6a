//! Luneburg's lens brings parallel light to a point; Maxwell's fish-eye brings the light of each point to another.

use whit::scene::Method;

use crate::exact::glass::{conjugate, fish_eye, luneburg, luneburg_direction};
use crate::orbit::dot;
use crate::support::{
    assert_below, controlled, distance, fixed, halved, landing, layers, mean, number, order, rows, start, tenths,
    walled,
};
use crate::tables::GLASS;
use crate::world::{Bend, Number, Start, Target, World};

const HEIGHTS: [f64; 7] = [0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99];

/// By how much parallel light, from outside of the lens, misses the focus and its direction there.
fn focus<T: Number>(method: Method<f64>, heights: &[f64]) -> Vec<[f64; 2]> {
    let at = |h| {
        let (point, direction) = landing::<T>(&walled(luneburg(method), 1.0), &start(-2.0, h, 0.0));
        [distance(point, [1.0, 0.0, 0.0]), distance(direction, luneburg_direction(h))]
    };
    heights.iter().copied().map(at).collect()
}

/// By how much light is off at the places of the table.
fn on_the_way<T: Number>(method: Method<f64>) -> Vec<f64> {
    let inside = rows(GLASS).filter(|row| row[0] == "luneburg R=1" && row[3] != "1.000000000000");
    let error = |row: Vec<&str>| {
        let (point, _) = landing::<T>(&walled(luneburg(method), number(row[3])), &start(-2.0, 0.5_f64.sin(), 0.0));
        point[1] - number(row[4])
    };
    inside.map(error).collect()
}

/// The starts of paths in the fish-eye, in all directions from two points, and their opposite points.
fn rays() -> Vec<(Start, [f64; 3])> {
    let points = [[0.5, 0.0, 0.0], [0.3, -0.6, 0.2]];
    let mut rays = Vec::new();
    for point in points {
        for i in 0..40 {
            let (z, turn) = (f64::from(2 * i + 1) / 40.0 - 1.0, f64::from(i) * 2.4);
            let across = (1.0 - z * z).sqrt();
            rays.push((
                Start { origin: point, direction: [across * turn.cos(), across * turn.sin(), z] },
                conjugate(point),
            ));
        }
    }
    rays
}

/// How far from the opposite point light meets the plane there, across the line to it; of light that starts towards there.
fn opposite<T: Number>(method: Method<f64>) -> Vec<f64> {
    let error = |(from, image): (Start, [f64; 3])| {
        let size = distance(image, [0.0; 3]);
        let target = Target::Plane { point: image, normal: image.map(|x| -x / size) };
        let world = World { bend: Bend::Medium(fish_eye(method)), targets: vec![target] };
        distance(landing::<T>(&world, &from).0, image)
    };
    rays().into_iter().filter(|(from, image)| dot(from.direction, *image) > 0.1).map(error).collect()
}

fn worst(errors: impl IntoIterator<Item = f64>) -> f64 {
    errors.into_iter().fold(0.0, |worst, error| error.abs().max(worst))
}

fn check<T: Number>(method: Method<f64>, bound: f64) {
    let name = format!("{method:?}, f{}", 8 * size_of::<T>());
    check_luneburg::<T>(&name, method, &HEIGHTS, bound);
    assert_below(&format!("{name}, fish-eye"), worst(opposite::<T>(method)), bound);
}

fn check_luneburg<T: Number>(name: &str, method: Method<f64>, heights: &[f64], bound: f64) {
    let [misses, turns] = [0, 1].map(|i| worst(focus::<T>(method, heights).into_iter().map(|error| error[i])));
    assert_below(&format!("{name}, focus"), misses, bound);
    assert_below(&format!("{name}, direction"), turns, bound);
    assert_below(&format!("{name}, on the way"), worst(on_the_way::<T>(method)), bound);
}

#[test]
fn controlled_steps() {
    // With 1e-2, light that meets the wall opposite at an angle of 3° may pass by it.
    for tolerance in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
        check::<f64>(controlled(tolerance), 20.0 * tolerance);
        check::<f32>(controlled(tolerance), 20.0 * tolerance + 2e-4);
    }
}

#[test]
fn fixed_steps() {
    for length in [0.1, 0.05, 0.02, 0.01] {
        check::<f64>(fixed(length), 50.0 * length * length);
        check::<f32>(fixed(length), 50.0 * length * length + 2e-4);
    }
}

/// Where light turns in one of the layers, the error goes with the root of its thickness; and light that goes nearly along round
/// layers may stay in one for ever. So neither the fish-eye nor grazing light are here.
#[test]
fn thin_layers() {
    let heights = &HEIGHTS[..6];
    for thickness in [0.01_f64, 0.001] {
        let bound = 2.0 * thickness.sqrt();
        check_luneburg::<f64>(&format!("{thickness}, f64"), layers(thickness), heights, bound);
        check_luneburg::<f32>(&format!("{thickness}, f32"), layers(thickness), heights, bound);
    }
    for thickness in halved(0.02, 8) {
        let miss = mean(focus::<f64>(layers(thickness), heights).iter().map(|error| error[0]));
        assert_below(&format!("{thickness}, mean"), miss, thickness.sqrt());
    }
}

#[test]
fn orders() {
    let both = |method: Method<f64>| {
        [mean(focus::<f64>(method, &HEIGHTS).into_iter().map(|e| e[0])), mean(opposite::<f64>(method))]
    };
    for (i, name) in ["focus", "fish-eye"].into_iter().enumerate() {
        let fixed = order(name, &halved(0.05, 6), |length| both(fixed(length))[i]);
        let controlled = order(name, &tenths(1e-3, 5), |tolerance| both(controlled(tolerance))[i]);
        assert!((1.8..2.2).contains(&fixed) && (0.8..1.6).contains(&controlled), "{fixed} {controlled}");
    }
}

/// In the fish-eye light goes along circles that divide each straight line through the centre into parts with the product 1.
#[test]
fn the_fish_eye_has_circles() {
    for (from, _) in rays() {
        for radius in [0.9, 1.0, 1.2] {
            let target = Target::Sphere { center: [0.0; 3], radius };
            let world = World { bend: Bend::Medium(fish_eye(controlled(1e-6))), targets: vec![target] };
            let (point, _) = landing::<f64>(&world, &from);
            // The circle's centre is across the direction of the start, at c with 2c·p = |p|² − 1 for all of its points p.
            let off = circle_error(&from, point);
            assert!(off < 1e-5, "{from:?} {radius}: {off:e}");
        }
    }
}

/// How much 2c·p differs from |p|² − 1.
fn circle_error(from: &Start, point: [f64; 3]) -> f64 {
    let Start { origin: p, direction: d } = *from;
    let along = dot(p, d);
    let across = [0, 1, 2].map(|i| p[i] - along * d[i]);
    // c = p + s·across, from 2c·p = |p|² − 1.
    let s = (-1.0 - dot(p, p)) / (2.0 * dot(across, p));
    let center = [0, 1, 2].map(|i| p[i] + s * across[i]);
    (2.0 * dot(center, point) - dot(point, point) + 1.0).abs()
}
