//! How the floats of a table are read: one function for each kind of range.

use core::ops::RangeInclusive;

use crate::{Frame, ParseError};

/// A table of the specification, or a note where the tables are silent; it signs its errors.
#[derive(Clone, Copy)]
pub(crate) struct Table(pub(crate) &'static str);

impl Table {
    /// Checks that float 1 holds this state.
    pub(crate) fn state(
        self,
        frame: &Frame,
        state: f32,
        allowed: &'static str,
    ) -> Result<(), ParseError> {
        let found = frame.float(1);
        if found == state {
            return Ok(());
        }
        Err(self.out_of_range(1, "state", found, allowed))
    }

    /// A float that only has to be finite.
    pub(crate) fn finite(
        self,
        frame: &Frame,
        n: usize,
        name: &'static str,
    ) -> Result<f32, ParseError> {
        self.only(frame, n, name, f32::is_finite, "a finite number")
    }

    /// A float above 0.
    pub(crate) fn positive(
        self,
        frame: &Frame,
        n: usize,
        name: &'static str,
    ) -> Result<f32, ParseError> {
        self.only(
            frame,
            n,
            name,
            |found| found > 0.0 && found.is_finite(),
            "a finite number above 0",
        )
    }

    /// A float of 0 or above.
    pub(crate) fn not_negative(
        self,
        frame: &Frame,
        n: usize,
        name: &'static str,
    ) -> Result<f32, ParseError> {
        self.only(
            frame,
            n,
            name,
            |found| found >= 0.0 && found.is_finite(),
            "a finite number of 0 or above",
        )
    }

    /// A percentage above 0 (note N15).
    pub(crate) fn percent(
        self,
        frame: &Frame,
        n: usize,
        name: &'static str,
    ) -> Result<f32, ParseError> {
        self.only(
            frame,
            n,
            name,
            |found| found > 0.0 && found <= 100.0,
            "above 0 to 100 (percent)",
        )
    }

    /// The speed of a jog: a release or a switch needs none (note N13).
    pub(crate) fn jog_speed(self, frame: &Frame, moves: bool) -> Result<f32, ParseError> {
        let (range, allowed) = if moves {
            (1.0..=100.0, "1 to 100 (percent)")
        } else {
            (0.0..=100.0, "0 to 100 (percent)")
        };
        self.within(frame, 8, "StarVel", range, allowed)
    }

    /// The gripper's angle of a target.
    pub(crate) fn gripper(self, frame: &Frame, n: usize) -> Result<f32, ParseError> {
        self.within(
            frame,
            n,
            "GripperValue",
            -90.0..=90.0,
            "-90 to 90 (degrees)",
        )
    }

    /// A pause in seconds (note N10).
    pub(crate) fn pause(
        self,
        frame: &Frame,
        n: usize,
        name: &'static str,
    ) -> Result<f32, ParseError> {
        self.within(frame, n, name, 0.0..=655.0, "0 to 655 (seconds)")
    }

    /// A float within a range.
    pub(crate) fn within(
        self,
        frame: &Frame,
        n: usize,
        name: &'static str,
        range: RangeInclusive<f32>,
        allowed: &'static str,
    ) -> Result<f32, ParseError> {
        self.only(frame, n, name, |found| range.contains(&found), allowed)
    }

    /// A switch: exactly 0 (off) or 1 (on) (note N6).
    pub(crate) fn switch(
        self,
        frame: &Frame,
        n: usize,
        name: &'static str,
    ) -> Result<bool, ParseError> {
        self.code(frame, n, name, &[false, true], "0 (off) or 1 (on)")
    }

    /// A code: exactly the index of one of `choices` (note N6).
    pub(crate) fn code<T: Copy>(
        self,
        frame: &Frame,
        n: usize,
        name: &'static str,
        choices: &[T],
        allowed: &'static str,
    ) -> Result<T, ParseError> {
        let found = frame.float(n);
        whole_number(found)
            .and_then(|index| choices.get(usize::from(index)).copied())
            .ok_or_else(|| self.out_of_range(n, name, found, allowed))
    }

    /// The error that this table signs.
    pub(crate) const fn out_of_range(
        self,
        float: usize,
        name: &'static str,
        found: f32,
        allowed: &'static str,
    ) -> ParseError {
        ParseError::OutOfRange {
            float,
            name,
            found,
            allowed,
            table: self.0,
        }
    }

    fn only(
        self,
        frame: &Frame,
        n: usize,
        name: &'static str,
        good: impl FnOnce(f32) -> bool,
        allowed: &'static str,
    ) -> Result<f32, ParseError> {
        let found = frame.float(n);
        if good(found) {
            return Ok(found);
        }
        Err(self.out_of_range(n, name, found, allowed))
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
