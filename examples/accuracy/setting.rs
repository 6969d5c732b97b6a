//! One choice of all that trades accuracy for time, as text and as code.

use std::fmt;
use std::str::FromStr;

use whit::render::Sampling;
use whit::scene::Fresnel;
use whit::{Budget, Settings, Termination};

use crate::number_name::NumberName;

/// All knobs. As text, what is not the default of a built-in scene comes at the end:
/// `f32 exact depth=5 cutoff=0 termination=background samples=1 film=bands:16`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    pub number: NumberName,
    pub fresnel: Fresnel,
    pub depth: u8,
    pub cutoff: f32,
    pub termination: Termination<f32>,
    pub sampling: Sampling<f32>,
    pub spectrum: SpectrumName,
    pub path: Path,
    /// The distance at which rays leave surfaces; none is what the scene has.
    pub offset: Option<f32>,
}

/// How films get their colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpectrumName {
    /// As the scene has it.
    Own,
    Wavelengths,
    Bands(u8),
    Table,
}

/// How bent light is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Path {
    /// As the scene has it.
    Own,
    /// In steps of this length.
    Fixed(f32),
    /// To this tolerance.
    Controlled(f32),
    /// In layers of this thickness.
    Layers(f32),
}

impl Setting {
    /// What `tracer!` and `Settings::new` give.
    pub const DEFAULT: Self = Self {
        number: NumberName::F32,
        fresnel: Fresnel::Exact,
        depth: 8,
        cutoff: 1.0 / 255.0,
        termination: Termination::Background,
        sampling: Sampling::Grid(1),
        spectrum: SpectrumName::Own,
        path: Path::Own,
        offset: None,
    };

    /// Whether it leaves the scene as it is.
    pub fn has_own_scene(&self) -> bool {
        *self == Self { fresnel: Fresnel::Exact, spectrum: SpectrumName::Own, path: Path::Own, offset: None, ..*self }
    }

    /// The setting for a picture of a size.
    pub fn for_picture(&self, width: u32, height: u32) -> Settings<f32> {
        let settings = Settings::new(width, height).with_sampling(self.sampling);
        let budget = Budget { cutoff: self.cutoff, termination: self.termination, ..Budget::with_depth(self.depth) };
        Settings { budget, ..settings }
    }

    /// The knobs that are not those of another setting.
    pub fn other_than(&self, other: &Self) -> String {
        let (mine, theirs) = (self.to_string(), other.to_string());
        let known: Vec<&str> = theirs.split(' ').collect();
        let words: Vec<&str> = mine.split(' ').filter(|word| !known.contains(word)).collect();
        if words.is_empty() { "default".to_owned() } else { words.join(" ") }
    }
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let fresnel = match self.fresnel {
            Fresnel::Exact => "exact",
            Fresnel::Schlick => "schlick",
        };
        write!(f, "{} {fresnel} depth={} cutoff={}", self.number, self.depth, Share(self.cutoff))?;
        match self.termination {
            Termination::Background => f.write_str(" termination=background")?,
            Termination::Black => f.write_str(" termination=black")?,
            Termination::Color(color) => write!(f, " termination={},{},{}", color.r, color.g, color.b)?,
        }
        match self.sampling {
            Sampling::Grid(1) => f.write_str(" samples=1")?,
            Sampling::Grid(n) => write!(f, " samples={n}x{n}")?,
            Sampling::Sequence(n) => write!(f, " samples={n}")?,
            Sampling::Adaptive { first, most, contrast } => {
                write!(f, " samples={first}..{most}@{}", Share(contrast))?;
            }
        }
        match self.spectrum {
            SpectrumName::Own => {}
            SpectrumName::Wavelengths => f.write_str(" film=wavelengths")?,
            SpectrumName::Bands(n) => write!(f, " film=bands:{n}")?,
            SpectrumName::Table => f.write_str(" film=table")?,
        }
        match self.path {
            Path::Own => {}
            Path::Fixed(length) => write!(f, " path=fixed:{length}")?,
            Path::Controlled(tolerance) => write!(f, " path=controlled:{tolerance:e}")?,
            Path::Layers(thickness) => write!(f, " path=layers:{thickness}")?,
        }
        self.offset.map_or(Ok(()), |distance| write!(f, " offset={distance}"))
    }
}

impl FromStr for Setting {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut setting = Self::DEFAULT;
        for word in text.split_whitespace() {
            match word.split_once('=') {
                None if word == "exact" => setting.fresnel = Fresnel::Exact,
                None if word == "schlick" => setting.fresnel = Fresnel::Schlick,
                None => setting.number = word.parse()?,
                Some(("depth", depth)) => setting.depth = number(depth)?,
                Some(("cutoff", cutoff)) => setting.cutoff = cutoff.parse::<Share>()?.0,
                Some(("termination", termination)) => setting.termination = parse_termination(termination)?,
                Some(("samples", samples)) => setting.sampling = parse_sampling(samples)?,
                Some(("film", film)) => setting.spectrum = parse_spectrum(film)?,
                Some(("path", path)) => setting.path = parse_path(path)?,
                Some(("offset", "own")) => setting.offset = None,
                Some(("offset", distance)) => setting.offset = Some(number(distance)?),
                Some((key, _)) => return Err(format!("`{key}` is no part of a setting")),
            }
        }
        Ok(setting)
    }
}

/// A number that is written as 1/n where it is one.
pub struct Share(pub f32);

impl fmt::Display for Share {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = self.0.recip().round();
        if self.0 > 0.0 && self.0 < 1.0 && count.recip() == self.0 {
            return write!(f, "1/{count}");
        }
        write!(f, "{}", self.0)
    }
}

impl FromStr for Share {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Ok(Self(match text.split_once('/') {
            Some((share, whole)) => number::<f32>(share)? / number::<f32>(whole)?,
            None => number(text)?,
        }))
    }
}

fn number<T: FromStr>(text: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("expected a number, found `{text}`"))
}

fn parse_termination(text: &str) -> Result<Termination<f32>, String> {
    Ok(match text {
        "background" => Termination::Background,
        "black" => Termination::Black,
        _ => {
            let channels: Vec<f32> = text.split(',').map(number).collect::<Result<_, _>>()?;
            let &[r, g, b] = channels.as_slice() else { return Err(format!("expected R,G,B, found `{text}`")) };
            Termination::Color(whit::Rgb::new(r, g, b))
        }
    })
}

fn parse_sampling(text: &str) -> Result<Sampling<f32>, String> {
    if let Some((first, rest)) = text.split_once("..") {
        let (most, contrast) = rest.split_once('@').ok_or_else(|| format!("expected A..B@C, found `{text}`"))?;
        let contrast = contrast.parse::<Share>()?.0;
        return Ok(Sampling::Adaptive { first: number(first)?, most: number(most)?, contrast });
    }
    match text.split_once('x') {
        Some((columns, rows)) if columns == rows => Ok(Sampling::Grid(number(columns)?)),
        Some(_) => Err(format!("expected as many rows as columns, found `{text}`")),
        None if text == "1" => Ok(Sampling::Grid(1)),
        None => Ok(Sampling::Sequence(number(text)?)),
    }
}

fn parse_spectrum(text: &str) -> Result<SpectrumName, String> {
    match text.split_once(':') {
        None if text == "own" => Ok(SpectrumName::Own),
        None if text == "wavelengths" => Ok(SpectrumName::Wavelengths),
        None if text == "table" => Ok(SpectrumName::Table),
        Some(("bands", count)) => Ok(SpectrumName::Bands(number(count)?)),
        _ => Err(format!("expected wavelengths, table or bands:N, found `{text}`")),
    }
}

fn parse_path(text: &str) -> Result<Path, String> {
    match text.split_once(':') {
        None if text == "own" => Ok(Path::Own),
        Some(("fixed", length)) => Ok(Path::Fixed(number(length)?)),
        Some(("controlled", tolerance)) => Ok(Path::Controlled(number(tolerance)?)),
        Some(("layers", thickness)) => Ok(Path::Layers(number(thickness)?)),
        _ => Err(format!("expected fixed:LENGTH, controlled:TOLERANCE or layers:THICKNESS, found `{text}`")),
    }
}
