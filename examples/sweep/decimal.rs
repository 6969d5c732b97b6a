//! Numbers that the compiler reads.

/// A number in decimal, of at most 15 digits, as in `0.02`.
pub const fn read(text: &[u8]) -> f32 {
    let (mut digits, mut power, mut is_fraction, mut place) = (0_u64, 1.0, false, 0);
    while place < text.len() {
        match text[place] {
            digit @ b'0'..=b'9' if digits < 100_000_000_000_000 => {
                digits = 10 * digits + (digit - b'0') as u64;
                power *= if is_fraction { 10.0 } else { 1.0 };
            }
            b'.' if !is_fraction => is_fraction = true,
            _ => panic!("expected a number such as 0.02"),
        }
        place += 1;
    }
    assert!(!text.is_empty(), "expected a number such as 0.02");
    // Both are exact, so that the quotient is correctly rounded.
    (digits as f64 / power) as f32
}

/// What follows a name and a colon, as in `length:0.02`.
pub const fn after(text: &'static str, name: &str) -> Option<&'static [u8]> {
    let (text, name) = (text.as_bytes(), name.as_bytes());
    let mut place = 0;
    while place < name.len() {
        if place >= text.len() || text[place] != name[place] {
            return None;
        }
        place += 1;
    }
    if place < text.len() && text[place] == b':' { Some(text.split_at(place + 1).1) } else { None }
}
