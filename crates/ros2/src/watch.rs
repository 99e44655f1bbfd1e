//! Observes the station, publishes its state, and forwards stops.

use std::sync::Arc;
use std::time::Duration;

use dobot_api::{LinkPhase, News, State, StationEvent};
use dobot_host::StationClient;
use dobot_model::Model;
use dobot_safety::Policy;
use tokio::sync::{mpsc, oneshot};
use tokio::time::{Instant, sleep_until};

use crate::actions::stop;
use crate::diagnostics;
use crate::frames::Frames;
use crate::joints::{Velocities, degrees_of, joint_state};
use crate::log::Log;
use crate::node::Publishers;
use crate::settings::NODE;
use crate::station::{Station, refused};

/// A request to stop the arm, with the channel for its outcome.
pub(crate) type WantedStop = oneshot::Sender<Result<String, String>>;

/// Publishes the station's state.
pub(crate) struct Watch {
    pub(crate) station: Station,
    pub(crate) publishers: Publishers,
    pub(crate) frames: Frames,
    pub(crate) model: Model,
    pub(crate) log: Arc<Log>,
    pub(crate) stops: mpsc::Receiver<WantedStop>,
    pub(crate) policy: Option<Policy>,
    /// The time of the last diagnostics, in seconds since the station started.
    pub(crate) diagnosed_s: Option<f64>,
    pub(crate) velocities: Velocities,
}

impl Watch {
    /// Runs forever, reconnecting to the station when the connection is lost.
    pub(crate) async fn run(mut self) {
        self.describe();
        let mut reported = None;
        loop {
            let why = match self.station.connect("watch").await {
                Ok(client) => {
                    self.log.info("connected to the station");
                    reported = None;
                    self.diagnosed_s = None;
                    self.policy = self.station.policy().await;
                    self.look(client).await
                }
                Err(why) => why,
            };
            if reported.as_ref() != Some(&why) {
                self.log.warn(&why);
            }
            self.wait(&why).await;
            reported = Some(why);
        }
    }

    /// Publishes static data.
    fn describe(&self) {
        let _ = self.publishers.description.publish(self.model.to_urdf());
        let fixed = self
            .frames
            .transforms(&self.model, &dobot_wire::Status::AT_ZERO, true);
        let _ = self.publishers.tf_static.publish(fixed);
    }

    /// Publishes states until the connection ends; returns the reason.
    async fn look(&mut self, mut client: StationClient) -> String {
        loop {
            tokio::select! {
                Some(wanted) = self.stops.recv() => {
                    let _ = wanted.send(stop(&mut client, "requested by a ROS 2 node").await);
                }
                event = client.next() => match event {
                    Ok(StationEvent::State(state)) => self.publish(&state),
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

    /// Waits a second while there is no station.
    async fn wait(&mut self, why: &str) {
        let silent = diagnostics::of_no_station(NODE, why);
        let _ = self.publishers.diagnostics.publish(silent);
        let until = Instant::now() + RETRY_DELAY;
        loop {
            tokio::select! {
                Some(wanted) = self.stops.recv() => {
                    let _ = wanted.send(Err(format!("cannot forward the stop: {why}")));
                }
                () = sleep_until(until) => return,
            }
        }
    }

    /// Publishes a state. What is not delivered is replaced by the next state.
    fn publish(&mut self, state: &State) {
        if let (Some(arm), LinkPhase::Up) = (&state.arm, state.link.phase) {
            let moving = self.frames.transforms(&self.model, &arm.status, false);
            let velocities = self.velocities.at(state.at_s, degrees_of(&arm.status));
            let joints = joint_state(&arm.status, velocities);
            let _ = self.publishers.joint_states.publish(joints);
            let _ = self.publishers.pose.publish(self.frames.pose(&arm.status));
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

/// The delay before the station is searched again.
const RETRY_DELAY: Duration = Duration::from_secs(1);
/// The period of diagnostics, in seconds.
const DIAGNOSED_S: f64 = 1.0;
