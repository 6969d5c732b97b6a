//! The page and its pictures.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use image::RgbImage;

use super::picture;

/// A page in Markdown, with its pictures in the folder `images/stability` beside it.
pub struct Page {
    path: PathBuf,
    images: PathBuf,
    text: String,
}

impl Page {
    pub fn new(path: &Path) -> Result<Self, String> {
        let images = path.with_file_name("images").join("stability");
        fs::create_dir_all(&images).map_err(|error| format!("{}: {error}", images.display()))?;
        Ok(Self { path: path.to_owned(), images, text: String::new() })
    }

    /// Adds a paragraph, a heading or a list.
    pub fn text(&mut self, text: &str) {
        let _ = writeln!(self.text, "{}\n", text.trim());
    }

    /// Adds a table. The first row is its head; the first column is text, the others are numbers.
    pub fn table(&mut self, rows: &[Vec<String>]) {
        for (i, row) in rows.iter().enumerate() {
            let _ = writeln!(self.text, "| {} |", row.join(" | "));
            if i == 0 {
                let _ = writeln!(self.text, "|---|{}", "--:|".repeat(row.len() - 1));
            }
        }
        self.text.push('\n');
    }

    /// Adds pictures from left to right.
    pub fn pictures(&mut self, name: &str, caption: &str, pictures: &[&RgbImage]) -> Result<(), String> {
        picture::save(&self.images.join(name).with_extension("png"), pictures)?;
        let _ = writeln!(self.text, "![{caption}](images/stability/{name}.png)\n");
        self.text(caption);
        Ok(())
    }

    pub fn write(&self) -> Result<(), String> {
        fs::write(&self.path, format!("{}\n", self.text.trim_end()))
            .map_err(|error| format!("{}: {error}", self.path.display()))
    }
}
