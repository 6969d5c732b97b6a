//! An effect that a scene does not use is not in the binary, and nothing in it can panic: programs that render a scene
//! with each effect and one without it are compiled, and looked into.
#![allow(missing_docs, clippy::unwrap_used)]

#[path = "../examples/effects/scenes.rs"]
mod scenes;
#[path = "../examples/effects/size.rs"]
mod size;

use std::collections::HashMap;
use std::path::Path;

use rayon::prelude::*;
use size::{Library, Probe};
use whit::{Effects, Scene};

struct Pair {
    with: (&'static str, Scene<'static, f32>),
    without: (&'static str, Scene<'static, f32>),
    function: &'static str,
}

macro_rules! list {
    ($($with:ident, $without:ident, $function:literal;)*) => {
        [$(Pair {
            with: (stringify!($with), scenes::$with),
            without: (stringify!($without), scenes::$without),
            function: $function,
        }),*]
    };
}

#[test]
fn every_effect_has_a_pair() {
    let pairs = scenes::pairs!(list);
    let gained = pairs.iter().fold(Effects::NONE, |all, Pair { with, without, .. }| {
        let gained = with.1.effects().without(without.1.effects());
        assert!(!gained.is_empty(), "{} has no effect that {} has not", with.0, without.0);
        all.with(gained)
    });
    assert_eq!(Effects::ALL.without(gained), Effects::NONE, "effects that no pair shows");
}

#[test]
fn unused_effects_are_not_compiled_and_nothing_panics() {
    let library = Library::build(&Path::new(env!("CARGO_TARGET_TMPDIR")).join("absence"), None).unwrap();
    let pairs = scenes::pairs!(list);
    let mut names: Vec<&str> = pairs.iter().flat_map(|pair| [pair.with.0, pair.without.0]).collect();
    names.sort_unstable();
    names.dedup();
    let probes: HashMap<&str, Probe> =
        names.par_iter().map(|&name| (name, library.probe(name, "2").unwrap())).collect();
    for (name, probe) in &probes {
        assert!(!probe.can_panic(), "{name} can panic");
    }
    for Pair { with: (with, _), without: (without, _), function } in pairs {
        let (more, less) = (&probes[with], &probes[without]);
        println!("{with:20} {:6} bytes, {without:20} {:6}", more.code, less.code);
        assert!(more.frame >= less.frame && less.frame > 0);
        // Of an effect that is no function of its own, the bytes tell less than how the compiler has inlined the rest.
        if !function.is_empty() {
            assert!(more.code > less.code, "{with}: {} bytes of code, {without}: {}", more.code, less.code);
            assert!(more.has(function), "{function} is not found in {with}");
            assert!(!less.has(function), "{function} is found in {without}");
        }
    }
    // Of several ways to compute the same thing, only the one that the scene chooses.
    for (scene, other_ways) in [
        ("EXACT", ["schlick_dielectric", "by_table"]),
        ("SCHLICK", ["fresnel_dielectric", "by_table"]),
        ("FILM_TABLE", ["by_bands", "by_wavelengths"]),
        ("FILM_BANDS", ["by_table", "by_wavelengths"]),
        ("FILM_WAVELENGTHS", ["by_table", "by_bands"]),
        ("HEIGHT", ["orbit", "layers"]),
        ("RADIUS", ["orbit", "towards"]),
        ("BLACK_HOLE", ["graded", "verlet"]),
    ] {
        for way in other_ways {
            assert!(!probes[scene].has(way), "{way} is found in {scene}");
        }
    }
}
