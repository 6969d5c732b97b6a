//! The scenes that there is code for. A program with less code has a list of its own.

/// Calls a macro with the names of the scenes.
macro_rules! with_built_in {
    ($callback:ident($($arguments:tt)*)) => {
        $callback!($($arguments)*
            SHOWCASE SPHERES MIRRORS FLAKE CARD METALS WINDOW GLASS DEEP TINTS BUBBLE OIL TITANIUM PRISM MIRAGE SHIP SUNSET
            LENSES HOLE)
    };
}
