//! A canvas for lines, areas and words, written as SVG.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use crate::style::{Rounded, ShapeStyle, TextStyle};
use crate::words::{Anchor, letter_of, placed};
use crate::{CAPITAL, width};

/// An SVG canvas: x to the right, y down; later elements cover earlier ones. Lines have round ends,
/// and no fonts are needed.
#[derive(Debug)]
pub struct Sheet {
    svg: String,
    /// The letters in use: each is defined once and referenced for every occurrence.
    letters: BTreeSet<char>,
    clips: u32,
}

/// A rectangle of a sheet.
#[derive(Clone, Copy, Debug)]
pub struct Rectangle {
    /// Its left edge.
    pub left: f64,
    /// Its upper edge.
    pub top: f64,
    /// The width.
    pub width: f64,
    /// The height.
    pub height: f64,
}

impl Rectangle {
    /// Creates a rectangle from its upper left and lower right corners.
    #[must_use]
    pub fn between([left, top]: [f64; 2], [right, bottom]: [f64; 2]) -> Self {
        Self {
            left,
            top,
            width: right - left,
            height: bottom - top,
        }
    }

    /// Returns the right edge.
    #[must_use]
    pub fn right(&self) -> f64 {
        self.left + self.width
    }

    /// Returns the lower edge.
    #[must_use]
    pub fn bottom(&self) -> f64 {
        self.top + self.height
    }

    /// Returns the attributes of a `rect` element.
    fn attributes(&self, radius: f64) -> String {
        let [left, top, width, height] =
            [self.left, self.top, self.width, self.height].map(Rounded);
        let radius = Rounded(radius);
        format!(r#"x="{left}" y="{top}" width="{width}" height="{height}" rx="{radius}""#)
    }
}

impl Sheet {
    /// Creates an empty sheet of this page, in an SVG unit of length: `mm`, or `px` for pixels.
    #[must_use]
    pub fn new(page: Rectangle, unit: &str) -> Self {
        let [left, top, width, height] =
            [page.left, page.top, page.width, page.height].map(Rounded);
        let svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}{unit}" height="{height}{unit}" viewBox="{left} {top} {width} {height}" fill="none" stroke-linecap="round" stroke-linejoin="round">
"#
        );
        Self {
            svg,
            letters: BTreeSet::new(),
            clips: 0,
        }
    }

    /// Returns the text of the SVG file.
    #[must_use]
    pub fn finish(mut self) -> String {
        self.svg += "<defs>\n";
        for letter in std::mem::take(&mut self.letters) {
            let mut path = String::new();
            for line in letter_of(letter).strokes {
                outline(&mut path, line.iter().map(|p| [p.x, p.y]));
            }
            self.add(format_args!(r#"<path id="{}" d="{path}"/>"#, id(letter)));
        }
        self.svg + "</defs>\n</svg>\n"
    }

    /// Draws a straight line.
    pub fn line(&mut self, from: [f64; 2], to: [f64; 2], style: &ShapeStyle<'_>) {
        self.curve(&[from, to], style);
    }

    /// Draws a line through points; a single point is a dot.
    pub fn curve(&mut self, points: &[[f64; 2]], style: &ShapeStyle<'_>) {
        let mut path = String::new();
        outline(&mut path, points.iter().copied());
        self.path(&path, style);
    }

    /// Draws many lines in one style with few elements, so that large pictures stay small and
    /// render fast.
    pub fn curves<L>(&mut self, lines: impl IntoIterator<Item = L>, style: &ShapeStyle<'_>)
    where
        L: IntoIterator<Item = [f64; 2]>,
    {
        self.add(format_args!("<g{style}>"));
        let (mut path, mut points) = (String::new(), 0);
        for line in lines {
            points += outline(&mut path, line);
            if points >= POINTS_A_PATH {
                self.path(&std::mem::take(&mut path), &ShapeStyle::default());
                points = 0;
            }
        }
        self.path(&path, &ShapeStyle::default());
        self.add("</g>");
    }

    /// Fills the polygon of some points.
    pub fn area(&mut self, corners: &[[f64; 2]], style: &ShapeStyle<'_>) {
        let mut path = String::new();
        outline(&mut path, corners.iter().copied());
        self.path(&(path + "Z"), style);
    }

    /// Draws SVG path data, filled by the even-odd rule.
    pub fn path(&mut self, data: &str, style: &ShapeStyle<'_>) {
        if !data.is_empty() {
            self.add(format_args!(
                r#"<path fill-rule="evenodd" d="{data}"{style}/>"#
            ));
        }
    }

    /// Draws a rectangle with rounded corners.
    pub fn rect(&mut self, frame: &Rectangle, radius: f64, style: &ShapeStyle<'_>) {
        self.add(format_args!("<rect {}{style}/>", frame.attributes(radius)));
    }

    /// Draws a circle.
    pub fn circle(&mut self, [x, y]: [f64; 2], radius: f64, style: &ShapeStyle<'_>) {
        let [x, y, radius] = [x, y, radius].map(Rounded);
        self.add(format_args!(
            r#"<circle cx="{x}" cy="{y}" r="{radius}"{style}/>"#
        ));
    }

    /// Writes a line of text, anchored at a point on its baseline.
    pub fn text(&mut self, [x, y]: [f64; 2], anchor: Anchor, kind: &TextStyle<'_>, words: &str) {
        let TextStyle {
            height,
            color,
            weight,
        } = *kind;
        let left = anchor.left(x, width(words, height));
        self.add(format_args!(
            r#"<g transform="translate({} {})scale({:.4})" stroke="{color}" stroke-width="{}" aria-label="{}">"#,
            Rounded(left),
            Rounded(y),
            height / CAPITAL,
            Rounded(weight * CAPITAL),
            escaped(words)
        ));
        for (x, letter) in placed(words).filter(|placed| !placed.1.is_whitespace()) {
            self.letters.insert(letter);
            let _ = write!(
                self.svg,
                r##"<use href="#{}" x="{}"/>"##,
                id(letter),
                Rounded(x)
            );
        }
        self.add("</g>");
    }

    /// Draws the content of `draw` with an SVG transform.
    pub fn within(&mut self, transform: &str, draw: impl FnOnce(&mut Self)) {
        self.add(format_args!(r#"<g transform="{transform}">"#));
        draw(self);
        self.add("</g>");
    }

    /// Draws the content of `draw` clipped to a frame with rounded corners.
    pub fn clipped(&mut self, frame: &Rectangle, radius: f64, draw: impl FnOnce(&mut Self)) {
        let (clip, frame) = (self.clips, frame.attributes(radius));
        self.clips += 1;
        self.add(format_args!(
            r#"<clipPath id="clip{clip}"><rect {frame}/></clipPath><g clip-path="url(#clip{clip})">"#
        ));
        draw(self);
        self.add("</g>");
    }

    fn add(&mut self, element: impl std::fmt::Display) {
        writeln!(self.svg, "{element}").expect("writing to a string works");
    }
}

/// Returns the element id of a letter.
fn id(letter: char) -> String {
    format!("letter-{:x}", u32::from(letter))
}

/// Appends a line through points and returns their number. A dot is a line of no length with round
/// ends.
fn outline(path: &mut String, points: impl IntoIterator<Item = [f64; 2]>) -> usize {
    let mut count = 0;
    for [x, y] in points {
        let to = if count == 0 { 'M' } else { 'L' };
        write!(path, "{to}{} {}", Rounded(x), Rounded(y)).expect("writing to a string works");
        count += 1;
    }
    if count == 1 {
        *path += "h.001";
    }
    count
}

/// Escapes a text for an attribute; control characters, which are not allowed there, are replaced.
fn escaped(words: &str) -> String {
    let mut text = String::new();
    for letter in words.chars() {
        match letter {
            '<' => text += "&lt;",
            '&' => text += "&amp;",
            '"' => text += "&quot;",
            letter if letter.is_control() => text.push('\u{FFFD}'),
            letter => text.push(letter),
        }
    }
    text
}

const POINTS_A_PATH: usize = 1000;

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(draw: impl FnOnce(&mut Sheet)) -> String {
        let mut sheet = Sheet::new(Rectangle::between([0.0, 0.0], [10.0, 5.0]), "mm");
        draw(&mut sheet);
        sheet.finish()
    }

    #[test]
    fn a_dot_is_a_line_of_no_length() {
        let svg = drawn(|sheet| sheet.curve(&[[-2.0, 1.004]], &ShapeStyle::line("red", 0.5)));
        assert!(
            svg.contains(r#"d="M-2 1h.001" stroke="red" stroke-width="0.5""#),
            "{svg}"
        );
    }

    #[test]
    fn many_short_lines_share_a_path() {
        let lines = (0..1500).map(|_| [[1.0, 2.0], [3.0, 4.0]]);
        let svg = drawn(|sheet| sheet.curves(lines, &ShapeStyle::line("red", 1.0)));
        assert_eq!(svg.matches("<path").count(), 3);
        assert_eq!(svg.matches('M').count(), 1500);
    }

    #[test]
    fn a_letter_is_drawn_once_and_its_words_can_be_read_by_other_programs() {
        let text = |sheet: &mut Sheet| {
            sheet.text(
                [0.0, 3.0],
                Anchor::Left,
                &TextStyle::new(2.0, "red"),
                "a <\"& a",
            );
        };
        let svg = drawn(text);
        assert!(svg.contains(r#"aria-label="a &lt;&quot;&amp; a""#), "{svg}");
        assert_eq!(svg.matches("\"letter-61\"").count(), 1);
        assert_eq!(svg.matches("\"#letter-61\"").count(), 2);
    }

    #[test]
    fn any_sheet_is_an_svg_file() {
        let svg = drawn(|sheet| {
            sheet.clipped(&Rectangle::between([0.0, 0.0], [1.0, 1.0]), 0.1, |sheet| {
                sheet.within("rotate(3)", |sheet| {
                    sheet.area(&[[0.0, 0.0], [1.0, 0.0]], &ShapeStyle::area("red"));
                });
            });
            sheet.text(
                [5.0, 3.0],
                Anchor::Middle,
                &TextStyle::new(2.0, "red").bold(),
                "Grüße\u{7} 漢",
            );
            sheet.curves([[[0.0, 0.0]]; 0], &ShapeStyle::default());
        });
        let tree = usvg::Tree::from_str(&svg, &usvg::Options::default());
        assert!(tree.is_ok(), "{svg}");
    }
}
