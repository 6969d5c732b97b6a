//! What is rendered: chosen when the program is compiled, so that it is all that is in it.

use whit::{Scene, scenes};

/// The name of the scene: WHIT_SCENE.
pub const NAME: &str = match option_env!("WHIT_SCENE") {
    Some(name) => name,
    None => "showcase",
};

/// The size of the picture: WHIT_SIZE.
pub const SIZE: [u32; 2] = match option_env!("WHIT_SIZE") {
    Some(size) => numbers(size),
    None => [96, 72],
};

/// The number of bounces: WHIT_DEPTH.
pub const DEPTH: u8 = match option_env!("WHIT_DEPTH") {
    Some(depth) => {
        let [depth] = numbers(depth);
        assert!(depth <= 254, "WHIT_DEPTH: expected at most 254 bounces");
        depth as u8
    }
    None => 5,
};

/// The scene.
pub const SCENE: Scene<'static, f32> = built_in(NAME);

const fn built_in(name: &str) -> Scene<'static, f32> {
    let mut place = 0;
    while place < scenes::ALL.len() {
        if same(scenes::ALL[place].0.as_bytes(), name.as_bytes()) {
            return scenes::ALL[place].1;
        }
        place += 1;
    }
    panic!("WHIT_SCENE: there is no built-in scene of that name; `cargo run --example render -- --list` names them")
}

/// Whether two texts are the same.
pub const fn same(one: &[u8], other: &[u8]) -> bool {
    let mut place = 0;
    while place < one.len() && place < other.len() && one[place] == other[place] {
        place += 1;
    }
    place == one.len() && place == other.len()
}

/// Numbers of at most six digits with `x` between them, as in `64x48`.
const fn numbers<const COUNT: usize>(text: &str) -> [u32; COUNT] {
    let mut numbers = [0; COUNT];
    let (mut which, mut digits, mut place) = (0, 0, 0);
    while place < text.len() {
        match text.as_bytes()[place] {
            digit @ b'0'..=b'9' if digits < 6 => {
                numbers[which] = 10 * numbers[which] + (digit - b'0') as u32;
                digits += 1;
            }
            b'x' if digits > 0 && which + 1 < COUNT => (which, digits) = (which + 1, 0),
            _ => panic!("WHIT_SIZE: expected for example 64x48; WHIT_DEPTH: for example 5"),
        }
        place += 1;
    }
    assert!(which + 1 == COUNT && digits > 0, "WHIT_SIZE: expected for example 64x48; WHIT_DEPTH: for example 5");
    numbers
}
