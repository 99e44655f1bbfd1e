//! Stops of the whole fleet: stations exchange the stops that they know when one of them arrives or
//! returns.

use std::collections::{BTreeMap, HashSet};
use std::time::{Duration, SystemTime};

use dobot_api::problem_kinds::MEMBER_AWAY;
use dobot_api::{ApiAnswer, FleetWideStop};
use dobot_host::StationHandle;
use serde_json::json;
use zenoh::query::Query;

use crate::key_expressions::{MemberKey, STOPS};
use crate::requests::{Requester, Responder};
use crate::roster::MAX_STATIONS;

/// Decides with which members to exchange stops, and when: an engine without network and clock.
#[derive(Debug)]
pub(crate) struct StopExchange {
    own: MemberKey,
    /// The members present.
    present: HashSet<MemberKey>,
    /// The members that were present before.
    known: HashSet<MemberKey>,
    /// The members to exchange stops with, and when.
    due: BTreeMap<MemberKey, Duration>,
    /// The time at which the station is settled.
    settles: Duration,
    /// When it last ran, by a monotonic clock and by the system's clock.
    last: (Duration, SystemTime),
}

/// How long a station waits after it arrived or returned before it accepts or offers jobs: time to
/// connect and to learn the stops of others.
const SETTLES_WITHIN: Duration = Duration::from_secs(4);
/// The gap after which other members may have missed this station; they take three seconds to
/// notice.
const GAP: Duration = Duration::from_secs(2);
/// The delay before an exchange is retried.
const RETRY_DELAY: Duration = Duration::from_secs(1);

impl StopExchange {
    pub(crate) fn new(own: MemberKey, now: Duration, clock: SystemTime) -> Self {
        Self {
            own,
            present: HashSet::new(),
            known: HashSet::new(),
            due: BTreeMap::new(),
            settles: now + SETTLES_WITHIN,
            last: (now, clock),
        }
    }

    /// Advances the time. A station that was suspended may have missed stops: it exchanges with all
    /// members.
    pub(crate) fn handle_time(&mut self, now: Duration, clock: SystemTime) {
        let (before, clock_before) = self.last;
        self.last = (now, clock);
        let slept = clock.duration_since(clock_before).unwrap_or_default();
        if now.saturating_sub(before).max(slept) >= GAP {
            self.settles = now + SETTLES_WITHIN;
            self.due = self
                .present
                .iter()
                .map(|member| (member.clone(), now))
                .collect();
        }
    }

    /// Whether the station had time to learn the fleet's stops.
    pub(crate) fn is_settled(&self, now: Duration) -> bool {
        now >= self.settles
    }

    /// Handles an arrival. Of two stations that meet for the first time one starts the exchange.
    pub(crate) fn handle_arrival(&mut self, member: &MemberKey, now: Duration) {
        // A flood of names takes no more room here than in the roster.
        if *member == self.own || self.present.len() >= MAX_STATIONS {
            return;
        }
        if self.known.len() >= MAX_STATIONS {
            self.known.clone_from(&self.present);
        }
        let is_back = !self.known.insert(member.clone());
        self.present.insert(member.clone());
        if is_back || self.own < *member {
            self.due.insert(member.clone(), now);
        }
    }

    /// Handles a departure.
    pub(crate) fn handle_departure(&mut self, member: &MemberKey) {
        self.present.remove(member);
        self.due.remove(member);
    }

    /// Schedules a retry for a member that did not answer, while it is present.
    pub(crate) fn handle_silent(&mut self, member: &MemberKey, now: Duration) {
        if self.present.contains(member) {
            self.due.insert(member.clone(), now + RETRY_DELAY);
        }
    }

    /// Returns a member to exchange stops with now.
    pub(crate) fn poll_due(&mut self, now: Duration) -> Option<MemberKey> {
        let due = self.due.iter().find(|(_, at)| **at <= now);
        let member = due?.0.clone();
        self.due.remove(&member);
        Some(member)
    }
}

/// Exchanges stops with another station: sends those known here and adopts its own.
pub(crate) async fn exchange(
    requester: Option<&Requester>,
    handle: &StationHandle,
    member: &MemberKey,
) -> ApiAnswer {
    let learned = match requester {
        Some(requester) => ask(requester, handle, member).await,
        None => Err("cannot be reached yet".to_owned()),
    };
    match learned {
        Ok(()) => ApiAnswer {
            status: 200,
            body: json!({}),
        },
        Err(why) => ApiAnswer::of_problem(&MEMBER_AWAY.hinted(
            format!("{} {why}", member.name),
            "it learns of the stop when it returns",
        )),
    }
}

async fn ask(
    requester: &Requester,
    handle: &StationHandle,
    member: &MemberKey,
) -> Result<(), String> {
    let known = handle.adopt_fleet_stops(Vec::new()).await;
    let (known, _) = known.map_err(|refusal| refusal.to_string())?;
    let theirs = requester
        .ask_first(member, STOPS, &emit(&known), WITHIN)
        .await?;
    let theirs = parse(&theirs).map_err(|error| error.to_string())?;
    let adopted = handle.adopt_fleet_stops(theirs).await;
    adopted.map(drop).map_err(|refusal| refusal.to_string())
}

/// Adopts the stops of another station, and returns those known here.
pub(crate) async fn answer(handle: StationHandle, responder: Responder, query: Query) {
    let payload = query
        .payload()
        .map(|payload| payload.to_bytes())
        .unwrap_or_default();
    match parse(&payload) {
        // Without a response the sender retries.
        Err(error) => tracing::info!(%error, "ignored invalid stops of a member"),
        // A station that is ending sends nothing.
        Ok(theirs) => {
            if let Ok((known, _)) = handle.adopt_fleet_stops(theirs).await {
                responder.reply(&query, STOPS, &payload, emit(&known)).await;
            }
        }
    }
}

fn parse(payload: &[u8]) -> serde_json::Result<Vec<FleetWideStop>> {
    serde_json::from_slice(payload)
}

fn emit(stops: &[FleetWideStop]) -> Vec<u8> {
    serde_json::to_vec(stops).expect("structures with text keys are JSON")
}

/// The timeout of an exchange.
const WITHIN: Duration = Duration::from_secs(2);

#[cfg(test)]
mod tests {
    use super::*;

    fn key(name: &str) -> MemberKey {
        MemberKey {
            name: name.into(),
            id: "a".repeat(32),
        }
    }

    const fn at(seconds: u64) -> Duration {
        Duration::from_secs(seconds)
    }

    fn clock(seconds: u64) -> SystemTime {
        SystemTime::UNIX_EPOCH + at(1_000_000 + seconds)
    }

    /// A settled station of this name.
    fn settled(name: &str) -> StopExchange {
        let mut settled = StopExchange::new(key(name), at(0), clock(0));
        for second in 0..=4 {
            settled.handle_time(at(second), clock(second));
        }
        settled
    }

    fn due(settled: &mut StopExchange, now: Duration) -> Vec<String> {
        std::iter::from_fn(|| settled.poll_due(now))
            .map(|member| member.name)
            .collect()
    }

    #[test]
    fn when_two_stations_meet_for_the_first_time_one_informs_the_other() {
        let [mut one, mut other] = [settled("a"), settled("b")];
        one.handle_arrival(&key("b"), at(4));
        other.handle_arrival(&key("a"), at(4));
        assert_eq!(due(&mut one, at(4)), ["b"]);
        assert!(due(&mut other, at(4)).is_empty());
    }

    #[test]
    fn a_returning_station_is_informed_by_all() {
        let mut settled = settled("b");
        settled.handle_arrival(&key("a"), at(4));
        settled.handle_departure(&key("a"));
        settled.handle_arrival(&key("a"), at(5));
        assert_eq!(due(&mut settled, at(5)), ["a"]);
    }

    #[test]
    fn a_station_that_does_not_answer_is_informed_again_while_it_is_present() {
        let mut settled = settled("a");
        settled.handle_arrival(&key("b"), at(4));
        assert_eq!(due(&mut settled, at(4)), ["b"]);
        settled.handle_silent(&key("b"), at(6));
        assert!(due(&mut settled, at(6)).is_empty());
        assert_eq!(due(&mut settled, at(7)), ["b"]);
        settled.handle_departure(&key("b"));
        settled.handle_silent(&key("b"), at(8));
        assert!(due(&mut settled, at(20)).is_empty());
    }

    #[test]
    fn a_suspended_station_asks_all_others_before_it_is_settled_again() {
        // A frozen process sees the monotonic clock advance; a sleeping computer perhaps only the
        // system's clock.
        for (now, clock_now) in [(at(60), clock(60)), (at(4), clock(60))] {
            let mut settled = settled("b");
            settled.handle_arrival(&key("a"), at(4));
            assert!(due(&mut settled, at(4)).is_empty());
            assert!(settled.is_settled(at(4)));
            settled.handle_time(now, clock_now);
            assert!(!settled.is_settled(now));
            assert_eq!(due(&mut settled, now), ["a"]);
            assert!(settled.is_settled(now + SETTLES_WITHIN));
        }
    }

    #[test]
    fn a_clock_that_is_set_back_changes_nothing() {
        let mut settled = settled("a");
        settled.handle_time(at(5), clock(0));
        assert!(settled.is_settled(at(5)));
    }
}
