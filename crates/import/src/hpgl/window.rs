//! The clip window of a plot: IW.

use dobot_geometry::Point;

use super::command::Command;
use super::plotter::Plotter;
use super::transform::UNIT_MM;
use crate::error::SourceError;
use crate::sketch::SketchMark;

/// A window that clips what is drawn from its start on.
#[derive(Debug)]
pub(super) struct Window {
    /// Opposite corners, in plotter units; RO rotates them.
    corners: [Point; 2],
    since: Option<SketchMark>,
}

impl Plotter<'_> {
    /// IW: opposite corners in the current units. Without them the window is removed.
    pub(super) fn set_window(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let corners = match command.numbers.as_slice() {
            [] => None,
            &[x1, y1, x2, y2] => Some([Point::new(x1, y1), Point::new(x2, y2)]),
            _ => return Err(self.refused(command, "x,y of two opposite corners")),
        };
        self.end_window()?;
        let Some([a, b]) = corners else {
            return Ok(());
        };
        if a.x == b.x || a.y == b.y {
            self.warn(command, "flat window", "nothing is clipped (IW)");
            return Ok(());
        }
        if self.transform.scale.is_some() {
            let instead = "read as one in the units of SC, as in HP-GL/2 (IW)";
            self.warn(command, "window in a scale", instead);
        }
        let corners = [a, b].map(|p| self.transform.plotter_units(p).to_point());
        for p in corners {
            self.sketch
                .check(command.at, (p.to_vec2() * UNIT_MM).to_point())?;
        }
        self.sketch.lift();
        self.window = Some(Window {
            corners,
            since: None,
        });
        Ok(())
    }

    /// Starts drawing: everything from here on is in the window.
    pub(super) fn begin_window(&mut self) {
        if let Some(window) = self.window.as_mut().filter(|window| window.since.is_none()) {
            window.since = Some(self.sketch.mark());
        }
    }

    /// Clips what was drawn up to here: before the window changes, and before a rotation.
    pub(super) fn end_window(&mut self) -> Result<(), SourceError> {
        self.end_dashes()?;
        let Some(Window {
            corners,
            since: Some(since),
        }) = self.window.take()
        else {
            return Ok(());
        };
        let [a, b] = corners;
        let ring = [a, Point::new(b.x, a.y), b, Point::new(a.x, b.y)];
        let on_paper = |p: Point| (self.transform.turned(p.to_vec2()) * UNIT_MM).to_point();
        self.sketch.cut_since(&since, ring.map(on_paper).to_vec())
    }

    /// Clips what was drawn up to here, and continues with the same window.
    pub(super) fn renew_window(&mut self) -> Result<(), SourceError> {
        let corners = self.window.as_ref().map(|window| window.corners);
        self.end_window()?;
        self.window = corners.map(|corners| Window {
            corners,
            since: None,
        });
        Ok(())
    }
}
