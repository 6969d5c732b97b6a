//! Many spheres in a layout that is quick to search.

use super::Sphere;
use crate::math::{LANES, Vec3};

/// Many spheres of one material, packed eight by eight so that a ray is tested against eight at once.
///
/// Neighbours are packed together, and around each eight lies a bounding sphere; the bounding spheres are packed eight
/// by eight as well. A ray looks only into the clusters whose bounding sphere it meets.
///
/// `BOUNDS` and `CLUSTERS` follow from the number of spheres: `CLUSTERS` is an eighth of it and `BOUNDS` an eighth of
/// that, both rounded up.
///
/// Of thousands of spheres the compiler says that a constant takes long; `#[allow(long_running_const_eval)]` lets it go on.
///
/// ```
/// use whit::scene::{PackedSpheres, Sphere};
/// use whit::{Shape, Vec3};
/// const ROW: [Sphere<f32>; 10] = {
///     let mut row = [Sphere { center: Vec3::new(0.0, 0.0, 0.0), radius: 0.5 }; 10];
///     let mut i = 0;
///     while i < 10 {
///         row[i].center.x = i as f32;
///         i += 1;
///     }
///     row
/// };
/// const PACKED: PackedSpheres<f32, 1, 2> = PackedSpheres::new(&ROW);
/// const SHAPE: Shape<'static, f32> = Shape::Spheres(PACKED.view());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PackedSpheres<T, const BOUNDS: usize, const CLUSTERS: usize> {
    pub(super) bounds: [Cluster<T>; BOUNDS],
    pub(super) clusters: [Cluster<T>; CLUSTERS],
    pub(super) around: Around<T>,
}

/// A view of [`PackedSpheres`] without their number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereList<'a, T> {
    /// Lane j of bound i lies around cluster 8·i + j.
    pub(crate) bounds: &'a [Cluster<T>],
    pub(crate) clusters: &'a [Cluster<T>],
    pub(crate) around: Around<T>,
}

/// A box around all spheres: its middle, and half of each side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Around<T> {
    pub middle: Vec3<T>,
    pub half: Vec3<T>,
}

/// Up to eight spheres, coordinate by coordinate as vector registers want them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cluster<T> {
    pub x: [T; LANES],
    pub y: [T; LANES],
    pub z: [T; LANES],
    pub radius: [T; LANES],
    pub count: u8,
}

impl<T: Copy> Cluster<T> {
    /// The sphere in one of the lanes.
    #[inline]
    #[allow(clippy::indexing_slicing)] // In range by the condition; `get` is not const.
    pub(crate) const fn sphere(&self, lane: usize) -> Option<Sphere<T>> {
        if lane >= self.count as usize || lane >= LANES {
            return None;
        }
        let center = Vec3::new(self.x[lane], self.y[lane], self.z[lane]);
        Some(Sphere { center, radius: self.radius[lane] })
    }
}

impl<T: Copy> SphereList<'_, T> {
    /// A sphere by its number; `None` past the end.
    #[inline]
    #[allow(clippy::indexing_slicing)] // In range by the condition; `get` is not const.
    pub(crate) const fn sphere(&self, number: usize) -> Option<Sphere<T>> {
        if number / LANES >= self.clusters.len() {
            return None;
        }
        self.clusters[number / LANES].sphere(number % LANES)
    }
}

impl<T: Copy> SphereList<'_, T> {
    /// The spheres, in the order in which they were packed.
    pub fn iter(&self) -> impl Iterator<Item = Sphere<T>> {
        self.clusters.iter().flat_map(|cluster| (0..LANES).filter_map(|lane| cluster.sphere(lane)))
    }
}

impl<T: Copy, const BOUNDS: usize, const CLUSTERS: usize> PackedSpheres<T, BOUNDS, CLUSTERS> {
    /// The spheres as a [`Shape`](super::Shape) wants them.
    #[must_use]
    pub const fn view(&self) -> SphereList<'_, T> {
        SphereList { bounds: &self.bounds, clusters: &self.clusters, around: self.around }
    }
}
