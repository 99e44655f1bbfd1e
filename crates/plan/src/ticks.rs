//! The tick planner: a stock arm executes vectors in whole ticks of 20 ms, and suitable speeds are
//! searched for (note N48).

pub(crate) mod stop_each;
pub(crate) mod tick_chain;
pub(crate) mod tick_fit;
pub(crate) mod tick_planner;
pub(crate) mod ticker;

/// The duration of a tick of a stock arm, in s: in single precision, as the arm computes.
pub(crate) const TICK_S: f32 = dobot_arm::TICK.as_secs_f32();
