//! The screen of `dobot teach`, as a pure function of the state and of the terminal's size.

use dobot_teach::Times;
use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Stylize;
use ratatui::text::{Line, Span};

use super::prompt::{Input, Prompt};
use super::teacher::Teacher;
use crate::follow::place;
use crate::output;
use crate::pendant::{answer, draw_top, key_line, move_lines};
use crate::verbs::watch::panels;

/// Draws the screen.
pub(crate) fn draw(frame: &mut Frame, teacher: &Teacher) {
    // A question has fewer keys, and answers that may need a second line.
    let [keys_height, answer_height] = if teacher.prompt.is_some() {
        [8, 2]
    } else {
        [9, 1]
    };
    let rows = [
        Constraint::Length(1),
        Constraint::Length(1),
        Constraint::Length(6),
        Constraint::Min(3),
        Constraint::Length(keys_height),
        Constraint::Length(answer_height),
    ];
    let [top, alarm_row, arm, program, keys, bottom] = Layout::vertical(rows).areas(frame.area());
    draw_top(frame, &teacher.pendant, [top, alarm_row, arm]);
    program_panel(frame, program, teacher);
    match &teacher.prompt {
        Some(prompt) => panels::panel(frame, keys, "question", question_of(teacher, prompt)),
        None => panels::panel(frame, keys, "keys", keys_of(teacher)),
    }
    frame.render_widget(answer(&teacher.pendant), bottom);
}

/// The rows around the cursor, under the state.
fn program_panel(frame: &mut Frame, area: Rect, teacher: &Teacher) {
    let begun = teacher.lesson.begun();
    let height = usize::from(area.height.saturating_sub(2 + u16::from(begun.is_some())));
    let rows = teacher.lesson.rows();
    let cursor = teacher.lesson.cursor();
    let skipped = (cursor + 1).saturating_sub(height);
    let mut lines = Vec::new();
    for (index, (number, text)) in rows.into_iter().enumerate().skip(skipped).take(height) {
        let is_cursor = index == cursor;
        let line = Line::from(format!("{} {number:>3}  {text}", mark(is_cursor)));
        lines.push(if is_cursor { line.bold() } else { line });
        if let Some(times) = begun.filter(|_| is_cursor) {
            let text = format!("       repeat {}, from the next step on", times_text(times));
            lines.push(text.cyan().into());
        }
    }
    panels::titled_panel(frame, area, "program", state_line(teacher), lines);
}

/// `3 times`, or `forever`.
pub(super) fn times_text(times: Times) -> String {
    match times {
        Times::Count(count) => output::count(count, "time"),
        Times::Forever => "forever".to_owned(),
    }
}

const fn mark(is_cursor: bool) -> char {
    if is_cursor { '▶' } else { ' ' }
}

/// The state: the file, the path and the frame of the next step, the recording and the job.
fn state_line(teacher: &Teacher) -> Line<'static> {
    let changed = if teacher.lesson.is_changed() { "*" } else { "" };
    let mut spans: Vec<Span> = vec![
        format!(" {}{changed}  ", teacher.file.display()).into(),
        format!("next step: {:?}  ", teacher.path)
            .to_lowercase()
            .dim(),
    ];
    if let Some(frame) = teacher.lesson.frame() {
        spans.push(format!("in frame {frame}  ").cyan());
    }
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

/// The question, what was answered so far, and the keys that answer it.
fn question_of<'a>(teacher: &Teacher, prompt: &Prompt) -> Vec<Line<'a>> {
    let question = Line::from(prompt.question()).bold();
    let stops = [("Space", "STOP"), ("Esc", "STOP and leave")];
    let back = ("Backspace", "back");
    match prompt.input() {
        Input::Choice => vec![
            question,
            key_line(prompt.choices()),
            key_line(&[stops[0], stops[1], back]),
        ],
        Input::Text => vec![
            question,
            Line::from(format!("  {}█", prompt.text())).bold(),
            key_line(&[("Enter", "accept"), stops[0], stops[1], back]),
        ],
        Input::Place => {
            let mut lines = vec![question];
            lines.extend(move_lines(&teacher.pendant, STEPS_KEY));
            lines.push(key_line(&[("Enter", "touch"), stops[1], back]));
            lines
        }
    }
}

fn keys_of(teacher: &Teacher) -> Vec<Line<'static>> {
    let mut lines = move_lines(&teacher.pendant, STEPS_KEY);
    lines.extend(KEYS.map(key_line));
    lines
}

const KEYS: [&[(&str, &str)]; 4] = [
    &[
        ("Enter", "add point"),
        ("m", "path"),
        ("u j", "pump on, off"),
        ("t", "pause"),
        ("v", "record"),
    ],
    &[
        (", .", "step"),
        ("< >", "move it"),
        ("Del", "remove"),
        ("z Z", "undo, redo"),
        ("w q", "save, quit"),
    ],
    &[
        ("a", "add name, repeat, tool, grid, frame, call"),
        ("e", "end repeat or grid"),
    ],
    &[
        ("g", "run"),
        ("l", "loop"),
        ("h", "from here"),
        ("n", "one step"),
        ("p", "pause"),
        ("x", "end"),
    ],
];

/// The key that toggles steps.
const STEPS_KEY: &str = "/";
