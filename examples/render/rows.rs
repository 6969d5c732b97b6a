//! Which rows of a picture are rendered.

use std::ops::Range;

/// Rows as they are asked for.
#[derive(Clone, Debug, PartialEq)]
pub enum Rows {
    All,
    Range(Range<u32>),
    /// The one of this number, from 1 on, of so many nearly equal ranges.
    Part(u32, u32),
}

impl Rows {
    /// The rows of a picture of that height.
    ///
    /// # Errors
    /// Where the picture has too few rows.
    pub fn of(&self, height: u32) -> Result<Range<u32>, String> {
        let (rows, asked) = match *self {
            Self::All => return Ok(0..height),
            Self::Range(ref rows) if rows.end <= height => return Ok(rows.clone()),
            Self::Range(ref rows) => (format!("{}..{}", rows.start, rows.end), "rows"),
            Self::Part(number, count) if count <= height => {
                let start = |parts: u32| (u64::from(parts) * u64::from(height) / u64::from(count)) as u32;
                return Ok(start(number - 1)..start(number));
            }
            Self::Part(number, count) => (format!("{number}/{count}"), "part"),
        };
        Err(format!("--{asked} {rows}: the picture has {height} rows"))
    }
}

/// Reads `A..B`.
pub fn parse_range(text: &str) -> Result<Rows, String> {
    let rows = text.split_once("..").and_then(|(a, b)| Some(a.parse().ok()?..b.parse().ok()?));
    match rows {
        Some(rows) if !rows.is_empty() => Ok(Rows::Range(rows)),
        _ => Err("expected FIRST..END with FIRST below END, such as 0..240".to_owned()),
    }
}

/// Reads `K/N`.
pub fn parse_part(text: &str) -> Result<Rows, String> {
    let part = text.split_once('/').and_then(|(k, n)| Some((k.parse().ok()?, n.parse().ok()?)));
    match part {
        Some((number, count)) if (1..=count).contains(&number) => Ok(Rows::Part(number, count)),
        _ => Err("expected NUMBER/COUNT with NUMBER from 1 to COUNT, such as 3/8".to_owned()),
    }
}
