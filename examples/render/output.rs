//! Pictures on disk.

use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};

use image::{ImageFormat, RgbImage};
use whit::Rgb;

use crate::part::Part;

/// A file that will be written at once, or not at all.
pub struct Target {
    path: PathBuf,
    format: ImageFormat,
}

impl Target {
    /// Checks the name and makes sure of the folder, before any work is done.
    pub fn new(path: &Path) -> Result<Self, String> {
        let fault = |problem: &str| format!("{}: {problem}", path.display());
        let format = match path.extension().and_then(|extension| extension.to_str()) {
            Some("png") => ImageFormat::Png,
            Some("exr") => ImageFormat::OpenExr,
            _ => return Err(fault("expected a name that ends in .png or .exr")),
        };
        if path.is_dir() {
            return Err(fault("is a folder"));
        }
        let target = Self { path: path.to_owned(), format };
        if target.folder() == Path::new("target/render") {
            std::fs::create_dir_all(target.folder()).map_err(|error| fault(&error.to_string()))?;
        }
        if !target.folder().is_dir() {
            return Err(fault("the folder does not exist"));
        }
        Ok(target)
    }

    fn folder(&self) -> &Path {
        match self.path.parent() {
            Some(folder) if folder != Path::new("") => folder,
            _ => Path::new("."),
        }
    }

    /// Writes the part's rows: 8-bit encoded to a PNG; as they are, with what they are of, to an EXR.
    pub fn write(&self, part: &Part, pixels: &[Rgb<f32>]) -> Result<(), String> {
        let contents = match self.format {
            ImageFormat::Png => to_png(part, pixels),
            _ => part.to_exr(pixels),
        };
        contents
            .and_then(|contents| self.replace(&contents))
            .map_err(|problem| format!("{}: {problem}", self.path.display()))
    }

    /// Writes a file beside the target and gives it the target's name when it is complete.
    fn replace(&self, contents: &[u8]) -> Result<(), String> {
        let mut builder = tempfile::Builder::new();
        builder.prefix(".render-").suffix(".partial");
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let mut file = builder.tempfile_in(self.folder()).map_err(|error| error.to_string())?;
        file.write_all(contents).map_err(|error| error.to_string())?;
        file.persist(&self.path).map_err(|error| error.to_string())?;
        Ok(())
    }
}

fn to_png(part: &Part, pixels: &[Rgb<f32>]) -> Result<Vec<u8>, String> {
    let encoding = part.description.encoding().ok_or("it is not known how its values become those of a display")?;
    let bytes = pixels.iter().flat_map(|&color| encoding.encode8(color)).collect();
    let picture =
        RgbImage::from_raw(part.size.width, part.rows.len() as u32, bytes).ok_or("the picture is incomplete")?;
    let mut file = Cursor::new(Vec::new());
    picture.write_to(&mut file, ImageFormat::Png).map_err(|error| error.to_string())?;
    Ok(file.into_inner())
}
