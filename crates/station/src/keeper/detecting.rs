//! Finding out which dialect the arm speaks, while nobody else moves it.

use std::time::Duration;

use dobot_arm::{Joints, Tool};
use dobot_client::Detection;
use dobot_course::Place;
use dobot_wire::Status;

use super::Keeper;
use crate::words::{ClientId, Refusal, Reply};

/// A detection that is under way, and who asked for it.
#[derive(Debug)]
pub(super) struct Detecting {
    client: ClientId,
    detection: Detection,
}

impl Keeper {
    /// Begins; the answer comes when the arm has made its motions.
    pub(super) fn detect(&mut self, client: ClientId) -> Option<Result<Reply, Refusal>> {
        match self.begin_detection(client) {
            Ok(detecting) => {
                self.detecting = Some(detecting);
                self.halt.forget();
                None
            }
            Err(refusal) => Some(Err(refusal)),
        }
    }

    fn begin_detection(&self, client: ClientId) -> Result<Detecting, Refusal> {
        self.check_may_move(client)?;
        self.arm.check_trust()?;
        let within_s = self.rests_within().as_secs_f64();
        let Some(status) = self.arm.last().filter(|_| self.is_at_rest()) else {
            return Err(Refusal::StillMoving { within_s });
        };
        let tool = self
            .arm
            .session()
            .model()
            .map_or(Tool::SuctionCup, |it| it.tool);
        let allowed = |joints: &Joints| {
            let place = Place::at_joints(*joints, tool);
            self.arm.policy().allows(&place, tool)
        };
        let detection = Detection::new(&status, allowed)
            .map_err(|error| Refusal::NotFound(error.to_string()))?;
        Ok(Detecting { client, detection })
    }

    pub(super) fn check_not_detecting(&self) -> Result<(), Refusal> {
        match self.detecting {
            None => Ok(()),
            Some(_) => Err(Refusal::Detecting),
        }
    }

    pub(super) fn watch_detection(&mut self, status: &Status) {
        let now = self.arm.now();
        let Some(detecting) = &mut self.detecting else {
            return;
        };
        detecting.detection.handle_status(now, status);
        if let Some(packet) = detecting.detection.poll_packet() {
            self.arm.send_urgent_packet(packet);
        }
        if let Some(outcome) = detecting.detection.poll_outcome() {
            let client = detecting.client;
            self.detecting = None;
            let answer = match outcome {
                Ok(finding) => {
                    self.finding = Some(finding.clone());
                    let set = self.set_dialect(finding.dialect);
                    set.map(|_| Reply::Found { finding })
                }
                Err(error) => Err(Refusal::NotFound(error.to_string())),
            };
            self.outbox.answer((client, answer));
        }
    }

    /// Ends a detection that cannot go on.
    pub(super) fn end_detection(&mut self, why: &str) {
        if let Some(detecting) = self.detecting.take() {
            let refusal = Refusal::NotFound(why.to_owned());
            self.outbox.answer((detecting.client, Err(refusal)));
        }
    }
}

/// None of the motions takes longer.
pub(super) const MOTION: Duration = Duration::from_secs(5);
