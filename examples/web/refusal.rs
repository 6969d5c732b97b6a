//! Why a picture cannot be begun.

use whit::render::SettingsError;
use whit::scene::{Place, SceneError};
use whit::trace::TracerError;

use crate::message::Message;
use crate::picture::CAPACITY;

pub enum Refusal {
    NoScene,
    Scene(SceneError),
    TooManyPixels,
    Tracer(TracerError),
    Settings(SettingsError),
}

impl Refusal {
    /// Says it in the words of the library.
    pub fn tell(&self, message: &mut Message) {
        match self {
            Self::NoScene => message.set("there is no scene, or no room for it"),
            Self::TooManyPixels => message.set("size: there is room for ").number(CAPACITY).text(" pixels"),
            Self::Scene(error) | Self::Tracer(TracerError::Scene(error)) => scene(error, message),
            // The module has every effect and remembers media.
            Self::Tracer(_) => message.set("there is no code for the scene"),
            Self::Settings(error) => settings(error, message),
        };
    }
}

fn scene<'m>(error: &SceneError, message: &'m mut Message) -> &'m mut Message {
    match error.place {
        Place::Camera => message.set("camera"),
        Place::Scene => message.set("scene"),
        Place::Object(i) => message.set("object ").number(i),
        Place::Light(i) => message.set("light ").number(i),
        Place::Profile(i) => message.set("profile ").number(i),
    };
    message.text(": ").text(error.field).text(": expected ").text(error.expected)
}

fn settings<'m>(error: &SettingsError, message: &'m mut Message) -> &'m mut Message {
    match *error {
        SettingsError::Depth { asked, most } => {
            message.set("depth ").number(asked.into()).text(": the tracer's stack has room for ").number(most)
        }
        SettingsError::NotAnAmount(field) => message.set(field).text(": expected a finite number of at least 0"),
        SettingsError::NoSamples => message.set("samples: expected at least 1 a pixel"),
        SettingsError::Size { largest, .. } => {
            message.set("size: expected 1 to ").number(largest as usize).text(" pixels a side")
        }
        // It renders all of them.
        SettingsError::Rows { .. } => message.set("there are no such rows"),
    }
}
