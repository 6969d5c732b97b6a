//! What is claimed of a whole linked program: nothing in it panics and no function is called by its address.

use crate::graph::Graph;
use crate::image::{Image, Relocation};
use crate::names::{full, short};
use crate::problem::Problem;

/// Relocations of the ELF of the Arm architecture (IHI 0044) in Thumb code and in constants.
mod kind {
    /// Calls and jumps: `R_ARM_THM_CALL`, `_JUMP24`, `_JUMP19`, `_JUMP6`, `_JUMP11`, `_JUMP8`.
    pub const BRANCHES: [u32; 6] = [10, 30, 51, 52, 102, 103];
    /// An address in a word: `R_ARM_ABS32`, the only one that says which by what is in the word.
    pub const WORD: u32 = 2;
    /// An address relative to the place, or in two instructions: `R_ARM_REL32`, `R_ARM_THM_MOVW_ABS_NC`, `_MOVT_ABS`,
    /// `_MOVW_PREL_NC`, `_MOVT_PREL`.
    pub const ADDRESSES: [u32; 5] = [3, 47, 48, 49, 50];
}

/// The part of a program that the processor looks up, with the address of the first function.
const VECTORS: &str = ".vectors";

/// The panics in a program; `from` is where it begins, to say how they are reached.
pub fn panics(image: &Image, from: &str) -> Result<Vec<Problem>, String> {
    let panics: Vec<&String> = image.symbols.iter().filter(|symbol| is_panic(&full(symbol))).collect();
    if panics.is_empty() {
        return Ok(Vec::new());
    }
    let (graph, start) = Graph::from(image, from)?;
    let problem = |symbol: &String| {
        let path = image.function_named(symbol).map(|function| graph.path(start, function.start));
        Problem::Panic { symbol: full(symbol), path: path.unwrap_or_default() }
    };
    Ok(panics.into_iter().map(problem).collect())
}

/// All panics go through `core::panicking` and end in the program's own handler; the others are those of `core` that say
/// more in the name.
fn is_panic(path: &str) -> bool {
    path.contains("panicking")
        || path.contains("rust_begin_unwind")
        || path.contains("panic_")
        || path.ends_with("_fail")
        || path.ends_with("_failed")
}

/// Functions of which the address is kept somewhere, and relocations of which the meaning is not known.
pub fn addresses(image: &Image) -> Vec<Problem> {
    let places = image.relocations.values().filter(|place| place.section != VECTORS && !is_harmless(place));
    places.filter_map(|place| kept(image, place)).collect()
}

/// A call or a jump, or the address of something that is not code.
fn is_harmless(place: &Relocation) -> bool {
    let is_address = place.kind == kind::WORD || kind::ADDRESSES.contains(&place.kind);
    kind::BRANCHES.contains(&place.kind) || is_address && !place.is_code
}

fn kept(image: &Image, place: &Relocation) -> Option<Problem> {
    let inside = image.function_at(place.address);
    let here = inside.map_or_else(|| place.section.clone(), |function| short(&function.name));
    let target = if place.kind == kind::WORD { image.word(place.address)? } else { place.symbol } & !1;
    let function = image.function_at(target);
    // A table of places within the function, to jump to.
    let is_own = function.map(|function| function.start) == inside.map(|function| function.start);
    match function {
        Some(_) if is_own && place.kind == kind::WORD => None,
        Some(function) => Some(Problem::AddressTaken { function: short(&function.name), place: here }),
        None => {
            let what = format!("relocation {} to {target:#x} is not understood", place.kind);
            Some(Problem::Unclear { function: here, address: place.address, what })
        }
    }
}

/// Calls of which the linker knows another target than the code, or none.
pub fn unconfirmed(image: &Image, graph: &Graph<'_>) -> Vec<Problem> {
    let unconfirmed = graph.calls().filter(|(_, place, target)| match image.relocations.get(place) {
        Some(relocation) => !kind::BRANCHES.contains(&relocation.kind) || relocation.symbol & !1 != *target,
        None => true,
    });
    unconfirmed
        .map(|(function, address, target)| Problem::Unclear {
            function: short(&function.name),
            address,
            what: format!("calls {target:#x}, and the linker knows nothing of that"),
        })
        .collect()
}
