//! The points and primitives of paths, in both formats.
//!
//! ```text
//!   <V vx="1" vy="2" c0x="3" c0y="4"/>      V1 2c0x3c0y4     a point; c0 pulls the curve that leaves it,
//!                                                            c1 the one that arrives
//!   <P T="B" p0="0" p1="1"/>                B0 1             a curve (B) or a line (L) from one point to another
//! ```

use dobot_geometry::Point;
use usvg::roxmltree::Node;

use super::field::{Field, number};
use crate::error::SourceError;
use crate::limits::Budget;
use crate::number::real;
use crate::place::excerpt;

/// A point of a path, with its control points.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Vertex {
    pub(super) at: Point,
    pub(super) leaving: Point,
    pub(super) arriving: Point,
}

/// The primitives between points of a path.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Joints {
    /// Straight lines through all points.
    InOrder {
        /// Straight lines through all points, closed.
        closed: bool,
    },
    /// A list of lines and curves.
    Listed(Vec<Joint>),
}

/// A line or a curve between two points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Joint {
    pub(super) is_curve: bool,
    /// Point numbers, from 0.
    pub(super) from: usize,
    pub(super) to: usize,
    /// The position in the file, in bytes.
    pub(super) at: usize,
}

/// The points of `<VertList>`.
pub(super) fn vertices(
    file: &str,
    field: Field<'_>,
    budget: &mut Budget,
) -> Result<Vec<Vertex>, SourceError> {
    let mut list = List::new(file, field, VERTICES);
    let mut vertices = Vec::new();
    while list.continues() {
        list.word(&["V"]).ok_or_else(|| list.refused())?;
        budget.spend(SHARE)?;
        let at = Point::new(list.number()?, list.number()?);
        let mut pulls = [None; 4];
        while let Some(which) = list.pull() {
            pulls[which] = Some(list.number()?);
        }
        vertices.push(vertex(at, pulls));
    }
    Ok(vertices)
}

/// The primitives of `<PrimList>`.
pub(super) fn joints(
    file: &str,
    field: Field<'_>,
    budget: &mut Budget,
) -> Result<Joints, SourceError> {
    let closed = match field.text.trim() {
        "LineClosed" => Some(true),
        "LineOpen" | "Line" => Some(false),
        _ => None,
    };
    if let Some(closed) = closed {
        return Ok(Joints::InOrder { closed });
    }
    let mut list = List::new(file, field, JOINTS);
    let mut joints = Vec::new();
    while list.continues() {
        budget.spend(SHARE)?;
        let at = list.at();
        let kind = list.word(&["L", "B"]).ok_or_else(|| list.refused())?;
        joints.push(Joint {
            is_curve: kind == 1,
            from: list.count()?,
            to: list.count()?,
            at,
        });
    }
    Ok(Joints::Listed(joints))
}

/// The points of a path of the older format.
pub(super) fn old_vertices(
    file: &str,
    shape: Node<'_, '_>,
    budget: &mut Budget,
) -> Result<Vec<Vertex>, SourceError> {
    let read = |node: Node<'_, '_>| {
        budget.spend(SHARE)?;
        let at = Point::new(number(file, node, "vx")?, number(file, node, "vy")?);
        let pull = |name| {
            let field = Field::attribute(node, name);
            field.map(|field| field.number(file)).transpose()
        };
        let pulls = [pull("c0x")?, pull("c0y")?, pull("c1x")?, pull("c1y")?];
        Ok(vertex(at, pulls))
    };
    let nodes = shape.children().filter(|child| child.has_tag_name("V"));
    nodes.map(read).collect()
}

/// The primitives of a path of the older format.
pub(super) fn old_joints(
    file: &str,
    shape: Node<'_, '_>,
    budget: &mut Budget,
) -> Result<Joints, SourceError> {
    let read = |node: Node<'_, '_>| {
        budget.spend(SHARE)?;
        let at = node.range().start;
        let refused = |found| SourceError::found(file.as_bytes(), at, found, OLD_JOINT);
        let end = |name| {
            let field = Field::attribute(node, name).ok_or_else(|| refused("<P"))?;
            let count = field.count(file)?;
            usize::try_from(count).map_err(|_| field.refused(file, OLD_JOINT))
        };
        let is_curve = match node.attribute("T") {
            Some("L") => false,
            Some("B") => true,
            _ => return Err(refused("<P with another T")),
        };
        Ok(Joint {
            is_curve,
            from: end("p0")?,
            to: end("p1")?,
            at,
        })
    };
    let nodes = shape.children().filter(|child| child.has_tag_name("P"));
    nodes
        .map(read)
        .collect::<Result<_, _>>()
        .map(Joints::Listed)
}

/// A control point exists only if both of its numbers are given: a single `c0x1` means none.
const fn vertex(at: Point, pulls: [Option<f64>; 4]) -> Vertex {
    const fn pull(at: Point, x: Option<f64>, y: Option<f64>) -> Point {
        match (x, y) {
            (Some(x), Some(y)) => Point::new(x, y),
            _ => at,
        }
    }
    let [x0, y0, x1, y1] = pulls;
    Vertex {
        at,
        leaving: pull(at, x0, y0),
        arriving: pull(at, x1, y1),
    }
}

/// A reader of a list of letters and numbers without separators.
struct List<'d> {
    file: &'d str,
    field: Field<'d>,
    /// The number of bytes read.
    offset: usize,
    expected: &'static str,
}

impl<'d> List<'d> {
    const fn new(file: &'d str, field: Field<'d>, expected: &'static str) -> Self {
        Self {
            file,
            field,
            offset: 0,
            expected,
        }
    }

    fn rest(&self) -> &'d [u8] {
        &self.field.text.as_bytes()[self.offset..]
    }

    fn skip_spaces(&mut self) {
        self.skip(u8::is_ascii_whitespace);
    }

    fn skip(&mut self, is_skipped: impl Fn(&u8) -> bool) {
        self.offset += self
            .rest()
            .iter()
            .take_while(|rest| is_skipped(rest))
            .count();
    }

    fn continues(&mut self) -> bool {
        self.skip_spaces();
        !self.rest().is_empty()
    }

    /// The position in the file, in bytes.
    const fn at(&self) -> usize {
        self.field.at + self.offset
    }

    /// Reads one of these words; returns its index.
    fn word(&mut self, words: &[&str]) -> Option<usize> {
        self.skip_spaces();
        let rest = self.rest();
        let which = words
            .iter()
            .position(|word| rest.starts_with(word.as_bytes()))?;
        self.offset += words[which].len();
        Some(which)
    }

    /// The index of the next control point number, if there is one.
    fn pull(&mut self) -> Option<usize> {
        // A point may be followed by a flag for smooth editing.
        if self.word(&["S"]).is_some() {
            self.skip(u8::is_ascii_digit);
        }
        self.word(&["c0x", "c0y", "c1x", "c1y"])
    }

    fn number(&mut self) -> Result<f64, SourceError> {
        self.skip_spaces();
        let (number, length) = real(self.rest()).ok_or_else(|| self.refused())?;
        self.offset += length;
        Ok(number)
    }

    fn count(&mut self) -> Result<usize, SourceError> {
        self.skip_spaces();
        let start = self.offset;
        let rest = self.rest();
        let length = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
        let count = self.field.text[start..start + length].parse();
        let count = count.map_err(|_| self.refused())?;
        self.offset += length;
        Ok(count)
    }

    /// An error about the text at the position.
    fn refused(&self) -> SourceError {
        let found = excerpt(self.field.text.as_bytes(), self.offset);
        SourceError::found(self.file.as_bytes(), self.at(), found, self.expected)
    }
}

/// The cost of a list point or a primitive, in drawn points.
const SHARE: usize = 2;
const VERTICES: &str = "points such as V1 2 or V1 2c0x3c0y4c1x5c1y6, with numbers of at most 1e9";
const JOINTS: &str = "lines and curves such as L0 1B1 2, LineClosed or LineOpen";
const OLD_JOINT: &str = "a line or curve such as <P T=\"L\" p0=\"0\" p1=\"1\"/>";
