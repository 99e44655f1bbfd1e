//! The messages of clients, of other stations and of this process.

use std::time::Duration;

use dobot_api::{CalibrationFile, Calibrations, ClientId, FleetWideStop, Reply};
use dobot_safety::Policy;
use dobot_supervisor::{Refusal, StoppedBy};

use super::{Driver, now_ms};
use crate::handle::Message;
use crate::host::scaled_to_arm_time;

impl Driver {
    pub(super) fn handle(&mut self, message: Message) {
        let now = self.now();
        match message {
            Message::Came {
                name,
                person,
                device,
                role,
                reply,
            } => {
                let client = self.supervisor.handle_client(now, &name, role, &person);
                self.supervisor.handle_device(client, device);
                tracing::debug!(client = client.0, name, ?role, "a client came");
                if reply.send(client).is_err() {
                    self.supervisor.handle_left(now, client);
                }
            }
            Message::Left(client) => {
                tracing::debug!(client = client.0, "a client left");
                self.waiting.remove(&client);
                self.supervisor.handle_left(now, client);
            }
            Message::Asked {
                client,
                request,
                reply,
            } => self.ask(client, request, reply),
            Message::Raw {
                client,
                packet,
                reply,
            } => {
                let taken = self.supervisor.handle_raw(now, client, &packet);
                self.send();
                // The program may have left.
                let _ = reply.send(taken);
            }
            Message::Planned {
                client,
                started,
                reply,
            } => {
                let answer = self.supervisor.handle_start(now, client, *started);
                let _ = reply.send(answer);
            }
            Message::Answered { longer, reply } => self.handle_answered(now, longer, reply),
            Message::Jobs(reply) => self.jobs.clone().list(self.supervisor.job(), reply),
            Message::Policy {
                client,
                policy,
                reply,
            } => {
                let changed = self.set_policy(now, client, &policy);
                // The requester may have left.
                let _ = reply.send(changed);
            }
            Message::JobPath { job, reply } => self.jobs.clone().path(job, reply),
            Message::Offer { key, ask, reply } => {
                let model = self.supervisor.planning_model();
                let jobs = self.jobs.clone();
                jobs.answer_offer(key, ask, model, now_ms(), reply);
            }
            Message::FleetStop { origin, by, reply } => {
                let _ = reply.send(self.stop_fleet(now, &origin, by));
            }
            Message::FleetStops { stops, reply } => {
                let _ = reply.send(self.adopt_fleet_stops(now, &stops));
            }
            Message::FleetReset { by, reply } => {
                let _ = reply.send(self.supervisor.handle_fleet_reset(now, &by));
            }
            Message::Trouble(text) => self.supervisor.handle_trouble(now, text),
            Message::Buttons(text) => self.supervisor.handle_buttons_changed(now, text),
            Message::Failed(text) => self.fail(text),
            Message::End => self.end(),
        }
    }

    /// Stops the whole fleet from here. Returns the stop, and how this arm stops.
    fn stop_fleet(&mut self, now: Duration, origin: &str, by: StoppedBy) -> (FleetWideStop, Reply) {
        self.drop_held_start();
        // With a clock before 1970, the count continues from the last stop.
        let now_ms = u64::try_from(now_ms()).unwrap_or_default();
        let stopped = self.supervisor.handle_fleet_stop(now, origin, by, now_ms);
        self.send();
        stopped
    }

    /// Adopts the fleet-wide stops of another station. Returns those known here, and how this arm stops
    /// if a stop holds it.
    fn adopt_fleet_stops(
        &mut self,
        now: Duration,
        stops: &[FleetWideStop],
    ) -> (Vec<FleetWideStop>, Option<Reply>) {
        let stopped = self.supervisor.handle_fleet_stops(now, stops);
        self.send();
        if stopped.is_some() {
            self.drop_held_start();
        }
        (self.supervisor.state().fleet_stops, stopped)
    }

    fn set_policy(
        &mut self,
        now: Duration,
        client: ClientId,
        policy: &Policy,
    ) -> Result<(), Refusal> {
        let of_arm = scaled_to_arm_time(policy, self.source.speed());
        self.supervisor.handle_policy(now, client, of_arm)?;
        self.jobs.set_policy(policy);
        self.recording.tools(now, policy);
        self.channels.change_rules(|rules| {
            rules.policy = policy.clone();
            rules.dead_man_s = policy.jog.dead_man_s;
        });
        Ok(())
    }

    /// Sets the calibration and saves it for this arm.
    pub(super) fn calibrate(
        &mut self,
        now: Duration,
        client: ClientId,
        calibration: Option<CalibrationFile>,
    ) -> Result<Calibrations, Refusal> {
        calibration.as_ref().map_or(Ok(()), check_calibration)?;
        let Some(address) = self.address.clone() else {
            return Err(Refusal::NoLink(
                "a calibration is saved for an arm, and none has been connected yet".into(),
            ));
        };
        let calibrations = self.arms.calibrations(&address).replaced_by(calibration);
        self.supervisor
            .handle_calibration(now, client, &calibrations)?;
        let new = self.arms.calibrate(&address, calibrations.clone());
        self.write_file(new, "the calibration of the arm cannot be saved");
        self.channels
            .change_rules(|rules| rules.calibrations = calibrations.clone());
        Ok(calibrations)
    }
}

fn check_calibration(calibration: &CalibrationFile) -> Result<(), Refusal> {
    calibration.check().map_err(|error| Refusal::OutOfRange {
        name: error.key,
        found: error.found,
        allowed: format!("{} to {}", error.least, error.most),
    })
}
