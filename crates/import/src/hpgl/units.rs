//! The units of a plot: IP, IR, SC, RO.

use dobot_geometry::Point;

use super::command::Command;
use super::plotter::Plotter;
use super::transform::{PlotTransform, Scale, ScaleKind};
use crate::error::SourceError;

impl Plotter<'_> {
    pub(super) fn set_corners(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let [p1, p2] = PlotTransform::DEFAULT.corners;
        let corners = match command.numbers.as_slice() {
            [] => [p1, p2],
            &[x, y] => {
                let [old1, old2] = self.transform.corners;
                let p1 = Point::new(x, y);
                [p1, p1 + (old2 - old1)]
            }
            &[x1, y1, x2, y2] if x1 != x2 && y1 != y2 => [Point::new(x1, y1), Point::new(x2, y2)],
            _ => return Err(self.refused(command, "x,y of P1 and of P2, different in both")),
        };
        self.knows_corners = !command.numbers.is_empty();
        // Pattern lengths are fractions of the distance between the corners.
        self.end_dashes()?;
        self.use_transform(PlotTransform {
            corners,
            ..self.transform
        });
        Ok(())
    }

    /// PS: the length and the width of the sheet.
    pub(super) fn set_sheet(&mut self, command: &Command<'_>) {
        if let &[length, width, ..] = command.numbers.as_slice() {
            self.sheet = Some([length, width]);
        }
    }

    /// IR: P1 and P2, in percent of the sheet. P1 alone moves P2 along, and so keeps all sizes.
    pub(super) fn relative_corners(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        if command.numbers.is_empty() {
            return self.set_corners(command);
        }
        let Some([length, width]) = self.sheet else {
            if self.knows_corners && command.numbers.len() == 2 {
                let instead = "left out, because the size of the sheet is unknown (IR without PS)";
                self.warn(command, "shift of the scale", instead);
                return Ok(());
            }
            return Err(self.refused(command, "IP, because the size of the sheet is unknown"));
        };
        if ![2, 4].contains(&command.numbers.len()) {
            return Err(self.refused(command, "x,y of P1, or of P1 and of P2, in percent"));
        }
        let is_turned = self.transform.quarters % 2 == 1;
        let sheet = if is_turned {
            [width, length]
        } else {
            [length, width]
        };
        let shares = command.numbers.iter().zip(sheet.iter().cycle());
        let numbers = shares.map(|(percent, side)| percent / 100.0 * side);
        let knew_corners = self.knows_corners || command.numbers.len() > 2;
        self.set_corners(&Command {
            numbers: numbers.collect(),
            ..*command
        })?;
        self.knows_corners = knew_corners;
        Ok(())
    }

    pub(super) fn set_scale(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let scale = scale(&command.numbers).map_err(|expected| self.refused(command, expected))?;
        if scale.is_some() && !self.knows_corners {
            let instead = "read as that of an A4 sheet (SC without IP)";
            self.warn(command, "cornerless scale", instead);
        }
        self.use_transform(PlotTransform {
            scale,
            ..self.transform
        });
        Ok(())
    }

    pub(super) fn turn(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let quarters = match command.number(0) {
            None | Some(0.0) => 0,
            Some(90.0) => 1,
            Some(180.0) => 2,
            Some(270.0) => 3,
            _ => return Err(self.refused(command, "a rotation of 0, 90, 180 or 270 degrees")),
        };
        if self.has_drawn && quarters != self.transform.quarters {
            let instead = "rotated about the origin instead of the sheet, because the size of the sheet is unknown (RO)";
            self.warn(command, "late rotation", instead);
        }
        self.labels.margin_mm = None;
        self.renew_window()?;
        self.use_transform(PlotTransform {
            quarters,
            ..self.transform
        });
        Ok(())
    }
}

/// The scale of SC; without numbers the scale ends.
fn scale(numbers: &[f64]) -> Result<Option<Scale>, &'static str> {
    let share = |percent: f64| (percent / 100.0).clamp(0.0, 1.0);
    let (ends, kind) = match numbers {
        [] => return Ok(None),
        ends | [ends @ .., 0.0] if ends.len() == 4 => (ends, ScaleKind::Stretched),
        [ends @ .., 2.0] if ends.len() == 4 => (ends, ScaleKind::Factor),
        [ends @ .., 1.0] if ends.len() == 4 => (ends, EVEN),
        [ends @ .., 1.0, left, bottom] if ends.len() == 4 => {
            let (left, bottom) = (share(*left), share(*bottom));
            (ends, ScaleKind::Even { left, bottom })
        }
        _ => return Err("x and y of P1 and P2 as SC x1,x2,y1,y2"),
    };
    let (from, to) = (Point::new(ends[0], ends[2]), Point::new(ends[1], ends[3]));
    let is_flat = match kind {
        ScaleKind::Factor => to.x == 0.0 || to.y == 0.0,
        _ => from.x == to.x || from.y == to.y,
    };
    if is_flat {
        return Err("a scale with a width and a height");
    }
    Ok(Some(Scale { from, to, kind }))
}

const EVEN: ScaleKind = ScaleKind::Even {
    left: 0.5,
    bottom: 0.5,
};
