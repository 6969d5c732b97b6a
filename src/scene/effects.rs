//! What a scene calls for, so that a tracer holds no more.

use core::fmt;

/// A set of effects: one bit for each optical effect and each kind of shape, pattern, light and background.
///
/// [`Scene::effects`](super::Scene::effects) reads it off a scene in constant evaluation; a
/// [`Tracer`](crate::Tracer) has it as a constant parameter, and what is not in it is not in the binary.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Effects(u64);

macro_rules! effects {
    ($($(#[$doc:meta])* $name:ident = $bit:literal, $label:literal;)*) => {
        impl Effects {
            $($(#[$doc])* pub const $name: Self = Self(1 << $bit);)*
            /// Every effect there is: for scenes that are known only at run time.
            pub const ALL: Self = Self($(1 << $bit)|*);
            const LABELS: &'static [(Self, &'static str)] = &[$((Self::$name, $label)),*];
        }
    };
}

effects! {
    /// [`Shape::Sphere`](super::Shape::Sphere)
    SPHERE = 0, "sphere";
    /// [`Shape::Spheres`](super::Shape::Spheres)
    SPHERES = 1, "spheres";
    /// [`Shape::Plane`](super::Shape::Plane)
    PLANE = 2, "plane";
    /// [`Shape::Disc`](super::Shape::Disc)
    DISC = 3, "disc";
    /// [`Shape::Box`](super::Shape::Box)
    BOX = 4, "box";
    /// [`Shape::Triangle`](super::Shape::Triangle)
    TRIANGLE = 5, "triangle";
    /// [`Shape::Triangles`](super::Shape::Triangles)
    TRIANGLES = 6, "triangles";
    /// [`Shape::SmoothTriangle`](super::Shape::SmoothTriangle)
    SMOOTH_TRIANGLE = 7, "smooth-triangle";
    /// [`Shape::Cone`](super::Shape::Cone)
    CONE = 8, "cone";
    /// [`Sides::Outside`](super::Sides::Outside)
    ONE_SIDED = 9, "one-sided";
    /// [`Shadow::None`](super::Shadow::None)
    SHADOWLESS = 10, "shadowless";
    /// A diffuse body.
    BODY = 11, "body";
    /// [`Pattern::Checker`](super::Pattern::Checker)
    CHECKER = 12, "checker";
    /// [`Pattern::Gradient`](super::Pattern::Gradient)
    GRADIENT = 13, "gradient";
    /// [`Lobe::Blinn`](super::Lobe::Blinn)
    BLINN = 14, "blinn-highlight";
    /// [`Lobe::Phong`](super::Lobe::Phong)
    PHONG = 15, "phong-highlight";
    /// [`Exponent::Integer`](super::Exponent::Integer)
    INTEGER_EXPONENT = 16, "integer-exponent";
    /// [`Exponent::Real`](super::Exponent::Real)
    REAL_EXPONENT = 17, "real-exponent";
    /// [`Interface::Mirror`](super::Interface::Mirror)
    MIRROR = 18, "mirror";
    /// [`Interface::Metal`](super::Interface::Metal)
    METAL = 19, "metal";
    /// [`Interface::Constant`](super::Interface::Constant)
    CONSTANT = 20, "constant-transmission";
    /// [`Interface::Dielectric`](super::Interface::Dielectric)
    DIELECTRIC = 21, "dielectric";
    /// [`Emitter::Point`](super::Emitter::Point)
    POINT_LIGHT = 22, "point-light";
    /// [`Emitter::Directional`](super::Emitter::Directional)
    DIRECTIONAL_LIGHT = 23, "directional-light";
    /// [`Emitter::Sphere`](super::Emitter::Sphere)
    SPHERE_LIGHT = 24, "sphere-light";
    /// [`Emitter::Parallelogram`](super::Emitter::Parallelogram)
    PARALLELOGRAM_LIGHT = 25, "parallelogram-light";
    /// [`Falloff`](super::Falloff)
    FALLOFF = 26, "falloff";
    /// [`Background::Gradient`](super::Background::Gradient)
    BACKGROUND_GRADIENT = 27, "background-gradient";
    /// [`Background::Sky`](super::Background::Sky)
    SKY = 28, "sky";
    /// [`Lens`](super::Lens)
    LENS = 29, "lens";
    /// [`Tone::Display`](super::Tone::Display)
    DISPLAY_TONE = 30, "display-tone";
    /// [`Fresnel::Exact`](super::Fresnel::Exact), where a dielectric without a film or a coat calls for it.
    FRESNEL = 31, "fresnel";
    /// [`Fresnel::Schlick`](super::Fresnel::Schlick), where a dielectric without a film or a coat calls for it.
    SCHLICK = 32, "schlick";
    /// [`Interface::Conductor`](super::Interface::Conductor) without a film.
    CONDUCTOR = 33, "conductor";
    /// [`Interface::Coat`](super::Interface::Coat)
    COAT = 34, "coat";
    /// A medium with [`attenuation`](super::Medium::attenuation).
    ATTENUATION = 35, "attenuation";
    /// A medium with a [`priority`](super::Medium::priority).
    PRIORITY = 36, "priority";
    /// [`Shadow::Tinted`](super::Shadow::Tinted)
    TINTED_SHADOW = 37, "tinted-shadow";
    /// [`Index::Dispersive`](super::Index::Dispersive)
    DISPERSION = 38, "dispersion";
    /// A thin film on a dielectric.
    DIELECTRIC_FILM = 39, "film-on-dielectric";
    /// A thin film on a conductor.
    CONDUCTOR_FILM = 40, "film-on-conductor";
    /// [`Spectrum::Wavelengths`](super::Spectrum::Wavelengths)
    FILM_WAVELENGTHS = 41, "film-wavelengths";
    /// [`Spectrum::Bands`](super::Spectrum::Bands)
    FILM_BANDS = 42, "film-bands";
    /// [`Spectrum::Table`](super::Spectrum::Table)
    FILM_TABLE = 43, "film-table";
    /// [`Thickness::Gradient`](super::Thickness::Gradient)
    FILM_GRADIENT = 44, "film-gradient";
    /// [`Thickness::Radial`](super::Thickness::Radial)
    FILM_RADIAL = 45, "film-radial";
    /// [`Balance`](super::Balance)
    BALANCE = 46, "balance";
    /// [`Aperture::Disc`](super::Aperture::Disc); without it, the opening of a [`LENS`](Self::LENS) is a square.
    DISC_APERTURE = 47, "disc-aperture";
    /// [`Shape::Annulus`](super::Shape::Annulus)
    ANNULUS = 48, "annulus";
    /// [`Pattern::Rings`](super::Pattern::Rings)
    RINGS = 49, "rings";
    /// [`Background::Stars`](super::Background::Stars)
    STARS = 50, "stars";
    /// [`Level::Height`](super::Level::Height)
    HEIGHT_PROFILE = 51, "height-profile";
    /// [`Level::Radius`](super::Level::Radius)
    RADIUS_PROFILE = 52, "radius-profile";
    /// [`Law::Polynomial`](super::Law::Polynomial)
    POLYNOMIAL_LAW = 53, "polynomial-law";
    /// [`Law::Exponential`](super::Law::Exponential), [`Law::Thermal`](super::Law::Thermal) and
    /// [`Law::Inversion`](super::Law::Inversion)
    EXPONENTIAL_LAW = 54, "exponential-law";
    /// [`Law::FishEye`](super::Law::FishEye)
    FISH_EYE_LAW = 55, "fish-eye-law";
    /// [`Law::Table`](super::Law::Table)
    TABLE_LAW = 56, "table-law";
    /// [`Method::Layers`](super::Method::Layers)
    LAYERS = 57, "layers";
    /// [`Steps::Fixed`](super::Steps::Fixed)
    FIXED_STEPS = 58, "fixed-steps";
    /// [`Steps::Controlled`](super::Steps::Controlled)
    CONTROLLED_STEPS = 59, "controlled-steps";
    /// [`BlackHole`](super::BlackHole)
    BLACK_HOLE = 60, "black-hole";
    /// [`ShadowRays::Bent`](super::ShadowRays::Bent), in a scene that bends light.
    BENT_SHADOWS = 61, "bent-shadows";
    /// Rays that start at a fixed distance from the surfaces that they leave.
    FIXED_OFFSET = 62, "fixed-offset";
    /// [`Hierarchy`](super::Hierarchy)
    HIERARCHY = 63, "hierarchy";
}

impl Effects {
    /// A medium whose index of refraction varies.
    pub(crate) const GRADED: Self = Self::HEIGHT_PROFILE.with(Self::RADIUS_PROFILE);

    /// No effect at all.
    pub const NONE: Self = Self(0);

    /// The bits, for use as a constant parameter.
    #[must_use]
    pub const fn bits(self) -> u64 {
        self.0
    }

    /// The set with these bits; unknown bits are dropped.
    #[must_use]
    pub const fn from_bits(bits: u64) -> Self {
        Self(bits & Self::ALL.0)
    }

    /// Whether any effect of `other` is in the set.
    #[must_use]
    pub const fn has(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    /// The effects of both sets.
    #[must_use]
    pub const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// The effects of this set that are not in `other`.
    #[must_use]
    pub const fn without(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }

    /// Whether the set is empty.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The names of the effects, as [`Display`](fmt::Display) prints them.
    pub fn names(self) -> impl Iterator<Item = &'static str> {
        Self::LABELS.iter().filter(move |(effect, _)| self.has(*effect)).map(|(_, label)| *label)
    }
}

impl fmt::Display for Effects {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, name) in self.names().enumerate() {
            if i > 0 {
                f.write_str(", ")?;
            }
            f.write_str(name)?;
        }
        Ok(())
    }
}

impl fmt::Debug for Effects {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Effects({self})")
    }
}
