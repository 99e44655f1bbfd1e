//! What is to be seen around the arm: where its commands lead, and what its tool has drawn.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_arm::{Position, Tool};
use dobot_model::MountedTool;
use dobot_motion::Model;
use dobot_session::Observer;
use dobot_wire::{Command, Dialect, Status};
use serde_json::{Value, json};

use crate::frames::{BASE, Frames, metres};
use crate::ink::Ink;
use crate::target::Target;
use crate::topic::{INK, TARGET};

/// What is to be seen around the arm: an engine, commands and statuses in, scenes out. While nobody knows the dialect,
/// nobody knows where commands lead, and there is nothing.
#[derive(Debug, Default)]
pub(crate) struct Scene {
    frames: Frames,
    observer: Option<Observer>,
    /// Below which height of the tool a pen draws now.
    pen_below_mm: Option<f64>,
    /// The same when each of the commands was sent that are not over.
    sent_below_mm: VecDeque<Option<f64>>,
    target: Target,
    ink: Ink,
    /// What was mounted when it was seen last.
    tool: Tool,
}

impl Scene {
    /// From here on it may be another arm.
    pub(crate) fn set_dialect(&mut self, dialect: Option<Dialect>) {
        self.observer = dialect.map(Observer::new);
        self.sent_below_mm.clear();
        self.ink.end_line();
        self.target.note_change();
    }

    /// Takes how long each tool is.
    pub(crate) fn set_tools(&mut self, tools: &[MountedTool]) {
        self.frames.set_tools(tools);
    }

    /// Takes below which height of the tool a pen draws.
    pub(crate) const fn set_pen(&mut self, below_mm: Option<f64>) {
        self.pen_below_mm = below_mm;
    }

    /// Takes a command that leaves for the arm.
    pub(crate) fn handle_sent(&mut self, at: Duration, command: &Command) {
        let Some(observer) = &mut self.observer else {
            return;
        };
        observer.handle_sent(at, command);
        self.sent_below_mm
            .resize(observer.waiting_for(), self.pen_below_mm);
        self.target.note_change();
    }

    /// Takes a status.
    pub(crate) fn handle_status(&mut self, at: Duration, status: &Status) {
        let Some(observer) = &mut self.observer else {
            self.tool = Model::new(Dialect::SPECIFICATION, status).tool;
            return;
        };
        for over in observer.handle_status(at, status) {
            let below_mm = self.sent_below_mm.pop_front().flatten();
            let is_vector = matches!(over.command, Command::WriteVector(_));
            match over.way {
                Some(way) => self.ink.draw(at, &way, is_vector, below_mm),
                None => self.ink.end_line(),
            }
            self.target.note_change();
        }
        self.ink.handle_time(at);
        self.tool = observer.model().map_or(self.tool, |model| model.tool);
    }

    /// What is news by now: each a topic and its message.
    pub(crate) fn poll(
        &mut self,
        at: Duration,
        time: &Value,
    ) -> impl Iterator<Item = (&'static str, Value)> + use<> {
        let tip_mm = self.frames.length_mm(self.tool);
        let ways = self.observer.iter().flat_map(Observer::in_flight);
        let target = self.target.poll(at, time, ways, tip_mm);
        let ink = self.ink.poll(time, tip_mm);
        let target = target.map(|target| (TARGET, target));
        target.into_iter().chain(ink.map(|ink| (INK, ink)))
    }

    /// Where each link of the arm is that a status tells.
    pub(crate) fn transforms(&mut self, status: &Status, time: &Value) -> Value {
        self.frames.transforms(status, self.tool, time)
    }

    /// The target is told again, for those who come late.
    pub(crate) const fn tell_again(&mut self) {
        self.target.tell_again();
    }

    /// The ink that was told, for one who comes late: messages of its topic.
    pub(crate) fn ink_so_far(&self, time: &Value) -> Vec<Value> {
        let tip_mm = self.frames.length_mm(self.tool);
        self.ink.so_far(time, tip_mm)
    }
}

/// Something to be seen, under a name of its own; it stays until it is removed or another one has its name.
pub(crate) fn entity(time: &Value, id: &str, lines: &[Value], spheres: &[Value]) -> Value {
    json!({
        "timestamp": time,
        "frame_id": BASE,
        "id": id,
        "lifetime": { "sec": 0, "nsec": 0 },
        "frame_locked": true,
        "metadata": [],
        "arrows": [],
        "cubes": [],
        "spheres": spheres,
        "cylinders": [],
        "lines": lines,
        "triangles": [],
        "texts": [],
        "models": [],
    })
}

/// Takes back what has this name.
pub(crate) fn removal(time: &Value, id: &str) -> Value {
    json!({ "timestamp": time, "type": MATCHING_ID, "id": id })
}

/// A line through places, so thick in metres.
pub(crate) fn line(points: &[Value], thickness_m: f64, color: &Value) -> Value {
    json!({
        "type": LINE_STRIP,
        "pose": pose(&json!({ "x": 0.0, "y": 0.0, "z": 0.0 })),
        "thickness": thickness_m,
        "scale_invariant": false,
        "points": points,
        "color": color,
        "colors": [],
        "indices": [],
    })
}

/// A ball of that diameter in metres.
pub(crate) fn sphere(at: &Value, size_m: f64, color: &Value) -> Value {
    json!({
        "pose": pose(at),
        "size": { "x": size_m, "y": size_m, "z": size_m },
        "color": color,
    })
}

/// The places of a tip that hangs so far below these, in metres.
pub(crate) fn points(places: &[Position], tip_mm: f64) -> Vec<Value> {
    let point = |position: &Position| {
        let [x, y, z] = [position.x.0, position.y.0, position.z.0 - tip_mm].map(metres);
        json!({ "x": x, "y": y, "z": z })
    };
    places.iter().map(point).collect()
}

/// A colour of three bytes, red first, as parts of one.
pub(crate) fn color(rgb: u32) -> Value {
    let [_, r, g, b] = rgb.to_be_bytes().map(|it| f64::from(it) / 255.0);
    let [r, g, b] = [r, g, b].map(|value| (value * 1000.0).round() / 1000.0);
    json!({ "r": r, "g": g, "b": b, "a": 1.0 })
}

fn pose(at: &Value) -> Value {
    json!({
        "position": at,
        "orientation": { "x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0 },
    })
}

/// Takes back what has the name, and nothing else.
const MATCHING_ID: u8 = 0;
/// Each point is joined with the next one.
const LINE_STRIP: u8 = 0;
