//! Why a picture cannot be drawn.

use thiserror::Error;

use crate::formats::Format;

/// Why a picture cannot be drawn.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ImageError {
    /// No bytes at all.
    #[error(
        "the file is empty; a picture is a {} file",
        Format::names(Format::is_picture, "or")
    )]
    EmptyFile,
    /// Another format, whatever its name says.
    #[error(
        "the file is not a {} file; save the picture as PNG or JPEG",
        Format::names(Format::is_picture, "or")
    )]
    UnknownFormat,
    /// The file breaks off, or is not what its first bytes say.
    #[error("cannot read the {format} picture: {problem}; save it again as PNG or JPEG")]
    Damaged {
        /// Which one.
        format: &'static str,
        /// What the decoder says.
        problem: String,
    },
    /// A width or height of 0, which a GIF file may have.
    #[error(
        "the picture has {width} x {height} pixels; allowed are 1 x 1 or more; save it again as PNG or JPEG"
    )]
    NoPixels {
        /// From left to right.
        width: usize,
        /// From top to bottom.
        height: usize,
    },
    /// More pixels than are ever needed.
    #[error(
        "the picture has {width} x {height} pixels; allowed are {limit} million; make it smaller"
    )]
    TooManyPixels {
        /// From left to right.
        width: usize,
        /// From top to bottom.
        height: usize,
        /// In millions.
        limit: usize,
    },
    /// A setting of the shading is out of range.
    #[error("the {setting} of the shading is {found}; allowed is {allowed}")]
    Setting {
        /// Which.
        setting: &'static str,
        /// What it is.
        found: f64,
        /// What it may be.
        allowed: &'static str,
    },
    /// Lines so near to each other on so large a paper that drawing them would take days.
    #[error(
        "a spacing of {spacing_mm} mm is too fine for a picture of {width_mm:.0} x {height_mm:.0} mm on the paper; allowed are {least_mm:.2} mm or more; use a wider spacing or a smaller picture"
    )]
    TooFine {
        /// The spacing asked for, on the paper.
        spacing_mm: f64,
        /// The smallest for this size.
        least_mm: f64,
        /// The picture on the paper, left to right.
        width_mm: f64,
        /// The picture on the paper, top to bottom.
        height_mm: f64,
    },
}
