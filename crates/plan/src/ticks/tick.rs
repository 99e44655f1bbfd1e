//! The tick of a stock arm in single precision, as the arm computes.

/// The duration of a tick, in s.
pub(crate) const TICK_S: f32 = dobot_arm::TICK.as_secs_f32();
