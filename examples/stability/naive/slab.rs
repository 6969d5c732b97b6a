//! The slab test without care for 0·∞: Shirley, Black and Hollasch, "Ray Tracing: The Next Week" (version 4, "Bounding
//! Volume Hierarchies"), after Kay and Kajiya, "Ray Tracing Complex Scenes" (1986).
//!
//! Where a ray runs in the plane of a face, 0·∞ is no number, and every comparison with it is false: which branch that
//! takes depends on the sign of the zero. A box of no thickness is never met, for it is left when it is entered.

/// Where a ray enters a box, or 0 where it starts inside; `None` where it passes by.
#[must_use]
pub fn intersect(origin: [f32; 3], direction: [f32; 3], min: [f32; 3], max: [f32; 3]) -> Option<f32> {
    let (mut enter, mut leave) = (0.0, f32::INFINITY);
    for axis in 0..3 {
        let inverse = 1.0 / direction[axis];
        let a = (min[axis] - origin[axis]) * inverse;
        let b = (max[axis] - origin[axis]) * inverse;
        let (near, far) = if a < b { (a, b) } else { (b, a) };
        if near > enter {
            enter = near;
        }
        if far < leave {
            leave = far;
        }
        if leave <= enter {
            return None;
        }
    }
    Some(enter)
}
