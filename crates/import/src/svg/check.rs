//! Checks of values: what the library would skip or truncate silently is reported.

use std::str::FromStr;

use dobot_geometry::{CancelToken, Cancelled};
use svgtypes::{Length, NumberListParser, PathParser, PathSegment, Transform, ViewBox};
use usvg::roxmltree::{Attribute, Document, Node};

use super::edits::Edit;
use super::expand::circular_references;
use crate::error::SvgError;
use crate::limits::{Budget, MAX_NUMBER};
use crate::place::printable;
use crate::warning::{Warning, WarningKind};

/// Invalid values of attributes: how to rewrite them, and a warning for each kind.
#[derive(Debug, Default)]
pub(super) struct Damage {
    pub(super) edits: Vec<Edit>,
    pub(super) warnings: Vec<Warning>,
    /// The kind of value of each warning.
    kinds: Vec<&'static str>,
}

impl Damage {
    /// Checks every path, point list, length, transform, viewBox and reference of the document. Like
    /// a browser, a shape is drawn up to the error, and other invalid values are ignored (SVG 1.1,
    /// F.2).
    pub(super) fn of(doc: &Document<'_>, cancel: &CancelToken) -> Result<Self, Cancelled> {
        let mut damage = Self::default();
        for node in doc.descendants().filter(Node::is_element) {
            cancel.check()?;
            for attribute in node.attributes().filter(|a| a.namespace().is_none()) {
                // Those of the page have a warning of their own.
                let is_page_size =
                    node == doc.root_element() && matches!(attribute.name(), "width" | "height");
                if is_page_size {
                    continue;
                }
                if let Err(problem) = check_value(node, attribute.name(), attribute.value()) {
                    damage.add(doc, node, &attribute, &problem);
                }
            }
        }
        for (node, attribute) in circular_references(doc) {
            let problem = ValueProblem {
                kind: "circular reference",
                at: 0,
                expected: "an element that does not contain this one",
            };
            damage.add(doc, node, &attribute, &problem);
        }
        Ok(damage)
    }

    fn add(
        &mut self,
        doc: &Document<'_>,
        node: Node<'_, '_>,
        attribute: &Attribute<'_, '_>,
        problem: &ValueProblem,
    ) {
        self.edits.push(match valid_part(node, attribute) {
            Some(words) => Edit {
                range: attribute.range_value(),
                words,
            },
            None => Edit {
                range: attribute.range(),
                words: String::new(),
            },
        });
        if let Some(known) = self.kinds.iter().position(|kind| *kind == problem.kind) {
            self.warnings[known].count += 1;
            return;
        }
        self.kinds.push(problem.kind);
        self.warnings.push(warning(doc, node, attribute, problem));
    }
}

/// The valid start of a path or a list of points; `None` for other values.
fn valid_part(node: Node<'_, '_>, attribute: &Attribute<'_, '_>) -> Option<String> {
    let value = attribute.value();
    match attribute.name() {
        "d" if node.tag_name().name() == "path" => Some(valid_path(value)),
        "points" => {
            let numbers = NumberListParser::from(value).map_while(Result::ok);
            let numbers = numbers.take_while(|number| is_small(*number));
            let numbers: Vec<String> = numbers.map(|number| number.to_string()).collect();
            Some(numbers.join(" "))
        }
        _ => None,
    }
}

/// Path data up to its first error. Arcs stay arcs: one with a far too large radius would become
/// curves without end.
fn valid_path(value: &str) -> String {
    let segments = PathParser::from(value).map_while(Result::ok);
    let valid = segments
        .map(PathCommand::of)
        .take_while(PathCommand::is_small);
    valid.map(|command| command.text()).collect()
}

/// Counts the line segments of all shapes, by the number of their node in the document.
pub(super) fn segments(doc: &Document<'_>, budget: &mut Budget) -> Result<Vec<u64>, SvgError> {
    let mut segments = vec![0; doc.descendants().count()];
    for node in doc.descendants().filter(Node::is_element) {
        let count = &mut segments[node.id().get_usize()];
        if let ("path", Some(path)) = (node.tag_name().name(), node.attribute("d")) {
            // One by one: a path may have millions of them.
            for segment in PathParser::from(path).map_while(Result::ok) {
                budget.spend(weight(segment))?;
                *count += weight(segment) as u64;
            }
        } else if let Some(points) = node.attribute("points") {
            let points = NumberListParser::from(points).map_while(Result::ok).count() / 2;
            budget.spend(points)?;
            *count += points as u64;
        }
    }
    Ok(segments)
}

pub(super) struct ValueProblem {
    /// The kind of value.
    kind: &'static str,
    /// The position in the value, in bytes.
    at: usize,
    pub(super) expected: &'static str,
}

fn check_value(node: Node<'_, '_>, name: &str, value: &str) -> Result<(), ValueProblem> {
    let whole = |is_valid: bool, kind, expected| {
        let problem = ValueProblem {
            kind,
            at: 0,
            expected,
        };
        is_valid.then_some(()).ok_or(problem)
    };
    match name {
        "d" if node.tag_name().name() == "path" => check_path(value),
        "points" => check_points(value),
        "transform" | "gradientTransform" | "patternTransform" => whole(
            Transform::from_str(value).is_ok_and(is_sane) || value.trim() == "none",
            "invalid transform",
            "a transform such as translate(10 20) or rotate(45)",
        ),
        "viewBox" => whole(
            ViewBox::from_str(value).is_ok_and(|v| [v.x, v.y, v.w, v.h].into_iter().all(is_small)),
            "invalid viewBox",
            "four numbers: x, y, width and height above 0",
        ),
        _ if is_length(node.tag_name().name(), name) => whole(
            value.trim() == "auto"
                || Length::from_str(value.trim()).is_ok_and(|l| is_small(l.number)),
            "invalid length",
            "a length such as 12, 12mm or 50%",
        ),
        _ => Ok(()),
    }
}

/// Checks path data. Data with an error must not be read with arcs as curves, which may have no end.
pub(super) fn check_path(value: &str) -> Result<(), ValueProblem> {
    if value.trim() == "none" {
        return Ok(());
    }
    let problem = |at, expected| ValueProblem {
        kind: "invalid path",
        at,
        expected,
    };
    for segment in PathParser::from(value) {
        let expected = "path data: commands MLHVCSQTAZ and finite numbers";
        let segment = segment.map_err(|error| problem(position(&error, value), expected))?;
        if !PathCommand::of(segment).is_small() {
            return Err(problem(0, "coordinates of at most 1e9"));
        }
    }
    Ok(())
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

fn check_points(value: &str) -> Result<(), ValueProblem> {
    let problem = |at, expected| ValueProblem {
        kind: "invalid point list",
        at,
        expected,
    };
    for number in NumberListParser::from(value) {
        let number =
            number.map_err(|error| problem(position(&error, value), "a list of finite numbers"))?;
        if !is_small(number) {
            return Err(problem(0, "coordinates of at most 1e9"));
        }
    }
    Ok(())
}

/// A segment of path data as its letter and numbers.
pub(super) struct PathCommand {
    letter: char,
    numbers: [f64; 7],
    count: usize,
}

impl PathCommand {
    fn of(segment: PathSegment) -> Self {
        use PathSegment as P;
        let flag = |is_set: bool| f64::from(u8::from(is_set));
        match segment {
            P::MoveTo { abs, x, y } => Self::new('M', abs, [x, y]),
            P::LineTo { abs, x, y } => Self::new('L', abs, [x, y]),
            P::HorizontalLineTo { abs, x } => Self::new('H', abs, [x]),
            P::VerticalLineTo { abs, y } => Self::new('V', abs, [y]),
            P::CurveTo {
                abs,
                x1,
                y1,
                x2,
                y2,
                x,
                y,
            } => Self::new('C', abs, [x1, y1, x2, y2, x, y]),
            P::SmoothCurveTo { abs, x2, y2, x, y } => Self::new('S', abs, [x2, y2, x, y]),
            P::Quadratic { abs, x1, y1, x, y } => Self::new('Q', abs, [x1, y1, x, y]),
            P::SmoothQuadratic { abs, x, y } => Self::new('T', abs, [x, y]),
            P::EllipticalArc {
                abs,
                rx,
                ry,
                x_axis_rotation,
                large_arc,
                sweep,
                x,
                y,
            } => {
                let flags = [flag(large_arc), flag(sweep)];
                // Any number of whole turns is allowed.
                let rotation = x_axis_rotation % 360.0;
                let numbers = [rx, ry, rotation, flags[0], flags[1], x, y];
                Self::new('A', abs, numbers)
            }
            P::ClosePath { abs } => Self::new('Z', abs, []),
        }
    }

    pub(super) fn new<const COUNT: usize>(
        letter: char,
        is_absolute: bool,
        values: [f64; COUNT],
    ) -> Self {
        let mut numbers = [0.0; 7];
        numbers[..COUNT].copy_from_slice(&values);
        let letter = if is_absolute {
            letter
        } else {
            letter.to_ascii_lowercase()
        };
        Self {
            letter,
            numbers,
            count: COUNT,
        }
    }

    pub(super) fn is_small(&self) -> bool {
        self.numbers.into_iter().all(is_small)
    }

    pub(super) fn text(&self) -> String {
        let numbers: Vec<String> = self.numbers[..self.count]
            .iter()
            .map(f64::to_string)
            .collect();
        format!("{}{}", self.letter, numbers.join(" "))
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

fn warning(
    doc: &Document<'_>,
    node: Node<'_, '_>,
    attribute: &Attribute<'_, '_>,
    problem: &ValueProblem,
) -> Warning {
    let value = attribute.value();
    let range = attribute.range_value();
    // After replaced entities, the value no longer matches the file.
    let offset = if range.len() == value.len() {
        problem.at
    } else {
        0
    };
    let what = format!(
        "{}: {} of <{}> {}; expected {}",
        problem.kind,
        printable(attribute.name()),
        printable(node.tag_name().name()),
        found(value, problem.at),
        problem.expected
    );
    let instead = if valid_part(node, attribute).is_some() {
        "drawn up to there"
    } else {
        "ignored"
    };
    Warning {
        kind: WarningKind::Mistake,
        place: Some(doc.text_pos_at(range.start + offset).into()),
        ..Warning::new(&what, instead, 1)
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
