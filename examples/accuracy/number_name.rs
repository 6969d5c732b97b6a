//! The names of the number types that are compared. Another one is a line of the list.

use std::fmt;
use std::str::FromStr;

/// Calls a macro with the number types: what each is called here, in text, and in code.
macro_rules! with_numbers {
    ($callback:ident!($($arguments:tt)*)) => {
        $callback! { $($arguments)*
            F64, "f64", f64;
            F32, "f32", f32;
            Fast, "fast", whit::math::Fast;
            Micromath, "micromath", whit::math::Micromath;
            Q20, "q20", whit::math::Q20;
            Q16, "q16", whit::math::Q16;
        }
    };
}
pub(crate) use with_numbers;

macro_rules! names {
    ($($variant:ident, $name:literal, $type:ty;)*) => {
        /// The name of a number type.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum NumberName {
            $($variant,)*
        }

        impl NumberName {
            pub const ALL: &'static [Self] = &[$(Self::$variant,)*];

            /// Those that firmware is written in.
            pub const FIRMWARE: [Self; 4] = [Self::F32, Self::Fast, Self::Q20, Self::Q16];

            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                }
            }

            /// The type as a user of the library writes it.
            pub fn type_name(self) -> String {
                match self {
                    $(Self::$variant => stringify!($type).replace(' ', ""),)*
                }
            }
        }
    };
}

with_numbers!(names!());

impl fmt::Display for NumberName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for NumberName {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let names = || Self::ALL.iter().map(|number| number.name()).collect::<Vec<_>>().join(", ");
        let found = Self::ALL.iter().find(|number| number.name() == text);
        found.copied().ok_or_else(|| format!("number `{text}`: expected one of {}", names()))
    }
}
