//! Fault events: start, hits and end.

use std::fmt;
use std::time::Duration;

use super::Fault;

/// A fault event of a virtual arm.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Struck {
    /// The time since the first power-up.
    pub at: Duration,
    /// The fault.
    pub fault: Fault,
    /// The effect.
    pub what: FaultEffect,
}

/// The effect of a fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FaultEffect {
    /// It began, or acted once.
    Began,
    /// The number of bytes or pulses hit; reported at 1, 10, 100 and so on.
    Hit(u64),
    /// It ended, with this number of bytes or pulses hit.
    Over(u64),
}

impl fmt::Display for Struck {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { at, fault, what } = self;
        let at_s = at.as_secs_f64();
        match what {
            FaultEffect::Began => write!(f, "{at_s:.3} s: fault {fault}"),
            FaultEffect::Hit(1) => write!(f, "{at_s:.3} s: fault {fault} hit for the first time"),
            FaultEffect::Hit(hits) => write!(f, "{at_s:.3} s: fault {fault} has hit {hits} times"),
            FaultEffect::Over(0) => write!(f, "{at_s:.3} s: fault {fault} is over"),
            FaultEffect::Over(hits) => {
                write!(f, "{at_s:.3} s: fault {fault} is over, with {hits} hits")
            }
        }
    }
}
