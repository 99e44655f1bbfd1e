//! Time slots: when the arm is reserved for a student.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_api::{SlotView, SlotsView, TimeSlot, is_fleet_name, is_same_person};

use crate::is_plain;
use crate::refusal::Refusal;

/// The current and upcoming slots, in order.
#[derive(Debug, Default)]
pub(super) struct Slots {
    /// None overlap; at most the first one is current.
    all: VecDeque<Slot>,
    /// The last time seen.
    now: Duration,
}

/// A slot, in the supervisor's time.
#[derive(Clone, Debug)]
struct Slot {
    student: String,
    group: Option<String>,
    from: Duration,
    until: Duration,
    /// Whether it is current.
    started: bool,
    /// Whether its student was warned that it ends soon.
    warned: bool,
}

/// A change of a slot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum SlotChange {
    Began { student: String, lasts: Duration },
    Ending { student: String, left: Duration },
    Ended { student: String },
}

/// A slot of another student.
#[derive(Clone, Copy, Debug)]
pub(super) struct OtherSlot<'a> {
    pub(super) student: &'a str,
    pub(super) group: Option<&'a str>,
    /// The remaining time.
    pub(super) left: Duration,
    /// The time until the arm is free: after all consecutive slots.
    pub(super) free_in: Duration,
}

impl Slots {
    /// Replaces the slots.
    ///
    /// # Errors
    ///
    /// [`Refusal::BadSlots`]; the old slots stay.
    pub(super) fn set(&mut self, now: Duration, slots: &[TimeSlot]) -> Result<(), Refusal> {
        let mut all = read(now, slots).map_err(Refusal::BadSlots)?;
        // A slot that continues in the new list causes no notice.
        let student = self.student();
        if let Some(first) = all.first_mut().filter(|first| first.from <= now) {
            first.started = student.is_some_and(|student| is_same_person(student, &first.student));
        }
        self.all = all.into();
        Ok(())
    }

    /// Advances the time: returns the next change of a slot.
    pub(super) fn poll_change(&mut self, now: Duration) -> Option<SlotChange> {
        self.now = now;
        self.drop_missed();
        let first = self.all.front_mut()?;
        let student = first.student.clone();
        let left = first.until.saturating_sub(now);
        if left.is_zero() {
            self.all.pop_front();
            return Some(SlotChange::Ended { student });
        }
        if !first.started && first.from <= now {
            first.started = true;
            return Some(SlotChange::Began {
                student,
                lasts: left,
            });
        }
        if first.started && !first.warned && left <= WARNING {
            first.warned = true;
            return Some(SlotChange::Ending { student, left });
        }
        None
    }

    /// Drops slots that were over before they could begin: they had no effect.
    fn drop_missed(&mut self) {
        let now = self.now;
        while self
            .all
            .front()
            .is_some_and(|slot| !slot.started && slot.until <= now)
        {
            self.all.pop_front();
        }
    }

    /// Returns when the next change is due.
    pub(super) fn wakeup(&self) -> Option<Duration> {
        let first = self.all.front()?;
        Some(if !first.started {
            first.from
        } else if first.warned {
            first.until
        } else {
            first.until.saturating_sub(WARNING)
        })
    }

    /// Returns the student of the current slot.
    pub(super) fn student(&self) -> Option<&str> {
        self.current().map(|current| current.student.as_str())
    }

    /// Returns the current slot, if slot is not this person's.
    pub(super) fn other_slot(&self, person: &str) -> Option<OtherSlot<'_>> {
        let slot = self.current()?;
        (!is_same_person(&slot.student, person)).then(|| OtherSlot {
            student: &slot.student,
            group: slot.group.as_deref(),
            left: slot.until.saturating_sub(self.now),
            free_in: self.free(slot.until).saturating_sub(self.now),
        })
    }

    /// Returns the current and upcoming slots, relative to now.
    pub(super) fn upcoming(&self, now: Duration) -> Vec<TimeSlot> {
        let from_now = |at: Duration| at.saturating_sub(now).as_secs_f64();
        let time_slot = |slot: &Slot| TimeSlot {
            student: slot.student.clone(),
            group: slot.group.clone(),
            starts_in_s: from_now(slot.from),
            ends_in_s: from_now(slot.until),
        };
        self.all.iter().map(time_slot).collect()
    }

    /// Returns the slots for observers.
    pub(super) fn view(&self) -> Option<SlotsView> {
        let now = self.current();
        let next = self.all.get(usize::from(now.is_some()));
        (!self.all.is_empty()).then(|| SlotsView {
            now: now.map(Slot::view),
            next: next.map(Slot::view),
            free_s: now.map(|now| self.free(now.until).as_secs_f64()),
        })
    }

    fn current(&self) -> Option<&Slot> {
        self.all.front().filter(|slot| slot.started)
    }

    /// Returns the end of the consecutive slots.
    fn free(&self, until: Duration) -> Duration {
        let later = self.all.iter().skip(1);
        later.fold(
            until,
            |free, slot| if slot.from <= free { slot.until } else { free },
        )
    }
}

impl Slot {
    fn view(&self) -> SlotView {
        SlotView {
            student: self.student.clone(),
            group: self.group.clone(),
            starts_s: self.from.as_secs_f64(),
            ends_s: self.until.as_secs_f64(),
        }
    }
}

/// Reads the slots in order, or returns what is wrong with them.
fn read(now: Duration, slots: &[TimeSlot]) -> Result<Vec<Slot>, String> {
    let (found, most) = (slots.len(), TimeSlot::MAX_COUNT);
    if found > most {
        return Err(format!("{found} slots; allowed are up to {most}"));
    }
    let mut all = Vec::with_capacity(found);
    for (index, slot) in slots.iter().enumerate() {
        let read = read_one(now, slot);
        all.push(read.map_err(|why| format!("slot {}: {why}", index + 1))?);
    }
    all.sort_by_key(|slot| slot.from);
    for (one, next) in all.iter().zip(all.iter().skip(1)) {
        if next.from < one.until {
            let describe = |slot: &Slot| {
                let s = |at: Duration| at.saturating_sub(now).as_secs_f64();
                let (from_s, until_s) = (s(slot.from), s(slot.until));
                format!("{} (from {from_s} s to {until_s} s)", slot.student)
            };
            let (one, next) = (describe(one), describe(next));
            return Err(format!(
                "the slots of {one} and {next} overlap; a slot may begin only when the one before has ended"
            ));
        }
    }
    Ok(all)
}

fn read_one(now: Duration, slot: &TimeSlot) -> Result<Slot, String> {
    let student = slot.student.trim();
    check_student(student)?;
    slot.group.as_deref().map_or(Ok(()), check_group)?;
    let (starts_s, ends_s, latest_s) = (slot.starts_in_s, slot.ends_in_s, TimeSlot::LONGEST_S);
    if !(0.0..=latest_s).contains(&starts_s) {
        return Err(format!(
            "starts_in_s of {student} is {starts_s}; allowed is 0 to {latest_s}"
        ));
    }
    if !(starts_s + SHORTEST_S..=latest_s).contains(&ends_s) {
        return Err(format!(
            "ends_in_s of {student} is {ends_s}; allowed is {} (a second after it starts) to {latest_s}",
            starts_s + SHORTEST_S
        ));
    }
    Ok(Slot {
        student: student.to_owned(),
        group: slot.group.clone(),
        from: now + Duration::from_secs_f64(starts_s),
        until: now + Duration::from_secs_f64(ends_s),
        started: false,
        warned: false,
    })
}

fn check_student(student: &str) -> Result<(), String> {
    let characters = student.chars().count();
    if !(1..=60).contains(&characters) || !student.chars().all(is_plain) {
        return Err(format!(
            "student has {characters} characters; allowed are 1 to 60 visible ones"
        ));
    }
    Ok(())
}

fn check_group(group: &str) -> Result<(), String> {
    if is_fleet_name(group) {
        return Ok(());
    }
    let group: String = group.chars().take(60).collect();
    Err(format!(
        "group is {group:?}; allowed are 1 to 40 small letters of English, digits and hyphens, the first one a letter"
    ))
}

/// A student is warned this long before the slot ends.
const WARNING: Duration = Duration::from_secs(60);
/// A shorter slot is a mistake.
const SHORTEST_S: f64 = 1.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn slot(student: &str, starts_in_s: f64, ends_in_s: f64) -> TimeSlot {
        TimeSlot {
            student: student.into(),
            group: None,
            starts_in_s,
            ends_in_s,
        }
    }

    fn s(s: u64) -> Duration {
        Duration::from_secs(s)
    }

    /// Returns the changes of the slots at these seconds.
    fn turns(slots: &mut Slots, at_s: u64) -> Vec<String> {
        std::iter::from_fn(|| slots.poll_change(s(at_s)))
            .map(|turn| match turn {
                SlotChange::Began { student, lasts } => format!("{student} has {lasts:?}"),
                SlotChange::Ending { student, left } => format!("{student} has {left:?} left"),
                SlotChange::Ended { student } => format!("{student} is over"),
            })
            .collect()
    }

    #[test]
    fn each_slot_begins_is_announced_as_ending_and_ends_once_in_order() {
        let mut slots = Slots::default();
        let all = [slot("Ben", 600.0, 1200.0), slot("Anna", 0.0, 600.0)];
        slots.set(s(100), &all).unwrap();
        assert_eq!(turns(&mut slots, 100), ["Anna has 600s"]);
        assert_eq!(slots.wakeup(), Some(s(640)));
        assert!(turns(&mut slots, 639).is_empty());
        assert_eq!(turns(&mut slots, 640), ["Anna has 60s left"]);
        assert!(turns(&mut slots, 641).is_empty());
        assert_eq!(turns(&mut slots, 700), ["Anna is over", "Ben has 600s"]);
        assert_eq!(turns(&mut slots, 5000), ["Ben is over"]);
        assert_eq!((slots.wakeup(), slots.view()), (None, None));
    }

    #[test]
    fn a_slot_that_passed_unnoticed_is_not_reported() {
        let mut slots = Slots::default();
        slots
            .set(s(0), &[slot("Anna", 10.0, 20.0), slot("Ben", 30.0, 99.0)])
            .unwrap();
        assert_eq!(turns(&mut slots, 25), Vec::<String>::new());
        assert_eq!(turns(&mut slots, 30), ["Ben has 69s"]);
    }

    #[test]
    fn the_arm_is_free_after_all_consecutive_slots() {
        let mut slots = Slots::default();
        let all = [
            slot("Anna", 0.0, 60.0),
            slot("Ben", 60.0, 120.0),
            slot("Chen", 150.0, 200.0),
        ];
        slots.set(s(0), &all).unwrap();
        slots.poll_change(s(0)).unwrap();
        let others = slots.other_slot("Ben").unwrap();
        assert_eq!(
            (others.student, others.left, others.free_in),
            ("Anna", s(60), s(120))
        );
        assert!(slots.other_slot(" ANNA ").is_none());
        let view = slots.view().unwrap();
        assert_eq!(view.next.unwrap().student, "Ben");
        assert_eq!(view.free_s, Some(120.0));
    }

    #[test]
    fn an_invalid_slot_is_refused_with_what_is_allowed_and_the_old_slots_stay() {
        let mut slots = Slots::default();
        slots.set(s(0), &[slot("Anna", 0.0, 60.0)]).unwrap();
        let long = "a".repeat(61);
        let many: Vec<_> = (0..201)
            .map(|starts_s| slot("Anna", f64::from(starts_s), 9e4))
            .collect();
        let group = TimeSlot {
            group: Some("Room 1".into()),
            ..slot("Anna", 0.0, 9.0)
        };
        for (bad, expected) in [
            (
                vec![slot("Anna", f64::NAN, 60.0)],
                "starts_in_s of Anna is NaN",
            ),
            (vec![slot("Anna", -1.0, 60.0)], "starts_in_s of Anna is -1"),
            (
                vec![slot("Anna", 0.0, f64::INFINITY)],
                "ends_in_s of Anna is inf",
            ),
            (
                vec![slot("Anna", 0.0, f64::NAN)],
                "ends_in_s of Anna is NaN",
            ),
            (
                vec![slot("Anna", 0.0, 86_401.0)],
                "ends_in_s of Anna is 86401",
            ),
            (
                vec![slot("Anna", 10.0, 10.0)],
                "ends_in_s of Anna is 10; allowed is 11",
            ),
            (vec![slot(" ", 0.0, 9.0)], "student has 0 characters"),
            (vec![slot(&long, 0.0, 9.0)], "student has 61 characters"),
            (
                vec![slot("A\u{202e}", 0.0, 9.0)],
                "student has 2 characters",
            ),
            (vec![group], "group is \"Room 1\""),
            (many, "201 slots; allowed are up to 200"),
            (
                vec![slot("Ben", 50.0, 99.0), slot("Chen", 0.0, 51.5)],
                "the slots of Chen (from 0 s to 51.5 s) and Ben (from 50 s to 99 s) overlap",
            ),
        ] {
            let refused = slots.set(s(9), &bad).unwrap_err();
            assert_eq!(refused.kind(), "bad-slots");
            let text = refused.to_string();
            assert!(text.contains(expected), "{text}; expected {expected}");
        }
        assert_eq!(slots.upcoming(s(9)), [slot("Anna", 0.0, 51.0)]);
    }
}
