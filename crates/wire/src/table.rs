//! How the floats of a table are read: one function for each kind of range.

use core::ops::RangeInclusive;

use crate::{Frame, ParseError};

/// A table of the specification, or a note where the tables are silent; it signs its errors.
#[derive(Clone, Copy)]
pub(crate) struct Table(pub(crate) &'static str);

/// A float of a frame, with the name that it has in a table.
pub(crate) struct Float {
    table: &'static str,
    number: usize,
    name: &'static str,
    found: f32,
}

impl Table {
    /// Float `number` of a frame, which has this name here.
    pub(crate) const fn float(self, frame: &Frame, number: usize, name: &'static str) -> Float {
        self.value(number, name, frame.float(number))
    }

    /// Something found in float `number`, or made of it.
    pub(crate) const fn value(self, number: usize, name: &'static str, found: f32) -> Float {
        Float {
            table: self.0,
            number,
            name,
            found,
        }
    }

    /// Checks that float 1 holds this state.
    pub(crate) fn state(
        self,
        frame: &Frame,
        state: f32,
        allowed: &'static str,
    ) -> Result<(), ParseError> {
        let float = self.float(frame, 1, "state");
        float.only(|found| found == state, allowed).map(|_| ())
    }
}

impl Float {
    /// One that only has to be finite.
    pub(crate) fn finite(self) -> Result<f32, ParseError> {
        self.only(f32::is_finite, "a finite number")
    }

    /// One above 0.
    pub(crate) fn positive(self) -> Result<f32, ParseError> {
        let good = |found: f32| found > 0.0 && found.is_finite();
        self.only(good, "a finite number above 0")
    }

    /// One of 0 or above.
    pub(crate) fn not_negative(self) -> Result<f32, ParseError> {
        let good = |found: f32| found >= 0.0 && found.is_finite();
        self.only(good, "a finite number of 0 or above")
    }

    /// A percentage above 0 (note N15).
    pub(crate) fn percent(self) -> Result<f32, ParseError> {
        let good = |found| found > 0.0 && found <= 100.0;
        self.only(good, "above 0 to 100 (percent)")
    }

    /// The speed of a jog: a release or a switch needs none (note N13).
    pub(crate) fn jog_speed(self, moves: bool) -> Result<f32, ParseError> {
        if moves {
            self.within(1.0..=100.0, "1 to 100 (percent)")
        } else {
            self.within(0.0..=100.0, "0 to 100 (percent)")
        }
    }

    /// The gripper's angle of a target.
    pub(crate) fn gripper(self) -> Result<f32, ParseError> {
        self.within(-90.0..=90.0, "-90 to 90 (degrees)")
    }

    /// A pause in seconds (note N10).
    pub(crate) fn pause(self) -> Result<f32, ParseError> {
        self.within(0.0..=655.0, "0 to 655 (seconds)")
    }

    /// A switch: exactly 0 (off) or 1 (on) (note N6).
    pub(crate) fn switch(self) -> Result<bool, ParseError> {
        self.code(&[false, true], "0 (off) or 1 (on)")
    }

    /// A code: exactly the index of one of `choices` (note N6).
    pub(crate) fn code<T: Copy>(
        self,
        choices: &[T],
        allowed: &'static str,
    ) -> Result<T, ParseError> {
        whole_number(self.found)
            .and_then(|index| choices.get(usize::from(index)).copied())
            .ok_or_else(|| self.out_of_range(allowed))
    }

    fn within(self, range: RangeInclusive<f32>, allowed: &'static str) -> Result<f32, ParseError> {
        self.only(|found| range.contains(&found), allowed)
    }

    pub(crate) fn only(
        self,
        good: impl FnOnce(f32) -> bool,
        allowed: &'static str,
    ) -> Result<f32, ParseError> {
        if good(self.found) {
            return Ok(self.found);
        }
        Err(self.out_of_range(allowed))
    }

    /// The error that the table signs.
    const fn out_of_range(&self, allowed: &'static str) -> ParseError {
        ParseError::OutOfRange {
            float: self.number,
            name: self.name,
            found: self.found,
            allowed,
            table: self.table,
        }
    }
}

/// The whole number from 0 to 255 that a float holds exactly.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the cast saturates, and the comparison sees it"
)]
#[inline]
pub(crate) fn whole_number(found: f32) -> Option<u8> {
    let whole = found as u8;
    (f32::from(whole) == found).then_some(whole)
}
