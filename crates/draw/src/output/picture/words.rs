//! The text of a picture: title, legend, statistics, and a row per pass.

use dobot_geometry::Rect;
use dobot_lettering::paper_style::{INK, MUTED};
use dobot_lettering::{Anchor, ShapeStyle, Sheet, TextStyle};

use super::colors::pass_color;
use super::{Colors, Picture, TRAVEL, unit};
use crate::output::estimate::PassFigures;

impl Picture<'_> {
    /// Writes title, legend, statistics and passes around the paper.
    pub(super) fn words(&self, sheet: &mut Sheet, paper: Rect) {
        let unit = unit(paper);
        let (left, above, below) = (paper.x0, paper.y0 - 4.5 * unit, paper.y1);
        let title = TextStyle::new(3.6 * unit, INK);
        sheet.text([left, above], Anchor::Left, &title, self.title);
        self.legend(sheet, [paper.x1, above], unit);
        sheet.figures([left, below], self.figures, unit);
        if self.rows() > 0 {
            let below = below + self.figures_high() * unit;
            self.table(sheet, [left, below], paper.width(), unit);
        }
    }

    /// Returns the height of the text below the paper, in units.
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

    /// Draws the legend, right-aligned at a point.
    fn legend(&self, sheet: &mut Sheet, [mut x, y]: [f64; 2], unit: f64) {
        let kind = TextStyle::new(1.9 * unit, MUTED);
        let mut entries = vec![("travel".to_owned(), TRAVEL)];
        entries.extend(self.colors.legend());
        for (name, look) in entries.iter().rev() {
            sheet.text([x, y], Anchor::Right, &kind, name);
            x -= kind.width(name) + 2.0 * unit;
            let middle = y - 0.95 * unit;
            sheet.line([x - 7.0 * unit, middle], [x, middle], look);
            x -= 12.0 * unit;
        }
    }

    /// Returns the number of rows; a single pass needs none because the totals are above.
    fn rows(&self) -> u32 {
        let passes = u32::try_from(self.passes.len()).unwrap_or(u32::MAX);
        if passes < 2 { 0 } else { passes.min(MAX_ROWS) }
    }

    /// Draws a row for each pass: name, strokes, vectors, ink, travel, time and error.
    fn table(&self, sheet: &mut Sheet, [left, top]: [f64; 2], wide: f64, unit: f64) {
        let (head, body) = (
            TextStyle::new(1.9 * unit, MUTED),
            TextStyle::new(1.9 * unit, INK),
        );
        let mut y = top + ROW_HIGH * unit;
        cells(
            sheet,
            &HEAD.map(str::to_owned),
            [left, y],
            wide,
            unit,
            &head,
        );
        let shown = self.rows() as usize;
        for (i, pass) in self.passes[..shown].iter().enumerate() {
            y += ROW_HIGH * unit;
            cells(sheet, &row(pass), [left, y], wide, unit, &body);
            if self.colors == Colors::Passes {
                let (color, y) = (pass_color(self.plan, i), y - 0.9 * unit);
                let look = ShapeStyle::line(&color, 1.2 * unit);
                sheet.line([left, y], [left + SWATCH * unit, y], &look);
            }
        }
        if shown < self.passes.len() {
            let more = format!("and {} more", self.passes.len() - shown);
            let at = [left + (SWATCH + 3.0) * unit, y + ROW_HIGH * unit];
            sheet.text(at, Anchor::Left, &head, &more);
        }
    }
}

/// Writes cells: names on the left, values in columns on the right.
fn cells(
    sheet: &mut Sheet,
    row: &[String; 7],
    [left, y]: [f64; 2],
    wide: f64,
    unit: f64,
    kind: &TextStyle<'_>,
) {
    let name_x = left + (SWATCH + 3.0) * unit;
    let column = (wide - NAMES_WIDE * unit) / 6.0;
    sheet.text([name_x, y], Anchor::Left, kind, &row[0]);
    for (i, cell) in (1..).zip(&row[1..]) {
        let x = left + NAMES_WIDE * unit + column * f64::from(i);
        sheet.text([x, y], Anchor::Right, kind, cell);
    }
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

/// Shortens a name to its column.
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

/// Formats minutes and seconds.
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
const MAX_ROWS: u32 = 12;
