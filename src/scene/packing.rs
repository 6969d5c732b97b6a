//! Packing spheres, in constant evaluation if asked there.

use super::neighbours::sort_into_neighbours;
use super::{Around, Cluster, PackedSpheres, Sphere};
use crate::math::{LANES, Vec3, square_root_constant};

#[allow(clippy::indexing_slicing)] // In range by the loops' conditions; iterators are not const.
impl<const BOUNDS: usize, const CLUSTERS: usize> PackedSpheres<f32, BOUNDS, CLUSTERS> {
    /// Sorts spheres into clusters of neighbours.
    ///
    /// # Panics
    /// When `BOUNDS` or `CLUSTERS` do not fit the number of spheres, or that is 0; in constant evaluation, where this
    /// belongs, that is an error of compilation.
    #[must_use]
    pub const fn new<const N: usize>(spheres: &[Sphere<f32>; N]) -> Self {
        assert!(N > 0 && CLUSTERS == N.div_ceil(LANES), "CLUSTERS must be an eighth of the spheres, rounded up");
        assert!(BOUNDS == CLUSTERS.div_ceil(LANES), "BOUNDS must be an eighth of CLUSTERS, rounded up");
        let sorted = sort_into_neighbours(spheres);
        let mut clusters = [Cluster::of(&sorted, 0); CLUSTERS];
        let mut around = [spheres[0]; CLUSTERS];
        let mut i = 0;
        while i < CLUSTERS {
            clusters[i] = Cluster::of(&sorted, i * LANES);
            around[i] = bounding_sphere(&clusters[i]);
            i += 1;
        }
        let mut bounds = [Cluster::of(&around, 0); BOUNDS];
        let mut i = 0;
        while i < BOUNDS {
            bounds[i] = Cluster::of(&around, i * LANES);
            i += 1;
        }
        Self { bounds, clusters, around: Around::of(&sorted) }
    }
}

#[allow(clippy::indexing_slicing)] // In range by the loop's condition.
impl Cluster<f32> {
    /// The cluster of the spheres from `first` on; lanes past the last sphere are empty.
    const fn of<const N: usize>(spheres: &[Sphere<f32>; N], first: usize) -> Self {
        let mut cluster = Self { x: [0.0; LANES], y: [0.0; LANES], z: [0.0; LANES], radius: [0.0; LANES], count: 0 };
        let mut lane = 0;
        while lane < LANES && first + lane < N {
            let Sphere { center, radius } = spheres[first + lane];
            (cluster.x[lane], cluster.y[lane], cluster.z[lane]) = (center.x, center.y, center.z);
            cluster.radius[lane] = radius;
            lane += 1;
        }
        cluster.count = lane as u8;
        cluster
    }
}

/// The lowest and the highest coordinates of some spheres.
struct Sides {
    low: [f64; 3],
    high: [f64; 3],
}

impl Sides {
    const NONE: Self = Self { low: [f64::MAX; 3], high: [f64::MIN; 3] };

    const fn with(&self, Sphere { center, radius }: &Sphere<f32>) -> Self {
        let (Self { low, high }, reach) = (self, radius.abs() as f64);
        let [x, y, z] = [center.x as f64, center.y as f64, center.z as f64];
        Self {
            low: [low[0].min(x - reach), low[1].min(y - reach), low[2].min(z - reach)],
            high: [high[0].max(x + reach), high[1].max(y + reach), high[2].max(z + reach)],
        }
    }

    const fn middle(&self) -> Vec3<f32> {
        let Self { low, high } = self;
        Vec3::new(
            ((low[0] + high[0]) / 2.0) as f32,
            ((low[1] + high[1]) / 2.0) as f32,
            ((low[2] + high[2]) / 2.0) as f32,
        )
    }
}

#[allow(clippy::indexing_slicing)] // In range by the loop's condition.
impl Around<f32> {
    const fn of<const N: usize>(spheres: &[Sphere<f32>; N]) -> Self {
        let (mut sides, mut i) = (Sides::NONE, 0);
        while i < N {
            sides = sides.with(&spheres[i]);
            i += 1;
        }
        let Sides { low, high } = sides;
        let middle = sides.middle();
        // From the middle as it is rounded to there, and rounded up.
        let [x, y, z] = [middle.x as f64, middle.y as f64, middle.z as f64];
        let half = Vec3::new(
            ((x - low[0]).max(high[0] - x) as f32).next_up(),
            ((y - low[1]).max(high[1] - y) as f32).next_up(),
            ((z - low[2]).max(high[2] - z) as f32).next_up(),
        );
        Self { middle, half }
    }
}

/// A sphere around all spheres of a cluster.
const fn bounding_sphere(cluster: &Cluster<f32>) -> Sphere<f32> {
    let (mut sides, mut lane) = (Sides::NONE, 0);
    while let Some(sphere) = cluster.sphere(lane) {
        sides = sides.with(&sphere);
        lane += 1;
    }
    let middle = sides.middle();
    let mut reach = 0.0_f64;
    let mut lane = 0;
    while let Some(Sphere { center, radius }) = cluster.sphere(lane) {
        reach = reach.max(distance(middle, center) + radius.abs() as f64);
        lane += 1;
    }
    // Rounded up, so that every sphere is inside.
    Sphere { center: middle, radius: (reach as f32).next_up() }
}

const fn distance(a: Vec3<f32>, b: Vec3<f32>) -> f64 {
    let (x, y, z) = (a.x as f64 - b.x as f64, a.y as f64 - b.y as f64, a.z as f64 - b.z as f64);
    square_root_constant(x * x + y * y + z * z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::scenes::flake_spheres;
    use std::vec::Vec;

    #[test]
    fn every_sphere_is_packed_once_and_inside_its_bound() {
        let spheres = flake_spheres::<91>();
        let packed = PackedSpheres::<f32, 2, 12>::new(&spheres);
        let list = packed.view();
        let mut found: Vec<_> = list.iter().collect();
        for (i, cluster) in list.clusters.iter().enumerate() {
            let around = list.bounds[i / LANES].sphere(i % LANES).unwrap();
            for sphere in (0..LANES).filter_map(|lane| cluster.sphere(lane)) {
                let far = distance(around.center, sphere.center) + f64::from(sphere.radius);
                assert!(far <= f64::from(around.radius));
            }
        }
        let mut spheres = spheres.to_vec();
        let key = |s: &Sphere<f32>| [s.center.x, s.center.y, s.center.z].map(f32::to_bits);
        spheres.sort_by_key(key);
        found.sort_by_key(key);
        assert_eq!(found, spheres);
    }
}
