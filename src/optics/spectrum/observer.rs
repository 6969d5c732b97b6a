//! The eye: from a spectrum to linear Rec. 709, in constant evaluation.

/// The wavelength of the first row of the observer, in nanometres.
pub(super) const FIRST: f64 = 380.0;
/// The step between rows, in nanometres.
pub(super) const STEP: f64 = 5.0;
/// The number of rows.
pub(super) const ROWS: usize = OBSERVER.len();

/// What an equal-energy spectrum adds to (red, green, blue) in row `row`, up to a factor per channel.
///
/// A factor per channel is all that is left open: whoever sums these divides by the sum for white.
#[allow(clippy::indexing_slicing)] // In constant evaluation only: a row out of range does not compile.
pub(super) const fn response(row: usize) -> [f64; 3] {
    let [x, y, z] = OBSERVER[row];
    let [r, g, b] = LINEAR_FROM_XYZ;
    [r[0] * x + r[1] * y + r[2] * z, g[0] * x + g[1] * y + g[2] * z, b[0] * x + b[1] * y + b[2] * z]
}

/// The same at a wavelength in nanometres, linear between the rows and zero outside.
#[allow(clippy::indexing_slicing)] // As above.
pub(super) const fn response_at(wavelength: f64) -> [f64; 3] {
    let position = (wavelength - FIRST) / STEP;
    if position < 0.0 || position > (ROWS - 1) as f64 {
        return [0.0; 3];
    }
    let row = if position as usize > ROWS - 2 { ROWS - 2 } else { position as usize };
    let (low, high) = (response(row), response(row + 1));
    let t = position - row as f64;
    [low[0] + (high[0] - low[0]) * t, low[1] + (high[1] - low[1]) * t, low[2] + (high[2] - low[2]) * t]
}

/// CIE XYZ to linear Rec. 709: the inverse of the matrix that the chromaticities of ITU-R BT.709-6 (table 1) give with
/// D65 = (0.95047, 1, 1.08883). Digits as in Lindbloom, *RGB/XYZ Matrices*.
const LINEAR_FROM_XYZ: [[f64; 3]; 3] =
    [[3.2404542, -1.5371385, -0.4985314], [-0.969266, 1.8760108, 0.041556], [0.0556434, -0.2040259, 1.0572252]];

/// The colour matching functions x̄, ȳ, z̄ of the CIE 1931 standard observer (2°) every 5 nm from 380 nm to 780 nm.
///
/// From CIE 015:2018, *Colorimetry*, as tabulated by the Colour and Vision Research Laboratory (cvrl.org). A constant,
/// not a static: it is not in the binary.
const OBSERVER: [[f64; 3]; 81] = [
    [0.001368, 3.9e-05, 0.006450001],
    [0.002236, 6.4e-05, 0.01054999],
    [0.004243, 0.00012, 0.02005001],
    [0.00765, 0.000217, 0.03621],
    [0.01431, 0.000396, 0.06785001],
    [0.02319, 0.00064, 0.1102],
    [0.04351, 0.00121, 0.2074],
    [0.07763, 0.00218, 0.3713],
    [0.13438, 0.004, 0.6456],
    [0.21477, 0.0073, 1.0390501],
    [0.2839, 0.0116, 1.3856],
    [0.3285, 0.01684, 1.62296],
    [0.34828, 0.023, 1.74706],
    [0.34806, 0.0298, 1.7826],
    [0.3362, 0.038, 1.77211],
    [0.3187, 0.048, 1.7441],
    [0.2908, 0.06, 1.6692],
    [0.2511, 0.0739, 1.5281],
    [0.19536, 0.09098, 1.28764],
    [0.1421, 0.1126, 1.0419],
    [0.09564, 0.13902, 0.8129501],
    [0.05795001, 0.1693, 0.6162],
    [0.03201, 0.20802, 0.46518],
    [0.0147, 0.2586, 0.3533],
    [0.0049, 0.323, 0.272],
    [0.0024, 0.4073, 0.2123],
    [0.0093, 0.503, 0.1582],
    [0.0291, 0.6082, 0.1117],
    [0.06327, 0.71, 0.07824999],
    [0.1096, 0.7932, 0.05725001],
    [0.1655, 0.862, 0.04216],
    [0.2257499, 0.9148501, 0.02984],
    [0.2904, 0.954, 0.0203],
    [0.3597, 0.9803, 0.0134],
    [0.4334499, 0.9949501, 0.008749999],
    [0.5120501, 1.0, 0.005749999],
    [0.5945, 0.995, 0.0039],
    [0.6784, 0.9786, 0.002749999],
    [0.7621, 0.952, 0.0021],
    [0.8425, 0.9154, 0.0018],
    [0.9163, 0.87, 0.001650001],
    [0.9786, 0.8163, 0.0014],
    [1.0263, 0.757, 0.0011],
    [1.0567, 0.6949, 0.001],
    [1.0622, 0.631, 0.0008],
    [1.0456, 0.5668, 0.0006],
    [1.0026, 0.503, 0.00034],
    [0.9384, 0.4412, 0.00024],
    [0.8544499, 0.381, 0.00019],
    [0.7514, 0.321, 0.0001],
    [0.6424, 0.265, 4.999999e-05],
    [0.5419, 0.217, 3e-05],
    [0.4479, 0.175, 2e-05],
    [0.3608, 0.1382, 1e-05],
    [0.2835, 0.107, 0.0],
    [0.2187, 0.0816, 0.0],
    [0.1649, 0.061, 0.0],
    [0.1212, 0.04458, 0.0],
    [0.0874, 0.032, 0.0],
    [0.0636, 0.0232, 0.0],
    [0.04677, 0.017, 0.0],
    [0.0329, 0.01192, 0.0],
    [0.0227, 0.00821, 0.0],
    [0.01584, 0.005723, 0.0],
    [0.01135916, 0.004102, 0.0],
    [0.008110916, 0.002929, 0.0],
    [0.005790346, 0.002091, 0.0],
    [0.004109457, 0.001484, 0.0],
    [0.002899327, 0.001047, 0.0],
    [0.00204919, 0.00074, 0.0],
    [0.001439971, 0.00052, 0.0],
    [0.0009999493, 0.0003611, 0.0],
    [0.0006900786, 0.0002492, 0.0],
    [0.0004760213, 0.0001719, 0.0],
    [0.0003323011, 0.00012, 0.0],
    [0.0002348261, 8.48e-05, 0.0],
    [0.0001661505, 6e-05, 0.0],
    [0.000117413, 4.24e-05, 0.0],
    [8.307527e-05, 3e-05, 0.0],
    [5.870652e-05, 2.12e-05, 0.0],
    [4.150994e-05, 1.499e-05, 0.0],
];

#[cfg(test)]
mod tests {
    use super::*;

    /// The observer is normalised so that the three functions enclose the same area: 106.86 nm.
    #[test]
    fn areas_under_the_observer_are_equal() {
        for component in 0..3 {
            let area: f64 = OBSERVER.iter().map(|row| row[component] * STEP).sum();
            assert!((area - 106.86).abs() < 0.02, "{component}: {area}");
        }
    }

    #[test]
    fn between_rows_the_response_is_linear() {
        assert_eq!(response_at(555.0), response(35));
        assert_eq!(response_at(780.0), response(80));
        assert_eq!(response_at(379.9), [0.0; 3]);
        assert_eq!(response_at(780.1), [0.0; 3]);
        let (low, middle, high) = (response(20)[1], response_at(482.5)[1], response(21)[1]);
        assert!((middle - f64::midpoint(low, high)).abs() < 1e-15);
    }
}
