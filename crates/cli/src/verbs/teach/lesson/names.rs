//! The names in the program: points, tools, grids and frames.

use dobot_teach::{
    Action, Frame, Go, Grid, GridSize, MountedTool, Place, Point, ProgramDocument, ProgramError,
    RecordedPlace, Steps, TaughtGrid,
};
use dobot_wire::MovingMode;

use super::blocks::step_at;
use super::{Edited, Lesson};
use crate::verbs::teach::outline::{RowKind, outline};

/// A grid that a person taught.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct TouchedGrid {
    pub(crate) name: String,
    /// The first cell, the end of its row and the end of its column.
    pub(crate) corners: [RecordedPlace; 3],
    pub(crate) size: GridSize,
}

/// What became of a grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum GridUse {
    /// The steps that use it remain.
    TaughtAgain,
    /// A new step visits its cells.
    Visited,
    /// The `each` around the cursor visits its cells, too.
    Joined,
}

impl Lesson {
    /// The point to which the selected step goes, or the nearest step before it.
    pub(crate) fn last_point(&self) -> Option<String> {
        let program = self.program();
        let rows = outline(&program);
        let mut before = rows.iter().take(self.cursor + 1).rev();
        before.find_map(|row| match row.step?.get_ref() {
            Action::Go(Go {
                to: Place::Named(name),
                ..
            }) => Some(name.clone()).filter(|name| program.points.contains_key(name)),
            _ => None,
        })
    }

    /// Renames a point, also where it is used.
    pub(crate) fn rename_point(&mut self, from: &str, to: &str) -> Result<(), ProgramError> {
        let path = self.selected();
        self.change(|document| {
            document.rename_point(from, to)?;
            Ok(Edited::on(path))
        })
    }

    /// Adds a step that selects a tool. Returns whether the steps after it go to points taught with another length.
    pub(crate) fn add_tool(&mut self, tool: MountedTool) -> Result<bool, ProgramError> {
        let program = self.program();
        let known = program.tools.iter().find(|(_, known)| **known == tool);
        let name = known.map_or_else(
            || free_name(tool.kind.short(), |name| program.tools.contains_key(name)),
            |(name, _)| name.clone(),
        );
        let changes_points = self.length_mm() != tool.length && {
            let rows = outline(&program);
            let mut rest = rows.iter().skip(self.cursor + 1);
            rest.any(|row| {
                row.kind == RowKind::Step
                    && matches!(row.step.map(toml::Spanned::get_ref), Some(Action::Go(_)))
            })
        };
        let is_known = known.is_some();
        let step = Action::Tool(name.clone());
        self.add(vec![step], |document| {
            if is_known {
                return Ok(0);
            }
            document.set_tool(&name, &tool).map(|()| 1)
        })?;
        Ok(changes_points)
    }

    /// Adds a grid and a step that visits its cells. Returns what became of it and the angle of its corner in degrees.
    pub(crate) fn add_grid(
        &mut self,
        touched: &TouchedGrid,
        path: MovingMode,
    ) -> Result<(GridUse, f64), ProgramError> {
        let TouchedGrid {
            name,
            corners,
            size,
        } = touched;
        let tips = corners.map(|corner| self.tip(&corner));
        let taught = TaughtGrid::of(name, &tips, *size)?;
        let set = |document: &mut ProgramDocument| {
            document.set_frame(name, &taught.frame)?;
            document.set_grid(name, &taught.grid)?;
            Ok(2)
        };
        let visit = Action::Go(Go {
            path,
            ..Go::to(name.as_str())
        });
        let program = self.program();
        let used = if program.grids.contains_key(name) {
            let selected = self.selected();
            self.change(|document| {
                let changes = set(document)?;
                Ok(Edited {
                    changes,
                    ..Edited::on(selected)
                })
            })?;
            GridUse::TaughtAgain
        } else if let Some(each) = self.each_around(&taught.grid)? {
            let at = self.next_path();
            let grids = [each.grids, vec![name.clone()]].concat();
            self.change(|document| {
                let changes = set(document)?;
                document.set_each(&each.path, &grids)?;
                document.insert(&at, visit)?;
                Ok(Edited::at(changes + 2, at))
            })?;
            GridUse::Joined
        } else {
            let each = Action::Each(vec![name.clone()], Steps::new(vec![visit]));
            self.add(vec![each], set)?;
            // Select the step inside: what is taught next belongs to each cell.
            self.move_cursor(true);
            GridUse::Visited
        };
        Ok((used, taught.corner_deg))
    }

    /// The `each` around the cursor, whose grids have as many cells as this one.
    fn each_around(&self, grid: &Grid) -> Result<Option<EachBlock>, ProgramError> {
        let program = self.program();
        let at = self.next_path();
        let mut blocks = (1..at.len()).rev().map(|depth| &at[..depth]);
        let each = blocks.find_map(|block| match step_at(&program, block) {
            Some(Action::Each(grids, _)) => Some(EachBlock {
                path: block.to_vec(),
                grids: grids.clone(),
            }),
            _ => None,
        });
        let known = each.as_ref().and_then(|each| each.grids.first());
        let known = known.and_then(|name| program.grids.get_key_value(name));
        match known {
            Some((name, known)) if known.cells() != grid.cells() => {
                Err(ProgramError::new(format!(
                    "the grid has {} cells, and grid {name:?} of the each around it {}; enter a size with as many, or press Esc, and e to end that each",
                    grid.cells(),
                    known.cells()
                )))
            }
            _ => Ok(each),
        }
    }

    /// Sets a frame from its three touched points; the points of the next steps are taught in it. Returns whether its
    /// z axis points up.
    pub(crate) fn set_frame(
        &mut self,
        name: &str,
        points: &[RecordedPlace; 3],
    ) -> Result<bool, ProgramError> {
        let tips = points.map(|point| self.tip(&point));
        let frame = Frame::touched(&tips);
        let selected = self.selected();
        let mut points_up = true;
        self.change(|document| {
            document.set_frame(name, &frame)?;
            // A frame whose points lie on one line is otherwise an error only where it is used.
            let above = tips[0].tip(-ABOVE_MM);
            let above = document.program()?.point_in(name, &above, None)?;
            if let Point::Cartesian { position, .. } = above {
                points_up = position[2] > 0.0;
            }
            Ok(Edited::on(selected))
        })?;
        self.frame = Some(name.to_owned());
        Ok(points_up)
    }

    /// Teaches the next points in a frame; `None` for the base frame.
    pub(crate) fn use_frame(&mut self, name: Option<String>) {
        self.frame = name;
    }

    /// The frame in which points are taught; `None` for the base frame.
    pub(crate) fn frame(&self) -> Option<&str> {
        let frame = self.frame.as_deref()?;
        self.program().frames.contains_key(frame).then_some(frame)
    }

    /// Adds a call of another program.
    pub(crate) fn add_call(&mut self, file: String) -> Result<(), ProgramError> {
        self.add(vec![Action::Call(file)], |_| Ok(0))
    }
}

/// An `each` in the program.
struct EachBlock {
    path: Vec<usize>,
    grids: Vec<String>,
}

/// The name, or the name with the first number that is free.
fn free_name(name: &str, is_taken: impl Fn(&str) -> bool) -> String {
    if !is_taken(name) {
        return name.to_owned();
    }
    let mut numbered = (2_u32..).map(|number| format!("{name}{number}"));
    numbered.find(|name| !is_taken(name)).unwrap_or_default()
}

/// A height above a frame's origin.
const ABOVE_MM: f64 = 10.0;
