//! The same scene in another unit of length.
//!
//! Multiplied are all coordinates, lengths and radii, the levels of profiles and the mass of a black hole; divided is what is
//! counted per length: attenuation, falloff, the directions of patterns and the slopes of laws. Directions, normals, angles,
//! colours, tolerances, shares of a distance and the thickness of films are left as they are.
#![allow(unreachable_pub, clippy::panic, clippy::unwrap_used)]

use whit::scene::{
    Annulus, Aperture, AxisBox, BlackHole, Cone, Disc, Emitter, Falloff, Film, Hierarchy, Law, Leaf, Lens, Level,
    Method, Node, Offset, PackedSpheres, Plane, Profile, SmoothTriangle, Sphere, SphereList, Steps, Thickness,
    Triangle,
};
use whit::{Camera, Interface, Light, Material, Medium, Object, Pattern, Scene, Shape};

/// A scene with all that it refers to. Lists of primitives and tables are never freed.
pub struct Scaled {
    rest: Scene<'static, f32>,
    objects: Vec<Object<'static, f32>>,
    lights: Vec<Light<f32>>,
    profiles: Vec<Profile<'static, f32>>,
    /// Of the scaled objects, if the scene has one.
    hierarchy: Option<Hierarchy<'static>>,
}

impl Scaled {
    /// The scene with all lengths multiplied by `scale`.
    pub fn new(scene: &Scene<'_, f32>, scale: f32) -> Self {
        let objects = scene.objects.iter().map(|object| Object {
            shape: shape(&object.shape, scale),
            material: material(object.material, scale),
            sides: object.sides,
            shadow: object.shadow,
        });
        let objects: Vec<_> = objects.collect();
        let hierarchy = scene.hierarchy.map(|_| {
            let boxed = scene.with_objects(&objects);
            let (nodes, leaves) =
                (vec![Node::EMPTY; Hierarchy::nodes(boxed.parts())], vec![Leaf::EMPTY; boxed.parts()]);
            Hierarchy::build(&boxed, nodes.leak(), leaves.leak()).unwrap()
        });
        Self {
            rest: Scene {
                camera: camera(scene.camera, scale),
                background: scene.background,
                medium: medium(scene.medium, scale),
                fresnel: scene.fresnel,
                objects: &[],
                lights: &[],
                tone: scene.tone,
                profiles: &[],
                black_hole: scene.black_hole.map(|hole| black_hole(hole, scale)),
                shadow_rays: scene.shadow_rays,
                hierarchy: None,
                offset: match scene.offset {
                    Offset::Bounded => Offset::Bounded,
                    Offset::Fixed(distance) => Offset::Fixed(distance * scale),
                },
            },
            objects,
            hierarchy,
            lights: scene.lights.iter().map(|one| light(*one, scale)).collect(),
            profiles: scene.profiles.iter().map(|one| profile(one, scale)).collect(),
        }
    }

    pub fn scene(&self) -> Scene<'_, f32> {
        let scene = self.rest.with_objects(&self.objects).with_lights(&self.lights).with_profiles(&self.profiles);
        Scene { hierarchy: self.hierarchy, ..scene }
    }
}

fn camera(camera: Camera<f32>, s: f32) -> Camera<f32> {
    let lens = camera.lens.map(|lens| Lens {
        aperture: match lens.aperture {
            Aperture::Disc { radius } => Aperture::Disc { radius: radius * s },
            Aperture::Square { side } => Aperture::Square { side: side * s },
        },
        focus: lens.focus * s,
    });
    Camera { eye: camera.eye * s, target: camera.target * s, lens, ..camera }
}

fn light(light: Light<f32>, s: f32) -> Light<f32> {
    let emitter = match light.emitter {
        Emitter::Point { position } => Emitter::Point { position: position * s },
        Emitter::Directional { towards } => Emitter::Directional { towards },
        Emitter::Sphere { center, radius } => Emitter::Sphere { center: center * s, radius: radius * s },
        Emitter::Parallelogram { corner, edge_u, edge_v } => {
            Emitter::Parallelogram { corner: corner * s, edge_u: edge_u * s, edge_v: edge_v * s }
        }
    };
    let falloff = light.falloff.map(|falloff| Falloff {
        constant: falloff.constant,
        linear: falloff.linear / s,
        quadratic: falloff.quadratic / s / s,
    });
    Light { emitter, falloff, ..light }
}

fn medium(medium: Medium<f32>, s: f32) -> Medium<f32> {
    Medium { attenuation: medium.attenuation.map(|c| c * (1.0 / s)), ..medium }
}

fn profile(profile: &Profile<'_, f32>, s: f32) -> Profile<'static, f32> {
    let level = match profile.level {
        Level::Height { origin, up } => Level::Height { origin: origin * s, up },
        Level::Radius { center, radius } => Level::Radius { center: center * s, radius: radius * s },
    };
    let method = match profile.method {
        Method::Layers { thickness } => Method::Layers { thickness: thickness * s },
        Method::Steps(Steps::Fixed { length }) => Method::Steps(Steps::Fixed { length: length * s }),
        Method::Steps(steps @ Steps::Controlled { .. }) => Method::Steps(steps),
    };
    Profile { level, from: profile.from * s, to: profile.to * s, law: law(profile.law, s), method }
}

/// An index of refraction has no unit, and nor has what makes one at a level.
fn law(law: Law<'_, f32>, s: f32) -> Law<'static, f32> {
    match law {
        Law::Polynomial { constant, linear, quadratic } => {
            Law::Polynomial { constant, linear: linear / s, quadratic: quadratic / s / s }
        }
        Law::Exponential { far, excess, scale } => Law::Exponential { far, excess, scale: scale * s },
        Law::Thermal { excess, ratio, scale } => Law::Thermal { excess, ratio, scale: scale * s },
        Law::Inversion { below, above, height, thickness } => {
            Law::Inversion { below, above, height: height * s, thickness: thickness * s }
        }
        Law::FishEye { index, radius } => Law::FishEye { index, radius: radius * s },
        Law::Table { spacing, values } => Law::Table { spacing: spacing * s, values: values.to_vec().leak() },
    }
}

/// Steps around a hole are shares of the distance from it.
fn black_hole(hole: BlackHole<f32>, s: f32) -> BlackHole<f32> {
    BlackHole { center: hole.center * s, mass: hole.mass * s, ..hole }
}

fn material(material: Material<f32>, s: f32) -> Material<f32> {
    let body = material.body.map(|mut body| {
        body.color = match body.color {
            Pattern::Solid(color) => Pattern::Solid(color),
            Pattern::Checker { even, odd, u, v } => Pattern::Checker { even, odd, u: u * (1.0 / s), v: v * (1.0 / s) },
            Pattern::Gradient { from, to, origin, axis } => {
                Pattern::Gradient { from, to, origin: origin * s, axis: axis * (1.0 / s) }
            }
            Pattern::Rings { even, odd, center, width } => {
                Pattern::Rings { even, odd, center: center * s, width: width * s }
            }
        };
        body
    });
    let interface = match material.interface {
        Interface::Constant { reflected, transmitted, medium: inside } => {
            Interface::Constant { reflected, transmitted, medium: medium(inside, s) }
        }
        Interface::Dielectric { medium: inside, film: over } => {
            Interface::Dielectric { medium: medium(inside, s), film: over.map(|over| film(over, s)) }
        }
        Interface::Conductor { index, extinction, film: over } => {
            Interface::Conductor { index, extinction, film: over.map(|over| film(over, s)) }
        }
        other @ (Interface::Opaque | Interface::Mirror { .. } | Interface::Metal { .. } | Interface::Coat { .. }) => {
            other
        }
    };
    Material { body, interface, ..material }
}

/// A film is as many nanometres thick in any unit; where it is how thick is in the scene's.
fn film(film: Film<f32>, s: f32) -> Film<f32> {
    let thickness = match film.thickness {
        Thickness::Uniform(thickness) => Thickness::Uniform(thickness),
        Thickness::Gradient { from, to, origin, axis } => {
            Thickness::Gradient { from, to, origin: origin * s, axis: axis * (1.0 / s) }
        }
        Thickness::Radial { from, to, center, radius } => {
            Thickness::Radial { from, to, center: center * s, radius: radius * s }
        }
    };
    Film { thickness, ..film }
}

fn shape(shape: &Shape<'_, f32>, s: f32) -> Shape<'static, f32> {
    let triangle = |t: &Triangle<f32>| Triangle { vertices: t.vertices.map(|v| v * s) };
    match shape {
        Shape::Sphere(one) => Shape::Sphere(sphere(one, s)),
        Shape::Spheres(list) => Shape::Spheres(spheres(list, s)),
        Shape::Plane(p) => Shape::Plane(Plane { point: p.point * s, normal: p.normal }),
        Shape::Disc(d) => Shape::Disc(Disc { center: d.center * s, normal: d.normal, radius: d.radius * s }),
        Shape::Annulus(a) => {
            Shape::Annulus(Annulus { center: a.center * s, normal: a.normal, inner: a.inner * s, outer: a.outer * s })
        }
        Shape::Box(b) => Shape::Box(AxisBox { min: b.min * s, max: b.max * s }),
        Shape::Triangle(t) => Shape::Triangle(triangle(t)),
        Shape::Triangles(list) => Shape::Triangles(list.iter().map(triangle).collect::<Vec<_>>().leak()),
        Shape::SmoothTriangle(t) => {
            Shape::SmoothTriangle(SmoothTriangle { vertices: t.vertices.map(|v| v * s), normals: t.normals })
        }
        Shape::Cone(c) => Shape::Cone(Cone {
            base: c.base * s,
            apex: c.apex * s,
            base_radius: c.base_radius * s,
            apex_radius: c.apex_radius * s,
            capped: c.capped,
        }),
    }
}

fn sphere(sphere: &Sphere<f32>, s: f32) -> Sphere<f32> {
    Sphere { center: sphere.center * s, radius: sphere.radius * s }
}

/// Packs the spheres anew; their number is one of a few, since it is part of a type.
fn spheres(list: &SphereList<'_, f32>, s: f32) -> SphereList<'static, f32> {
    let spheres: Vec<_> = list.iter().map(|one| sphere(&one, s)).collect();
    match spheres.len() {
        10 => pack::<10, 1, 2>(&spheres),
        49 => pack::<49, 1, 7>(&spheres),
        91 => pack::<91, 2, 12>(&spheres),
        count => panic!("a line for {count} spheres is missing here"),
    }
}

fn pack<const N: usize, const BOUNDS: usize, const CLUSTERS: usize>(
    spheres: &[Sphere<f32>],
) -> SphereList<'static, f32> {
    let spheres: &[Sphere<f32>; N] = spheres.try_into().unwrap();
    Box::leak(Box::new(PackedSpheres::<f32, BOUNDS, CLUSTERS>::new(spheres))).view()
}
