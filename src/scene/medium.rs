//! What fills a volume that light goes through.

use crate::math::{Real, Rgb};

/// A transparent medium: air, water, glass.
///
/// ```
/// use whit::scene::Medium;
/// use whit::Rgb;
/// // Glass that takes most of the blue light over one scene unit.
/// const AMBER: Medium<f32> = Medium::new(1.5).with_attenuation(Rgb::new(0.1, 0.5, 2.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium<T> {
    /// Index of refraction.
    pub index: Index<T>,
    /// Attenuation constant c of Beer's law per channel, in 1/scene unit: e^(−c·x) of the light is left after a
    /// distance x. `None` for a clear medium.
    pub attenuation: Option<Rgb<T>>,
    /// Which of several objects that overlap a place belongs to: the one whose medium has the highest priority, of
    /// equal ones the last in the list. `None` ranks lowest. Surfaces that coincide, as those of a glass and of the water
    /// in it, are crossed at once where the tracer remembers media; give one of the two a priority.
    pub priority: Option<u8>,
}

/// An index of refraction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Index<T> {
    /// The same for all light.
    Constant(T),
    /// One index for each channel: a branch of light splits into its channels where it is first refracted by it. The
    /// formulas of [`optics`](crate::optics) (Cauchy, Sellmeier) give the three numbers for real glass.
    Dispersive(Rgb<T>),
    /// Different from place to place: the scene's profile of this number.
    Profile(u8),
}

/// A channel of colour, which a branch of light that has been dispersed carries alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// Red.
    Red,
    /// Green.
    Green,
    /// Blue.
    Blue,
}

impl<T: Real> Medium<T> {
    /// Nothing at all; near enough for air.
    pub const VACUUM: Self = Self::new(T::ONE);

    /// A clear medium of one index of refraction.
    pub const fn new(index: T) -> Self {
        Self { index: Index::Constant(index), attenuation: None, priority: None }
    }

    /// A clear medium with an index of refraction for each channel.
    pub const fn dispersive(index: Rgb<T>) -> Self {
        Self { index: Index::Dispersive(index), attenuation: None, priority: None }
    }

    /// A clear medium whose index is the scene's profile of this number: see [`Profile`](super::Profile).
    pub const fn graded(profile: u8) -> Self {
        Self { index: Index::Profile(profile), attenuation: None, priority: None }
    }

    /// The same medium, attenuating light by e^(−c·x) over a distance x; c is in 1/scene unit.
    #[must_use]
    pub const fn with_attenuation(self, attenuation: Rgb<T>) -> Self {
        Self { attenuation: Some(attenuation), ..self }
    }

    /// The same medium with a priority where it overlaps others.
    #[must_use]
    pub const fn with_priority(self, priority: u8) -> Self {
        Self { priority: Some(priority), ..self }
    }

    /// The same medium in another number type.
    pub(crate) fn map<U: Real>(&self, f: impl Fn(T) -> U) -> Medium<U> {
        Medium {
            index: match self.index {
                Index::Constant(n) => Index::Constant(f(n)),
                Index::Dispersive(n) => Index::Dispersive(n.map(&f)),
                Index::Profile(number) => Index::Profile(number),
            },
            attenuation: self.attenuation.map(|c| c.map(f)),
            priority: self.priority,
        }
    }
}

impl<T: Real> Index<T> {
    /// The index for a channel; for light of all channels that of green, the middle one. It is 1 for a profile, which the
    /// scene knows: [`Scene::index_at`](super::Scene::index_at).
    #[inline]
    pub fn at(&self, channel: Option<Channel>) -> T {
        match (self, channel) {
            (Self::Constant(n), _) => *n,
            (Self::Dispersive(n), Some(Channel::Red)) => n.r,
            (Self::Dispersive(n), None | Some(Channel::Green)) => n.g,
            (Self::Dispersive(n), Some(Channel::Blue)) => n.b,
            (Self::Profile(_), _) => T::ONE,
        }
    }
}

impl<T> Index<T> {
    /// Whether it differs between channels.
    pub(crate) const fn is_dispersive(&self) -> bool {
        matches!(self, Self::Dispersive(_))
    }
}

impl Channel {
    /// The three channels.
    pub const ALL: [Self; 3] = [Self::Red, Self::Green, Self::Blue];

    /// A colour without the other channels.
    #[inline]
    pub fn of<T: Real>(self, color: Rgb<T>) -> Rgb<T> {
        match self {
            Self::Red => Rgb::new(color.r, T::ZERO, T::ZERO),
            Self::Green => Rgb::new(T::ZERO, color.g, T::ZERO),
            Self::Blue => Rgb::new(T::ZERO, T::ZERO, color.b),
        }
    }
}
