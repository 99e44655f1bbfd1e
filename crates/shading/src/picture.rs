//! Grey pixels and their conversion to tones.

use dobot_geometry::{CancelToken, Cancelled, Point};

use crate::levels::levelled;
use crate::resample::resample;
use crate::shading::{CELLS, MAX_CELLS, Shading};
use crate::tone::{self, Tone};

/// A picture of grey pixels.
#[derive(Clone, Copy, Debug)]
pub struct GreyPicture<'a> {
    /// The pixels row by row, from the upper left corner: 0 is black, 255 white.
    pub pixels: &'a [u8],
    /// The length of a row, in pixels.
    pub width: usize,
    /// The number of rows.
    pub height: usize,
    /// The width and height of the stored picture, in millimetres.
    pub page: Point,
    /// The changes to the stored picture that show it upright.
    pub orientation: Orientation,
}

impl GreyPicture<'_> {
    /// Returns the tones on a grid as fine as the spacing needs, whatever the number of pixels.
    pub(crate) fn toned(
        &self,
        shading: &Shading,
        spacing_mm: f64,
        cancel: &CancelToken,
    ) -> Result<Tone, Cancelled> {
        let cells = |mm: f64| tone::cell((CELLS * mm / spacing_mm).ceil(), MAX_CELLS).max(2);
        let tone = resample(
            self.pixels,
            [self.width, self.height],
            [cells(self.page.x), cells(self.page.y)],
            self.page,
        );
        cancel.check()?;
        let tone = tone.oriented(self.orientation);
        Ok(levelled(&tone, shading, spacing_mm, cancel))
    }
}

/// Changes to a picture, in this order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Orientation {
    /// Whether rows become columns.
    pub transpose: bool,
    /// Whether left becomes right.
    pub mirror_x: bool,
    /// Whether top becomes bottom.
    pub mirror_y: bool,
}

impl Orientation {
    /// The orientation of this number in the Exif standard, 1 to 8: the stored position of the
    /// picture's upper left corner. Any other number is upright.
    #[must_use]
    pub const fn numbered(number: u16) -> Self {
        let (transpose, mirror_x, mirror_y) = match number {
            2 => (false, true, false),
            3 => (false, true, true),
            4 => (false, false, true),
            5 => (true, false, false),
            6 => (true, true, false),
            7 => (true, true, true),
            8 => (true, false, true),
            _ => (false, false, false),
        };
        Self {
            transpose,
            mirror_x,
            mirror_y,
        }
    }

    /// Returns the size of a page after the changes.
    #[must_use]
    pub fn page(self, stored: Point) -> Point {
        if self.transpose {
            return Point::new(stored.y, stored.x);
        }
        stored
    }
}
