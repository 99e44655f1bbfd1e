//! Strict checks of values: what a lenient reader would skip or truncate silently is an error.

use std::str::FromStr;

use svgtypes::{Length, NumberListParser, PathParser, PathSegment, Transform, ViewBox};
use usvg::roxmltree::{Attribute, Document, Node};

use crate::error::SvgError;
use crate::limits::{Budget, MAX_NUMBER, OverBudget};

/// Checks every path, point list, length, transform and viewBox of the document, and returns the
/// number of line segments of each node, by its number in the document.
pub(crate) fn check(doc: &Document<'_>, budget: &mut Budget) -> Result<Vec<u64>, SvgError> {
    // One for each node, indexed by its number.
    let mut segments = vec![0; doc.descendants().count()];
    for node in doc.descendants().filter(Node::is_element) {
        for attribute in node.attributes().filter(|a| a.namespace().is_none()) {
            match check_value(node, attribute.name(), attribute.value(), budget) {
                Ok(0) => {}
                Ok(count) => segments[node.id().get_usize()] = count as u64,
                Err(Refused::Value(problem)) => {
                    return Err(bad_value(doc, node, &attribute, &problem));
                }
                Err(Refused::Over(over)) => return Err(over.into()),
            }
        }
    }
    Ok(segments)
}

/// The reason why a value is invalid.
enum Refused {
    Value(ValueProblem),
    /// It has more segments than a drawing may have.
    Over(OverBudget),
}

impl From<ValueProblem> for Refused {
    fn from(problem: ValueProblem) -> Self {
        Self::Value(problem)
    }
}

impl From<OverBudget> for Refused {
    fn from(over: OverBudget) -> Self {
        Self::Over(over)
    }
}

struct ValueProblem {
    /// The position in the value, in bytes.
    at: usize,
    expected: &'static str,
}

fn check_value(
    node: Node<'_, '_>,
    name: &str,
    value: &str,
    budget: &mut Budget,
) -> Result<usize, Refused> {
    let whole = |ok: bool, expected| {
        let problem = ValueProblem { at: 0, expected };
        ok.then_some(0).ok_or(Refused::Value(problem))
    };
    match name {
        "d" if node.tag_name().name() == "path" => check_path(value, budget),
        "points" => check_points(value, budget),
        "transform" | "gradientTransform" | "patternTransform" => whole(
            Transform::from_str(value).is_ok_and(is_sane) || value.trim() == "none",
            "a transform such as translate(10 20) or rotate(45)",
        ),
        "viewBox" => whole(
            ViewBox::from_str(value).is_ok_and(|v| [v.x, v.y, v.w, v.h].into_iter().all(is_small)),
            "four numbers: x, y, width and height above 0",
        ),
        _ if is_length(node.tag_name().name(), name) => whole(
            value.trim() == "auto" || Length::from_str(value).is_ok_and(|l| is_small(l.number)),
            "a length such as 12, 12mm or 50%",
        ),
        _ => Ok(0),
    }
}

fn check_path(value: &str, budget: &mut Budget) -> Result<usize, Refused> {
    let expected = "path data: commands MLHVCSQTAZ and finite numbers";
    if value.trim() == "none" {
        return Ok(0);
    }
    let mut count = 0;
    for segment in PathParser::from(value) {
        let segment = segment.map_err(|error| ValueProblem {
            at: position(&error, value),
            expected,
        })?;
        if !numbers(segment).into_iter().all(is_small) {
            let expected = "coordinates of at most 1e9";
            return Err(ValueProblem { at: 0, expected }.into());
        }
        // One by one: a path may have millions of them.
        budget.spend(weight(segment))?;
        count += weight(segment);
    }
    Ok(count)
}

/// The number of lines of a segment: a curve becomes several, and takes as much memory before that.
const fn weight(segment: PathSegment) -> usize {
    match segment {
        PathSegment::CurveTo { .. }
        | PathSegment::SmoothCurveTo { .. }
        | PathSegment::Quadratic { .. }
        | PathSegment::SmoothQuadratic { .. } => 4,
        PathSegment::EllipticalArc { .. } => 12,
        _ => 1,
    }
}

fn check_points(value: &str, budget: &mut Budget) -> Result<usize, Refused> {
    let mut count = 0;
    for number in NumberListParser::from(value) {
        let number = number.map_err(|error| ValueProblem {
            at: position(&error, value),
            expected: "a list of finite numbers",
        })?;
        if !is_small(number) {
            let expected = "coordinates of at most 1e9";
            return Err(ValueProblem { at: 0, expected }.into());
        }
        budget.spend(count % 2)?;
        count += 1;
    }
    // The last point may lack its y, which is a warning; it is drawn up to the point before.
    Ok(count / 2)
}

fn numbers(segment: PathSegment) -> [f64; 6] {
    use PathSegment as P;
    match segment {
        P::MoveTo { x, y, .. } | P::LineTo { x, y, .. } | P::SmoothQuadratic { x, y, .. } => {
            [x, y, 0.0, 0.0, 0.0, 0.0]
        }
        P::HorizontalLineTo { x, .. } => [x, 0.0, 0.0, 0.0, 0.0, 0.0],
        P::VerticalLineTo { y, .. } => [0.0, y, 0.0, 0.0, 0.0, 0.0],
        P::CurveTo {
            x1,
            y1,
            x2,
            y2,
            x,
            y,
            ..
        } => [x1, y1, x2, y2, x, y],
        P::SmoothCurveTo { x2, y2, x, y, .. } => [x2, y2, x, y, 0.0, 0.0],
        P::Quadratic { x1, y1, x, y, .. } => [x1, y1, x, y, 0.0, 0.0],
        P::EllipticalArc { rx, ry, x, y, .. } => [rx, ry, x, y, 0.0, 0.0],
        P::ClosePath { .. } => [0.0; 6],
    }
}

fn is_small(number: f64) -> bool {
    number.abs() <= MAX_NUMBER
}

fn is_sane(t: Transform) -> bool {
    [t.a, t.b, t.c, t.d, t.e, t.f].into_iter().all(is_small)
}

/// Whether an attribute of an element is a length.
pub(super) fn is_length(element: &str, name: &str) -> bool {
    let has_lengths = matches!(
        element,
        "rect" | "circle" | "ellipse" | "line" | "svg" | "use" | "symbol" | "image"
    );
    let is_one = matches!(
        name,
        "x" | "y"
            | "width"
            | "height"
            | "cx"
            | "cy"
            | "r"
            | "rx"
            | "ry"
            | "x1"
            | "y1"
            | "x2"
            | "y2"
    );
    has_lengths && is_one
}

/// The position of the parser's error, in bytes of the value. The parser counts characters from 1.
fn position(error: &svgtypes::Error, value: &str) -> usize {
    use svgtypes::Error as E;
    let (E::UnexpectedData(at)
    | E::InvalidNumber(at)
    | E::InvalidChar(_, at)
    | E::InvalidString(_, at)) = error
    else {
        return value.len();
    };
    let character = value.char_indices().nth(at.saturating_sub(1));
    character.map_or(value.len(), |(byte, _)| byte)
}

fn bad_value(
    doc: &Document<'_>,
    node: Node<'_, '_>,
    attribute: &Attribute<'_, '_>,
    problem: &ValueProblem,
) -> SvgError {
    let value = attribute.value();
    let range = attribute.range_value();
    // After replaced entities, the value no longer matches the file.
    let offset = if range.len() == value.len() {
        problem.at
    } else {
        0
    };
    SvgError::BadValue {
        place: doc.text_pos_at(range.start + offset).into(),
        attribute: attribute.name().to_owned(),
        element: node.tag_name().name().to_owned(),
        found: found(value, problem.at),
        expected: problem.expected,
    }
}

/// The text of a value at a position, or at whose end it is incomplete.
fn found(value: &str, at: usize) -> String {
    let (read, rest) = value.split_at(at);
    if !rest.is_empty() || read.is_empty() {
        return format!("holds {:?}", shortened(rest));
    }
    let last: Vec<char> = read.chars().rev().take(FOUND_CHARACTERS).collect();
    let last: String = last.into_iter().rev().collect();
    let cut = if last.len() < read.len() { "…" } else { "" };
    format!("ends after {:?}", format!("{cut}{last}"))
}

fn shortened(text: &str) -> String {
    let mut short: String = text.chars().take(FOUND_CHARACTERS).collect();
    if short.len() < text.len() {
        short.push('…');
    }
    short
}

const FOUND_CHARACTERS: usize = 24;
