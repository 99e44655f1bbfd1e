//! The client of the rules, and its operations.

mod job;

use std::time::Duration;

use dobot_api::problem_kinds::BAD_PROGRAM;
use dobot_api::{Answer as JobAnswer, Jog, RemoteError, Reply, Request, State, StationEvent};
use dobot_controller::PowerUp;
use dobot_host::StationClient;
use dobot_wire::{Command, Status};
use tokio::sync::mpsc::UnboundedReceiver;
use tokio::time::timeout;

use crate::failure::Failure;
use crate::mailbox::{Mailbox, Received, Sender};
use crate::worker::{Answer, Inspect, Job, Operation, Outcome, Report, Stop, Subscribers, lock};

use self::job::Rests;

/// A held jog button.
struct Held {
    jog: Jog,
    /// The time of the next repetition, by the arm's clock.
    next: Duration,
    /// The time of the release.
    until: Duration,
    /// The reason why it is not held any more.
    over: Option<Failure>,
}

/// The client, and the state of its operations.
pub(crate) struct Session {
    client: StationClient,
    /// The power-up state of the virtual arm of this process.
    power_up: Option<PowerUp>,
    subscribers: Subscribers,
    held: Option<Held>,
    rests: Option<Rests>,
    /// The answers to questions of programs.
    answers: UnboundedReceiver<JobAnswer>,
    /// Whether questions of the current program are answered here.
    asks: bool,
}

impl Session {
    pub(crate) const fn new(
        client: StationClient,
        power_up: Option<PowerUp>,
        subscribers: Subscribers,
        answers: UnboundedReceiver<JobAnswer>,
    ) -> Self {
        Self {
            client,
            power_up,
            subscribers,
            held: None,
            rests: None,
            answers,
            asks: false,
        }
    }

    /// Carries out operations, one after the other. Messages of a station are also received in
    /// between; virtual time passes only while a call waits.
    pub(crate) async fn serve(
        mut self,
        jobs: &mut UnboundedReceiver<Job>,
        mut stops: UnboundedReceiver<Stop>,
    ) {
        let is_virtual = self.client.virtual_arm().is_some();
        let mut listens = !is_virtual;
        loop {
            let beats = self.held.as_ref().is_some_and(|held| held.over.is_none()) && !is_virtual;
            let beat = self.time_to_beat();
            tokio::select! {
                biased;
                Some(stop) = stops.recv() => self.stop(stop).await,
                job = jobs.recv() => {
                    let Some(Job { operation, answer }) = job else { break };
                    let stopped = tokio::select! {
                        biased;
                        Some(stop) = stops.recv() => stop,
                        done = self.act(operation, &answer) => {
                            answer.send(Report::Over(done));
                            continue;
                        }
                    };
                    self.stop(stopped).await;
                    answer.send(Report::Over(Err(Failure::Stopped)));
                }
                () = tokio::time::sleep(beat), if beats => self.beat().await,
                // A broken connection is reported to the next call.
                event = self.client.next(), if listens => match event {
                    Ok(event) => publish_state(&self.subscribers, &event),
                    Err(_) => listens = false,
                },
            }
        }
        self.client.end().await;
    }

    async fn stop(&mut self, Stop { reason, answer }: Stop) {
        let done = self.client.request(Request::Stop { reason }).await;
        if let Some(held) = &mut self.held {
            held.over = Some(Failure::Stopped);
        }
        let done = match done {
            Ok(Reply::Stopping {
                delivered: false, ..
            }) => Err(Failure::Failed {
                text: "the stop was NOT DELIVERED: there is no link to the arm".to_owned(),
                hint: Some(
                    "switch the arm off by hand; the stop is sent when the link is restored"
                        .to_owned(),
                ),
            }),
            done => done.map(|_| Outcome::Nothing).map_err(Failure::from),
        };
        answer.send(Report::Over(done));
    }

    async fn act(&mut self, operation: Operation, reports: &Sender<Report>) -> Answer {
        let moves = matches!(
            operation,
            Operation::CarryOut(_)
                | Operation::Draw(_)
                | Operation::Run(_)
                | Operation::Resume { .. }
                | Operation::Press(..)
        );
        if moves && self.held.is_some() {
            return Err(Failure::Failed {
                text: "a jog button is held".to_owned(),
                hint: Some("leave the `with` of `arm.jog(...)` first".to_owned()),
            });
        }
        match operation {
            Operation::Connected => {}
            Operation::Status => return Ok(Outcome::Status(self.status().await?)),
            Operation::CarryOut(command) => {
                let state = self.client.first_state().await?;
                let arm = state.arm.as_ref().ok_or(RemoteError::Silent)?;
                let command = command(&arm.status, state.dialect);
                publish(&self.subscribers, &state);
                self.carry_out(command).await?;
                return Ok(Outcome::Status(self.status().await?));
            }
            Operation::Draw(request) => self.draw(*request, reports).await?,
            Operation::Run(run) => self.run(*run, reports).await?,
            Operation::Check(source) => {
                let (_, arm) = self.planned_for().await?;
                let report = source.report(&arm);
                let report = report.map_err(|error| BAD_PROGRAM.problem(error.to_string()));
                return Ok(Outcome::Json(
                    report.map_err(|error| Failure::Refused(error.into()))?,
                ));
            }
            Operation::Inspect(inspect) => return self.inspect(inspect),
            Operation::Resume { as_person } => self.resume(as_person, reports).await?,
            Operation::Cancel => self.cancel().await?,
            Operation::Wait(time) => self.wait(time).await?,
            Operation::Press(jog, at_most) => self.press(jog, at_most).await?,
            Operation::Release => self.release().await?,
            Operation::Subscribe(mailbox) => {
                // A status may be received before this thread continues.
                let count = mailbox.count();
                while mailbox.len() == 0 && mailbox.count() == count {
                    self.pass(BEAT).await?;
                }
            }
            Operation::Controlled(request) => {
                self.client.request(Request::TakeLease).await?;
                self.client.request_at_rest(request).await?;
            }
            Operation::Plain(request) => {
                // The pose is unknown before the first status.
                if matches!(request, Request::ConfirmPose) {
                    self.status().await?;
                }
                self.client.request_at_rest(request).await?;
            }
        }
        Ok(Outcome::Nothing)
    }

    fn inspect(&mut self, inspect: Box<Inspect>) -> Answer {
        let (Some(power_up), Some(arm)) = (self.power_up, self.client.virtual_arm_mut()) else {
            return Err(Failure::Failed {
                text: "this arm is not a virtual arm of this process".to_owned(),
                hint: Some("use `dobot_arm.connect(\"virtual:\")`".to_owned()),
            });
        };
        inspect(arm, power_up).map_err(|text| Failure::Failed {
            text,
            hint: Some("use `dobot_arm.connect(\"virtual:\", world=..., faults=[...])`".to_owned()),
        })
    }

    async fn carry_out(&mut self, command: Command) -> Result<(), Failure> {
        self.client.request(Request::TakeLease).await?;
        let request = Request::Command { command };
        if let Reply::Accepted { command, .. } = self.client.request_at_rest(request).await? {
            let subscribers = &self.subscribers;
            let see = |state: &State| publish(subscribers, state);
            self.client.finished_with_states(command, see).await?;
        }
        Ok(())
    }

    /// Waits for the next status.
    async fn status(&mut self) -> Result<Status, Failure> {
        if self.held.is_none() {
            let state = self.client.first_state().await?;
            publish(&self.subscribers, &state);
            let arm = state.arm.ok_or(RemoteError::Silent)?;
            return Ok(arm.status);
        }
        let (sender, statuses) = Mailbox::new();
        lock(&self.subscribers).push(sender);
        loop {
            if let Received::Message(status) = statuses.receive(Duration::ZERO) {
                return Ok(status);
            }
            self.pass(BEAT).await?;
        }
    }

    async fn wait(&mut self, time: Duration) -> Result<(), Failure> {
        let until = self.client.now().saturating_add(time);
        while self.client.now() < until {
            let left = until.saturating_sub(self.client.now());
            self.pass(BEAT.min(left)).await?;
        }
        Ok(())
    }

    /// Lets at most this time pass, and less if there is a message. A button stays held.
    async fn pass(&mut self, time: Duration) -> Result<(), Failure> {
        if let Some(event) = self.client.next_within(time).await? {
            publish_state(&self.subscribers, &event);
        }
        if self.time_to_beat().is_zero() {
            self.beat().await;
        }
        Ok(())
    }

    /// The first press waits until a decelerating arm is at rest.
    async fn press(&mut self, jog: Jog, at_most: Duration) -> Result<(), Failure> {
        self.client.request(Request::TakeLease).await?;
        self.client.request_at_rest(Request::Jog { jog }).await?;
        let now = self.client.now();
        self.held = Some(Held {
            jog,
            next: now + BEAT,
            until: now + at_most,
            over: None,
        });
        Ok(())
    }

    /// Releases the button, and waits until the arm is at rest.
    async fn release(&mut self) -> Result<(), Failure> {
        let Some(held) = self.held.take() else {
            return Ok(());
        };
        if let Some(failure) = held.over {
            return Err(failure);
        }
        self.client.request(Request::Release).await?;
        let subscribers = &self.subscribers;
        let rest = self
            .client
            .rest_with_events(|event| publish_state(subscribers, event));
        timeout(REST, rest).await.ok().transpose()?;
        Ok(())
    }

    /// Returns the time until the button is pressed again.
    fn time_to_beat(&self) -> Duration {
        match &self.held {
            Some(Held {
                next, over: None, ..
            }) => next.saturating_sub(self.client.now()),
            _ => Duration::MAX,
        }
    }

    /// Presses the button again, or releases it at the end of its time.
    async fn beat(&mut self) {
        let now = self.client.now();
        let Some(held) = self.held.as_mut().filter(|held| held.over.is_none()) else {
            return;
        };
        if now >= held.until {
            let released = self.client.request(Request::Release).await;
            held.over = Some(match released {
                Ok(_) => Failure::Failed {
                    text: "the button was released before the end of the `with` block: its time was over"
                        .to_owned(),
                    hint: Some("set the maximum time with `at_most`, in seconds".to_owned()),
                },
                Err(error) => error.into(),
            });
            return;
        }
        held.next = now + BEAT;
        let jog = held.jog;
        if let Err(error) = self.client.request(Request::Jog { jog }).await {
            held.over = Some(error.into());
        }
    }
}

fn publish_state(subscribers: &Subscribers, event: &StationEvent) {
    if let StationEvent::State(state) = event {
        publish(subscribers, state);
    }
}

/// Sends a status to all subscribers. A subscriber that does not read is dropped, and notices that.
fn publish(subscribers: &Subscribers, state: &State) {
    let Some(arm) = &state.arm else { return };
    let mut subscribers = lock(subscribers);
    subscribers.retain(|subscriber| !subscriber.has_no_receiver() && subscriber.unread() < LONGEST);
    for subscriber in &*subscribers {
        subscriber.send(arm.status);
    }
}

/// A third of the time after which a station releases a button.
const BEAT: Duration = Duration::from_millis(50);
/// The maximum time of a deceleration.
const REST: Duration = Duration::from_secs(5);
/// The number of statuses that are kept for a slow subscriber: more than an hour.
const LONGEST: usize = 65_536;
