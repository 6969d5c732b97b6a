//! Reads a scene file for the web page, into records that its other modules take.
#![cfg_attr(target_arch = "wasm32", no_std)]
#![allow(unsafe_code)] // As in `memory` and `exports`.

mod alone;
mod encode;
mod message;
mod record;
mod trap;

use alone::Alone;
use encode::Records;
use message::Message;
use whit::scene::nff::{self, Found, NffError, Problem};

/// The longest file in bytes.
const CAPACITY: usize = 512 * 1024;

static TEXT: Alone<[u8; CAPACITY]> = Alone::new([0; CAPACITY]);
static RECORDS: Alone<Records> = Alone::new(Records::EMPTY);
static MESSAGE: Alone<Message> = Alone::new(Message::EMPTY);

/// Where the file goes.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn file() -> *mut u8 {
    unsafe { TEXT.get() }.as_mut_ptr()
}

/// How many bytes of it there is room for.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn file_capacity() -> usize {
    CAPACITY
}

/// Reads the first bytes at `file`. Gives the length of what is wrong with them, at `text`; 0 is success.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn read_file(length: usize) -> usize {
    let (text, records) = unsafe { (TEXT.get(), RECORDS.get()) };
    match nff::read_bytes(text.get(..length).unwrap_or_default(), records) {
        Ok(_) => 0,
        Err(error) => tell(&error, unsafe { MESSAGE.get() }).as_bytes().len(),
    }
}

/// Where the message is.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn text() -> *const u8 {
    unsafe { MESSAGE.get() }.as_bytes().as_ptr()
}

/// Where the records are that came of the file.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn records() -> *const u8 {
    unsafe { RECORDS.get() }.as_slice().as_ptr().cast()
}

/// How many bytes they are.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn records_length() -> usize {
    size_of_val(unsafe { RECORDS.get() }.as_slice())
}

/// Says what is wrong in the words of the library.
fn tell<'m>(error: &NffError, message: &'m mut Message) -> &'m mut Message {
    message.set("line ").number(error.line).text(": ");
    match &error.problem {
        Problem::Unexpected { expected, field, found } => {
            tell_expected(expected, *field, message).text(", found ");
            tell_found(found, message)
        }
        Problem::OutOfRange { field, expected } => tell_expected(expected, Some(field), message),
        Problem::NoRoom { what, needed, room } => {
            message.number(*needed).text(" ").text(what).text(", but there is room for ").number(*room)
        }
        Problem::NotUtf8 => message.text("expected UTF-8 text"),
    }
}

fn tell_expected<'m>(expected: &str, field: Option<&str>, message: &'m mut Message) -> &'m mut Message {
    message.text("expected ").text(expected);
    match field {
        Some(field) => message.text(" for `").text(field).text("`"),
        None => message,
    }
}

fn tell_found<'m>(found: &Found, message: &'m mut Message) -> &'m mut Message {
    match found {
        Found::Word(word) => message.text("`").text(word.as_str()).text("`"),
        Found::EndOfLine => message.text("the end of the line"),
        Found::EndOfFile => message.text("the end of the file"),
    }
}
