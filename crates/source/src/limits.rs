//! How large a drawing may be.

use crate::error::{SourceError, SvgError};

/// How many segments may still come: the guard against drawings that would fill the memory.
#[derive(Debug)]
pub(crate) struct Budget {
    limit: usize,
    left: usize,
}

impl Budget {
    pub(crate) const fn new(limit: usize) -> Self {
        Self { limit, left: limit }
    }

    pub(crate) fn spend(&mut self, segments: usize) -> Result<(), OverBudget> {
        let limit = self.limit;
        let left = self.left.checked_sub(segments);
        self.left = left.ok_or(OverBudget { limit })?;
        Ok(())
    }

    /// How many segments may still come.
    pub(crate) const fn left(&self) -> usize {
        self.left
    }
}

/// A drawing has more segments than its budget.
#[derive(Debug)]
pub(crate) struct OverBudget {
    limit: usize,
}

impl From<OverBudget> for SvgError {
    fn from(OverBudget { limit }: OverBudget) -> Self {
        let limit = limit as u64;
        Self::TooManySegments { limit }
    }
}

impl From<OverBudget> for SourceError {
    fn from(OverBudget { limit }: OverBudget) -> Self {
        Self::TooManySegments { limit }
    }
}

pub(crate) fn checked_tolerance_mm(found_mm: f64) -> Result<f64, SvgError> {
    let least_mm = 1e-6;
    if found_mm >= least_mm && found_mm.is_finite() {
        return Ok(found_mm);
    }
    Err(SvgError::Tolerance { found_mm, least_mm })
}

/// No drawing has more line segments: the arm takes two days for it.
pub(crate) const MAX_SEGMENTS: usize = 2_000_000;
/// No drawing leads farther than that, in mm.
pub(crate) const LIMIT_MM: f64 = 1_000_000.0;
/// Larger numbers are a mistake, and would overflow further on.
pub(crate) const MAX_NUMBER: f64 = 1e9;
