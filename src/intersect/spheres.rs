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
            if let Some(found) = intersect_cluster(list, group * LANES + lane, ray, limit, outside_only, any) {
                limit = found.0.t;
                best = Some(found);
                if any {
                    return best;
                }
            }
        }
    }
    best
}

/// The same with one cluster of a list, by its number.
#[inline]
pub(crate) fn intersect_cluster<T: Real>(
    list: &SphereList<'_, T>,
    number: usize,
    ray: &Ray<T>,
    limit: T,
    outside_only: bool,
    any: bool,
) -> Option<(Contact<T>, usize)> {
    let mut best = None;
    let mut limit = limit;
    let cluster = list.clusters.get(number)?;
    for lane in Lanes(near(cluster, ray, limit)) {
        let Some(sphere) = cluster.sphere(lane) else { break };
        if let Some(contact) = sphere::intersect(&sphere, ray, limit, outside_only) {
            limit = contact.t;
            best = Some((contact, number * LANES + lane));
            if any {
                break;
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
    let mut lanes: [u32; LANES] = [1, 2, 4, 8, 16, 32, 64, 128];
    let spheres = cluster.x.iter().zip(&cluster.y).zip(&cluster.z).zip(&cluster.radius);
    for (lane, (((x, y), z), radius)) in lanes.iter_mut().zip(spheres) {
        let f = Vec3::new(*x, *y, *z) - ray.origin;
        let along = f.dot(ray.direction).max(T::ZERO);
        let square = radius.product(*radius);
        let outside = T::less(f.square(), 64.0) - square;
        let past = (along * T::from_f32(1.0 - 1.0 / 1024.0) - limit).max(T::ZERO);
        let (beside, before) = (along.product(along) - outside, square - past.product(past));
        let margin = if beside < before { beside } else { before };
        *lane = if margin < T::NOTHING { 0 } else { *lane };
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{PackedSpheres, Sphere};
    use crate::trace::Sequence;

    /// The sieve loses nothing: the same contact as from each sphere in full, over 16 decades of size and distance,
    /// with spheres turned inside out among them, from outside and from inside.
    #[test]
    fn packed_spheres_give_the_contacts_of_each_sphere() {
        let mut hits = 0;
        for round in 0..4000_u32 {
            let number = |i: u32| Sequence::new(round, i).point::<f32>(0, 0)[0] * 2.0 - 1.0;
            let vector = |i| Vec3::new(number(i), number(i + 1), number(i + 2));
            let (scale, away) = (10_f32.powi((number(900) * 8.0) as i32), 10_f32.powi((number(901) * 4.0) as i32));
            let spheres: [Sphere<f32>; 70] = core::array::from_fn(|i| Sphere {
                center: vector(8 * i as u32) * scale,
                radius: number(8 * i as u32 + 3) * scale * 0.2 + 1e-9 * scale,
            });
            let origin = vector(910) * (scale * away);
            let aim = spheres[round as usize % 70];
            let target = aim.center + vector(920).normalized() * (aim.radius * number(930).abs().sqrt());
            let ray = Ray { origin, direction: (target - origin).normalized() };
            let packed = PackedSpheres::<f32, 2, 9>::new(&spheres);
            let list = packed.view();
            for outside_only in [false, true] {
                let mut limit = f32::MAX;
                let full = list.iter().fold(None, |best, s| {
                    let contact = sphere::intersect(&s, &ray, limit, outside_only);
                    limit = contact.map_or(limit, |contact: Contact<f32>| contact.t);
                    contact.or(best)
                });
                let sieved = intersect(&list, &ray, f32::MAX, outside_only, false).map(|(contact, _)| contact);
                assert_eq!(sieved, full, "{ray:?}");
                assert_eq!(intersect(&list, &ray, f32::MAX, outside_only, true).is_some(), full.is_some());
                hits += u32::from(full.is_some());
            }
        }
        assert!(hits > 4000, "{hits}");
    }
}
