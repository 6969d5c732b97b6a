//! Frames at the ends of what settings allow, and of files.

use whit::math::{Q16, Q20};
use whit::render::{LinearRgb, Sampling, Size};
use whit::{
    Background, Budget, Camera, Frame, Material, Object, Real, Rgb, Scene, Settings, Shape, Termination, Tracer, Vec3,
};

use super::{ALL, converted};

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);

fn camera(half_height: f32) -> Camera<f32> {
    Camera::with_half_height(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, UP, half_height)
}

fn render<T: Real>(scene: &Scene<'_, f32>, settings: Settings<T>) -> Vec<Rgb<f32>> {
    let scene = converted::<T>(scene);
    let scene = scene.as_scene();
    let tracer = Tracer::<T, ALL, 8, 4>::try_new(&scene).unwrap();
    let mut pixels = vec![Rgb::BLACK; settings.size.pixels() as usize];
    let mut target = LinearRgb::new(settings.size, &mut pixels).unwrap();
    Frame::new(&tracer, settings).unwrap().render(&mut target).unwrap();
    pixels
}

/// The mean of however many samples is right, and so is that of the brightest.
#[test]
fn means_of_many_samples() {
    fn check<T: Real>() {
        let mirror = [Object::new(Shape::sphere(Vec3::ZERO, 4.0), Material::mirror(Rgb::WHITE))];
        for light in [T::MAX, T::ONE, T::SMALLEST] {
            let budget = Budget { termination: Termination::Color(Rgb::grey(light)), ..Budget::with_depth(0) };
            let scene = Scene::new(camera(0.1), Background::Solid(Rgb::BLACK)).with_objects(&mirror);
            let settings = Settings { budget, ..Settings::new(1, 1) };
            for count in [1, 3, 20_000] {
                let pixels = render::<T>(&scene, settings.clone().with_sampling(Sampling::Sequence(count)));
                assert_eq!(pixels, [Rgb::grey(light.to_f32())], "{count} samples");
            }
        }
    }
    check::<Q16>();
    check::<Q20>();
}

/// The widest angle in the widest picture: rays along a row go nearly all the way round, in order.
#[test]
fn the_widest_picture() {
    fn check<T: Real>(width: u32) {
        let background = Background::Gradient { below: Rgb::BLACK, above: Rgb::WHITE, up: Vec3::new(1.0, 0.0, 0.0) };
        let pixels = render::<T>(&Scene::new(camera(8.0), background), Settings::new(width, 1));
        let light: Vec<_> = pixels.iter().map(|pixel| pixel.g).collect();
        assert!(light.is_sorted(), "the row turns back");
        let (first, last) = (light[0], light[light.len() - 1]);
        assert!(first < 1e-3 && last > 0.999, "{first} {last}");
    }
    check::<Q16>(16_383);
    check::<Q20>(1023);
}

/// Files that are in range render; the others are refused.
#[cfg(feature = "nff")]
#[test]
fn files() {
    use whit::SceneBuf;
    use whit::scene::nff::read;

    type Big<T> = SceneBuf<T, 640, 16>;
    fn said<T: Real>(scene: &Scene<'_, f32>) -> Option<String> {
        let scene = Box::new(Big::<T>::from_scene(scene, T::from_f32).unwrap());
        let scene = scene.as_scene();
        let tracer = match Tracer::<T, ALL, 8, 4>::try_new(&scene) {
            Ok(tracer) => tracer,
            Err(error) => return Some(error.to_string()),
        };
        let mut pixels = vec![Rgb::BLACK; 24 * 24];
        let mut target = LinearRgb::new(Size::new(24, 24), &mut pixels).unwrap();
        Frame::new(&tracer, Settings::new(24, 24)).unwrap().render(&mut target).unwrap();
        let most = T::MAX.to_f32();
        assert!(pixels.iter().all(|p| [p.r, p.g, p.b].into_iter().all(|x| (0.0..=most).contains(&x))));
        let first = pixels[0];
        assert!(pixels.iter().any(|pixel| *pixel != first), "an empty picture");
        None
    }
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/nff");
    let mut refused = Vec::new();
    let mut names: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    names.sort();
    for path in names {
        let mut scene = Box::new(Big::<f32>::new(camera(0.5), Background::Solid(Rgb::BLACK)));
        read(&std::fs::read_to_string(&path).unwrap(), &mut *scene).unwrap();
        let scene = scene.as_scene();
        let name = path.file_stem().unwrap().to_string_lossy();
        let sayings = [("Q16", said::<Q16>(&scene)), ("Q20", said::<Q20>(&scene))];
        refused.extend(sayings.into_iter().filter_map(|(number, said)| Some(format!("{name} {number}: {}", said?))));
    }
    let expected = ["mount_s4 Q20: object 0: highlight.exponent: expected a number from -64 to 64"];
    assert_eq!(refused, expected);
}
