//! The programs that are measured: each renders one scene on bare metal.

use whit::scenes;

/// A program that renders a scene.
#[derive(Clone, Debug)]
pub struct Program {
    /// What the page calls it.
    pub name: String,
    /// The bounces that its frame has room for.
    pub bounces: usize,
    pub source: String,
}

/// The bounces of most programs, and others to show that they do not matter.
const BOUNCES: usize = 5;
const OTHER_BOUNCES: [usize; 2] = [1, 64];

/// Number types besides `f32`, in `whit::math`.
const NUMBERS: [&str; 2] = ["Fast", "Q20"];

/// All programs: every built-in scene, and one for scenes that are known only at run time, which has all effects.
pub fn all() -> Vec<Program> {
    let mut programs: Vec<Program> = scenes::ALL.iter().map(|(name, _)| constant(name, BOUNCES)).collect();
    programs.extend(OTHER_BOUNCES.map(|bounces| constant("showcase", bounces)));
    programs.push(at_run_time(BOUNCES));
    programs.extend(OTHER_BOUNCES.map(at_run_time));
    programs.extend(NUMBERS.map(in_number));
    programs
}

/// A scene that is checked by the compiler, by a tracer for its own effects.
fn constant(name: &str, bounces: usize) -> Program {
    let scene = format!("whit::scenes::{}", name.to_uppercase());
    let source = source(&format!(
        "number: f32, effects: {scene}.effects(), depth: {scene}.stack({bounces}), media: {scene}.media(), \
         tracer: whit::tracer!({scene}, {bounces}), bounces: {}",
        rendered(bounces)
    ));
    Program { name: format!("`{name}`"), bounces, source }
}

/// A scene that is checked and put in boxes by the program, by a tracer for all effects. Which one it is does not show in the
/// code.
fn at_run_time(bounces: usize) -> Program {
    let source = source(&format!(
        "number: f32, effects: whit::Effects::ALL, depth: {bounces}, media: 8, \
         tracer: whit::Tracer::try_new(in_boxes()?).ok()?, bounces: {}",
        rendered(bounces)
    )) + "
        use whit::scene::{Hierarchy, Leaf, Node};
        static GIVEN: whit::Scene<'static, f32> = whit::scenes::GLASS;
        static mut NODES: MaybeUninit<[Node; 8]> = MaybeUninit::uninit();
        static mut LEAVES: MaybeUninit<[Leaf; 32]> = MaybeUninit::uninit();
        static mut SCENE: MaybeUninit<whit::Scene<'static, f32>> = MaybeUninit::uninit();
        #[inline(never)]
        fn in_boxes() -> Option<&'static whit::Scene<'static, f32>> {
            let (nodes, leaves) = unsafe { (&mut *(&raw mut NODES), &mut *(&raw mut LEAVES)) };
            let (nodes, leaves) = (nodes.write([Node::EMPTY; 8]), leaves.write([Leaf::EMPTY; 32]));
            let given = core::hint::black_box(&GIVEN);
            let scene = given.with_hierarchy(Hierarchy::build(given, nodes, leaves).ok()?);
            Some(unsafe { &mut *(&raw mut SCENE) }.write(scene))
        }
        ";
    Program { name: "any, at run time".to_owned(), bounces, source }
}

/// The same in another number type, into which the program converts the scene.
fn in_number(name: &str) -> Program {
    let number = format!("whit::math::{name}");
    let source = source(&format!(
        "number: {number}, effects: whit::Effects::ALL, depth: {BOUNCES}, media: 8, \
         tracer: whit::Tracer::try_new(converted()?).ok()?, bounces: {BOUNCES}",
    )) + &format!(
        "static GIVEN: whit::Scene<'static, f32> = whit::scenes::SHOWCASE;
        static mut BUFFER: MaybeUninit<whit::SceneBuf<{number}, 16, 4>> = MaybeUninit::uninit();
        static mut SCENE: MaybeUninit<whit::Scene<'static, {number}>> = MaybeUninit::uninit();
        #[inline(never)]
        fn converted() -> Option<&'static whit::Scene<'static, {number}>> {{
            let (buffer, scene) = unsafe {{ (&mut *(&raw mut BUFFER), &mut *(&raw mut SCENE)) }};
            let buffer = buffer.write(whit::SceneBuf::EMPTY);
            buffer.copy_from(core::hint::black_box(&GIVEN), <{number} as whit::Real>::from_f32).ok()?;
            Some(scene.write(buffer.as_scene()))
        }}
        "
    );
    Program { name: format!("any, at run time, in `{name}`"), bounces: BOUNCES, source }
}

/// A tree of 64 bounces would be followed for ever.
fn rendered(bounces: usize) -> usize {
    bounces.min(BOUNCES)
}

fn source(scene: &str) -> String {
    let firmware = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/stack/firmware.rs");
    format!("#![no_std]\n#![no_main]\n#[macro_use]\n#[path = {firmware:?}]\nmod firmware;\nfirmware!({scene});\n")
}
