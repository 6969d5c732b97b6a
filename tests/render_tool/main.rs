//! The `render` example as its users meet it: files, counts and errors.
#![cfg(all(unix, feature = "nff"))]
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

mod parts;
mod refusals;
mod tool;

use std::path::Path;
use std::process::Command;

use tool::{files, folder, run, tool};

#[test]
fn default_is_a_picture_of_the_showcase() {
    let folder = folder();
    let output = run(folder.path(), &["--size", "64x48", "--samples", "1"]);
    assert!(output.status.success() && output.stdout.is_empty() && output.stderr.is_empty(), "{output:?}");
    let picture = image::open(folder.path().join("target/render/showcase.png")).unwrap().into_rgb8();
    assert_eq!(picture.dimensions(), (64, 48));
    let darkest = picture.pixels().flat_map(|pixel| pixel.0).min().unwrap();
    let brightest = picture.pixels().flat_map(|pixel| pixel.0).max().unwrap();
    assert!(darkest < 60 && brightest > 200, "{darkest} {brightest}");
}

#[test]
fn file_to_linear_exr_with_stats() {
    let folder = folder();
    let arguments = ["balls.nff", "-o", "x.exr", "--size", "40x30", "--samples", "1", "--depth", "4", "--stats"];
    let output = run(folder.path(), &[&arguments[..], &["--dropped", "dropped.exr"]].concat());
    assert!(output.status.success(), "{output:?}");
    let stats: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(stats["eye"], 1200);
    for count in
        ["reflected", "transmitted", "shadow", "total_internal", "cut_by_depth", "cut_by_cutoff", "cut_by_budget"]
    {
        assert!(stats[count].is_u64(), "{count}: {stats}");
    }
    assert!(stats["seconds"].as_f64().unwrap() > 0.0 && stats["ns_per_ray"].as_f64().unwrap() > 0.0);
    let picture = image::open(folder.path().join("x.exr")).unwrap().into_rgb32f();
    assert_eq!(picture.dimensions(), (40, 30));
    assert_eq!(picture.as_raw(), &by_the_library(&folder.path().join("balls.nff")));
    assert_eq!(files(folder.path()), ["balls.nff", "dropped.exr", "x.exr"]);
}

/// The linear values of the same picture, without the tool.
fn by_the_library(file: &Path) -> Vec<f32> {
    use whit::render::{LinearRgb, Size};
    use whit::{Background, Camera, Effects, Frame, Rgb, SceneBuf, Settings, Tracer, Vec3};
    let camera = Camera::look_at(Vec3::new(0.0, 0.0, 1.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 45.0);
    let mut buffer = SceneBuf::<f32, 64, 4>::new(camera, Background::Solid(Rgb::BLACK));
    whit::scene::nff::read_bytes(&std::fs::read(file).unwrap(), &mut buffer).unwrap();
    let mut pixels = [Rgb::BLACK; 1200];
    let scene = buffer.as_scene();
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 4>::try_new(&scene).unwrap();
    let mut target = LinearRgb::new(Size::new(40, 30), &mut pixels).unwrap();
    Frame::new(&tracer, Settings::new(40, 30).with_depth(4)).unwrap().render(&mut target).unwrap();
    pixels.iter().flat_map(|color| [color.r, color.g, color.b]).collect()
}

/// Rows and threads do not change a byte.
#[test]
fn rows_and_threads_make_the_same_picture() {
    let folder = folder();
    let size = ["card", "--size", "24x20", "--samples", "4"];
    for extra in [&["-o", "whole.png", "--threads", "1"][..], &["-o", "low.png", "--rows", "12..20", "--threads", "3"]]
    {
        assert!(run(folder.path(), &[&size[..], extra].concat()).status.success());
    }
    let open = |name: &str| image::open(folder.path().join(name)).unwrap().into_rgb8();
    let (whole, low) = (open("whole.png"), open("low.png"));
    assert_eq!(low.dimensions(), (24, 8));
    assert_eq!(low.as_raw()[..], whole.as_raw()[24 * 12 * 3..]);
}

#[test]
fn list_names_scenes_and_effects() {
    let output = run(folder().path(), &["--list"]);
    let text = String::from_utf8(output.stdout).unwrap();
    let lines: Vec<_> = text.lines().collect();
    assert_eq!(lines.len(), whit::scenes::ALL.len());
    assert!(lines[0].starts_with("showcase") && lines[0].contains("dielectric"), "{text}");
}

/// Whoever reads one line and goes away gets no complaint; a full disk is one.
#[test]
fn closed_pipe_ends_quietly() {
    let folder = folder();
    let small = ["--size", "8x6", "--samples", "1", "-o", "x.png", "--stats"];
    for arguments in [&["--list"][..], &["--help"], &small] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let output = Command::new(tool()).current_dir(folder.path()).args(arguments).stdout(writer).output().unwrap();
        assert!(output.status.success() && output.stderr.is_empty(), "{arguments:?}: {output:?}");
    }
    assert!(files(folder.path()).contains(&"x.png".to_owned()));
    if let Ok(full) = std::fs::File::create("/dev/full") {
        let output = Command::new(tool()).arg("--list").stdout(full).output().unwrap();
        assert_eq!(output.status.code(), Some(2));
        let text = String::from_utf8(output.stderr).unwrap();
        assert!(text.starts_with("render: the standard output: No space left"), "{text}");
    }
}

#[test]
fn every_built_in_scene_is_rendered() {
    let folder = folder();
    let pictures = whit::scenes::ALL.map(|(name, _)| {
        let output = run(folder.path(), &[name, "--size", "16x12", "--samples", "1", "-o", "picture.png"]);
        assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
        std::fs::read(folder.path().join("picture.png")).unwrap()
    });
    for (i, picture) in pictures.iter().enumerate() {
        assert!(!pictures[..i].contains(picture), "{} shows another scene", whit::scenes::ALL[i].0);
    }
}

/// One line on stderr, exit code 2, nothing written, nothing lost.
#[test]
fn bad_input_is_one_clear_line() {
    let folder = folder();
    let at = folder.path();
    std::fs::write(at.join("broken.nff"), "v\nfrom 0 0 x\n").unwrap();
    std::fs::write(at.join("old.png"), "precious").unwrap();
    let before = files(at);
    let names = whit::scenes::ALL.map(|(name, _)| name).join(", ");
    let unknown = format!("scene `teapot`: expected one of {names}, or a path to an .nff file");
    let cases: [(&[&str], &str); 20] = [
        (&["teapot"], &unknown),
        (&["nowhere.nff"], "nowhere.nff: No such file"),
        (&["broken.nff", "-o", "old.png"], "broken.nff: line 2: expected a number for `z`, found `x`"),
        (&["--size", "0x10"], "expected 1 to 1048576 pixels a side, found `0`"),
        (&["--size", "640"], "expected WIDTHxHEIGHT, such as 640x480"),
        (&["--size", "1048576x1048576", "-o", "old.png"], "--size: there is no memory for 1099511627776 pixels"),
        (&["--samples", "0"], "invalid value '0' for '--samples <N>'"),
        (&["--depth", "129"], "invalid value '129' for '--depth <D>'"),
        (&["--cutoff", "NaN"], "expected a finite number of at least 0"),
        (&["--termination", "1,2"], "expected background, black or three numbers R,G,B"),
        (&["--rows", "5..5"], "expected FIRST..END with FIRST below END"),
        (&["--rows", "470..490", "-o", "old.png"], "--rows 470..490: the picture has 480 rows"),
        (&["--part", "0/4"], "expected NUMBER/COUNT with NUMBER from 1 to COUNT, such as 3/8"),
        (&["--part", "5/4"], "expected NUMBER/COUNT with NUMBER from 1 to COUNT, such as 3/8"),
        (&["--part", "1/481", "-o", "old.png"], "--part 1/481: the picture has 480 rows"),
        (&["--part", "1/4", "--rows", "0..9"], "'--part <K/N>' cannot be used with '--rows <A..B>'"),
        (&["-o", "picture.jpg"], "picture.jpg: expected a name that ends in .png or .exr"),
        (&["-o", "missing/x.png"], "missing/x.png: the folder does not exist"),
        (&["--frobnicate"], "unexpected argument '--frobnicate' found"),
        (&["--stats", "--dropped", "x.gif", "-o", "old.png"], "x.gif: expected a name that ends in .png or .exr"),
    ];
    for (arguments, expected) in cases {
        let output = run(at, arguments);
        let text = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {text}");
        assert!(text.starts_with("render: ") && text.contains(expected), "{arguments:?}: {text}");
        assert_eq!(text.lines().count(), 1, "{arguments:?}: {text}");
        assert!(output.stdout.is_empty());
        assert_eq!(files(at), before, "{arguments:?}");
        assert_eq!(std::fs::read_to_string(at.join("old.png")).unwrap(), "precious");
    }
}
