//! The joints of the arm.

use dobot_arm::{Degrees, Limits, Span};

/// A joint: its child turns about an axis that stands still in its parent. At 0 degrees the frames of both have the same
/// directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Joint {
    pub(crate) name: &'static str,
    pub(crate) parent: &'static str,
    pub(crate) child: &'static str,
    /// Where it is in the frame of its parent, in mm.
    pub(crate) at_mm: [f64; 3],
    pub(crate) turn: Turn,
}

/// How the child of a joint turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Turn {
    /// A motor turns it.
    Driven {
        axis: Axis,
        span: Span<Degrees>,
        /// The highest speed of a stock arm.
        deg_s: f64,
    },
    /// The linkage turns it, about Y: its angle is `rear` times that of the rear arm and `fore` times that of the forearm.
    Follows { rear: f64, fore: f64 },
    /// It does not turn.
    Fixed,
}

/// About what a joint turns, in the frame of its parent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Axis {
    /// To the left: a positive angle turns forward and down.
    Y,
    /// Up: a positive angle turns counter-clockwise, seen from above.
    Z,
}

impl Turn {
    pub(crate) const fn axis(&self) -> Axis {
        match self {
            Self::Driven { axis, .. } => *axis,
            Self::Follows { .. } | Self::Fixed => Axis::Y,
        }
    }
}

impl Axis {
    pub(crate) const fn vector(self) -> [f64; 3] {
        match self {
            Self::Y => [0.0, 1.0, 0.0],
            Self::Z => [0.0, 0.0, 1.0],
        }
    }
}

/// How far a joint turns that follows so, where the driven ones keep to the limits.
pub(crate) fn span_of_follower(rear: f64, fore: f64, limits: &Limits) -> Span<Degrees> {
    if rear * fore == 0.0 {
        let [a, b] = [&limits.rear, &limits.fore].map(|span| (span.min.0, span.max.0));
        let ends = if rear == 0.0 {
            [fore * b.0, fore * b.1]
        } else {
            [rear * a.0, rear * a.1]
        };
        return Span::degrees(ends[0].min(ends[1]), ends[0].max(ends[1]));
    }
    // It is the opening of the elbow, or that turned round.
    let Span { min, max } = opening(limits);
    if rear > fore {
        Span::degrees(min.0, max.0)
    } else {
        Span::degrees(-max.0, -min.0)
    }
}

/// How far the elbow opens; what has no limit of its own ends with those of both arms.
pub(crate) fn opening(limits: &Limits) -> Span<Degrees> {
    let Limits {
        rear,
        fore,
        opening,
        ..
    } = limits;
    Span::degrees(
        opening.min.0.max(rear.min.0 - fore.max.0),
        opening.max.0.min(rear.max.0 - fore.min.0),
    )
}
