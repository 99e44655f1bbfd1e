//! The dashboard, as a pure function of the state and of the terminal's size.

use std::collections::VecDeque;

use dobot_api::{LinkPhase, Notice, State, StopView};
use ratatui::Frame;
use ratatui::layout::{Constraint, Layout};
use ratatui::style::{Color, Modifier, Style, Stylize};
use ratatui::text::{Line, Span};
use ratatui::widgets::{Paragraph, Wrap};

use super::panels;

/// The contents of the dashboard.
#[derive(Debug, Default)]
pub(crate) struct View {
    /// The address of the station.
    pub(crate) station: String,
    /// The last state, if any.
    pub(crate) state: Option<State>,
    /// Recent notices, oldest first.
    pub(crate) notices: VecDeque<Notice>,
    /// The reason why the station is not connected, if it is not.
    pub(crate) lost: Option<String>,
    /// Whether the question about clearing the stop is shown.
    pub(crate) asks: bool,
    /// The answer of the station to the last key.
    pub(crate) answer: Option<String>,
}

impl View {
    /// Handles the notices before the connection.
    pub(crate) fn handle_history(&mut self, notices: Vec<Notice>) {
        self.notices.clear();
        for notice in notices {
            self.handle_notice(notice);
        }
    }

    /// Handles a notice, unless it is in the history.
    pub(crate) fn handle_notice(&mut self, notice: Notice) {
        if self
            .notices
            .back()
            .is_some_and(|last| last.number >= notice.number)
        {
            return;
        }
        if self.notices.len() == MAX_NOTICES {
            self.notices.pop_front();
        }
        self.notices.push_back(notice);
    }
}

/// Draws the screen.
pub(crate) fn draw(frame: &mut Frame, view: &View) {
    let alarm = alarm_of(view);
    let rows = [
        Constraint::Length(1),
        Constraint::Length(alarm.rows(frame.area().width)),
        Constraint::Length(panels::PANEL_ROWS),
        Constraint::Length(panels::PANEL_ROWS),
        Constraint::Length(4),
        Constraint::Min(0),
        Constraint::Length(1),
    ];
    let [top, alarm_row, arm, rest, job, notices, keys] =
        Layout::vertical(rows).areas(frame.area());
    frame.render_widget(title(view), top);
    frame.render_widget(bar(&alarm), alarm_row);
    if let Some(state) = &view.state {
        panels::arm(frame, arm, state);
        panels::rest(frame, rest, state);
        panels::job(frame, job, state.job.as_ref());
    }
    panels::notices(frame, notices, &view.notices);
    frame.render_widget(keys_of(view), keys);
}

/// The station, the arm and the link between them.
fn title(view: &View) -> Paragraph<'_> {
    let mut spans = vec![
        " dobot ".bold().reversed(),
        format!(" {}  ", view.station).into(),
    ];
    if let Some(State { link, dialect, .. }) = &view.state {
        spans.push(link.address.as_deref().unwrap_or("no arm yet").bold());
        let dialect = dialect.map_or_else(
            || "dialect unknown".to_owned(),
            |dialect| dialect.to_string(),
        );
        spans.push(format!("  {dialect}").dim());
    }
    Paragraph::new(Line::from(spans))
}

/// The alarm line.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Alarm {
    style: Style,
    text: String,
}

impl Alarm {
    /// The rows that its text fills, with room for the ends of lines, at most four.
    fn rows(&self, width: u16) -> u16 {
        let per_row = usize::from(width).saturating_sub(LONGEST_WORD).max(1);
        let rows = match self.text.len() + 1 {
            len if len <= usize::from(width) => 1,
            len => len.div_ceil(per_row),
        };
        u16::try_from(rows.min(4)).expect("at most four")
    }
}

/// The most important alarm.
fn alarm_of(view: &View) -> Alarm {
    match (&view.lost, &view.state) {
        (Some(why), _) => {
            let text = format!("NO STATION: {why}; the data is outdated");
            Alarm { style: RED, text }
        }
        (None, state) => alarm_of_state(state.as_ref()),
    }
}

/// The most important alarm of a station's state.
pub(crate) fn alarm_of_state(state: Option<&State>) -> Alarm {
    let alarm = |style, text| Alarm { style, text };
    let (red, yellow) = (RED, YELLOW);
    let Some(state) = state else {
        return alarm(yellow, "waiting for the first report of the station".into());
    };
    if let Some(stop) = &state.stop {
        return alarm(red, stop_text(stop));
    }
    if state.link.phase != LinkPhase::Up {
        return alarm(yellow, link_alarm(state));
    }
    if !state.trust.trusted {
        let reason = state.trust.reason.as_deref().unwrap_or("the arm was reset");
        return alarm(yellow, format!("the pose is not confirmed: {reason}"));
    }
    if state.laser.on {
        return alarm(yellow, "LASER ON".into());
    }
    let moving = state.arm.as_ref().is_some_and(|arm| arm.moving);
    let text = if moving { "moving" } else { "at rest" };
    alarm(Style::new().fg(Color::Green), text.into())
}

fn stop_text(stop: &StopView) -> String {
    let rest = if stop.at_rest {
        "at rest"
    } else {
        "coming to rest"
    };
    let text = stop.text().replacen("stopped", "STOPPED", 1);
    format!("{text} ({rest})")
}

fn link_alarm(state: &State) -> String {
    let phase = match state.link.phase {
        LinkPhase::Searching => "looking for an arm",
        LinkPhase::Listening => "the port is open, but the arm is silent",
        LinkPhase::Lost => "the connection to the arm is lost",
        LinkPhase::Up => "connected",
    };
    let problem = [&state.link.problem, &state.link.remedy];
    match problem.map(|text| text.as_deref().unwrap_or_default()) {
        ["", _] => phase.to_owned(),
        [problem, ""] => format!("{phase}: {problem}"),
        [problem, remedy] => format!("{phase}: {problem}; {remedy}"),
    }
}

/// An alarm as a bar across the screen.
pub(crate) fn bar(alarm: &Alarm) -> Paragraph<'static> {
    Paragraph::new(format!(" {}", alarm.text))
        .wrap(Wrap { trim: false })
        .style(alarm.style)
}

/// The keys, and the answer to the last one.
fn keys_of(view: &View) -> Paragraph<'_> {
    if view.asks {
        return Paragraph::new(" clear the stop? look at the arm first   y yes   n no")
            .style(Style::new().reversed());
    }
    let mut spans: Vec<Span> = [("s", "STOP"), ("r", "clear stop"), ("q", "quit")]
        .iter()
        .flat_map(|(key, what)| [format!(" {key} ").reversed(), format!(" {what}  ").into()])
        .collect();
    spans.extend(view.answer.as_ref().map(|answer| answer.as_str().yellow()));
    Paragraph::new(Line::from(spans))
}

const RED: Style = Style::new()
    .bg(Color::Red)
    .fg(Color::White)
    .add_modifier(Modifier::BOLD);
const YELLOW: Style = Style::new().bg(Color::Yellow).fg(Color::Black);
/// More than fits on any screen.
const MAX_NOTICES: usize = 200;

/// A word that does not fit into the rest of a line leaves it empty.
const LONGEST_WORD: usize = 12;

#[cfg(test)]
mod tests {
    use dobot_api::{JobKind, JobPhase, JobView, News, QueueView, State, StopView};
    use dobot_wire::Dialect;
    use ratatui::Terminal;
    use ratatui::backend::TestBackend;

    use super::*;

    fn view() -> View {
        let mut state = State {
            dialect: Some(Dialect::FIRMWARE_1_1),
            queue: QueueView {
                waiting: 2,
                under_way: 1,
                ahead_s: 1.5,
            },
            clients: 2,
            ..State::sample()
        };
        (state.link.lost_statuses, state.link.damaged_bytes) = (3, 17);
        let status = &mut state.arm.as_mut().expect("there is one").status;
        status.y_mm = -40.5;
        (status.base_deg, status.servo_deg) = (30.25, -90.0);
        View {
            station: "http://127.0.0.1:8642".into(),
            state: Some(state),
            ..View::default()
        }
    }

    fn with(change: impl FnOnce(&mut State)) -> View {
        let mut view = view();
        change(view.state.as_mut().expect("there is one"));
        view
    }

    /// The screen as text, a line for each row.
    fn screen(view: &View, width: u16, height: u16) -> Vec<String> {
        let backend = TestBackend::new(width, height);
        let mut terminal = Terminal::new(backend).expect("memory is always there");
        terminal
            .draw(|frame| draw(frame, view))
            .expect("memory is always there");
        let buffer = terminal.backend().buffer();
        let row = |y| (0..width).map(|x| buffer[(x, y)].symbol()).collect();
        (0..height).map(row).collect()
    }

    #[track_caller]
    fn shows(view: &View, parts: &[&str]) {
        let screen = screen(view, 80, 24).join("\n");
        for part in parts {
            assert!(screen.contains(part), "`{part}` is missing:\n{screen}");
        }
    }

    #[test]
    fn the_dashboard_shows_the_place_of_the_arm_and_the_quality_of_the_link() {
        shows(
            &view(),
            &[
                "http://127.0.0.1:8642",
                "serial:/dev/ttyUSB0@9600",
                "firmware-1.1",
                "220.000 mm",
                "-40.500 mm",
                "30.25°",
                "12.5 of 12.5",
                "3 lost",
                "17 bytes bad",
                "46 ms",
                "at rest",
            ],
        );
    }

    #[test]
    fn the_dashboard_shows_each_joint_between_its_limits() {
        let screen = screen(&view(), 80, 24);
        let row = |name| {
            let row = screen.iter().find(|line| line.contains(name));
            row.unwrap_or_else(|| panic!("no {name}: {screen:#?}"))
        };
        // -5 to 85 degrees: 40 is in the middle; -90 to 90: -90 is at the very left.
        let place = |name| {
            let bar: String = row(name).chars().skip_while(|sign| *sign != '├').collect();
            let mark = bar.chars().position(|sign| sign == '●').expect("a mark");
            let len = bar.chars().position(|sign| sign == '┤').expect("an end");
            (mark, len)
        };
        let (mark, len) = place("rear");
        assert!(mark.abs_diff(len / 2) <= 1, "{mark} of {len}");
        assert_eq!(place("servo").0, 1);
    }

    #[test]
    fn the_dashboard_shows_that_the_arm_is_stopped_and_by_whom() {
        let stopped = with(|state| {
            state.stop = Some(StopView {
                by: "the page".into(),
                device: None,
                client: None,
                reason: Some("smoke".into()),
                at_s: 10.0,
                rests_by_s: 10.5,
                at_rest: true,
                delivered: true,
                of_fleet: false,
            });
        });
        shows(&stopped, &["STOPPED by the page: smoke (at rest)"]);
    }

    #[test]
    fn the_dashboard_shows_the_reason_for_a_wait() {
        let searching = with(|state| {
            state.link.phase = LinkPhase::Searching;
            state.link.problem = Some("no permission for /dev/ttyUSB0".into());
            state.link.remedy = Some("become a member of dialout, then log out and in".into());
            state.arm = None;
        });
        shows(
            &searching,
            &[
                "looking for an arm: no permission for /dev/ttyUSB0",
                "then log out and in",
            ],
        );
    }

    #[test]
    fn the_dashboard_shows_a_pose_that_is_not_trusted() {
        let reset = with(|state| {
            state.trust.trusted = false;
            state.trust.reason = Some("the arm was reset".into());
        });
        shows(&reset, &["the pose is not confirmed: the arm was reset"]);
    }

    #[test]
    fn the_dashboard_shows_the_progress_and_the_remaining_time_of_the_job() {
        let drawing = with(|state| {
            state.job = Some(JobView {
                job: 4,
                title: "harbour.svg".into(),
                kind: JobKind::Drawing,
                created_ms: 1_700_000_000_000,
                phase: JobPhase::Paused,
                reason: Some("a person asked for it".into()),
                waits_for_person: false,
                commands: 400,
                completed: 100,
                planned_s: Some(120.0),
                left_s: Some(83.0),
                took_s: None,
                speed_percent: 100.0,
                height_mm: 0.0,
                program: None,
                question: None,
            });
        });
        shows(
            &drawing,
            &[
                "harbour.svg",
                "paused: a person asked for it",
                "100 of 400",
                "1:23 min left",
                "25 %",
            ],
        );
    }

    #[test]
    fn the_dashboard_shows_the_lease_holder_and_the_requester() {
        let lease = r#"{"client": 5, "name": "the page", "since_s": 1.0,
                "asked_by": [{"client": 9, "name": "dobot jog"}]}"#;
        let held = with(|state| {
            state.lease = Some(serde_json::from_str(lease).expect("it is a lease"));
        });
        shows(&held, &["the page (client 5)", "asked: dobot jog (9)"]);
        shows(&view(), &["nobody"]);
    }

    #[test]
    fn the_dashboard_shows_the_laser_and_its_remaining_arming_time() {
        shows(&view(), &["disarmed"]);
        let armed = with(|state| state.laser.armed_for_s = 90.0);
        shows(&armed, &["armed 1:30 min"]);
        let burning = with(|state| state.laser.on = true);
        shows(&burning, &["LASER ON"]);
    }

    #[test]
    fn the_dashboard_shows_the_newest_notices() {
        let mut view = view();
        for number in 1..=300 {
            view.handle_notice(Notice {
                number,
                at_s: 10.0,
                news: News::LinkUp,
                text: format!("notice {number}."),
            });
        }
        shows(&view, &["notice 300.", "notice 299."]);
        assert!(!screen(&view, 80, 24).join("\n").contains("notice 1."));
    }

    #[test]
    fn the_dashboard_reports_old_data_when_the_station_is_gone() {
        let mut view = view();
        view.lost = Some("the station closed the connection".into());
        shows(&view, &["NO STATION", "the data is outdated"]);
    }

    #[test]
    fn a_person_is_asked_before_the_arm_moves_again() {
        let mut view = view();
        view.asks = true;
        shows(&view, &["clear the stop?", "y yes"]);
    }

    #[test]
    fn every_size_of_terminal_can_be_drawn_on() {
        for width in (1..=200).step_by(7) {
            for height in (1..=20).chain([24, 40, 60]) {
                screen(&view(), width, height);
                screen(&View::default(), width, height);
            }
        }
    }

    #[test]
    fn a_stop_is_visible_on_the_smallest_terminal() {
        let stopped = with(|state| {
            state.stop = Some(StopView {
                by: "me".into(),
                device: None,
                client: None,
                reason: None,
                at_s: 0.0,
                rests_by_s: 0.0,
                at_rest: false,
                delivered: true,
                of_fleet: false,
            });
        });
        let screen = screen(&stopped, 20, 4).join("\n");
        assert!(screen.contains("STOPPED by me"), "{screen}");
    }
}
