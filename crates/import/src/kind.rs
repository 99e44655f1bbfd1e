//! Recognises the kind of a source by its first bytes.

use crate::Source;
use crate::error::SourceError;

/// The kinds of text files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TextKind {
    Svg,
    LightBurn,
    Json,
    Dxf,
    Csv,
    Hpgl,
    Gcode,
}

impl TextKind {
    /// The kind of a text that begins like this. An empty file counts as SVG, for which the error is
    /// the clearest.
    pub(super) fn of_start(bytes: &[u8]) -> Option<Self> {
        let start = String::from_utf8_lossy(&bytes[..bytes.len().min(1000)]);
        let start = start.trim_start_matches('\u{FEFF}').trim_start();
        if is_lightburn(bytes) {
            return Some(Self::LightBurn);
        }
        if bytes.is_empty() || start.contains("<svg") || start.starts_with("<?xml") {
            return Some(Self::Svg);
        }
        let first = start.lines().next().unwrap_or_default();
        let kinds = [
            (Self::Json, start.starts_with(['[', '{'])),
            (Self::Dxf, is_dxf(start)),
            (Self::Csv, is_csv(first)),
            (Self::Hpgl, is_hpgl(start)),
            (Self::Gcode, is_gcode(start)),
        ];
        kinds.into_iter().find(|it| it.1).map(|it| it.0)
    }

    pub(super) fn source(self, bytes: Vec<u8>) -> Result<Source, SourceError> {
        Ok(match self {
            Self::Svg => Source::Svg(text(bytes)?),
            Self::LightBurn => Source::LightBurn(text(bytes)?),
            Self::Json => Source::Json(text(bytes)?),
            Self::Csv => Source::Csv(text(bytes)?),
            Self::Dxf => Source::Dxf(bytes),
            Self::Hpgl => Source::Hpgl(bytes),
            Self::Gcode => Source::Gcode(bytes),
        })
    }
}

/// Whether it is an SVG file, whatever its name says.
pub(super) fn is_svg(bytes: &[u8]) -> bool {
    let start = String::from_utf8_lossy(&bytes[..bytes.len().min(1000)]);
    let start = start.trim_start_matches('\u{FEFF}').trim_start();
    start.starts_with("<svg") || (start.starts_with("<?xml") && start.contains("<svg"))
}

/// Whether it is a project of `LightBurn`, whatever its name says.
pub(super) fn is_lightburn(bytes: &[u8]) -> bool {
    let start = &bytes[..bytes.len().min(1000)];
    let mark = b"<LightBurnProject";
    start.windows(mark.len()).any(|it| it == mark)
}

/// Refuses what other programs make a drawing of, and says which.
pub(super) fn refuse_foreign(bytes: &[u8]) -> Result<(), SourceError> {
    let start = &bytes[..bytes.len().min(1000)];
    let has = |mark: &[u8]| start.windows(mark.len()).any(|it| it == mark);
    let converted =
        "Inkscape opens it and saves it as SVG, and so does `pdftocairo -svg in.pdf out.svg`";
    let kinds = [
        (has(b"%PDF-"), "a PDF file", converted),
        (
            start.starts_with(b"%!PS") || start.starts_with(&[0xc5, 0xd0, 0xd3, 0xc6]),
            "a PostScript or EPS file",
            "Inkscape opens it and saves it as SVG, and so do `ps2pdf in.eps in.pdf` and `pdftocairo -svg in.pdf out.svg`",
        ),
        (
            start.starts_with(b"8BPS") || start.starts_with(b"gimp xcf"),
            "a file of a picture program",
            "export it as PNG there",
        ),
        (
            start.get(4..12).is_some_and(|it| {
                it.starts_with(b"ftyphei")
                    || it.starts_with(b"ftypmif1")
                    || it.starts_with(b"ftypavif")
            }),
            "an HEIC or AVIF picture",
            "save it as JPEG or PNG: phones can be told to take JPEG",
        ),
        (
            start.starts_with(b"version https://git-lfs.github.com/spec/"),
            "a pointer of Git LFS, which only stands for the file,",
            "`git lfs pull` in its folder fetches the file itself",
        ),
        (
            start.starts_with(b"PK\x03\x04"),
            "a packed folder (zip)",
            "unpack it, and give the drawing in it",
        ),
    ];
    match kinds.into_iter().find(|it| it.0) {
        Some((_, what, way)) => Err(SourceError::Foreign { what, way }),
        None => Ok(()),
    }
}

/// Pairs of lines: a section or a comment comes first.
fn is_dxf(start: &str) -> bool {
    let lines = start.split(['\r', '\n']).map(str::trim);
    let mut lines = lines.filter(|it| !it.is_empty());
    let first = (lines.next(), lines.next());
    let is_binary = start.starts_with("AutoCAD Binary DXF") || start.starts_with("AC10");
    is_binary || first == (Some("0"), Some("SECTION")) || first.0 == Some("999")
}

/// Two numbers, or a header with x and y.
fn is_csv(first: &str) -> bool {
    let fields = first
        .split([',', ';', '\t'])
        .map(|it| it.trim().to_ascii_lowercase());
    let fields: Vec<String> = fields.collect();
    let has = |name: &str| fields.iter().any(|it| it == name);
    let is_number = |it: &String| it.parse::<f64>().is_ok();
    (has("x") && has("y")) || (fields.len() >= 2 && fields.iter().all(is_number))
}

/// A plotter's escape sequence, or a command that plots begin with, and not with other letters.
fn is_hpgl(start: &str) -> bool {
    let start = start.trim_start_matches(';');
    let name = start.get(..2).unwrap_or_default().to_ascii_uppercase();
    let next = start.get(2..).unwrap_or_default();
    let is_first = [
        "BP", "DF", "IN", "IP", "PA", "PD", "PR", "PU", "RO", "SC", "SP", "VS",
    ]
    .contains(&name.as_str());
    let is_word = next.starts_with(|c: char| c.is_ascii_lowercase())
        && !start.starts_with(|c: char| c.is_ascii_lowercase());
    start.starts_with('\u{1b}') || (is_first && !is_word)
}

/// A word such as `G21`, or what may stand before the first.
fn is_gcode(start: &str) -> bool {
    let mut letters = start.chars();
    let first = letters.next().unwrap_or_default().to_ascii_uppercase();
    let second = letters.find(|it| *it != ' ').unwrap_or_default();
    "%(;$/".contains(first)
        || ("FGMNSTXYZ".contains(first) && (second.is_ascii_digit() || "-.".contains(second)))
}

/// The text in a file.
pub(crate) fn text(bytes: Vec<u8>) -> Result<String, SourceError> {
    String::from_utf8(bytes).map_err(|error| {
        let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let lines = valid.split(|&byte| byte == b'\n').count();
        SourceError::NotText { line: lines }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_kind_is_told_from_how_it_begins() {
        for (start, kind) in [
            ("", Some(TextKind::Svg)),
            ("\u{FEFF}<?xml version=\"1.0\"?>", Some(TextKind::Svg)),
            ("<!-- made by hand --><svg/>", Some(TextKind::Svg)),
            (
                "<?xml version=\"1.0\"?>\n<LightBurnProject AppVersion=\"1.7\">",
                Some(TextKind::LightBurn),
            ),
            (" [[[0,0]]]", Some(TextKind::Json)),
            ("{\"strokes\": []}", Some(TextKind::Json)),
            ("  0\r\nSECTION\r\n", Some(TextKind::Dxf)),
            ("999\nmade by hand\n0\nSECTION", Some(TextKind::Dxf)),
            ("  0\rSECTION\r  2\rHEADER\r", Some(TextKind::Dxf)),
            ("AutoCAD Binary DXF\r\n\u{1a}", Some(TextKind::Dxf)),
            ("0,0\n1,1", Some(TextKind::Csv)),
            ("-1.5;2e3\n", Some(TextKind::Csv)),
            ("pen\tX\tY\n", Some(TextKind::Csv)),
            ("IN;SP1;PU0,0", Some(TextKind::Hpgl)),
            ("in;pu;", Some(TextKind::Hpgl)),
            ("PUPA0,0", Some(TextKind::Hpgl)),
            ("\u{1b}.(;IN;", Some(TextKind::Hpgl)),
            ("\u{1b}%-12345X@PJL", Some(TextKind::Hpgl)),
            ("G21\nG90", Some(TextKind::Gcode)),
            ("g0x1", Some(TextKind::Gcode)),
            ("; made by hand\nG0 X1", Some(TextKind::Gcode)),
            ("%\n(drawing)\n", Some(TextKind::Gcode)),
            ("N10 G1 X1", Some(TextKind::Gcode)),
            ("$H\nG0", Some(TextKind::Gcode)),
            ("M3 S100", Some(TextKind::Gcode)),
            ("Dear reader", None),
            ("Input of the day", None),
            ("Green", None),
            ("\u{89}PNG", None),
        ] {
            assert_eq!(TextKind::of_start(start.as_bytes()), kind, "{start:?}");
        }
    }
}
