//! How large a drawing may be.

use std::cell::Cell;

use crate::error::{SourceError, SvgError};

/// How many segments may still come, and how often an edge may be looked at: the guard against drawings that would fill
/// the memory or take for ever.
#[derive(Debug)]
pub(crate) struct Budget {
    limit: usize,
    left: usize,
    looks_left: usize,
    /// How many of them curves became, which a larger tolerance makes fewer.
    curved: Cell<usize>,
}

impl Budget {
    pub(crate) const fn new(limit: usize) -> Self {
        Self {
            limit,
            left: limit,
            looks_left: MAX_LOOKS,
            curved: Cell::new(0),
        }
    }

    pub(crate) fn spend(&mut self, segments: usize) -> Result<(), OverBudget> {
        let left = self.left.checked_sub(segments);
        self.left = left.ok_or_else(|| self.over())?;
        Ok(())
    }

    /// Notes how many segments a curve became; they are spent by themselves.
    pub(crate) fn note_curve(&self, segments: usize) {
        self.curved.set(self.curved.get().saturating_add(segments));
    }

    fn over(&self) -> OverBudget {
        let limit = self.limit;
        if self.curved.get() > limit / LEAST_CURVED {
            OverBudget::Segments { limit }
        } else {
            OverBudget::Corners { limit }
        }
    }

    /// Takes looks at edges from those that are left; `false` where they do not reach, and none is left then.
    pub(crate) fn take_looks(&mut self, looks: usize) -> bool {
        let is_enough = looks <= self.looks_left;
        self.looks_left = self.looks_left.saturating_sub(looks);
        is_enough
    }

    /// The same, where what takes more is refused.
    pub(crate) fn look(&mut self, looks: usize) -> Result<(), OverBudget> {
        self.take_looks(looks)
            .then_some(())
            .ok_or(OverBudget::Looks)
    }

    /// Whether edges may still be looked at.
    pub(crate) const fn has_looks(&self) -> bool {
        self.looks_left > 0
    }

    /// How many segments may still come.
    pub(crate) const fn left(&self) -> usize {
        self.left
    }
}

/// What a drawing has more of than its budget.
#[derive(Debug)]
pub(crate) enum OverBudget {
    /// Segments, many of them of curves.
    Segments { limit: usize },
    /// Segments that the file has one by one.
    Corners { limit: usize },
    /// Looks at edges.
    Looks,
}

impl From<OverBudget> for SvgError {
    fn from(over: OverBudget) -> Self {
        match over {
            OverBudget::Segments { limit } => Self::TooManySegments {
                limit: limit as u64,
            },
            OverBudget::Corners { limit } => Self::TooManyCorners {
                limit: limit as u64,
            },
            OverBudget::Looks => Self::TooManyCuts,
        }
    }
}

impl From<OverBudget> for SourceError {
    fn from(over: OverBudget) -> Self {
        match over {
            OverBudget::Segments { limit } => Self::TooManySegments { limit },
            OverBudget::Corners { limit } => Self::TooManyCorners { limit },
            OverBudget::Looks => Self::TooManyCuts,
        }
    }
}

pub(crate) fn checked_tolerance_mm(found_mm: f64) -> Result<f64, SvgError> {
    let least_mm = 1e-6;
    if found_mm >= least_mm && found_mm.is_finite() {
        return Ok(found_mm);
    }
    Err(SvgError::Tolerance { found_mm, least_mm })
}

/// No file but a picture has more bytes, unpacked: a million points have some twenty million.
pub(crate) const MOST_BYTES: u64 = 64_000_000;
/// Nor a picture: a sheet that is scanned as finely as any, and not packed.
pub(crate) const MOST_PICTURE_BYTES: u64 = 256_000_000;
/// No drawing has more line segments: the arm takes two days for it.
pub(crate) const MAX_SEGMENTS: usize = 2_000_000;
/// Where less than one of so many is of a curve, a larger tolerance hardly helps.
const LEAST_CURVED: usize = 10;
/// How many edges may be looked at where lines and areas are cut: a second or two.
const MAX_LOOKS: usize = 150_000_000;
/// No drawing leads farther than that, in mm.
pub(crate) const LIMIT_MM: f64 = 1_000_000.0;
/// Larger numbers are a mistake, and would overflow further on.
pub(crate) const MAX_NUMBER: f64 = 1e9;
