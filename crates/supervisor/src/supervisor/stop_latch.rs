//! The stop latch: any client may stop the arm, and it stays stopped until a person clears the
//! stop.

use std::time::Duration;

use dobot_api::{ClientId, Device, FleetWideStop, StopView};
use serde::{Deserialize, Serialize};

use super::fleet_stops::{Adopted, FleetStops, SavedFleetStop};
use super::still_moving;
use crate::refusal::Refusal;

/// Who stopped the arm, and why.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StoppedBy {
    /// The name.
    pub by: String,
    /// The device, if it was a page.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub device: Option<Device>,
    /// The client, if it is one of this station; not saved, because numbers start again.
    #[serde(skip)]
    pub client: Option<ClientId>,
    /// The reason.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

/// The stop that holds the arm, if any: its own, one of the whole fleet, or both.
#[derive(Debug, Default)]
pub(super) struct StopLatch {
    /// The stop of this arm alone.
    own: Option<StoppedBy>,
    fleet: FleetStops,
    holding: Option<Holding>,
    /// Whether the saved stops are out of date.
    is_changed: bool,
}

/// The progress of a stop.
#[derive(Debug)]
struct Holding {
    at: Duration,
    rests_by: Duration,
    at_rest: bool,
    delivered: bool,
    /// When a missing delivery is reported again.
    again: Duration,
    /// The last cause, for an arm that still comes to rest after a reset; true for a fleet-wide
    /// stop.
    last: (StoppedBy, bool),
}

impl StopLatch {
    /// Stops this arm; returns the text to publish, unless it is known.
    pub(super) fn handle_stop(
        &mut self,
        now: Duration,
        by: StoppedBy,
        rests_within: Duration,
        delivered: bool,
    ) -> Option<String> {
        if self.own.is_none() {
            self.own = Some(by);
            self.is_changed = true;
        }
        self.hold(now, rests_within, delivered)
    }

    /// Makes a fleet-wide stop.
    pub(super) fn make_fleet_stop(
        &mut self,
        origin: &str,
        by: StoppedBy,
        now_ms: u64,
    ) -> FleetWideStop {
        self.is_changed = true;
        self.fleet.make(origin, by.by, by.reason, now_ms)
    }

    /// Adopts stops known to other stations; returns whether one of them stops the arm.
    /// [`StopLatch::hold`] then does so.
    pub(super) fn adopt(&mut self, stops: &[FleetWideStop]) -> bool {
        let mut is_stopping = false;
        for stop in stops {
            let adopted = self.fleet.adopt(stop);
            self.is_changed |= adopted != Adopted::Known;
            is_stopping |= adopted == Adopted::Stops;
        }
        is_stopping
    }

    /// Resets the fleet-wide stops.
    pub(super) fn reset_fleet(&mut self, by: &str) {
        self.fleet.reset(by);
        self.is_changed = true;
    }

    /// Holds the arm for its current stop; returns the text to publish, unless it is known.
    pub(super) fn hold(
        &mut self,
        now: Duration,
        rests_within: Duration,
        delivered: bool,
    ) -> Option<String> {
        let last = self.cause()?;
        let holding = self.holding.get_or_insert_with(|| Holding {
            at: now,
            rests_by: now + rests_within,
            at_rest: false,
            delivered,
            again: now + EVERY,
            last: (StoppedBy::default(), false),
        });
        holding.delivered |= delivered;
        if holding.last == last {
            return None;
        }
        holding.last = last;
        self.check().err().map(|refusal| refusal.to_string())
    }

    /// Restores the stops saved before the station started.
    pub(super) fn handle_saved(
        &mut self,
        now: Duration,
        own: Option<StoppedBy>,
        fleet: Vec<SavedFleetStop>,
    ) {
        self.own = own;
        self.fleet = FleetStops::of(fleet);
        // The first packet to an arm that is found switches its laser off.
        self.hold(now, Duration::ZERO, true);
    }

    /// Handles delivery of the stop packets; returns whether it was outstanding.
    pub(super) fn handle_delivered(&mut self) -> bool {
        let waits = self.holding.as_mut().filter(|holding| !holding.delivered);
        waits.map(|holding| holding.delivered = true).is_some()
    }

    /// Returns when a missing delivery is reported again.
    pub(super) fn wakeup(&self) -> Option<Duration> {
        let waits = self.holding.as_ref().filter(|holding| !holding.delivered);
        waits.map(|holding| holding.again)
    }

    /// Returns whether a missing delivery is to be reported now.
    pub(super) fn is_due(&mut self, now: Duration) -> bool {
        let waits = self.holding.as_mut().filter(|holding| !holding.delivered);
        let due = waits.filter(|holding| holding.again <= now);
        due.map(|holding| holding.again = now + EVERY).is_some()
    }

    /// Clears the stop of this arm, whatever its cause; returns whether there was one. The arm must
    /// have been seen at rest.
    pub(super) fn reset(&mut self, now: Duration, is_linked: bool) -> Result<bool, Refusal> {
        if let Some(stop) = self.holding.as_ref().filter(|holding| !holding.at_rest) {
            if !is_linked {
                let why = "the arm cannot be seen at rest, so the stop holds";
                return Err(Refusal::NoLink(why.to_owned()));
            }
            let within = stop.rests_by.saturating_sub(now).max(SOON);
            return Err(still_moving(within));
        }
        self.own = None;
        self.fleet.reset_here();
        self.is_changed = true;
        Ok(self.holding.take().is_some())
    }

    /// Releases the arm once no stop holds it; returns whether that happens now. An arm that has
    /// been connected must have been seen at rest.
    pub(super) fn release(&mut self, was_met: bool) -> bool {
        let is_over = self.cause().is_none();
        let over = self
            .holding
            .take_if(|holding| is_over && (holding.at_rest || !was_met));
        if let (None, Some(cause), Some(holding)) = (&over, self.cause(), &mut self.holding) {
            holding.last = cause;
        }
        over.is_some()
    }

    /// Checks that no stop holds the arm.
    pub(super) fn check(&self) -> Result<(), Refusal> {
        match &self.holding {
            None => Ok(()),
            Some(Holding {
                last: (stop, of_fleet),
                ..
            }) => Err(Refusal::Stopped {
                by: Device::named(&stop.by, stop.device),
                reason: stop.reason.clone(),
                of_fleet: *of_fleet,
            }),
        }
    }

    pub(super) const fn holds(&self) -> bool {
        self.holding.is_some()
    }

    /// Handles a status; returns whether the arm has just come to rest.
    pub(super) fn handle_status(&mut self, rests: bool) -> bool {
        let moving = self
            .holding
            .as_mut()
            .filter(|holding| !holding.at_rest && rests);
        moving.map(|holding| holding.at_rest = true).is_some()
    }

    pub(super) fn view(&self) -> Option<StopView> {
        self.holding.as_ref().map(|holding| StopView {
            by: holding.last.0.by.clone(),
            device: holding.last.0.device,
            client: holding.last.0.client,
            reason: holding.last.0.reason.clone(),
            at_s: holding.at.as_secs_f64(),
            rests_by_s: holding.rests_by.as_secs_f64(),
            at_rest: holding.at_rest,
            delivered: holding.delivered,
            of_fleet: holding.last.1,
        })
    }

    pub(super) fn fleet_stops(&self) -> Vec<FleetWideStop> {
        self.fleet.all()
    }

    /// Returns the stops to save, if they have changed.
    pub(super) fn poll_saved(&mut self) -> Option<(Option<StoppedBy>, Vec<SavedFleetStop>)> {
        let is_changed = std::mem::take(&mut self.is_changed);
        is_changed.then(|| (self.own.clone(), self.fleet.kept()))
    }

    /// Returns the cause of the stop, and whether it is the fleet's: a person who clears it must
    /// know about a fleet-wide stop first.
    fn cause(&self) -> Option<(StoppedBy, bool)> {
        let fleet = self.fleet.holding().map(|stop| StoppedBy {
            by: stop.by.clone(),
            reason: stop.reason.clone(),
            ..StoppedBy::default()
        });
        let own = self.own.clone().map(|stop| (stop, false));
        fleet.map(|stop| (stop, true)).or(own)
    }
}

/// The interval of reports that a stop was not delivered.
const EVERY: Duration = Duration::from_secs(1);
/// Three statuses.
const SOON: Duration = Duration::from_millis(240);
