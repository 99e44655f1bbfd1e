//! The printed sheet with the points to touch and a bar that shows whether the printer scales.

use std::fmt::Write;

use thiserror::Error;

/// The points of the sheet, forward and to the left of the base's axis, in mm, in the order of the
/// touches.
pub const SHEET_POINTS: [[f64; 2]; 9] = [
    [215.0, 0.0],
    [155.0, 100.0],
    [275.0, 100.0],
    [275.0, -100.0],
    [155.0, -100.0],
    [155.0, 0.0],
    [275.0, 0.0],
    [215.0, 100.0],
    [215.0, -100.0],
];

/// The length of the bar on a print at true size, in mm.
pub const BAR_MM: f64 = 200.0;

/// Returns the sheet, A4 landscape, as SVG at true size. Its near edge faces the arm.
#[must_use]
pub fn sheet_svg() -> String {
    let mut svg = String::from(concat!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="297mm" height="210mm" viewBox="0 0 297 210">"#,
        r#"<rect width="297" height="210" fill="white"/>"#,
        r#"<g fill="none" stroke="black" stroke-width="0.15" font-family="sans-serif" font-size="4">"#,
    ));
    for (number, [x_mm, y_mm]) in (1..).zip(SHEET_POINTS) {
        let [right, down] = on_sheet([x_mm, y_mm]);
        let _ = write!(
            svg,
            r#"<path d="M{} {down}h12M{right} {}v12"/><circle cx="{right}" cy="{down}" r="3"/>"#,
            right - 6.0,
            down - 6.0,
        );
        let _ = write!(
            svg,
            r#"<text x="{}" y="{}" fill="black" stroke="none">{number}: {x_mm}, {y_mm}</text>"#,
            right + 4.0,
            down - 4.0,
        );
    }
    let [left, right] = [(WIDE_MM - BAR_MM) / 2.0, f64::midpoint(WIDE_MM, BAR_MM)];
    let _ = write!(
        svg,
        concat!(
            r#"<path d="M{left} 188H{right}M{left} 184v8M{right} 184v8M148.5 196V206l-2 -3m2 3l2 -3"/>"#,
            r#"<g fill="black" stroke="none" text-anchor="middle"><text x="148.5" y="186">"#,
            "this bar is {bar} mm long; print at 100 %</text>",
            r#"<text x="185" y="203">the arm stands here, {near} mm from this edge to its axis</text></g></g></svg>"#,
            "\n"
        ),
        left = left,
        right = right,
        bar = BAR_MM,
        near = NEAR_EDGE_MM,
    );
    svg
}

/// Checks the length of the bar, measured on the print with a ruler.
///
/// # Errors
///
/// [`ScaledBar`] if the print is scaled.
pub fn check_bar(measured_mm: f64) -> Result<(), ScaledBar> {
    if (measured_mm - BAR_MM).abs() <= BAR_TOLERANCE_MM {
        return Ok(());
    }
    Err(ScaledBar {
        found_mm: measured_mm,
        percent: measured_mm / BAR_MM * 100.0,
    })
}

/// The error returned when the printer has scaled the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error(
    "the bar is {found_mm} mm long; allowed are {BAR_MM} mm within {BAR_TOLERANCE_MM} mm; the print is at {percent:.1} % of its size; print it at 100 % (\"actual size\")"
)]
pub struct ScaledBar {
    found_mm: f64,
    percent: f64,
}

/// Returns a calibrated position on the sheet, from its upper left corner: forward is up, left is
/// left.
pub(crate) fn on_sheet([x_mm, y_mm]: [f64; 2]) -> [f64; 2] {
    [WIDE_MM / 2.0 - y_mm, HIGH_MM + NEAR_EDGE_MM - x_mm]
}

pub(crate) const WIDE_MM: f64 = 297.0;
pub(crate) const HIGH_MM: f64 = 210.0;
/// The distance from the base's axis to the near edge.
const NEAR_EDGE_MM: f64 = 95.0;
const BAR_TOLERANCE_MM: f64 = 0.5;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_points_are_on_the_sheet_and_away_from_its_edges() {
        for point in SHEET_POINTS {
            let [right, down] = on_sheet(point);
            assert!(
                (10.0..=WIDE_MM - 10.0).contains(&right),
                "{point:?}: {right}"
            );
            assert!((10.0..=HIGH_MM - 30.0).contains(&down), "{point:?}: {down}");
        }
    }

    #[test]
    fn a_print_that_was_fitted_to_the_page_is_reported_by_its_bar() {
        assert!(check_bar(199.8).is_ok());
        let error = check_bar(194.0)
            .expect_err("it is 3 % too small")
            .to_string();
        assert!(
            error.contains("97.0 %") && error.contains("100 %"),
            "{error}"
        );
    }
}
