//! Text, files and the end of a program, through the debugger or the emulator (semihosting).
//!
//! By the calls themselves and not by what the package builds on them, which is larger than a small tracer.

use core::ffi::CStr;
use core::panic::PanicInfo;

use semihosting::fd::{AsFd, OwnedFd};
use semihosting::sys::arm_compat::{OpenMode, sys_flen, sys_open, sys_read_orig, sys_rename, sys_write_orig};

use super::Outcome;

/// Prints bytes of text for the user.
pub fn write(text: &[u8]) {
    write_to(OpenMode::WRONLY_TRUNC, text);
}

/// Of the console, as the specification calls it, the mode tells the output from that for errors.
fn write_to(mode: OpenMode, text: &[u8]) {
    if let Ok(console) = sys_open(c":tt", mode) {
        let _ = sys_write_orig(console.as_fd(), text); // Without a host there is nobody to be told.
    }
}

/// Prints bytes of text about what went wrong.
pub fn write_error(text: &[u8]) {
    write_to(OpenMode::WRONLY_APPEND, text);
}

/// Ends the program, and with it the emulator.
pub fn finish(outcome: Outcome) -> ! {
    if let Err(problem) = outcome {
        for text in ["error: ", problem, "\n"] {
            write_error(text.as_bytes());
        }
    }
    semihosting::process::exit(outcome.is_err().into())
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    finish(Err("panic"))
}

/// A file on the host.
pub struct File(OwnedFd);

impl File {
    /// A new file, in place of one of that name.
    pub fn create(name: &CStr) -> Result<Self, &'static str> {
        let file = sys_open(name, OpenMode::WRONLY_TRUNC_BINARY);
        Ok(Self(file.map_err(|_| "the file cannot be created; is there a folder for it?")?))
    }

    /// Adds to the file.
    pub fn write(&mut self, bytes: &[u8]) -> Outcome {
        match sys_write_orig(self.0.as_fd(), bytes) {
            Ok(0) => Ok(()), // bytes are left
            _ => Err("the file cannot be written to"),
        }
    }
}

/// Reads a whole file into memory; gives the bytes of it.
pub fn read_file<'a>(name: &CStr, memory: &'a mut [u8]) -> Result<&'a [u8], &'static str> {
    let file = sys_open(name, OpenMode::RDONLY_BINARY).map_err(|_| "the file cannot be opened")?;
    let length = sys_flen(file.as_fd()).map_err(|_| "the file has no length")?;
    let place = memory.get_mut(..length).ok_or("the file is larger than the memory for it")?;
    match sys_read_orig(file.as_fd(), place) {
        Ok(0) => Ok(place), // bytes are left
        _ => Err("the file cannot be read"),
    }
}

/// Gives a file another name, in place of one of that name.
pub fn rename(from: &CStr, to: &CStr) -> Outcome {
    sys_rename(from, to).map_err(|_| "the file cannot be renamed")
}
