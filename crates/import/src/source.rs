//! Files, pictures and texts that can be drawn, before they are read.

use dobot_geometry::Point;

use crate::artwork::Artwork;
use crate::error::SourceError;
use crate::limits::{MOST_BYTES, MOST_PICTURE_BYTES};
use crate::options::ReadOptions;
use crate::text::{Font, Text};
use crate::warning::Warning;
use crate::{dxf, encoding, gcode, hpgl, kind, lightburn, packed, picture, points, svg};

/// Something to be drawn, not yet read.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// An SVG file.
    Svg(String),
    /// A PNG, JPEG, GIF, WebP, BMP or TIFF file.
    Picture(Vec<u8>),
    /// G-code: of a laser, a plotter or a mill. Bytes, for its comments may hold anything.
    Gcode(Vec<u8>),
    /// HP-GL: a plot. Bytes, for its letters may be packed numbers.
    Hpgl(Vec<u8>),
    /// DXF in text. Bytes, for older ones are no UTF-8.
    Dxf(Vec<u8>),
    /// A project of `LightBurn` (`.lbrn`, `.lbrn2`).
    LightBurn(String),
    /// Points in lines: x to the right, y down, in mm.
    Csv(String),
    /// Lines of points that a program has calculated: x to the right, y down, in mm.
    Lines(Vec<Vec<Point>>),
    /// Points in JSON: lists of strokes, which are lists of points, in mm.
    Json(String),
    /// Text, in letters of single lines or outlines.
    Text(Text),
}

impl Source {
    /// Takes the contents of a file, which may be packed with gzip, for what its name says or its first
    /// bytes: SVG files, projects of `LightBurn` and pictures are known by these whatever they are called.
    ///
    /// # Errors
    ///
    /// [`SourceError::UnknownKind`] where neither tells, [`SourceError::NotText`] where a text file
    /// holds no text, [`SourceError::Encoding`], [`SourceError::Foreign`] for what other programs make a drawing of,
    /// [`SourceError::Packed`], and [`SourceError::TooLarge`].
    pub fn of_file(name: &str, bytes: Vec<u8>) -> Result<Self, SourceError> {
        let bytes = packed::unpacked(Self::checked_size(bytes)?)?;
        let bytes = encoding::in_utf8(Self::checked_size(bytes)?)?;
        kind::refuse_foreign(&bytes)?;
        let unpacked = name.strip_suffix(".gz").unwrap_or(name);
        let ending = unpacked.rsplit_once('.').map_or("", |(_, ending)| ending);
        match ending.to_ascii_lowercase().as_str() {
            _ if kind::is_svg(&bytes) => Ok(Self::Svg(kind::text(bytes)?)),
            _ if picture::is_picture(&bytes) => Ok(Self::Picture(bytes)),
            _ if kind::is_lightburn(&bytes) => Ok(Self::LightBurn(kind::text(bytes)?)),
            "svg" | "svgz" => Ok(Self::Svg(kind::text(bytes)?)),
            "png" | "jpg" | "jpeg" | "gif" | "webp" | "bmp" | "tif" | "tiff" => {
                Ok(Self::Picture(bytes))
            }
            "gcode" | "gco" | "g" | "nc" | "ngc" | "tap" | "cnc" => Ok(Self::Gcode(bytes)),
            "hpgl" | "hpg" | "hgl" | "plt" => Ok(Self::Hpgl(bytes)),
            "dxf" => Ok(Self::Dxf(bytes)),
            "lbrn" | "lbrn2" => Ok(Self::LightBurn(kind::text(bytes)?)),
            "csv" => Ok(Self::Csv(kind::text(bytes)?)),
            "json" => Ok(Self::Json(kind::text(bytes)?)),
            _ => Self::of_contents(name, bytes),
        }
    }

    /// How many bytes a file may have that begins like this: who reads it need not read more of them.
    #[must_use]
    pub fn most_bytes(start: &[u8]) -> u64 {
        if picture::is_picture(start) {
            MOST_PICTURE_BYTES
        } else {
            MOST_BYTES
        }
    }

    /// Whether it says how large it is to be drawn; otherwise it fills the paper.
    #[must_use]
    pub const fn has_size(&self) -> bool {
        !matches!(self, Self::Picture(_))
    }

    /// Whether it becomes the same however large it is drawn: it has no curves that would be read more finely.
    #[must_use]
    pub const fn is_same_at_any_size(&self) -> bool {
        matches!(self, Self::Lines(_))
    }

    /// Whether it has letters that only installed fonts can show.
    #[must_use]
    pub fn needs_fonts(&self) -> bool {
        match self {
            Self::Svg(svg) => svg.contains("<text") || svg.contains(":text"),
            Self::Text(text) => matches!(text.font, Font::Outline(_)),
            _ => false,
        }
    }

    fn checked_size(bytes: Vec<u8>) -> Result<Vec<u8>, SourceError> {
        let most = Self::most_bytes(&bytes);
        if bytes.len() as u64 > most {
            return Err(SourceError::TooLarge { most });
        }
        Ok(bytes)
    }

    fn of_contents(name: &str, bytes: Vec<u8>) -> Result<Self, SourceError> {
        match kind::TextKind::of_start(&bytes) {
            Some(kind) => kind.source(bytes),
            None => Err(SourceError::UnknownKind {
                name: name.to_owned(),
            }),
        }
    }

    /// Reads it as layers of lines and areas, with what a pen cannot show as warnings.
    ///
    /// # Errors
    ///
    /// [`SourceError`] with the place, what was found there and what is allowed.
    pub fn read(&self, options: &ReadOptions) -> Result<(Artwork, Vec<Warning>), SourceError> {
        match self {
            Self::Svg(text) => svg::read(text, options),
            Self::Text(text) => text.read(options),
            Self::Gcode(text) => gcode::read(text, options),
            Self::Hpgl(text) => hpgl::read(text, options),
            Self::Dxf(text) => dxf::read(text, options),
            Self::LightBurn(text) => lightburn::read(text, options),
            Self::Csv(text) => points::read_csv(text, options),
            Self::Json(text) => points::read_json(text, options),
            Self::Lines(lines) => points::read_lines(lines, options),
            Self::Picture(bytes) => picture::read(bytes, options),
        }
    }

    /// Width and height of a picture's page, in millimetres: what its strokes look like depends on
    /// how large it becomes, so that this has to be known first. Other sources have none.
    ///
    /// # Errors
    ///
    /// [`SourceError::Picture`] where the file is damaged or too large.
    pub fn picture_page(&self) -> Result<Option<Point>, SourceError> {
        match self {
            Self::Picture(bytes) => picture::page(bytes).map(Some),
            _ => Ok(None),
        }
    }
}

impl From<&str> for Source {
    fn from(svg: &str) -> Self {
        Self::Svg(svg.to_owned())
    }
}

#[cfg(test)]
pub(crate) mod tests;
