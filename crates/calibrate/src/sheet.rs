//! The printed sheet with the points to touch and a bar that shows whether the printer scales.

use std::fmt::Write;

use thiserror::Error;

use crate::Marker;

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

/// A sheet to print, A4 landscape. Its number determines the length of its bar, which is not printed:
/// a person has to measure it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sheet(u16);

impl Sheet {
    /// Chooses a sheet by any number, such as the time.
    ///
    /// # Panics
    ///
    /// Never: there are few sheets.
    #[must_use]
    pub fn chosen_by(number: u64) -> Self {
        let count = u64::from(LAST - FIRST) + 1;
        Self(FIRST + u16::try_from(number % count).expect("the remainder is small"))
    }

    /// Returns the sheet with a number.
    ///
    /// # Errors
    ///
    /// [`BarError::NoSheet`] if no sheet has this number.
    pub fn numbered(number: u16) -> Result<Self, BarError> {
        if (FIRST..=LAST).contains(&number) {
            Ok(Self(number))
        } else {
            Err(BarError::NoSheet(number))
        }
    }

    /// Returns the number of the sheet, which is printed on it.
    #[must_use]
    pub const fn number(self) -> u16 {
        self.0
    }

    /// Checks the length of the bar, measured on the print with a ruler.
    ///
    /// # Errors
    ///
    /// [`BarError`] if the print is scaled, or has another bar.
    pub fn check_bar(self, measured_mm: f64) -> Result<(), BarError> {
        let percent = measured_mm / self.bar_mm() * 100.0;
        if (measured_mm - self.bar_mm()).abs() <= BAR_TOLERANCE_MM {
            Ok(())
        } else if (MIN_PERCENT..=MAX_PERCENT).contains(&percent) {
            Err(BarError::Scaled {
                number: self.0,
                measured_mm,
                percent,
            })
        } else {
            Err(BarError::OtherBar {
                number: self.0,
                measured_mm,
            })
        }
    }

    /// Returns the length of the bar on a print at true size, in mm: consecutive numbers have very
    /// different bars, shorter than a ruler of 200 mm.
    #[must_use]
    pub fn bar_mm(self) -> f64 {
        MIN_BAR_MM + f64::from(self.0 * 37 % 80) * 0.5
    }

    /// Returns the sheet as SVG at true size. Its near edge faces the arm.
    #[must_use]
    pub fn svg(self) -> String {
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
            // Away from the markers at the corners.
            let (side, anchor) = if y_mm < 0.0 {
                (-4.0, "end")
            } else {
                (4.0, "start")
            };
            let _ = write!(
                svg,
                r#"<text x="{}" y="{}" fill="black" stroke="none" text-anchor="{anchor}">{number}: {x_mm}, {y_mm}</text>"#,
                right + side,
                down - 4.0,
            );
        }
        for (marker, corners) in sheet_markers() {
            svg += &marker.svg_path(on_sheet(corners[0]), MARKER_MM);
        }
        let bar_mm = self.bar_mm();
        let _ = write!(
            svg,
            concat!(
                r#"<path d="M{left} 188H{right}M{left} 184v8M{right} 184v8M148.5 196V206l-2 -3m2 3l2 -3"/>"#,
                r#"<g fill="black" stroke="none" text-anchor="middle"><text x="148.5" y="186">"#,
                "sheet {number}: print at 100 %, and measure this bar from end to end</text>",
                r#"<text x="152.5" y="203" text-anchor="start">the arm stands here, {near} mm from this edge to its axis</text></g></g></svg>"#,
                "\n"
            ),
            left = (WIDE_MM - bar_mm) / 2.0,
            right = f64::midpoint(WIDE_MM, bar_mm),
            number = self.0,
            near = NEAR_EDGE_MM,
        );
        svg
    }
}

/// Returns the markers 0 to 3 at the corners of the sheet, clockwise from the far left one, each with
/// its own four corners: forward and to the left of the base's axis, in mm, clockwise from the upper
/// left one of the marker.
#[must_use]
pub fn sheet_markers() -> [(Marker, [[f64; 2]; 4]); 4] {
    let [right, down] = [WIDE_MM, HIGH_MM].map(|edge| edge - MARKER_EDGE_MM - MARKER_MM);
    let near = MARKER_EDGE_MM;
    let places = [[near, near], [right, near], [right, down], [near, down]];
    [0, 1, 2, 3].map(|index| {
        let [left, top] = places[index];
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
            .map(|[x, y]| in_frame([left + x * MARKER_MM, top + y * MARKER_MM]));
        (Marker::CORNERS[index], corners)
    })
}

/// Checks the number of a sheet and the measured length of its bar, which a calibration needs.
///
/// # Errors
///
/// [`BarError`] if one of them is missing, or the print is scaled.
pub fn check_bar(number: Option<u16>, measured_mm: Option<f64>) -> Result<(), BarError> {
    match (number, measured_mm) {
        (Some(number), Some(measured_mm)) => Sheet::numbered(number)?.check_bar(measured_mm),
        _ => Err(BarError::NotMeasured),
    }
}

/// The error returned when the bar of a print was not measured or has the wrong length.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum BarError {
    /// The number of the sheet or the length of its bar is missing.
    #[error(
        "the number of the sheet and the length of its bar are needed, because a scaled print looks like a longer tool; print a new sheet (an older one has no number), measure its bar, and give both"
    )]
    NotMeasured,
    /// No sheet has this number.
    #[error(
        "the number of the sheet is {0}; allowed are {FIRST} to {LAST}; it is printed above the bar of the sheet"
    )]
    NoSheet(u16),
    /// The printer has scaled the sheet.
    #[error(
        "the bar of sheet {number} is {measured_mm} mm long, so that the print is at {percent:.1} % of its size; print it at 100 % (\"actual size\"), and measure again"
    )]
    Scaled {
        /// The number of the sheet.
        number: u16,
        /// The measured length.
        measured_mm: f64,
        /// The size of the print.
        percent: f64,
    },
    /// No print of this sheet has such a bar.
    #[error(
        "no print of sheet {number} has a bar of {measured_mm} mm; measure the bar on this print with a ruler, from end to end, and check the number above it; print at 100 %"
    )]
    OtherBar {
        /// The number of the sheet.
        number: u16,
        /// The measured length.
        measured_mm: f64,
    },
}

/// Returns a calibrated position on the sheet, from its upper left corner: forward is up, left is
/// left.
pub(crate) fn on_sheet([x_mm, y_mm]: [f64; 2]) -> [f64; 2] {
    [WIDE_MM / 2.0 - y_mm, HIGH_MM + NEAR_EDGE_MM - x_mm]
}

/// The reverse of [`on_sheet`].
fn in_frame([right, down]: [f64; 2]) -> [f64; 2] {
    [HIGH_MM + NEAR_EDGE_MM - down, WIDE_MM / 2.0 - right]
}

pub(crate) const WIDE_MM: f64 = 297.0;
pub(crate) const HIGH_MM: f64 = 210.0;
/// The distance from the base's axis to the near edge.
const NEAR_EDGE_MM: f64 = 95.0;
const MARKER_MM: f64 = 28.0;
/// The distance of a marker from the edges: printers leave up to 5 mm white.
const MARKER_EDGE_MM: f64 = 6.0;
const FIRST: u16 = 100;
const LAST: u16 = 999;
const MIN_BAR_MM: f64 = 155.0;
const BAR_TOLERANCE_MM: f64 = 0.5;
/// The sizes at which printers scale a page.
const MIN_PERCENT: f64 = 90.0;
const MAX_PERCENT: f64 = 110.0;

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
    fn the_markers_leave_the_points_free_and_surround_them() {
        for (marker, corners) in sheet_markers() {
            let on = corners.map(on_sheet);
            for [right, down] in on {
                assert!(
                    (5.0..=WIDE_MM - 5.0).contains(&right) && (5.0..=HIGH_MM - 5.0).contains(&down)
                );
            }
            for point in SHEET_POINTS.map(on_sheet) {
                let apart = on.map(|corner| (corner[0] - point[0]).hypot(corner[1] - point[1]));
                assert!(apart.iter().all(|mm| *mm > 10.0), "{marker:?} at {point:?}");
            }
        }
        let farthest_left = sheet_markers()[0].1[0];
        assert!((farthest_left[0] - 299.0).abs() < 1e-9 && (farthest_left[1] - 142.5).abs() < 1e-9);
    }

    /// The length of the bar as drawn.
    fn drawn_mm(sheet: Sheet) -> f64 {
        let svg = sheet.svg();
        let (_, path) = svg.split_once(r#"<path d="M"#).expect("it has points");
        let (_, bar) = path.rsplit_once(r#"<path d="M"#).expect("it has a bar");
        let (left, right) = bar.split_once(" 188H").expect("the bar is level");
        let (right, _) = right.split_once('M').expect("it has end marks");
        let number = |text: &str| text.parse::<f64>().expect("a number");
        number(right) - number(left)
    }

    #[test]
    fn each_sheet_is_accepted_with_its_printed_bar_and_refused_with_200_mm() {
        for number in FIRST..=LAST {
            let sheet = Sheet::numbered(number).expect("it is a sheet");
            assert_eq!(sheet.check_bar(drawn_mm(sheet)), Ok(()));
            assert!(sheet.check_bar(200.0).is_err(), "sheet {number}");
            assert!(sheet.svg().contains(&format!("sheet {number}: ")));
        }
    }

    #[test]
    fn the_length_of_one_bar_does_not_apply_to_the_next_sheet() {
        for number in FIRST..LAST {
            let [this, next] = [number, number + 1].map(Sheet);
            assert!((drawn_mm(this) - drawn_mm(next)).abs() > 10.0, "{number}");
        }
    }

    #[test]
    fn a_print_that_was_fitted_to_the_page_is_reported_by_its_bar() {
        let sheet = Sheet::chosen_by(17);
        let error = sheet
            .check_bar(0.97 * drawn_mm(sheet))
            .expect_err("it is 3 % too small");
        let text = error.to_string();
        assert!(text.contains("97.0 %") && text.contains("100 %"), "{text}");
    }

    #[test]
    fn a_bar_without_the_number_of_its_sheet_is_refused_with_a_remedy() {
        for (number, bar_mm) in [(None, Some(200.0)), (Some(417), None), (None, None)] {
            assert_eq!(check_bar(number, bar_mm), Err(BarError::NotMeasured));
        }
        assert!(
            BarError::NotMeasured
                .to_string()
                .contains("print a new sheet")
        );
        assert_eq!(check_bar(Some(99), Some(200.0)), Err(BarError::NoSheet(99)));
    }
}
