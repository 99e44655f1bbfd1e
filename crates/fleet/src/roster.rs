//! Who is there: an engine without a network or a clock.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::sync::Arc;

use dobot_api::problem_kinds::MEMBER_REFUSED;
use dobot_api::{Member, MemberAbout, Presence, Problem, State};
use dobot_station::Members;
use serde::{Deserialize, Serialize};

use crate::keys::{Alive, MESSAGES, MemberKey};

/// What a station tells of itself.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Told {
    pub(crate) about: MemberAbout,
    pub(crate) state: Option<Box<State>>,
}

/// All stations that have been seen.
#[derive(Debug)]
pub(crate) struct Roster {
    own: MemberKey,
    seen: BTreeMap<MemberKey, Seen>,
    /// All of them, as long as nothing has changed.
    members: Option<Members>,
    /// Whether there were more than it takes.
    is_full: bool,
}

/// A station that has been seen.
#[derive(Debug)]
struct Seen {
    member: Arc<Member>,
    /// What its liveliness token said, while there is one.
    alive: Option<Alive>,
}

/// How many stations are known at the most: a flood of names takes no more memory than that.
pub(crate) const MOST: usize = 2000;

impl Roster {
    pub(crate) fn new(own: MemberKey) -> Self {
        Self {
            own,
            seen: BTreeMap::new(),
            members: None,
            is_full: false,
        }
    }

    /// All of them, by name: the same until something changes.
    pub(crate) fn members(&mut self) -> Members {
        let all = || self.seen.values().map(|it| it.member.clone()).collect();
        self.members.get_or_insert_with(all).clone()
    }

    /// Whether others were there for which there was no room.
    pub(crate) const fn is_full(&self) -> bool {
        self.is_full
    }

    /// A station is there.
    pub(crate) fn came(&mut self, alive: Alive, at_s: f64) {
        let key = alive.member.clone();
        self.members = None;
        if !self.seen.contains_key(&key) && self.seen.len() >= MOST {
            let away = |it: &Seen| it.alive.is_none();
            self.is_full = true;
            let Some(old) = self.seen.iter().find(|(_, it)| away(it)) else {
                return;
            };
            let old = old.0.clone();
            self.seen.remove(&old);
        }
        let here = key == self.own;
        let seen = self.seen.entry(key.clone()).or_insert_with(|| Seen {
            member: Arc::new(Member {
                name: key.name.clone(),
                id: key.id.clone(),
                here,
                presence: Presence::Away,
                heard_at_s: at_s,
                about: None,
                state: None,
            }),
            alive: None,
        });
        seen.alive = Some(alive);
        Arc::make_mut(&mut seen.member).heard_at_s = at_s;
        // One that was replaced under its name is not missed.
        let replaced = |(it, seen): &(&MemberKey, &mut Seen)| {
            **it != key && seen.alive.is_none() && **it != self.own
        };
        let replaced = self.seen.range_mut(of_name(&key.name)).filter(replaced);
        let replaced: Vec<_> = replaced.map(|(it, _)| it.clone()).collect();
        for it in replaced {
            self.seen.remove(&it);
        }
        self.judge(&key.name);
    }

    /// A station is not there any more. A virtual arm that was given to somebody is not missed: it ends when it is not used.
    pub(crate) fn went(&mut self, member: &MemberKey) {
        if let Some(seen) = self.seen.get_mut(member) {
            self.members = None;
            seen.alive = None;
            let about = seen.member.about.as_ref();
            if about.is_some_and(|it| it.given_by.is_some()) {
                self.seen.remove(member);
            }
            self.judge(&member.name);
        }
    }

    /// A station tells of itself. What nobody who is there says is not kept.
    pub(crate) fn told(&mut self, member: &MemberKey, told: Told, at_s: f64) {
        let Some(seen) = self.seen.get_mut(member).filter(|it| it.alive.is_some()) else {
            return;
        };
        self.members = None;
        let member = Arc::make_mut(&mut seen.member);
        member.heard_at_s = at_s;
        member.about = Some(told.about);
        if told.state.is_some() {
            member.state = told.state;
        }
    }

    /// What is to be asked of the stations of a name, now that one came or went.
    fn judge(&mut self, name: &str) {
        let there = self.seen.range(of_name(name));
        let claim = there.filter(|(_, seen)| seen.alive.is_some()).count();
        for (_, seen) in self.seen.range_mut(of_name(name)) {
            let presence = match &seen.alive {
                None => Presence::Away,
                Some(alive) => match refusal(alive, claim) {
                    Some(problem) => Presence::Refused { problem },
                    None => Presence::Present,
                },
            };
            if seen.member.presence != presence {
                Arc::make_mut(&mut seen.member).presence = presence;
            }
        }
    }
}

/// The keys of all stations of a name.
fn of_name(name: &str) -> RangeInclusive<MemberKey> {
    let key = |id: &str| MemberKey {
        name: name.into(),
        id: id.into(),
    };
    // A number is of hexadecimal digits, which all come before the letter g.
    key("")..=key("g")
}

/// Why nothing is asked of a station, if so.
fn refusal(alive: &Alive, claim: usize) -> Option<Problem> {
    let name = &alive.member.name;
    let (theirs, ours) = (&alive.version, env!("CARGO_PKG_VERSION"));
    if alive.messages != MESSAGES {
        let found = alive.messages;
        return Some(MEMBER_REFUSED.hinted(
            format!(
                "{name} (dobot {theirs}) speaks version {found} of the fleet's messages, this station (dobot {ours}) version {MESSAGES}"
            ),
            "bring both to the same release",
        ));
    }
    (claim > 1).then(|| {
        MEMBER_REFUSED.hinted(
            format!("{claim} stations call themselves {name}"),
            "start all of them but one with another `--name`",
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::telling::tests::state;

    fn key(name: &str, digit: char) -> MemberKey {
        MemberKey {
            name: name.into(),
            id: String::from(digit).repeat(32),
        }
    }

    fn alive(member: MemberKey) -> Alive {
        Alive {
            member,
            messages: MESSAGES,
            version: "1.2.3".into(),
        }
    }

    fn roster() -> Roster {
        let mut roster = Roster::new(key("desk-1", 'a'));
        roster.came(alive(key("desk-1", 'a')), 0.0);
        roster
    }

    fn presences(roster: &mut Roster) -> Vec<(String, Presence)> {
        let members = roster.members();
        let told = |it: &Arc<Member>| (it.name.clone(), it.presence.clone());
        members.iter().map(told).collect()
    }

    #[test]
    fn a_station_that_went_is_shown_as_away_and_one_that_comes_again_as_present() {
        let mut roster = roster();
        roster.came(alive(key("desk-2", 'b')), 1.0);
        roster.went(&key("desk-2", 'b'));
        let away = [("desk-1", Presence::Present), ("desk-2", Presence::Away)];
        assert_eq!(
            presences(&mut roster),
            away.map(|(it, how)| (it.into(), how))
        );
        roster.came(alive(key("desk-2", 'b')), 2.0);
        assert_eq!(presences(&mut roster)[1].1, Presence::Present);
        assert!(roster.members()[0].here && !roster.members()[1].here);
    }

    #[test]
    fn of_two_stations_of_one_name_none_is_asked_until_one_is_left() {
        let mut roster = roster();
        for digit in ['b', 'c'] {
            roster.came(alive(key("desk-2", digit)), 1.0);
        }
        for (_, presence) in &presences(&mut roster)[1..] {
            let Presence::Refused { problem } = presence else {
                panic!("{presence:?}");
            };
            assert_eq!(problem.detail, "2 stations call themselves desk-2");
        }
        roster.went(&key("desk-2", 'b'));
        let left = roster.members();
        let ids: Vec<_> = left.iter().map(|it| (&*it.id, &it.presence)).collect();
        assert_eq!(ids[2], (&*"c".repeat(32), &Presence::Present));
    }

    #[test]
    fn a_station_that_takes_the_place_of_one_that_is_away_is_the_only_one_of_its_name() {
        let mut roster = roster();
        roster.came(alive(key("desk-2", 'b')), 1.0);
        roster.went(&key("desk-2", 'b'));
        roster.came(alive(key("desk-2", 'c')), 2.0);
        assert_eq!(presences(&mut roster).len(), 2);
    }

    #[test]
    fn a_station_of_another_version_is_refused_with_both_versions() {
        let mut roster = roster();
        let newer = Alive {
            messages: 9,
            ..alive(key("desk-2", 'b'))
        };
        roster.came(newer, 1.0);
        let Presence::Refused { problem } = &roster.members()[1].presence else {
            panic!("{:?}", roster.members()[1]);
        };
        for word in [
            "dobot 1.2.3",
            "version 9",
            env!("CARGO_PKG_VERSION"),
            "version 1",
        ] {
            assert!(problem.detail.contains(word), "{}", problem.detail);
        }
    }

    #[test]
    fn what_is_told_is_kept_of_those_who_are_there_and_of_nobody_else() {
        let mut roster = roster();
        let told = |group: &str| Told {
            about: MemberAbout {
                groups: vec![group.into()],
                ..MemberAbout::default()
            },
            state: None,
        };
        roster.told(&key("desk-2", 'b'), told("room-1"), 1.0);
        assert_eq!(roster.members().len(), 1);
        roster.came(alive(key("desk-2", 'b')), 2.0);
        roster.told(&key("desk-2", 'b'), told("room-1"), 3.0);
        let member = &roster.members()[1];
        assert_eq!(member.heard_at_s, 3.0);
        assert_eq!(
            member.about.as_ref().map(|it| &*it.groups[0]),
            Some("room-1")
        );
    }

    #[test]
    fn a_station_with_a_wrong_clock_is_heard_when_it_is_heard() {
        let mut roster = roster();
        roster.came(alive(key("desk-2", 'b')), 2.0);
        for at_s in [-1e9, 1e12] {
            let state = State { at_s, ..state() };
            let told = Told {
                about: MemberAbout::default(),
                state: Some(Box::new(state)),
            };
            roster.told(&key("desk-2", 'b'), told, 3.0);
            let member = &roster.members()[1];
            assert_eq!(member.heard_at_s, 3.0);
            assert_eq!(member.presence, Presence::Present);
        }
    }

    #[test]
    fn a_flood_of_names_is_held_and_pushes_out_nobody_who_is_there() {
        let mut roster = roster();
        for number in 0..MOST + 10 {
            roster.came(alive(key(&format!("flood-{number}"), 'f')), 1.0);
        }
        assert_eq!(roster.members().len(), MOST);
        assert!(roster.is_full());
        assert!(roster.members().iter().any(|it| it.here));
        // Those that went make room.
        roster.went(&key("flood-0", 'f'));
        roster.came(alive(key("late", 'e')), 2.0);
        assert!(roster.members().iter().any(|it| it.name == "late"));
    }

    #[test]
    fn only_those_that_changed_are_told_anew() {
        let mut roster = roster();
        roster.came(alive(key("desk-2", 'b')), 1.0);
        let before = roster.members();
        let told = Told {
            about: MemberAbout::default(),
            state: None,
        };
        roster.told(&key("desk-2", 'b'), told, 3.0);
        let after = roster.members();
        assert!(Arc::ptr_eq(&before[0], &after[0]));
        assert!(!Arc::ptr_eq(&before[1], &after[1]));
    }
}
