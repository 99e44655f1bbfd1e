//! Strokes drawn with one tool.

use std::ops::Range;

use dobot_geometry::Stroke;

use crate::DrawingTool;

/// Strokes drawn with one tool, one after another.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pass {
    /// The name shown to people.
    pub name: String,
    /// Red, green and blue, if the file specifies a colour.
    pub color: Option<[u8; 3]>,
    /// The tool.
    pub tool: DrawingTool,
    /// The strokes in the base frame, in order.
    pub strokes: Vec<Stroke>,
    /// The instruction to a person before the pass, such as changing the pen; the arm waits for
    /// confirmation.
    pub message: Option<String>,
}

impl Pass {
    /// Creates a pass without a name and without a message.
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

    /// Returns the strokes as drawn, including repeated burns of a laser.
    pub fn drawn(&self) -> impl Iterator<Item = &Stroke> {
        let (count, times) = (self.strokes.len(), self.tool.times() as usize);
        let by_stroke = matches!(self.tool, DrawingTool::Laser(laser) if laser.by_stroke);
        (0..count * times)
            .map(move |i| &self.strokes[if by_stroke { i / times } else { i % count }])
    }

    pub(super) fn has_strokes(&self) -> bool {
        self.strokes.iter().any(|stroke| !stroke.points.is_empty())
    }
}

/// A planned pass.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedPass {
    /// The name.
    pub name: String,
    /// Red, green and blue, if the file specifies a colour.
    pub color: Option<[u8; 3]>,
    /// The tool.
    pub tool: DrawingTool,
    /// The range of its vectors in [`Plan::moves`](crate::Plan::moves).
    pub moves: Range<usize>,
}

/// A break in which the arm waits for a person.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Break {
    /// The vector after the break, as an index in [`Plan::moves`](crate::Plan::moves).
    pub before: usize,
    /// The message to the person.
    pub message: String,
}
