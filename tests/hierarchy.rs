//! A hierarchy of boxes finds what a search through the list of objects finds, whatever the objects and the rays are.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing)]

use fastrand::Rng;
use whit::render::{LinearRgb, Sampling, Size};
use whit::scene::{Hierarchy, HierarchyBuf, Leaf, Node, PackedSpheres, Shadow, Sphere, Triangle};
use whit::{
    Background, Camera, Effects, Frame, Material, Object, Ray, Real, Rgb, Scene, SceneBuf, Settings, Shape, Tracer,
    Vec3, scenes,
};

const ALL: u64 = Effects::ALL.without(BENT).bits();
/// What makes all tracing go by another way.
const BENT: Effects = Effects::HEIGHT_PROFILE.with(Effects::RADIUS_PROFILE).with(Effects::BLACK_HOLE);

fn scene<'a, T: Real>(objects: &'a [Object<'a, T>]) -> Scene<'a, T> {
    let unit = |x, y, z| Vec3::new(x, y, z).map(T::from_f32);
    let camera = Camera::with_half_height(unit(0.0, 0.0, 9.0), unit(0.0, 0.0, 0.0), unit(0.0, 1.0, 0.0), T::ONE);
    Scene::new(camera, Background::Solid(Rgb::BLACK)).with_objects(objects)
}

/// Asserts that all rays meet the same with a hierarchy as without; how many meet anything.
fn assert_same<T: Real>(scene: &Scene<'_, T>, rays: impl Iterator<Item = Ray<T>>) -> usize {
    let parts = scene.parts();
    let (mut nodes, mut leaves) = (vec![Node::EMPTY; Hierarchy::nodes(parts)], vec![Leaf::EMPTY; parts]);
    let with = scene.with_hierarchy(Hierarchy::build(scene, &mut nodes, &mut leaves).unwrap());
    let by_list = Tracer::<T, ALL, 1, 1>::try_new(scene).unwrap();
    let by_boxes = Tracer::<T, ALL, 1, 1>::try_new(&with).unwrap();
    let is_opaque = scene.objects.iter().all(|object| object.shadow == Shadow::Full);
    let mut met = 0;
    for ray in rays {
        let [one, other] = [by_list.intersect(&ray), by_boxes.intersect(&ray)]
            .map(|found| found.map(|there| (there.object, there.primitive, there.distance)));
        assert_eq!(one, other, "{ray:?}");
        assert_eq!(by_list.is_occluded(&ray, T::FARTHEST), by_boxes.is_occluded(&ray, T::FARTHEST), "{ray:?}");
        for tracer in [&by_list, &by_boxes].into_iter().filter(|_| is_opaque) {
            let (before, behind) = match one {
                Some((_, _, distance)) => (distance * T::from_f32(0.99), distance.plus(distance)),
                None => (T::FARTHEST, T::ZERO),
            };
            assert!(!tracer.is_occluded(&ray, before), "{ray:?}");
            assert_eq!(tracer.is_occluded(&ray, behind), one.is_some(), "{ray:?}");
        }
        met += usize::from(one.is_some());
    }
    met
}

fn point(random: &mut Rng, size: f32) -> Vec3<f32> {
    let mut coordinate = || (random.f32() * 2.0 - 1.0) * size;
    Vec3::new(coordinate(), coordinate(), coordinate())
}

fn direction(random: &mut Rng) -> Vec3<f32> {
    // Now and then along an axis or a plane of axes.
    let v = point(random, 1.0);
    let keep = |x: f32, random: &mut Rng| if random.u8(..8) == 0 { 0.0 } else { x };
    let v = Vec3::new(keep(v.x, random), keep(v.y, random), v.z);
    if v.length() > 0.01 { v.normalized() } else { Vec3::new(1.0, 0.0, 0.0) }
}

fn shape(random: &mut Rng, size: f32) -> Shape<'static, f32> {
    let center = point(random, 10.0);
    let extent = point(random, size);
    let radius = extent.length() + 1e-3;
    let across = direction(random);
    match random.u8(..8) {
        0 | 1 => Shape::sphere(center, radius),
        2 => Shape::triangle(center, center + extent, center + point(random, size)),
        3 => Shape::axis_box(center, center + extent.abs()),
        4 => Shape::disc(center, across, radius),
        5 => Shape::cylinder(center, center + across, radius).capped(),
        6 => Shape::annulus(center, across, radius * 0.5, radius),
        _ => Shape::sphere(center, -radius),
    }
}

fn rays(random: &mut Rng, count: usize, reach: f32) -> Vec<Ray<f32>> {
    let one = |random: &mut Rng| {
        let origin = point(random, reach);
        let towards = if random.bool() { direction(random) } else { (point(random, 10.0) - origin).normalized() };
        Ray { origin, direction: towards }
    };
    (0..count).map(|_| one(random)).collect()
}

#[test]
fn objects_of_every_kind() {
    for (round, count) in [0, 1, 2, 3, 5, 9, 33, 100, 700, 3000].into_iter().enumerate() {
        let mut random = Rng::with_seed(round as u64);
        let size = if count > 100 { 0.3 } else { 3.0 };
        let mut objects: Vec<_> =
            (0..count).map(|_| Object::new(shape(&mut random, size), Material::matte(Rgb::WHITE))).collect();
        if count % 2 == 1 {
            let floor = Shape::plane(Vec3::new(0.0, -5.0, 0.0), Vec3::new(0.0, 1.0, 0.0));
            objects.insert(count / 2, Object::new(floor, Material::matte(Rgb::WHITE)));
        }
        for reach in [12.0, 1e4] {
            let rays = rays(&mut random, 4000, reach);
            let met = assert_same(&scene(&objects), rays.into_iter());
            assert!(met > 100 || count < 9, "{count} {met}");
        }
    }
}

/// Where the boxes of a mesh of squares end, its seams are: a ray along a seam meets one of its triangles.
#[test]
fn seams_along_the_sides_of_boxes() {
    let corner = |x: usize, y: usize| Vec3::new(x as f32 - 8.0, y as f32 - 8.0, 0.0);
    let squares = (0..16).flat_map(|x| (0..16).map(move |y| (x, y)));
    let mesh: Vec<Triangle<f32>> = squares
        .flat_map(|(x, y)| {
            let [a, b, c, d] = [corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)];
            [Triangle { vertices: [a, b, c] }, Triangle { vertices: [a, c, d] }]
        })
        .collect();
    let objects = [Object::new(Shape::Triangles(&mesh), Material::matte(Rgb::WHITE))];
    let mut random = Rng::with_seed(1);
    let rays: Vec<_> = (0..40_000)
        .map(|i| {
            let seam = (random.usize(1..16) as f32 - 8.0) + (random.f32() - 0.5) * [0.0, 1e-7, 1e-6][i % 3];
            let along = random.f32() * 15.0 - 7.5;
            let target = if random.bool() { Vec3::new(seam, along, 0.0) } else { Vec3::new(along, seam, 0.0) };
            let away = 10_f32.powf(random.f32() * 6.0 - 2.0);
            let direction = if i % 2 == 0 { Vec3::new(0.0, 0.0, -1.0) } else { direction(&mut random) };
            Ray { origin: target - direction * away, direction }
        })
        .collect();
    let steep = rays.iter().filter(|ray| ray.direction.z.abs() > 0.01).count();
    assert!(assert_same(&scene(&objects), rays.into_iter()) >= steep * 99 / 100);
}

#[test]
fn packed_spheres_and_single_ones() {
    let mut random = Rng::with_seed(2);
    let spheres: [Sphere<f32>; 1000] =
        std::array::from_fn(|_| Sphere { center: point(&mut random, 10.0), radius: 0.2 + random.f32() * 0.2 });
    let packed = PackedSpheres::<f32, 16, 125>::new(&spheres);
    let mut objects = vec![Object::new(Shape::Spheres(packed.view()), Material::matte(Rgb::WHITE))];
    objects.extend(spheres[..100].iter().map(|s| Object::new(Shape::Sphere(*s), Material::matte(Rgb::WHITE))));
    let rays = rays(&mut random, 20_000, 15.0);
    assert!(assert_same(&scene(&objects), rays.into_iter()) > 5000);
}

/// Coordinates as large as they may be, and all in one place.
#[test]
fn extreme_places() {
    for scale in [1e-6_f32, 1.0, 1e6, 1e11] {
        let mut random = Rng::with_seed(3);
        let objects: Vec<_> = (0..200)
            .map(|i| {
                let center = if i % 3 == 0 { Vec3::splat(scale) } else { point(&mut random, scale) };
                Object::new(Shape::sphere(center, scale * 0.1 * random.f32().max(0.01)), Material::matte(Rgb::WHITE))
            })
            .collect();
        let rays: Vec<_> =
            rays(&mut random, 4000, 1.5).into_iter().map(|ray| Ray { origin: ray.origin * scale, ..ray }).collect();
        assert!(assert_same(&scene(&objects), rays.into_iter()) > 100, "{scale}");
    }
}

#[test]
fn other_number_types() {
    fn check<T: Real>(from_all: impl Fn(f32) -> T + Copy) {
        let mut random = Rng::with_seed(4);
        let mut buffer = Box::new(SceneBuf::<T, 64, 0>::EMPTY);
        let objects: Vec<_> =
            (0..60).map(|_| Object::new(shape(&mut random, 2.0), Material::matte(Rgb::WHITE))).collect();
        buffer.copy_from(&scene(&objects), from_all).unwrap();
        let rays = rays(&mut random, 3000, 20.0).into_iter();
        let rays = rays.map(|ray| Ray { origin: ray.origin.map(from_all), direction: ray.direction.map(from_all) });
        let rays = rays.map(|ray| Ray { direction: ray.direction.normalized(), ..ray });
        assert!(assert_same(&buffer.as_scene(), rays) > 500);
    }
    check::<f64>(f64::from);
    #[cfg(feature = "micromath")]
    check::<whit::Fast>(Real::from_f32);
    #[cfg(feature = "fixed")]
    check::<whit::Q16>(Real::from_f32);
    #[cfg(feature = "fixed")]
    check::<whit::Q20>(Real::from_f32);
}

#[test]
fn built_in_scenes() {
    for (name, scene) in scenes::ALL.into_iter().filter(|(_, scene)| !scene.effects().has(BENT)) {
        let mut random = Rng::with_seed(5);
        let (eye, target) = (scene.camera.eye, scene.camera.target);
        let size = (eye - target).length();
        let rays = (0..3000).map(|_| {
            let aim = target + point(&mut random, size * 0.4) - eye;
            Ray { origin: eye, direction: aim.normalized() }
        });
        assert!(assert_same(&scene, rays) > 300, "{name}");
    }
}

#[test]
fn documented_sizes_are_true() {
    assert_eq!((size_of::<Node>(), size_of::<Leaf>()), (104, 32));
}

/// Whole pictures, with shadows, and media that overlap.
#[test]
fn pictures_of_built_in_scenes() {
    fn picture(scene: &Scene<'_, f32>) -> Vec<Rgb<f32>> {
        let tracer = Tracer::<f32, { Effects::ALL.bits() }, 12, 8>::try_new(scene).unwrap();
        let size = Size::new(32, 24);
        let mut pixels = vec![Rgb::BLACK; size.pixels() as usize];
        let settings = Settings::new(size.width, size.height).with_sampling(Sampling::Sequence(2));
        let mut target = LinearRgb::new(size, &mut pixels).unwrap();
        Frame::new(&tracer, settings).unwrap().render(&mut target).unwrap();
        pixels
    }
    for (name, scene) in scenes::ALL {
        let parts = scene.parts();
        let (mut nodes, mut leaves) = (vec![Node::EMPTY; Hierarchy::nodes(parts)], vec![Leaf::EMPTY; parts]);
        let with = scene.with_hierarchy(Hierarchy::build(&scene, &mut nodes, &mut leaves).unwrap());
        assert!(picture(&scene) == picture(&with), "{name}");
    }
}

/// What the compiler builds is what a program builds.
#[test]
fn constants() {
    const PARTS: usize = scenes::SPHERES.parts();
    static MEMORY: HierarchyBuf<{ Hierarchy::nodes(PARTS) }, PARTS> = HierarchyBuf::of(&scenes::SPHERES);
    let (mut nodes, mut leaves) = (vec![Node::EMPTY; Hierarchy::nodes(PARTS)], vec![Leaf::EMPTY; PARTS]);
    let built = Hierarchy::build(&scenes::SPHERES, &mut nodes, &mut leaves).unwrap();
    assert_eq!(MEMORY.view(), built);
}

#[test]
fn what_does_not_fit_is_refused() {
    let objects: Vec<_> =
        (0..100).map(|i| Object::new(Shape::sphere(Vec3::splat(i as f32), 1.0), Material::matte(Rgb::WHITE))).collect();
    let scene = scene(&objects);
    let refusal = |nodes: usize, leaves: usize| {
        let (mut nodes, mut leaves) = (vec![Node::EMPTY; nodes], vec![Leaf::EMPTY; leaves]);
        Hierarchy::build(&scene, &mut nodes, &mut leaves).err().map(|full| full.to_string())
    };
    assert_eq!(refusal(Hierarchy::nodes(100), 100), None);
    assert_eq!(refusal(24, 99).unwrap(), "no room for another leaf: the capacity is 99");
    assert_eq!(refusal(2, 100).unwrap(), "no room for another node: the capacity is 2");
    assert_eq!(refusal(0, 100).unwrap(), "no room for another node: the capacity is 0");
    let (mut nodes, mut leaves) = ([Node::EMPTY; 24], [Leaf::EMPTY; 100]);
    let hierarchy = Hierarchy::build(&scene, &mut nodes, &mut leaves).unwrap();
    let other = scene.with_objects(&objects[1..]).with_hierarchy(hierarchy);
    let error = Tracer::<f32, ALL, 1, 1>::try_new(&other).err().unwrap().to_string();
    assert_eq!(error, "scene: hierarchy: expected one that was built of these objects");
}
