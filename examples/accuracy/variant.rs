//! What of a scene itself is a choice between accuracy and time: the spectra of its films, the method of its bent paths, and where
//! rays leave its surfaces.

use whit::optics::{Band, bands};
use whit::scene::{BlackHole, Film, Fresnel, Method, Offset, Profile, Spectrum, Steps};
use whit::{Interface, Material, Object, Scene};

use crate::setting::{Path, Setting, SpectrumName};

static BANDS_8: [Band; 8] = bands();
static BANDS_16: [Band; 16] = bands();
static BANDS_38: [Band; 38] = bands();
static BANDS_128: [Band; 128] = bands();

/// How many bands a film can have here.
pub const BANDS: [u8; 4] = [8, 16, 38, 128];

/// A built-in scene with the choices of a setting, for as long as the program runs.
pub fn of(scene: &Scene<'static, f32>, setting: &Setting) -> Result<Scene<'static, f32>, String> {
    let mut scene = scene.with_fresnel(setting.fresnel);
    if let Some(spectrum) = spectrum(setting.spectrum)? {
        let objects: Vec<_> = scene.objects.iter().map(|object| with_spectrum(object, spectrum)).collect();
        scene.objects = objects.leak();
    }
    if let Some(method) = method(setting.path) {
        let profiles: Vec<_> = scene.profiles.iter().map(|profile| Profile { method, ..*profile }).collect();
        scene.profiles = profiles.leak();
        if let Method::Steps(steps) = method {
            scene.black_hole = scene.black_hole.map(|hole| BlackHole { steps, ..hole });
        }
    }
    if let Some(distance) = setting.offset {
        scene.offset = Offset::Fixed(distance);
    }
    Ok(scene)
}

/// Whether the scene has a film.
pub fn has_film(scene: &Scene<'_, f32>) -> bool {
    scene.objects.iter().any(|object| film(&object.material).is_some())
}

/// Whether light is bent in the scene.
pub const fn is_bent(scene: &Scene<'_, f32>) -> bool {
    scene.black_hole.is_some() || !scene.profiles.is_empty()
}

/// Whether light is reflected or transmitted in the scene.
pub fn has_branches(scene: &Scene<'_, f32>) -> bool {
    scene.objects.iter().any(|object| !matches!(object.material.interface, Interface::Opaque))
}

/// Whether Schlick's approximation changes anything in the scene.
pub fn has_fresnel(scene: &Scene<'static, f32>) -> bool {
    scene.with_fresnel(Fresnel::Schlick).effects() != scene.effects()
}

fn spectrum(name: SpectrumName) -> Result<Option<Spectrum>, String> {
    Ok(Some(match name {
        SpectrumName::Own => return Ok(None),
        SpectrumName::Wavelengths => Spectrum::Wavelengths,
        SpectrumName::Table => Spectrum::Table,
        SpectrumName::Bands(8) => Spectrum::Bands(&BANDS_8),
        SpectrumName::Bands(16) => Spectrum::Bands(&BANDS_16),
        SpectrumName::Bands(38) => Spectrum::Bands(&BANDS_38),
        SpectrumName::Bands(128) => Spectrum::Bands(&BANDS_128),
        SpectrumName::Bands(count) => return Err(format!("{count} bands: this program has {BANDS:?}")),
    }))
}

const fn method(path: Path) -> Option<Method<f32>> {
    match path {
        Path::Own => None,
        Path::Fixed(length) => Some(Method::Steps(Steps::Fixed { length })),
        Path::Controlled(tolerance) => Some(Method::Steps(Steps::Controlled { tolerance })),
        Path::Layers(thickness) => Some(Method::Layers { thickness }),
    }
}

const fn film(material: &Material<f32>) -> Option<Film<f32>> {
    match material.interface {
        Interface::Dielectric { film, .. } | Interface::Conductor { film, .. } => film,
        _ => None,
    }
}

fn with_spectrum(object: &Object<'static, f32>, spectrum: Spectrum) -> Object<'static, f32> {
    match film(&object.material) {
        Some(film) => Object { material: object.material.with_film(film.with_spectrum(spectrum)), ..*object },
        None => *object,
    }
}
