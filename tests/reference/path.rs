//! The paths of light that is bent.

use whit::scene::Scene;

use super::graded;
use super::hole::{self, Hole};
use super::integrator::root;
use super::profile::Profile;
use super::shapes::Ray;
use super::vector::Vector;
use super::world::World;

/// A point of a path, with the direction of light there, of length 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    pub point: Vector,
    pub direction: Vector,
}

/// What bends light.
#[derive(Clone, Copy, Debug)]
pub enum Bend<'a> {
    Graded(&'a Profile),
    Hole(&'a Hole),
}

impl<'a> Bend<'a> {
    /// The path that starts at a place, as if nothing were in the way.
    pub fn course(self, start: Place) -> Course<'a> {
        match self {
            Self::Graded(profile) => Course::Graded(graded::Course::new(profile, start)),
            Self::Hole(hole) => Course::Hole(hole::Course::new(hole, start)),
        }
    }

    /// The length that goes with the bend.
    pub fn scale(self) -> f64 {
        match self {
            Self::Graded(profile) => profile.feature(),
            Self::Hole(hole) => hole.mass,
        }
    }
}

/// A part of a path.
#[derive(Clone, Copy, Debug)]
pub enum Piece {
    /// The last one of a path that leads far away has no end.
    Straight {
        start: Place,
        length: f64,
    },
    Graded(graded::Arc),
    Orbit(hole::Arc),
}

impl Piece {
    /// The place at a share of the piece; of a straight one without an end, only its start.
    pub fn at(&self, share: f64) -> Place {
        match self {
            Self::Straight { start, .. } if share == 0.0 => *start,
            Self::Straight { start, length } => {
                Place { point: start.point + start.direction * (share * length), ..*start }
            }
            Self::Graded(arc) => arc.at(share),
            Self::Orbit(arc) => arc.at(share),
        }
    }

    /// How long it is up to a share of it.
    pub fn length_to(&self, share: f64) -> f64 {
        match self {
            Self::Straight { length, .. } => share * length,
            Self::Graded(arc) => share * arc.length,
            Self::Orbit(arc) => arc.length_to(share),
        }
    }

    pub fn length(&self) -> f64 {
        self.length_to(1.0)
    }

    /// The place after a length.
    pub fn after(&self, length: f64) -> Place {
        let whole = self.length();
        match self {
            Self::Straight { start, .. } => Place { point: start.point + start.direction * length, ..*start },
            Self::Graded(arc) => arc.at(length / whole),
            Self::Orbit(arc) => {
                let rest = |share| [arc.length_to(share) - length, whole];
                arc.at(root(rest, 0.0, 1.0, 1e-15 * whole))
            }
        }
    }
}

/// The pieces of a path in order, up to the horizon or to infinity.
pub enum Course<'a> {
    Graded(graded::Course<'a>),
    Hole(hole::Course),
}

impl Course<'_> {
    /// Whether the path, of which all pieces have been taken, ended behind a horizon.
    pub fn captured(&self) -> bool {
        match self {
            Self::Graded(_) => false,
            Self::Hole(course) => course.captured,
        }
    }
}

impl Iterator for Course<'_> {
    type Item = Piece;

    fn next(&mut self) -> Option<Piece> {
        match self {
            Self::Graded(course) => course.next(),
            Self::Hole(course) => course.next(),
        }
    }
}

/// Where light is after a length of way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    At(Place),
    /// Behind the horizon of a black hole.
    Captured,
}

impl End {
    /// # Panics
    /// When it is captured.
    pub fn place(self) -> Place {
        match self {
            Self::At(place) => place,
            Self::Captured => panic!("captured"),
        }
    }
}

/// Follows light for a length through the medium between a scene's objects, which are ignored.
pub fn follow(scene: &Scene<'_, f32>, origin: Vector, direction: Vector, length: f64) -> End {
    let scene = Scene { objects: &[], ..*scene };
    let world = World::new(&scene);
    let ray = Ray::new(origin, direction);
    let start = Place { point: ray.origin, direction: ray.direction };
    match world.bend(&ray) {
        Some(bend) => go(bend, start, length),
        None => End::At(Place { point: ray.at(length), ..start }),
    }
}

/// Follows light for a length.
pub fn go(bend: Bend<'_>, start: Place, length: f64) -> End {
    let mut rest = length;
    let mut last = start;
    let mut course = bend.course(start);
    for piece in course.by_ref() {
        let of_piece = piece.length();
        if rest <= of_piece {
            return End::At(piece.after(rest));
        }
        rest -= of_piece;
        last = piece.at(1.0);
    }
    if course.captured() { End::Captured } else { End::At(last) }
}
