//! Title, figures and what happened.

use std::fmt::Write as _;

use dobot_geometry::Point;
use dobot_lettering::{Anchor, lettering, width};

use super::{Frame, INK, MUTED, WARM};
use crate::world::marks::{WRITES_MM, ink_mm};
use crate::world::track::length_mm;
use crate::world::{Event, ToolKind, WorldState};

/// Above the views: what it is on the left, what the tool is about on the right.
pub(super) fn head(state: &WorldState, top: &Frame, unit: f64) -> String {
    let y = top.top - 4.5 * unit;
    let title = format!("the world at {:.2} s", state.time_s);
    let title = lettering(&title, Anchor::Left, top.left, y, 3.6 * unit);
    let doing = lettering(
        &doing(state),
        Anchor::Right,
        top.left + top.width,
        y,
        1.9 * unit,
    );
    format!(
        "<g stroke=\"{INK}\" stroke-width=\".85\">{title}</g><g stroke=\"{MUTED}\" stroke-width=\".75\">{doing}</g>\n"
    )
}

fn doing(state: &WorldState) -> String {
    let name = state.tool.name();
    let Some(arm) = &state.arm else {
        return name.to_owned();
    };
    match (state.tool.kind, state.held.first()) {
        (_, Some(held)) => format!("{name}, holds {held}"),
        (ToolKind::Pen { .. }, _) if arm.tip_mm <= WRITES_MM => "pen, down".to_owned(),
        (ToolKind::Pen { .. }, _) => "pen, up".to_owned(),
        (ToolKind::Laser { .. }, _) if arm.laser => "laser, on".to_owned(),
        (ToolKind::Laser { .. }, _) => "laser, off".to_owned(),
        (ToolKind::SuctionCup { .. }, _) if arm.pump => "suction cup, pump on".to_owned(),
        (ToolKind::SuctionCup { .. }, _) => "suction cup, pump off".to_owned(),
        (ToolKind::Gripper { .. }, _) => format!("gripper, {:.1} mm open", arm.opening_mm),
    }
}

/// What happened last, the latest at the bottom.
pub(super) fn log(state: &WorldState, frame: &Frame, unit: f64) -> String {
    let (x, high, step) = (frame.left + 3.0 * unit, 1.45 * unit, 3.3 * unit);
    let words = |text: &str, y: f64, color: &str| {
        let words = lettering(text, Anchor::Left, x, y, high);
        format!("<g stroke=\"{color}\" stroke-width=\".75\">{words}</g>\n")
    };
    let lines = lines(state, frame.width - 6.0 * unit, high);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a few dozen lines"
    )]
    let room = ((frame.height - 9.0 * unit) / step).clamp(1.0, 60.0) as usize;
    let cut = lines.len().saturating_sub(room);
    let all = cut == 0 && state.events.len() as u64 == state.event_count;
    let mut svg = words(
        &headline(state.event_count, all),
        frame.top + 4.4 * unit,
        MUTED,
    );
    let mut y = frame.top + 8.6 * unit;
    for (text, color) in &lines[cut..] {
        svg += &words(text, y, color);
        y += step;
    }
    svg
}

fn headline(count: u64, all: bool) -> String {
    match count {
        0 => "nothing happened yet".to_owned(),
        _ if all => "what happened".to_owned(),
        many => format!("what happened, the last of {many}"),
    }
}

/// The events, broken into lines that fit.
fn lines(state: &WorldState, wide: f64, high: f64) -> Vec<(String, &'static str)> {
    let mut lines = Vec::new();
    for happened in &state.events {
        let color = match happened.event {
            Event::PickedUp { .. } | Event::Dropped { .. } => INK,
            _ => WARM,
        };
        let mut line = String::new();
        for word in happened.to_string().split(' ') {
            let longer = format!("{line}{}{word}", if line.is_empty() { "" } else { " " });
            if line.is_empty() || width(&longer, high) <= wide {
                line = longer;
            } else {
                lines.push((line, color));
                line = format!("   {word}");
            }
        }
        lines.push((line, color));
    }
    lines
}

/// Below the views.
pub(super) fn figures(state: &WorldState, at: Point, unit: f64) -> String {
    let mut svg = String::new();
    let mut x = at.x;
    for (name, figure) in &facts(state) {
        let name_at = lettering(name, Anchor::Left, x, at.y + 6.0 * unit, 1.7 * unit);
        let figure_at = lettering(figure, Anchor::Left, x, at.y + 11.2 * unit, 2.6 * unit);
        let _ = writeln!(
            svg,
            r#"<g stroke="{MUTED}" stroke-width=".75">{name_at}<g stroke="{INK}">{figure_at}</g></g>"#
        );
        x += width(name, 1.7 * unit).max(width(figure, 2.6 * unit)) + 7.0 * unit;
    }
    svg
}

fn facts(state: &WorldState) -> Vec<(&'static str, String)> {
    let mut facts = Vec::new();
    if let Some(arm) = &state.arm {
        facts.push((
            "x, y, z",
            format!("{:.1}, {:.1}, {:.1} mm", arm.x_mm, arm.y_mm, arm.z_mm),
        ));
        facts.push(("turn", format!("{:.1}\u{b0}", arm.rotation_deg)));
        facts.push(("tip above the table", format!("{:.1} mm", arm.tip_mm)));
    }
    if !state.strokes.is_empty() {
        facts.push(("ink", format!("{:.0} mm", ink_mm(&state.strokes))));
        facts.push(("strokes", state.strokes.len().to_string()));
    }
    if !state.burns.is_empty() || !state.holes.is_empty() {
        let burned: f64 = state.burns.iter().map(|it| length_mm(&it.points_mm)).sum();
        facts.push(("burned", format!("{burned:.0} mm")));
        facts.push(("holes", state.holes.len().to_string()));
    }
    if !state.objects.is_empty() {
        facts.push(("objects", state.objects.len().to_string()));
    }
    facts
}
