//! Printed markers that a camera recognises: the first fifty of `ArUco`'s 4x4 dictionary.

use std::fmt::Write;
use std::ops::RangeInclusive;

use thiserror::Error;

/// A marker: a black square of six by six cells, whose inner four by four cells encode its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Marker(u16);

impl Marker {
    /// The markers 0 to 3, at the corners of the calibration sheet.
    pub const CORNERS: [Self; 4] = [Self(0), Self(1), Self(2), Self(3)];

    /// Returns the marker with a number from 0 to 49.
    #[must_use]
    pub fn numbered(number: u16) -> Option<Self> {
        (usize::from(number) < CODES.len()).then_some(Self(number))
    }

    /// Returns the number of the marker.
    #[must_use]
    pub const fn number(self) -> u16 {
        self.0
    }

    /// Returns whether a cell is white; row and column count from 0 to 5, from the upper left.
    #[must_use]
    pub fn is_white(self, row: u16, column: u16) -> bool {
        let inner = 1..=4;
        let is_inner = inner.contains(&row) && inner.contains(&column);
        is_inner && CODES[usize::from(self.0)] >> (15 - 4 * (row - 1) - (column - 1)) & 1 == 1
    }

    /// Returns the marker as an SVG path filled with black: upper left corner and side, in mm.
    #[must_use]
    pub fn svg_path(self, [left, top]: [f64; 2], side_mm: f64) -> String {
        let cell = side_mm / f64::from(CELLS);
        let mut path = String::from(r#"<path fill="black" stroke="none" d=""#);
        for row in 0..CELLS {
            let mut column = 0;
            while column < CELLS {
                let end = (column..CELLS).find(|&column| self.is_white(row, column));
                let end = end.unwrap_or(CELLS);
                if end > column {
                    let [x, y] = [left + cell * f64::from(column), top + cell * f64::from(row)];
                    let wide = cell * f64::from(end - column);
                    let _ = write!(path, "M{x:.3} {y:.3}h{wide:.3}v{cell:.3}h-{wide:.3}z");
                }
                column = end + 1;
            }
        }
        path + r#""/>"#
    }
}

/// Returns an A4 page of markers to cut out and stick on objects, as SVG at true size. Each has its
/// number below it.
///
/// # Errors
///
/// [`MarkersError`] if a number or the side is not allowed, or the markers do not fit on the page.
pub fn markers_svg(numbers: RangeInclusive<u16>, side_mm: f64) -> Result<String, MarkersError> {
    if !(MIN_SIDE_MM..=MAX_SIDE_MM).contains(&side_mm) {
        return Err(MarkersError::Side(side_mm));
    }
    let (first, last) = numbers.into_inner();
    if first < FIRST_OBJECT || last < first || Marker::numbered(last).is_none() {
        return Err(MarkersError::Numbers { first, last });
    }
    // White around a marker is a cell wide; more makes it easier to cut out.
    let pitch = [side_mm * 5.0 / 3.0, side_mm * 5.0 / 3.0 + LABEL_MM];
    let [columns, rows] = [0, 1].map(|axis| count(PAGE_MM[axis] - 2.0 * MARGIN_MM, pitch[axis]));
    let [wanted, room] = [last - first + 1, columns * rows];
    if wanted > room {
        return Err(MarkersError::NoRoom {
            wanted,
            room,
            side_mm,
        });
    }
    let [wide, high] = PAGE_MM;
    let mut svg = format!(
        concat!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="{wide}mm" height="{high}mm" viewBox="0 0 {wide} {high}">"#,
            r#"<rect width="{wide}" height="{high}" fill="white"/>"#,
            r#"<g fill="black" font-family="sans-serif" font-size="3" text-anchor="middle">"#,
        ),
        wide = wide,
        high = high
    );
    for number in first..=last {
        let index = number - first;
        let [column, row] = [index % columns, index / columns].map(f64::from);
        let left = MARGIN_MM + pitch[0] * column + (pitch[0] - side_mm) / 2.0;
        let top = MARGIN_MM + pitch[1] * row + (pitch[0] - side_mm) / 2.0;
        svg += &Marker(number).svg_path([left, top], side_mm);
        let _ = write!(
            svg,
            r#"<text x="{:.3}" y="{:.3}">{number} ({side_mm} mm)</text>"#,
            left + side_mm / 2.0,
            top + side_mm * 4.0 / 3.0 + 2.5,
        );
    }
    svg += "</g></svg>\n";
    Ok(svg)
}

/// Returns how many pieces of a length fit.
fn count(length_mm: f64, piece_mm: f64) -> u16 {
    let fits = |count: &u16| f64::from(*count) * piece_mm <= length_mm;
    (1..=1000).take_while(fits).last().unwrap_or(0)
}

/// The error returned when markers cannot be printed.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum MarkersError {
    /// The numbers are not those of markers for objects.
    #[error(
        "the markers are {first} to {last}; allowed are {FIRST_OBJECT} to 49, in this order; 0 to 3 are at the corners of the calibration sheet"
    )]
    Numbers {
        /// The first number.
        first: u16,
        /// The last number.
        last: u16,
    },
    /// The side is too short or too long.
    #[error("the side is {0} mm; allowed are {MIN_SIDE_MM} to {MAX_SIDE_MM} mm")]
    Side(f64),
    /// There are too many markers for a page.
    #[error(
        "{wanted} markers of {side_mm} mm do not fit on an A4 page; {room} fit: print fewer, or smaller ones"
    )]
    NoRoom {
        /// The number of markers asked for.
        wanted: u16,
        /// The number that fits.
        room: u16,
        /// The side.
        side_mm: f64,
    },
}

/// The cells along a side.
const CELLS: u16 = 6;
const FIRST_OBJECT: u16 = 4;
const MIN_SIDE_MM: f64 = 8.0;
const MAX_SIDE_MM: f64 = 100.0;
const PAGE_MM: [f64; 2] = [210.0, 297.0];
const MARGIN_MM: f64 = 10.0;
const LABEL_MM: f64 = 2.0;

/// The inner cells, row by row from the upper left, white is 1 (`OpenCV`'s `DICT_4X4_50`).
#[rustfmt::skip]
const CODES: [u16; 50] = [
    0xb532, 0x0f9a, 0x332d, 0x9946, 0x549e, 0x79cd, 0x9e2e, 0xc4f2, 0xfeda, 0xcf56,
    0xf991, 0x11a7, 0x0eb7, 0x2a0f, 0x24b1, 0x263e, 0x4665, 0x6600, 0x6c5e, 0x76af,
    0x868b, 0xb02b, 0xccd5, 0xdd82, 0xfe47, 0x9471, 0xace4, 0xa554, 0x2123, 0x346f,
    0x4415, 0x57b2, 0x9ecf, 0xf0cb, 0x08ae, 0x0929, 0x1875, 0x04ff, 0x0df6, 0x1c5a,
    0x1718, 0x2a28, 0x328c, 0x38b2, 0x24e8, 0x2eeb, 0x2d3f, 0x4b64, 0x502e, 0x5013,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_marker_looks_like_another_one_even_turned() {
        let turned = |code: u16| {
            (0..16).fold(0, |sum, bit: u16| {
                let (row, column) = (bit / 4, bit % 4);
                sum | (code >> (15 - 4 * (3 - column) - row) & 1) << (15 - bit)
            })
        };
        for (index, &code) in CODES.iter().enumerate() {
            let mut other = code;
            for _ in 0..4 {
                let near = CODES.iter().enumerate();
                let nearest = near
                    .filter(|&(of, _)| of != index)
                    .map(|(_, code)| (code ^ other).count_ones())
                    .min();
                assert!(nearest >= Some(3), "{index}: {nearest:?}");
                other = turned(other);
            }
            assert_eq!(other, code);
        }
    }

    #[test]
    fn a_page_has_its_markers_at_true_size_with_their_numbers() {
        let svg = markers_svg(4..=15, 20.0).expect("they fit");
        assert_eq!(svg.matches("<path").count(), 12);
        for number in 4..=15 {
            assert!(svg.contains(&format!(">{number} (20 mm)<")), "{number}");
        }
        assert!(svg.contains(r#"width="210mm" height="297mm" viewBox="0 0 210 297""#));
    }

    #[test]
    fn the_numbers_of_the_sheet_and_pages_without_room_are_refused() {
        let error = |numbers, side| markers_svg(numbers, side).expect_err("refused").to_string();
        assert!(error(3..=10, 20.0).contains("0 to 3 are at the corners"));
        assert!(error(4..=50, 20.0).contains("allowed are 4 to 49"));
        assert!(error(4..=4, 5.0).contains("allowed are 8 to 100 mm"));
        assert!(error(4..=30, 60.0).contains("fit: print fewer"));
    }
}
