//! Scenes on the display of a small device, in a window, rendered from coarse to fine.
//!
//!     cargo run --release --manifest-path examples/simulator/Cargo.toml
//!     cargo run --release --manifest-path examples/simulator/Cargo.toml -- mono glass
//!
//! It needs SDL2 (`libsdl2-dev` on Debian, `sdl2` from Homebrew). Where there is none, the finished picture can still be
//! written to a file:
//!
//!     EG_SIMULATOR_DUMP=target/simulator.png \
//!     cargo run --release --manifest-path examples/simulator/Cargo.toml --no-default-features -- grey card

mod panel;
mod show;
mod view;

use std::error::Error;
use std::process::ExitCode;

use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Rgb565};
use view::View;

const USAGE: &str = "simulator [DISPLAY] [SCENE]

displays  color  320 x 240 pixels in 65536 colours; if none is named
          grey   128 x 64 pixels in 16 greys
          mono   128 x 64 pixels, lit or dark
scenes    ";

pub const KEYS: &str = "left, right, up, down  move around      plus, minus  nearer, farther
N, P                   next, previous   R  back to the start   Esc  close";

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let mut arguments: Vec<_> = std::env::args().skip(1).collect();
    if arguments.iter().any(|argument| argument == "--help" || argument == "-h") {
        println!("{}", usage());
        return Ok(());
    }
    let is_display = arguments.first().is_some_and(|first| ["color", "grey", "mono"].contains(&first.as_str()));
    let display = if is_display { arguments.remove(0) } else { "color".to_owned() };
    let view = match &arguments[..] {
        [] => View::FIRST,
        [scene] => View::of(scene).ok_or_else(|| format!("there is no display or scene `{scene}`\n\n{}", usage()))?,
        _ => return Err(format!("expected a display and a scene\n\n{}", usage()).into()),
    };
    match display.as_str() {
        "grey" => show::run::<Gray4>(view),
        "mono" => show::run::<BinaryColor>(view),
        _ => show::run::<Rgb565>(view),
    }
}

fn usage() -> String {
    format!("{USAGE}{}\n\n{KEYS}", whit::scenes::ALL.map(|(name, _)| name).join(", "))
}
