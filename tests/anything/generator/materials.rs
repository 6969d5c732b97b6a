//! Materials.

use whit::scene::{Balance, Body, Exponent, Highlight, Lobe};
use whit::{Material, Pattern};

use super::Source;
use super::span::{AMOUNT, SHARE};

impl Source<'_> {
    pub fn material(&mut self) -> Material<f32> {
        Material {
            body: if self.once_in(2) { Some(self.body()) } else { None },
            highlight: if self.once_in(3) { Some(self.highlight()) } else { None },
            interface: self.interface(),
            balance: if self.once_in(4) { Some(self.balance()) } else { None },
        }
    }

    fn body(&mut self) -> Body<f32> {
        let color = self.pattern();
        Body { color, emission: self.number(AMOUNT), ambient: self.number(AMOUNT), diffuse: self.number(AMOUNT) }
    }

    fn pattern(&mut self) -> Pattern<f32> {
        match self.below(4) {
            0 | 1 => Pattern::Solid(self.color()),
            2 => Pattern::Checker { even: self.color(), odd: self.color(), u: self.point(), v: self.point() },
            _ => Pattern::Gradient { from: self.color(), to: self.color(), origin: self.point(), axis: self.point() },
        }
    }

    fn highlight(&mut self) -> Highlight<f32> {
        let exponent = match self.below(4) {
            0 | 1 => Exponent::Integer(self.pick(&[0, 1, 2, 50, u32::MAX, u32::MAX - 1, 1 << 31], 0)),
            2 => Exponent::Integer(self.word()),
            _ => Exponent::Real(self.number(AMOUNT)),
        };
        Highlight { color: self.color(), lobe: self.pick(&[Lobe::Blinn, Lobe::Phong], Lobe::Blinn), exponent }
    }

    /// The two numbers may not give more light together than there is.
    fn balance(&mut self) -> Balance<f32> {
        let (ratio, brightness) = (self.number(SHARE), self.number(AMOUNT));
        if self.is_wild || ratio * brightness <= 1.0 {
            return Balance { ratio, brightness };
        }
        let most = 1.0 / ratio;
        Balance { ratio, brightness: if ratio * most <= 1.0 { most } else { most.next_down() } }
    }
}
