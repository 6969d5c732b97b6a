//! Pictures made of parts have the bits of those made whole.

use exr::prelude as exr_file;
use exr_file::{AttributeValue, IntegerBounds, MetaData, Text};

use crate::tool::{folder, make_line};

#[allow(dead_code)]
#[path = "../../examples/render/rows.rs"]
mod rows;

/// Renders a picture whole and in parts, and compares what is made of the parts byte by byte, and EXR values bit by bit.
fn compare(picture: &str, parts: &[&str]) {
    let folder = folder();
    let at = folder.path();
    let names: Vec<String> = (0..parts.len()).map(|i| format!("{i}.exr")).collect();
    for (part, name) in parts.iter().zip(&names) {
        make_line(at, &format!("{picture} {part} -o {name} --dropped dropped{name}"));
    }
    make_line(at, &format!("{picture} -o whole.exr --dropped dropped.exr"));
    make_line(at, &format!("{picture} -o whole.png --dropped dropped.png"));
    let names = names.join(" ");
    let of_dropped = names.split(' ').map(|name| format!("dropped{name}")).collect::<Vec<_>>().join(" ");
    for (names, whole) in [(&names, "whole"), (&of_dropped, "dropped")] {
        for extension in ["exr", "png"] {
            make_line(at, &format!("--join {names} -o joined.{extension}"));
            let read = |name: &str| std::fs::read(at.join(name).with_extension(extension)).unwrap();
            assert!(read("joined") == read(whole), "{picture}: {whole}.{extension}");
        }
        let bits = |name: &str| {
            let picture = image::open(at.join(name)).unwrap().into_rgb32f();
            picture.into_raw().into_iter().map(f32::to_bits).collect::<Vec<_>>()
        };
        assert_eq!(bits("joined.exr"), bits(&format!("{whole}.exr")));
    }
}

#[test]
fn uneven_parts_join_to_the_whole() {
    let parts = ["--rows 13..20 --threads 3", "--rows 0..3", "--rows 4..13 --threads 1", "--rows 3..4"];
    compare("card --size 24x20 --samples 4", &parts);
}

#[test]
fn parts_of_a_file_with_adaptive_samples_join_to_the_whole() {
    let parts = ["--part 1/5", "--part 2/5", "--part 3/5", "--part 4/5", "--part 5/5"];
    compare("balls.nff --size 20x33 --samples 16 --adaptive 0.05 --termination 0.1,0.2,0.3 --cutoff 0.1", &parts);
}

#[test]
fn parts_with_picked_settings_join_to_the_whole() {
    compare("showcase --size 24x18 --max-error 1/16", &["--part 2/2", "--part 1/2"]);
}

/// More rows than are packed together in a file.
#[test]
fn parts_of_many_rows_join_to_the_whole() {
    compare("bubble --size 16x90 --samples 1", &["--rows 0..1", "--rows 1..40", "--rows 40..90"]);
}

#[test]
fn file_says_which_rows_of_what_it_holds() {
    let folder = folder();
    make_line(folder.path(), "--size 32x24 --samples 1 --part 2/5 -o part.exr");
    let data = MetaData::read_from_file(folder.path().join("part.exr"), true).unwrap();
    let header = &data.headers[0];
    assert_eq!(header.shared_attributes.display_window, IntegerBounds::from_dimensions((32, 24)));
    assert_eq!(header.data_window(), IntegerBounds::new((0, 4), (32, 5)));
    let Some(AttributeValue::Text(text)) = header.own_attributes.other.get(&Text::from("whit")) else {
        panic!("{header:?}")
    };
    let description: serde_json::Value = serde_json::from_str(&text.to_string()).unwrap();
    assert_eq!(description["scene"], "showcase");
    assert_eq!(description["values"], "linear");
    assert_eq!(description["cutoff"], (1.0_f32 / 255.0).to_string());
    assert_eq!(description["tool"], concat!("whit ", env!("CARGO_PKG_VERSION"), " render"));
}

/// For any number of them, and none has two rows more than another.
#[test]
fn numbered_parts_hold_each_row_once() {
    let check = |height: u32, count: u32, numbers: std::ops::RangeInclusive<u32>| {
        let mut end = (u64::from(*numbers.start() - 1) * u64::from(height) / u64::from(count)) as u32;
        for number in numbers {
            let part = rows::parse_part(&format!("{number}/{count}")).unwrap().of(height).unwrap();
            assert_eq!(part.start, end, "{number}/{count} of {height}");
            assert!([height / count, height.div_ceil(count)].contains(&(part.len() as u32)), "{part:?}");
            end = part.end;
        }
        end
    };
    for height in 1..=70 {
        for count in 1..=height {
            assert_eq!(check(height, count, 1..=count), height);
        }
        assert!(rows::Rows::Part(1, height + 1).of(height).is_err());
    }
    let largest = whit::render::Size::LARGEST;
    for count in [1, 3, 1000, largest - 1, largest] {
        assert_eq!(check(largest, count, count.saturating_sub(500).max(1)..=count), largest);
    }
    for wrong in ["0/1", "2/1", "1/0", "1", "1/", "/1", "-1/2", "1/2/3", "1.0/2", "4294967296/4294967296"] {
        assert!(rows::parse_part(wrong).is_err(), "{wrong}");
    }
}
