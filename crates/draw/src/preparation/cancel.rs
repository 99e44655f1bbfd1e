//! Cancellation of a preparation.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::PrepareError;

/// Cancels a preparation from another thread.
///
/// The preparation checks the token between steps, areas, strokes, and attempts at a shorter path.
#[derive(Clone, Debug, Default)]
pub struct CancelToken(Arc<AtomicBool>);

impl CancelToken {
    /// Cancels the preparation permanently.
    pub fn cancel(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    pub(crate) fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    pub(crate) fn check(&self) -> Result<(), PrepareError> {
        if self.is_cancelled() {
            return Err(PrepareError::Cancelled);
        }
        Ok(())
    }
}
