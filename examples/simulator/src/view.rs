//! Which scene is seen, and from where.

use whit::{Camera, Scene, Vec3, scenes};

/// How near to straight above or below the camera comes, in radians: its picture has no upper side there.
#[cfg(feature = "window")]
const STEEPEST: f32 = 1.5;

/// A scene, and where its camera is around what it looks at, compared with where the scene has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    place: usize,
    /// In radians.
    turn: f32,
    rise: f32,
    /// A factor.
    distance: f32,
}

impl View {
    pub const FIRST: Self = Self::at(0);

    const fn at(place: usize) -> Self {
        Self { place, turn: 0.0, rise: 0.0, distance: 1.0 }
    }

    pub fn of(name: &str) -> Option<Self> {
        scenes::ALL.iter().position(|(scene, _)| *scene == name).map(Self::at)
    }

    pub fn name(self) -> &'static str {
        scenes::ALL[self.place].0
    }

    pub fn scene(self) -> Scene<'static, f32> {
        let scene = scenes::ALL[self.place].1;
        Scene { camera: self.moved(&scene.camera), ..scene }
    }

    /// The view as the scene has it.
    pub fn start(self) -> Self {
        Self::at(self.place)
    }

    fn moved(self, camera: &Camera<f32>) -> Camera<f32> {
        if self == self.start() {
            return *camera; // To the bit.
        }
        let (length, height, forward) = around(camera);
        let (up, sideways) = (camera.up.normalized(), camera.up.normalized().cross(forward));
        let level = forward * self.turn.cos() + sideways * self.turn.sin();
        let height = height + self.rise;
        let direction = level * height.cos() + up * height.sin();
        Camera { eye: camera.target + direction * (length * self.distance), ..*camera }
    }
}

/// How far the camera is from what it looks at, at which angle above it, and in which level direction.
fn around(camera: &Camera<f32>) -> (f32, f32, Vec3<f32>) {
    let (up, offset) = (camera.up.normalized(), camera.eye - camera.target);
    let (length, height) = (offset.length(), offset.dot(up));
    (length, (height / length).asin(), (offset - up * height).normalized())
}

/// What the user asks for.
#[cfg(feature = "window")]
impl View {
    pub fn next(self) -> Self {
        Self::at((self.place + 1) % scenes::ALL.len())
    }

    pub fn previous(self) -> Self {
        Self::at((self.place + scenes::ALL.len() - 1) % scenes::ALL.len())
    }

    pub fn turned(self, angle: f32) -> Self {
        Self { turn: self.turn + angle, ..self }
    }

    pub fn raised(self, angle: f32) -> Self {
        let (_, height, _) = around(&scenes::ALL[self.place].1.camera);
        Self { rise: (height + self.rise + angle).clamp(-STEEPEST, STEEPEST) - height, ..self }
    }

    pub fn scaled(self, factor: f32) -> Self {
        Self { distance: (self.distance * factor).clamp(0.1, 10.0), ..self }
    }
}
