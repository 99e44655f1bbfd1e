//! Contacts: the tool, or an object that it holds, is pressed into something.

use dobot_geometry::{Point, direction};

use super::grip::Grip;
use super::object::Object;
use super::place::{rounded, rounded_place};
use super::tip::Tip;
use super::{Event, Paper, Tool};

/// The contacts at present, and their depths when they were reported.
#[derive(Clone, Debug, Default)]
pub(crate) struct Contacts {
    reported: Vec<(Mover, Obstacle, f64)>,
}

/// What moves.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Mover {
    Tool,
    Object(usize),
}

/// What is in its way.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Obstacle {
    Table,
    Object(usize),
}

/// What may touch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scenery<'a> {
    pub(crate) tool: &'a Tool,
    pub(crate) paper: Option<&'a Paper>,
    pub(crate) objects: &'a [Object],
    pub(crate) grip: &'a Grip,
    pub(crate) tip: &'a Tip,
    /// How far the fingers are apart.
    pub(crate) opening_mm: f64,
}

impl Contacts {
    /// Finds the contacts, and reports those that are new or twice as deep as before.
    pub(crate) fn look(&mut self, scenery: &Scenery<'_>, mut report: impl FnMut(Event)) {
        let mut now = Vec::new();
        scenery.tool(&mut now);
        scenery.load(&mut now);
        now.retain(|(_, _, depth_mm)| *depth_mm > scenery.tool.give_mm);
        for contact in &mut now {
            let same = |it: &&(Mover, Obstacle, f64)| (it.0, it.1) == (contact.0, contact.1);
            match self.reported.iter().find(same) {
                Some(reported) if contact.2 < 2.0 * reported.2 => contact.2 = reported.2,
                _ => report(scenery.event(contact)),
            }
        }
        self.reported = now;
    }
}

impl Scenery<'_> {
    /// Where the tool ends: a gripper in two fingers.
    fn ends(&self) -> [Point; 2] {
        let across = direction(self.tip.turn_deg + 90.0) * (self.opening_mm / 2.0);
        [self.tip.at + across, self.tip.at - across]
    }

    fn tool(&self, contacts: &mut Vec<(Mover, Obstacle, f64)>) {
        contacts.push((Mover::Tool, Obstacle::Table, -self.tip.height_mm));
        for (i, object) in self.objects.iter().enumerate() {
            let depth_mm = object.top_mm() - self.tip.height_mm;
            if depth_mm <= 0.0 || self.grip.holds(i) {
                continue;
            }
            let footprint = object.footprint();
            if self
                .ends()
                .iter()
                .any(|it| footprint.margin_mm(*it) > AT_THE_EDGE_MM)
            {
                contacts.push((Mover::Tool, Obstacle::Object(i), depth_mm));
            }
        }
    }

    fn load(&self, contacts: &mut Vec<(Mover, Obstacle, f64)>) {
        for held in self.grip.objects() {
            let object = &self.objects[held];
            contacts.push((Mover::Object(held), Obstacle::Table, -object.bottom_mm));
            for (i, other) in self.objects.iter().enumerate() {
                if !self.grip.holds(i)
                    && let Some(depth_mm) = object.overlap_mm(other)
                {
                    contacts.push((Mover::Object(held), Obstacle::Object(i), depth_mm));
                }
            }
        }
    }

    fn event(&self, &(what, with, depth_mm): &(Mover, Obstacle, f64)) -> Event {
        let name = |object: usize| self.objects[object].name.clone();
        let what = match what {
            Mover::Tool => format!("the {}", self.tool.tool().label()),
            Mover::Object(object) => name(object),
        };
        let with = match with {
            Obstacle::Object(object) => name(object),
            Obstacle::Table if self.paper.is_some_and(|it| it.contains(self.tip.at)) => {
                "the paper".to_owned()
            }
            Obstacle::Table => "the table".to_owned(),
        };
        Event::Collided {
            what,
            with,
            depth_mm: rounded(depth_mm),
            at_mm: rounded_place(self.tip.at),
        }
    }
}

/// A finger that lies at a side touches it, but is not in it.
const AT_THE_EDGE_MM: f64 = 0.2;
