//! The parts of the dashboard.

use std::collections::VecDeque;

use dobot_api::{ArmView, JobView, LaserView, LinkView, Notice, QueueView, State};
use dobot_arm::{Degrees, Limits, Span as Range};
use dobot_wire::Status;
use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::{Color, Style, Stylize};
use ratatui::text::Line;
use ratatui::widgets::{Block, BorderType, LineGauge, Paragraph};

use crate::output::{clock, time_left};

/// Pose and joints.
pub(crate) fn arm(frame: &mut Frame, area: Rect, state: &State) {
    let [pose, joints] =
        Layout::horizontal([Constraint::Length(24), Constraint::Min(0)]).areas(area);
    let status = state.arm.as_ref().map(|arm| &arm.status);
    panel(frame, pose, "pose", status.map_or_else(unknown, pose_lines));
    let width = joints.width.saturating_sub(2);
    let lines = status.map_or_else(unknown, |status| joint_lines(status, width));
    panel(frame, joints, "joints", lines);
}

/// The lines of the panel of the station.
const STATION_LINES: usize = 4;
/// The height of `arm` and of `rest` with their frames, in rows.
#[expect(clippy::cast_possible_truncation, reason = "a handful of lines")]
pub(crate) const PANEL_ROWS: u16 = STATION_LINES as u16 + 2;

/// Tool, link and queue.
pub(crate) fn rest(frame: &mut Frame, area: Rect, state: &State) {
    let halves = [Constraint::Length(24), Constraint::Min(0)];
    let [tool, station] = Layout::horizontal(halves).areas(area);
    panel(frame, tool, "tool", tool_lines(state));
    panel(frame, station, "station", station_lines(state).to_vec());
}

/// The job and its progress.
pub(super) fn job(frame: &mut Frame, area: Rect, job: Option<&JobView>) {
    let block = block("job");
    let inside = block.inner(area);
    frame.render_widget(block, area);
    let Some(job) = job else {
        frame.render_widget(Paragraph::new("none".dim()), inside);
        return;
    };
    let halves = [Constraint::Length(1), Constraint::Length(1)];
    let [text, bar] = Layout::vertical(halves).areas(inside);
    frame.render_widget(Paragraph::new(job_line(job)), text);
    let share = share(job.completed, job.commands);
    let gauge = LineGauge::default()
        .ratio(share)
        .label(format!(
            "{:.0} %  {} of {}  {}",
            share * 100.0,
            job.completed,
            job.commands,
            time_left(job.left_s)
        ))
        .filled_style(Style::new().fg(Color::Cyan))
        .unfilled_style(Style::new().dim());
    frame.render_widget(gauge, bar);
}

/// Recent notices that fit, the newest one last.
pub(super) fn notices(frame: &mut Frame, area: Rect, notices: &VecDeque<Notice>) {
    let rows = usize::from(area.height.saturating_sub(2));
    let skipped = notices.len().saturating_sub(rows);
    let lines = notices.iter().skip(skipped).map(|notice| {
        let at = format!("{:>9}  ", clock(notice.at_s));
        Line::from(vec![at.dim(), notice.text.as_str().into()])
    });
    panel(frame, area, "events", lines.collect());
}

/// A panel with lines of text.
pub(crate) fn panel(frame: &mut Frame, area: Rect, title: &'static str, lines: Vec<Line>) {
    frame.render_widget(Paragraph::new(lines).block(block(title)), area);
}

/// Draws a panel with a second title, of several styles.
pub(crate) fn titled_panel(
    frame: &mut Frame,
    area: Rect,
    title: &'static str,
    second: Line,
    lines: Vec<Line>,
) {
    let block = block(title).title(second);
    frame.render_widget(Paragraph::new(lines).block(block), area);
}

fn block(title: &'static str) -> Block<'static> {
    Block::bordered()
        .border_type(BorderType::Rounded)
        .border_style(Style::new().dim())
        .title(format!(" {title} "))
}

fn unknown<'a>() -> Vec<Line<'a>> {
    vec!["no data".dim().into()]
}

fn pose_lines(status: &Status) -> Vec<Line<'static>> {
    vec![
        format!("x    {:9.3} mm", status.x_mm).into(),
        format!("y    {:9.3} mm", status.y_mm).into(),
        format!("z    {:9.3} mm", status.z_mm).into(),
        format!("turn {:8.2}°", status.rotation_deg).into(),
    ]
}

fn joint_lines(status: &Status, width: u16) -> Vec<Line<'static>> {
    let limits = Limits::STOCK;
    [
        ("base ", status.base_deg, limits.base),
        ("rear ", status.rear_deg, limits.rear),
        ("fore ", status.fore_deg, limits.fore),
        ("servo", status.servo_deg, limits.servo),
    ]
    .into_iter()
    .map(|(name, deg, range)| joint_line(name, deg.into(), range, usize::from(width)))
    .collect()
}

/// `rear   40.00°   -5 ├─────────●─────────┤ 85`
fn joint_line(name: &str, deg: f64, range: Range<Degrees>, width: usize) -> Line<'static> {
    let (min, max) = (range.min.0, range.max.0);
    let before = format!("{name} {deg:8.2}°  {min:>4.0} ");
    let after = format!(" {max:<4.0}");
    let room = width.saturating_sub(before.chars().count() + after.len() + 2);
    let share = ((deg - min) / (max - min)).clamp(0.0, 1.0);
    let mark = part(share, room.saturating_sub(1));
    let bar = |len| "─".repeat(len);
    let near = !(NEAR..=1.0 - NEAR).contains(&share);
    let color = if near { Color::Yellow } else { Color::Cyan };
    Line::from(vec![
        before.into(),
        format!("├{}", bar(mark)).dim(),
        "●".fg(color),
        format!("{}┤", bar(room.saturating_sub(mark + 1))).dim(),
        after.into(),
    ])
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "a share of the columns of a terminal"
)]
fn part(share: f64, of: usize) -> usize {
    (share * of as f64).round() as usize
}

#[expect(clippy::cast_precision_loss, reason = "a share for the eye")]
fn share(completed: usize, commands: usize) -> f64 {
    (completed as f64 / commands.max(1) as f64).clamp(0.0, 1.0)
}

fn tool_lines(state: &State) -> Vec<Line<'static>> {
    let mut lines = state
        .arm
        .as_ref()
        .map_or_else(unknown, |ArmView { status, .. }| {
            let suction = if status.suction {
                "on".bold()
            } else {
                "off".into()
            };
            vec![
                Line::from(vec!["suction ".dim(), suction]),
                Line::from(vec![
                    "gripper ".dim(),
                    format!("{:.1}°", status.gripper_deg).into(),
                ]),
            ]
        });
    lines.push(Line::from(vec!["laser   ".dim(), laser_text(&state.laser)]));
    lines
}

fn laser_text(laser: &LaserView) -> ratatui::text::Span<'static> {
    match (laser.on, laser.armed_for_s > 0.0) {
        (true, _) => "on".red().bold(),
        (false, true) => format!("armed {}", clock(laser.armed_for_s)).yellow(),
        (false, false) => "disarmed".into(),
    }
}

fn station_lines(state: &State) -> [Line<'static>; STATION_LINES] {
    let fact = |name: &'static str, text: String| Line::from(vec![name.dim(), text.into()]);
    [
        fact("control ", control(state)),
        fact("queue   ", queue_text(&state.queue)),
        fact("link    ", link_text(&state.link)),
        fact(
            "clients ",
            format!("{}, running for {}", state.clients, clock(state.at_s)),
        ),
    ]
}

fn queue_text(queue: &QueueView) -> String {
    format!(
        "{} in flight, {} waiting, {} ahead",
        queue.under_way,
        queue.waiting,
        clock(queue.ahead_s)
    )
}

fn link_text(link: &LinkView) -> String {
    let latency = link.latency_ms.map(|ms| format!(", {ms:.0} ms"));
    format!(
        "{:.1} of 12.5/s, {} lost, {} bytes bad{}",
        link.statuses_per_s,
        link.lost_statuses,
        link.damaged_bytes,
        latency.unwrap_or_default()
    )
}

fn control(state: &State) -> String {
    let Some(lease) = &state.lease else {
        return "nobody".to_owned();
    };
    let asking = lease
        .asked_by
        .iter()
        .map(|asking| format!("{} ({})", asking.name, asking.client.0));
    let asking: Vec<_> = asking.collect();
    let asked = if asking.is_empty() {
        String::new()
    } else {
        format!(", asked: {}", asking.join(", "))
    };
    format!("{} (client {}){asked}", lease.name, lease.client.0)
}

fn job_line(job: &JobView) -> Line<'_> {
    let phase = format!("{:?}", job.phase).to_lowercase();
    let reason = job.reason.as_ref().map(|reason| format!(": {reason}"));
    Line::from(vec![
        format!("{} ", job.job).dim(),
        job.title.as_str().bold(),
        format!("  {phase}{}", reason.unwrap_or_default()).into(),
    ])
}

/// The distance to a limit at which a joint is highlighted, as a fraction of its range.
const NEAR: f64 = 0.05;
