//! Ends a preparation from outside.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::PrepareError;

/// Ends a preparation from another thread: whoever asked for it does not want it any more.
///
/// It ends between two steps of the way from a source to a plan, two areas, two strokes, or two tries for a shorter way.
#[derive(Clone, Debug, Default)]
pub struct GiveUp(Arc<AtomicBool>);

impl GiveUp {
    /// Ends it, for good.
    pub fn give_up(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    pub(crate) fn is_given_up(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    pub(crate) fn check(&self) -> Result<(), PrepareError> {
        if self.is_given_up() {
            return Err(PrepareError::GivenUp);
        }
        Ok(())
    }
}
