//! Sources: files, pictures and texts that can be drawn.

use dobot_geometry::Point;

use crate::artwork::Artwork;
use crate::error::SourceError;
use crate::formats::{Contents, FORMATS, Format};
use crate::limits::{MAX_BYTES, MAX_PICTURE_BYTES};
use crate::options::ReadOptions;
use crate::place::Place;
use crate::text::{Font, Text};
use crate::warning::{Warning, WarningKind};
use crate::{encoding, foreign, packed, picture, points};

/// A source, not yet read.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// A file.
    File {
        /// Its format.
        format: &'static Format,
        /// Its content, unpacked.
        bytes: Vec<u8>,
    },
    /// Calculated lines of points: x to the right, y down, in mm.
    Lines(Vec<Vec<Point>>),
    /// Text, in single-line letters or outlines.
    Text(Text),
}

impl Source {
    /// Creates a source from a file, optionally compressed with gzip, in the format of its start or
    /// its name ([`Format::of_file`]).
    ///
    /// # Errors
    ///
    /// [`SourceError::UnknownKind`] for an unknown format, [`SourceError::NotText`] for a text file
    /// without text, [`SourceError::Encoding`], [`SourceError::Foreign`] for a file that another
    /// program must convert, [`SourceError::Packed`], and [`SourceError::TooLarge`].
    pub fn of_file(name: &str, bytes: Vec<u8>) -> Result<Self, SourceError> {
        let bytes = packed::unpacked(Self::checked_size(bytes)?)?;
        let bytes = encoding::in_utf8(Self::checked_size(bytes)?)?;
        foreign::refuse_foreign(&bytes)?;
        let Some(format) = Format::of_file(name, &bytes) else {
            return Err(SourceError::UnknownKind {
                name: name.to_owned(),
            });
        };
        format.check(&bytes)?;
        Ok(Self::File { format, bytes })
    }

    /// The largest length of a file with this start, in bytes; readers of the file may stop there.
    #[must_use]
    pub fn most_bytes(start: &[u8]) -> u64 {
        if picture::format(start).is_some() {
            MAX_PICTURE_BYTES
        } else {
            MAX_BYTES
        }
    }

    /// Whether it has a size; otherwise it fills the paper.
    #[must_use]
    pub fn has_size(&self) -> bool {
        self.picture().is_none()
    }

    /// Whether it has letters that need installed fonts.
    #[must_use]
    pub fn needs_fonts(&self) -> bool {
        match self {
            Self::File { format, bytes } if format.contents == Contents::Page => {
                let has = |mark: &[u8]| bytes.windows(mark.len()).any(|window| window == mark);
                has(b"<text") || has(b":text")
            }
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

    /// Reads it as layers of lines and areas, with warnings about what a pen cannot show.
    ///
    /// # Errors
    ///
    /// [`SourceError`] with the place, what was found and what is allowed.
    pub fn read(&self, options: &ReadOptions) -> Result<(Artwork, Vec<Warning>), SourceError> {
        let (artwork, warnings) = match self {
            Self::File { format, bytes } => format.read(bytes, options)?,
            Self::Text(text) => text.read(options)?,
            Self::Lines(lines) => points::read_lines(lines, options)?,
        };
        if options.strict {
            refuse_mistakes(&warnings)?;
        }
        Ok((artwork, warnings))
    }

    /// The bytes of a picture.
    fn picture(&self) -> Option<&[u8]> {
        match self {
            Self::File { format, bytes } if format.is_picture() => Some(bytes),
            _ => None,
        }
    }

    /// Width and height of a picture's page, in millimetres, which must be known before reading,
    /// because the strokes depend on the size on the paper. `None` for other sources.
    ///
    /// # Errors
    ///
    /// [`SourceError::Picture`] if the file is damaged or too large.
    pub fn picture_page(&self) -> Result<Option<Point>, SourceError> {
        self.picture().map(picture::page).transpose()
    }
}

/// Refuses a source with a mistake.
pub(crate) fn refuse_mistakes(warnings: &[Warning]) -> Result<(), SourceError> {
    let is_mistake = |warning: &&Warning| warning.kind == WarningKind::Mistake;
    match warnings.iter().find(is_mistake) {
        Some(Warning { place, what, .. }) => Err(SourceError::Mistake {
            place: place.unwrap_or(Place::new(1, 1)),
            what: what.clone(),
        }),
        None => Ok(()),
    }
}

impl From<&str> for Source {
    fn from(svg: &str) -> Self {
        Self::File {
            format: &FORMATS[0],
            bytes: svg.into(),
        }
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod cancelled;
#[cfg(test)]
pub(crate) mod tests;
