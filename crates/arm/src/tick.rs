//! The clock of the arm's controller.

use core::time::Duration;

/// The control tick, the period at which the controller sets its motors (note N27).
pub const TICK: Duration = Duration::from_millis(20);
/// The same in seconds.
pub const TICK_S: f64 = TICK.as_secs_f64();
