//! Faults, and how they are written: `drop=1%`, `reset@12s`.

mod fault_state;
mod parse;
mod schedule;
mod struck;
mod when;

use std::fmt;
use std::time::Duration;

pub(crate) use fault_state::FaultState;
pub use parse::FaultError;
use schedule::Counted;
pub(crate) use schedule::{ArmOrder, FaultSchedule, LineDirection};
pub use struck::{FaultEffect, Struck};

use crate::Joint;
use when::{FaultTime, Time};

/// Something that goes wrong with a virtual arm, on demand.
///
/// | text | what happens |
/// |---|---|
/// | `drop=1%`, `drop=3` | one byte of a hundred is lost; the next three are |
/// | `flip=0.1%` | a bit of a byte is turned over |
/// | `duplicate=1%` | a byte comes twice |
/// | `delay=50ms` | bytes come late, by up to so much, which changes now and then; their order stays |
/// | `withhold@10s..12s` | the arm sends no statuses |
/// | `close@12s..14s` | the port is closed, and can be opened again later |
/// | `reset@12s`, `reset@open` | the controller restarts, as a real one does when its port is opened |
/// | `power@12s..15s` | the power is cut; the arm stays where it is and restarts when it is back |
/// | `lose=rear:30@5s`, `lose=fore:1%` | the motor of a joint does not make these pulses |
/// | `backlash=base:0.3` | a joint is slack by so many degrees |
/// | `zero=fore:2` | a joint stands two degrees further than the controller believes |
///
/// `:to` or `:from` behind a number of bytes is one way only: to the arm or from it, as in
/// `drop=1%:from`.
///
/// `@` says when: at a time since the first power-up (`@12s`; units `ms`, `s`, `min`, `h`), when the
/// fifth packet has been received whole (`@packet5`) or the hundredth status sent (`@status100`),
/// and from then on. A window has an end: `@12s..15s`, `@packet5..packet9`, `@status100..+2s`.
///
/// A controller that restarts is deaf for two seconds, believes its base at 0 and reads rear arm
/// and forearm from the tilt sensors; these read wrong by what stands behind `=`, as in
/// `reset=rear:1.5,fore:-0.8@open` or `power=rear:1@12s..15s`.
///
/// ```
/// use dobot_sim::Fault;
///
/// let fault: Fault = "drop=1%:to@12s..15s".parse()?;
/// assert_eq!(fault.to_string(), "drop=1%:to@12s..15s");
/// # Ok::<(), dobot_sim::FaultError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fault {
    kind: FaultKind,
    when: FaultTime,
}

impl Fault {
    /// Whether it puts a joint askew.
    pub(crate) fn is_zero(&self) -> bool {
        matches!(self.kind, FaultKind::Zero { .. })
    }

    /// The same, where times, packets and statuses count from these on.
    pub(crate) fn counted_from(&self, now: Duration, counted: Counted) -> Self {
        let when = &self.when;
        Self {
            kind: self.kind,
            when: when.counted_from(now, counted.packets, counted.statuses),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum FaultKind {
    Bytes {
        damage: Damage,
        amount: Amount,
        way: Directions,
    },
    Delay {
        longest: Duration,
        way: Directions,
    },
    Withhold,
    Close,
    Reset(Tilt),
    Power(Tilt),
    Lose {
        joint: Joint,
        amount: Amount,
    },
    Backlash {
        joint: Joint,
        deg: f64,
    },
    Zero {
        joint: Joint,
        deg: f64,
    },
}

/// What happens to a byte.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Damage {
    Drop,
    Flip,
    Duplicate,
}

/// How many of the bytes or pulses.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Amount {
    /// So many of a hundred, by chance.
    Percent(f64),
    /// The next so many.
    Count(u32),
}

/// Which bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Directions {
    Both,
    To,
    From,
}

/// What the tilt sensors read more than is true, in degrees.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Tilt {
    pub(crate) rear_deg: f64,
    pub(crate) fore_deg: f64,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.kind {
            FaultKind::Bytes {
                damage,
                amount,
                way,
            } => write!(f, "{}={amount}{way}", damage.name()),
            FaultKind::Delay { longest, way } => write!(f, "delay={}{way}", Time(longest)),
            FaultKind::Withhold => f.write_str("withhold"),
            FaultKind::Close => f.write_str("close"),
            FaultKind::Reset(tilt) => write!(f, "reset{tilt}"),
            FaultKind::Power(tilt) => write!(f, "power{tilt}"),
            FaultKind::Lose { joint, amount } => write!(f, "lose={joint}:{amount}"),
            FaultKind::Backlash { joint, deg } => write!(f, "backlash={joint}:{deg}"),
            FaultKind::Zero { joint, deg } => write!(f, "zero={joint}:{deg}"),
        }?;
        self.when.fmt(f)
    }
}

impl Damage {
    const fn name(self) -> &'static str {
        match self {
            Self::Drop => "drop",
            Self::Flip => "flip",
            Self::Duplicate => "duplicate",
        }
    }
}

impl Directions {
    const fn includes(self, direction: LineDirection) -> bool {
        matches!(
            (self, direction),
            (Self::Both, _)
                | (Self::To, LineDirection::ToArm)
                | (Self::From, LineDirection::FromArm)
        )
    }
}

impl fmt::Display for Amount {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Percent(percent) => write!(f, "{percent}%"),
            Self::Count(count) => write!(f, "{count}"),
        }
    }
}

impl fmt::Display for Directions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Both => "",
            Self::To => ":to",
            Self::From => ":from",
        })
    }
}

impl fmt::Display for Tilt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if *self == Self::default() {
            return Ok(());
        }
        write!(f, "=rear:{},fore:{}", self.rear_deg, self.fore_deg)
    }
}
