//! SVG text in single-line letters, for Hershey fonts.

use dobot_geometry::{Affine, Point, Stroke, Vec2};
use dobot_lettering::{CAPITAL, Letter, StrokeFont};
use unicode_normalization::char::is_combining_mark;
use usvg::{
    AlignmentBaseline, BaselineShift, DominantBaseline, Font, FontFamily, Text, TextAnchor,
    TextChunk, TextFlow, TextSpan, WritingMode,
};

use super::warning_count::WarningKind;
use crate::text::composed;

/// The single-line font that a file names first; `None` if it names another kind.
pub(super) fn font(font: &Font) -> Option<StrokeFont> {
    match font.families().first()? {
        FontFamily::Named(name) => StrokeFont::of_family(name),
        _ => None,
    }
}

/// A text with its positions in the file.
pub(super) struct SingleLineText<'t> {
    /// Its letters, and the underlines, overlines and strikethroughs.
    pub(super) written: Vec<Written<'t>>,
    /// The number of characters missing in the fonts.
    pub(super) missing: usize,
    /// The unsupported properties of each part.
    pub(super) unread: Vec<WarningKind>,
}

/// A letter with its position in the file.
pub(super) struct Written<'t> {
    /// Its lines, in units of the file.
    pub(super) strokes: Vec<Stroke>,
    /// The style of the text around it.
    pub(super) span: &'t TextSpan,
}

/// A text in single lines; `None` if it is not all in Hershey fonts, or follows a path.
pub(super) fn written(text: &Text, tolerance: f64) -> Option<SingleLineText<'_>> {
    let is_plain = |chunk: &TextChunk| {
        matches!(chunk.text_flow(), TextFlow::Linear)
            && chunk.spans().iter().all(|span| font(span.font()).is_some())
    };
    if text.chunks().is_empty() || !text.chunks().iter().all(is_plain) {
        return None;
    }
    let (mut written, mut missing) = (Vec::new(), 0);
    let (mut pen, mut number) = (Point::default(), 0);
    for chunk in text.chunks() {
        pen.x = chunk.x().map_or(pen.x, f64::from);
        pen.y = chunk.y().map_or(pen.y, f64::from);
        let width: f64 = chunk.spans().iter().map(|span| width(chunk, span)).sum();
        pen.x -= width
            * match chunk.anchor() {
                TextAnchor::Start => 0.0,
                TextAnchor::Middle => 0.5,
                TextAnchor::End => 1.0,
            };
        for span in chunk.spans() {
            let unit = unit(span);
            let Some(font) = font(span.font()) else {
                continue;
            };
            let mut begin = pen;
            for (character, parts) in spelled(chunk, span, font) {
                let moved = |list: &[f32]| {
                    let moves = list.iter().skip(number).take(parts);
                    moves.copied().map(f64::from).sum::<f64>()
                };
                let way = Vec2::new(moved(text.dx()), moved(text.dy()));
                if way != Vec2::ZERO {
                    written.push(Written {
                        strokes: decoration(span, begin, pen),
                        span,
                    });
                    pen += way;
                    begin = pen;
                }
                let turn_deg = text.rotate().get(number).copied().unwrap_or(0.0);
                number += parts;
                let Some(letter) = Letter::of(font, character) else {
                    missing += 1;
                    continue;
                };
                let advance = advance(span, font, character);
                let foot = Affine::translate(pen.to_vec2() - Vec2::new(0.0, raised(span)));
                let turn = Affine::rotate(f64::from(turn_deg).to_radians());
                let place = foot * turn * Affine::scale(unit);
                let letter = letter.rounded(font, tolerance / unit);
                let lines = letter.strokes.iter().map(|points| {
                    let points: Vec<Point> = points.iter().map(|&p| place * p).collect();
                    let closed = points.len() > 2 && points.first() == points.last();
                    Stroke { points, closed }
                });
                written.push(Written {
                    strokes: lines.collect(),
                    span,
                });
                pen.x += advance;
            }
            written.push(Written {
                strokes: decoration(span, begin, pen),
                span,
            });
        }
    }
    let spans = text.chunks().iter().flat_map(TextChunk::spans);
    Some(SingleLineText {
        written,
        missing,
        unread: spans.flat_map(|span| unread(text, span)).collect(),
    })
}

/// The shift of letters above the line of the text.
fn raised(span: &TextSpan) -> f64 {
    let em = f64::from(span.font_size().get());
    let shifts = span
        .baseline_shift()
        .iter()
        .map(|baseline_shift| match *baseline_shift {
            BaselineShift::Baseline => 0.0,
            BaselineShift::Subscript => -SUBSCRIPT_EM * em,
            BaselineShift::Superscript => SUPERSCRIPT_EM * em,
            BaselineShift::Number(by) => f64::from(by),
        });
    shifts.sum()
}

/// The underlines, overlines and strikethroughs between two places.
fn decoration(span: &TextSpan, begin: Point, end: Point) -> Vec<Stroke> {
    if begin == end {
        return Vec::new();
    }
    let em = f64::from(span.font_size().get());
    let lines = span.decoration();
    let line = |is_there: bool, above_em: f64| {
        let up = Vec2::new(0.0, above_em * em);
        is_there.then(|| Stroke::open(vec![begin - up, end - up]))
    };
    [
        line(lines.underline().is_some(), -UNDERLINE_EM),
        line(lines.overline().is_some(), OVERLINE_EM),
        line(lines.line_through().is_some(), 0.5 * CAPITAL_OF_EM),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The properties that single-line letters do not support.
fn unread(text: &Text, span: &TextSpan) -> impl Iterator<Item = WarningKind> {
    use AlignmentBaseline as A;
    use DominantBaseline as D;
    let is_plain = matches!(
        span.dominant_baseline(),
        D::Auto | D::Alphabetic | D::UseScript | D::NoChange | D::ResetSize
    );
    let is_aligned = matches!(
        span.alignment_baseline(),
        A::Auto | A::Baseline | A::Alphabetic
    );
    let goes_right = text.writing_mode() == WritingMode::LeftToRight;
    let found = [
        (WarningKind::LettersLength, span.text_length().is_some()),
        (WarningKind::LettersDirection, !goes_right),
        (WarningKind::LettersBaseline, !is_plain),
        (WarningKind::LettersAlignment, !is_aligned),
    ];
    found.into_iter().filter(|item| item.1).map(|found| found.0)
}

/// The characters to write, and the number of the file's characters for each: a letter and its
/// marks become one if the font has it.
fn spelled(chunk: &TextChunk, span: &TextSpan, font: StrokeFont) -> Vec<(char, usize)> {
    let mut rest = chunk
        .text()
        .get(span.start()..span.end())
        .unwrap_or_default();
    let mut spelled = Vec::new();
    while !rest.is_empty() {
        let mut following = rest.char_indices().skip(1);
        let end = following.find(|following| !is_combining_mark(following.1));
        let (parts, after) = rest.split_at(end.map_or(rest.len(), |end| end.0));
        // The shifts of all characters apply to the first.
        let mut number = parts.chars().count();
        for character in composed(parts, font).chars() {
            spelled.push((character, std::mem::take(&mut number)));
        }
        rest = after;
    }
    spelled
}

fn width(chunk: &TextChunk, span: &TextSpan) -> f64 {
    let Some(font) = font(span.font()) else {
        return 0.0;
    };
    let spelled = spelled(chunk, span, font).into_iter();
    spelled.map(|spelled| advance(span, font, spelled.0)).sum()
}

/// The distance between letters.
fn advance(span: &TextSpan, font: StrokeFont, character: char) -> f64 {
    let own = Letter::of(font, character).map_or(0.0, |letter| letter.advance * unit(span));
    let word = if character == ' ' {
        span.word_spacing()
    } else {
        0.0
    };
    own + f64::from(span.letter_spacing() + word)
}

/// The size of the letter grid in the file.
fn unit(span: &TextSpan) -> f64 {
    f64::from(span.font_size().get()) * CAPITAL_OF_EM / CAPITAL
}

/// The shift of subscripts below the line, relative to the font size.
const SUBSCRIPT_EM: f64 = 0.2;
/// The shift of superscripts above the line.
const SUPERSCRIPT_EM: f64 = 0.4;
const UNDERLINE_EM: f64 = 0.15;
const OVERLINE_EM: f64 = CAPITAL_OF_EM + 0.15;
/// The height of capitals, relative to the font size.
const CAPITAL_OF_EM: f64 = 0.7;
