//! Ray against many spheres.

use super::{Contact, Ray, sphere};
use crate::math::{Real, Vec3};
use crate::scene::{Cluster, LANES, SphereList};

/// The nearest contact with a list of spheres, and the number of the sphere; with `any`, the first found.
///
/// Bounding spheres, and then the spheres of a cluster, are sieved side by side; what is not in the mask costs nothing
/// more.
pub(crate) fn intersect<T: Real>(
    list: &SphereList<'_, T>,
    ray: &Ray<T>,
    limit: T,
    outside_only: bool,
    any: bool,
) -> Option<(Contact<T>, usize)> {
    let mut best = None;
    let mut limit = limit;
    for (group, bounds) in list.bounds.iter().enumerate() {
        for lane in Lanes(near(bounds, ray, limit)) {
            let number = group * LANES + lane;
            let Some(cluster) = list.clusters.get(number) else { break };
            for lane in Lanes(near(cluster, ray, limit)) {
                let Some(sphere) = cluster.sphere(lane) else { break };
                if let Some(contact) = sphere::intersect(&sphere, ray, limit, outside_only) {
                    limit = contact.t;
                    best = Some((contact, number * LANES + lane));
                    if any {
                        return best;
                    }
                }
            }
        }
    }
    best
}

/// The spheres that a ray may meet between its origin and `limit`, a bit for each lane; a few that it misses may be
/// among them.
///
/// With f from the origin to the centre, the line meets the sphere where (f·d)² ≥ f² − r²; an origin outside, f² > r²,
/// needs f·d > 0 as well. Rounding moves each side by less than 16u·f², so 64u·f² leave room for all roundings of
/// [`sphere::intersect`] too. No contact is nearer than f·d − |r|, good to far less than the 1024th part of f·d where it
/// is above zero.
///
/// Straight-line code for every lane, with one word a lane at the end, is what compilers turn into vector instructions;
/// out of line, both levels share it.
#[inline(never)]
fn near<T: Real>(cluster: &Cluster<T>, ray: &Ray<T>, limit: T) -> u32 {
    let mut lanes = [0; LANES];
    let spheres = cluster.x.iter().zip(&cluster.y).zip(&cluster.z).zip(&cluster.radius);
    for (i, (lane, (((x, y), z), radius))) in lanes.iter_mut().zip(spheres).enumerate() {
        let f = Vec3::new(*x, *y, *z) - ray.origin;
        let along = f.dot(ray.direction).max(T::ZERO);
        let square = *radius * *radius;
        let outside = f.length_squared() * (T::ONE - T::from_f32(64.0) * T::ROUNDOFF) - square;
        let past = (along * T::from_f32(1.0 - 1.0 / 1024.0) - limit).max(T::ZERO);
        let margin = (along * along - outside).min(square - past * past);
        *lane = if margin < T::ZERO { 0 } else { 1 << i };
    }
    // Halves first, as wide as a vector register.
    let [a, b, c, d, e, f, g, h] = lanes;
    ((a | b | c | d) | (e | f | g | h)) & !(u32::MAX << cluster.count)
}

/// The numbers of the bits that are 1.
struct Lanes(u32);

impl Iterator for Lanes {
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        if self.0 == 0 {
            return None;
        }
        let lane = self.0.trailing_zeros();
        self.0 &= self.0 - 1;
        Some(lane as usize)
    }
}
