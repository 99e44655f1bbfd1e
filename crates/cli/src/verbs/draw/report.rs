//! The closing report.

use std::time::Duration;

use dobot_draw::{Estimate, PassFigures, Prepared, SheetPlace};
use dobot_geometry::{Stroke, bounds};
use dobot_import::Warning;
use dobot_plan::Pass;
use serde::Serialize;

use super::defaults::DefaultsLine;
use super::{Drawn, MeasuredFrom};
use crate::drawing_options::with_option_names;
use crate::output::{self, clock};

/// The closing report.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    strokes: usize,
    vectors: usize,
    /// Pen down or laser on.
    drawn_mm: f64,
    travelled_mm: f64,
    /// How much larger than its file says it is.
    scale: f64,
    /// The time that the planned motions take, the way to the paper included.
    planned_s: f64,
    /// The time that a virtual arm took; absent where none was asked.
    estimated_s: Option<f64>,
    /// From the first motion to the last one over; absent where nothing moved or the drawing was
    /// stopped.
    time_s: Option<f64>,
    /// How much longer it took than was estimated.
    estimate_error_percent: Option<f64>,
    /// The largest; absent where it was not measured.
    deviation_mm: Option<f64>,
    deviation_at_mm: Option<[f64; 2]>,
    /// What the deviation was measured from: a laser's light is in no status.
    measured_from: &'static str,
    /// What each pass is, where there is more than one.
    passes: Vec<PassFigures>,
    /// What is drawn otherwise than the file says.
    warnings: Vec<WarningLine>,
    /// The ink in the base frame: the least x and y, and the largest.
    ink_mm: [f64; 4],
    /// The corners of the sheet, from the upper left one on; absent where none was told.
    sheet_mm: Option<[[f64; 2]; 4]>,
    /// How near and how far from its axis the arm reaches the paper; absent where it was not asked.
    reach_mm: Option<[f64; 2]>,
    layers: Vec<LayerLine>,
    /// The options that a file of defaults gave; absent where there is no such file.
    defaults: Option<DefaultsLine>,
}

/// A warning.
#[derive(Debug, Serialize)]
struct WarningLine {
    /// The file, where several are drawn.
    file: Option<String>,
    /// Line and column in the file, where that is known.
    place: Option<String>,
    what: String,
    instead: String,
    count: usize,
}

impl WarningLine {
    fn of(it: &Warning) -> Self {
        Self {
            file: it.file.clone(),
            place: it.place.map(|it| it.to_string()),
            what: it.what.clone(),
            instead: with_option_names(&it.instead),
            count: it.count,
        }
    }
}

/// A layer as it is drawn.
#[derive(Debug, Serialize)]
struct LayerLine {
    name: String,
    color: Option<[u8; 3]>,
    strokes: usize,
    /// Of the wanted path, drawn or burned once.
    length_mm: f64,
}

impl LayerLine {
    fn of(it: &Pass) -> Self {
        Self {
            name: it.name.clone(),
            color: it.color,
            strokes: it.strokes.len(),
            length_mm: it.strokes.iter().map(Stroke::length_mm).sum(),
        }
    }
}

fn ink_mm(prepared: &Prepared) -> [f64; 4] {
    let strokes = prepared.passes.iter().flat_map(|it| &it.strokes);
    let ink = bounds(strokes.flat_map(|it| it.points.iter().copied()));
    [ink.x0, ink.y0, ink.x1, ink.y1]
}

impl Report {
    pub(super) fn new(
        prepared: &Prepared,
        sheet: Option<&SheetPlace>,
        estimate: Option<&Estimate>,
        drawn: Option<&Drawn>,
        times: Times,
        defaults: Option<DefaultsLine>,
    ) -> Self {
        let summary = prepared.plan.summary();
        let measured = drawn.filter(|it| it.is_measured());
        let worst = measured.map(Drawn::worst);
        let passes = estimate.map_or_else(Vec::new, |it| it.passes.clone());
        Self {
            strokes: summary.strokes,
            vectors: summary.vectors,
            drawn_mm: summary.drawn_mm,
            travelled_mm: summary.travelled_mm,
            scale: prepared.scale,
            planned_s: times.planned_s.unwrap_or(summary.duration_s),
            estimated_s: times.estimated.map(|it| it.as_secs_f64()),
            time_s: times.took.map(|it| it.as_secs_f64()),
            estimate_error_percent: times.error_percent(),
            deviation_mm: worst.map(|it| it.distance_mm),
            deviation_at_mm: worst.map(|it| [it.at.x, it.at.y]),
            measured_from: match measured {
                Some(drawn) => match drawn.from {
                    MeasuredFrom::TruePosition => "the arm's true position",
                    MeasuredFrom::Statuses => "the statuses",
                    MeasuredFrom::Plan => "the plan",
                },
                None => "nothing",
            },
            warnings: prepared.warnings.iter().map(WarningLine::of).collect(),
            ink_mm: ink_mm(prepared),
            sheet_mm: sheet.map(|it| it.corners().map(|p| [p.x, p.y])),
            reach_mm: prepared.reach_mm,
            layers: prepared.passes.iter().map(LayerLine::of).collect(),
            passes,
            defaults,
        }
    }

    pub(super) fn print(&self, as_json: bool) -> std::io::Result<()> {
        if as_json {
            return output::json(self);
        }
        if (self.scale - 1.0).abs() > 1e-9 {
            let percent = percent(self.scale);
            output::line(&format!("size               {percent} % of the file's"))?;
        }
        output::line(&format!("strokes            {}", self.strokes))?;
        output::line(&format!("vectors            {}", self.vectors))?;
        output::line(&format!("drawn              {:.1} mm", self.drawn_mm))?;
        output::line(&format!(
            "travelled          {:.1} mm without ink",
            self.travelled_mm
        ))?;
        output::line(&self.time())?;
        output::line(&self.deviation())?;
        if self.passes.len() > 1 {
            for pass in &self.passes {
                output::line(&pass_line(pass))?;
            }
        }
        self.defaults.iter().try_for_each(print_defaults)
    }

    fn deviation(&self) -> String {
        let (Some(mm), Some([x, y])) = (self.deviation_mm, self.deviation_at_mm) else {
            return "largest deviation  not measured".to_owned();
        };
        let from = self.measured_from;
        format!("largest deviation  {mm:.3} mm, at x {x:.1} y {y:.1}, measured from {from}")
    }

    fn time(&self) -> String {
        let planned = clock(self.planned_s);
        match (self.time_s, self.estimated_s, self.estimate_error_percent) {
            (Some(took), Some(estimated), Some(error)) => format!(
                "time on the arm    {} ({} estimated, {error:+.1} %)",
                clock(took),
                clock(estimated)
            ),
            (Some(took), _, _) => format!("time on the arm    {} ({planned} planned)", clock(took)),
            (None, Some(estimated), _) => {
                format!("time on the arm    {} estimated", clock(estimated))
            }
            (None, None, _) => format!("time on the arm    {planned} planned"),
        }
    }

    /// What stands below the picture.
    pub(super) fn figures(&self) -> Vec<(String, String)> {
        let time_s = self.time_s.or(self.estimated_s).unwrap_or(self.planned_s);
        let deviation = self.deviation_mm.map(|mm| format!("{mm:.3} mm"));
        [
            ("strokes", self.strokes.to_string()),
            ("vectors", self.vectors.to_string()),
            ("drawn", format!("{:.0} mm", self.drawn_mm)),
            ("travelled", format!("{:.0} mm", self.travelled_mm)),
            ("time", clock(time_s)),
            (
                "deviation",
                deviation.unwrap_or_else(|| "not measured".to_owned()),
            ),
        ]
        .map(|(name, figure)| (name.to_owned(), figure))
        .to_vec()
    }

    pub(super) fn passes(&self) -> &[PassFigures] {
        &self.passes
    }
}

/// How long it was to take, and how long it took.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Times {
    /// By the motion model, in seconds.
    pub(super) planned_s: Option<f64>,
    pub(super) estimated: Option<Duration>,
    pub(super) took: Option<Duration>,
}

impl Times {
    /// How far the estimate was off; nothing where it took less than half of that: then the time of the
    /// arm does not pass as it does for a real one.
    pub(super) fn error_percent(self) -> Option<f64> {
        let estimated_s = self.estimated?.as_secs_f64();
        let took_s = self.took?.as_secs_f64();
        (estimated_s > 0.0 && took_s > 0.5 * estimated_s)
            .then(|| (took_s / estimated_s - 1.0) * 100.0)
    }
}

/// A factor in percent, with at least three digits that count.
fn percent(factor: f64) -> String {
    let percent = factor * 100.0;
    let is_short = |&decimals: &i32| percent * 10_f64.powi(decimals) < 99.95;
    let decimals = (0..9).take_while(is_short).count();
    format!("{percent:.decimals$}")
}

fn print_defaults(defaults: &DefaultsLine) -> std::io::Result<()> {
    let used = match &defaults.used[..] {
        [] => "none".to_owned(),
        used => used.join(", "),
    };
    output::line(&format!("defaults           {used} (of {})", defaults.file))?;
    for unused in &defaults.unused {
        output::line(&format!(
            "  not used         {}: {}",
            unused.option, unused.why
        ))?;
    }
    Ok(())
}

fn pass_line(pass: &PassFigures) -> String {
    let ink = if pass.tool.burns() { "burned" } else { "drawn" };
    format!(
        "  {:<16} {} strokes, {} vectors, {:.0} mm {ink}, {}",
        pass.name,
        pass.strokes,
        pass.vectors,
        pass.ink_mm,
        clock(pass.time_s)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_size_is_told_with_three_digits_that_count() {
        for (factor, told) in [
            (12.0, "1200"),
            (1.234, "123"),
            (0.9999, "100"),
            (1.0 / 3.0, "33.3"),
            (0.000_456, "0.0456"),
        ] {
            assert_eq!(percent(factor), told);
        }
    }
}
