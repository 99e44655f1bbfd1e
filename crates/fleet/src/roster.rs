//! The members of a fleet: an engine without network and clock.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::sync::{Arc, MutexGuard, PoisonError};

use dobot_api::problem_kinds::MEMBER_REFUSED;
use dobot_api::{Member, MemberAbout, Presence, Problem, State};
use dobot_station::Members;
use serde::{Deserialize, Serialize};

use crate::identity::Peer;
use crate::key_expressions::{Alive, MESSAGES, MemberKey};
use crate::publisher;
use crate::requests::Peers;

/// The published description and state of a station.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct StateReport {
    pub(crate) about: MemberAbout,
    pub(crate) state: Option<Box<State>>,
}

/// All stations seen so far.
#[derive(Debug)]
pub(crate) struct Roster {
    own: MemberKey,
    seen: BTreeMap<MemberKey, KnownStation>,
    /// The members, cached until a change.
    members: Option<Members>,
    /// Whether stations were left out for lack of space.
    is_full: bool,
    /// The certificates of the members present.
    peers: Peers,
}

/// A station that has been seen.
#[derive(Debug)]
struct KnownStation {
    member: Arc<Member>,
    /// Its liveliness token, while it exists.
    alive: Option<Alive>,
    /// The signer of the token; absent with other versions of the messages.
    peer: Option<Arc<Peer>>,
    /// The start of its last token.
    last_run: u64,
    /// The sequence number of the last state that it published since.
    last_state: u64,
}

impl KnownStation {
    /// Returns how strong the station's claim to its name is: strongest with a certificate for it,
    /// weakest without a certificate.
    fn claim(&self) -> Claim {
        claim(self.peer.as_deref(), &self.member.name)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Claim {
    OtherVersion,
    /// A virtual arm that the holder of the certificate hosts.
    Given,
    Own,
}

fn claim(peer: Option<&Peer>, name: &str) -> Claim {
    match peer {
        Some(peer) if peer.name == name => Claim::Own,
        Some(_) => Claim::Given,
        None => Claim::OtherVersion,
    }
}

/// The maximum number of stations per certificate: one that hosts 200 virtual arms.
const MAX_PER_CERTIFICATE: usize = 201;
/// The maximum number of stations: bounds the memory that a flood of names can take.
pub(crate) const MAX_STATIONS: usize = 2000;

impl Roster {
    pub(crate) fn new(own: MemberKey) -> Self {
        Self {
            own,
            seen: BTreeMap::new(),
            members: None,
            is_full: false,
            peers: Peers::default(),
        }
    }

    /// Returns the certificates of the members present, updated as they come and go.
    pub(crate) const fn peers(&self) -> &Peers {
        &self.peers
    }

    /// Returns all members, by name; the same value until something changes.
    pub(crate) fn members(&mut self) -> Members {
        let all = || {
            self.seen
                .values()
                .map(|value| value.member.clone())
                .collect()
        };
        self.members.get_or_insert_with(all).clone()
    }

    /// Whether stations were left out for lack of space.
    pub(crate) const fn is_full(&self) -> bool {
        self.is_full
    }

    /// Handles an arrival, with the certificate that signed it; none with other versions of the
    /// messages.
    pub(crate) fn handle_arrival(&mut self, alive: Alive, peer: Option<Arc<Peer>>, at_s: f64) {
        let key = alive.member.clone();
        let claims = claim(peer.as_deref(), &key.name);
        // A token of another signer or of an earlier start is ignored.
        let is_passed_over = |seen: &KnownStation| {
            let is_others = claims == Claim::Given && seen.peer != peer;
            let last = seen.alive.as_ref().map(|alive| alive.run);
            let is_old = seen.claim() == claims && last.is_some_and(|run| run > alive.run);
            seen.claim() > claims || (seen.claim() == claims && is_others) || is_old
        };
        let is_passed_over = match self.seen.get(&key) {
            Some(seen) => is_passed_over(seen),
            None => !self.makes_room(peer.as_deref()),
        };
        if is_passed_over {
            return;
        }
        self.members = None;
        let here = key == self.own;
        let seen = self
            .seen
            .entry(key.clone())
            .or_insert_with(|| KnownStation {
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
                peer: None,
                last_run: 0,
                last_state: 0,
            });
        // A link that comes back is the same run: states before the interruption stay replays.
        if seen.last_run != alive.run {
            (seen.last_run, seen.last_state) = (alive.run, 0);
        }
        seen.alive = Some(alive);
        seen.peer.clone_from(&peer);
        Arc::make_mut(&mut seen.member).heard_at_s = at_s;
        if let Some(peer) = peer {
            self.known().insert(key.clone(), peer);
        }
        // A replaced station of the same name is not reported as away.
        let replaced = |(other, seen): &(&MemberKey, &mut KnownStation)| {
            **other != key && seen.alive.is_none() && **other != self.own && seen.claim() <= claims
        };
        let replaced = self.seen.range_mut(of_name(&key.name)).filter(replaced);
        let replaced: Vec<_> = replaced.map(|(other, _)| other.clone()).collect();
        for other in replaced {
            self.forget(&other);
        }
        self.judge(&key.name);
    }

    fn forget(&mut self, member: &MemberKey) {
        self.seen.remove(member);
        self.known().remove(member);
    }

    fn known(&self) -> MutexGuard<'_, BTreeMap<MemberKey, Arc<Peer>>> {
        self.peers.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Makes room for one more station: drops one of another message version or one that is away. A
    /// certificate cannot take the room of all others.
    fn makes_room(&mut self, peer: Option<&Peer>) -> bool {
        let by_same = |seen: &&KnownStation| seen.peer.as_deref() == peer;
        if peer.is_some() && self.seen.values().filter(by_same).count() >= MAX_PER_CERTIFICATE {
            return false;
        }
        if self.seen.len() < MAX_STATIONS {
            return true;
        }
        self.is_full = true;
        let is_other = |entry: &KnownStation| peer.is_some() && entry.peer.is_none();
        let old = self.seen.iter();
        let mut old = old.filter(|(_, station)| station.alive.is_none() || is_other(station));
        let Some(old) = old.next().map(|(key, _)| key.clone()) else {
            return false;
        };
        self.forget(&old);
        true
    }

    /// Handles a departure, if the token is the current one. A hosted virtual arm is not reported
    /// as away: it ends when it is unused.
    pub(crate) fn handle_departure(&mut self, alive: &Alive) {
        let member = &alive.member;
        let seen = self.seen.get_mut(member);
        if let Some(seen) = seen.filter(|seen| seen.alive.as_ref() == Some(alive)) {
            self.members = None;
            seen.alive = None;
            if seen.claim() == Claim::Given {
                self.forget(member);
            }
            self.judge(&member.name);
        }
    }

    /// Forgets the stations whose certificates are no longer valid; `counts` decides.
    pub(crate) fn forget_strangers(&mut self, counts: impl Fn(&Peer) -> bool) {
        let is_stranger =
            |seen: &KnownStation| seen.peer.as_deref().is_some_and(|peer| !counts(peer));
        let strangers = self
            .seen
            .iter()
            .filter(|(key, station)| **key != self.own && is_stranger(station));
        let strangers: Vec<_> = strangers.map(|(key, _)| key.clone()).collect();
        for member in strangers {
            self.members = None;
            self.forget(&member);
            self.judge(&member.name);
        }
    }

    /// Handles a published state and its signature. Replays and states of other signers are
    /// ignored.
    pub(crate) fn handle_state(
        &mut self,
        member: &MemberKey,
        report: &[u8],
        signature: &[u8],
        at_s: f64,
    ) -> Result<(), String> {
        let seen = self.seen.get(member);
        let Some((alive, peer)) =
            seen.and_then(|entry| entry.alive.as_ref().zip(entry.peer.as_ref()))
        else {
            return Ok(());
        };
        let number = publisher::number_of(peer, member, alive.run, report, signature);
        let number = number.ok_or("its signature is invalid")?;
        if seen.is_some_and(|seen| seen.last_state >= number) {
            return Err("it is a replay".into());
        }
        let read = publisher::read(report, &member.name, &peer.name)?;
        self.store(member, read, at_s);
        if let Some(seen) = self.seen.get_mut(member) {
            seen.last_state = number;
        }
        Ok(())
    }

    /// Stores the published state of a station that is present.
    pub(crate) fn store(&mut self, member: &MemberKey, report: StateReport, at_s: f64) {
        let Some(seen) = self
            .seen
            .get_mut(member)
            .filter(|seen| seen.alive.is_some())
        else {
            return;
        };
        self.members = None;
        let member = Arc::make_mut(&mut seen.member);
        member.heard_at_s = at_s;
        member.about = Some(report.about);
        if report.state.is_some() {
            member.state = report.state;
        }
    }

    /// Updates the presence of the stations of a name, after an arrival or departure.
    fn judge(&mut self, name: &str) {
        let all = || self.seen.range(of_name(name)).map(|(_, station)| station);
        // The name belongs to the holder of its certificate, also while the holder is away.
        let best = all().map(KnownStation::claim).max();
        let is_best = |seen: &&KnownStation| seen.alive.is_some() && Some(seen.claim()) == best;
        let claim = all().filter(is_best).count();
        for (_, seen) in self.seen.range_mut(of_name(name)) {
            let is_best = Some(seen.claim()) == best;
            let presence = match &seen.alive {
                None => Presence::Away,
                Some(alive) => match refusal(alive, is_best, claim) {
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

/// Returns the range of keys of a name.
fn of_name(name: &str) -> RangeInclusive<MemberKey> {
    let key = |id: &str| MemberKey {
        name: name.into(),
        id: id.into(),
    };
    // An id consists of hexadecimal digits, which sort before the letter g.
    key("")..=key("g")
}

/// Returns the reason why a station accepts no requests, if any.
fn refusal(alive: &Alive, is_best: bool, claim: usize) -> Option<Problem> {
    let name = &alive.member.name;
    let (theirs, ours) = (&alive.version, env!("CARGO_PKG_VERSION"));
    if alive.messages != MESSAGES {
        let found = alive.messages;
        return Some(MEMBER_REFUSED.hinted(
            format!(
                "{name} (dobot {theirs}) speaks version {found} of the fleet's messages, this station (dobot {ours}) version {MESSAGES}"
            ),
            "update both to the same release",
        ));
    }
    if !is_best {
        return Some(MEMBER_REFUSED.hinted(
            format!("the certificate of another station reserves the name {name}"),
            "start this one with another `--name`",
        ));
    }
    (claim > 1).then(|| {
        MEMBER_REFUSED.hinted(
            format!("{claim} stations use the name {name}"),
            "restart all but one of them with another `--name`",
        )
    })
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use crate::Credentials;
    use crate::identity::Identity;
    use crate::publisher::StateSigner;

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
            run: 1,
            proof: Vec::new(),
        }
    }

    /// A certificate for this name.
    fn certificate(name: &str) -> Identity {
        let folder = tempfile::tempdir().unwrap();
        let made = Credentials::local(&folder.path().join("own"), name);
        made.unwrap().identity().unwrap()
    }

    fn peer(name: &str) -> Arc<Peer> {
        certificate(name).own().clone()
    }

    /// Adds a station with a certificate for its name.
    fn handle_arrival(roster: &mut Roster, member: MemberKey, at_s: f64) {
        let peer = peer(&member.name);
        roster.handle_arrival(alive(member), Some(peer), at_s);
    }

    fn roster() -> Roster {
        let mut roster = Roster::new(key("desk-1", 'a'));
        handle_arrival(&mut roster, key("desk-1", 'a'), 0.0);
        roster
    }

    fn presences(roster: &mut Roster) -> Vec<(String, Presence)> {
        let members = roster.members();
        let presence = |member: &Arc<Member>| (member.name.clone(), member.presence.clone());
        members.iter().map(presence).collect()
    }

    #[test]
    fn a_station_that_left_is_shown_as_away_and_a_returning_one_as_present() {
        let mut roster = roster();
        handle_arrival(&mut roster, key("desk-2", 'b'), 1.0);
        roster.handle_departure(&alive(key("desk-2", 'b')));
        let away = [("desk-1", Presence::Present), ("desk-2", Presence::Away)];
        assert_eq!(
            presences(&mut roster),
            away.map(|(name, how)| (name.into(), how))
        );
        handle_arrival(&mut roster, key("desk-2", 'b'), 2.0);
        assert_eq!(presences(&mut roster)[1].1, Presence::Present);
        assert!(roster.members()[0].here && !roster.members()[1].here);
    }

    #[test]
    fn two_stations_of_one_name_are_not_asked_until_one_is_left() {
        let mut roster = roster();
        for digit in ['b', 'c'] {
            handle_arrival(&mut roster, key("desk-2", digit), 1.0);
        }
        for (_, presence) in &presences(&mut roster)[1..] {
            let Presence::Refused { problem } = presence else {
                panic!("{presence:?}");
            };
            assert_eq!(problem.detail, "2 stations use the name desk-2");
        }
        roster.handle_departure(&alive(key("desk-2", 'b')));
        let left = roster.members();
        let ids: Vec<_> = left
            .iter()
            .map(|left| (&*left.id, &left.presence))
            .collect();
        assert_eq!(ids[2], (&*"c".repeat(32), &Presence::Present));
    }

    #[test]
    fn a_station_that_replaces_an_absent_one_is_the_only_one_of_its_name() {
        let mut roster = roster();
        handle_arrival(&mut roster, key("desk-2", 'b'), 1.0);
        roster.handle_departure(&alive(key("desk-2", 'b')));
        handle_arrival(&mut roster, key("desk-2", 'c'), 2.0);
        assert_eq!(presences(&mut roster).len(), 2);
    }

    #[test]
    fn a_station_of_another_version_is_refused_with_both_versions() {
        let mut roster = roster();
        let newer = Alive {
            messages: 9,
            ..alive(key("desk-2", 'b'))
        };
        roster.handle_arrival(newer, None, 1.0);
        let Presence::Refused { problem } = &roster.members()[1].presence else {
            panic!("{:?}", roster.members()[1]);
        };
        for word in [
            "dobot 1.2.3",
            "version 9",
            env!("CARGO_PKG_VERSION"),
            &format!("version {MESSAGES}"),
        ] {
            assert!(problem.detail.contains(word), "{}", problem.detail);
        }
    }

    #[test]
    fn reports_are_kept_for_present_stations_only() {
        let mut roster = roster();
        let report = |group: &str| StateReport {
            about: MemberAbout {
                groups: vec![group.into()],
                ..MemberAbout::default()
            },
            state: None,
        };
        roster.store(&key("desk-2", 'b'), report("room-1"), 1.0);
        assert_eq!(roster.members().len(), 1);
        handle_arrival(&mut roster, key("desk-2", 'b'), 2.0);
        roster.store(&key("desk-2", 'b'), report("room-1"), 3.0);
        let member = &roster.members()[1];
        assert_eq!(member.heard_at_s, 3.0);
        assert_eq!(
            member.about.as_ref().map(|about| &*about.groups[0]),
            Some("room-1")
        );
    }

    #[test]
    fn a_report_of_a_station_with_a_wrong_clock_counts_from_its_arrival() {
        let mut roster = roster();
        handle_arrival(&mut roster, key("desk-2", 'b'), 2.0);
        for at_s in [-1e9, 1e12] {
            let state = State {
                at_s,
                ..State::sample()
            };
            let report = StateReport {
                about: MemberAbout::default(),
                state: Some(Box::new(state)),
            };
            roster.store(&key("desk-2", 'b'), report, 3.0);
            let member = &roster.members()[1];
            assert_eq!(member.heard_at_s, 3.0);
            assert_eq!(member.presence, Presence::Present);
        }
    }

    #[test]
    fn five_thousand_stations_of_one_certificate_leave_room_for_the_others() {
        let mut roster = roster();
        let rogue = Some(peer("desk-9"));
        for number in 0..5000 {
            let fake = alive(key(&format!("fake-{number}"), 'f'));
            roster.handle_arrival(fake, rogue.clone(), 1.0);
        }
        assert_eq!(roster.members().len(), 1 + MAX_PER_CERTIFICATE);
        handle_arrival(&mut roster, key("desk-2", 'b'), 2.0);
        let there =
            |member: &&Arc<Member>| member.name == "desk-2" && member.presence == Presence::Present;
        assert!(roster.members().iter().any(|member| there(&member)));
        assert!(!roster.is_full());
    }

    #[test]
    fn a_flood_of_other_versions_is_bounded_and_displaces_no_present_station() {
        let mut roster = roster();
        for number in 0..MAX_STATIONS + 10 {
            let other = Alive {
                messages: 9,
                ..alive(key(&format!("flood-{number}"), 'f'))
            };
            roster.handle_arrival(other, None, 1.0);
        }
        assert_eq!(roster.members().len(), MAX_STATIONS);
        assert!(roster.is_full());
        assert!(roster.members().iter().any(|member| member.here));
        // They make room for a station with a certificate.
        handle_arrival(&mut roster, key("late", 'e'), 2.0);
        assert!(roster.members().iter().any(|member| member.name == "late"));
        assert_eq!(roster.members().len(), MAX_STATIONS);
    }

    #[test]
    fn a_name_belongs_to_its_certificate_and_others_that_use_it_are_refused() {
        let mut roster = roster();
        let rogue = Some(peer("desk-9"));
        handle_arrival(&mut roster, key("desk-2", 'b'), 1.0);
        roster.handle_arrival(alive(key("desk-2", 'f')), rogue.clone(), 2.0);
        // Also in the place of the station itself.
        roster.handle_arrival(alive(key("desk-2", 'b')), rogue.clone(), 2.0);
        let presences: Vec<_> = presences(&mut roster);
        assert_eq!(presences[1].1, Presence::Present);
        let Presence::Refused { problem } = &presences[2].1 else {
            panic!("{presences:?}");
        };
        assert!(
            problem
                .detail
                .contains("the certificate of another station"),
            "{problem:?}"
        );
        // It stays so while the station is away.
        roster.handle_departure(&alive(key("desk-2", 'b')));
        roster.handle_arrival(alive(key("desk-2", 'f')), rogue, 3.0);
        let there = roster.members();
        let is_asked =
            |member: &Arc<Member>| member.name == "desk-2" && member.presence == Presence::Present;
        assert!(!there.iter().any(is_asked), "{there:?}");
    }

    #[test]
    fn a_report_counts_once_and_only_from_the_station_itself() {
        let mut roster = roster();
        let (own, rogue) = (
            Arc::new(certificate("desk-2")),
            Arc::new(certificate("desk-9")),
        );
        let member = key("desk-2", 'b');
        roster.handle_arrival(alive(member.clone()), Some(own.own().clone()), 1.0);
        let new_signer =
            |identity: &Arc<Identity>| StateSigner::new(identity.clone(), member.clone(), 1);
        let about = |group: &str| StateReport {
            about: MemberAbout {
                groups: vec![group.into()],
                ..MemberAbout::default()
            },
            state: None,
        };
        let [old, new] = ["old", "new"].map(|name| serde_json::to_vec(&about(name)).unwrap());
        let signer = new_signer(&own);
        let [first, second] = [&old, &new].map(|bytes| signer.sign(bytes));
        roster.handle_state(&member, &old, &first, 2.0).unwrap();
        roster.handle_state(&member, &new, &second, 3.0).unwrap();
        let refused = |roster: &mut Roster, signature: &[u8]| {
            roster
                .handle_state(&member, &old, signature, 4.0)
                .unwrap_err()
        };
        assert_eq!(refused(&mut roster, &first), "it is a replay");
        let forged = new_signer(&rogue).sign(&old);
        for signature in [&forged[..], &second, b"", &[0; 8]] {
            assert_eq!(refused(&mut roster, signature), "its signature is invalid");
        }
        let members = roster.members();
        assert_eq!(members[1].about.as_ref().unwrap().groups, ["new"]);
        // So it is after an interruption of its link.
        roster.handle_departure(&alive(member.clone()));
        roster.handle_arrival(alive(member.clone()), Some(own.own().clone()), 5.0);
        assert_eq!(refused(&mut roster, &first), "it is a replay");
        // After a restart the sequence begins again; earlier states are no longer valid.
        let again = Alive {
            run: 2,
            ..alive(member.clone())
        };
        roster.handle_arrival(again, Some(own.own().clone()), 5.0);
        assert_eq!(refused(&mut roster, &first), "its signature is invalid");
        roster.handle_arrival(alive(member.clone()), Some(own.own().clone()), 6.0);
        let signature = StateSigner::new(own, member.clone(), 2).sign(&old);
        roster.handle_state(&member, &old, &signature, 7.0).unwrap();
    }

    #[test]
    fn only_changed_members_are_reported_again() {
        let mut roster = roster();
        handle_arrival(&mut roster, key("desk-2", 'b'), 1.0);
        let before = roster.members();
        let report = StateReport {
            about: MemberAbout::default(),
            state: None,
        };
        roster.store(&key("desk-2", 'b'), report, 3.0);
        let after = roster.members();
        assert!(Arc::ptr_eq(&before[0], &after[0]));
        assert!(!Arc::ptr_eq(&before[1], &after[1]));
    }
}
