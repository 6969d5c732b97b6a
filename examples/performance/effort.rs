//! How much is measured.

/// Sizes of all jobs, and how often each is done.
pub struct Effort {
    pub rounds: usize,
    /// Pixels a side of the business card.
    pub card: u32,
    /// Of the pictures that are compared with other programs'.
    pub picture: u32,
    /// Of the curves.
    pub curve: u32,
    /// Spheres of the flakes.
    pub flakes: &'static [usize],
    /// Objects of the curves.
    pub counts: &'static [usize],
    /// Height of the pictures by many threads.
    pub threads: u32,
}

/// The most objects that are searched one by one.
pub const LONGEST_LIST: usize = 1000;
/// The most objects of a scene, nearly; a list of triangles or of packed spheres is one object.
pub const MOST_OBJECTS: usize = 50_000;

impl Effort {
    pub const FULL: Self = Self {
        rounds: 5,
        card: 512,
        picture: 512,
        curve: 256,
        flakes: &[1, 10, 91, 820, 7381],
        counts: &[10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000, 20_000, 50_000, 100_000],
        threads: 768,
    };

    /// To see that everything works.
    pub const QUICK: Self = Self {
        rounds: 2,
        card: 128,
        picture: 128,
        curve: 64,
        flakes: &[10, 820],
        counts: &[10, 100, 1000, 10_000],
        threads: 192,
    };
}
