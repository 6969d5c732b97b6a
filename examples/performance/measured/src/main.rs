//! What the example `performance` measures of whit. It is run by that example, once for each number.
//!
//!     measured card SIZE SAMPLES PICTURE
//!     measured render SCENE COUNT LAYOUT SIZE PICTURE
//!     measured rays SCENE COUNT SIZE RAYS SHAPES
//!     measured replay SCENE COUNT LAYOUT RAYS ANSWERS
//!
//! SCENE is `flake`, `balls` or `mesh`, of COUNT primitives; LAYOUT is `list` or `boxes` for objects one by one, `packed` or
//! `packed-boxes` for packed ones. Pictures are in PPM.

mod card;
mod clock;
mod crowd;
mod files;
mod layout;
#[allow(dead_code)] // The list is for others.
#[path = "../../../instructions/files.rs"]
mod nff;
mod rays;
mod render;
mod replay;

use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match arguments[..] {
        ["card", size, samples, picture] => {
            number(size).and_then(|size| card::draw(size, number(samples)?, picture.as_ref()))
        }
        ["render", scene, count, layout, size, picture] => with_crowd(scene, count, |crowd| {
            let render = render::Render { size: number(size)?, picture: picture.as_ref() };
            layout::with_scene(crowd, layout, render)
        }),
        ["file", file, layout, size, picture] => number(size).and_then(|size| {
            layout::with_file(file.as_ref(), layout, render::Render { size, picture: picture.as_ref() })
        }),
        ["rays", scene, count, size, rays, shapes] => with_crowd(scene, count, |crowd| {
            let dump = rays::Dump { size: number(size)?, crowd, rays: rays.as_ref(), shapes: shapes.as_ref() };
            layout::with_scene(crowd, "boxes", dump)
        }),
        ["replay", scene, count, layout, rays, answers] => with_crowd(scene, count, |crowd| {
            let rays = rays::read(rays.as_ref())?;
            layout::with_scene(crowd, layout, replay::Replay { rays: &rays, answers: answers.as_ref() })
        }),
        _ => Err("what the example `performance` runs; it takes no other use".to_owned()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("measured: {message}");
            ExitCode::FAILURE
        }
    }
}

fn with_crowd(scene: &str, count: &str, f: impl FnOnce(&crowd::Crowd) -> Result<(), String>) -> Result<(), String> {
    f(&crowd::Crowd::new(scene, number(count)? as usize)?)
}

fn number(text: &str) -> Result<u32, String> {
    text.parse().map_err(|_| format!("{text}: expected a number"))
}
