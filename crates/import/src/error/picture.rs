//! Errors of pictures.

use dobot_shading::ShadingError;
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
    /// This program is built without the reader of this format.
    #[error(
        "this program is built without {format} pictures; save the picture as PNG or JPEG, or use a released archive or `cargo build --release --features full`"
    )]
    NotBuilt {
        /// The format.
        format: &'static str,
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
    /// The picture cannot be drawn with these settings.
    #[error(transparent)]
    Shading(#[from] ShadingError),
}
