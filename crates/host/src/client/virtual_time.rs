//! A client of a supervisor and a virtual arm in virtual time.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_api::{ClientId, JobView, Reply, Request, StationEvent};
use dobot_controller::PowerUp;
use dobot_safety::Policy;
use dobot_sim::VirtualArm;
use dobot_supervisor::Refusal;

use crate::{Rules, VirtualStation};

/// A client of a supervisor in virtual time: time passes while it waits.
#[derive(Debug)]
pub(super) struct VirtualTimeClient {
    station: VirtualStation,
    client: ClientId,
    /// Events not taken yet; only the last of several states, unless each is requested.
    events: VecDeque<StationEvent>,
    /// The number of notices taken.
    taken: usize,
    dead_man_s: f64,
}

impl VirtualTimeClient {
    pub(super) fn new(arm: VirtualArm, power_up: PowerUp, policy: Policy, name: &str) -> Self {
        let dead_man_s = policy.jog.dead_man_s;
        let mut station = VirtualStation::with_arm(arm, power_up, policy);
        station.free_laser();
        let client = station.client(name);
        Self {
            station,
            client,
            events: VecDeque::new(),
            taken: 0,
            dead_man_s,
        }
    }

    pub(super) fn request(&mut self, request: Request) -> Result<Reply, Refusal> {
        self.station.ask(self.client, request)
    }

    /// Lets time pass until the next event.
    pub(super) fn next(&mut self) -> StationEvent {
        loop {
            if let Some(event) = self.next_within(Duration::MAX) {
                return event;
            }
        }
    }

    /// Lets time pass until the next event, at most this long.
    pub(super) fn next_within(&mut self, time: Duration) -> Option<StationEvent> {
        let until = self.station.now().saturating_add(time);
        loop {
            self.listen();
            let event = self.events.pop_front();
            if event.is_some() || self.station.now() >= until {
                return event;
            }
            self.station.step(until);
        }
    }

    pub(super) fn wait(&mut self, time: Duration) {
        let until = self.station.now() + time;
        while self.station.now() < until {
            self.station.step(until);
            self.listen();
        }
    }

    pub(super) const fn dead_man_s(&self) -> f64 {
        self.dead_man_s
    }

    pub(super) const fn now(&self) -> Duration {
        self.station.now()
    }

    pub(super) const fn id(&self) -> ClientId {
        self.client
    }

    pub(super) fn jobs(&mut self) -> Result<Vec<JobView>, Refusal> {
        self.station.jobs()
    }

    pub(super) fn rules(&self) -> Rules {
        self.station.rules()
    }

    pub(super) const fn arm(&self) -> &VirtualArm {
        self.station.arm()
    }

    pub(super) const fn arm_mut(&mut self) -> &mut VirtualArm {
        self.station.arm_mut()
    }

    fn listen(&mut self) {
        let notices = self.station.notices();
        let news = notices[self.taken..]
            .iter()
            .cloned()
            .map(StationEvent::Notice);
        self.events.extend(news);
        self.taken = notices.len();
        if self.station.poll_status() {
            self.events
                .retain(|event| !matches!(event, StationEvent::State(_)));
            let state = Box::new(self.station.supervisor().state());
            self.events.push_back(StationEvent::State(state));
        }
    }
}
