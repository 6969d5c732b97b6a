//! Ray against many spheres.

use super::{Contact, Ray, sphere};
use crate::math::{Real, Vec3};
use crate::scene::{Cluster, LANES, Sphere, SphereList};

/// The nearest contact with a list of spheres, and the number of the sphere; with `any`, the first found.
///
/// Bounding spheres and the discriminants of a cluster are worked out side by side and give a mask; what is not in the
/// mask costs nothing more.
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
            let discriminants = side_by_side(cluster, |sphere| sphere::discriminant(&sphere, ray));
            for lane in Lanes(mask(cluster, discriminants.map(|d| d >= T::ZERO))) {
                let (Some(sphere), Some(&d)) = (cluster.sphere(lane), discriminants.get(lane)) else { break };
                if let Some(contact) = sphere::meet(&sphere, ray, d, limit, outside_only) {
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

/// The bounding spheres that a ray may meet between its origin and `limit`; a few that it misses may be among them.
///
/// Rounding moves the foot of the perpendicular by at most 4u|f| on each axis, and its square by less than 16u|f|².
/// Where the line does pass through the sphere, the error of the foot's distance is below its 1024th part.
#[inline(always)]
fn near<T: Real>(bounds: &Cluster<T>, ray: &Ray<T>, limit: T) -> u64 {
    let is_near = side_by_side(bounds, |around| {
        let f = ray.origin - around.center;
        let along = -f.dot(ray.direction);
        let perpendicular = f + ray.direction * along;
        let slack = f.length_squared() * (T::from_f32(16.0) * T::ROUNDOFF);
        let reach = around.radius * T::from_f32(1.0 + 1.0 / 1024.0);
        let beside = perpendicular.length_squared() - slack > around.radius * around.radius;
        let behind = along < -reach;
        let beyond = along * T::from_f32(1.0 - 1.0 / 1024.0) - reach > limit;
        !(beside | behind | beyond)
    });
    mask(bounds, is_near)
}

/// One value a lane, in a form that compilers turn into vector instructions.
#[inline(always)]
fn side_by_side<T: Real, U: Copy + Default>(cluster: &Cluster<T>, f: impl Fn(Sphere<T>) -> U) -> [U; LANES] {
    let mut values = [U::default(); LANES];
    let centers = cluster.x.iter().zip(&cluster.y).zip(&cluster.z).zip(&cluster.radius);
    for (value, (((x, y), z), radius)) in values.iter_mut().zip(centers) {
        *value = f(Sphere { center: Vec3::new(*x, *y, *z), radius: *radius });
    }
    values
}

/// A byte for each lane that holds a sphere: 1 where it says yes. Compilers pack comparisons into bytes better than
/// into bits.
#[inline(always)]
fn mask<T>(cluster: &Cluster<T>, lanes: [bool; LANES]) -> u64 {
    let held = u64::MAX.checked_shr(64 - 8 * u32::from(cluster.count)).unwrap_or(0);
    u64::from_le_bytes(lanes.map(u8::from)) & held
}

/// The numbers of the lanes whose byte is 1.
struct Lanes(u64);

impl Iterator for Lanes {
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        if self.0 == 0 {
            return None;
        }
        let lane = self.0.trailing_zeros() / 8;
        self.0 &= self.0 - 1;
        Some(lane as usize)
    }
}
