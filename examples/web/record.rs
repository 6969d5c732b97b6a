//! How what is in a scene file goes from the module that reads it to those that render it: a list of records, the first
//! of which is the view.
//!
//! The reader is a module of its own because it is about as large as the renderer, and because one will do for every number type.

/// One of the things in a scene file. What does not apply is 0.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Record {
    pub kind: u32,
    /// Of the light, the object, or behind all objects.
    pub color: [f32; 3],
    /// Kd
    pub diffuse: f32,
    /// Ks
    pub specular: f32,
    /// Shine
    pub exponent: f32,
    /// Whether the exponent goes by squaring.
    pub is_integer: u32,
    /// T
    pub transmittance: f32,
    /// The index of refraction; of the view, the tangent of half the field of view.
    pub index: f32,
    /// Centre; base and apex; vertices and normals; position; eye, target and up.
    pub points: [[f32; 3]; 6],
    /// Of a sphere, or of a cone's base and apex.
    pub radii: [f32; 2],
}

pub const VIEW: u32 = 0;
pub const LIGHT: u32 = 1;
pub const SPHERE: u32 = 2;
pub const CONE: u32 = 3;
pub const TRIANGLE: u32 = 4;
pub const SMOOTH_TRIANGLE: u32 = 5;

/// The most objects of a scene, every triangle counted.
pub const OBJECTS: usize = 4096;
/// The most lights of a scene.
pub const LIGHTS: usize = 32;
/// The most records: the view, the lights, the objects.
pub const RECORDS: usize = 1 + LIGHTS + OBJECTS;

impl Record {
    /// All 0.
    pub const EMPTY: Self = Self {
        kind: VIEW,
        color: [0.0; 3],
        diffuse: 0.0,
        specular: 0.0,
        exponent: 0.0,
        is_integer: 0,
        transmittance: 0.0,
        index: 0.0,
        points: [[0.0; 3]; 6],
        radii: [0.0; 2],
    };
}
