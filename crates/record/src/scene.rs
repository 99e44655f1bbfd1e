//! The scene around the arm: the targets of its commands, and the ink of its tool.

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

/// A sans-IO scene: commands and statuses in, scene updates out. Empty while the dialect, and with
/// it the meaning of commands, is unknown.
#[derive(Debug, Default)]
pub(crate) struct Scene {
    frames: Frames,
    observer: Option<Observer>,
    /// The current height below which a pen draws.
    pen_below_mm: Option<f64>,
    /// That height for each in-flight command, when it was sent.
    sent_below_mm: VecDeque<Option<f64>>,
    target: Target,
    ink: Ink,
    /// The last known tool.
    tool: Tool,
}

impl Scene {
    /// Starts over for another arm.
    pub(crate) fn set_dialect(&mut self, dialect: Option<Dialect>) {
        self.observer = dialect.map(Observer::new);
        self.sent_below_mm.clear();
        self.ink.end_line();
        self.target.note_change();
    }

    /// Sets the lengths of the tools.
    pub(crate) fn set_tools(&mut self, tools: &[MountedTool]) {
        self.frames.set_tools(tools);
    }

    /// Sets the height below which a pen draws.
    pub(crate) const fn set_pen(&mut self, below_mm: Option<f64>) {
        self.pen_below_mm = below_mm;
    }

    /// Handles a command to the arm.
    pub(crate) fn handle_sent(&mut self, at: Duration, command: &Command) {
        let Some(observer) = &mut self.observer else {
            return;
        };
        observer.handle_sent(at, command);
        self.sent_below_mm
            .resize(observer.waiting_for(), self.pen_below_mm);
        self.target.note_change();
    }

    /// Handles a status.
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

    /// The changes: topics and their messages.
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

    /// The transforms of the links of the arm for a status.
    pub(crate) fn transforms(&mut self, status: &Status, time: &Value) -> Value {
        self.frames.transforms(status, self.tool, time)
    }

    /// Requests another report of the target, for late subscribers.
    pub(crate) const fn report_again(&mut self) {
        self.target.report_again();
    }

    /// The reported ink, for a late subscriber: messages of its topic.
    pub(crate) fn ink_so_far(&self, time: &Value) -> Vec<Value> {
        let tip_mm = self.frames.length_mm(self.tool);
        self.ink.so_far(time, tip_mm)
    }
}

/// An entity with an id; it stays until it is deleted or replaced.
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

/// The deletion of the entity with this id.
pub(crate) fn removal(time: &Value, id: &str) -> Value {
    json!({ "timestamp": time, "type": MATCHING_ID, "id": id })
}

/// A line through places, with a thickness in metres.
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

/// A sphere of this diameter in metres.
pub(crate) fn sphere(at: &Value, size_m: f64, color: &Value) -> Value {
    json!({
        "pose": pose(at),
        "size": { "x": size_m, "y": size_m, "z": size_m },
        "color": color,
    })
}

/// The places of a tip this far below these, in metres.
pub(crate) fn points(places: &[Position], tip_mm: f64) -> Vec<Value> {
    let point = |position: &Position| {
        let [x, y, z] = [position.x.0, position.y.0, position.z.0 - tip_mm].map(metres);
        json!({ "x": x, "y": y, "z": z })
    };
    places.iter().map(point).collect()
}

/// A colour of three bytes, red first, as fractions of 1.
pub(crate) fn color(rgb: u32) -> Value {
    let [_, r, g, b] = rgb.to_be_bytes().map(|byte| f64::from(byte) / 255.0);
    let [r, g, b] = [r, g, b].map(|value| (value * 1000.0).round() / 1000.0);
    json!({ "r": r, "g": g, "b": b, "a": 1.0 })
}

fn pose(at: &Value) -> Value {
    json!({
        "position": at,
        "orientation": { "x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0 },
    })
}

/// Deletes the entity with exactly this id.
const MATCHING_ID: u8 = 0;
/// Each point is joined with the next one.
const LINE_STRIP: u8 = 0;
