//! What is counted on the machine at hand.

use whit::scenes;

use crate::files::FILES;

/// Something to count the instructions of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// A built-in scene.
    BuiltIn(&'static str),
    /// A sphere-flake of so many single spheres on a floor, by a hierarchy.
    Flake(usize),
    /// A scene file, by a hierarchy.
    File(&'static str),
    /// To build the hierarchy of the largest sphere-flake.
    Building,
}

/// The spheres of whole generations of the sphere-flake.
pub const FLAKES: [usize; 4] = [10, 91, 820, LARGEST];
/// The most.
pub const LARGEST: usize = 7381;

impl Subject {
    /// All of them.
    pub fn all() -> Vec<Self> {
        let scenes = scenes::ALL.into_iter().map(|(name, _)| Self::BuiltIn(name));
        scenes.chain(FLAKES.map(Self::Flake)).chain(FILES.map(Self::File)).chain([Self::Building]).collect()
    }

    /// By its name.
    pub fn find(name: &str) -> Result<Self, String> {
        let found = Self::all().into_iter().find(|subject| subject.name() == name);
        found.ok_or_else(|| format!("there is no scene `{name}`"))
    }

    /// As the record has it.
    pub fn name(self) -> String {
        match self {
            Self::BuiltIn(name) | Self::File(name) => name.to_owned(),
            Self::Flake(count) => format!("flake of {count}"),
            Self::Building => format!("building of {LARGEST}"),
        }
    }
}
