//! What is wrong with a scene.

use core::fmt;

/// What is wrong with a scene, and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SceneError {
    /// Where.
    pub place: Place,
    /// Which field.
    pub field: &'static str,
    /// What it must be.
    pub expected: &'static str,
}

/// A part of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The camera.
    Camera,
    /// The scene itself: background, medium, tone, black hole.
    Scene,
    /// An object, by its place in the list.
    Object(usize),
    /// A light, by its place in the list.
    Light(usize),
    /// A profile, by its place in the list.
    Profile(usize),
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.place {
            Place::Camera => f.write_str("camera")?,
            Place::Scene => f.write_str("scene")?,
            Place::Object(i) => write!(f, "object {i}")?,
            Place::Light(i) => write!(f, "light {i}")?,
            Place::Profile(i) => write!(f, "profile {i}")?,
        }
        write!(f, ": {}: expected {}", self.field, self.expected)
    }
}

impl core::error::Error for SceneError {}
