//! The tick of a stock arm, as it counts: in single precision.

/// How long it is, in s.
pub(crate) const TICK_S: f32 = dobot_arm::TICK.as_secs_f32();
