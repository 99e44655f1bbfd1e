//! The news of a fault: it began, it hit, it is over.

use std::fmt;
use std::time::Duration;

use super::Fault;

/// A fault that struck a virtual arm, and when.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Struck {
    /// When, since the first power-up.
    pub at: Duration,
    /// The fault.
    pub fault: Fault,
    /// What it did.
    pub what: FaultEffect,
}

/// What a fault did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FaultEffect {
    /// It began, or happened in a moment.
    Began,
    /// It has hit that many bytes or pulses by now; told at 1, 10, 100 and so on.
    Hit(u64),
    /// It is over; it has hit that many bytes or pulses.
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
