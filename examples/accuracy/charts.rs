//! Charts in SVG.

use std::path::Path;

use plotters::coord::ranged1d::ValueFormatter;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::curves::PAIRS;

const FONT: (&str, u32) = ("sans-serif", 13);
const SIZE: (u32, u32) = (760, 460);
/// The smallest error that is drawn.
const LEAST: f64 = 1e-6;

type Result<T> = std::result::Result<T, String>;

/// Settings of a scene, by cost and error.
pub struct Cloud<'a> {
    pub points: &'a [(f64, f64)],
    /// Places in `points`.
    pub frontier: &'a [usize],
    pub default: usize,
    pub x: &'a str,
    pub y: &'a str,
}

fn failed(error: impl std::fmt::Display) -> String {
    error.to_string()
}

/// A power of ten that is not above, and one that is not below.
fn decades(values: impl Iterator<Item = f64>) -> std::ops::Range<f64> {
    let (low, high) = values.fold((f64::INFINITY, 0.0_f64), |(low, high), x| (low.min(x), high.max(x)));
    10_f64.powf(low.log10().floor())..10_f64.powf(high.log10().ceil())
}

/// All settings as dots, the frontier as a line through numbered dots, and the default as a ring.
pub fn cloud(path: &Path, cloud: &Cloud<'_>) -> Result<()> {
    let root = SVGBackend::new(path, SIZE).into_drawing_area();
    root.fill(&WHITE).map_err(failed)?;
    let points: Vec<(f64, f64)> = cloud.points.iter().map(|&(x, y)| (x, y.max(LEAST))).collect();
    let (x, y) = (points.iter().map(|p| p.0), points.iter().map(|p| p.1));
    let low = x.clone().fold(f64::INFINITY, f64::min) * 0.8;
    let high = x.fold(0.0, f64::max) * 1.25;
    let mut chart = ChartBuilder::on(&root)
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(64)
        .build_cartesian_2d((low..high).log_scale(), decades(y).log_scale())
        .map_err(failed)?;
    mesh(&mut chart, cloud.x, cloud.y, 10)?;
    let grey = RGBColor(150, 160, 175);
    let dots = points.iter().map(|&point| Circle::new(point, 2, grey.mix(0.7).filled()));
    chart.draw_series(dots).map_err(failed)?;
    let best: Vec<_> = cloud.frontier.iter().map(|&place| points[place]).collect();
    let blue = RGBColor(20, 80, 180);
    chart.draw_series(LineSeries::new(best.iter().copied(), blue.stroke_width(2))).map_err(failed)?;
    chart.draw_series(best.iter().map(|&point| Circle::new(point, 4, blue.filled()))).map_err(failed)?;
    let red = RGBColor(210, 50, 30);
    chart.draw_series([Circle::new(points[cloud.default], 7, red.stroke_width(2))]).map_err(failed)?;
    let places: Vec<_> = best.iter().map(|point| chart.backend_coord(point)).collect();
    let style = FONT.into_font().color(&blue).pos(Pos::new(HPos::Center, VPos::Center));
    for (i, at) in apart(&places).into_iter().enumerate() {
        root.draw_text(&(i + 1).to_string(), &style, at).map_err(failed)?;
    }
    root.present().map_err(failed)
}

/// Lines with dots by cost and error, each with its name.
pub fn frontiers(path: &Path, lines: &[(&str, Vec<(f64, f64)>)], x: &str, y: &str) -> Result<()> {
    let root = SVGBackend::new(path, (SIZE.0, 340)).into_drawing_area();
    root.fill(&WHITE).map_err(failed)?;
    let points = || lines.iter().flat_map(|(_, line)| line);
    let (low, high) = points().fold((f64::INFINITY, 0.0_f64), |(low, high), p| (low.min(p.0), high.max(p.0)));
    let errors = decades(points().map(|p| p.1.max(LEAST)));
    let mut chart = ChartBuilder::on(&root)
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(64)
        .build_cartesian_2d((0.8 * low..1.25 * high).log_scale(), errors.log_scale())
        .map_err(failed)?;
    mesh(&mut chart, x, y, 10)?;
    for (i, (name, line)) in lines.iter().enumerate() {
        let color = color(i, lines.len());
        let line = || line.iter().map(|&(x, y)| (x, y.max(LEAST)));
        chart
            .draw_series(LineSeries::new(line(), color.stroke_width(2)))
            .map_err(failed)?
            .label(*name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], color.stroke_width(2)));
        chart.draw_series(line().map(|point| Circle::new(point, 4, color.filled()))).map_err(failed)?;
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::LowerLeft)
        .label_font(FONT)
        .background_style(WHITE.mix(0.8))
        .draw()
        .map_err(failed)?;
    root.present().map_err(failed)
}

/// A place for a label beside each dot, away from the dots and from the labels before it.
fn apart(dots: &[(i32, i32)]) -> Vec<(i32, i32)> {
    const BESIDE: [(i32, i32); 8] = [(9, -10), (-10, 11), (12, 4), (-12, -6), (0, -15), (0, 16), (18, -16), (-18, 18)];
    let mut labels: Vec<(i32, i32)> = Vec::new();
    for dot in dots {
        let free = |at: &(i32, i32)| {
            let near = |other: &&(i32, i32), x, y| (at.0 - other.0).abs() < x && (at.1 - other.1).abs() < y;
            !labels.iter().any(|label| near(&label, 16, 13)) && !dots.iter().any(|dot| near(&dot, 9, 10))
        };
        let candidates = BESIDE.map(|(x, y)| (dot.0 + x, dot.1 + y));
        let place = candidates.into_iter().find(free).unwrap_or(candidates[0]);
        labels.push(place);
    }
    labels
}

type Chart<'a, 'b, X, Y> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<X, Y>>;

/// Axes and a grid with at most so many fine lines between two others.
fn mesh<X, Y>(chart: &mut Chart<'_, '_, X, Y>, x: &str, y: &str, lines: usize) -> Result<()>
where
    X: Ranged<ValueType = f64> + ValueFormatter<f64>,
    Y: Ranged<ValueType = f64> + ValueFormatter<f64>,
{
    let number =
        |x: &f64| if *x != 0.0 && x.abs() < 1e-3 { format!("{x:.0e}") } else { format!("{}", (x * 1e6).round() / 1e6) };
    chart
        .configure_mesh()
        .max_light_lines(lines)
        .light_line_style(RGBColor(240, 240, 240))
        .bold_line_style(RGBColor(215, 215, 215))
        .label_style(FONT)
        .x_desc(x)
        .y_desc(y)
        .x_label_formatter(&number)
        .y_label_formatter(&number)
        .draw()
        .map_err(failed)
}

fn color(i: usize, of: usize) -> RGBColor {
    let HSLColor(h, s, l) = HSLColor(i as f64 / of as f64, 0.75, 0.42);
    let (r, g, b) = HSLColor(h, s, l).rgb();
    RGBColor(r, g, b)
}

/// Errors by depth, a panel a scene: solid where what is cut takes the background, dotted where it is black.
pub fn depths(path: &Path, series: &[(&str, [Vec<f64>; 2])]) -> Result<()> {
    const COLUMNS: usize = 4;
    const PANEL: (u32, u32) = (225, 185);
    let rows = series.len().div_ceil(COLUMNS);
    let size = (PANEL.0 * COLUMNS as u32, PANEL.1 * rows.max(1) as u32);
    let root = SVGBackend::new(path, size).into_drawing_area();
    root.fill(&WHITE).map_err(failed)?;
    let values = series.iter().flat_map(|(_, both)| both.iter().flatten()).map(|&error| error.max(LEAST));
    let range = decades(values);
    for (area, (name, [background, black])) in root.split_evenly((rows, COLUMNS)).iter().zip(series) {
        let mut chart = ChartBuilder::on(area)
            .margin(6)
            .caption(name, ("sans-serif", 13))
            .x_label_area_size(20)
            .y_label_area_size(44)
            .build_cartesian_2d(0.0..10.0, range.clone().log_scale())
            .map_err(failed)?;
        mesh(&mut chart, "", "", 1)?;
        let points = |errors: &[f64]| -> Vec<(f64, f64)> {
            (0..).map(f64::from).zip(errors.iter().map(|&error| error.max(LEAST))).collect()
        };
        let (blue, red) = (RGBColor(20, 80, 180), RGBColor(210, 50, 30));
        chart.draw_series(LineSeries::new(points(background), blue.stroke_width(2))).map_err(failed)?;
        let dots = DashedLineSeries::new(points(black), 2, 4, red.stroke_width(2));
        chart.draw_series(dots).map_err(failed)?;
    }
    root.present().map_err(failed)
}

/// Reflectances by angle: solid by the Fresnel equations, dotted by Schlick's approximation.
pub fn curves(path: &Path) -> Result<()> {
    let root = SVGBackend::new(path, (SIZE.0, 520)).into_drawing_area();
    root.fill(&WHITE).map_err(failed)?;
    let mut chart = ChartBuilder::on(&root)
        .margin(12)
        .margin_right(20)
        .x_label_area_size(44)
        .y_label_area_size(64)
        .build_cartesian_2d(0.0..90.0, 0.0..1.0)
        .map_err(failed)?;
    mesh(&mut chart, "angle of incidence (degrees)", "reflectance", 1)?;
    for (i, (name, pair)) in PAIRS.iter().enumerate() {
        let color = color(i, PAIRS.len());
        let curve = |which: usize| {
            (0..=1800).map(|i| f64::from(i) / 20.0).map(move |degrees| (degrees, pair.reflectances(degrees)[which]))
        };
        chart
            .draw_series(LineSeries::new(curve(0), color.stroke_width(2)))
            .map_err(failed)?
            .label(*name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], color.stroke_width(2)));
        chart.draw_series(DashedLineSeries::new(curve(1), 2, 4, color.stroke_width(2))).map_err(failed)?;
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::Coordinate(14, 178))
        .label_font(FONT)
        .background_style(WHITE.mix(0.8))
        .draw()
        .map_err(failed)?;
    root.present().map_err(failed)
}
