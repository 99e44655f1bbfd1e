//! Anyone may stop the arm, and it stays stopped until a person resets that.

use std::time::Duration;

use dobot_api::{FleetWideStop, StopView};
use serde::{Deserialize, Serialize};

use super::fleet_stops::{Adopted, FleetStops, KeptFleetStop};
use super::still_moving;
use crate::refusal::Refusal;

/// Who stopped the arm, and why.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StoppedBy {
    /// Who.
    pub by: String,
    /// Why.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

/// The stop that holds the arm, if one does: its own, one of the whole fleet, or both.
#[derive(Debug, Default)]
pub(super) struct StopLatch {
    /// Who stopped this arm alone.
    own: Option<StoppedBy>,
    fleet: FleetStops,
    holding: Option<Holding>,
    /// Whether what is kept on the disk is older.
    is_changed: bool,
}

/// How far the arm is that is being stopped.
#[derive(Debug)]
struct Holding {
    at: Duration,
    rests_by: Duration,
    at_rest: bool,
    delivered: bool,
    /// When people are told again that it was not delivered.
    again: Duration,
    /// Who stopped the arm last, for as long as it comes to rest after a reset.
    last: (StoppedBy, bool),
}

impl StopLatch {
    /// Takes that somebody stops this arm; says what is to be told, unless that is known.
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

    /// Takes that somebody at this station stops the whole fleet.
    pub(super) fn make_fleet_stop(
        &mut self,
        origin: &str,
        by: StoppedBy,
        now_ms: u64,
    ) -> FleetWideStop {
        self.is_changed = true;
        self.fleet.make(origin, by.by, by.reason, now_ms)
    }

    /// Takes what other stations know; says whether one of these stops is to stop the arm. [`StopLatch::hold`] does it.
    pub(super) fn adopt(&mut self, stops: &[FleetWideStop]) -> bool {
        let mut is_stopping = false;
        for stop in stops {
            let adopted = self.fleet.adopt(stop);
            self.is_changed |= adopted != Adopted::Known;
            is_stopping |= adopted == Adopted::Stops;
        }
        is_stopping
    }

    /// Takes that somebody lets the whole fleet move again.
    pub(super) fn reset_fleet(&mut self, by: &str) {
        self.fleet.reset(by);
        self.is_changed = true;
    }

    /// Holds the arm for what stops it now; says what is to be told, unless that is known.
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
        self.check().err().map(|it| it.to_string())
    }

    /// Takes what held before the station was started.
    pub(super) fn handle_kept(
        &mut self,
        now: Duration,
        own: Option<StoppedBy>,
        fleet: Vec<KeptFleetStop>,
    ) {
        self.own = own;
        self.fleet = FleetStops::of(fleet);
        // The first packet to an arm that is found switches its laser off.
        self.hold(now, Duration::ZERO, true);
    }

    /// Takes that the packets which stop the arm leave this computer now; says whether people waited for that.
    pub(super) fn handle_delivered(&mut self) -> bool {
        let waits = self.holding.as_mut().filter(|it| !it.delivered);
        waits.map(|it| it.delivered = true).is_some()
    }

    /// When people are told again that it was not delivered.
    pub(super) fn wakeup(&self) -> Option<Duration> {
        let waits = self.holding.as_ref().filter(|it| !it.delivered);
        waits.map(|it| it.again)
    }

    /// Whether people are told now that it was not delivered.
    pub(super) fn is_due(&mut self, now: Duration) -> bool {
        let waits = self.holding.as_mut().filter(|it| !it.delivered);
        let due = waits.filter(|it| it.again <= now);
        due.map(|it| it.again = now + EVERY).is_some()
    }

    /// Lets this arm go, whatever stopped it; says whether there was a stop. The arm has to have been seen at rest.
    pub(super) fn reset(&mut self, now: Duration, is_linked: bool) -> Result<bool, Refusal> {
        if let Some(stop) = self.holding.as_ref().filter(|it| !it.at_rest) {
            if !is_linked {
                let why = "whether it rests cannot be seen, so the stop holds";
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

    /// Lets the arm go once nothing stops it any more; says whether it does so now. An arm that was met has to have been seen
    /// at rest.
    pub(super) fn release(&mut self, was_met: bool) -> bool {
        let is_over = self.cause().is_none();
        let over = self
            .holding
            .take_if(|it| is_over && (it.at_rest || !was_met));
        if let (None, Some(cause), Some(holding)) = (&over, self.cause(), &mut self.holding) {
            holding.last = cause;
        }
        over.is_some()
    }

    /// Whether no stop holds the arm.
    pub(super) fn check(&self) -> Result<(), Refusal> {
        match &self.holding {
            None => Ok(()),
            Some(Holding {
                last: (stop, of_fleet),
                ..
            }) => Err(Refusal::Stopped {
                by: stop.by.clone(),
                reason: stop.reason.clone(),
                of_fleet: *of_fleet,
            }),
        }
    }

    pub(super) const fn holds(&self) -> bool {
        self.holding.is_some()
    }

    /// With each status: says whether the arm has come to rest now.
    pub(super) fn handle_status(&mut self, rests: bool) -> bool {
        let moving = self.holding.as_mut().filter(|it| !it.at_rest && rests);
        moving.map(|it| it.at_rest = true).is_some()
    }

    pub(super) fn view(&self) -> Option<StopView> {
        self.holding.as_ref().map(|it| StopView {
            by: it.last.0.by.clone(),
            reason: it.last.0.reason.clone(),
            at_s: it.at.as_secs_f64(),
            rests_by_s: it.rests_by.as_secs_f64(),
            at_rest: it.at_rest,
            delivered: it.delivered,
            of_fleet: it.last.1,
        })
    }

    pub(super) fn fleet_stops(&self) -> Vec<FleetWideStop> {
        self.fleet.all()
    }

    /// What is to be kept on the disk, if that is new.
    pub(super) fn poll_kept(&mut self) -> Option<(Option<StoppedBy>, Vec<KeptFleetStop>)> {
        let is_changed = std::mem::take(&mut self.is_changed);
        is_changed.then(|| (self.own.clone(), self.fleet.kept()))
    }

    /// What stops the arm, and whether that is the fleet: whoever resets it must know of a stop of the fleet first.
    fn cause(&self) -> Option<(StoppedBy, bool)> {
        let fleet = self.fleet.holding().map(|it| StoppedBy {
            by: it.by.clone(),
            reason: it.reason.clone(),
        });
        let own = self.own.clone().map(|it| (it, false));
        fleet.map(|it| (it, true)).or(own)
    }
}

/// How often people are told that a stop was not delivered.
const EVERY: Duration = Duration::from_secs(1);
/// Three statuses.
const SOON: Duration = Duration::from_millis(240);
