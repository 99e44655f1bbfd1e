//! Lines and words in pixels, written as SVG.

use std::fmt::Write as _;

/// A sheet in the making: pixels, x to the right, y down.
pub(super) struct Sheet {
    svg: String,
}

/// Where a text is held.
#[derive(Clone, Copy, Debug)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

impl Sheet {
    pub(super) fn new(width: f64, height: f64) -> Self {
        let svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" font-family="Helvetica, Arial, DejaVu Sans, sans-serif" font-size="13" stroke-linecap="round" stroke-linejoin="round">
<rect width="{width}" height="{height}" fill="{PAPER}"/>
"#
        );
        Self { svg }
    }

    pub(super) fn title(&mut self, at: [f64; 2], words: &str) {
        self.words(
            at,
            Anchor::Start,
            INK,
            r#" font-size="21" font-weight="bold""#,
            words,
        );
    }

    pub(super) fn heading(&mut self, at: [f64; 2], words: &str) {
        self.words(at, Anchor::Start, INK, r#" font-weight="bold""#, words);
    }

    pub(super) fn text(&mut self, at: [f64; 2], anchor: Anchor, color: &str, words: &str) {
        self.words(at, anchor, color, "", words);
    }

    pub(super) fn line(&mut self, from: [f64; 2], to: [f64; 2], color: &str, width: f64) {
        self.curve(&[from, to], color, width);
    }

    pub(super) fn curve(&mut self, points: &[[f64; 2]], color: &str, width: f64) {
        let mut d = String::new();
        for (n, [x, y]) in points.iter().enumerate() {
            let _ = write!(d, "{}{x:.1} {y:.1}", if n == 0 { 'M' } else { 'L' });
        }
        let _ = writeln!(
            self.svg,
            r#"<path d="{d}" fill="none" stroke="{color}" stroke-width="{width}"/>"#
        );
    }

    pub(super) fn area(&mut self, from: [f64; 2], to: [f64; 2], color: &str) {
        let ([x, y], [right, bottom]) = (from, to);
        let _ = writeln!(
            self.svg,
            r#"<rect x="{x:.1}" y="{y:.1}" width="{:.1}" height="{:.1}" fill="{color}"/>"#,
            right - x,
            bottom - y
        );
    }

    pub(super) fn dot(&mut self, [x, y]: [f64; 2], fill: &str) {
        let _ = writeln!(
            self.svg,
            r#"<circle cx="{x:.1}" cy="{y:.1}" r="5" fill="{fill}" stroke="{INK}" stroke-width="2"/>"#
        );
    }

    pub(super) fn finish(self) -> String {
        self.svg + "</svg>\n"
    }

    fn words(&mut self, at: [f64; 2], anchor: Anchor, color: &str, style: &str, words: &str) {
        let [x, y] = at;
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let words = escaped(words);
        let _ = writeln!(
            self.svg,
            r#"<text x="{x:.1}" y="{y:.1}" text-anchor="{anchor}" fill="{color}"{style}>{words}</text>"#
        );
    }
}

/// A text as XML takes it; control characters it does not take at all.
fn escaped(words: &str) -> String {
    let mut text = String::new();
    for letter in words.chars() {
        match letter {
            '<' => text.push_str("&lt;"),
            '&' => text.push_str("&amp;"),
            it if it.is_control() => text.push('\u{FFFD}'),
            it => text.push(it),
        }
    }
    text
}

pub(super) const PAPER: &str = "#ffffff";
pub(super) const INK: &str = "#1f2937";
pub(super) const SOFT: &str = "#6b7280";
pub(super) const GRID: &str = "#e5e7eb";
pub(super) const PANEL: &str = "#fafafa";
pub(super) const LASER: &str = "#dc2626";
pub(super) const PUMP: &str = "#0284c7";
/// Where the pose is no number.
pub(super) const LOST: &str = "#fde2e2";
