//! Looks on at the station, tells what it sees, and has a stop at hand.

use std::sync::Arc;
use std::time::Duration;

use dobot_api::{LinkPhase, News, State, StationEvent};
use dobot_host::StationClient;
use dobot_model::Model;
use dobot_safety::Policy;
use tokio::sync::{mpsc, oneshot};
use tokio::time::{Instant, sleep_until};

use crate::acts::stop;
use crate::diagnostics;
use crate::frames::Frames;
use crate::joints::joint_state;
use crate::node::Publishers;
use crate::settings::NODE;
use crate::station::{Station, refused};
use crate::told::Told;

/// Somebody wants the arm to stop, and to know what became of it.
pub(crate) type WantedStop = oneshot::Sender<Result<String, String>>;

/// Tells what the station tells.
pub(crate) struct Watch {
    pub(crate) station: Station,
    pub(crate) publishers: Publishers,
    pub(crate) frames: Frames,
    pub(crate) model: Model,
    pub(crate) told: Arc<Told>,
    pub(crate) stops: mpsc::Receiver<WantedStop>,
    pub(crate) policy: Option<Policy>,
    /// When the diagnostics were told last, in seconds since the station started.
    pub(crate) diagnosed_s: Option<f64>,
}

impl Watch {
    /// For ever: a station that is gone is looked for again.
    pub(crate) async fn run(mut self) {
        self.describe();
        let mut said = None;
        loop {
            let why = match self.station.connect("watch").await {
                Ok(client) => {
                    self.told.info("the station is there");
                    said = None;
                    self.diagnosed_s = None;
                    self.policy = self.station.policy().await;
                    self.look(client).await
                }
                Err(why) => why,
            };
            if said.as_ref() != Some(&why) {
                self.told.warn(&why);
            }
            self.wait(&why).await;
            said = Some(why);
        }
    }

    /// What never changes.
    fn describe(&self) {
        let _ = self.publishers.description.publish(self.model.to_urdf());
        let fixed = self
            .frames
            .transforms(&self.model, &dobot_wire::Status::AT_ZERO, true);
        let _ = self.publishers.tf_static.publish(fixed);
    }

    /// Tells states until the connection ends, and why it did.
    async fn look(&mut self, mut client: StationClient) -> String {
        loop {
            tokio::select! {
                Some(wanted) = self.stops.recv() => {
                    let _ = wanted.send(stop(&mut client, "a program of ROS 2 asked for it").await);
                }
                event = client.next() => match event {
                    Ok(StationEvent::State(state)) => self.tell(&state),
                    Ok(StationEvent::Notice(notice)) => {
                        if notice.news == News::PolicyChanged {
                            self.policy = self.station.policy().await;
                        }
                    }
                    Err(error) => return refused(&error),
                },
            }
        }
    }

    /// A second without a station.
    async fn wait(&mut self, why: &str) {
        let silent = diagnostics::of_no_station(NODE, why);
        let _ = self.publishers.diagnostics.publish(silent);
        let until = Instant::now() + AGAIN;
        loop {
            tokio::select! {
                Some(wanted) = self.stops.recv() => {
                    let _ = wanted.send(Err(format!("the stop cannot be passed on: {why}")));
                }
                () = sleep_until(until) => return,
            }
        }
    }

    /// What somebody does not take now, he takes from the next state.
    fn tell(&mut self, state: &State) {
        if let (Some(arm), LinkPhase::Up) = (&state.arm, state.link.phase) {
            let moving = self.frames.transforms(&self.model, &arm.status, false);
            let _ = self
                .publishers
                .joint_states
                .publish(joint_state(&arm.status));
            let _ = self.publishers.tf.publish(moving);
        }
        let last_s = self.diagnosed_s.unwrap_or(f64::NEG_INFINITY);
        if state.at_s - last_s >= DIAGNOSED_S {
            self.diagnosed_s = Some(state.at_s);
            let found = diagnostics::of_state(NODE, state, self.policy.as_ref());
            let _ = self.publishers.diagnostics.publish(found);
        }
    }
}

/// How long a station that is not there is left alone.
const AGAIN: Duration = Duration::from_secs(1);
/// How often the diagnostics are told.
const DIAGNOSED_S: f64 = 1.0;
