//! Text in the outlines of a font: a page with the text, read as an SVG file.

use std::fmt::Write as _;

use dobot_geometry::bounds;
use usvg::fontdb::{Database, FaceInfo};

use super::wrap::{Line, lines};
use super::{Align, Text, layer};
use crate::artwork::{Artwork, Layer};
use crate::error::{SourceError, TextError};
use crate::options::{LayersBy, ReadOptions};
use crate::svg;
use crate::warning::Warning;

pub(super) fn read(
    text: &Text,
    family: &str,
    options: &ReadOptions,
) -> Result<(Layer, Vec<Warning>), SourceError> {
    let face = Face::named(family, &options.fonts)?;
    if text.text.trim().is_empty() {
        return Ok((Layer::default(), Vec::new()));
    }
    let scale = text.height_mm / capital_mm(&face, options);
    let spacing_mm = text.line_spacing * text.height_mm / scale;
    let lines = lines(text, |part| scale * width_mm(part, &face, options));
    let page = page(&lines, text.align, &face, [spacing_mm, scale]);
    let fine = ReadOptions {
        tolerance_mm: (options.tolerance_mm / scale).max(1e-6),
        layers: LayersBy::Nothing,
        ..options.clone()
    };
    let (artwork, warnings) = svg::read(&page, &fine)?;
    let mut shown = one(artwork);
    for p in shown.points_mut() {
        *p = (p.to_vec2() * scale).to_point();
    }
    shown.name = layer(&text.text).name;
    shown.color = None;
    Ok((shown, warnings))
}

/// A font's name and style in SVG.
struct Face {
    family: String,
    weight: u16,
    style: &'static str,
}

impl Face {
    /// Parses `DejaVu Sans` or `dejavu sans bold italic`.
    fn named(name: &str, fonts: &Database) -> Result<Self, TextError> {
        let (mut weight, mut style) = (400, "normal");
        let mut rest = name.trim();
        loop {
            if let Some(family) = find(rest, fonts) {
                return Ok(Self {
                    family,
                    weight,
                    style,
                });
            }
            let Some((family, word)) = rest.rsplit_once(' ') else {
                return Err(unknown(name, fonts));
            };
            match word.to_ascii_lowercase().as_str() {
                "regular" => {}
                "thin" => weight = 100,
                "light" => weight = 300,
                "medium" => weight = 500,
                "semibold" => weight = 600,
                "bold" => weight = 700,
                "black" => weight = 900,
                "italic" => style = "italic",
                "oblique" => style = "oblique",
                _ => return Err(unknown(name, fonts)),
            }
            rest = family.trim_end();
        }
    }
}

fn find(name: &str, fonts: &Database) -> Option<String> {
    let mut families = fonts.faces().flat_map(families);
    families
        .find(|family| family.eq_ignore_ascii_case(name))
        .map(str::to_owned)
}

fn families(face: &FaceInfo) -> impl Iterator<Item = &str> {
    face.families.iter().map(|(family, _)| family.as_str())
}

fn unknown(name: &str, fonts: &Database) -> TextError {
    let mut known: Vec<&str> = fonts.faces().flat_map(families).collect();
    known.sort_unstable();
    known.dedup();
    let wanted = name.to_lowercase();
    known.sort_by_cached_key(|known| difference(&wanted, &known.to_lowercase()));
    TextError::UnknownFont {
        family: name.to_owned(),
        nearest: known.into_iter().take(NEAREST).map(str::to_owned).collect(),
    }
}

/// The edit distance of two texts (Levenshtein).
fn difference(from: &str, to: &str) -> usize {
    let to: Vec<char> = to.chars().take(MAX_NAME_LEN).collect();
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (i, a) in from.chars().take(MAX_NAME_LEN).enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], i + 1);
        for (j, b) in to.iter().enumerate() {
            let changed = diagonal + usize::from(a != *b);
            diagonal = row[j + 1];
            row[j + 1] = changed.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[to.len()]
}

/// The height of capitals in letters of [`SIZE_MM`].
fn capital_mm(face: &Face, options: &ReadOptions) -> f64 {
    let page = page(&[line("H")], Align::Left, face, [1.0, 1.0]);
    let ink = svg::read(&page, options).map(|(artwork, _)| bounds(one(artwork).points()));
    let height = ink.ok().map(|ink| ink.height());
    // A symbol font has no capitals; the usual ratio serves it.
    height
        .filter(|height| *height > 0.0)
        .unwrap_or(0.72 * SIZE_MM)
}

/// The width of a part of a line in letters of [`SIZE_MM`]. Spaces are measured between letters,
/// because they have no size of their own.
fn width_mm(part: &str, face: &Face, options: &ReadOptions) -> f64 {
    let width_mm = |text: &str| {
        let page = page(&[line(text)], Align::Left, face, [1.0, 1.0]);
        svg::text_width(&page, options)
    };
    if part.trim().is_empty() {
        width_mm(&format!("x{part}x")) - width_mm("xx")
    } else {
        width_mm(part)
    }
}

fn line(text: &str) -> Line {
    Line {
        text: text.to_owned(),
        ..Line::default()
    }
}

/// Returns a page with lines in letters of [`SIZE_MM`], which are shown at a scale.
fn page(lines: &[Line], align: Align, face: &Face, [spacing_mm, scale]: [f64; 2]) -> String {
    let longest = lines.iter().map(|line| line.text.len()).max().unwrap_or(0);
    let stretched = lines.iter().map(|line| line.extra_mm / scale);
    let stretched = stretched.fold(0.0, f64::max);
    #[expect(clippy::cast_precision_loss, reason = "counts of characters")]
    let [longest, count] = [longest as f64, lines.len() as f64];
    let width = ((4.0 * SIZE_MM + stretched) * (longest + 4.0)).min(MAX_MM);
    let height = (spacing_mm * count + 8.0 * SIZE_MM).min(MAX_MM);
    let (anchor, x) = match align {
        Align::Left => ("start", 0.25),
        Align::Center => ("middle", 0.5),
        Align::Right => ("end", 0.75),
    };
    let Face {
        family,
        weight,
        style,
    } = face;
    let family = escaped(family);
    let mut svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{width}mm' height='{height}mm' viewBox='0 0 {width} {height}' \
         font-family='\"{family}\"' font-weight='{weight}' font-style='{style}' font-size='{SIZE_MM}' \
         text-anchor='{anchor}' xml:space='preserve'>"
    );
    let x = x * width;
    let mut y = 4.0 * SIZE_MM;
    for line in lines {
        let words = escaped(&line.text);
        let extra_mm = line.extra_mm / scale;
        write!(
            svg,
            "<g transform='translate({x} {y})'><text word-spacing='{extra_mm}'>{words}</text></g>"
        )
        .expect("writing to a string works");
        y += spacing_mm;
    }
    svg + "</svg>"
}

/// Escapes for XML; characters not allowed in XML show as the font's box for missing letters.
fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&apos;"),
            '\t' => safe.push_str("    "),
            control if control.is_control() || matches!(control, '\u{fffe}' | '\u{ffff}') => {
                safe.push('\u{fffd}');
            }
            other => safe.push(other),
        }
    }
    safe
}

fn one(artwork: Artwork) -> Layer {
    artwork.layers.into_iter().next().unwrap_or_default()
}

/// The size at which letters are read: large enough for the reader's single precision.
const SIZE_MM: f64 = 10.0;
/// The largest page.
const MAX_MM: f64 = 500_000.0;
const NEAREST: usize = 3;
const MAX_NAME_LEN: usize = 64;
