//! The objects that the tool holds.

use dobot_geometry::{Vec2, direction};

use super::Event;
use super::object::{Object, TOUCHING_MM};
use super::place::rounded;
use super::tip::Tip;

/// The objects that move with the tool.
#[derive(Clone, Debug, Default)]
pub(crate) struct Grip {
    /// The object in the grip first, then all that stands on it.
    held: Vec<HeldObject>,
}

/// An object and where it is as seen from the tip.
#[derive(Clone, Copy, Debug)]
struct HeldObject {
    object: usize,
    offset: Vec2,
    turn_deg: f64,
    bottom_mm: f64,
}

impl Grip {
    pub(crate) fn is_empty(&self) -> bool {
        self.held.is_empty()
    }

    /// The object in the grip.
    pub(crate) fn object(&self) -> Option<usize> {
        self.held.first().map(|it| it.object)
    }

    pub(crate) fn holds(&self, object: usize) -> bool {
        self.held.iter().any(|it| it.object == object)
    }

    /// All that moves with the tool.
    pub(crate) fn objects(&self) -> impl Iterator<Item = usize> {
        self.held.iter().map(|it| it.object)
    }

    /// Takes hold of an object where it stands, and of all that stands on it; too heavy a load
    /// stays where it is.
    pub(crate) fn take(
        &mut self,
        object: usize,
        objects: &[Object],
        tip: &Tip,
        lifts_g: f64,
    ) -> Event {
        let load = load(object, objects);
        let mass_g: f64 = load.iter().map(|it| objects[*it].mass_g).sum();
        let name = objects[object].name.clone();
        if mass_g > lifts_g {
            return Event::TooHeavy {
                object: name,
                mass_g: rounded(mass_g),
                lifts_g,
            };
        }
        self.held = load.iter().map(|it| held(*it, objects, tip)).collect();
        Event::PickedUp {
            object: name,
            with: load.len() - 1,
        }
    }

    /// Moves all that is held to where the tip is now.
    pub(crate) fn carry(&self, objects: &mut [Object], tip: &Tip) {
        for held in &self.held {
            let object = &mut objects[held.object];
            object.at_mm = tip.at + held.offset.rotate_scale(direction(tip.turn_deg));
            object.turn_deg = (held.turn_deg + tip.turn_deg).rem_euclid(360.0);
            object.bottom_mm = held.bottom_mm + tip.height_mm;
        }
    }

    /// Lets go: everything falls straight down to what is below it.
    pub(crate) fn release(&mut self, objects: &mut [Object]) -> Option<Event> {
        let first = self.object()?;
        let mut falling: Vec<usize> = self.held.drain(..).map(|it| it.object).collect();
        falling.sort_by(|a, b| objects[*a].bottom_mm.total_cmp(&objects[*b].bottom_mm));
        let mut event = None;
        for object in falling {
            let (onto, rests_mm) = support(object, objects);
            let fell_mm = objects[object].bottom_mm - rests_mm;
            objects[object].bottom_mm = rests_mm;
            if object == first {
                event = Some(Event::Dropped {
                    object: objects[object].name.clone(),
                    onto: onto
                        .map_or_else(|| "the table".to_owned(), |it| objects[it].name.clone()),
                    fell_mm: rounded(fell_mm),
                });
            }
        }
        event
    }
}

fn held(object: usize, objects: &[Object], tip: &Tip) -> HeldObject {
    let it = &objects[object];
    HeldObject {
        object,
        offset: (it.at_mm - tip.at).rotate_scale(direction(-tip.turn_deg)),
        turn_deg: it.turn_deg - tip.turn_deg,
        bottom_mm: it.bottom_mm - tip.height_mm,
    }
}

/// The object and all that stands on it, directly or not.
fn load(object: usize, objects: &[Object]) -> Vec<usize> {
    let mut load = vec![object];
    let mut next = 0;
    while next < load.len() {
        let below = load[next];
        for (i, it) in objects.iter().enumerate() {
            if !load.contains(&i) && it.stands_on(&objects[below]) {
                load.push(i);
            }
        }
        next += 1;
    }
    load
}

/// What an object that falls comes to rest on, and how high that is: the highest upper face below
/// it. One that was pressed into another comes to rest on it, if not deeper than half its height.
fn support(object: usize, objects: &[Object]) -> (Option<usize>, f64) {
    let it = &objects[object];
    let footprint = it.footprint();
    let from_mm = it.bottom_mm + it.height_mm() / 2.0 + TOUCHING_MM;
    let below = objects.iter().enumerate().filter(|(i, other)| {
        *i != object && other.top_mm() <= from_mm && footprint.overlaps(&other.footprint())
    });
    let highest = below.max_by(|(_, a), (_, b)| a.top_mm().total_cmp(&b.top_mm()));
    match highest {
        Some((i, other)) if other.top_mm() > 0.0 => (Some(i), other.top_mm()),
        _ => (None, 0.0),
    }
}
