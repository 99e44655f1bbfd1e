//! Errors of pictures.

use thiserror::Error;

use crate::formats::Format;

/// The error returned when a picture cannot be drawn.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ImageError {
    /// The file is empty.
    #[error(
        "the file is empty; a picture is a {} file",
        Format::names(Format::is_picture, "or")
    )]
    EmptyFile,
    /// The file is of another format, whatever its name is.
    #[error(
        "the file is not a {} file; save the picture as PNG or JPEG",
        Format::names(Format::is_picture, "or")
    )]
    UnknownFormat,
    /// The file is truncated or damaged.
    #[error("cannot read the {format} picture: {problem}; save it again as PNG or JPEG")]
    Damaged {
        /// The format.
        format: &'static str,
        /// The message of the decoder.
        problem: String,
    },
    /// The width or height is 0, which is possible in a GIF file.
    #[error(
        "the picture has {width} x {height} pixels; allowed are 1 x 1 or more; save it again as PNG or JPEG"
    )]
    NoPixels {
        /// The width.
        width: usize,
        /// The height.
        height: usize,
    },
    /// The picture has too many pixels.
    #[error(
        "the picture has {width} x {height} pixels; allowed are {limit} million; make it smaller"
    )]
    TooManyPixels {
        /// The width.
        width: usize,
        /// The height.
        height: usize,
        /// The largest number allowed, in millions.
        limit: usize,
    },
    /// A setting of the shading is out of range.
    #[error("the {setting} of the shading is {found}; allowed is {allowed}")]
    Setting {
        /// The setting.
        setting: &'static str,
        /// Its value.
        found: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// The lines are too close for the size of the picture; drawing it would take days.
    #[error(
        "a spacing of {spacing_mm} mm is too fine for a picture of {width_mm:.0} x {height_mm:.0} mm on the paper; allowed are {least_mm:.2} mm or more; use a wider spacing or a smaller picture"
    )]
    TooFine {
        /// The spacing, on the paper.
        spacing_mm: f64,
        /// The smallest spacing for this size.
        least_mm: f64,
        /// The width of the picture on the paper.
        width_mm: f64,
        /// The height of the picture on the paper.
        height_mm: f64,
    },
}
