//! Title, figures and what happened.

use dobot_lettering::{Anchor, Rectangle, Sheet, TextStyle};

use super::{INK, MUTED, WARM};
use crate::world::marks::{WRITES_MM, ink_mm};
use crate::world::track::length_mm;
use crate::world::{Event, ToolAction, WorldState};

/// Above the views: what it is on the left, what the tool is about on the right.
pub(super) fn head(sheet: &mut Sheet, state: &WorldState, top: &Rectangle, unit: f64) {
    let y = top.top - 4.5 * unit;
    let title = format!("the world at {:.2} s", state.time_s);
    let kind = TextStyle::new(3.6 * unit, INK);
    sheet.text([top.left, y], Anchor::Left, &kind, &title);
    let kind = TextStyle::new(1.9 * unit, MUTED);
    sheet.text([top.right(), y], Anchor::Right, &kind, &doing(state));
}

fn doing(state: &WorldState) -> String {
    let name = state.tool.tool().label();
    let Some(arm) = &state.arm else {
        return name.to_owned();
    };
    let doing = match (state.tool.action, state.held.first()) {
        (_, Some(held)) => format!("holds {held}"),
        (ToolAction::Pen { .. }, _) if arm.tip_mm <= WRITES_MM => "down".to_owned(),
        (ToolAction::Pen { .. }, _) => "up".to_owned(),
        (ToolAction::Laser { .. }, _) if arm.laser => "on".to_owned(),
        (ToolAction::Laser { .. }, _) => "off".to_owned(),
        (ToolAction::SuctionCup { .. }, _) if arm.pump => "pump on".to_owned(),
        (ToolAction::SuctionCup { .. }, _) => "pump off".to_owned(),
        (ToolAction::Gripper { .. }, _) => format!("{:.1} mm open", arm.opening_mm),
    };
    format!("{name}, {doing}")
}

/// What happened last, the latest at the bottom.
pub(super) fn log(sheet: &mut Sheet, state: &WorldState, frame: &Rectangle, unit: f64) {
    let (x, high, step) = (frame.left + 3.0 * unit, 1.45 * unit, 3.3 * unit);
    let lines = lines(state, frame.width - 6.0 * unit, high);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a few dozen lines"
    )]
    let room = ((frame.height - 9.0 * unit) / step).clamp(1.0, 60.0) as usize;
    let cut = lines.len().saturating_sub(room);
    let all = cut == 0 && state.events.len() as u64 == state.event_count;
    let headline = headline(state.event_count, all);
    let mut y = frame.top + 4.4 * unit;
    sheet.text(
        [x, y],
        Anchor::Left,
        &TextStyle::new(high, MUTED),
        &headline,
    );
    y += 4.2 * unit;
    for (text, color) in &lines[cut..] {
        sheet.text([x, y], Anchor::Left, &TextStyle::new(high, color), text);
        y += step;
    }
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
            if line.is_empty() || dobot_lettering::width(&longer, high) <= wide {
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

/// The text below the views.
pub(super) fn facts(state: &WorldState) -> Vec<(&'static str, String)> {
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
