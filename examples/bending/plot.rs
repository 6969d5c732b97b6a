//! Line drawings in SVG, with scales.

use std::fmt::Write;
use std::path::Path;

const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 340.0;
const LEFT: f64 = 62.0;
const BOTTOM: f64 = 44.0;
const MARGIN: f64 = 14.0;

/// What a scale goes from and to.
#[derive(Clone, Copy)]
pub struct Scale {
    pub from: f64,
    pub to: f64,
    pub logarithmic: bool,
}

/// A drawing.
pub struct Plot {
    x: Scale,
    y: Scale,
    text: String,
}

impl Scale {
    /// A linear one.
    pub const fn new(from: f64, to: f64) -> Self {
        Self { from, to, logarithmic: false }
    }

    /// A logarithmic one from a power of ten to another that has all of these between them.
    pub fn around(values: impl IntoIterator<Item = f64>) -> Self {
        let limits = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = values.into_iter().fold(limits, |(low, high), x| (low.min(x), high.max(x)));
        Self { from: 10_f64.powf(low.log10().floor()), to: 10_f64.powf(high.log10().ceil()), logarithmic: true }
    }

    /// From 0 to 1.
    fn share(&self, x: f64) -> f64 {
        if self.logarithmic {
            (x / self.from).ln() / (self.to / self.from).ln()
        } else {
            (x - self.from) / (self.to - self.from)
        }
    }

    fn ticks(&self) -> Vec<(f64, String)> {
        if self.logarithmic {
            let decades = (self.to / self.from).log10().round() as i32;
            return (0..=decades).map(|i| self.from * 10_f64.powi(i)).map(|x| (x, format!("{x:.0e}"))).collect();
        }
        (0..=4).map(|i| self.from + (self.to - self.from) * f64::from(i) / 4.0).map(|x| (x, short(x))).collect()
    }
}

/// Without digits that are only roundings.
fn short(x: f64) -> String {
    ((x * 1e6).round() / 1e6).to_string()
}

impl Plot {
    pub fn new(x: Scale, y: Scale, x_name: &str, y_name: &str) -> Self {
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" \
             font-size=\"12\">\n<rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"white\"/>\n"
        );
        let (right, floor) = (WIDTH - MARGIN, HEIGHT - BOTTOM);
        let frame = format!("M{LEFT} {MARGIN}V{floor}H{right}V{MARGIN}Z");
        let _ = writeln!(text, "<clipPath id=\"inside\"><path d=\"{frame}\"/></clipPath>");
        let mut plot = Self { x, y, text };
        for (value, name) in x.ticks() {
            let (at, _) = plot.place(value, y.from);
            plot.line(&format!("M{at:.1} {floor}V{MARGIN}"), "#ddd", 1.0, "");
            plot.label(at, floor + 16.0, "middle", &name);
        }
        for (value, name) in y.ticks() {
            let (_, at) = plot.place(x.from, value);
            plot.line(&format!("M{LEFT} {at:.1}H{right}"), "#ddd", 1.0, "");
            plot.label(LEFT - 6.0, at + 4.0, "end", &name);
        }
        plot.line(&frame, "#555", 1.0, "");
        plot.label((LEFT + right) / 2.0, HEIGHT - 8.0, "middle", x_name);
        let middle = (MARGIN + floor) / 2.0;
        let _ = writeln!(
            plot.text,
            "<text x=\"14\" y=\"{middle}\" text-anchor=\"middle\" transform=\"rotate(-90 14 {middle})\">{y_name}</text>"
        );
        plot
    }

    fn place(&self, x: f64, y: f64) -> (f64, f64) {
        let (width, height) = (WIDTH - LEFT - MARGIN, HEIGHT - BOTTOM - MARGIN);
        (LEFT + width * self.x.share(x), HEIGHT - BOTTOM - height * self.y.share(y))
    }

    fn line(&mut self, path: &str, color: &str, width: f64, more: &str) {
        let _ = writeln!(
            self.text,
            "<path d=\"{path}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\" {more}/>"
        );
    }

    fn label(&mut self, x: f64, y: f64, anchor: &str, text: &str) {
        let _ = writeln!(self.text, "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{text}</text>");
    }

    /// A line through points.
    pub fn curve(&mut self, points: impl IntoIterator<Item = (f64, f64)>, color: &str, dashed: bool) {
        let mut path = String::new();
        for (i, (x, y)) in points.into_iter().enumerate() {
            let (x, y) = self.place(x, y);
            let _ = write!(path, "{}{x:.1} {y:.1}", if i == 0 { 'M' } else { 'L' });
        }
        let dashes = if dashed { "stroke-dasharray=\"5 4\" " } else { "" };
        self.line(&path, color, 1.5, &format!("{dashes}clip-path=\"url(#inside)\" "));
    }

    /// A dot.
    pub fn dot(&mut self, x: f64, y: f64, color: &str) {
        let (x, y) = self.place(x, y);
        let _ = writeln!(self.text, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3.5\" fill=\"{color}\"/>");
    }

    /// Fills what is within the points.
    pub fn area(&mut self, points: impl IntoIterator<Item = (f64, f64)>, color: &str) {
        let places: Vec<_> = points.into_iter().map(|(x, y)| self.place(x, y)).collect();
        let path: Vec<_> = places.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
        let _ = writeln!(self.text, "<polygon points=\"{}\" fill=\"{color}\"/>", path.join(" "));
    }

    /// Names of colours, from the upper right down.
    pub fn legend(&mut self, names: &[(&str, &str)]) {
        for (i, (name, color)) in names.iter().enumerate() {
            let y = MARGIN + 18.0 + 18.0 * i as f64;
            let _ =
                writeln!(self.text, "<circle cx=\"{}\" cy=\"{}\" r=\"3.5\" fill=\"{color}\"/>", WIDTH - 110.0, y - 4.0);
            self.label(WIDTH - 100.0, y, "start", name);
        }
    }

    pub fn write(mut self, path: &Path) -> Result<(), String> {
        self.text.push_str("</svg>\n");
        std::fs::write(path, self.text).map_err(|error| format!("{}: {error}", path.display()))
    }
}
