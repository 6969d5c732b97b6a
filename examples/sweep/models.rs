//! The scene, computed by other models than its own: WHIT_FRESNEL, WHIT_SPECTRUM, WHIT_STEPS and WHIT_OFFSET.

use whit::optics::{Band, bands};
use whit::scene::{BlackHole, Film, Interface, Method, Offset, Profile, Spectrum, Steps};
use whit::{Fresnel, Material, Object, Scene};

use crate::choice::{SCENE as BUILT_IN, same};
use crate::decimal;

/// The scene.
pub const SCENE: Scene<'static, f32> = Scene {
    fresnel: fresnel(),
    objects: &OBJECTS,
    profiles: &PROFILES,
    black_hole: match (BUILT_IN.black_hole, STEPS) {
        (Some(hole), Some(Method::Steps(steps))) => Some(BlackHole { steps, ..hole }),
        (Some(_), Some(Method::Layers { .. })) => panic!("WHIT_STEPS: there are no layers around a black hole"),
        (hole, _) => hole,
    },
    offset: match option_env!("WHIT_OFFSET") {
        None => BUILT_IN.offset,
        Some(distance) => Offset::Fixed(decimal::read(distance.as_bytes())),
    },
    ..BUILT_IN
};

const fn fresnel() -> Fresnel {
    match option_env!("WHIT_FRESNEL") {
        None => BUILT_IN.fresnel,
        Some(name) if same(name.as_bytes(), b"exact") => Fresnel::Exact,
        Some(name) if same(name.as_bytes(), b"schlick") => Fresnel::Schlick,
        Some(_) => panic!("WHIT_FRESNEL: expected exact or schlick"),
    }
}

const SPECTRUM: Option<Spectrum> = match option_env!("WHIT_SPECTRUM") {
    None => None,
    Some(name) if same(name.as_bytes(), b"wavelengths") => Some(Spectrum::Wavelengths),
    Some(name) if same(name.as_bytes(), b"table") => Some(Spectrum::Table),
    Some(name) => match decimal::after(name, "bands") {
        Some(_) => Some(Spectrum::Bands(&BANDS)),
        None => panic!("WHIT_SPECTRUM: expected wavelengths, table or for example bands:16"),
    },
};

static BANDS: [Band; COUNT] = bands();

const COUNT: usize = match option_env!("WHIT_SPECTRUM") {
    Some(name) => match decimal::after(name, "bands") {
        Some(count) => decimal::read(count) as usize,
        None => 0,
    },
    None => 0,
};

const STEPS: Option<Method<f32>> = match option_env!("WHIT_STEPS") {
    None => None,
    Some(name) => {
        assert!(
            !BUILT_IN.profiles.is_empty() || BUILT_IN.black_hole.is_some(),
            "WHIT_STEPS: the scene does not bend light"
        );
        if let Some(length) = decimal::after(name, "length") {
            Some(Method::Steps(Steps::Fixed { length: decimal::read(length) }))
        } else if let Some(tolerance) = decimal::after(name, "tolerance") {
            Some(Method::Steps(Steps::Controlled { tolerance: decimal::read(tolerance) }))
        } else if let Some(thickness) = decimal::after(name, "layers") {
            Some(Method::Layers { thickness: decimal::read(thickness) })
        } else {
            panic!("WHIT_STEPS: expected for example length:0.02, tolerance:0.00001 or layers:0.01")
        }
    }
};

const OBJECTS: [Object<'static, f32>; BUILT_IN.objects.len()] = {
    let mut objects = *BUILT_IN.objects.first_chunk().expect("as many as there are");
    let (mut place, mut films) = (0, 0);
    while place < objects.len() {
        if let Some(material) = with_spectrum(&objects[place].material) {
            objects[place].material = material;
            films += 1;
        }
        place += 1;
    }
    assert!(SPECTRUM.is_none() || films > 0, "WHIT_SPECTRUM: there is no thin film in the scene");
    objects
};

/// The material of a film with the spectrum that is asked for, if there is a film.
const fn with_spectrum(material: &Material<f32>) -> Option<Material<f32>> {
    match (material.interface, SPECTRUM) {
        (
            Interface::Dielectric { film: Some(film), .. } | Interface::Conductor { film: Some(film), .. },
            Some(spectrum),
        ) => Some(material.with_film(Film { spectrum, ..film })),
        _ => None,
    }
}

const PROFILES: [Profile<'static, f32>; BUILT_IN.profiles.len()] = {
    let mut profiles = *BUILT_IN.profiles.first_chunk().expect("as many as there are");
    let mut place = 0;
    while place < profiles.len() {
        if let Some(method) = STEPS {
            profiles[place].method = method;
        }
        place += 1;
    }
    profiles
};
