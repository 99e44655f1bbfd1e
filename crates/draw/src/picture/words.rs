//! The words of a picture: title, legend, figures, and a row for each pass.

use std::fmt::Write as _;

use dobot_geometry::{Point, Rect};
use dobot_lettering::{Anchor, lettering, width};

use super::colors::pass_color;
use super::{Colors, INK, MUTED, Picture, TRAVEL, unit};
use crate::estimate::PassFigures;

impl Picture<'_> {
    /// Title, legend, figures and passes around the paper.
    pub(super) fn words(&self, paper: Rect) -> String {
        let unit = unit(paper);
        let (left, above, below) = (paper.x0, paper.y0 - 4.5 * unit, paper.y1);
        let title = lettering(self.title, Anchor::Left, left, above, 3.6 * unit);
        let title = format!(r#"<g stroke="{INK}" stroke-width="0.85">{title}</g>"#);
        let legend = self.legend(Point::new(paper.x1, above), unit);
        let figures = self.figures(Point::new(left, below), unit);
        let top = below + self.figures_high() * unit;
        let table = Rect::new(left, top, paper.x1, paper.y1);
        title + &legend + &figures + &self.table(table, unit)
    }

    /// How much room the words below the paper take, in units.
    pub(super) fn words_high(&self) -> f64 {
        let rows = self.rows();
        let table = if rows == 0 {
            0.0
        } else {
            ROW_HIGH * (f64::from(rows) + 2.0)
        };
        self.figures_high() + table + 4.0
    }

    const fn figures_high(&self) -> f64 {
        if self.figures.is_empty() {
            2.0
        } else {
            FIGURES_HIGH
        }
    }

    fn figures(&self, at: Point, unit: f64) -> String {
        let mut words = String::new();
        let mut x = at.x;
        for (name, figure) in self.figures {
            let name_at = lettering(name, Anchor::Left, x, at.y + 6.0 * unit, 1.7 * unit);
            let figure_at = lettering(figure, Anchor::Left, x, at.y + 11.2 * unit, 2.9 * unit);
            let _ = writeln!(
                words,
                r#"<g stroke="{MUTED}" stroke-width="0.75">{name_at}<g stroke="{INK}">{figure_at}</g></g>"#
            );
            x += width(name, 1.7 * unit).max(width(figure, 2.9 * unit)) + 8.0 * unit;
        }
        words
    }

    /// What the lines mean, right-aligned at a place.
    fn legend(&self, at: Point, unit: f64) -> String {
        let mut entries = vec![("travel".to_owned(), TRAVEL.to_owned())];
        entries.extend(self.colors.legend(self.plan));
        let mut legend = String::new();
        let mut x = at.x;
        for (name, style) in entries.iter().rev() {
            x -= width(name, 1.9 * unit);
            let name = lettering(name, Anchor::Left, x, at.y, 1.9 * unit);
            x -= 9.0 * unit;
            let (y, long) = (at.y - 0.95 * unit, 7.0 * unit);
            let _ = writeln!(
                legend,
                r#"<g stroke="{MUTED}" stroke-width="0.75">{name}</g><path {style} d="M{x:.2} {y:.2}h{long:.2}"/>"#
            );
            x -= 5.0 * unit;
        }
        legend
    }

    /// One pass has its figures above already.
    fn rows(&self) -> u32 {
        let passes = u32::try_from(self.passes.len()).unwrap_or(u32::MAX);
        if passes < 2 { 0 } else { passes.min(MOST_ROWS) }
    }

    /// A row for each pass: name, strokes, vectors, ink, travel, time and error.
    fn table(&self, place: Rect, unit: f64) -> String {
        if self.rows() == 0 {
            return String::new();
        }
        let mut rows = vec![HEAD.map(str::to_owned)];
        let shown = self.rows() as usize;
        rows.extend(self.passes[..shown].iter().map(row));
        let mut table = String::new();
        let mut y = place.y0 + ROW_HIGH * unit;
        for (i, row) in rows.iter().enumerate() {
            let color = if i == 0 { MUTED } else { INK };
            let _ = writeln!(
                table,
                r#"<g stroke="{color}" stroke-width="0.75">{}</g>"#,
                cells(row, Point::new(place.x0, y), place.width(), unit)
            );
            if i > 0 && self.colors == Colors::Passes {
                let color = pass_color(self.plan, i - 1);
                let (x, y, long) = (place.x0, y - 0.9 * unit, SWATCH * unit);
                let _ = writeln!(
                    table,
                    r#"<path stroke="{color}" stroke-width="{:.2}" d="M{x:.2} {y:.2}h{long:.2}"/>"#,
                    1.2 * unit
                );
            }
            y += ROW_HIGH * unit;
        }
        if shown < self.passes.len() {
            let more = format!("and {} more", self.passes.len() - shown);
            let x = place.x0 + (SWATCH + 3.0) * unit;
            let more = lettering(&more, Anchor::Left, x, y, 1.7 * unit);
            let _ = writeln!(
                table,
                r#"<g stroke="{MUTED}" stroke-width="0.75">{more}</g>"#
            );
        }
        table
    }
}

/// Names to the left, figures in columns to the right.
fn cells(row: &[String; 7], at: Point, wide: f64, unit: f64) -> String {
    let name_x = at.x + (SWATCH + 3.0) * unit;
    let column = (wide - NAMES_WIDE * unit) / 6.0;
    let mut cells = lettering(&row[0], Anchor::Left, name_x, at.y, 1.9 * unit);
    for (i, cell) in (1..).zip(&row[1..]) {
        let x = at.x + NAMES_WIDE * unit + column * f64::from(i);
        cells += &lettering(cell, Anchor::Right, x, at.y, 1.9 * unit);
    }
    cells
}

fn row(pass: &PassFigures) -> [String; 7] {
    [
        shortened(&pass.name),
        pass.strokes.to_string(),
        pass.vectors.to_string(),
        format!("{:.0} mm", pass.ink_mm),
        format!("{:.0} mm", pass.travel_mm),
        clock(pass.time_s),
        format!("{:.3} mm", pass.error_mm),
    ]
}

/// A name that fits into its column.
fn shortened(name: &str) -> String {
    if name.is_empty() {
        return "-".to_owned();
    }
    if name.chars().count() <= LONGEST_NAME {
        return name.to_owned();
    }
    let start: String = name.chars().take(LONGEST_NAME - 2).collect();
    start + ".."
}

/// Minutes and seconds.
fn clock(time_s: f64) -> String {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a time of a drawing"
    )]
    let whole = time_s.round() as u64;
    format!("{}:{:02}", whole / 60, whole % 60)
}

const HEAD: [&str; 7] = [
    "pass", "strokes", "vectors", "ink", "travel", "time", "error",
];
const FIGURES_HIGH: f64 = 14.0;
const ROW_HIGH: f64 = 4.2;
const SWATCH: f64 = 5.0;
const NAMES_WIDE: f64 = 62.0;
const LONGEST_NAME: usize = 22;
const MOST_ROWS: u32 = 12;
