//! The scenes that there is code for. A program with less code has a list of its own.

/// Calls a macro with the names of the scenes.
#[cfg(not(debug_assertions))]
macro_rules! with_built_in {
    ($callback:ident($($arguments:tt)*)) => {
        $callback!($($arguments)*
            SHOWCASE SPHERES MIRRORS FLAKE CARD METALS WINDOW GLASS DEEP TINTS BUBBLE OIL TITANIUM PRISM MIRAGE SHIP SUNSET
            LENSES HOLE)
    };
}

/// A tracer for each scene in each number type takes minutes to compile: a program that is not to be measured has a few.
#[cfg(debug_assertions)]
macro_rules! with_built_in {
    ($callback:ident($($arguments:tt)*)) => { $callback!($($arguments)* SHOWCASE BUBBLE MIRAGE) };
}
