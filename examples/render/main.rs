//! Writes a picture of a scene.
//!
//!     cargo run --release --example render -- --help

mod arguments;
#[path = "../accuracy/code.rs"]
mod code;
#[allow(dead_code)] // The numbers were worked out before.
#[path = "../accuracy/difference.rs"]
mod difference;
#[allow(dead_code)]
#[path = "../accuracy/frontier.rs"]
mod frontier;
#[allow(dead_code, unused_imports)]
#[path = "../accuracy/number_name.rs"]
mod number_name;
mod output;
#[allow(dead_code)]
#[path = "../accuracy/record.rs"]
mod record;
mod scene;
#[allow(dead_code)]
#[path = "../accuracy/setting.rs"]
mod setting;
mod tune;
#[path = "../accuracy/tuner.rs"]
mod tuner;
mod work;

use std::process::ExitCode;

use arguments::Arguments;
use clap::Parser;

fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) if error.use_stderr() => return fail(first_line(&error.to_string())),
        Err(help) => help.exit(),
    };
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => fail(&message),
    }
}

fn fail(message: &str) -> ExitCode {
    eprintln!("render: {message}");
    ExitCode::from(2)
}

/// What is wrong, without the usage that follows it.
fn first_line(message: &str) -> &str {
    message.split("\n\n").next().unwrap_or(message).trim_start_matches("error: ")
}

fn run(arguments: &Arguments) -> Result<(), String> {
    if arguments.list {
        for (name, scene) in whit::scenes::ALL {
            println!("{name:10} {}", scene.effects());
        }
        return Ok(());
    }
    let source = scene::Source::open(&arguments.scene)?;
    let job = match tune::job(arguments, &source)? {
        Some(job) => job,
        None => arguments.job(&source)?,
    };
    let picture_file = output::Target::new(&arguments.output_path(&source))?;
    let dropped_file = arguments.dropped.as_deref().map(output::Target::new).transpose()?;
    let started = std::time::Instant::now();
    let picture = source.render(&job)?;
    let seconds = started.elapsed().as_secs_f64();
    picture_file.write(picture.width, &picture.pixels, source.encoding())?;
    if let Some(file) = dropped_file {
        file.write(picture.width, &picture.dropped, whit::render::Encoding::Srgb)?;
    }
    if arguments.stats {
        println!("{}", work::stats_as_json(&picture.stats, seconds));
    }
    Ok(())
}
