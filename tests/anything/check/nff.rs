//! Files.

use whit::scene::nff::read_bytes;
use whit::{Background, Budget, Camera, Rgb, SceneBuf, Settings, Vec3};

use super::{Fault, Outcome, check_scene, require};

/// A file: it is refused with the scene as it was, or gives a scene that renders.
///
/// # Errors
/// Says what does not hold.
pub fn check_file(bytes: &[u8]) -> Result<Outcome, Fault> {
    let camera = Camera::look_at(Vec3::ZERO, Vec3::new(0.0, 0.0, -1.0), Vec3::new(0.0, 1.0, 0.0), 40.0);
    let before = SceneBuf::<f32, 32, 4>::new(camera, Background::Solid(Rgb::BLACK));
    let mut scene = before.clone();
    let summary = match read_bytes(bytes, &mut scene) {
        Ok(summary) => summary,
        Err(error) => {
            require(error.to_string().len() > 10, || format!("says little: {error}"))?;
            require(scene.as_scene() == before.as_scene(), || "the scene is not as it was".into())?;
            return Ok(Outcome::Refused);
        }
    };
    let scene = scene.as_scene();
    scene.validate().map_err(|error| format!("read, but refused: {error}"))?;
    let (objects, lights) = (scene.objects.len(), scene.lights.len());
    require((objects, lights) == (summary.objects, summary.lights), || format!("{objects} objects, {lights} lights"))?;
    let pixels = summary.size.pixels().max(1);
    let rays_per_pixel = u32::try_from(2000 / pixels).unwrap_or(0).max(1);
    let settings = Settings {
        size: summary.size,
        rows: 0..summary.size.height,
        budget: Budget { rays_per_pixel, ..Budget::with_depth(5) },
        ..Settings::new(1, 1)
    };
    check_scene(&scene, &settings, 0, 7, &[])
}
