//! The screen of `dobot teach`, as a pure function of what is known and of the terminal's size.

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Stylize;
use ratatui::text::{Line, Span};

use super::teacher::Teacher;
use crate::follow::place;
use crate::pendant::{alarm, answer, held, key_line, move_lines};
use crate::verbs::watch::panels;

/// Draws everything.
pub(crate) fn draw(frame: &mut Frame, it: &Teacher) {
    let rows = [
        Constraint::Length(1),
        Constraint::Length(1),
        Constraint::Length(6),
        Constraint::Min(3),
        Constraint::Length(8),
        Constraint::Length(1),
    ];
    let [top, alarm_row, arm, program, keys, bottom] = Layout::vertical(rows).areas(frame.area());
    frame.render_widget(held(&it.pendant), top);
    frame.render_widget(alarm(&it.pendant), alarm_row);
    if let Some(state) = it.pendant.state() {
        panels::arm(frame, arm, state);
    }
    program_panel(frame, program, it);
    panels::panel(frame, keys, "keys", keys_of(it));
    frame.render_widget(answer(&it.pendant), bottom);
}

/// The steps around the cursor, below what is going on.
fn program_panel(frame: &mut Frame, area: Rect, it: &Teacher) {
    let rows = usize::from(area.height.saturating_sub(3));
    let steps = it.lesson.lines();
    let cursor = it.lesson.cursor();
    let skipped = (cursor + 1).saturating_sub(rows);
    let mut lines = vec![going_on(it)];
    let shown = steps.into_iter().enumerate().skip(skipped).take(rows);
    lines.extend(shown.map(|(index, text)| {
        let text = format!("{} {:3}  {text}", mark(index == cursor), index + 1);
        let line = Line::from(text);
        if index == cursor { line.bold() } else { line }
    }));
    panels::panel(frame, area, "program", lines);
}

const fn mark(is_cursor: bool) -> char {
    if is_cursor { '▶' } else { ' ' }
}

/// The file, the way of the next step, the recording and the job.
fn going_on(it: &Teacher) -> Line<'static> {
    let changed = if it.lesson.is_changed() { "*" } else { "" };
    let mut spans: Vec<Span> = vec![
        format!("{}{changed}  ", it.file.display()).into(),
        format!("next step: {:?}  ", it.path).to_lowercase().dim(),
    ];
    if let Some(places) = it.recorded() {
        spans.push(format!("RECORDING {places} places  ").red().bold());
    }
    if let Some(job) = it.job() {
        let phase = format!("{:?}", job.phase).to_lowercase();
        let how_far = job.program.as_ref().map(place).unwrap_or_default();
        spans.push(format!("job {} {phase}: {how_far}", job.job).cyan());
    }
    Line::from(spans)
}

fn keys_of(it: &Teacher) -> Vec<Line<'static>> {
    let mut lines = move_lines(&it.pendant);
    lines.extend([
        key_line(&[
            ("Enter", "teach point"),
            ("m", "way"),
            ("u j", "pump on, off"),
            ("t", "pause"),
            ("v", "record"),
        ]),
        key_line(&[
            (", .", "step"),
            ("< >", "move it"),
            ("Del", "remove"),
            ("z Z", "undo, redo"),
        ]),
        key_line(&[
            ("g", "run"),
            ("l", "loop"),
            ("h", "from here"),
            ("n", "one step"),
            ("p", "pause"),
            ("x", "end"),
            ("w q", "save, leave"),
        ]),
    ]);
    lines
}
