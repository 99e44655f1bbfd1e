//! The world around an arm: what its tool touches, marks, lifts and runs into.
//!
//! [`World`] is an engine without a clock: it is told where the joints truly are and what acts at
//! the tool, and keeps what comes of it. Its physics is simple and the same every time:
//!
//! - Nothing has inertia, and nothing slides, tips over or rolls: what is let go falls straight down
//!   to the highest upper face below it, and stays there however little of it is supported.
//! - What stands on an object that is lifted is lifted with it.
//! - What is run into stays where it is; that is told as an event.
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
    /// Where the arm was last, and when; nothing before it was told first.
    arm: Option<ArmMoment>,
    grip: Grip,
    /// The object that was last found too heavy or not under the cup, until the tool is elsewhere.
    refused: Option<usize>,
    /// How far apart the fingers were when they began to close.
    closing_from_mm: f64,
    /// How far apart the fingers are at least: as far as what they hold is wide.
    held_mm: f64,
    ink: Ink,
    burns: Burns,
    contacts: Contacts,
    /// Pen or laser mark the table beside the paper.
    off_paper: bool,
    lost: bool,
    untold: VecDeque<Happened>,
    log: VecDeque<Happened>,
    event_count: u64,
}

/// What acts at the tool.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Actuators {
    /// Whether the pump runs.
    pub pump: bool,
    /// Whether the laser is on.
    pub laser: bool,
    /// The angle of the gripper's servo; 0 is open, 90 is closed.
    pub gripper_deg: f64,
}

impl World {
    /// The world of a scene, before the arm is switched on.
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
            untold: VecDeque::new(),
            log: VecDeque::new(),
            event_count: 0,
        }
    }

    /// Takes where the joints truly are at a time, and what acted at the tool on the way there.
    ///
    /// Between two calls the joints turn evenly: a call every 20 ms, the control tick, makes that
    /// exact enough. Time does not go back. Angles that are not numbers are told as
    /// [`Event::Lost`] and leave the arm where it was.
    pub fn handle_arm(&mut self, at: Duration, joints: &Joints, actuators: Actuators) {
        let to = ArmMoment {
            at,
            joints: *joints,
            actuators,
            tip: Tip::of(joints, &self.scene.tool),
        };
        let lost = !to.is_somewhere();
        if lost && !self.lost {
            self.tell(at, Event::Lost);
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
        let pieces = from.pieces(&to);
        let mut last = from;
        for piece in 1..=pieces {
            let next = from.towards(&to, piece, pieces, &self.scene.tool);
            self.advance(&last, &next);
            last = next;
        }
        self.arm = Some(to);
    }

    /// What happened since the last call, in its order; of the events that are not asked for, the last 100 are
    /// kept.
    pub fn poll_event(&mut self) -> Option<Happened> {
        self.untold.pop_front()
    }

    /// All that can be known of it.
    #[must_use]
    pub fn state(&self) -> WorldState {
        let name = |object: usize| self.scene.objects[object].name.clone();
        let power_w = match self.scene.tool.action {
            ToolAction::Laser { power_w, .. } => power_w,
            _ => 0.0,
        };
        WorldState {
            time_s: self.arm.map_or(0.0, |it| seconds(it.at)),
            arm: self.arm.map(|it| it.state(&self.scene.tool, self.held_mm)),
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

    /// Its picture, as the text of an SVG file.
    #[must_use]
    pub fn picture(&self) -> String {
        self.state().picture()
    }

    /// Goes a short way, on which everything changes evenly.
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
            self.tell(to.at, event);
        }
        self.mark(to.at, to.tip.at);
    }

    /// Something is marked; where there is paper it should be that.
    fn mark(&mut self, now: Duration, at: Point) {
        let off_paper = self.scene.paper.is_some_and(|paper| !paper.contains(at));
        if off_paper && !self.off_paper {
            let at_mm = rounded_place(at);
            self.tell(now, Event::OffPaper { at_mm });
        }
        self.off_paper = off_paper;
    }

    /// The suction cup holds what its whole face covers while the pump runs.
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
            self.tell(now.at, Event::DrawsAir { object, by_mm });
            return;
        }
        self.take(object, now);
    }

    /// The highest object that the cup touches with some part, and how far inside its middle is.
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

    /// The fingers hold what they close on, and let go where they open.
    fn grasp(&mut self, from: &ArmMoment, to: &ArmMoment) {
        let tool = self.scene.tool;
        let [from_mm, to_mm] = [from, to].map(|it| tool.opening_mm(it.actuators.gripper_deg));
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

    /// The highest object that stood between the fingers before they closed and is as wide now as
    /// they are apart.
    fn between_the_fingers(&self, tip: &Tip, [now_mm, before_mm]: [f64; 2]) -> Option<usize> {
        let across = direction(tip.turn_deg + 90.0);
        let middle = tip.at.to_vec2().dot(across);
        let objects = self.scene.objects.iter().enumerate();
        let caught = objects.filter(|(_, it)| {
            let footprint = it.footprint();
            let [right, left] = footprint.extent(across).map(|it| it - middle);
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
        self.tell(now.at, event);
    }

    fn release(&mut self, now: &ArmMoment) {
        self.refused = None;
        self.held_mm = 0.0;
        if let Some(event) = self.grip.release(&mut self.scene.objects) {
            self.tell(now.at, event);
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
            self.tell(now.at, event);
        }
    }

    fn tell(&mut self, at: Duration, event: Event) {
        let happened = Happened {
            at_s: seconds(at),
            event,
        };
        self.event_count += 1;
        for kept in [&mut self.untold, &mut self.log] {
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

/// For how long a laser may stand before that is told.
const DANGEROUS_S: f64 = 0.5;
/// How far a cup may stand over an edge, or a finger be off, and still hold: nothing but rounding.
const SEALS_MM: f64 = 0.05;
/// How many events are kept.
const KEPT_EVENTS: usize = 100;
