//! The machine at hand.

use std::ffi::CStr;
use std::fs;
use std::io::Write;
use std::process::ExitCode;

use super::Outcome;

/// Prints bytes of text for the user.
pub fn write(text: &[u8]) {
    print!("{}", String::from_utf8_lossy(text));
}

/// Prints bytes of text about what went wrong.
pub fn write_error(text: &[u8]) {
    eprint!("{}", String::from_utf8_lossy(text));
}

/// The program's exit code.
pub fn finish(outcome: Outcome) -> ExitCode {
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("error: {problem}");
            ExitCode::FAILURE
        }
    }
}

/// A file.
pub struct File {
    file: fs::File,
}

impl File {
    /// A new file, in place of one of that name.
    pub fn create(name: &CStr) -> Result<Self, &'static str> {
        let file = fs::File::create(path(name)).map_err(|_| "the file cannot be created; is there a folder for it?")?;
        Ok(Self { file })
    }

    /// Adds to the file.
    pub fn write(&mut self, bytes: &[u8]) -> Outcome {
        self.file.write_all(bytes).map_err(|_| "the file cannot be written to")
    }
}

/// Reads a whole file into memory; gives the bytes of it.
pub fn read_file<'a>(name: &CStr, memory: &'a mut [u8]) -> Result<&'a [u8], &'static str> {
    let bytes = fs::read(path(name)).map_err(|_| "the file cannot be opened")?;
    let place = memory.get_mut(..bytes.len()).ok_or("the file is larger than the memory for it")?;
    place.copy_from_slice(&bytes);
    Ok(place)
}

/// Gives a file another name, in place of one of that name.
pub fn rename(from: &CStr, to: &CStr) -> Outcome {
    fs::rename(path(from), path(to)).map_err(|_| "the file cannot be renamed")
}

fn path(name: &CStr) -> String {
    name.to_string_lossy().into_owned()
}

/// Instructions are not counted here.
pub enum Clock {}

impl Clock {
    /// Starts to count. `None` where there is nothing to count with.
    pub fn start() -> Option<Self> {
        None
    }

    /// The instructions since the start.
    pub fn instructions(&self) -> u64 {
        match *self {}
    }
}

/// The stack is the system's here.
pub enum Painted {}

/// Fills the free part of the stack. `None` where the machine does not let programs do that.
pub fn paint_stack() -> Option<Painted> {
    None
}

impl Painted {
    /// The bytes that were written to since.
    pub fn used(&self) -> Result<u32, &'static str> {
        match *self {}
    }
}
