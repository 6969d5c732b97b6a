//! What a tracer of a scene is made of: small programs that render one scene, compiled and looked into.

#![allow(dead_code)] // The tool looks at sizes, the test at names.

#[path = "library.rs"] // Also when this file is part of a program in another folder.
mod library;

use object::{Object, ObjectSection, ObjectSymbol, SectionKind};

pub use library::Library;

/// A compiled program that renders one scene.
pub struct Probe {
    /// Bytes of code. On the machine at hand without the functions that it shares with other programs (`libm`).
    pub code: u64,
    /// Bytes of a frame of 5 bounces.
    pub frame: u64,
    /// The names of the functions in it and of those that it calls.
    symbols: String,
    /// The same, with the names of those that became part of others.
    names: String,
}

impl Library {
    /// Compiles the program for one scene of `scenes.rs`.
    ///
    /// `level` is the compiler's `opt-level`. Without linking, at "s" and below 2, the compiler leaves functions in that
    /// nothing uses.
    pub fn probe(&self, scene: &str, level: &str) -> Result<Probe, String> {
        let level_flag = format!("opt-level={level}");
        let mut arguments = vec!["-C", "debuginfo=2", "-C", &level_flag];
        let linked = ["bin", "-C", "link-args=--entry=render --undefined=FRAME --gc-sections"];
        arguments.push("--crate-type");
        arguments.extend_from_slice(if self.target.is_some() { &linked } else { &["lib", "--emit", "obj"] });
        let source = source_of(scene, self.target.is_some());
        let output = self.compile(&format!("probe_{scene}_{level}"), &source, &arguments)?;
        let bytes = std::fs::read(&output).map_err(|error| error.to_string())?;
        Probe::read(&bytes).map_err(|error| format!("{}: {error}", output.display()))
    }
}

impl Probe {
    fn read(bytes: &[u8]) -> object::Result<Self> {
        let file = object::File::parse(bytes)?;
        let code = file.sections().filter(|section| section.kind() == SectionKind::Text).map(|text| text.size()).sum();
        let frame = file.symbols().find(|symbol| symbol.name() == Ok("FRAME")).map_or(0, |symbol| symbol.size());
        let mut names = String::new();
        for section in file.sections().filter(|section| section.name().is_ok_and(|name| name.starts_with(".debug_str")))
        {
            names.push_str(&String::from_utf8_lossy(&section.uncompressed_data()?));
        }
        let symbols: String = file.symbols().filter_map(|symbol| symbol.name().ok()).collect();
        names.push_str(&symbols);
        Ok(Self { code, frame, symbols, names })
    }

    /// Whether there is anything in it that can panic.
    pub fn can_panic(&self) -> bool {
        self.symbols.contains("4core9panicking")
    }

    /// Whether any code of a function is in it. `module::function` names one of several.
    pub fn has(&self, function: &str) -> bool {
        // As the compiler writes names: each part after its length.
        let mangled: String = function.split("::").map(|part| format!("{}{part}", part.len())).collect();
        self.names.contains(&mangled)
    }
}

fn source_of(scene: &str, is_bare: bool) -> String {
    let scenes = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/effects/scenes.rs");
    let bare = "#[panic_handler]\nfn panic(_: &core::panic::PanicInfo) -> ! {\n    loop {}\n}\n";
    let (main, panic) = if is_bare { ("#![no_main]\n", bare) } else { ("", "") };
    format!(
        r#"#![no_std]
{main}
#[path = {scenes:?}]
mod scenes;
use core::convert::Infallible;
use scenes::{scene} as SCENE;
use whit::render::{{ForEach, Pixel, Size}};
use whit::{{Frame, Settings}};

type Drawn = Frame<'static, f32, {{ SCENE.effects().bits() }}, {{ SCENE.stack(5) }}, (), {{ SCENE.media() }}>;

#[used]
#[unsafe(no_mangle)]
pub static FRAME: [u8; size_of::<Drawn>()] = [0; size_of::<Drawn>()];

#[unsafe(no_mangle)]
pub extern "C" fn render() {{
    let tracer = whit::tracer!(SCENE);
    let mut target = ForEach::new(Size::new(64, 48), |pixel: Pixel| {{
        core::hint::black_box(pixel);
        Ok::<(), Infallible>(())
    }});
    if let Ok(mut frame) = Frame::new(&tracer, Settings::new(64, 48)) {{
        let _ = frame.render(&mut target);
    }}
}}
{panic}"#
    )
}
