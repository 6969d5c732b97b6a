//! An eye exactly on the surface of water that goes down without end, as a plane, sees as much of it as one on a block of
//! water that is as deep: it is in the water where it looks down.

use whit::scene::{Interface, Medium};
use whit::{Background, Material, Object, Ray, Rgb, Shape, Vec3};

use crate::support::{Nested, UP, scene, shoot};

fn seen(water: Shape<'static, f32>, direction: Vec3<f32>) -> Rgb<f32> {
    let medium = Medium::VACUUM.with_attenuation(Rgb::new(0.1, 0.0, 0.0));
    let clear = Interface::Constant { reflected: Rgb::BLACK, transmitted: Rgb::WHITE, medium };
    let ground = Material::matte(Rgb::WHITE).with_shares(1.0, 0.0, 0.0);
    let objects = [
        Object::new(water, Material::dielectric(1.0).with_interface(clear)),
        Object::new(Shape::plane(Vec3::new(0.0, -5.0, 0.0), UP), ground),
    ];
    let scene = scene(Background::Solid(Rgb::WHITE)).with_objects(&objects);
    let origin = Vec3::new(0.0, 0.3, 0.0);
    shoot(&Nested::try_new(&scene).unwrap(), Ray { origin, direction }, 5).0
}

#[test]
fn a_plane_of_water_is_as_a_block_of_water() {
    let plane = Shape::plane(Vec3::new(0.0, 0.3, 0.0), UP);
    let block = Shape::axis_box(Vec3::new(-1e3, -9.0, -1e3), Vec3::new(1e3, 0.3, 1e3));
    for direction in [UP, -UP, Vec3::new(0.6, -0.8, 0.0), Vec3::new(0.0, 0.6, 0.8)] {
        assert_eq!(seen(plane, direction), seen(block, direction), "{direction:?}");
    }
}
