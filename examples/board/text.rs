//! Text for the user. Numbers come without `core::fmt`, which is larger than a small tracer, and without divisions, which
//! small processors do not have; a program that has room for `core::fmt` takes [`Console`].

use core::fmt;

use super::write;

/// Prints text.
pub fn print(text: &str) {
    write(text.as_bytes());
}

/// Takes what is written by [`fmt::Write`].
pub struct Console;

impl fmt::Write for Console {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        print(text);
        Ok(())
    }
}

/// Prints a number in decimal.
pub fn print_number(number: u64) {
    let mut text = [b'0'; POWERS_OF_TEN.len()];
    let mut rest = number;
    let mut first = POWERS_OF_TEN.len() - 1;
    for (place, (digit, power)) in text.iter_mut().zip(&POWERS_OF_TEN).enumerate() {
        while rest >= *power {
            rest -= *power;
            *digit += 1;
            first = first.min(place);
        }
    }
    write(text.get(first..).unwrap_or_default());
}

/// Prints all digits of a number in hexadecimal.
pub fn print_hexadecimal(number: u64) {
    let digit = |shift: usize| match (number >> (60 - 4 * shift)) as u8 & 15 {
        decimal @ 0..=9 => b'0' + decimal,
        letter => b'a' - 10 + letter,
    };
    write(&core::array::from_fn::<u8, 16, _>(digit));
}

/// All that fit into 64 bits, from the largest.
#[allow(clippy::indexing_slicing)] // Evaluated by the compiler.
static POWERS_OF_TEN: [u64; 20] = {
    let mut powers = [1; 20];
    let mut place = powers.len() - 1;
    while place > 0 {
        powers[place - 1] = 10 * powers[place];
        place -= 1;
    }
    powers
};
