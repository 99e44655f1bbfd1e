//! Fleet-wide stops, as known to this station.

use std::collections::BTreeMap;

use dobot_api::FleetWideStop;
use serde::{Deserialize, Serialize};

use crate::plain;

/// The newest fleet-wide stop of each origin.
#[derive(Clone, Debug, Default)]
pub(super) struct FleetStops(BTreeMap<String, SavedFleetStop>);

/// A fleet-wide stop, and whether this arm was released from it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SavedFleetStop {
    /// The stop.
    pub stop: FleetWideStop,
    /// Whether a person at this station has cleared it for this arm alone.
    #[serde(default)]
    pub is_reset_here: bool,
}

/// The effect of a stop received from another station.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Adopted {
    /// No effect: already known.
    Known,
    /// It stops this arm.
    Stops,
    /// It no longer holds.
    Reset,
}

impl FleetStops {
    /// Restores the stops saved earlier.
    pub(super) fn of(kept: Vec<SavedFleetStop>) -> Self {
        let by_origin = |kept: SavedFleetStop| (kept.stop.origin.clone(), kept);
        Self(kept.into_iter().map(by_origin).collect())
    }

    /// Makes a fleet-wide stop at the station with the id `origin`. The count includes the time of
    /// its clock, so it is new even if the saved stops were lost.
    pub(super) fn make(
        &mut self,
        origin: &str,
        by: String,
        reason: Option<String>,
        now_ms: u64,
    ) -> FleetWideStop {
        let before = self.0.get(origin).map_or(0, |known| known.stop.count);
        let stop = FleetWideStop {
            origin: origin.to_owned(),
            count: now_ms.max(before + 1),
            by,
            reason,
            reset_by: None,
        };
        self.put(stop.clone(), false);
        stop
    }

    /// Adopts a stop from another station. A reset of the same stop is newer than the stop.
    pub(super) fn adopt(&mut self, other: &FleetWideStop) -> Adopted {
        let known = self.0.get(&other.origin);
        let age = |stop: &FleetWideStop| (stop.count, !stop.holds());
        let is_newer = known.is_none_or(|known| age(other) > age(&known.stop));
        let is_reset_here =
            known.is_some_and(|known| known.is_reset_here && known.stop.count == other.count);
        if !is_newer || other.count > MAX_COUNT || !self.has_room(&other.origin) {
            return Adopted::Known;
        }
        let text = |text: &Option<String>| text.as_ref().map(|text| plain(text, LONGEST));
        let stop = FleetWideStop {
            origin: other.origin.clone(),
            count: other.count,
            by: plain(&other.by, LONGEST),
            reason: text(&other.reason),
            reset_by: text(&other.reset_by),
        };
        self.put(stop, is_reset_here);
        if other.holds() {
            Adopted::Stops
        } else {
            Adopted::Reset
        }
    }

    /// Resets all stops for the whole fleet.
    pub(super) fn reset(&mut self, by: &str) {
        for kept in self.0.values_mut().filter(|kept| kept.stop.holds()) {
            kept.stop.reset_by = Some(by.to_owned());
        }
    }

    /// Clears all stops for this arm alone.
    pub(super) fn reset_here(&mut self) {
        for kept in self.0.values_mut() {
            kept.is_reset_here = true;
        }
    }

    /// Returns the stop that holds this arm; if there are several, the newest by their stations'
    /// clocks.
    pub(super) fn holding(&self) -> Option<&FleetWideStop> {
        let holding = self.0.values();
        let holding = holding.filter(|holding| holding.stop.holds() && !holding.is_reset_here);
        holding
            .map(|holding| &holding.stop)
            .max_by_key(|stop| stop.count)
    }

    pub(super) fn all(&self) -> Vec<FleetWideStop> {
        self.0.values().map(|kept| kept.stop.clone()).collect()
    }

    pub(super) fn kept(&self) -> Vec<SavedFleetStop> {
        self.0.values().cloned().collect()
    }

    fn put(&mut self, stop: FleetWideStop, is_reset_here: bool) {
        let origin = stop.origin.clone();
        let kept = SavedFleetStop {
            stop,
            is_reset_here,
        };
        self.0.insert(origin, kept);
    }

    /// Returns whether there is room for a stop of this origin. A stop that holds is never dropped
    /// for another one.
    fn has_room(&mut self, origin: &str) -> bool {
        if origin.len() > LONGEST {
            return false;
        }
        if self.0.len() >= MAX_STATIONS && !self.0.contains_key(origin) {
            let over = self.0.iter().find(|(_, kept)| !kept.stop.holds());
            let over = over.map(|(origin, _)| origin.clone());
            return over.is_some_and(|over| self.0.remove(&over).is_some());
        }
        true
    }
}

/// The maximum number of stations in a fleet.
const MAX_STATIONS: usize = 2000;
/// The largest integer that every JSON reader preserves.
const MAX_COUNT: u64 = 1 << 53;
/// The maximum characters kept of a text, and the maximum bytes of an origin.
const LONGEST: usize = 200;

#[cfg(test)]
mod tests {
    use super::*;

    fn stop(origin: &str, count: u64) -> FleetWideStop {
        FleetWideStop {
            origin: origin.into(),
            count,
            by: "Ms Weber".into(),
            reason: Some("fire drill".into()),
            reset_by: None,
        }
    }

    fn reset(origin: &str, count: u64) -> FleetWideStop {
        FleetWideStop {
            reset_by: Some("Ms Weber".into()),
            ..stop(origin, count)
        }
    }

    /// Returns what a station knows after these messages.
    fn after(messages: &[FleetWideStop]) -> FleetStops {
        let mut stops = FleetStops::default();
        for message in messages {
            stops.adopt(message);
        }
        stops
    }

    #[test]
    fn all_stations_agree_in_the_end_for_any_order_of_the_messages() {
        let messages = [stop("a", 5), reset("a", 5), stop("a", 7), stop("b", 6)];
        let known = after(&messages).all();
        for first in 0..messages.len() {
            for second in 0..messages.len() {
                let mut others = messages.clone();
                others.swap(0, first);
                others.swap(1, second);
                assert_eq!(after(&others).all(), known, "{others:?}");
            }
        }
        assert_eq!(known, [stop("a", 7), stop("b", 6)]);
    }

    #[test]
    fn a_reset_ends_only_the_stops_that_its_station_knew() {
        // Two stops at the same time, in two halves of a network: one half is reset before it
        // receives the other's stop.
        let mut one = after(&[stop("a", 5)]);
        one.reset("Ms Weber");
        assert_eq!(one.adopt(&stop("b", 4)), Adopted::Stops);
        assert_eq!(one.holding().map(|holding| &*holding.origin), Some("b"));
        assert_eq!(one.adopt(&stop("a", 5)), Adopted::Known);
    }

    #[test]
    fn a_stop_made_after_a_reset_holds_even_with_a_clock_that_went_back() {
        let mut stops = FleetStops::default();
        let first = stops.make("a", "Anna".into(), None, 1000);
        stops.reset("Anna");
        let second = stops.make("a", "Anna".into(), None, 10);
        assert!(second.count > first.count);
        let mut other = after(&[first, reset("a", 1000)]);
        assert_eq!(other.adopt(&second), Adopted::Stops);
    }

    #[test]
    fn an_arm_reset_by_a_person_is_not_stopped_by_the_same_stop_but_by_a_newer_one() {
        let mut stops = after(&[stop("a", 5)]);
        stops.reset_here();
        assert_eq!(stops.adopt(&stop("a", 5)), Adopted::Known);
        assert_eq!(stops.holding(), None);
        assert!(stops.all()[0].holds(), "it holds for the others");
        assert_eq!(stops.adopt(&stop("a", 6)), Adopted::Stops);
        assert!(stops.holding().is_some());
    }

    #[test]
    fn a_flood_of_origins_is_bounded_and_displaces_no_active_stop() {
        let mut stops = after(&[stop("a", 5)]);
        for number in 0..2 * MAX_STATIONS {
            stops.adopt(&reset(&format!("flood-{number}"), 1));
        }
        assert_eq!(stops.all().len(), MAX_STATIONS);
        assert!(stops.holding().is_some());
        let long = "x".repeat(1000);
        assert_eq!(stops.adopt(&stop(&long, 1)), Adopted::Known);
    }
}
