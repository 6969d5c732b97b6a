//! Any text gives a valid scene or an error that leaves the scene as it was (which `try_read` checks).

use whit::scene::nff::read_bytes;

use crate::{EVERY_ENTITY, FILES, HEAD, Random, other, try_read};

#[test]
fn files_cut_off_anywhere_do_not_panic() {
    let mut good = 0;
    for end in 0..EVERY_ENTITY.len() {
        good += usize::from(try_read(&EVERY_ENTITY[..end], &mut other::<16, 4>()).is_ok());
    }
    assert!(good > 10, "only {good} of the beginnings are files");
}

#[test]
fn words_in_any_order_do_not_panic() {
    const WORDS: [&str; 32] = [
        "v", "b", "l", "f", "s", "c", "p", "pp", "from", "at", "angle", "hither", "0", "1", "-1", "3", "4", "0.5", "2",
        "1e12", "1e-40", "-0", "nan", "inf", "1e39", "é", "\n", "\n", "\n", "\r\n", "#", "256",
    ];
    let mut random = Random(2);
    for _ in 0..20_000 {
        let words: Vec<&str> = (0..1 + random.below(60)).map(|_| WORDS[random.below(WORDS.len())]).collect();
        let _ = try_read(&format!("{HEAD}{}", words.join(" ").replace(" \n ", "\n")), &mut other::<16, 4>());
    }
}

/// Vertices on a small lattice: outlines that touch and cross themselves in every way.
#[test]
fn polygons_of_any_vertices_do_not_panic() {
    let mut random = Random(3);
    for _ in 0..5_000 {
        let n = 3 + random.below(12);
        let mut coordinate = || random.below(4) as f32 * [1.0, 1e-40, 1e11, 0.3][random.below(4)] - 1.0;
        let lines: String = (0..n).map(|_| format!("{} {} {}\n", coordinate(), coordinate(), coordinate())).collect();
        let summary = try_read(&format!("{HEAD}p {n}\n{lines}"), &mut other::<16, 4>()).unwrap();
        assert!(summary.objects <= n - 2);
    }
}

#[test]
fn files_with_a_changed_byte_do_not_panic() {
    let mut random = Random(4);
    for (_, text) in FILES {
        for _ in 0..200 {
            let mut bytes = text.as_bytes().to_vec();
            let place = random.below(bytes.len());
            bytes[place] = b"\n #-.e09vpscflb\xff"[random.below(16)];
            match std::str::from_utf8(&bytes) {
                Ok(text) => drop(try_read(text, &mut other::<640, 16>())),
                Err(_) => assert!(read_bytes(&bytes, &mut other::<1, 1>()).is_err()),
            }
        }
    }
}
