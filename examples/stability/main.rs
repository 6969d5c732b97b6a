//! tmp
mod leaving;
mod naive;
fn main() {}
