//! The checks of a scene.

mod objects;

use std::ops::RangeInclusive;

use dobot_geometry::Point;
use toml::Spanned;

use super::file::{self, File, line};
use super::{Paper, Scene, SceneError};
use crate::world::{Tool, ToolAction};

pub(super) fn scene(file: &File, text: &str) -> Result<Scene, SceneError> {
    let check = SceneCheck { text };
    Ok(Scene {
        tool: check.tool(file)?,
        table_z_mm: check.table(file)?,
        paper: file.paper.as_ref().map(|it| check.paper(it)).transpose()?,
        objects: check.objects(file)?,
    })
}

/// Checks the scene, and locates errors by the lines of the text.
struct SceneCheck<'a> {
    text: &'a str,
}

impl SceneCheck<'_> {
    fn line<T>(&self, it: &Spanned<T>) -> usize {
        line(self.text, it.span().start)
    }

    fn table(&self, file: &File) -> Result<f64, SceneError> {
        let Some(table) = &file.table else {
            return Ok(TABLE_Z_MM);
        };
        self.number(&table.z_mm, "z_mm of [table]", -400.0..=0.0)
    }

    fn paper(&self, paper: &file::Paper) -> Result<Paper, SceneError> {
        let [x, y] = [(&paper.x_mm, "x_mm"), (&paper.y_mm, "y_mm")].map(|(span, name)| {
            let [from, to] = *span.get_ref();
            let allowed = || {
                format!("two numbers within {NEAR_MM} mm of the base, the smaller one first, are allowed")
            };
            let good = from < to && from >= -NEAR_MM && to <= NEAR_MM;
            let what = format!("{name} of [paper]");
            good.then_some([from, to])
                .ok_or_else(|| self.value(span, what, format!("[{from}, {to}]"), allowed()))
        });
        let ([x, to_x], [y, to_y]) = (x?, y?);
        Ok(Paper {
            from_mm: Point::new(x, y),
            to_mm: Point::new(to_x, to_y),
        })
    }

    fn tool(&self, file: &File) -> Result<Tool, SceneError> {
        let pen = file.pen.as_ref().map(|it| (self.line(it), self.pen(it)));
        let laser = file.laser.as_ref();
        let laser = laser.map(|it| (self.line(it), self.laser(it)));
        let cup = file.suction_cup.as_ref();
        let cup = cup.map(|it| (self.line(it), self.suction_cup(it)));
        let gripper = file.gripper.as_ref();
        let gripper = gripper.map(|it| (self.line(it), self.gripper(it)));
        let tools = [pen, laser, cup, gripper].into_iter().flatten();
        let mut tools: Vec<_> = tools.collect();
        tools.sort_by_key(|(line, _)| *line);
        let (line, found) = match (tools.get(1), tools.len()) {
            (Some((line, _)), _) => (*line, "there is a second tool"),
            (None, 0) => (1, "there is no tool"),
            (None, _) => return tools.swap_remove(0).1,
        };
        let found = found.to_owned();
        Err(SceneError::Tools { line, found })
    }

    fn pen(&self, pen: &Spanned<file::Pen>) -> Result<Tool, SceneError> {
        let file::Pen {
            down_z_mm,
            give_mm,
            width_mm,
        } = pen.get_ref();
        let width_mm = self.optional(width_mm.as_ref(), "width_mm of [pen]", 0.05..=10.0, 0.5)?;
        let action = ToolAction::Pen { width_mm };
        self.mounted("pen", [down_z_mm, give_mm], [-40.0, 2.0], action)
    }

    fn laser(&self, laser: &Spanned<file::Laser>) -> Result<Tool, SceneError> {
        let it = laser.get_ref();
        let optional = |number: &Option<Spanned<f64>>, what, range, default| {
            self.optional(number.as_ref(), what, range, default)
        };
        let action = ToolAction::Laser {
            focus_mm: optional(&it.focus_mm, "focus_mm of [laser]", 1.0..=200.0, 25.0)?,
            depth_mm: optional(&it.depth_mm, "depth_mm of [laser]", 0.1..=50.0, 3.0)?,
            power_w: optional(&it.power_w, "power_w of [laser]", 0.001..=100.0, 0.5)?,
        };
        self.mounted("laser", [&it.down_z_mm, &it.give_mm], [-65.0, 0.5], action)
    }

    fn suction_cup(&self, cup: &Spanned<file::SuctionCup>) -> Result<Tool, SceneError> {
        let it = cup.get_ref();
        let (diameter, lifts) = ("diameter_mm of [suction-cup]", "lifts_g of [suction-cup]");
        let action = ToolAction::SuctionCup {
            diameter_mm: self.optional(it.diameter_mm.as_ref(), diameter, 1.0..=100.0, 20.0)?,
            lifts_g: self.optional(it.lifts_g.as_ref(), lifts, 1.0..=MAX_G, 500.0)?,
        };
        self.mounted(
            "suction-cup",
            [&it.down_z_mm, &it.give_mm],
            [-40.0, 3.0],
            action,
        )
    }

    fn gripper(&self, gripper: &Spanned<file::Gripper>) -> Result<Tool, SceneError> {
        let it = gripper.get_ref();
        let lifts_g = self.optional(
            it.lifts_g.as_ref(),
            "lifts_g of [gripper]",
            1.0..=MAX_G,
            500.0,
        )?;
        let open_mm = self.optional(
            it.open_mm.as_ref(),
            "open_mm of [gripper]",
            1.0..=200.0,
            40.0,
        )?;
        let closed_mm = self.optional(
            it.closed_mm.as_ref(),
            "closed_mm of [gripper]",
            0.0..=open_mm,
            0.0,
        )?;
        let action = ToolAction::Gripper {
            open_mm,
            closed_mm,
            lifts_g,
        };
        self.mounted(
            "gripper",
            [&it.down_z_mm, &it.give_mm],
            [-40.0, 1.0],
            action,
        )
    }

    /// What all tools have: the height of the wrist when the tip is down, and how far it gives.
    fn mounted(
        &self,
        name: &str,
        [down_z, give]: [&Option<Spanned<f64>>; 2],
        [down_z_mm, give_mm]: [f64; 2],
        action: ToolAction,
    ) -> Result<Tool, SceneError> {
        let what = |key: &str| format!("{key} of [{name}]");
        Ok(Tool {
            down_z_mm: self.optional(
                down_z.as_ref(),
                &what("down_z_mm"),
                -300.0..=130.0,
                down_z_mm,
            )?,
            give_mm: self.optional(give.as_ref(), &what("give_mm"), 0.1..=20.0, give_mm)?,
            action,
        })
    }

    fn number(
        &self,
        number: &Spanned<f64>,
        what: &str,
        range: RangeInclusive<f64>,
    ) -> Result<f64, SceneError> {
        self.within(number, *number.get_ref(), what, range)
    }

    fn optional(
        &self,
        number: Option<&Spanned<f64>>,
        what: &str,
        range: RangeInclusive<f64>,
        default: f64,
    ) -> Result<f64, SceneError> {
        number.map_or(Ok(default), |it| self.number(it, what, range))
    }

    fn within<T>(
        &self,
        span: &Spanned<T>,
        found: f64,
        what: &str,
        range: RangeInclusive<f64>,
    ) -> Result<f64, SceneError> {
        if range.contains(&found) {
            return Ok(found);
        }
        let allowed = format!("from {} to {} is allowed", range.start(), range.end());
        Err(self.value(span, what.to_owned(), found.to_string(), allowed))
    }

    fn value<T>(
        &self,
        span: &Spanned<T>,
        what: String,
        found: String,
        allowed: String,
    ) -> SceneError {
        SceneError::Value {
            line: self.line(span),
            what,
            found,
            allowed,
        }
    }
}

/// Where the table of a stock arm is, about (`docs/kinematics.md`).
const TABLE_Z_MM: f64 = -103.0;
/// How far from the base axis things may be.
const NEAR_MM: f64 = 500.0;
const MAX_G: f64 = 10_000.0;
