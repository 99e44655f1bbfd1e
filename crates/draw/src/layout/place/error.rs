//! Errors of the placement.

use thiserror::Error;

/// The error returned when a drawing cannot be placed.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PlaceError {
    /// The scale is not a number above 0.
    #[error("the scale is {0}; it must be a number above 0")]
    Scale(f64),
    /// The rotation, in degrees, is not a number.
    #[error("the rotation is {0} degrees; it must be a finite number")]
    Rotate(f64),
    /// The margin leaves no space.
    #[error("the margin is {margin_mm} mm; it must be from 0 to below {most_mm} mm")]
    Margin {
        /// The margin.
        margin_mm: f64,
        /// The margin at which no space is left.
        most_mm: f64,
    },
    /// Border, crop marks and signature leave no space for the drawing.
    #[error(
        "border, crop marks and signature take {:.1} x {:.1} mm, and there are {:.1} x {:.1} mm; use a larger sheet, a smaller place.margin or place.gap, or leave one out",
        taken_mm[0], taken_mm[1], room_mm[0], room_mm[1]
    )]
    MarksTooLarge {
        /// Width and height of the marks.
        taken_mm: [f64; 2],
        /// Width and height inside the margin.
        room_mm: [f64; 2],
    },
    /// The signature is wider than the sheet.
    #[error(
        "the signature is {width_mm:.1} mm wide, and there is room for {room_mm:.1} mm; use a shorter one, or a larger sheet"
    )]
    Signature {
        /// Its width.
        width_mm: f64,
        /// The available width.
        room_mm: f64,
    },
    /// The gaps of a grid leave no space for its cells.
    #[error(
        "the gaps of the grid take all of the {:.1} x {:.1} mm; use a smaller place.gap, or fewer cells in place.grid",
        room_mm[0], room_mm[1]
    )]
    Gaps {
        /// Width and height of the space.
        room_mm: [f64; 2],
    },
    /// A text does not fit with the height of its letters.
    #[error(
        "the text does not fit in letters of {height_mm} mm; they may be {most_mm:.2} mm high; {}make it shorter",
        if *can_wrap { "wrap it with what.wrap, or " } else { "" }
    )]
    TextTooLarge {
        /// The requested height of capitals.
        height_mm: f64,
        /// The height that fits.
        most_mm: f64,
        /// Whether lines can be wrapped between words.
        can_wrap: bool,
    },
    /// There are more files than cells in the grid.
    #[error(
        "a grid of {cells} cell{} has no room for {files} files; use a cell for each, as in place.grid {files}x1",
        if *cells == 1 { "" } else { "s" }
    )]
    Cells {
        /// The number of cells.
        cells: u32,
        /// The number of files.
        files: usize,
    },
    /// The drawing is larger than the area.
    #[error(
        "the drawing is {width_mm:.1} x {height_mm:.1} mm, and the arm reaches all of {area_width_mm:.1} x {area_height_mm:.1} mm; make it smaller"
    )]
    TooLarge {
        /// The width of the drawing.
        width_mm: f64,
        /// The height of the drawing.
        height_mm: f64,
        /// The maximum width.
        area_width_mm: f64,
        /// The maximum height.
        area_height_mm: f64,
    },
    /// The drawing does not fit on the sheet.
    #[error(
        "the drawing extends {by_mm:.1} mm beyond the {} of the sheet, at x {x_mm:.1}, y {y_mm:.1}; make it smaller, or clip it with place.clip",
        if *margin_mm > 0.0 { "margin" } else { "edge" }
    )]
    BeyondSheet {
        /// The distance beyond the edge.
        by_mm: f64,
        /// The margin of the sheet.
        margin_mm: f64,
        /// Forward, in the base frame.
        x_mm: f64,
        /// To the left.
        y_mm: f64,
    },
    /// A point is out of the arm's reach.
    #[error(
        "the pen cannot reach x {x_mm:.1}, y {y_mm:.1}, z {z_mm:.1} mm: {reason}; make the drawing smaller, or place it elsewhere"
    )]
    OutOfReach {
        /// Forward, in the base frame.
        x_mm: f64,
        /// To the left.
        y_mm: f64,
        /// Up.
        z_mm: f64,
        /// The limit of the arm.
        reason: String,
    },
    /// A point on the run-up or run-out of the laser is out of reach.
    #[error(
        "the run-up or run-out of the laser cannot reach x {x_mm:.1}, y {y_mm:.1}, z {z_mm:.1} mm: {reason}; burn slower, which shortens it, or place the drawing elsewhere"
    )]
    RunOutOfReach {
        /// Forward, in the base frame.
        x_mm: f64,
        /// To the left.
        y_mm: f64,
        /// Up.
        z_mm: f64,
        /// The limit of the arm.
        reason: String,
    },
    /// A travel between two strokes leads out of reach, although each stroke may be within reach.
    #[error(
        "the travel between two strokes passes through x {x_mm:.1}, y {y_mm:.1}, z {z_mm:.1} mm: {reason}; place the drawing farther from the arm, or draw the parts on either side of it separately"
    )]
    WayOutOfReach {
        /// Forward, in the base frame.
        x_mm: f64,
        /// To the left.
        y_mm: f64,
        /// Up.
        z_mm: f64,
        /// The limit of the arm.
        reason: String,
    },
}
