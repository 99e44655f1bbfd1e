//! The screen of `dobot calibrate`.

use dobot_api::CalibrationFile;
use dobot_calibrate::{Fit, Trust, Unsure};
use ratatui::Frame;
use ratatui::layout::{Constraint, Layout};
use ratatui::style::Stylize;
use ratatui::text::Line;

use super::toucher::Toucher;
use crate::output::wrapped;
use crate::pendant::{Pendant, answer, draw_top, key_line, move_lines};
use crate::verbs::watch::panels;

/// Draws the screen.
pub(super) fn draw(frame: &mut Frame, toucher: &Toucher) {
    let more = [("b", "on the block"), ("m", "measured")];
    draw_touching(
        frame,
        &toucher.pendant,
        "calibration",
        lines(toucher),
        &more,
    );
}

/// Draws the screen of a procedure with touches: the arm, the result, the keys.
pub(super) fn draw_touching(
    frame: &mut Frame,
    pendant: &Pendant,
    title: &'static str,
    result: Vec<Line<'static>>,
    more_keys: &[(&'static str, &'static str)],
) {
    let rows = [
        Constraint::Length(1),
        Constraint::Length(1),
        Constraint::Length(5),
        Constraint::Min(8),
        Constraint::Length(6),
        Constraint::Length(1),
    ];
    let [top, alarm_row, arm, touches, keys, bottom] = Layout::vertical(rows).areas(frame.area());
    draw_top(frame, pendant, [top, alarm_row, arm]);
    panels::panel(frame, touches, title, result);
    let mut help = move_lines(pendant, ".");
    help.push(key_line(&[TOUCHING_KEYS, more_keys].concat()));
    panels::panel(frame, keys, "keys", help);
    frame.render_widget(answer(pendant), bottom);
}

const TOUCHING_KEYS: &[(&str, &str)] = &[
    ("Enter", "touched"),
    ("n", "skip"),
    ("z", "undo"),
    ("w", "show, save"),
    ("q", "quit"),
];

fn lines(toucher: &Toucher) -> Vec<Line<'static>> {
    let (number, [x_mm, y_mm]) = toucher.procedure.next_point();
    let top = if toucher.on_block {
        format!("the block of {} mm on ", toucher.height_mm())
    } else {
        String::new()
    };
    let next = format!("touch {top}point {number} ({x_mm}, {y_mm}), from the right and from above");
    let mut lines = vec![Line::from(next).bold()];
    match &toucher.outcome {
        Ok(fit) => lines.extend(result(fit, toucher.kept.known.as_ref())),
        Err(why) => {
            let texts = wrapped(&why.to_string(), WIDTH);
            lines.extend(texts.into_iter().map(Line::from));
        }
    }
    lines
}

fn result(fit: &Fit, known: Option<&CalibrationFile>) -> Vec<Line<'static>> {
    let away = (0..fit.residuals_mm.len()).map(|index| {
        let mark = if fit.left_out.contains(&index) {
            "!"
        } else {
            ""
        };
        format!("{}{mark} {:.1}", index + 1, fit.residual_mm(index))
    });
    let away: Vec<String> = away.collect();
    let arm = &fit.arm;
    let mut lines = vec![
        Line::from(format!("error, mm: {}", away.join("  "))),
        Line::from(format!(
            "zeros: base {:.2}  rear {:.2}  fore {:.2} deg   tool: out {:.1}  left {:.1} mm",
            arm.base_deg, arm.rear_deg, arm.fore_deg, arm.reach_mm, arm.left_mm
        )),
    ];
    lines.extend(trust(fit));
    lines.extend(left_out(fit));
    if let Some(known) = known {
        lines.push(Line::from(format!(
            "change: base {:+.2}  rear {:+.2}  fore {:+.2} deg",
            arm.base_deg - known.zeros.base,
            arm.rear_deg - known.zeros.rear,
            arm.fore_deg - known.zeros.fore
        )));
    }
    if let Some(unsure) = fit.unsure.first() {
        let more = fit.advice.map_or(String::new(), |advice| {
            let [x_mm, y_mm] = advice.place_mm;
            let block = if advice.height_mm > 0.0 {
                format!("a block of about {} mm on ", advice.height_mm)
            } else {
                String::new()
            };
            format!("; best next point: {block}{x_mm}, {y_mm}")
        });
        let Unsure { what, by, unit } = unsure;
        lines.push(Line::from(format!("uncertain: {what} (±{by:.1} {unit}){more}")).dim());
    }
    lines
}

fn trust(fit: &Fit) -> Vec<Line<'static>> {
    let expected = format!("expected error {:.2} mm", fit.expected_mm);
    match fit.trust {
        Trust::Good => vec![Line::from(format!("good: {expected}")).green()],
        Trust::Unchecked => vec![Line::from(format!(
            "{expected} if no touch is wrong; touch six points or more to check"
        ))],
        Trust::Unmeasured => {
            let [out_mm, left_mm] = fit.tool_mm;
            vec![
                Line::from(format!(
                    "measure from the axis of the wrist to the tip: {out_mm:.0} mm outwards, {left_mm:.0} mm to the left?"
                ))
                .yellow(),
                Line::from("within 8 mm: press m; otherwise: measure the bar of the sheet, and touch again")
                    .yellow(),
            ]
        }
        Trust::Doubtful => vec![Line::from(format!(
            "doubtful: the touches differ by {:.1} mm, or the base was turned by hand; touch again",
            fit.typical_mm
        ))
        .yellow()],
    }
}

/// The touches that do not count.
fn left_out(fit: &Fit) -> Option<Line<'static>> {
    let numbers: Vec<String> = fit
        .left_out
        .iter()
        .map(|index| (index + 1).to_string())
        .collect();
    let line = |numbers| format!("left out, because they contradict the others: touch {numbers}");
    (!numbers.is_empty()).then(|| Line::from(line(numbers.join(" and "))))
}

/// The width of a text on the screen.
pub(super) const WIDTH: usize = 76;
