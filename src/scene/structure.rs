//! What a scene calls for, read off its structure: which variants, `Some` or `None`, never a number. That makes it
//! constant for every number type.

use super::{
    Aperture, Background, Effects, Emitter, Exponent, Film, Fresnel, Interface, Law, Level, Light, Lobe, Material,
    Medium, Method,
};
use super::{
    Object, Offset, Pattern, Profile, Scene, Shadow, ShadowRays, Shape, Sides, Spectrum, Steps, Thickness, Tone,
};

impl<T> Scene<'_, T> {
    /// The effects that the scene calls for. It reads structure only (which variants, `Some` or `None`), never a
    /// number, so it works in constant evaluation for every number type.
    #[must_use]
    #[allow(clippy::indexing_slicing)] // In range by the loop's condition; iterators are not const.
    pub const fn effects(&self) -> Effects {
        let mut effects = match self.background {
            Background::Solid(_) => Effects::NONE,
            Background::Gradient { .. } => Effects::BACKGROUND_GRADIENT,
            Background::Sky { .. } => Effects::SKY,
            Background::Stars { .. } => Effects::STARS,
        };
        if let Some(lens) = &self.camera.lens {
            effects = effects.with(Effects::LENS).with(match lens.aperture {
                Aperture::Disc { .. } => Effects::DISC_APERTURE,
                Aperture::Square { .. } => Effects::NONE,
            });
        }
        if matches!(self.tone, Tone::Display { .. }) {
            effects = effects.with(Effects::DISPLAY_TONE);
        }
        if matches!(self.offset, Offset::Fixed(_)) {
            effects = effects.with(Effects::FIXED_OFFSET);
        }
        if self.hierarchy.is_some() {
            effects = effects.with(Effects::HIERARCHY);
        }
        effects = effects.with(self.medium.effects());
        let mut i = 0;
        while i < self.objects.len() {
            effects = effects.with(self.objects[i].effects(self.fresnel));
            i += 1;
        }
        let mut i = 0;
        while i < self.lights.len() {
            effects = effects.with(self.lights[i].effects());
            i += 1;
        }
        effects.with(self.bending())
    }

    /// How many parts the objects have in a [`Hierarchy`](super::Hierarchy): each triangle of a list, eight packed spheres, and
    /// what else is one object.
    #[must_use]
    #[allow(clippy::indexing_slicing)] // In range by the loop's condition; iterators are not const.
    pub const fn parts(&self) -> usize {
        let (mut count, mut i) = (0, 0);
        while i < self.objects.len() {
            count += self.objects[i].parts();
            i += 1;
        }
        count
    }

    /// What bends light.
    #[allow(clippy::indexing_slicing)] // In range by the loop's condition; iterators are not const.
    const fn bending(&self) -> Effects {
        let mut effects = match &self.black_hole {
            Some(hole) => Effects::BLACK_HOLE.with(hole.steps.effects()),
            None => Effects::NONE,
        };
        let mut i = 0;
        while i < self.profiles.len() {
            effects = effects.with(self.profiles[i].effects());
            i += 1;
        }
        let bent = matches!(self.shadow_rays, ShadowRays::Bent) && !effects.is_empty();
        if bent { effects.with(Effects::BENT_SHADOWS) } else { effects }
    }
}

impl<T> Profile<'_, T> {
    const fn effects(&self) -> Effects {
        let level = match self.level {
            Level::Height { .. } => Effects::HEIGHT_PROFILE,
            Level::Radius { .. } => Effects::RADIUS_PROFILE,
        };
        let law = match self.law {
            Law::Polynomial { .. } => Effects::POLYNOMIAL_LAW,
            Law::Exponential { .. } | Law::Thermal { .. } | Law::Inversion { .. } => Effects::EXPONENTIAL_LAW,
            Law::FishEye { .. } => Effects::FISH_EYE_LAW,
            Law::Table { .. } => Effects::TABLE_LAW,
        };
        level.with(law).with(match &self.method {
            Method::Layers { .. } => Effects::LAYERS,
            Method::Steps(steps) => steps.effects(),
        })
    }
}

impl<T> Steps<T> {
    const fn effects(&self) -> Effects {
        match self {
            Self::Fixed { .. } => Effects::FIXED_STEPS,
            Self::Controlled { .. } => Effects::CONTROLLED_STEPS,
        }
    }
}

/// The most media that a branch of [`tracer!`](crate::tracer!) can be inside of at once.
const MOST_MEDIA: usize = 8;

impl<T> Scene<'_, T> {
    /// How many media a branch of light has to remember that it is inside of: 0 where each transparent object is clear,
    /// of one index, and can be taken to stand alone; else the number of transparent objects, up to 8.
    ///
    /// It is the `MEDIA` of a [`Tracer`](crate::Tracer).
    #[must_use]
    #[allow(clippy::indexing_slicing)] // In range by the loop's condition; iterators are not const.
    pub const fn media(&self) -> usize {
        if !self.effects().has(Effects::PRIORITY.with(Effects::ATTENUATION).with(Effects::GRADED)) {
            return 0;
        }
        let mut media = 0;
        let mut i = 0;
        while i < self.objects.len() && media < MOST_MEDIA {
            if self.objects[i].material.interface.is_transparent() {
                media += 1;
            }
            i += 1;
        }
        media
    }

    /// How many branches a tree of so many bounces has to put aside: one for each bounce, and in a scene with
    /// dispersion two more, for the other channels.
    ///
    /// It is the `DEPTH` of a [`Tracer`](crate::Tracer).
    #[must_use]
    pub const fn stack(&self, bounces: usize) -> usize {
        if self.effects().has(Effects::DISPERSION) { bounces + 2 } else { bounces }
    }
}

impl<T> Object<'_, T> {
    const fn effects(&self, fresnel: Fresnel) -> Effects {
        let mut effects = self.material.effects(fresnel).with(match self.shape {
            Shape::Sphere(_) => Effects::SPHERE,
            Shape::Spheres(_) => Effects::SPHERES,
            Shape::Plane(_) => Effects::PLANE,
            Shape::Disc(_) => Effects::DISC,
            Shape::Annulus(_) => Effects::ANNULUS,
            Shape::Box(_) => Effects::BOX,
            Shape::Triangle(_) => Effects::TRIANGLE,
            Shape::Triangles(_) => Effects::TRIANGLES,
            Shape::SmoothTriangle(_) => Effects::SMOOTH_TRIANGLE,
            Shape::Cone(_) => Effects::CONE,
        });
        if matches!(self.sides, Sides::Outside) {
            effects = effects.with(Effects::ONE_SIDED);
        }
        effects.with(match self.shadow {
            Shadow::Full => Effects::NONE,
            Shadow::None => Effects::SHADOWLESS,
            Shadow::Tinted => Effects::TINTED_SHADOW,
        })
    }
}

impl<T> Material<T> {
    const fn effects(&self, fresnel: Fresnel) -> Effects {
        let mut effects = self.interface.effects(fresnel);
        if self.balance.is_some() {
            effects = effects.with(Effects::BALANCE);
        }
        if let Some(body) = &self.body {
            effects = effects.with(Effects::BODY).with(match body.color {
                Pattern::Solid(_) => Effects::NONE,
                Pattern::Checker { .. } => Effects::CHECKER,
                Pattern::Gradient { .. } => Effects::GRADIENT,
                Pattern::Rings { .. } => Effects::RINGS,
            });
        }
        if let Some(highlight) = &self.highlight {
            effects = effects.with(match highlight.lobe {
                Lobe::Blinn => Effects::BLINN,
                Lobe::Phong => Effects::PHONG,
            });
            effects = effects.with(match highlight.exponent {
                Exponent::Integer(_) => Effects::INTEGER_EXPONENT,
                Exponent::Real(_) => Effects::REAL_EXPONENT,
            });
        }
        effects
    }
}

impl<T> Interface<T> {
    const fn effects(&self, fresnel: Fresnel) -> Effects {
        let fresnel = match fresnel {
            Fresnel::Exact => Effects::FRESNEL,
            Fresnel::Schlick => Effects::SCHLICK,
        };
        match self {
            Self::Opaque => Effects::NONE,
            Self::Mirror { .. } => Effects::MIRROR,
            Self::Metal { .. } => Effects::METAL,
            Self::Conductor { film: None, .. } => Effects::CONDUCTOR,
            Self::Conductor { film: Some(film), .. } => Effects::CONDUCTOR_FILM.with(film.effects()),
            Self::Coat { .. } => Effects::COAT.with(fresnel),
            Self::Constant { medium, .. } => Effects::CONSTANT.with(medium.effects()),
            Self::Dielectric { medium, film } => {
                let surface = match film {
                    None => fresnel,
                    Some(film) => Effects::DIELECTRIC_FILM.with(film.effects()),
                };
                Effects::DIELECTRIC.with(medium.effects()).with(surface)
            }
        }
    }

    /// Whether light goes inside.
    pub(super) const fn is_transparent(&self) -> bool {
        matches!(self, Self::Constant { .. } | Self::Dielectric { .. })
    }
}

impl<T> Medium<T> {
    const fn effects(&self) -> Effects {
        let mut effects = if self.index.is_dispersive() { Effects::DISPERSION } else { Effects::NONE };
        if self.attenuation.is_some() {
            effects = effects.with(Effects::ATTENUATION);
        }
        if self.priority.is_some() {
            effects = effects.with(Effects::PRIORITY);
        }
        effects
    }
}

impl<T> Film<T> {
    const fn effects(&self) -> Effects {
        let thickness = match self.thickness {
            Thickness::Uniform(_) => Effects::NONE,
            Thickness::Gradient { .. } => Effects::FILM_GRADIENT,
            Thickness::Radial { .. } => Effects::FILM_RADIAL,
        };
        thickness.with(match self.spectrum {
            Spectrum::Wavelengths => Effects::FILM_WAVELENGTHS,
            Spectrum::Bands(_) => Effects::FILM_BANDS,
            Spectrum::Table => Effects::FILM_TABLE,
        })
    }
}

impl<T> Light<T> {
    const fn effects(&self) -> Effects {
        let effects = match self.emitter {
            Emitter::Point { .. } => Effects::POINT_LIGHT,
            Emitter::Directional { .. } => Effects::DIRECTIONAL_LIGHT,
            Emitter::Sphere { .. } => Effects::SPHERE_LIGHT,
            Emitter::Parallelogram { .. } => Effects::PARALLELOGRAM_LIGHT,
        };
        if self.falloff.is_some() { effects.with(Effects::FALLOFF) } else { effects }
    }
}
