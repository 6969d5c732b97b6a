//! Spheres in a layout that is quick to search.

use super::Sphere;
use crate::math::{Real, Vec3};

/// Up to eight spheres, coordinate by coordinate as vector registers want them, and a sphere around them all.
///
/// A ray that misses the sphere around them has missed them all for the price of one.
///
/// ```
/// use whit::scene::{Sphere, SphereCluster};
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
/// const CLUSTERS: [SphereCluster<f32>; 2] = SphereCluster::pack(&ROW);
/// const SHAPE: Shape<'static, f32> = Shape::Spheres(&CLUSTERS);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereCluster<T> {
    pub(crate) around: Sphere<T>,
    pub(crate) x: [T; 8],
    pub(crate) y: [T; 8],
    pub(crate) z: [T; 8],
    /// Radii; those past the last sphere repeat it.
    pub(crate) radius: [T; 8],
    count: u8,
}

impl<T> SphereCluster<T> {
    /// How many spheres there is room for.
    pub const SIZE: usize = 8;
}

impl<T: Real> SphereCluster<T> {
    /// The spheres.
    pub fn spheres(&self) -> impl Iterator<Item = Sphere<T>> {
        let centers = self.x.into_iter().zip(self.y).zip(self.z);
        let spheres =
            centers.zip(self.radius).map(|(((x, y), z), radius)| Sphere { center: Vec3::new(x, y, z), radius });
        spheres.take(usize::from(self.count))
    }

    /// The sphere in one of the eight places.
    #[inline]
    pub(crate) fn sphere(&self, place: usize) -> Option<Sphere<T>> {
        let center = Vec3::new(*self.x.get(place)?, *self.y.get(place)?, *self.z.get(place)?);
        Some(Sphere { center, radius: *self.radius.get(place)? })
    }
}

#[allow(clippy::indexing_slicing)] // In range by the loops' conditions; iterators are not const.
impl SphereCluster<f32> {
    /// Sorts spheres into clusters of eight neighbours, the last of which may have room left.
    ///
    /// # Panics
    /// When there are not `N`/8 clusters, rounded up, or no spheres; in constant evaluation, where this belongs, that
    /// is an error of compilation.
    #[must_use]
    pub const fn pack<const N: usize, const CLUSTERS: usize>(spheres: &[Sphere<f32>; N]) -> [Self; CLUSTERS] {
        assert!(
            N > 0 && CLUSTERS == N.div_ceil(Self::SIZE),
            "the number of clusters is the number of spheres / 8, rounded up"
        );
        let mut rest = *spheres;
        let mut clusters = [Self::around(&rest, 0, 1); CLUSTERS];
        let (mut cluster, mut first) = (0, 0);
        while first < N {
            let end = if first + Self::SIZE < N { first + Self::SIZE } else { N };
            let mut next = first + 1;
            while next < end {
                let nearest = nearest_to(&rest, first, next);
                (rest[next], rest[nearest]) = (rest[nearest], rest[next]);
                next += 1;
            }
            clusters[cluster] = Self::around(&rest, first, end);
            (cluster, first) = (cluster + 1, end);
        }
        clusters
    }

    /// The cluster of the spheres from `first` to before `end`.
    const fn around<const N: usize>(spheres: &[Sphere<f32>; N], first: usize, end: usize) -> Self {
        let mut cluster = Self {
            around: spheres[first],
            x: [0.0; 8],
            y: [0.0; 8],
            z: [0.0; 8],
            radius: [0.0; 8],
            count: (end - first) as u8,
        };
        let (mut low, mut high) = ([f64::MAX; 3], [f64::MIN; 3]);
        let mut place = 0;
        while place < Self::SIZE {
            let Sphere { center, radius } = spheres[if first + place < end { first + place } else { end - 1 }];
            (cluster.x[place], cluster.y[place], cluster.z[place]) = (center.x, center.y, center.z);
            cluster.radius[place] = radius;
            let (position, reach) = ([center.x as f64, center.y as f64, center.z as f64], radius.abs() as f64);
            let mut axis = 0;
            while axis < 3 {
                low[axis] = low[axis].min(position[axis] - reach);
                high[axis] = high[axis].max(position[axis] + reach);
                axis += 1;
            }
            place += 1;
        }
        let middle = Vec3::new(
            ((low[0] + high[0]) / 2.0) as f32,
            ((low[1] + high[1]) / 2.0) as f32,
            ((low[2] + high[2]) / 2.0) as f32,
        );
        let mut reach = 0.0_f64;
        let mut i = first;
        while i < end {
            reach = reach.max(distance(middle, spheres[i].center) + spheres[i].radius.abs() as f64);
            i += 1;
        }
        // Rounded up, so that every sphere is inside.
        cluster.around = Sphere { center: middle, radius: (reach as f32).next_up() };
        cluster
    }
}

/// Of the spheres from `next` on, the one whose centre is nearest to that of `seed`.
#[allow(clippy::indexing_slicing)] // In range by the loop's condition.
const fn nearest_to<const N: usize>(spheres: &[Sphere<f32>; N], seed: usize, next: usize) -> usize {
    let (mut best, mut least) = (next, f64::MAX);
    let mut i = next;
    while i < N {
        let apart = distance_squared(spheres[seed].center, spheres[i].center);
        if apart < least {
            (best, least) = (i, apart);
        }
        i += 1;
    }
    best
}

const fn distance(a: Vec3<f32>, b: Vec3<f32>) -> f64 {
    square_root(distance_squared(a, b))
}

const fn distance_squared(a: Vec3<f32>, b: Vec3<f32>) -> f64 {
    let (x, y, z) = (a.x as f64 - b.x as f64, a.y as f64 - b.y as f64, a.z as f64 - b.z as f64);
    x * x + y * y + z * z
}

/// For constant evaluation, where there is no other: halving the exponent is right to 6 %, and each of Newton's steps
/// doubles the digits.
const fn square_root(x: f64) -> f64 {
    if x == 0.0 {
        return 0.0;
    }
    let mut root = f64::from_bits((x.to_bits() >> 1) + (1023 << 51));
    let mut steps = 0;
    while steps < 5 {
        root = (root + x / root) / 2.0;
        steps += 1;
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::scenes::flake_spheres;
    use std::vec::Vec;

    #[test]
    fn square_root_agrees_with_std() {
        for x in [0.0, 1e-20, 0.25, 2.0, 1e12, 3e24] {
            assert!((square_root(x) - x.sqrt()).abs() <= 1e-15 * x.sqrt(), "{x}");
        }
    }

    #[test]
    fn clusters_hold_every_sphere_once_and_reach_around_it() {
        let spheres = flake_spheres::<91>();
        let clusters = SphereCluster::pack::<91, 12>(&spheres);
        let mut packed: Vec<_> = clusters.iter().flat_map(SphereCluster::spheres).collect();
        for cluster in &clusters {
            for sphere in cluster.spheres() {
                let far = distance(cluster.around.center, sphere.center) + f64::from(sphere.radius);
                assert!(far <= f64::from(cluster.around.radius));
            }
        }
        let mut spheres = spheres.to_vec();
        let key = |s: &Sphere<f32>| [s.center.x, s.center.y, s.center.z].map(f32::to_bits);
        spheres.sort_by_key(key);
        packed.sort_by_key(key);
        assert_eq!(packed, spheres);
    }
}
