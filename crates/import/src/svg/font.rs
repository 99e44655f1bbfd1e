//! SVG fonts with single-line glyphs, as Inkscape's extension for Hershey text uses them.

use std::collections::HashMap;

use dobot_geometry::{Point, bounds};
use dobot_lettering::{CAPITAL, Letter};
use svgtypes::{SimplePathSegment, SimplifyingPathParser};
use usvg::roxmltree::Node;
use usvg::tiny_skia_path::{Path, PathBuilder};

use super::check::check_path;
use super::entities;
use super::flatten::flatten;
use crate::error::{SourceError, TextError};
use crate::limits::{Budget, MAX_SEGMENTS};
use crate::place::printable;
use crate::xml;

/// A font whose glyphs are lines (SVG 1.1, chapter 20).
#[derive(Debug)]
pub(crate) struct SvgFont {
    /// Its family name.
    pub(crate) name: String,
    glyphs: HashMap<char, Glyph>,
    /// Units of the letters' grid per unit of the font.
    scale: f64,
}

#[derive(Debug)]
struct Glyph {
    /// Its lines, y up; `None` for a blank.
    path: Option<Path>,
    advance: f64,
}

impl SvgFont {
    /// Reads the first font of an SVG file. Ligatures and kerning are left out.
    ///
    /// # Errors
    ///
    /// [`TextError::FontFile`] without a font or with a damaged glyph.
    pub(crate) fn read(text: &str) -> Result<Self, SourceError> {
        entities::check(text)?;
        let doc = xml::tree(text, true)?;
        let font = doc.descendants().find(|node| is_named(node, "font"));
        let font = font.ok_or_else(|| {
            damaged("it has no <font> element; export it as an SVG font, or use another one")
        })?;
        let face = font.children().find(|node| is_named(node, "font-face"));
        let of_face = |name| face.and_then(|face| face.attribute(name));
        let name = of_face("font-family").or(font.attribute("id"));
        let units = of_face("units-per-em")
            .and_then(number)
            .unwrap_or(UNITS_PER_EM);
        let advance = font.attribute("horiz-adv-x").and_then(number);
        let mut glyphs = HashMap::new();
        for node in font.children().filter(|node| is_named(node, "glyph")) {
            let mut characters = node.attribute("unicode").unwrap_or_default().chars();
            if let (Some(character), None) = (characters.next(), characters.next()) {
                let own = node.attribute("horiz-adv-x").and_then(number).or(advance);
                let glyph = Glyph {
                    path: path(character, node.attribute("d").unwrap_or_default())?,
                    advance: own.unwrap_or(units),
                };
                // The first glyph of a character is used.
                glyphs.entry(character).or_insert(glyph);
            }
        }
        let mut font = Self {
            name: printable(name.unwrap_or("SVG font")),
            glyphs,
            scale: 1.0,
        };
        let given = of_face("cap-height").and_then(number);
        let capital = font.capital().or(given).unwrap_or(CAPITALS_PER_EM * units);
        if !(capital > 0.0 && (CAPITAL / capital).is_finite()) {
            return Err(damaged(
                "its capitals have no height; export it again, or use another one",
            )
            .into());
        }
        font.scale = CAPITAL / capital;
        Ok(font)
    }

    /// Whether it has a glyph.
    pub(crate) fn has(&self, character: char) -> bool {
        self.glyphs.contains_key(&character)
    }

    /// The glyph for a character, within a tolerance in units of the letters' grid; `None` if the
    /// font lacks it or its curves have too many corners.
    pub(crate) fn letter(&self, character: char, tolerance: f64) -> Option<Letter> {
        let Glyph { path, advance } = self.glyphs.get(&character)?;
        let tolerance = tolerance / self.scale;
        let mut budget = Budget::new(MAX_SEGMENTS);
        let strokes = path
            .as_ref()
            .map(|path| flatten(path, tolerance, &mut budget));
        let strokes = strokes.transpose().ok()?.unwrap_or_default();
        let place = |p: &Point| Point::new(p.x * self.scale, -p.y * self.scale);
        let placed = |points: &[Point]| {
            let is_dot = points.iter().all(|p| *p == points[0]);
            let count = if is_dot { 1 } else { points.len() };
            points.iter().take(count).map(place).collect()
        };
        Some(Letter {
            strokes: strokes
                .iter()
                .map(|stroke| placed(&stroke.points))
                .collect(),
            advance: advance * self.scale,
        })
    }

    /// The height of the first capital with straight stems: files often state a wrong one.
    fn capital(&self) -> Option<f64> {
        let letter = "HEIN"
            .chars()
            .find_map(|capital| self.letter(capital, CAPITAL))?;
        let height = -bounds(letter.strokes.into_iter().flatten()).y0;
        (height > 0.0).then_some(height)
    }
}

fn is_named(node: &Node<'_, '_>, name: &str) -> bool {
    node.is_element() && node.tag_name().name() == name
}

fn number(text: &str) -> Option<f64> {
    text.trim()
        .parse()
        .ok()
        .filter(|number: &f64| number.is_finite())
}

fn damaged(what: impl Into<String>) -> TextError {
    TextError::FontFile { what: what.into() }
}

/// The path of a glyph; `None` for a blank.
fn path(character: char, data: &str) -> Result<Option<Path>, TextError> {
    let mut path = PathBuilder::new();
    #[expect(
        clippy::cast_possible_truncation,
        reason = "as all paths of the library"
    )]
    let single = |number: f64| number as f32;
    check_path(data).map_err(|problem| {
        damaged(format!(
            "the path of {character:?} is invalid: expected {}; export it again, or use another one",
            problem.expected
        ))
    })?;
    for segment in SimplifyingPathParser::from(data).map_while(Result::ok) {
        match segment {
            SimplePathSegment::MoveTo { x, y } => path.move_to(single(x), single(y)),
            SimplePathSegment::LineTo { x, y } => path.line_to(single(x), single(y)),
            SimplePathSegment::CurveTo {
                x1,
                y1,
                x2,
                y2,
                x,
                y,
            } => {
                let [x1, y1, x2, y2] = [x1, y1, x2, y2].map(single);
                path.cubic_to(x1, y1, x2, y2, single(x), single(y));
            }
            SimplePathSegment::Quadratic { x1, y1, x, y } => {
                path.quad_to(single(x1), single(y1), single(x), single(y));
            }
            SimplePathSegment::ClosePath => path.close(),
        }
    }
    let path = path.finish();
    let is_finite = |path: &Path| path.bounds().width().is_finite();
    if path.is_none() && !data.trim().is_empty() || !path.as_ref().is_none_or(is_finite) {
        return Err(damaged(format!(
            "the path of {character:?} has no finite extent; export it again, or use another one"
        )));
    }
    Ok(path)
}

/// The default of SVG 1.1.
const UNITS_PER_EM: f64 = 1000.0;
/// The usual ratio.
const CAPITALS_PER_EM: f64 = 0.7;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn font(inside: &str) -> String {
        format!(
            r#"<?xml version="1.0"?><!DOCTYPE svg><svg xmlns="http://www.w3.org/2000/svg"><defs><font id="f" horiz-adv-x="500"><font-face font-family="Plain" cap-height="1"/>{inside}</font></defs></svg>"#
        )
    }

    #[test]
    fn glyphs_are_as_tall_as_their_capitals_are() {
        let text = font(
            r#"<glyph unicode="H" d="M0 0V700M300 0V700" horiz-adv-x="400"/><glyph unicode=" "/><glyph unicode="&#x2e;" d="M10 0h0"/><glyph unicode="fi" d="M0 0h9"/>"#,
        );
        let font = SvgFont::read(&text).unwrap();
        assert_eq!(font.name, "Plain");
        let h = font.letter('H', 0.1).unwrap();
        assert_eq!(h.strokes.len(), 2);
        assert!((bounds(h.strokes.concat()).y0 + CAPITAL).abs() < 1e-6);
        assert!((h.advance - 12.0).abs() < 1e-6);
        let space = font.letter(' ', 0.1).unwrap();
        assert_eq!(space.strokes.len(), 0);
        assert!((space.advance - 15.0).abs() < 1e-6);
        assert_eq!(font.letter('.', 0.1).unwrap().strokes[0].len(), 1);
        assert!(!font.has('f') && font.letter('f', 0.1).is_none());
    }

    #[test]
    fn curves_of_glyphs_are_as_fine_as_requested() {
        let text = font(
            r#"<glyph unicode="H" d="M0 0V700"/><glyph unicode="o" d="M0 0C0 400 400 400 400 0"/>"#,
        );
        let font = SvgFont::read(&text).unwrap();
        let corners = |tolerance| font.letter('o', tolerance).unwrap().strokes[0].len();
        assert!(corners(0.01) > corners(1.0), "{}", corners(0.01));
    }

    #[test]
    fn damaged_fonts_are_refused_with_the_reason() {
        for (text, part) in [
            (
                "<svg xmlns='http://www.w3.org/2000/svg'/>".to_owned(),
                "no <font> element",
            ),
            (
                font(r#"<glyph unicode="H" d="M0 0 L"/>"#),
                "the path of 'H' is invalid",
            ),
            (
                font(r#"<glyph unicode="H" d="M0 0V1e39"/>"#),
                "the path of 'H'",
            ),
            ("<svg".to_owned(), ""),
        ] {
            let error = SvgFont::read(&text).unwrap_err().to_string();
            assert!(error.contains(part), "{error}");
        }
    }
}
