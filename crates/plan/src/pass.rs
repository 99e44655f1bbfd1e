//! What is drawn with one tool.

use std::ops::Range;

use dobot_geometry::Stroke;

use crate::DrawingTool;

/// Strokes that are drawn with one tool, one after the other.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pass {
    /// What it is called, for people.
    pub name: String,
    /// Red, green and blue, where the file tells a colour.
    pub color: Option<[u8; 3]>,
    /// What draws.
    pub tool: DrawingTool,
    /// The strokes in the base frame, in their order.
    pub strokes: Vec<Stroke>,
    /// What a person has to do before it, such as to change the pen: the arm waits for that.
    pub message: Option<String>,
}

impl Pass {
    /// A pass without a name that nobody has to prepare.
    #[must_use]
    pub const fn new(tool: DrawingTool, strokes: Vec<Stroke>) -> Self {
        Self {
            name: String::new(),
            color: None,
            tool,
            strokes,
            message: None,
        }
    }

    /// The strokes as they are drawn: what a laser burns several times stands there so often.
    pub fn drawn(&self) -> impl Iterator<Item = &Stroke> {
        let (count, times) = (self.strokes.len(), self.tool.times() as usize);
        let goes_on = matches!(self.tool, DrawingTool::Laser(laser) if laser.by_stroke);
        (0..count * times).map(move |i| &self.strokes[if goes_on { i / times } else { i % count }])
    }

    pub(super) fn has_strokes(&self) -> bool {
        self.strokes.iter().any(|stroke| !stroke.points.is_empty())
    }
}

/// A pass of a plan.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedPass {
    /// What it is called.
    pub name: String,
    /// Red, green and blue, where the file tells a colour.
    pub color: Option<[u8; 3]>,
    /// What draws.
    pub tool: DrawingTool,
    /// Its vectors in [`Plan::moves`](crate::Plan::moves).
    pub moves: Range<usize>,
}

/// Where the arm waits for a person.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Break {
    /// The vector before which it waits, as index in [`Plan::moves`](crate::Plan::moves).
    pub before: usize,
    /// What the person is told.
    pub message: String,
}
