//! The static memory of a module that renders. It has no other.
//!
//! A page calls one function of a module at a time, from one thread, so each of these has one user. What a frame refers
//! to is not written to as long as there is the frame.
#![allow(unsafe_code)]

use core::mem::MaybeUninit;

use whit::{Background, Camera, Scene, SceneBuf};

use crate::Number;
use crate::message::Message;
use crate::page::Page;
use crate::picture::Picture;
use crate::record::{LIGHTS, OBJECTS, RECORDS, Record};

pub type Buffer = SceneBuf<Number, OBJECTS, LIGHTS>;

pub fn page() -> &'static mut Page {
    static mut PAGE: Page = Page::EMPTY;
    unsafe { &mut *(&raw mut PAGE) }
}

pub fn picture() -> &'static mut Picture {
    static mut PICTURE: Picture = Picture::EMPTY;
    unsafe { &mut *(&raw mut PICTURE) }
}

pub fn message() -> &'static mut Message {
    static mut MESSAGE: Message = Message::EMPTY;
    unsafe { &mut *(&raw mut MESSAGE) }
}

/// Where the page puts what is in a scene file.
pub fn records() -> &'static mut [Record; RECORDS] {
    static mut MEMORY: [Record; RECORDS] = [Record::EMPTY; RECORDS];
    unsafe { &mut *(&raw mut MEMORY) }
}

/// Keeps a scene in one of two places, to which no frame refers.
pub fn keep(scene: Scene<'static, Number>, in_second: bool) -> &'static Scene<'static, Number> {
    static mut SCENES: [MaybeUninit<Scene<'static, Number>>; 2] = [const { MaybeUninit::uninit() }; 2];
    let [first, second] = unsafe { &mut *(&raw mut SCENES) };
    if in_second { second.write(scene) } else { first.write(scene) }
}

/// An empty scene in place of the one before, to which no frame refers. It would not fit on the stack.
pub fn empty_scene(camera: Camera<Number>, background: Background<Number>) -> &'static mut Buffer {
    static mut BUFFER: MaybeUninit<Buffer> = MaybeUninit::uninit();
    unsafe { &mut *(&raw mut BUFFER) }.write(SceneBuf::new(camera, background))
}
