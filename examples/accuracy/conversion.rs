//! Scenes in other number types.

use std::slice;

use whit::scene::{Full, Triangle};
use whit::{Object, Real, Scene, SceneBuf, Shape};

/// The most primitives of one object, and the most lights and profiles, of a built-in scene.
const PRIMITIVES: usize = 128;
const LIGHTS: usize = 8;
const PROFILES: usize = 4;

/// A copy of a scene in another number type, for as long as the program runs. Lists of triangles stay lists; packed spheres,
/// which are there for `f32` only, become objects of their own.
pub fn converted<T: Real>(scene: &Scene<'static, f32>) -> Result<Scene<'static, T>, Full> {
    let empty = scene.with_objects(&[]);
    let around = SceneBuf::<T, 0, LIGHTS, PROFILES>::from_scene(&empty, T::from_f32)?;
    let around = Box::leak(Box::new(around)).as_scene();
    let mut objects = Vec::new();
    for object in scene.objects {
        let alone = Scene::new(scene.camera, scene.background).with_objects(slice::from_ref(object));
        let mut parts = Box::new(SceneBuf::<T, PRIMITIVES, 0>::from_scene(&alone, T::from_f32)?);
        match object.shape {
            Shape::Triangles(_) => objects.extend(gathered(parts.objects_mut())),
            _ => objects.extend_from_slice(parts.objects_mut()),
        }
    }
    Ok(around.with_objects(objects.leak()))
}

/// Triangles of one material as one object.
fn gathered<T: Real>(parts: &[Object<'static, T>]) -> Option<Object<'static, T>> {
    let triangle = |part: &Object<'static, T>| match part.shape {
        Shape::Triangle(triangle) => Some(triangle),
        _ => None,
    };
    let triangles: Vec<Triangle<T>> = parts.iter().filter_map(triangle).collect();
    Some(Object { shape: Shape::Triangles(triangles.leak()), ..*parts.first()? })
}
