//! Whole scenes: cameras, lights and what is around them.

use whit::scene::{Aperture, Emitter, Extent, Falloff, Lens};
use whit::{Background, Camera, Fresnel, Light, Medium, Ray, Real, SceneBuf, Tone, Vec3};

use super::Source;

/// Room for the scenes of these tests.
pub type Buffer<T> = SceneBuf<T, 8, 16>;

impl Source {
    /// A scene whose numbers are in the range of the type, or nearly so: some of them are refused.
    pub fn scene(&mut self) -> Buffer<f32> {
        let mut scene = SceneBuf::new(self.camera(), self.background());
        if self.once_in(4) {
            scene.medium = self.medium();
        } else {
            scene.medium = Medium::VACUUM;
        }
        scene.fresnel = self.pick(&[Fresnel::Exact, Fresnel::Exact, Fresnel::Schlick]);
        if self.once_in(6) {
            let lift = self.number(-self.limit, self.limit, &[0.0, 0.1]);
            scene.tone = Tone::Display { gain: self.number(0.0, self.limit, &[0.8, 1.0]), lift };
        }
        for _ in 0..=self.below(6) {
            scene.add_object(self.object()).unwrap();
        }
        let lights = self.pick(&[0, 1, 1, 2, 3, 16]);
        for _ in 0..lights {
            scene.add_light(self.light()).unwrap();
        }
        scene
    }

    fn camera(&mut self) -> Camera<f32> {
        let eye = if self.once_in(2) { self.point() } else { Vec3::new(0.0, 0.0, 9.0) };
        let target = self.point();
        let lens = if self.once_in(4) { Some(self.lens()) } else { None };
        Camera {
            eye,
            target: if target == eye { eye.map(|x| if x > 0.0 { x - 0.5 } else { x + 0.5 }) } else { target },
            up: self.course(),
            half_height: self.number(1e-3, 8.0, &[0.3, 0.4, 0.6, 1.0]),
            extent: self.pick(&[Extent::PixelEdges, Extent::PixelCentres]),
            lens,
        }
    }

    fn lens(&mut self) -> Lens<f32> {
        let size = self.length();
        let aperture = match self.below(2) {
            0 => Aperture::Disc { radius: size },
            _ => Aperture::Square { side: size },
        };
        Lens { aperture, focus: self.length() }
    }

    fn light(&mut self) -> Light<f32> {
        let emitter = match self.below(5) {
            0 | 1 => Emitter::Point { position: self.point() },
            2 => Emitter::Directional { towards: self.course() },
            3 => Emitter::Sphere { center: self.point(), radius: self.length() },
            _ => Emitter::Parallelogram { corner: self.point(), edge_u: self.point(), edge_v: self.point() },
        };
        let falloff = if self.once_in(2) { Some(self.falloff()) } else { None };
        Light { emitter, color: self.color(), falloff }
    }

    fn falloff(&mut self) -> Falloff<f32> {
        Falloff {
            constant: self.number(1.0 / 64.0, self.limit, &[0.5, 1.0, 2.0]),
            linear: self.number(0.0, self.limit, &[0.0, 0.1, 1.0]),
            quadratic: self.number(0.0, self.limit, &[0.0, 0.1, 1.0]),
        }
    }

    fn background(&mut self) -> Background<f32> {
        match self.below(6) {
            0 | 1 => Background::Solid(self.color()),
            2 => Background::Gradient { below: self.color(), above: self.color(), up: self.unit_vector() },
            3 | 4 => Background::Sky { horizon: self.color(), up: self.unit_vector() },
            _ => Background::Stars {
                sky: self.color(),
                brightness: self.amount(),
                cells: self.number(1.0, self.limit, &[1.0, 2.0, 20.0]) as u16,
                radius: self.number(1.0 / 64.0, 0.5, &[0.1, 0.3]),
            },
        }
    }

    /// A ray from where a surface may be, as far out as that.
    pub fn ray<T: Real>(&mut self) -> Ray<T> {
        let most = T::OUTERMOST.to_f32();
        let is_far = self.once_in(3);
        let origin = self.point().map(|x| if is_far { (8.0 * x).clamp(-most, most) } else { x });
        let towards = if self.once_in(2) { self.unit_vector() } else { self.point() - origin };
        let direction = towards.map(T::from_f32).normalized();
        let ahead = Vec3::new(T::ZERO, T::ZERO, T::ONE);
        Ray { origin: origin.map(T::from_f32), direction: if direction == Vec3::ZERO { ahead } else { direction } }
    }
}
