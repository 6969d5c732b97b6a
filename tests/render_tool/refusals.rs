//! What cannot be joined, and what is said of it.

use std::path::Path;

use exr::prelude as exr_file;
use exr_file::Vec2;

use crate::tool::{files, folder, make_line, run};

/// Exit code 2, one line on the standard error, and every file as before.
fn assert_refused(folder: &Path, line: &str, expected: &str) {
    let contents =
        || files(folder).into_iter().map(|name| std::fs::read(folder.join(&name)).map(|bytes| (name, bytes)));
    let before: Vec<_> = contents().flatten().collect();
    let output = run(folder, &line.split(' ').collect::<Vec<_>>());
    let text = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{line}: {text}");
    assert!(text.starts_with("render: ") && text.contains(expected), "{line}: {text}");
    assert_eq!(text.lines().count(), 1, "{line}: {text}");
    assert!(output.stdout.is_empty(), "{line}");
    assert!(before == contents().flatten().collect::<Vec<_>>(), "{line} changed a file");
}

const SMALL: &str = "--size 8x9 --samples 4";

/// A folder with the parts 1.exr, 2.exr and 3.exr of a picture, and an older picture.
fn folder_of_parts() -> tempfile::TempDir {
    let folder = folder();
    for k in 1..=3 {
        make_line(folder.path(), &format!("{SMALL} --part {k}/3 -o {k}.exr"));
    }
    std::fs::write(folder.path().join("old.png"), "precious").unwrap();
    folder
}

#[test]
fn missing_and_doubled_rows_are_named() {
    let folder = folder_of_parts();
    let at = folder.path();
    make_line(at, &format!("{SMALL} --rows 2..5 -o shifted.exr"));
    let cases = [
        ("1.exr 3.exr", "rows 3..6 are in no part"),
        ("2.exr", "rows 0..3, rows 6..9 are in no part"),
        ("1.exr 2.exr 2.exr 3.exr", "rows 3..6 are in both 2.exr and 2.exr"),
        ("3.exr shifted.exr 1.exr 2.exr", "rows 2..3 are in both 1.exr and shifted.exr"),
        ("shifted.exr 3.exr 2.exr", "rows 3..5 are in both shifted.exr and 2.exr"),
    ];
    for (parts, expected) in cases {
        assert_refused(at, &format!("--join {parts} -o old.png"), expected);
    }
    // A part inside another does not hide that rows after it are doubled.
    make_line(at, &format!("{SMALL} --rows 0..8 -o long.exr"));
    assert_refused(at, "--join long.exr 2.exr 3.exr -o old.png", "rows 3..6 are in both long.exr and 2.exr");
}

#[test]
fn parts_of_another_picture_are_told_apart() {
    let folder = folder_of_parts();
    let at = folder.path();
    std::fs::write(at.join("other.nff"), [&std::fs::read(at.join("balls.nff")).unwrap()[..], b"\n"].concat()).unwrap();
    let cases = [
        ("--size 8x10 --samples 4", "size 8x10, not 8x9"),
        ("--size 9x9 --samples 4", "size 9x9, not 8x9"),
        ("--size 8x9 --samples 5", "samples 5, not 4"),
        ("--size 8x9 --samples 4 --adaptive 0.1", "samples 1 to 4 by a contrast of 0.1, not 4"),
        ("--size 8x9 --samples 4 --depth 7", "depth 7, not 8"),
        ("--size 8x9 --samples 4 --cutoff 0.00392", "cutoff 0.00392, not 0.003921569"),
        ("--size 8x9 --samples 4 --rays-per-pixel 99", "rays per pixel 99, not 4294967295"),
        ("--size 8x9 --samples 4 --steps 9", "steps 9, not 10000"),
        ("--size 8x9 --samples 4 --termination black", "termination Black, not Background"),
        ("card --size 8x9 --samples 4", "scene card, not showcase; values display, not linear"),
        ("spheres --size 8x9 --samples 4", "scene spheres, not showcase"),
        ("other.nff --size 8x9 --samples 4", "scene a file of "),
    ];
    for (other, expected) in cases {
        make_line(at, &format!("{other} --rows 3..6 -o other.exr"));
        let expected = format!("other.exr: is of another picture than 1.exr: {expected}");
        assert_refused(at, "--join 3.exr other.exr 1.exr -o old.png", &expected);
    }
    make_line(at, &format!("{SMALL} --rows 3..6 -o 2.png --dropped other.exr"));
    assert_refused(at, "--join 1.exr other.exr 3.exr -o old.png", "shows dropped throughput, not light");
    // Neither the name of a file nor where it is counts, but what is in it does.
    std::fs::copy(at.join("balls.nff"), at.join("same.nff")).unwrap();
    for (file, rows) in [("balls", "0..4"), ("same", "4..9"), ("other", "4..9")] {
        make_line(at, &format!("{file}.nff {SMALL} --rows {rows} -o {file}.exr"));
    }
    make_line(at, "--join balls.exr same.exr -o balls.png");
    assert_refused(
        at,
        "--join balls.exr other.exr -o old.png",
        "other.exr: is of another picture than balls.exr: scene",
    );
}

#[test]
fn part_by_another_version_is_refused() {
    let folder = folder_of_parts();
    let at = folder.path();
    let mut bytes = std::fs::read(at.join("2.exr")).unwrap();
    let version = concat!("whit ", env!("CARGO_PKG_VERSION"));
    let place = bytes.windows(version.len()).position(|window| window == version.as_bytes()).unwrap();
    bytes[place + "whit ".len()] = b'9';
    std::fs::write(at.join("other.exr"), bytes).unwrap();
    assert_refused(
        at,
        "--join 1.exr other.exr 3.exr -o old.png",
        "other.exr: is of another picture than 1.exr: tool whit 9",
    );
}

#[test]
fn what_is_no_part_is_refused() {
    let folder = folder_of_parts();
    let at = folder.path();
    make_line(at, &format!("{SMALL} --rows 3..6 -o part.png"));
    image::Rgb32FImage::new(8, 3).save(at.join("plain.exr")).unwrap();
    save_in_half_precision(&at.join("2.exr"), &at.join("half.exr"));
    std::fs::write(at.join("empty.exr"), "").unwrap();
    let not_ours = "is no part: this tool did not write it, or not as it is";
    let cases = [
        ("part.png", "part.png: is no OpenEXR file, or not all of one"),
        ("empty.exr", "empty.exr: is no OpenEXR file, or not all of one"),
        ("plain.exr", &format!("plain.exr: {not_ours}")),
        ("half.exr", &format!("half.exr: {not_ours}")),
        ("nowhere.exr", "nowhere.exr: No such file"),
        ("part*.exr", "part*.exr: No such file"),
        (".", ".: is a folder"),
    ];
    for (file, expected) in cases {
        assert_refused(at, &format!("--join 1.exr {file} 3.exr -o old.png"), expected);
    }
}

/// What another program might make of a part: it keeps the attributes, but not the bits.
fn save_in_half_precision(from: &Path, to: &Path) {
    use exr_file::{Image, Layer, ReadChannels, ReadLayers, SpecificChannels, WritableImage, f16};
    let create = |size: Vec2<usize>, _: &_| (size, ());
    let part = exr_file::read().no_deep_data().largest_resolution_level();
    let part = part.rgb_channels(create, |_, _, _: (f32, f32, f32)| {}).first_valid_layer().all_attributes();
    let part = part.from_file(from).unwrap();
    let channels = SpecificChannels::rgb(|_: Vec2<usize>| (f16::ONE, f16::ONE, f16::ONE));
    let layer = Layer::new(part.layer_data.size, part.layer_data.attributes, part.layer_data.encoding, channels);
    Image::new(part.attributes, layer).write().to_file(to).unwrap();
}

#[test]
fn part_cut_short_is_refused() {
    let folder = folder_of_parts();
    let at = folder.path();
    let bytes = std::fs::read(at.join("2.exr")).unwrap();
    for length in [3, 4, 8, 100, 300, bytes.len() / 2, bytes.len() - 1] {
        std::fs::write(at.join("short.exr"), &bytes[..length]).unwrap();
        assert_refused(at, "--join 1.exr short.exr 3.exr -o old.png", "short.exr: is no");
    }
}

#[test]
fn output_does_not_overwrite_a_part() {
    let folder = folder_of_parts();
    let at = folder.path();
    std::os::unix::fs::symlink("2.exr", at.join("link.exr")).unwrap();
    assert_refused(at, "--join 1.exr 2.exr 3.exr -o 2.exr", "2.exr: is a part, and would be overwritten");
    assert_refused(at, "--join 1.exr 2.exr 3.exr -o ./2.exr", "2.exr: is a part, and would be overwritten");
    assert_refused(at, "--join 1.exr 2.exr 3.exr -o link.exr", "2.exr: is a part, and would be overwritten");
    assert_refused(at, "--join 1.exr 2.exr 3.exr -o x.jpg", "x.jpg: expected a name that ends in .png or .exr");
    assert_refused(at, "--join 1.exr 2.exr 3.exr -o no/x.png", "no/x.png: the folder does not exist");
}

#[test]
fn join_goes_with_the_output_alone() {
    let folder = folder_of_parts();
    let at = folder.path();
    assert_refused(at, "--join -o x.png", "a value is required for '--join <FILE>...' but none was supplied");
    assert_refused(at, "--join 1.exr 2.exr 3.exr", "required arguments were not provided: --output <FILE>");
    assert_refused(
        at,
        "showcase --join 1.exr 2.exr 3.exr -o x.png",
        "'[SCENE]' cannot be used with '--join <FILE>...'",
    );
    let help = String::from_utf8(run(at, &["--help"]).stdout).unwrap();
    let options = help.lines().filter_map(|line| line.trim_start().strip_prefix("--"));
    let mut count = 0;
    for mut words in options.map(str::split_whitespace) {
        let name = words.next().unwrap();
        if name == "join" {
            continue;
        }
        let value = match (name, words.next().filter(|value| value.starts_with('<'))) {
            (_, None) => "",
            ("size", _) => " 8x9",
            ("rows", _) => " 0..1",
            ("part", _) => " 1/2",
            ("termination", _) => " black",
            _ => " 1",
        };
        let expected = "cannot be used with";
        assert_refused(at, &format!("--{name}{value} --join 1.exr 2.exr 3.exr -o x.png"), expected);
        count += 1;
    }
    assert!(count >= 15, "{help}");
}
