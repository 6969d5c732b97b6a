//! Writes a picture of a scene.
//!
//!     cargo run --release --example render -- --help

mod arguments;
#[path = "../accuracy/code.rs"]
mod code;
mod description;
#[allow(dead_code)] // The numbers were worked out before.
#[path = "../accuracy/difference.rs"]
mod difference;
#[allow(dead_code)]
#[path = "../accuracy/frontier.rs"]
mod frontier;
mod join;
#[allow(dead_code, unused_imports)]
#[path = "../accuracy/number_name.rs"]
mod number_name;
mod output;
mod part;
mod print;
#[allow(dead_code)]
#[path = "../accuracy/record.rs"]
mod record;
mod rows;
mod scene;
#[allow(dead_code)]
#[path = "../accuracy/setting.rs"]
mod setting;
mod tune;
#[path = "../accuracy/tuner.rs"]
mod tuner;
mod work;

use std::io::Write;
use std::process::ExitCode;

use arguments::Arguments;
use description::Description;
use part::Part;
use print::print;

fn main() -> ExitCode {
    let arguments = match Arguments::read() {
        Ok(arguments) => arguments,
        Err(error) if error.use_stderr() => return fail(&in_one_line(&error.to_string())),
        Err(help) => help.exit(),
    };
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => fail(&message),
    }
}

fn fail(message: &str) -> ExitCode {
    // Whether anyone reads it or not.
    let _ = writeln!(std::io::stderr(), "render: {message}");
    ExitCode::from(2)
}

/// What is wrong, without the usage that follows it.
fn in_one_line(message: &str) -> String {
    let fault = message.split("\n\n").next().unwrap_or(message).trim_start_matches("error: ");
    fault.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn run(arguments: &Arguments) -> Result<(), String> {
    if arguments.list {
        return whit::scenes::ALL.iter().try_for_each(|(name, scene)| print(&format!("{name:10} {}", scene.effects())));
    }
    if let Some(parts) = &arguments.join {
        return join::join(parts, &arguments.output_path("joined"));
    }
    render(arguments)
}

fn render(arguments: &Arguments) -> Result<(), String> {
    let source = scene::Source::open(&arguments.scene)?;
    let job = match tune::job(arguments, &source)? {
        Some(job) => job,
        None => arguments.job(&source)?,
    };
    let picture_file = output::Target::new(&arguments.output_path(source.name()))?;
    let dropped_file = arguments.dropped.as_deref().map(output::Target::new).transpose()?;
    let started = std::time::Instant::now();
    let picture = source.render(&job)?;
    let seconds = started.elapsed().as_secs_f64();
    let settings = &job.settings;
    let description = Description::new(&source, settings);
    let part = Part { size: settings.size, rows: settings.rows.clone(), description };
    picture_file.write(&part, &picture.pixels)?;
    if let Some(file) = dropped_file {
        let description = part.description.of_dropped();
        file.write(&Part { description, ..part }, &picture.dropped)?;
    }
    if arguments.stats {
        print(&work::stats_as_json(&picture.stats, seconds).to_string())?;
    }
    Ok(())
}
