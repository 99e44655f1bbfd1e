//! The supported file formats. A new one needs a reader and a row here; all texts and lists of
//! formats are made from this table.

use schemars::JsonSchema;
use serde::Serialize;

use crate::artwork::Artwork;
use crate::error::SourceError;
use crate::options::ReadOptions;
use crate::picture::{self, PictureFormat};
use crate::warning::Warning;
use crate::{dxf, gcode, hpgl, lightburn, points, svg};

/// The formats, in the order in which the start of a file is compared with them.
///
/// ```
/// use dobot_import::FORMATS;
///
/// let plots = FORMATS.iter().find(|format| format.name == "HP-GL").expect("a row");
/// assert!(plots.extensions.contains(&"plt"));
/// ```
pub static FORMATS: [Format; 13] = [
    Format {
        name: "SVG",
        extensions: &["svg", "svgz"],
        mime_type: "image/svg+xml",
        contents: Contents::Page,
        is_certain: |start| svg::is_certain(&start.text),
        is_likely: |start| start.bytes.is_empty() || svg::is_likely(&start.text),
        reader: Reader::Text(svg::read),
    },
    picture("PNG", &["png"], "image/png", |start| {
        picture::format(start.bytes) == Some(PictureFormat::Png)
    }),
    picture("JPEG", &["jpg", "jpeg"], "image/jpeg", |start| {
        picture::format(start.bytes) == Some(PictureFormat::Jpeg)
    }),
    picture("GIF", &["gif"], "image/gif", |start| {
        picture::format(start.bytes) == Some(PictureFormat::Gif)
    }),
    picture("WebP", &["webp"], "image/webp", |start| {
        picture::format(start.bytes) == Some(PictureFormat::WebP)
    }),
    picture("BMP", &["bmp"], "image/bmp", |start| {
        picture::format(start.bytes) == Some(PictureFormat::Bmp)
    }),
    picture("TIFF", &["tif", "tiff"], "image/tiff", |start| {
        picture::format(start.bytes) == Some(PictureFormat::Tiff)
    }),
    Format {
        name: "DXF",
        extensions: &["dxf"],
        mime_type: "image/vnd.dxf",
        contents: Contents::Shapes,
        is_certain: |start| dxf::is_certain(&start.text),
        is_likely: |start| dxf::is_likely(&start.text),
        reader: Reader::Bytes(dxf::read),
    },
    Format {
        name: "LightBurn",
        extensions: &["lbrn", "lbrn2"],
        mime_type: "application/x-lightburn",
        contents: Contents::Lines,
        is_certain: |start| lightburn::is_certain(start.bytes),
        is_likely: |_| false,
        reader: Reader::Text(lightburn::read),
    },
    Format {
        name: "CSV",
        extensions: &["csv"],
        mime_type: "text/csv",
        contents: Contents::Lines,
        is_certain: |_| false,
        is_likely: |start| points::is_likely_csv(&start.text),
        reader: Reader::Text(points::read_csv),
    },
    Format {
        name: "JSON",
        extensions: &["json"],
        mime_type: "application/json",
        contents: Contents::Lines,
        is_certain: |_| false,
        is_likely: |start| start.text.starts_with(['[', '{']),
        reader: Reader::Text(points::read_json),
    },
    // After CSV, whose header may start with the same letters.
    Format {
        name: "HP-GL",
        extensions: &["plt", "hpgl", "hpg", "hgl"],
        mime_type: "application/vnd.hp-hpgl",
        contents: Contents::Shapes,
        is_certain: |_| false,
        is_likely: |start| hpgl::is_likely(&start.text),
        reader: Reader::Bytes(hpgl::read),
    },
    // After HP-GL: `;` starts a comment here, and may precede a command there.
    Format {
        name: "G-code",
        extensions: &["gcode", "nc", "gco", "g", "ngc", "tap", "cnc"],
        mime_type: "text/x-gcode",
        contents: Contents::Lines,
        is_certain: |_| false,
        is_likely: |start| gcode::is_likely(&start.text),
        reader: Reader::Bytes(gcode::read),
    },
];

const fn picture(
    name: &'static str,
    extensions: &'static [&'static str],
    mime_type: &'static str,
    is_certain: fn(&Start<'_>) -> bool,
) -> Format {
    Format {
        name,
        extensions,
        mime_type,
        contents: Contents::Picture,
        is_certain,
        is_likely: |_| false,
        reader: Reader::Bytes(picture::read),
    }
}

/// A file format.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Format {
    /// The name, as in `HP-GL`.
    pub name: &'static str,
    /// The file name extensions in lower case, without dots; the usual one first.
    pub extensions: &'static [&'static str],
    /// The MIME type.
    pub mime_type: &'static str,
    /// The content of its files.
    pub contents: Contents,
    /// Whether a file with this start is of this format, whatever its name is.
    #[serde(skip)]
    is_certain: fn(&Start<'_>) -> bool,
    /// Whether a file with this start is of this format if its name does not identify it.
    #[serde(skip)]
    is_likely: fn(&Start<'_>) -> bool,
    #[serde(skip)]
    reader: Reader,
}

/// The content of the files of a format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Contents {
    /// Shapes on a page, painted over each other.
    Page,
    /// Shapes, painted over each other.
    Shapes,
    /// Lines and areas.
    Lines,
    /// A pixel picture.
    Picture,
}

/// The artwork of a file and the warnings.
type Drawn = Result<(Artwork, Vec<Warning>), SourceError>;

#[derive(Debug)]
enum Reader {
    /// A reader of UTF-8 text.
    Text(fn(&str, &ReadOptions) -> Drawn),
    /// A reader of bytes: comments may contain anything, letters may be packed numbers, older files
    /// are in code pages.
    Bytes(fn(&[u8], &ReadOptions) -> Drawn),
}

/// The start of a file.
struct Start<'a> {
    bytes: &'a [u8],
    /// The start as text, without leading blanks.
    text: String,
}

impl<'a> Start<'a> {
    fn of(bytes: &'a [u8]) -> Self {
        let bytes = &bytes[..bytes.len().min(1000)];
        let text = String::from_utf8_lossy(bytes);
        let text = text.trim_start_matches('\u{FEFF}').trim_start().to_owned();
        Self { bytes, text }
    }
}

impl Format {
    /// Returns the format of a file: by its start if unambiguous, else by its name unless it names
    /// XML and the file is none, else the most likely one. An empty file without a name counts as
    /// SVG, which gives the clearest error.
    #[must_use]
    pub fn of_file(name: &str, bytes: &[u8]) -> Option<&'static Self> {
        let start = Start::of(bytes);
        let certain = FORMATS.iter().find(|format| (format.is_certain)(&start));
        let likely = || FORMATS.iter().find(|format| (format.is_likely)(&start));
        let named = Self::of_name(name);
        let is_xml = start.text.is_empty() || start.text.starts_with('<');
        let fitting = named.filter(|format| is_xml || !["SVG", "LightBurn"].contains(&format.name));
        certain.or(fitting).or_else(likely).or(named)
    }

    /// The format of a file name; `.gz` after its extension is ignored.
    #[must_use]
    pub fn of_name(name: &str) -> Option<&'static Self> {
        let unpacked = name.strip_suffix(".gz").unwrap_or(name);
        let (_, extension) = unpacked.rsplit_once('.')?;
        let extension = extension.to_ascii_lowercase();
        FORMATS
            .iter()
            .find(|format| format.extensions.contains(&extension.as_str()))
    }

    /// The names of some formats, as in `SVG, DXF and HP-GL`.
    #[must_use]
    pub fn names(is_meant: impl Fn(&Self) -> bool, conjunction: &str) -> String {
        let meant = FORMATS.iter().filter(|format| is_meant(format));
        let names: Vec<&str> = meant.map(|format| format.name).collect();
        match &names[..] {
            [first @ .., last] if !first.is_empty() => {
                format!("{} {conjunction} {last}", first.join(", "))
            }
            _ => names.concat(),
        }
    }

    /// Whether its files are pictures.
    #[must_use]
    pub fn is_picture(&self) -> bool {
        self.contents == Contents::Picture
    }

    /// Checks that a file of a text format is text.
    pub(crate) fn check(&self, bytes: &[u8]) -> Result<(), SourceError> {
        match self.reader {
            Reader::Text(_) => text(bytes).map(|_| ()),
            Reader::Bytes(_) => Ok(()),
        }
    }

    pub(crate) fn read(
        &self,
        bytes: &[u8],
        options: &ReadOptions,
    ) -> Result<(Artwork, Vec<Warning>), SourceError> {
        match self.reader {
            Reader::Text(read) => read(text(bytes)?, options),
            Reader::Bytes(read) => read(bytes, options),
        }
    }
}

impl PartialEq for Format {
    /// Finds a format by its name.
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

/// The extensions of all supported files: `.svg, .svgz, .png` and so on.
pub(crate) fn extensions() -> String {
    let all = FORMATS.iter().flat_map(|format| format.extensions);
    let dotted: Vec<String> = all.map(|extension| format!(".{extension}")).collect();
    dotted.join(", ")
}

/// The text in a file.
fn text(bytes: &[u8]) -> Result<&str, SourceError> {
    str::from_utf8(bytes).map_err(|error| {
        let valid = &bytes[..error.valid_up_to()];
        let lines = valid.split(|&byte| byte == b'\n').count();
        SourceError::NotText { line: lines }
    })
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use std::collections::HashSet;
    use std::fs;
    use std::path::Path;

    use super::*;

    #[test]
    fn each_format_is_recognised_by_its_beginning() {
        for (start, name) in [
            ("", Some("SVG")),
            ("\u{FEFF}<?xml version=\"1.0\"?>", Some("SVG")),
            ("<!-- made by hand --><svg/>", Some("SVG")),
            (
                "<?xml version=\"1.0\"?>\n<LightBurnProject AppVersion=\"1.7\">",
                Some("LightBurn"),
            ),
            (" [[[0,0]]]", Some("JSON")),
            ("{\"strokes\": []}", Some("JSON")),
            ("  0\r\nSECTION\r\n", Some("DXF")),
            ("999\nmade by hand\n0\nSECTION", Some("DXF")),
            ("  0\rSECTION\r  2\rHEADER\r", Some("DXF")),
            ("AutoCAD Binary DXF\r\n\u{1a}", Some("DXF")),
            ("0,0\n1,1", Some("CSV")),
            ("-1.5;2e3\n", Some("CSV")),
            ("pen\tX\tY\n", Some("CSV")),
            ("IN;SP1;PU0,0", Some("HP-GL")),
            ("in;pu;", Some("HP-GL")),
            ("PUPA0,0", Some("HP-GL")),
            ("\u{1b}.(;IN;", Some("HP-GL")),
            ("\u{1b}%-12345X@PJL", Some("HP-GL")),
            ("G21\nG90", Some("G-code")),
            ("g0x1", Some("G-code")),
            ("; made by hand\nG0 X1", Some("G-code")),
            ("%\n(drawing)\n", Some("G-code")),
            ("N10 G1 X1", Some("G-code")),
            ("$H\nG0", Some("G-code")),
            ("M3 S100", Some("G-code")),
            ("Dear reader", None),
            ("Input of the day", None),
            ("Green", None),
            ("\u{89}PNG", None),
        ] {
            let found = Format::of_file("-", start.as_bytes()).map(|format| format.name);
            assert_eq!(found, name, "{start:?}");
        }
    }

    #[test]
    fn no_name_and_no_extension_belongs_to_two_formats() {
        let mut seen = HashSet::new();
        for format in &FORMATS {
            let names = format.extensions.iter().chain([&format.name]);
            for name in names.filter(|name| **name != format.name.to_lowercase()) {
                assert!(seen.insert(*name), "{name} is there twice");
            }
            for extension in format.extensions {
                assert_eq!(*extension, extension.to_ascii_lowercase());
            }
        }
    }

    #[test]
    fn the_page_about_drawing_documents_each_format() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
        let page = fs::read_to_string(folder.join("../../docs/drawing.md")).unwrap();
        let rows = page.lines().filter(|line| line.starts_with("| `."));
        let sources: Vec<&str> = rows.filter_map(|line| line.split('|').nth(1)).collect();
        for format in &FORMATS {
            let usual = format!("`.{}`", format.extensions[0]);
            assert!(
                sources.iter().any(|source| source.contains(&usual)),
                "docs/drawing.md has no row for {usual} ({})",
                format.name
            );
        }
        let words = sources.iter().flat_map(|source| source.split_whitespace());
        for extension in words.filter_map(|word| word.strip_prefix("`.")?.strip_suffix('`')) {
            let file = format!("a.{extension}");
            assert!(Format::of_name(&file).is_some(), "{file} cannot be drawn");
        }
    }

    #[test]
    fn formats_are_listed_as_people_write_them() {
        assert_eq!(
            Format::names(Format::is_picture, "or"),
            "PNG, JPEG, GIF, WebP, BMP or TIFF"
        );
        assert_eq!(
            Format::names(|format| format.contents == Contents::Page, "and"),
            "SVG"
        );
    }
}
