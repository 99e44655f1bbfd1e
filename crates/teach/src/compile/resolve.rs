//! The resolution of places to coordinates.

use std::collections::BTreeMap;

use dobot_arm::{Degrees, Joints, Pose, Position, forward};

use super::Scope;
use super::state::State;
use crate::axes::Axes;
use crate::program::{Frame, Grid, Offset};
use crate::{MountedTool, Place, Point, Program, ProgramError, RecordedPlace};

/// A resolved place: taught joint angles, or a pose of the wrist.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spot {
    pub(super) to: SpotKind,
    /// Its frame, whose axes an offset follows.
    axes: Axes,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum SpotKind {
    Joints(Joints),
    /// The pose of the wrist in the base frame.
    Wrist(Pose),
}

impl Spot {
    pub(super) const fn wrist(position: Position, rotation_deg: f64) -> Self {
        let rotation = Degrees(rotation_deg);
        Self {
            to: SpotKind::Wrist(Pose { position, rotation }),
            axes: Axes::BASE,
        }
    }

    pub(super) const fn joints(joints: Joints) -> Self {
        Self {
            to: SpotKind::Joints(joints),
            axes: Axes::BASE,
        }
    }

    /// The pose of the wrist at this place.
    pub(super) fn pose(&self, state: &State) -> Pose {
        match self.to {
            SpotKind::Joints(joints) => forward(&joints, state.tool),
            SpotKind::Wrist(pose) => pose,
        }
    }

    /// The place with an offset along its frame.
    pub(super) fn moved(self, by: Offset, state: &State) -> Self {
        if by == Offset::default() {
            return self;
        }
        let pose = self.pose(state);
        let position = pose.position + self.axes.way([by.x, by.y, by.z]);
        Self {
            to: SpotKind::Wrist(Pose { position, ..pose }),
            ..self
        }
    }
}

impl Program {
    /// Returns a place, that of the tip of the mounted tool, as a point in a frame of the program.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if there is no such frame, or its points lie on one line.
    pub fn point_in(
        &self,
        frame: &str,
        tip: &RecordedPlace,
        tool: Option<&MountedTool>,
    ) -> Result<Point, ProgramError> {
        let mut state = State::new(None);
        if let Some(tool) = tool {
            state.mount(tool);
        }
        let scope = Scope {
            program: self,
            path: None,
            file: None,
            call_line: None,
            cells: BTreeMap::new(),
        };
        let axes = scope.axes(frame, &state).map_err(ProgramError::new)?;
        Ok(tip.point_in(frame, &axes))
    }
}

impl Scope<'_> {
    /// Resolves a place for the mounted tool.
    pub(super) fn spot(&self, place: &Place, state: &State) -> Result<Spot, String> {
        match place {
            Place::At(point) => self.point(point, state),
            Place::Named(name) => {
                match (self.cells.get(name.as_str()), self.program.points.get(name)) {
                    (Some(spot), _) => Ok(*spot),
                    (None, Some(point)) => self.point(point, state),
                    (None, None) => Err(format!("there is no point {name:?}")),
                }
            }
            Place::External(_) => Err(GIVEN_LATER.into()),
        }
    }

    /// Resolves a cell of a grid: columns first, then rows, then layers.
    pub(super) fn cell(&self, grid: &Grid, cell: u64, state: &State) -> Result<Spot, String> {
        let (columns, rows) = (u64::from(grid.columns), u64::from(grid.rows));
        let [column, row, layer] = [cell % columns, cell / columns % rows, cell / columns / rows];
        #[expect(clippy::cast_precision_loss, reason = "1000 at most")]
        let along = |count: u64, pitch: f64| count as f64 * pitch;
        let by = Offset {
            x: along(column, grid.pitch.x),
            y: along(row, grid.pitch.y),
            z: along(layer, grid.pitch.z),
        };
        Ok(self.spot(&grid.at, state)?.moved(by, state))
    }

    pub(super) fn point(&self, point: &Point, state: &State) -> Result<Spot, String> {
        match point {
            Point::Joints([base, rear, fore, servo]) => {
                Ok(Spot::joints(Joints::new(*base, *rear, *fore, *servo)))
            }
            Point::Cartesian {
                position,
                rotation,
                frame,
            } => {
                let axes = match frame {
                    Some(name) => self.axes(name, state)?,
                    None => Axes::BASE,
                };
                let wrist = axes.place(*position) + Position::new(0.0, 0.0, state.length_mm);
                let rotation = axes.rotation_deg() + rotation.unwrap_or(0.0);
                Ok(Spot {
                    axes,
                    ..Spot::wrist(wrist, rotation)
                })
            }
        }
    }

    fn axes(&self, name: &str, state: &State) -> Result<Axes, String> {
        let Some(Frame { origin, x, y }) = self.program.frames.get(name) else {
            return Err(format!("there is no frame {name:?}"));
        };
        let [origin, x, y] = [
            self.tip(origin, state)?,
            self.tip(x, state)?,
            self.tip(y, state)?,
        ];
        Axes::of(origin, x, y).map_err(|reason| format!("frame {name:?}: {reason}"))
    }

    /// The tip position at a point that defines a frame; the point itself must be in the base
    /// frame.
    fn tip(&self, place: &Place, state: &State) -> Result<Position, String> {
        let point = match place {
            Place::At(point) => point,
            Place::Named(name) => {
                let named = self.program.points.get(name);
                named.ok_or_else(|| format!("there is no point {name:?}"))?
            }
            Place::External(_) => return Err(GIVEN_LATER.into()),
        };
        if let Point::Cartesian {
            frame: Some(frame), ..
        } = point
        {
            return Err(format!(
                "a point that defines a frame is itself in frame {frame:?}; it must be in the base frame"
            ));
        }
        let position = self.point(point, state)?.pose(state).position;
        Ok(position - Position::new(0.0, 0.0, state.length_mm))
    }
}

const GIVEN_LATER: &str =
    "a position that is given while the program runs is allowed in go, pick and place only";
