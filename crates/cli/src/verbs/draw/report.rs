//! The report of a drawing.

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

/// The report of a drawing.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    strokes: usize,
    vectors: usize,
    /// The length with pen down or laser on.
    drawn_mm: f64,
    travelled_mm: f64,
    /// The scale relative to the file.
    scale: f64,
    /// The planned duration, including the way to the paper.
    planned_s: f64,
    /// The duration on a virtual arm, if simulated.
    estimated_s: Option<f64>,
    /// The actual duration; `None` if nothing moved or the drawing was stopped.
    time_s: Option<f64>,
    /// The excess of the actual duration over the estimate.
    estimate_error_percent: Option<f64>,
    /// The largest deviation, if measured.
    deviation_mm: Option<f64>,
    deviation_at_mm: Option<[f64; 2]>,
    /// The source of the deviation; statuses do not contain the laser.
    measured_from: &'static str,
    /// The passes, if there is more than one.
    passes: Vec<PassFigures>,
    /// Differences from the file.
    warnings: Vec<WarningLine>,
    /// The bounds of the ink in the base frame: minimum x and y, maximum x and y.
    ink_mm: [f64; 4],
    /// The corners of the sheet from the upper left one on, if it is known.
    sheet_mm: Option<[[f64; 2]; 4]>,
    /// The minimum and maximum reach on the paper from the axis of the arm, if known.
    reach_mm: Option<[f64; 2]>,
    layers: Vec<LayerLine>,
    /// The options of a file of defaults, if there is one.
    defaults: Option<DefaultsLine>,
}

/// A warning.
#[derive(Debug, Serialize)]
struct WarningLine {
    /// The file, if several are drawn.
    file: Option<String>,
    /// Line and column in the file, if known.
    place: Option<String>,
    what: String,
    instead: String,
    count: usize,
}

impl WarningLine {
    fn of(warning: &Warning) -> Self {
        Self {
            file: warning.file.clone(),
            place: warning.place.map(|place| place.to_string()),
            what: warning.what.clone(),
            instead: with_option_names(&warning.instead),
            count: warning.count,
        }
    }
}

/// A drawn layer.
#[derive(Debug, Serialize)]
struct LayerLine {
    name: String,
    color: Option<[u8; 3]>,
    strokes: usize,
    /// The length of the wanted path, drawn once.
    length_mm: f64,
}

impl LayerLine {
    fn of(pass: &Pass) -> Self {
        Self {
            name: pass.name.clone(),
            color: pass.color,
            strokes: pass.strokes.len(),
            length_mm: pass.strokes.iter().map(Stroke::length_mm).sum(),
        }
    }
}

fn ink_mm(prepared: &Prepared) -> [f64; 4] {
    let strokes = prepared.passes.iter().flat_map(|pass| &pass.strokes);
    let ink = bounds(strokes.flat_map(|stroke| stroke.points.iter().copied()));
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
        let measured = drawn.filter(|drawn| drawn.is_measured());
        let worst = measured.map(Drawn::worst);
        let passes = estimate.map_or_else(Vec::new, |estimate| estimate.passes.clone());
        Self {
            strokes: summary.strokes,
            vectors: summary.vectors,
            drawn_mm: summary.drawn_mm,
            travelled_mm: summary.travelled_mm,
            scale: prepared.scale,
            planned_s: times.planned_s.unwrap_or(summary.duration_s),
            estimated_s: times.estimated.map(|time| time.as_secs_f64()),
            time_s: times.took.map(|time| time.as_secs_f64()),
            estimate_error_percent: times.error_percent(),
            deviation_mm: worst.map(|worst| worst.distance_mm),
            deviation_at_mm: worst.map(|worst| [worst.at.x, worst.at.y]),
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
            sheet_mm: sheet.map(|sheet| sheet.corners().map(|p| [p.x, p.y])),
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

    /// The figures below the picture.
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

/// The planned, estimated and actual durations.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Times {
    /// The duration by the motion model, in seconds.
    pub(super) planned_s: Option<f64>,
    pub(super) estimated: Option<Duration>,
    pub(super) took: Option<Duration>,
}

impl Times {
    /// The error of the estimate; `None` if the drawing took less than half of it: then the time of the arm is
    /// not real time.
    pub(super) fn error_percent(self) -> Option<f64> {
        let estimated_s = self.estimated?.as_secs_f64();
        let took_s = self.took?.as_secs_f64();
        (estimated_s > 0.0 && took_s > 0.5 * estimated_s)
            .then(|| (took_s / estimated_s - 1.0) * 100.0)
    }
}

/// Formats a factor in percent with at least three significant digits.
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
        "  {:<16} {}, {}, {:.0} mm {ink}, {}",
        pass.name,
        output::count(pass.strokes, "stroke"),
        output::count(pass.vectors, "vector"),
        pass.ink_mm,
        clock(pass.time_s)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_size_is_shown_with_three_significant_digits() {
        for (factor, text) in [
            (12.0, "1200"),
            (1.234, "123"),
            (0.9999, "100"),
            (1.0 / 3.0, "33.3"),
            (0.000_456, "0.0456"),
        ] {
            assert_eq!(percent(factor), text);
        }
    }
}
