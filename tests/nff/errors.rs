//! What is said about broken files.

use whit::scene::nff::{Found, MAX_VERTICES, NffError, Problem, read_bytes};

use crate::{EVERY_ENTITY, HEAD, other, read_big, try_read};

fn message(text: &str) -> String {
    try_read(text, &mut other::<16, 4>()).expect_err("an error").to_string()
}

fn with_line(line: usize, new: &str) -> String {
    EVERY_ENTITY.lines().enumerate().map(|(i, old)| format!("{}\n", if i + 1 == line { new } else { old })).collect()
}

/// Each line of the table replaces one line of a good file. What takes a whole view to find out is reported at its `v`.
#[test]
fn errors_say_what_was_expected_and_what_was_found() {
    for (line, new, expected) in [
        (4, "resolution 7", "line 4: expected a whole number above 0 for `height`, found the end of the line"),
        (4, "resolution 0 5", "line 4: expected a whole number above 0 for `width`, found `0`"),
        (4, "resolution 7.5 5", "line 4: expected a whole number above 0 for `width`, found `7.5`"),
        (5, "at 0 -5 1", "line 3: expected a point away from the eye for `at`"),
        (6, "from 0 0 9", "line 3: expected a direction that is not the line of sight for `up`"),
        (7, "up 0 0 0", "line 3: expected finite numbers, not all zero for `up`"),
        (7, "at 0 0 1", "line 7: expected one line each of from, at, up, angle, hither and resolution, found `at`"),
        (8, "angle 180", "line 8: expected a number above 0 and below 180 for `angle`, found `180`"),
        (8, "angle 0", "line 8: expected a number above 0 and below 180 for `angle`, found `0`"),
        (8, "angle 179.99999", "line 3: expected a tangent from 1e-6 to 1e6 for `angle`"),
        (8, "hither far", "line 8: expected a number for `hither`, found `far`"),
        (9, "b 0 -1 0", "line 9: expected a number from 0 to 1e12 for `background`"),
        (10, "l 4 -3", "line 10: expected a number for `z`, found the end of the line"),
        (10, "l 4 -3 1e13", "line 10: expected a finite number of at most 1e12 for `position`"),
        (11, "l 4 -3 5 1 0.5", "line 11: expected a number for `b`, found the end of the line"),
        (11, "l 4 -3 5 1 1 1 1", "line 11: expected the end of the line, found `1`"),
        (11, "v", "line 12: expected `from`, found `f`"),
        (12, "f 1 1 1 1 1 1 0", "line 12: expected a number for `ior`, found the end of the line"),
        (12, "f 1 1 1 -1 1 1 0 0", "line 12: expected a number from 0 to 1e12 for `body.diffuse`"),
        (12, "f 1 1 1 1 1.5 1 0 0", "line 12: expected a number from 0 to 1 for `Ks`, found `1.5`"),
        (12, "f 1 1 1 1 1 -0.5 0 0", "line 12: expected a number from 0 to 1e12 for `highlight.exponent`"),
        (12, "f 1 1 1 1 1 1 nan 1", "line 12: expected a number from 0 to 1 for `T`, found `nan`"),
        (12, "f 1 1 1 1 1 1 0.5 0", "line 12: expected a finite number, above 0 where T is for `ior`, found `0`"),
        (12, "s 0 0 0 1", "line 12: expected a surface `f` before the first object, found `s`"),
        (13, "p 2", "line 13: expected a whole number of at least 3 for `number of vertices`, found `2`"),
        (13, "p -1", "line 13: expected a whole number of at least 3 for `number of vertices`, found `-1`"),
        (13, "p 257", "line 13: 257 vertices, but there is room for 256"),
        (14, "2 2 1e99", "line 14: expected a finite number for `z`, found `1e99`"),
        (14, "2 2 1e20", "line 14: expected a finite number of at most 1e12 for `vertex`"),
        (14, "2 2 0 0", "line 14: expected the end of the line, found `0`"),
        (20, "sphere 0 0 0 1", "line 20: expected one of b, v, l, f, s, c, p, pp, found `sphere`"),
        (20, "s 0 0 0 abc", "line 20: expected a number for `radius`, found `abc`"),
        (20, "s 0 0 0 0", "line 20: expected a number from 1e-12 to 1e12 for `radius`"),
        (20, "s 0 0 inf 1", "line 20: expected a finite number for `z`, found `inf`"),
        (20, "s # 0 0 0 1", "line 20: expected a number for `x`, found the end of the line"),
        (
            20,
            "a_very_long_word_of_thirty_three_",
            "line 20: expected one of b, v, l, f, s, c, p, pp, found `a_very_long_word_of_thir…`",
        ),
        (23, "0 0 0", "line 23: expected a number for `radius`, found the end of the line"),
        (25, "c 0 0 0 1 0 0 2 -1", "line 25: expected the sign of `base_radius` for `apex_radius`"),
        (25, "c 0 0 0 1 0 0 0 1", "line 25: expected finite numbers, not all zero for `apex`"),
        (27, "0 0 0 0 0 0", "line 27: expected finite numbers, not all zero for `normal`"),
        (27, "0 0 0 0 0", "line 27: expected a number for `nz`, found the end of the line"),
        (30, "b 0 0 0", "line 30: expected only one background, found `b`"),
    ] {
        assert_eq!(message(&with_line(line, new)), expected);
    }
}

#[test]
fn what_is_missing_at_the_end_is_reported_at_the_last_line() {
    let polygon = format!("{HEAD}p 3\n0 0 0\n1 0 0\n\n# nothing more");
    let patch = format!("{HEAD}pp 3\n0 0 0 0 0 1\n");
    for (text, expected) in [
        ("", "line 1: expected a view `v`, found the end of the file"),
        ("b 0 0 0\n\n", "line 2: expected a view `v`, found the end of the file"),
        ("v\nfrom 0 0 1\nat 0 0 0\n", "line 3: expected `up`, found the end of the file"),
        (&HEAD.replace("angle 40\n", ""), "line 7: expected `angle`, found `f`"),
        (&HEAD.replace("resolution 32 32\n", ""), "line 7: expected `resolution`, found `f`"),
        (&format!("{HEAD}{HEAD}"), "line 9: expected only one view, found `v`"),
        (&format!("{HEAD}c\n0 0 0 1"), "line 10: expected a line `x y z radius` of a cone, found the end of the file"),
        (&polygon, "line 13: expected a vertex `x y z`, found the end of the file"),
        (&patch, "line 10: expected a vertex `x y z nx ny nz`, found the end of the file"),
    ] {
        assert_eq!(message(text), expected);
    }
    assert!(read_big(&HEAD.replace("hither 1\n", "")).0.objects == 0, "`hither` may be missing");
}

#[test]
fn too_much_is_counted_to_the_end() {
    fn problem<const OBJECTS: usize, const LIGHTS: usize>(text: &str) -> NffError {
        try_read(text, &mut other::<OBJECTS, LIGHTS>()).expect_err("too much")
    }
    // The sixth object is the triangle of the patch, which begins in line 26; the third light is in line 30.
    let error = problem::<5, 4>(EVERY_ENTITY);
    assert_eq!(error, NffError { line: 26, problem: Problem::NoRoom { what: "objects", needed: 6, room: 5 } });
    assert_eq!(problem::<1, 4>(EVERY_ENTITY).to_string(), "line 13: 6 objects, but there is room for 1");
    assert_eq!(problem::<6, 2>(EVERY_ENTITY).to_string(), "line 30: 3 lights, but there is room for 2");
    assert!(try_read(EVERY_ENTITY, &mut other::<6, 3>()).is_ok());
    // An error further on comes first.
    assert_eq!(problem::<1, 1>(&with_line(30, "l 0 0")).line, 30);
}

#[test]
fn a_polygon_takes_as_many_vertices_as_documented() {
    let round = |n: usize| {
        let vertex = |i: usize| (i as f32 / n as f32 * std::f32::consts::TAU).sin_cos();
        let lines: String = (0..n).map(vertex).map(|(y, x)| format!("{x} {y} 0\n")).collect();
        format!("{HEAD}p {n}\n{lines}")
    };
    assert_eq!(read_big(&round(MAX_VERTICES)).0.objects, MAX_VERTICES - 2);
    assert_eq!(message(&round(MAX_VERTICES + 1)), "line 9: 257 vertices, but there is room for 256");
}

#[test]
fn bytes_that_are_not_text_are_an_error_in_their_line() {
    let mut scene = other::<16, 4>();
    let error = read_bytes(b"b 0 0 0\n# caf\xe9\n", &mut scene).unwrap_err();
    assert_eq!(error, NffError { line: 2, problem: Problem::NotUtf8 });
    assert_eq!(error.to_string(), "line 2: expected UTF-8 text");
    assert_eq!(scene.as_scene(), other::<16, 4>().as_scene());
}

#[test]
fn errors_outlive_the_text_and_name_the_word() {
    let error = try_read(&with_line(20, "s 0 0 0 abc"), &mut other::<16, 4>()).unwrap_err();
    let Problem::Unexpected { field: Some("radius"), found: Found::Word(word), .. } = &error.problem else {
        panic!("{error:?}")
    };
    assert_eq!(word.as_str(), "abc");
    let _: Box<dyn std::error::Error + Send + Sync + 'static> = error.into();
}
