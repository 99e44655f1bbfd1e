//! The world around an arm: what its tool touches, marks, lifts and runs into.
//!
//! [`World`] is an engine without a clock. It receives the true joint angles and the actuators of the
//! tool, and updates its state. Its physics is simple and deterministic:
//!
//! - Nothing has inertia, and nothing slides, tips over or rolls: a released object falls straight down
//!   to the highest upper face below it, and stays there even if hardly supported.
//! - Objects on top of a lifted object are lifted with it.
//! - An object hit by the tool stays in place; the collision is reported as an event.
//! - Pen and laser mark the plane of the table, and of the paper on it, not the objects.
//!
//! ```
//! use std::time::Duration;
//! use dobot_arm::{Pose, Position, Tool, inverse};
//! use dobot_sim::world::{Actuators, Point, Scene, World};
//!
//! let mut world = World::new(Scene::parse("[pen]\ndown_z_mm = -40")?);
//! for (ms, x_mm, z_mm) in [(0, 200.0, -40.0), (500, 210.0, -40.0), (600, 210.0, -30.0)] {
//!     let position = Position::new(x_mm, 0.0, z_mm);
//!     let joints = inverse(&Pose { position, ..Pose::default() }, Tool::SuctionCup)?;
//!     world.handle_arm(Duration::from_millis(ms), &joints, Actuators::default());
//! }
//! let drawn = &world.state().strokes[0].points_mm;
//! assert_eq!(drawn[0], Point::new(200.0, 0.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod color;
mod contact;
mod event;
mod footprint;
mod grip;
mod marks;
mod moment;
mod object;
mod picture;
mod place;
mod scene;
mod state;
mod tip;
mod tool;
mod track;

use std::collections::VecDeque;
use std::time::Duration;

use dobot_arm::Joints;
use dobot_geometry::direction;

use self::contact::{Contacts, Scenery};
use self::grip::Grip;
use self::marks::{Burns, Ink};
use self::moment::ArmMoment;
use self::place::{rounded, rounded_place};
use self::tip::Tip;

pub use self::event::{Event, Happened};
pub use self::marks::{Burn, Hole, Stroke};
pub use self::object::{Object, Shape};
pub use self::scene::{Paper, Scene, SceneError};
pub use self::state::{ArmState, WorldState};
pub use self::tool::{Tool, ToolAction};
pub use dobot_geometry::Point;

/// The world around an arm.
#[derive(Clone, Debug)]
pub struct World {
    scene: Scene,
    /// The last state of the arm with its time; `None` before the first.
    arm: Option<ArmMoment>,
    grip: Grip,
    /// The object last found too heavy or not covered by the cup, until the tool moves away.
    refused: Option<usize>,
    /// The opening of the fingers when they began to close.
    closing_from_mm: f64,
    /// The minimum opening of the fingers: the width of the held object.
    held_mm: f64,
    ink: Ink,
    burns: Burns,
    contacts: Contacts,
    /// Whether pen or laser mark the table beside the paper.
    off_paper: bool,
    lost: bool,
    unreported: VecDeque<Happened>,
    log: VecDeque<Happened>,
    event_count: u64,
}

/// The actuators of the tool.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Actuators {
    /// Whether the pump is on.
    pub pump: bool,
    /// Whether the laser is on.
    pub laser: bool,
    /// The angle of the gripper's servo; 0 is open, 90 is closed.
    pub gripper_deg: f64,
}

impl World {
    /// Creates the world of a scene, before power-up of the arm.
    #[must_use]
    pub fn new(scene: Scene) -> Self {
        Self {
            scene,
            arm: None,
            grip: Grip::default(),
            refused: None,
            closing_from_mm: 0.0,
            held_mm: 0.0,
            ink: Ink::default(),
            burns: Burns::default(),
            contacts: Contacts::default(),
            off_paper: false,
            lost: false,
            unreported: VecDeque::new(),
            log: VecDeque::new(),
            event_count: 0,
        }
    }

    /// Handles the true joint angles at a time and the actuators since the last call.
    ///
    /// Joints are interpolated linearly between two calls; one call per 20 ms control tick is accurate
    /// enough. Time must not decrease. NaN angles are reported as [`Event::Lost`] and leave the arm
    /// in place.
    pub fn handle_arm(&mut self, at: Duration, joints: &Joints, actuators: Actuators) {
        let to = ArmMoment {
            at,
            joints: *joints,
            actuators,
            tip: Tip::of(joints, &self.scene.tool),
        };
        let lost = !to.is_somewhere();
        if lost && !self.lost {
            self.report(at, Event::Lost);
        }
        self.lost = lost;
        if lost {
            return;
        }
        let from = self.arm.unwrap_or(to);
        if self.arm.is_some() && !from.changes(&to) {
            self.arm = Some(to);
            return;
        }
        self.advance_in_pieces(&from, &to);
        self.arm = Some(to);
    }

    fn advance_in_pieces(&mut self, from: &ArmMoment, to: &ArmMoment) {
        let pieces = from.pieces(to);
        let mut last = *from;
        for piece in 1..=pieces {
            let next = from.towards(to, piece, pieces, &self.scene.tool);
            self.advance(&last, &next);
            last = next;
        }
    }

    /// Takes the events since the last call in order; at most the last 100 are kept.
    pub fn poll_event(&mut self) -> Option<Happened> {
        self.unreported.pop_front()
    }

    /// The complete state.
    #[must_use]
    pub fn state(&self) -> WorldState {
        let name = |object: usize| self.scene.objects[object].name.clone();
        let power_w = match self.scene.tool.action {
            ToolAction::Laser { power_w, .. } => power_w,
            _ => 0.0,
        };
        WorldState {
            time_s: self.arm.map_or(0.0, |arm| seconds(arm.at)),
            arm: self
                .arm
                .map(|arm| arm.state(&self.scene.tool, self.held_mm)),
            tool: self.scene.tool,
            table_z_mm: self.scene.table_z_mm,
            paper: self.scene.paper,
            objects: self.scene.objects.iter().map(Object::rounded).collect(),
            held: self.grip.objects().map(name).collect(),
            strokes: self.ink.strokes(),
            burns: self.burns.burns(power_w),
            holes: self.burns.holes(),
            event_count: self.event_count,
            events: self.log.iter().cloned().collect(),
        }
    }

    /// Returns a picture as the text of an SVG file.
    #[must_use]
    pub fn picture(&self) -> String {
        self.state().picture()
    }

    /// Handles a short linear step.
    fn advance(&mut self, from: &ArmMoment, to: &ArmMoment) {
        self.grip.carry(&mut self.scene.objects, &to.tip);
        match self.scene.tool.action {
            ToolAction::Pen { .. } => self.draw(from, to),
            ToolAction::Laser {
                focus_mm,
                depth_mm,
                power_w,
            } => {
                let off_focus_mm = (to.tip.height_mm - focus_mm).abs();
                let power_w = (to.actuators.laser && off_focus_mm <= depth_mm).then_some(power_w);
                self.burn(from, to, power_w);
            }
            ToolAction::SuctionCup { diameter_mm, .. } => self.suck(to, diameter_mm / 2.0),
            ToolAction::Gripper { .. } => self.grasp(from, to),
        }
        self.touch(to);
    }

    fn draw(&mut self, from: &ArmMoment, to: &ArmMoment) {
        match self.ink.draw(&from.tip, &to.tip) {
            Some(at) => self.mark(to.at, at),
            None => self.off_paper = false,
        }
    }

    fn burn(&mut self, from: &ArmMoment, to: &ArmMoment, power_w: Option<f64>) {
        let Some(power_w) = power_w else {
            self.burns.stop();
            self.off_paper = false;
            return;
        };
        let time_s = to.at.saturating_sub(from.at).as_secs_f64();
        let grown = self.burns.burn(from.tip.at, to.tip.at, time_s, power_w);
        if let Some((hole, before_s)) = grown
            && before_s < DANGEROUS_S
            && hole.time_s >= DANGEROUS_S
        {
            let event = Event::BurnsOnTheSpot {
                at_mm: rounded_place(hole.at_mm),
                time_s: rounded(hole.time_s),
            };
            self.report(to.at, event);
        }
        self.mark(to.at, to.tip.at);
    }

    /// Reports marks beside the paper, if there is paper.
    fn mark(&mut self, now: Duration, at: Point) {
        let off_paper = self.scene.paper.is_some_and(|paper| !paper.contains(at));
        if off_paper && !self.off_paper {
            let at_mm = rounded_place(at);
            self.report(now, Event::OffPaper { at_mm });
        }
        self.off_paper = off_paper;
    }

    /// Handles the suction cup: it holds an object that its whole face covers while the pump is on.
    fn suck(&mut self, now: &ArmMoment, radius_mm: f64) {
        if !now.actuators.pump {
            self.release(now);
            return;
        }
        if !self.grip.is_empty() {
            return;
        }
        let Some((object, margin_mm)) = self.under_the_cup(&now.tip, radius_mm) else {
            self.refused = None;
            return;
        };
        if self.refused == Some(object) {
            return;
        }
        let by_mm = radius_mm - margin_mm;
        if by_mm > SEALS_MM {
            self.refused = Some(object);
            let object = self.scene.objects[object].name.clone();
            let by_mm = rounded(by_mm);
            self.report(now.at, Event::DrawsAir { object, by_mm });
            return;
        }
        self.take(object, now);
    }

    /// The highest object that the cup touches, and the distance of its centre from the edge.
    fn under_the_cup(&self, tip: &Tip, radius_mm: f64) -> Option<(usize, f64)> {
        let give_mm = self.scene.tool.give_mm;
        let objects = self.scene.objects.iter().enumerate();
        let touched = objects.filter_map(|(i, it)| {
            let near = (it.top_mm() - tip.height_mm).abs() <= give_mm;
            let margin_mm = it.footprint().margin_mm(tip.at);
            (near && margin_mm > -radius_mm).then_some((i, margin_mm))
        });
        touched.max_by(|(a, _), (b, _)| {
            let top_mm = |it: usize| self.scene.objects[it].top_mm();
            top_mm(*a).total_cmp(&top_mm(*b))
        })
    }

    /// Handles the gripper: the fingers hold what they close on and release it when they open.
    fn grasp(&mut self, from: &ArmMoment, to: &ArmMoment) {
        let tool = self.scene.tool;
        let [from_mm, to_mm] = [from, to].map(|arm| tool.opening_mm(arm.actuators.gripper_deg));
        if to_mm > from_mm {
            self.refused = None;
            self.release(to);
        }
        if to_mm >= from_mm {
            self.closing_from_mm = to_mm;
            return;
        }
        if !self.grip.is_empty() {
            return;
        }
        let fingers = [to_mm, self.closing_from_mm];
        if let Some(object) = self.between_the_fingers(&to.tip, fingers)
            && self.refused != Some(object)
        {
            self.take(object, to);
            self.held_mm = if self.grip.is_empty() { 0.0 } else { to_mm };
        }
    }

    /// The highest object between the closing fingers whose width matches their opening.
    fn between_the_fingers(&self, tip: &Tip, [now_mm, before_mm]: [f64; 2]) -> Option<usize> {
        let across = direction(tip.turn_deg + 90.0);
        let middle = tip.at.to_vec2().dot(across);
        let objects = self.scene.objects.iter().enumerate();
        let caught = objects.filter(|(_, it)| {
            let footprint = it.footprint();
            let [right, left] = footprint.extent(across).map(|edge| edge - middle);
            let beside = (it.bottom_mm..it.top_mm()).contains(&(tip.height_mm.max(0.0)));
            let between = right.abs().max(left.abs()) <= before_mm / 2.0 + SEALS_MM;
            beside && between && left - right >= now_mm && footprint.margin_mm(tip.at) > 0.0
        });
        let highest = caught.max_by(|(_, a), (_, b)| a.top_mm().total_cmp(&b.top_mm()));
        highest.map(|(i, _)| i)
    }

    fn take(&mut self, object: usize, now: &ArmMoment) {
        let lifts_g = self.scene.tool.lifts_g();
        let event = self
            .grip
            .take(object, &self.scene.objects, &now.tip, lifts_g);
        self.refused = self.grip.is_empty().then_some(object);
        self.report(now.at, event);
    }

    fn release(&mut self, now: &ArmMoment) {
        self.refused = None;
        self.held_mm = 0.0;
        if let Some(event) = self.grip.release(&mut self.scene.objects) {
            self.report(now.at, event);
        }
    }

    fn touch(&mut self, now: &ArmMoment) {
        let mut events = Vec::new();
        let scenery = Scenery {
            tool: &self.scene.tool,
            paper: self.scene.paper.as_ref(),
            objects: &self.scene.objects,
            grip: &self.grip,
            tip: &now.tip,
            opening_mm: self
                .scene
                .tool
                .opening_mm(now.actuators.gripper_deg)
                .max(self.held_mm),
        };
        self.contacts.look(&scenery, |event| events.push(event));
        for event in events {
            self.report(now.at, event);
        }
    }

    fn report(&mut self, at: Duration, event: Event) {
        let happened = Happened {
            at_s: seconds(at),
            event,
        };
        self.event_count += 1;
        for kept in [&mut self.unreported, &mut self.log] {
            if kept.len() == KEPT_EVENTS {
                kept.pop_front();
            }
            kept.push_back(happened.clone());
        }
    }
}

fn seconds(time: Duration) -> f64 {
    rounded(time.as_secs_f64())
}

/// The time for which a laser may stand before it is reported.
const DANGEROUS_S: f64 = 0.5;
/// The tolerance of cup and fingers for rounding.
const SEALS_MM: f64 = 0.05;
/// The number of events kept.
const KEPT_EVENTS: usize = 100;
