//! The screen of the pendant, as a pure function of the state and of the terminal's size.

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::{Style, Stylize};
use ratatui::text::{Line, Span};
use ratatui::widgets::{Paragraph, Wrap};

use dobot_api::JogFrame;
use dobot_motion::{JogAxis, Model};
use dobot_wire::LINE_TIME;

use super::{Drive, KeyReports, Pendant, Question};
use crate::verbs::watch::dashboard::{alarm_of_state, bar};
use crate::verbs::watch::panels;

/// Draws the screen.
pub(crate) fn draw(frame: &mut Frame, pendant: &Pendant) {
    let rows = [
        Constraint::Length(1),
        Constraint::Length(1),
        Constraint::Length(panels::PANEL_ROWS),
        Constraint::Length(panels::PANEL_ROWS),
        Constraint::Min(0),
        Constraint::Length(2),
    ];
    let [top, alarm_row, arm, rest, keys, bottom] = Layout::vertical(rows).areas(frame.area());
    draw_top(frame, pendant, [top, alarm_row, arm]);
    if let Some(state) = &pendant.state {
        panels::rest(frame, rest, state);
    }
    keys_of(frame, keys, pendant);
    frame.render_widget(answer(pendant), bottom);
}

/// Draws the first rows of each screen with a pendant: the held button, the alarm, the arm.
pub(crate) fn draw_top(frame: &mut Frame, pendant: &Pendant, [held, alarm_row, arm]: [Rect; 3]) {
    frame.render_widget(held_line(pendant), held);
    frame.render_widget(alarm(pendant), alarm_row);
    if let Some(state) = &pendant.state {
        panels::arm(frame, arm, state);
    }
}

/// The alarm line.
fn alarm(pendant: &Pendant) -> Paragraph<'static> {
    bar(&alarm_of_state(pendant.state.as_ref()))
}

/// The held button and its speed.
fn held_line(pendant: &Pendant) -> Paragraph<'static> {
    let (name, unit) = match pendant.drive {
        Drive::Jog => (" jog ", "% of the jog speed"),
        Drive::Mouse(_) => (" mouse ", "% of the increment"),
    };
    let held = match pendant.hold.button() {
        Some(button) => format!(" {} ", button.name()).bold().green(),
        None => " no key held ".dim(),
    };
    let far = match (pendant.step, pendant.frame) {
        (None, _) => format!(
            " {:.0} {unit}{}  ",
            pendant.speed_percent,
            coasting(pendant)
        ),
        (Some(size), JogFrame::Linear) => format!(" steps of {size} mm  "),
        (Some(size), JogFrame::Joint) => format!(" steps of {size} degrees  "),
    };
    Paragraph::new(Line::from(vec![
        name.bold().reversed(),
        held,
        far.into(),
        frame_name(pendant.frame).dim(),
    ]))
}

/// How far the arm coasts at this speed, if it is known.
fn coasting(pendant: &Pendant) -> String {
    let (Drive::Jog, Some(state)) = (&pendant.drive, &pendant.state) else {
        return String::new();
    };
    let (Some(dialect), Some(arm)) = (state.dialect, &state.arm) else {
        return String::new();
    };
    let model = Model::new(dialect, &arm.status);
    let model = state
        .settings
        .iter()
        .fold(model, |model, command| model.begun(command));
    let (axis, unit) = match pendant.frame {
        JogFrame::Linear => (JogAxis::X, " mm"),
        JogFrame::Joint => (JogAxis::Base, "°"),
    };
    let delay = pendant.hold.release_delay() + LINE_TIME;
    let share = f64::from(pendant.speed_percent) / 100.0;
    let far = axis.coasting(&model.settings, share, delay.as_secs_f64());
    format!(", coasts {far:.1}{unit}")
}

const fn frame_name(frame: JogFrame) -> &'static str {
    match frame {
        JogFrame::Linear => "along x, y, z",
        JogFrame::Joint => "joints",
    }
}

/// The keys, and how this terminal reports them.
fn keys_of(frame: &mut Frame, area: Rect, pendant: &Pendant) {
    let mut lines = move_lines(pendant, ".");
    lines.push(key_line(&[("u j", "pump on, off"), ("q", "quit")]));
    lines.push(match pendant.hold.keys() {
        KeyReports::Releases => "the arm moves while a key is held".dim().into(),
        KeyReports::Presses => "the arm moves while a key repeats: a short step, then continuously"
            .dim()
            .into(),
    });
    panels::panel(frame, area, "keys", lines);
}

/// The keys that stop and move the arm; `steps` is the key that toggles steps.
pub(crate) fn move_lines(pendant: &Pendant, steps: &'static str) -> Vec<Line<'static>> {
    let [arrows, sides, pages] = match pendant.frame {
        JogFrame::Linear => ["x+ x-", "y+ y-", "z+ z-"],
        JogFrame::Joint => ["rear+ rear-", "base+ base-", "fore- fore+"],
    };
    let mut stops = vec![("Space Esc s", "STOP"), ("1 … 9 0", "speed")];
    if matches!(pendant.drive, Drive::Jog) {
        stops.push((steps, "steps of 1, of 0.1"));
    }
    let mut lines = vec![
        key_line(&stops),
        key_line(&[("↑ ↓", arrows), ("← →", sides), ("PgUp PgDn", pages)]),
    ];
    if matches!(pendant.drive, Drive::Jog) {
        lines.push(key_line(&[
            ("r f", "turn tool"),
            ("o c", "open, close gripper"),
            ("Tab", "joints or x, y, z"),
        ]));
    }
    lines
}

/// Formats keys with their meanings.
pub(crate) fn key_line(keys: &[(&'static str, &'static str)]) -> Line<'static> {
    let spans = keys
        .iter()
        .flat_map(|(key, what)| [format!(" {key} ").reversed(), format!(" {what}  ").into()]);
    Line::from(spans.collect::<Vec<Span>>())
}

/// The question, or the answer to the last key.
pub(crate) fn answer(pendant: &Pendant) -> Paragraph<'_> {
    let question = match pendant.asks {
        Some(Question::Reset) => " clear the stop? look at the arm first   y yes   n no",
        Some(Question::Confirm) => {
            " is the arm at this position, and does it point there?   y yes   n no"
        }
        None => {
            let text = pendant.answer.as_deref().or_else(|| pendant.remedy());
            return Paragraph::new(text.unwrap_or_default().yellow()).wrap(Wrap { trim: true });
        }
    };
    Paragraph::new(question).style(Style::new().reversed())
}

impl Pendant {
    /// The remedy while no key moves the arm.
    fn remedy(&self) -> Option<&'static str> {
        self.question().map(|question| match question {
            Question::Reset => "look at the arm, then press r to clear the stop",
            Question::Confirm => {
                "compare the arm with the screen, turn it by hand if it differs, then press r"
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use dobot_api::{ClientId, State};
    use dobot_wire::Dialect;
    use ratatui::Terminal;
    use ratatui::backend::TestBackend;

    use super::*;
    use crate::pendant::Mouse;

    fn pendant(keys: KeyReports, drive: Drive) -> Pendant {
        Pendant::new(ClientId(1), keys, Duration::from_millis(150), drive)
    }

    fn screen(pendant: &Pendant, width: u16, height: u16) -> String {
        let mut terminal =
            Terminal::new(TestBackend::new(width, height)).expect("memory is always there");
        terminal
            .draw(|frame| draw(frame, pendant))
            .expect("memory is always there");
        let buffer = terminal.backend().buffer();
        let row = |y| (0..width).map(|x| buffer[(x, y)].symbol()).collect();
        let rows: Vec<String> = (0..height).map(row).collect();
        rows.join("\n")
    }

    #[test]
    fn the_screen_shows_every_key_on_a_usual_terminal() {
        let screen = screen(&pendant(KeyReports::Presses, Drive::Jog), 80, 24);
        for part in [
            "STOP",
            "x+ x-",
            "y+ y-",
            "z+ z-",
            "turn tool",
            "gripper",
            "pump",
            "speed",
            "quit",
            "a key repeats",
            "no key held",
            "50 %",
        ] {
            assert!(screen.contains(part), "`{part}` is missing:\n{screen}");
        }
    }

    #[test]
    fn the_screen_shows_how_far_the_arm_coasts() {
        // 60 mm/s, braked at 60 mm/s2: 30 mm; a release takes 55 ms: 3.3 mm; a terminal that does not report it
        // takes 150 ms more: 9 mm. Joints: 15 degrees/s, braked at 50 degrees/s2.
        for (keys, frame, expected) in [
            (KeyReports::Releases, JogFrame::Linear, "coasts 33.3 mm"),
            (KeyReports::Presses, JogFrame::Linear, "coasts 42.3 mm"),
            (KeyReports::Releases, JogFrame::Joint, "coasts 3.1°"),
        ] {
            let mut pendant = pendant(keys, Drive::Jog);
            let mut state = State::sample();
            state.dialect = Some(Dialect::FIRMWARE_1_1);
            pendant.handle_state(state);
            pendant.frame = frame;
            pendant.speed_percent = 100.0;
            let screen = screen(&pendant, 80, 24);
            assert!(screen.contains(expected), "{expected}:\n{screen}");
        }
    }

    #[test]
    fn a_mouse_shows_no_keys_that_it_lacks() {
        let mouse = Drive::Mouse(Mouse::new());
        let screen = screen(&pendant(KeyReports::Releases, mouse), 80, 24);
        assert!(
            screen.contains("x+ x-") && screen.contains("is held"),
            "{screen}"
        );
        assert!(!screen.contains("close gripper"), "{screen}");
    }

    #[test]
    fn every_size_of_terminal_can_be_drawn_on() {
        let pendant = pendant(KeyReports::Presses, Drive::Jog);
        for width in (1..=120).step_by(7) {
            for height in 1..=40 {
                screen(&pendant, width, height);
            }
        }
    }
}
