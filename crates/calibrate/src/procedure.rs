//! The touch procedure: the points of the sheet in order.

use dobot_arm::{Joints, Tool};

use crate::{Fit, FitError, SHEET_POINTS, Touch, fit};

/// The touches recorded by a person and their result.
#[derive(Clone, Debug, PartialEq)]
pub struct Procedure {
    tool: Tool,
    touches: Vec<Touch>,
    /// The number of points that the arm cannot reach.
    skipped: usize,
}

impl Procedure {
    /// Creates the procedure for an arm with this tool, without touches.
    #[must_use]
    pub const fn new(tool: Tool) -> Self {
        Self {
            tool,
            touches: Vec::new(),
            skipped: 0,
        }
    }

    /// Returns the number and position of the next point to touch. After the last point the first
    /// follows again, which improves the result.
    #[must_use]
    pub fn next_point(&self) -> (usize, [f64; 2]) {
        let index = (self.touches.len() + self.skipped) % SHEET_POINTS.len();
        (index + 1, SHEET_POINTS[index])
    }

    /// Records that the tool touches the next point, or a block of this height on it, in mm.
    pub fn touch(&mut self, raw: Joints, height_mm: f64) {
        let (_, place_mm) = self.next_point();
        self.touches.push(Touch {
            place_mm,
            height_mm,
            raw,
        });
    }

    /// Skips the next point because the arm cannot reach it.
    pub const fn skip(&mut self) {
        self.skipped += 1;
    }

    /// Removes the last touch and returns whether there was one.
    pub fn undo(&mut self) -> bool {
        self.touches.pop().is_some()
    }

    /// Discards all touches because the base was referenced again, and returns how many there were.
    pub fn restart(&mut self) -> usize {
        self.skipped = 0;
        std::mem::take(&mut self.touches).len()
    }

    /// Returns the touches.
    #[must_use]
    pub fn touches(&self) -> &[Touch] {
        &self.touches
    }

    /// Fits the touches.
    ///
    /// # Errors
    ///
    /// [`FitError`] if the touches do not determine a calibration.
    pub fn outcome(&self) -> Result<Fit, FitError> {
        fit(&self.touches, self.tool)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_touch_advances_to_the_next_point_and_can_be_undone() {
        let mut procedure = Procedure::new(Tool::SuctionCup);
        assert_eq!(procedure.next_point(), (1, SHEET_POINTS[0]));
        procedure.touch(Joints::new(0.0, 45.0, 45.0, 0.0), 30.0);
        assert_eq!(procedure.touches()[0].height_mm, 30.0);
        assert_eq!(procedure.next_point(), (2, SHEET_POINTS[1]));
        procedure.skip();
        assert_eq!(procedure.next_point(), (3, SHEET_POINTS[2]));
        assert!(procedure.undo());
        assert!(!procedure.undo());
        assert_eq!(procedure.outcome(), Err(FitError::TooFew { found: 0 }));
    }
}
