//! A part of the page.

use crate::aim::Aim;

/// Of a line of a paragraph.
const WIDTH: usize = 125;

/// A part of the page, with what it says of aims.
#[derive(Default)]
pub struct Section {
    pub text: String,
    pub aims: Vec<Aim>,
}

impl Section {
    pub fn new(title: &str) -> Self {
        Self { text: format!("\n## {title}\n"), aims: Vec::new() }
    }

    /// Says what to install for a peer that is missing.
    pub fn lacks(&mut self, peer: &str, package: &str) {
        eprintln!("without {peer}");
        self.line(&format!("There was no {peer}, so this is not measured: `apt-get install {package}` on Debian."));
    }

    /// A paragraph.
    pub fn line(&mut self, text: &str) {
        self.text += "\n";
        let mut column = 0;
        for word in text.split(' ') {
            let length = word.chars().count();
            let is_full = column > 0 && column + 1 + length > WIDTH;
            self.text += if is_full {
                "\n"
            } else if column > 0 {
                " "
            } else {
                ""
            };
            self.text += word;
            column = if is_full || column == 0 { length } else { column + 1 + length };
        }
        self.text += "\n";
    }

    /// A list.
    pub fn list(&mut self, items: impl Iterator<Item = String>) {
        self.text += "\n";
        items.for_each(|item| self.text += &format!("- {item}\n"));
    }

    /// The head of a table; each column's letter in `sides` is `l` or `r`.
    pub fn table(&mut self, columns: &[&str], sides: &str) {
        let rule: Vec<&str> = sides.chars().map(|side| if side == 'r' { "--:" } else { "---" }).collect();
        self.text += &format!("\n| {} |\n|{}|\n", columns.join(" | "), rule.join("|"));
    }

    pub fn row(&mut self, cells: &[String]) {
        self.text += &format!("| {} |\n", cells.join(" | "));
    }
}
