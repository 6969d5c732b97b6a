//! Pictures on disk.

use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use image::{DynamicImage, ImageFormat, Rgb32FImage, RgbImage};
use whit::Rgb;
use whit::render::Encoding;

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

    /// Writes linear or display values: 8-bit encoded to a PNG, as they are to an EXR.
    pub fn write(&self, width: u32, pixels: &[Rgb<f32>], encoding: Encoding) -> Result<(), String> {
        let height = (pixels.len() / width as usize) as u32;
        let picture = match self.format {
            ImageFormat::Png => {
                let bytes = pixels.iter().flat_map(|&color| encoding.encode8(color)).collect();
                RgbImage::from_raw(width, height, bytes).map(DynamicImage::from)
            }
            _ => {
                let values = pixels.iter().flat_map(|color| [color.r, color.g, color.b]).collect();
                Rgb32FImage::from_raw(width, height, values).map(DynamicImage::from)
            }
        };
        let picture = picture.ok_or("the picture is incomplete")?;
        self.replace(&picture).map_err(|problem| format!("{}: {problem}", self.path.display()))
    }

    /// Writes a file beside the target and gives it the target's name when it is complete.
    fn replace(&self, picture: &DynamicImage) -> Result<(), String> {
        let mut builder = tempfile::Builder::new();
        builder.prefix(".render-").suffix(".partial");
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let mut file = builder.tempfile_in(self.folder()).map_err(|error| error.to_string())?;
        let mut buffer = std::io::Cursor::new(Vec::new());
        picture.write_to(&mut buffer, self.format).map_err(|error| error.to_string())?;
        let mut writer = BufWriter::new(&mut file);
        writer.write_all(buffer.get_ref()).and_then(|()| writer.flush()).map_err(|error| error.to_string())?;
        drop(writer);
        file.persist(&self.path).map_err(|error| error.to_string())?;
        Ok(())
    }
}
