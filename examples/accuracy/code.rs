//! A setting as the code that a user of the library writes.

use std::fmt::Write;

use whit::Termination;
use whit::render::Sampling;
use whit::scene::Fresnel;

use crate::number_name::NumberName;
use crate::setting::{Path, Setting, SpectrumName};

/// The code for a picture of a built-in scene.
pub fn of(setting: &Setting, scene: &str) -> String {
    let mut code = String::new();
    let constant = format!("scenes::{}", scene.to_uppercase());
    let (depth, number) = (setting.depth, setting.number.type_name());
    let changes = changes(setting);
    if !changes.is_empty() {
        let _ = writeln!(code, "const SCENE: Scene<'static, f32> = {constant}{changes};");
    }
    let scene = if changes.is_empty() { constant.as_str() } else { "SCENE" };
    if let Some(film) = film(setting.spectrum) {
        let _ = writeln!(code, "// Of each film: .with_spectrum({film})");
    }
    match setting.path {
        Path::Own => {}
        Path::Layers(thickness) => {
            let _ = writeln!(code, "// Of each profile: method: Method::Layers {{ thickness: {thickness:?} }}");
        }
        Path::Fixed(length) => with_steps(&mut code, &format!("Fixed {{ length: {length:?} }}")),
        Path::Controlled(tolerance) => with_steps(&mut code, &format!("Controlled {{ tolerance: {tolerance:?} }}")),
    }
    if setting.number == NumberName::F32 {
        let _ = writeln!(code, "let tracer = whit::tracer!({scene}, {depth});");
    } else {
        // In the copy, what was in lists stands alone.
        let _ = writeln!(
            code,
            "const EFFECTS: Effects = {scene}.effects().with(Effects::SPHERE).with(Effects::TRIANGLE);\n\
             let copy = SceneBuf::<{number}, 128, 8, 4>::from_scene(&{scene}, {number}::from_f32)?;\n\
             let copy = copy.as_scene();\n\
             let tracer = Tracer::<{number}, {{ EFFECTS.bits() }}, {{ {scene}.stack({depth}) }}, \
             {{ {scene}.media() }}>::try_new(&copy)?;"
        );
    }
    let _ = writeln!(code, "let budget = {};", budget(setting));
    let _ = writeln!(
        code,
        "let settings = Settings {{ budget, sampling: {}, ..Settings::new(width, height) }};",
        sampling(setting.sampling, setting.number)
    );
    code
}

/// Of the scene as a whole.
fn changes(setting: &Setting) -> String {
    let mut changes = String::new();
    if setting.fresnel == Fresnel::Schlick {
        changes.push_str(".with_fresnel(Fresnel::Schlick)");
    }
    if let Some(distance) = setting.offset {
        let _ = write!(changes, ".with_offset(Offset::Fixed({distance:?}))");
    }
    changes
}

fn budget(setting: &Setting) -> String {
    let mut fields = String::new();
    let literal = |x| literal(x, setting.number);
    if setting.cutoff != 0.0 {
        let _ = write!(fields, "cutoff: {}, ", literal(setting.cutoff));
    }
    match setting.termination {
        Termination::Background => {}
        Termination::Black => fields.push_str("termination: Termination::Black, "),
        Termination::Color(color) => {
            let [r, g, b] = [color.r, color.g, color.b].map(literal);
            let _ = write!(fields, "termination: Termination::Color(Rgb::new({r}, {g}, {b})), ");
        }
    }
    let plain = format!("Budget::with_depth({})", setting.depth);
    if fields.is_empty() { plain } else { format!("Budget {{ {fields}..{plain} }}") }
}

/// A number in a number type.
fn literal(x: f32, number: NumberName) -> String {
    match number {
        NumberName::F32 | NumberName::F64 => format!("{x:?}"),
        _ => format!("{}::from_f32({x:?})", number.type_name()),
    }
}

fn sampling(sampling: Sampling<f32>, number: NumberName) -> String {
    match sampling {
        Sampling::Grid(n) => format!("Sampling::Grid({n})"),
        Sampling::Sequence(n) => format!("Sampling::Sequence({n})"),
        Sampling::Adaptive { first, most, contrast } => {
            let contrast = literal(contrast, number);
            format!("Sampling::Adaptive {{ first: {first}, most: {most}, contrast: {contrast} }}")
        }
    }
}

fn film(spectrum: SpectrumName) -> Option<String> {
    match spectrum {
        SpectrumName::Own => None,
        SpectrumName::Wavelengths => Some("Spectrum::Wavelengths".to_owned()),
        SpectrumName::Bands(n) => Some(format!("Spectrum::Bands(&const {{ bands::<{n}>() }})")),
        SpectrumName::Table => Some("Spectrum::Table".to_owned()),
    }
}

fn with_steps(code: &mut String, steps: &str) {
    let _ = writeln!(
        code,
        "// Of each profile: method: Method::Steps(Steps::{steps}); of a black hole: steps: Steps::{steps}"
    );
}
