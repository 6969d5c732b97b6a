//! Charts in SVG.

use std::ops::Range;
use std::path::Path;

use plotters::prelude::*;

const FONT: (&str, u32) = ("sans-serif", 13);
const SIZE: (u32, u32) = (760, 460);
/// The colours of Okabe and Ito, which those who see few colours can tell apart.
const COLORS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(204, 121, 167),
    RGBColor(90, 90, 90),
];

/// A line with dots.
pub struct Line<'a> {
    pub name: &'a str,
    pub points: Vec<(f64, f64)>,
    pub is_dashed: bool,
}

fn failed(error: impl std::fmt::Display) -> String {
    error.to_string()
}

/// Draws lines on two logarithmic axes.
pub fn chart(path: &Path, lines: &[Line<'_>], x: &str, y: &str) -> Result<(), String> {
    let root = SVGBackend::new(path, SIZE).into_drawing_area();
    root.fill(&WHITE).map_err(failed)?;
    let points = || lines.iter().flat_map(|line| &line.points);
    let mut chart = ChartBuilder::on(&root)
        .margin(12)
        .margin_right(24)
        .x_label_area_size(44)
        .y_label_area_size(64)
        .build_cartesian_2d(range(points().map(|p| p.0)).log_scale(), range(points().map(|p| p.1)).log_scale())
        .map_err(failed)?;
    let number = |x: &f64| format!("{x:.0}");
    chart
        .configure_mesh()
        .light_line_style(RGBColor(240, 240, 240))
        .bold_line_style(RGBColor(215, 215, 215))
        .label_style(FONT)
        .x_desc(x)
        .y_desc(y)
        .x_label_formatter(&number)
        .y_label_formatter(&number)
        .draw()
        .map_err(failed)?;
    for (line, color) in lines.iter().zip(COLORS.iter().cycle()) {
        let points = || line.points.iter().copied();
        let style = color.stroke_width(2);
        let legend = move |(x, y): (i32, i32)| PathElement::new([(x, y), (x + 18, y)], style);
        let drawn = match line.is_dashed {
            true => chart.draw_series(DashedLineSeries::new(points(), 5, 4, style)),
            false => chart.draw_series(LineSeries::new(points(), style)),
        };
        drawn.map_err(failed)?.label(line.name).legend(legend);
        chart.draw_series(points().map(|point| Circle::new(point, 3, color.filled()))).map_err(failed)?;
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .label_font(FONT)
        .background_style(WHITE.mix(0.8))
        .draw()
        .map_err(failed)?;
    root.present().map_err(failed)
}

/// From a little below the least to a little above the largest.
fn range(values: impl Iterator<Item = f64>) -> Range<f64> {
    let (low, high) = values.fold((f64::INFINITY, 0.0_f64), |(low, high), x| (low.min(x), high.max(x)));
    0.8 * low..1.25 * high
}
