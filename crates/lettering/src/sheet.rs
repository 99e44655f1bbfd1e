//! A picture in the making: lines, areas and words, written as SVG.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use crate::style::{Rounded, ShapeStyle, TextStyle};
use crate::words::{Anchor, letter_of, placed};
use crate::{CAPITAL, width};

/// A picture in the making: x to the right, y down; later things lie on earlier ones. Lines have
/// round ends, and no fonts are needed.
#[derive(Debug)]
pub struct Sheet {
    svg: String,
    /// Those that were written: each is drawn once and used often.
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
    /// From left to right.
    pub width: f64,
    /// From top to bottom.
    pub height: f64,
}

impl Rectangle {
    /// The rectangle from its upper left to its lower right corner.
    #[must_use]
    pub fn between([left, top]: [f64; 2], [right, bottom]: [f64; 2]) -> Self {
        Self {
            left,
            top,
            width: right - left,
            height: bottom - top,
        }
    }

    /// Its right edge.
    #[must_use]
    pub fn right(&self) -> f64 {
        self.left + self.width
    }

    /// Its lower edge.
    #[must_use]
    pub fn bottom(&self) -> f64 {
        self.top + self.height
    }

    /// The attributes of an element.
    fn attributes(&self, radius: f64) -> String {
        let [left, top, width, height] =
            [self.left, self.top, self.width, self.height].map(Rounded);
        let radius = Rounded(radius);
        format!(r#"x="{left}" y="{top}" width="{width}" height="{height}" rx="{radius}""#)
    }
}

impl Sheet {
    /// An empty sheet of that page, in a unit of length as SVG names it: `mm`, or `px` for pixels.
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

    /// The text of the SVG file.
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

    /// A straight line.
    pub fn line(&mut self, from: [f64; 2], to: [f64; 2], style: &ShapeStyle<'_>) {
        self.curve(&[from, to], style);
    }

    /// A line through some points; a single one is a dot.
    pub fn curve(&mut self, points: &[[f64; 2]], style: &ShapeStyle<'_>) {
        let mut path = String::new();
        outline(&mut path, points.iter().copied());
        self.path(&path, style);
    }

    /// Many lines in one style, in few elements: large pictures stay small and are shown fast.
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

    /// The area between some points.
    pub fn area(&mut self, corners: &[[f64; 2]], style: &ShapeStyle<'_>) {
        let mut path = String::new();
        outline(&mut path, corners.iter().copied());
        self.path(&(path + "Z"), style);
    }

    /// A path of SVG path data, filled by the even-odd rule.
    pub fn path(&mut self, data: &str, style: &ShapeStyle<'_>) {
        if !data.is_empty() {
            self.add(format_args!(
                r#"<path fill-rule="evenodd" d="{data}"{style}/>"#
            ));
        }
    }

    /// A rectangle whose corners are round.
    pub fn rect(&mut self, frame: &Rectangle, radius: f64, style: &ShapeStyle<'_>) {
        self.add(format_args!("<rect {}{style}/>", frame.attributes(radius)));
    }

    /// A circle around a point.
    pub fn circle(&mut self, [x, y]: [f64; 2], radius: f64, style: &ShapeStyle<'_>) {
        let [x, y, radius] = [x, y, radius].map(Rounded);
        self.add(format_args!(
            r#"<circle cx="{x}" cy="{y}" r="{radius}"{style}/>"#
        ));
    }

    /// A line of words, held at a place on its base line.
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

    /// Draws by `draw`, moved, turned or scaled by an SVG transform.
    pub fn within(&mut self, transform: &str, draw: impl FnOnce(&mut Self)) {
        self.add(format_args!(r#"<g transform="{transform}">"#));
        draw(self);
        self.add("</g>");
    }

    /// Draws by `draw`; a frame with round corners cuts it off.
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

/// The name of a letter in a file.
fn id(letter: char) -> String {
    format!("letter-{:x}", u32::from(letter))
}

/// A line through some points, and how many those are. A dot is a line of no length with round ends.
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

/// A text as an attribute takes it; control characters it does not take at all.
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
    fn a_letter_is_drawn_once_and_its_words_can_be_read_by_others() {
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
