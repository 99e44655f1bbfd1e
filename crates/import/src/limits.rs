//! The size limits of drawings.

use std::cell::Cell;

use dobot_geometry::{CancelToken, Cancelled};

use crate::error::{SourceError, SvgError};

/// The budget of segments and of edge tests, against drawings that would exhaust memory or time.
#[derive(Debug)]
pub(crate) struct Budget {
    limit: usize,
    left: usize,
    looks_left: usize,
    /// The number of segments from curves, which a larger tolerance reduces.
    curved: Cell<usize>,
    cancel: CancelToken,
}

impl Budget {
    pub(crate) fn new(limit: usize) -> Self {
        Self::until(limit, &CancelToken::default())
    }

    /// Creates a budget that counts as exceeded once this token is cancelled.
    pub(crate) fn until(limit: usize, cancel: &CancelToken) -> Self {
        Self {
            limit,
            left: limit,
            looks_left: MAX_LOOKS,
            curved: Cell::new(0),
            cancel: cancel.clone(),
        }
    }

    pub(crate) fn spend(&mut self, segments: usize) -> Result<(), OverBudget> {
        self.cancel.check()?;
        let left = self.left.checked_sub(segments);
        self.left = left.ok_or_else(|| self.over())?;
        Ok(())
    }

    /// Notes the number of segments of a curve; they are spent separately.
    pub(crate) fn note_curve(&self, segments: usize) {
        self.curved.set(self.curved.get().saturating_add(segments));
    }

    /// Whether any curve was noted.
    pub(crate) const fn has_curves(&self) -> bool {
        self.curved.get() > 0
    }

    fn over(&self) -> OverBudget {
        let limit = self.limit;
        if self.curved.get() > limit / MIN_CURVED {
            OverBudget::Segments { limit }
        } else {
            OverBudget::Corners { limit }
        }
    }

    /// Spends edge tests; `false` if the budget is too small, which then is exhausted.
    pub(crate) fn take_looks(&mut self, looks: usize) -> bool {
        if self.cancel.is_cancelled() {
            self.looks_left = 0;
            return false;
        }
        let is_enough = looks <= self.looks_left;
        self.looks_left = self.looks_left.saturating_sub(looks);
        is_enough
    }

    /// Spends edge tests; an error if the budget is too small.
    pub(crate) fn look(&mut self, looks: usize) -> Result<(), OverBudget> {
        if self.take_looks(looks) {
            return Ok(());
        }
        self.cancel.check()?;
        Err(OverBudget::Looks)
    }

    /// Whether edge tests remain.
    pub(crate) const fn has_looks(&self) -> bool {
        self.looks_left > 0
    }

    /// The number of remaining segments.
    pub(crate) const fn left(&self) -> usize {
        self.left
    }
}

/// The exceeded limit.
#[derive(Debug)]
pub(crate) enum OverBudget {
    /// Segments, many of them from curves.
    Segments { limit: usize },
    /// Segments listed in the file.
    Corners { limit: usize },
    /// Edge tests.
    Looks,
    /// Reading was cancelled.
    Cancelled(Cancelled),
}

impl From<Cancelled> for OverBudget {
    fn from(cancelled: Cancelled) -> Self {
        Self::Cancelled(cancelled)
    }
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
            OverBudget::Cancelled(cancelled) => cancelled.into(),
        }
    }
}

impl From<OverBudget> for SourceError {
    fn from(over: OverBudget) -> Self {
        match over {
            OverBudget::Segments { limit } => Self::TooManySegments { limit },
            OverBudget::Corners { limit } => Self::TooManyCorners { limit },
            OverBudget::Looks => Self::TooManyCuts,
            OverBudget::Cancelled(cancelled) => cancelled.into(),
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

/// The largest unpacked file except for pictures: a million points have about twenty million bytes.
pub(crate) const MAX_BYTES: u64 = 64_000_000;
/// The largest picture: an unpacked scan of a sheet at a high resolution.
pub(crate) const MAX_PICTURE_BYTES: u64 = 256_000_000;
/// The largest number of line segments: the arm takes two days for it. In unit tests this limit and others are lower, to be
/// reached quickly.
pub(crate) const MAX_SEGMENTS: usize = if cfg!(test) { 100_000 } else { 2_000_000 };
/// If fewer than one in this many segments are from curves, a larger tolerance hardly helps.
const MIN_CURVED: usize = 10;
/// The largest number of edge tests for clipping: one or two seconds.
const MAX_LOOKS: usize = if cfg!(test) { 3_000_000 } else { 150_000_000 };
/// The largest coordinate, in mm.
pub(crate) const LIMIT_MM: f64 = 1_000_000.0;
/// Larger numbers are a mistake, and would overflow later.
pub(crate) const MAX_NUMBER: f64 = 1e9;
