//! What is rendered: chosen when the program is compiled, so that it is all that is in it.

use whit::Scene;

use crate::scenes::{ALL, Peer};

/// The scene and how it is rendered: WHIT_SCENE.
pub const PEER: Peer = named(match option_env!("WHIT_SCENE") {
    Some(name) => name,
    None => "raystones",
});

/// The scene alone.
pub const SCENE: Scene<'static, f32> = PEER.scene;

/// Below which weight branches are cut: WHIT_CUTOFF.
pub const CUTOFF: f32 = match option_env!("WHIT_CUTOFF") {
    Some(text) if same(text.as_bytes(), b"0") => 0.0,
    Some(text) if !same(text.as_bytes(), b"1/255") => panic!("WHIT_CUTOFF: expected 0 or 1/255"),
    _ => 1.0 / 255.0,
};

/// Whether rays are counted: always where instructions are not, else by WHIT_COUNT.
pub const IS_COUNTED: bool = cfg!(not(target_os = "none")) || option_env!("WHIT_COUNT").is_some();

const fn named(name: &str) -> Peer {
    let mut place = 0;
    while place < ALL.len() {
        if same(ALL[place].name.as_bytes(), name.as_bytes()) {
            return ALL[place];
        }
        place += 1;
    }
    panic!("WHIT_SCENE: expected card, raystones or ftb")
}

/// Whether two texts are the same.
const fn same(one: &[u8], other: &[u8]) -> bool {
    let mut place = 0;
    while place < one.len() && place < other.len() && one[place] == other[place] {
        place += 1;
    }
    place == one.len() && place == other.len()
}
