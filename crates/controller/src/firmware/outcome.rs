//! The outcome of a tick.

use crate::{Hang, Refused};

/// The outcome of a tick of a command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TickOutcome {
    pub(crate) is_over: bool,
    pub(crate) notice: Option<Refused>,
}

/// The outcome of a tick of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Progress {
    GoesOn,
    /// The end was detected; nothing moved in this tick.
    Arrived,
    /// A limit refused the tick.
    CutShort,
}

impl TickOutcome {
    pub(crate) const GOES_ON: Self = Self {
        is_over: false,
        notice: None,
    };
    pub(crate) const OVER: Self = Self {
        is_over: true,
        notice: None,
    };

    /// Finished; `has_moved` is false if a limit refused the tick.
    pub(crate) const fn over(has_moved: bool) -> Self {
        if has_moved {
            Self::OVER
        } else {
            Self::OVER.with(Refused::CutShort)
        }
    }

    pub(crate) const fn over_with(notice: Refused) -> Self {
        Self::OVER.with(notice)
    }

    pub(crate) const fn hangs(hang: Hang) -> Self {
        Self::GOES_ON.with(Refused::Hangs(hang))
    }

    pub(crate) const fn hangs_if(hangs: bool, hang: Hang) -> Self {
        if hangs {
            Self::hangs(hang)
        } else {
            Self::GOES_ON
        }
    }

    pub(crate) const fn with(self, notice: Refused) -> Self {
        Self {
            notice: Some(notice),
            ..self
        }
    }
}

impl Progress {
    /// Moving, or refused by a limit.
    pub(crate) const fn of(has_moved: bool) -> Self {
        if has_moved {
            Self::GoesOn
        } else {
            Self::CutShort
        }
    }
}
