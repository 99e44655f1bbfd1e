//! The outcome of a tick.

use crate::{Hang, Refused};

/// What a tick of a command comes to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TickOutcome {
    pub(crate) is_over: bool,
    pub(crate) notice: Option<Refused>,
}

/// What a tick of a way comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Progress {
    GoesOn,
    /// The end was noticed; nothing moved in this tick.
    Arrived,
    /// A limit forbade the tick.
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

    /// Over, whether the tick was gone or a limit forbade it.
    pub(crate) const fn over(was_gone: bool) -> Self {
        if was_gone {
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
    /// Whether the tick was gone or a limit forbade it.
    pub(crate) const fn of(was_gone: bool) -> Self {
        if was_gone {
            Self::GoesOn
        } else {
            Self::CutShort
        }
    }
}
