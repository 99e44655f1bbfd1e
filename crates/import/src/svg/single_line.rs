//! Text of an SVG file in letters of single lines, where it names a Hershey font.

use dobot_geometry::{Affine, Point, Stroke, Vec2};
use dobot_lettering::{CAPITAL, Letter, StrokeFont};
use unicode_normalization::char::is_combining_mark;
use usvg::{
    AlignmentBaseline, BaselineShift, DominantBaseline, Font, FontFamily, Text, TextAnchor,
    TextChunk, TextFlow, TextSpan, WritingMode,
};

use super::warning_count::WarningKind;
use crate::text::composed;

/// The font of single lines that a file names first; none where it names another kind.
pub(super) fn font(font: &Font) -> Option<StrokeFont> {
    match font.families().first()? {
        FontFamily::Named(name) => StrokeFont::of_family(name),
        _ => None,
    }
}

/// A text as it stands in the file.
pub(super) struct SingleLineText<'t> {
    /// Its letters, and the lines below, above and through them.
    pub(super) written: Vec<Written<'t>>,
    /// How many characters the fonts lack.
    pub(super) missing: usize,
    /// What is not read of each part.
    pub(super) unread: Vec<WarningKind>,
}

/// A letter as it stands in the file.
pub(super) struct Written<'t> {
    /// Its lines, in units of the file.
    pub(super) strokes: Vec<Stroke>,
    /// How the text around it looks.
    pub(super) span: &'t TextSpan,
}

/// A text in single lines; none where it is not all in Hershey fonts, or follows a path.
pub(super) fn written(text: &Text, tolerance: f64) -> Option<SingleLineText<'_>> {
    let is_plain = |it: &TextChunk| {
        matches!(it.text_flow(), TextFlow::Linear)
            && it.spans().iter().all(|it| font(it.font()).is_some())
    };
    if text.chunks().is_empty() || !text.chunks().iter().all(is_plain) {
        return None;
    }
    let (mut written, mut missing) = (Vec::new(), 0);
    let (mut pen, mut number) = (Point::default(), 0);
    for chunk in text.chunks() {
        pen.x = chunk.x().map_or(pen.x, f64::from);
        pen.y = chunk.y().map_or(pen.y, f64::from);
        let width: f64 = chunk.spans().iter().map(|it| width(chunk, it)).sum();
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
        unread: spans.flat_map(|it| unread(text, it)).collect(),
    })
}

/// How far letters stand above the line that the text is on.
fn raised(span: &TextSpan) -> f64 {
    let em = f64::from(span.font_size().get());
    let shifts = span.baseline_shift().iter().map(|it| match *it {
        BaselineShift::Baseline => 0.0,
        BaselineShift::Subscript => -SUBSCRIPT_EM * em,
        BaselineShift::Superscript => SUPERSCRIPT_EM * em,
        BaselineShift::Number(by) => f64::from(by),
    });
    shifts.sum()
}

/// The lines below, above and through letters between two places.
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

/// What letters do not have here of what the file tells.
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
    found.into_iter().filter(|it| it.1).map(|it| it.0)
}

/// The characters to write, and for how many of the file's each stands: a letter and its marks become
/// one where the font has that.
fn spelled(chunk: &TextChunk, span: &TextSpan, font: StrokeFont) -> Vec<(char, usize)> {
    let mut rest = chunk
        .text()
        .get(span.start()..span.end())
        .unwrap_or_default();
    let mut spelled = Vec::new();
    while !rest.is_empty() {
        let mut following = rest.char_indices().skip(1);
        let end = following.find(|it| !is_combining_mark(it.1));
        let (parts, behind) = rest.split_at(end.map_or(rest.len(), |it| it.0));
        // All that is moved in the file moves the first.
        let mut number = parts.chars().count();
        for character in composed(parts, font).chars() {
            spelled.push((character, std::mem::take(&mut number)));
        }
        rest = behind;
    }
    spelled
}

fn width(chunk: &TextChunk, span: &TextSpan) -> f64 {
    let Some(font) = font(span.font()) else {
        return 0.0;
    };
    let spelled = spelled(chunk, span, font).into_iter();
    spelled.map(|it| advance(span, font, it.0)).sum()
}

/// From a letter to the next.
fn advance(span: &TextSpan, font: StrokeFont, character: char) -> f64 {
    let own = Letter::of(font, character).map_or(0.0, |it| it.advance * unit(span));
    let word = if character == ' ' {
        span.word_spacing()
    } else {
        0.0
    };
    own + f64::from(span.letter_spacing() + word)
}

/// What a unit of the letters' grid is in the file.
fn unit(span: &TextSpan) -> f64 {
    f64::from(span.font_size().get()) * CAPITAL_OF_EM / CAPITAL
}

/// By how much of the size of their font lower letters stand below the line.
const SUBSCRIPT_EM: f64 = 0.2;
/// And higher ones above it.
const SUPERSCRIPT_EM: f64 = 0.4;
const UNDERLINE_EM: f64 = 0.15;
const OVERLINE_EM: f64 = CAPITAL_OF_EM + 0.15;
/// How tall capitals are, as a share of the size of a font.
const CAPITAL_OF_EM: f64 = 0.7;
