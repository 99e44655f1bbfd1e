//! The ticks of axes: TL, XT, YT.

use dobot_geometry::Vec2;

use super::command::Command;
use super::plotter::Plotter;
use super::transform::UNIT_MM;
use crate::error::SourceError;

/// The length of ticks, in percent of the distance between P1 and P2: of their heights for XT, of
/// their widths for YT.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ticks {
    /// The part upwards or to the right.
    ahead: f64,
    /// The part downwards or to the left.
    back: f64,
}

impl Default for Ticks {
    /// The lengths of TL without numbers.
    fn default() -> Self {
        Self {
            ahead: 0.5,
            back: 0.5,
        }
    }
}

impl Ticks {
    /// TL: the lengths; a missing second one is 0.
    pub(super) fn of(numbers: &[f64]) -> Self {
        match *numbers {
            [] => Self::default(),
            [ahead] => Self { ahead, back: 0.0 },
            [ahead, back, ..] => Self { ahead, back },
        }
    }
}

impl Plotter<'_> {
    /// XT and YT: an upright or a level tick at the pen, which may be up.
    pub(super) fn tick(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        if !self.knows_corners {
            let instead = "drawn as for an A4 sheet (TL without IP)";
            self.warn(command, "sizeless tick", instead);
        }
        let [p1, p2] = self.transform.corners;
        let room = if &command.name == b"XT" {
            Vec2::new(0.0, p2.y - p1.y)
        } else {
            Vec2::new(p2.x - p1.x, 0.0)
        };
        let percent = self.transform.turned(room) * (UNIT_MM / 100.0);
        let at = self.transform.point(self.at);
        let Ticks { ahead, back } = self.ticks;
        let ends = [at - percent * back, at + percent * ahead];
        for end in ends {
            self.sketch.check(command.at, end)?;
        }
        self.outline(command, &ends)
    }
}
