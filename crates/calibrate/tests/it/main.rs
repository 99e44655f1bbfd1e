//! Tests of the calibration.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod arms;
mod fit;
