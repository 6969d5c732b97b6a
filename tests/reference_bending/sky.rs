//! Stars and rings.

use whit::Rgb;
use whit::Vec3;
use whit::scene::{Background, Pattern};

use super::reference::light::background;
use super::reference::shade::pattern;
use super::reference::vector::{Color, Vector};

const CELLS: u16 = 20;
const SKY: Background<f32> =
    Background::Stars { sky: Rgb::new(0.01, 0.02, 0.03), brightness: 2.0, cells: CELLS, radius: 0.25 };

/// The direction to a place of a face of the cube, from −1 to 1.
fn direction(face: usize, u: f64, v: f64) -> Vector {
    let mut axes = [0.0; 3];
    axes[face / 2] = [1.0, -1.0][face % 2];
    axes[(face / 2 + 1) % 3] = u;
    axes[(face / 2 + 2) % 3] = v;
    let [x, y, z] = axes;
    Vector::new(x, y, z).normalized()
}

/// One star at most in a cell, in half of all cells, none brighter than the brightest and none across the border of its cell.
#[test]
fn half_of_all_cells_hold_a_star() {
    let sky = Color([0.01_f32, 0.02, 0.03].map(f64::from));
    let (mut stars, mut brightest) = (0, 0.0_f64);
    let fine = 16;
    for face in 0..6 {
        for cell in 0..usize::from(CELLS).pow(2) {
            let (i, j) = (cell % usize::from(CELLS), cell / usize::from(CELLS));
            let mut most = 0.0_f64;
            for place in 0..(fine + 1) * (fine + 1) {
                let [x, y] = [place % (fine + 1), place / (fine + 1)]
                    .map(|at| (at as f64 / fine as f64).clamp(1e-6, 1.0 - 1e-6));
                let at = |cell: usize, within: f64| 2.0 * (cell as f64 + within) / f64::from(CELLS) - 1.0;
                let light = background(&SKY, direction(face, at(i, x), at(j, y)));
                let more = (light + sky * -1.0).max_channel();
                if [x, y].iter().any(|at| !(1e-5..=1.0 - 1e-5).contains(at)) {
                    assert!(more < 1e-6, "a star at the border of a cell");
                }
                most = most.max(more);
            }
            stars += usize::from(most > 0.0);
            brightest = brightest.max(most);
        }
    }
    let share = stars as f64 / (6.0 * f64::from(CELLS).powi(2));
    println!("{share:.3} of the cells hold a star, the brightest of {brightest:.3}");
    assert!((0.45..0.55).contains(&share) && (1.5..=2.0).contains(&brightest));
}

#[test]
fn the_corners_of_the_sky_have_a_face() {
    for x in [-1.0, 1.0] {
        for y in [-1.0, 1.0] {
            for z in [-1.0, 1.0] {
                assert!(background(&SKY, Vector::new(x, y, z).normalized()).max_channel().is_finite());
            }
        }
    }
}

#[test]
fn rings_alternate() {
    let rings = Pattern::Rings { even: Rgb::WHITE, odd: Rgb::BLACK, center: Vec3::new(1.0, 0.0, 0.0), width: 0.5 };
    for (x, color) in [(1.2, Color::WHITE), (1.7, Color::BLACK), (0.3, Color::BLACK), (-0.2, Color::WHITE)] {
        assert_eq!(pattern(&rings, Vector::new(x, 0.0, 0.0)), color, "{x}");
    }
}
