//! The procedure: one point of the sheet after the other.

use dobot_arm::{Joints, Tool};

use crate::{Fit, FitError, SHEET_POINTS, Touch, fit};

/// What a person has touched so far, and what it tells.
#[derive(Clone, Debug, PartialEq)]
pub struct Procedure {
    tool: Tool,
    touches: Vec<Touch>,
    /// How many points of the sheet the arm does not get to.
    skipped: usize,
}

impl Procedure {
    /// The procedure for an arm with this tool; nothing is touched yet.
    #[must_use]
    pub const fn new(tool: Tool) -> Self {
        Self {
            tool,
            touches: Vec::new(),
            skipped: 0,
        }
    }

    /// The point to touch next, with its number; after the last one of the sheet the first again,
    /// which makes the result better.
    #[must_use]
    pub fn next_point(&self) -> (usize, [f64; 2]) {
        let index = (self.touches.len() + self.skipped) % SHEET_POINTS.len();
        (index + 1, SHEET_POINTS[index])
    }

    /// Takes that the tool stands on the next point, or on a block on it that is so high, in mm.
    pub fn touch(&mut self, raw: Joints, height_mm: f64) {
        let (_, place_mm) = self.next_point();
        self.touches.push(Touch {
            place_mm,
            height_mm,
            raw,
        });
    }

    /// Leaves the next point out: the arm does not get to it.
    pub const fn skip(&mut self) {
        self.skipped += 1;
    }

    /// Takes the last touch back; tells whether there was one.
    pub fn undo(&mut self) -> bool {
        self.touches.pop().is_some()
    }

    /// Forgets all touches, because the arm counts its base anew; tells how many there were.
    pub fn begin_anew(&mut self) -> usize {
        self.skipped = 0;
        std::mem::take(&mut self.touches).len()
    }

    /// What was touched.
    #[must_use]
    pub fn touches(&self) -> &[Touch] {
        &self.touches
    }

    /// What the touches tell.
    ///
    /// # Errors
    ///
    /// [`FitError`] where they tell nothing that can be used.
    pub fn outcome(&self) -> Result<Fit, FitError> {
        fit(&self.touches, self.tool)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_touch_leads_to_the_next_point_and_can_be_taken_back() {
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
