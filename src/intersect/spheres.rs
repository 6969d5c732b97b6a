//! Ray against many spheres.

use super::{Bits, Contact, Ray, sphere};
use crate::math::{HAS_VECTORS, LANES, Lanes, Real, Vec3};
use crate::scene::{Around, Cluster, SphereList};
use wide::CmpLt;

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
    // Side by side, a few bounds take no longer than the box around them.
    let is_long = !HAS_VECTORS || list.bounds.len() > 1;
    if is_long && misses(&list.around, ray) {
        return None;
    }
    let mut best = None;
    let mut limit = limit;
    for (group, bounds) in list.bounds.iter().enumerate() {
        for lane in Bits(near(bounds, ray, limit)) {
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

/// Whether a ray surely goes past a box.
///
/// With m from its origin to the middle of the box, the line misses the box where m×d is longer along some axis than the
/// half-sides across it allow (Gottschalk, Lin and Manocha, "OBBTree", 1996, with the line as one of the boxes). The
/// products are good to 8u·|m|, of which 64 are taken; the half-sides grow by as much as the spheres' own test is off.
#[inline]
fn misses<T: Real>(around: &Around<T>, ray: &Ray<T>) -> bool {
    if T::IS_FIXED {
        return false;
    }
    let (m, d) = (around.middle - ray.origin, ray.direction);
    let (far, across) = (m.abs(), d.abs());
    let slack = (far.x + far.y + far.z).roundings(64.0);
    let half = around.half.map(|half| half + slack);
    let apart = |my: T, mz: T, dy: T, dz: T, most: T| (my * dz - mz * dy).abs() > most;
    apart(m.y, m.z, d.y, d.z, half.y * across.z + half.z * across.y)
        || apart(m.z, m.x, d.z, d.x, half.z * across.x + half.x * across.z)
        || apart(m.x, m.y, d.x, d.y, half.x * across.y + half.y * across.x)
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
    for lane in Bits(near(cluster, ray, limit)) {
        let Some(sphere) = cluster.sphere(lane) else { break };
        if let Some(contact) = sphere::intersect_near(&sphere, ray, limit, outside_only) {
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
#[inline(always)]
fn near<T: Real>(cluster: &Cluster<T>, ray: &Ray<T>, limit: T) -> u32 {
    let Cluster { x, y, z, radius, .. } = cluster;
    match (T::lanes(x), T::lanes(y), T::lanes(z), T::lanes(radius)) {
        (Some(x), Some(y), Some(z), Some(radius)) => {
            let lanes = near_side_by_side([x, y, z], radius, ray, limit.to_f32());
            lanes & !(u32::MAX << cluster.count)
        }
        _ => near_one_by_one(cluster, ray, limit),
    }
}

/// The same for all lanes at once.
#[inline(always)]
fn near_side_by_side<T: Real>([x, y, z]: [Lanes; 3], radius: Lanes, ray: &Ray<T>, limit: f32) -> u32 {
    let (origin, direction) = (ray.origin.map(T::to_f32), ray.direction.map(T::to_f32));
    let all = Lanes::splat;
    let (x, y, z) = (x - all(origin.x), y - all(origin.y), z - all(origin.z));
    let along = (x * all(direction.x) + y * all(direction.y) + z * all(direction.z)).fast_max(Lanes::ZERO);
    let square = radius * radius;
    let outside = (x * x + y * y + z * z) * all(1.0 - 64.0 * f32::ROUNDOFF) - square;
    let past = (along * all(NEARER) - all(limit)).fast_max(Lanes::ZERO);
    // What is not a number is looked at.
    let misses = (along * along - outside).cmp_lt(Lanes::ZERO) | (square - past * past).cmp_lt(Lanes::ZERO);
    !misses.move_mask().cast_unsigned()
}

/// The same for one lane after the other, of which most are done with when it is known how far beside the ray they are.
#[inline(never)]
fn near_one_by_one<T: Real>(cluster: &Cluster<T>, ray: &Ray<T>, limit: T) -> u32 {
    let Cluster { x, y, z, radius, .. } = cluster;
    let is_near = |(((x, y), z), radius): (((&T, &T), &T), &T)| {
        let f = Vec3::new(*x, *y, *z) - ray.origin;
        let along = f.dot(ray.direction);
        let square = radius.product(*radius);
        let outside = T::less(f.square(), 64.0) - square;
        if along.product(along) < outside || (along < T::ZERO && T::NOTHING < outside) {
            return false;
        }
        let past = along * T::from_f32(NEARER) - limit;
        past <= T::ZERO || past.product(past) <= square
    };
    let spheres = x.iter().zip(y).zip(z).zip(radius).take(cluster.count.into());
    // From the last to the first: each bit is shifted to its place by those that come after it.
    spheres.rev().fold(0, |lanes, sphere| lanes << 1 | u32::from(is_near(sphere)))
}

/// The share of f·d that is surely left of it.
const NEARER: f32 = 1.0 - 1.0 / 1024.0;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::intersect::numbers::Numbers;
    use crate::scene::{PackedSpheres, Sphere};

    /// The sieve loses nothing: the same contact as from each sphere in full, over 16 decades of size and distance,
    /// with spheres turned inside out among them, from outside and from inside.
    #[test]
    fn packed_spheres_give_the_contacts_of_each_sphere() {
        let mut hits = 0;
        for round in 0..4000_u32 {
            let numbers = Numbers(round);
            let (number, vector) = (|i| numbers.number(i), |i| numbers.vector(i));
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
            for cluster in list.clusters {
                let met = (0..cluster.count.into()).filter(|lane| {
                    let sphere = cluster.sphere(*lane).unwrap();
                    sphere::intersect(&sphere, &ray, f32::MAX, false).is_some()
                });
                let met = met.fold(0, |met, lane| met | 1 << lane);
                assert_eq!(met & !near(cluster, &ray, f32::MAX), 0, "{ray:?}");
                assert_eq!(met & !near_one_by_one(cluster, &ray, f32::MAX), 0, "{ray:?}");
            }
        }
        assert!(hits > 4000, "{hits}");
    }

    /// Rays that touch a sphere where the box around it does, from ever farther away.
    #[test]
    fn the_box_is_not_missed_where_a_sphere_is_met() {
        let mut hits = 0;
        for round in 0..40_000_u32 {
            let number = |i| Numbers(round).number(i);
            let center = Vec3::new(number(0), number(1), number(2));
            let sphere = Sphere { center, radius: 0.5 + 0.25 * number(3) };
            let list = PackedSpheres::<f32, 1, 1>::new(&[sphere]);
            let (along, across) = (Vec3::new(number(4), number(5), 0.0).normalized(), Vec3::new(0.0, 0.0, 1.0));
            let top = center + across * sphere.radius;
            let origin = top - along * 10_f32.powi(round as i32 % 5);
            let ray = Ray { origin, direction: (top - origin).normalized() };
            if sphere::intersect(&sphere, &ray, f32::MAX, false).is_some() {
                assert!(!misses(&list.view().around, &ray), "{ray:?}");
                hits += 1;
            }
        }
        assert!(hits > 4000, "{hits}");
    }
}
