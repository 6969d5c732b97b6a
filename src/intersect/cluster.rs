//! Ray against clusters of spheres.

use super::{Contact, Ray, sphere};
use crate::math::{Real, Vec3};
use crate::scene::{Sphere, SphereCluster};

/// The nearest contact with the spheres of some clusters, and the number of the sphere; with `any`, the first found.
///
/// Most spheres are missed, so the discriminants of a cluster are worked out side by side and only those that are met
/// are looked at.
pub(crate) fn intersect<T: Real>(
    clusters: &[SphereCluster<T>],
    ray: &Ray<T>,
    limit: T,
    outside_only: bool,
    any: bool,
) -> Option<(Contact<T>, usize)> {
    let mut best = None;
    let mut limit = limit;
    for (number, cluster) in clusters.iter().enumerate() {
        if is_missed(&cluster.around, ray, limit) {
            continue;
        }
        let discriminants = discriminants(cluster, ray);
        if discriminants.iter().fold(true, |missed, d| missed & (*d < T::ZERO)) {
            continue;
        }
        for (place, discriminant) in discriminants.into_iter().enumerate() {
            if discriminant < T::ZERO {
                continue;
            }
            let Some(sphere) = cluster.sphere(place) else { continue };
            if let Some(contact) = sphere::meet(&sphere, ray, discriminant, limit, outside_only) {
                limit = contact.t;
                best = Some((contact, number * SphereCluster::<T>::SIZE + place));
                if any {
                    return best;
                }
            }
        }
    }
    best
}

/// The sphere of a contact.
pub(crate) fn sphere<T: Real>(clusters: &[SphereCluster<T>], number: usize) -> Option<Sphere<T>> {
    clusters.get(number / SphereCluster::<T>::SIZE)?.sphere(number % SphereCluster::<T>::SIZE)
}

/// Whether a ray surely misses everything inside a sphere, or meets it only behind its origin or beyond `limit`.
///
/// Rounding moves the foot of the perpendicular by at most 4u|f| on each axis, and its square by less than 16u|f|².
/// Once the line is known to pass through the sphere, the error of the foot's distance is below its 1024th part.
#[inline(always)]
fn is_missed<T: Real>(around: &Sphere<T>, ray: &Ray<T>, limit: T) -> bool {
    let f = ray.origin - around.center;
    let along = -f.dot(ray.direction);
    let perpendicular = f + ray.direction * along;
    let slack = f.length_squared() * (T::from_f32(16.0) * T::ROUNDOFF);
    let beside = perpendicular.length_squared() - slack > around.radius * around.radius;
    let reach = around.radius * T::from_f32(1.0 + 1.0 / 1024.0);
    let behind = along < -reach;
    let beyond = along * T::from_f32(1.0 - 1.0 / 1024.0) - reach > limit;
    beside || behind || beyond
}

#[inline(always)]
fn discriminants<T: Real>(cluster: &SphereCluster<T>, ray: &Ray<T>) -> [T; 8] {
    let mut discriminants = [T::ZERO; 8];
    let centers = cluster.x.iter().zip(&cluster.y).zip(&cluster.z).zip(&cluster.radius);
    for (d, (((x, y), z), radius)) in discriminants.iter_mut().zip(centers) {
        *d = sphere::discriminant(&Sphere { center: Vec3::new(*x, *y, *z), radius: *radius }, ray);
    }
    discriminants
}
