//! The screen of `dobot teach`, as a pure function of the state and of the terminal's size.

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Stylize;
use ratatui::text::{Line, Span};

use super::teacher::Teacher;
use crate::follow::place;
use crate::output;
use crate::pendant::{alarm, answer, held_line, key_line, move_lines};
use crate::verbs::watch::panels;

/// Draws the screen.
pub(crate) fn draw(frame: &mut Frame, teacher: &Teacher) {
    let rows = [
        Constraint::Length(1),
        Constraint::Length(1),
        Constraint::Length(6),
        Constraint::Min(3),
        Constraint::Length(8),
        Constraint::Length(1),
    ];
    let [top, alarm_row, arm, program, keys, bottom] = Layout::vertical(rows).areas(frame.area());
    frame.render_widget(held_line(&teacher.pendant), top);
    frame.render_widget(alarm(&teacher.pendant), alarm_row);
    if let Some(state) = teacher.pendant.state() {
        panels::arm(frame, arm, state);
    }
    program_panel(frame, program, teacher);
    panels::panel(frame, keys, "keys", keys_of(teacher));
    frame.render_widget(answer(&teacher.pendant), bottom);
}

/// The state line and the steps around the cursor.
fn program_panel(frame: &mut Frame, area: Rect, teacher: &Teacher) {
    let rows = usize::from(area.height.saturating_sub(3));
    let steps = teacher.lesson.lines();
    let cursor = teacher.lesson.cursor();
    let skipped = (cursor + 1).saturating_sub(rows);
    let mut lines = vec![state_line(teacher)];
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

/// The state line: the file, the path of the next step, the recording and the job.
fn state_line(teacher: &Teacher) -> Line<'static> {
    let changed = if teacher.lesson.is_changed() { "*" } else { "" };
    let mut spans: Vec<Span> = vec![
        format!("{}{changed}  ", teacher.file.display()).into(),
        format!("next step: {:?}  ", teacher.path)
            .to_lowercase()
            .dim(),
    ];
    if let Some(places) = teacher.recorded() {
        spans.push(
            format!("RECORDING {}  ", output::count(places, "position"))
                .red()
                .bold(),
        );
    }
    if let Some(job) = teacher.job() {
        let phase = format!("{:?}", job.phase).to_lowercase();
        let how_far = job.program.as_ref().map(place).unwrap_or_default();
        spans.push(format!("job {} {phase}: {how_far}", job.job).cyan());
    }
    Line::from(spans)
}

fn keys_of(teacher: &Teacher) -> Vec<Line<'static>> {
    let mut lines = move_lines(&teacher.pendant);
    lines.extend([
        key_line(&[
            ("Enter", "add point"),
            ("m", "path"),
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
            ("w q", "save, quit"),
        ]),
    ]);
    lines
}
