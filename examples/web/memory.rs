//! The static memory of a module that renders. It has no other.
//!
//! A page calls one function of a module at a time, from one thread, so each of these has one user. What a frame refers
//! to is not written to as long as there is the frame.
#![allow(unsafe_code)]

use core::mem::MaybeUninit;

use whit::{Background, Camera, Scene, SceneBuf};

use crate::Number;
use crate::alone::Alone;
use crate::message::Message;
use crate::page::Page;
use crate::picture::Picture;
use crate::record::{LIGHTS, OBJECTS, RECORDS, Record};

/// The most media that bend light in a scene. A file has none.
const PROFILES: usize = 4;

pub type Buffer = SceneBuf<Number, OBJECTS, LIGHTS, PROFILES>;

pub fn page() -> &'static mut Page {
    static PAGE: Alone<Page> = Alone::new(Page::EMPTY);
    unsafe { PAGE.get() }
}

pub fn picture() -> &'static mut Picture {
    static PICTURE: Alone<Picture> = Alone::new(Picture::EMPTY);
    unsafe { PICTURE.get() }
}

pub fn message() -> &'static mut Message {
    static MESSAGE: Alone<Message> = Alone::new(Message::EMPTY);
    unsafe { MESSAGE.get() }
}

/// Where the page puts what is in a scene file.
pub fn records() -> &'static mut [Record; RECORDS] {
    static MEMORY: Alone<[Record; RECORDS]> = Alone::new([Record::EMPTY; RECORDS]);
    unsafe { MEMORY.get() }
}

/// Keeps a scene in one of two places, to which no frame refers.
pub fn keep(scene: Scene<'static, Number>, in_second: bool) -> &'static Scene<'static, Number> {
    static SCENES: Alone<[MaybeUninit<Scene<'static, Number>>; 2]> = Alone::new([const { MaybeUninit::uninit() }; 2]);
    let [first, second] = unsafe { SCENES.get() };
    if in_second { second.write(scene) } else { first.write(scene) }
}

/// An empty scene in place of the one before, to which no frame refers. It would not fit on the stack.
pub fn empty_scene(camera: Camera<Number>, background: Background<Number>) -> &'static mut Buffer {
    static BUFFER: Alone<MaybeUninit<Buffer>> = Alone::new(MaybeUninit::uninit());
    unsafe { BUFFER.get() }.write(SceneBuf::new(camera, background))
}
