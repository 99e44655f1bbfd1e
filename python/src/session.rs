//! The client of the rules, and its operations.

mod job;

use std::time::Duration;

use dobot_api::problem_kinds::{BAD_PROGRAM, COMMAND, NO_LEASE};
use dobot_api::{
    Answer as JobAnswer, Jog, RemoteError, Reply, Request, Sense, State, StationEvent,
};
use dobot_controller::PowerUp;
use dobot_host::{JobsError, StationClient};
use dobot_wire::{Command, Dialect, ParseError};
use serde_json::json;
use tokio::sync::mpsc::UnboundedReceiver;
use tokio::time::timeout;

use crate::failure::{Failure, failed};
use crate::mailbox::{Mailbox, Received, Sender};
use crate::worker::{
    Answer, Inspect, Job, Operation, Outcome, Report, Seen, SharedStatuses, Stop, lock,
};

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
    statuses: SharedStatuses,
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
        statuses: SharedStatuses,
        answers: UnboundedReceiver<JobAnswer>,
    ) -> Self {
        Self {
            client,
            power_up,
            statuses,
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
                    Ok(event) => publish_state(&self.statuses, &event),
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
            Operation::CarryOut(..)
                | Operation::Draw(_)
                | Operation::Run(_)
                | Operation::Follow(_)
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
            Operation::NextStatus => return Ok(Outcome::Status(self.next_status().await?)),
            Operation::State => return Ok(Outcome::Json(self.known().await?)),
            Operation::CarryOut(command, sense) => {
                let state = self.client.first_state().await?;
                let arm = state.arm.as_ref().ok_or(RemoteError::Silent)?;
                let command = command(&arm.status, &state);
                publish(&self.statuses, &state);
                check(&command, state.dialect)?;
                self.carry_out(command, sense).await?;
                return Ok(Outcome::Status(self.next_status().await?));
            }
            Operation::Draw(request) => self.draw(*request, reports).await?,
            Operation::Run(run) => self.run(*run, reports).await?,
            Operation::Follow(follow) => self.follow_path(*follow, reports).await?,
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
                    self.pass(TICK).await?;
                }
            }
            Operation::RequestControl(patience) => self.request_control(patience).await?,
            Operation::Controlled(request) => {
                self.client.request(Request::TakeLease).await?;
                self.client.request_at_rest(request).await?;
            }
            Operation::Plain(request) => {
                // The pose is unknown before the first status.
                if matches!(request, Request::ConfirmPose) {
                    self.next_status().await?;
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

    async fn carry_out(&mut self, command: Command, sense: Option<Sense>) -> Result<(), Failure> {
        self.client.request(Request::TakeLease).await?;
        let request = match sense {
            Some(sense) => Request::SensedCommand { sense, command },
            None => Request::Command { command },
        };
        if let Reply::Accepted { command, .. } = self.client.request_at_rest(request).await? {
            let statuses = &self.statuses;
            let see = |state: &State| publish(statuses, state);
            self.client.finished_with_states(command, see).await?;
        }
        Ok(())
    }

    /// Waits for the next status.
    async fn next_status(&mut self) -> Result<Seen, Failure> {
        if self.held.is_none() {
            let state = self.client.first_state().await?;
            publish(&self.statuses, &state);
            return Ok(Seen::of(&state).ok_or(RemoteError::Silent)?);
        }
        let (sender, statuses) = Mailbox::new();
        lock(&self.statuses).subscribers.push(sender);
        loop {
            if let Received::Message(status) = statuses.receive(Duration::ZERO) {
                return Ok(status);
            }
            self.pass(TICK).await?;
        }
    }

    /// Returns the state, the jobs and the policy, and the number of this client, as a JSON object.
    async fn known(&mut self) -> Result<String, Failure> {
        let state = match self.client.request(Request::ShowState).await? {
            Reply::State { state } => state,
            reply => return Err(RemoteError::Garbled(format!("{reply:?}")).into()),
        };
        publish(&self.statuses, &state);
        let none = |error: JobsError| failed(error.to_string());
        let jobs = self.client.jobs().await.map_err(none)?;
        let arm = self.client.planned_for(&state).await.map_err(none)?;
        let known = json!({
            "state": state,
            "jobs": jobs,
            "policy": arm.rules.policy,
            "client": self.client.id(),
        });
        Ok(known.to_string())
    }

    /// Takes control if it is free; otherwise asks its holder, and waits for it within a timeout.
    async fn request_control(&mut self, patience: Duration) -> Result<(), Failure> {
        let refused = match self.client.request(Request::TakeLease).await {
            Ok(_) => return Ok(()),
            Err(error) if error.kind() == Some(NO_LEASE.name) => error,
            Err(error) => return Err(error.into()),
        };
        self.client.request(Request::AskLease).await?;
        let until = self.client.now().saturating_add(patience);
        while self.client.now() < until {
            let left = until.saturating_sub(self.client.now());
            let Some(event) = self.client.next_within(left).await? else {
                break;
            };
            publish_state(&self.statuses, &event);
            let StationEvent::State(state) = event else {
                continue;
            };
            let id = self.client.id();
            match state.lease {
                Some(lease) if lease.client == id => return Ok(()),
                Some(_) => {}
                None => {
                    self.client.request(Request::TakeLease).await?;
                    return Ok(());
                }
            }
        }
        Err(refused.into())
    }

    async fn wait(&mut self, time: Duration) -> Result<(), Failure> {
        let until = self.client.now().saturating_add(time);
        while self.client.now() < until {
            let left = until.saturating_sub(self.client.now());
            self.pass(TICK.min(left)).await?;
        }
        Ok(())
    }

    /// Lets at most this time pass, and less if there is a message. A button stays held.
    async fn pass(&mut self, time: Duration) -> Result<(), Failure> {
        if let Some(event) = self.client.next_within(time).await? {
            publish_state(&self.statuses, &event);
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
            next: now + self.hold_period(),
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
        let statuses = &self.statuses;
        let rest = self
            .client
            .rest_with_events(|event| publish_state(statuses, event));
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

    /// Returns the period of the requests that hold a button: a third of the time after which the station
    /// releases it.
    fn hold_period(&self) -> Duration {
        self.client.dead_man() / 3
    }

    /// Presses the button again, or releases it at the end of its time.
    async fn beat(&mut self) {
        let now = self.client.now();
        let period = self.hold_period();
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
        held.next = now + period;
        let jog = held.jog;
        if let Err(error) = self.client.request(Request::Jog { jog }).await {
            held.over = Some(error.into());
        }
    }
}

fn publish_state(statuses: &SharedStatuses, event: &StationEvent) {
    if let StationEvent::State(state) = event {
        publish(statuses, state);
    }
}

/// Sends a status to all subscribers. A subscriber that does not read is dropped, and notices that.
fn publish(statuses: &SharedStatuses, state: &State) {
    let Some(seen) = Seen::of(state) else { return };
    let mut statuses = lock(statuses);
    statuses.last = Some(seen);
    let subscribers = &mut statuses.subscribers;
    subscribers.retain(|subscriber| !subscriber.has_no_receiver() && subscriber.unread() < LONGEST);
    for subscriber in subscribers {
        subscriber.send(seen);
    }
}

/// Checks that the values of a command are those of its table, before it is sent anywhere.
fn check(command: &Command, dialect: Option<Dialect>) -> Result<(), Failure> {
    let dialect = dialect.unwrap_or(Dialect::SPECIFICATION);
    let parsed = Command::parse(&command.emit(&dialect), &dialect);
    let problem =
        |error: ParseError| Failure::Refused(Box::new(COMMAND.problem(error.to_string())));
    parsed.map(drop).map_err(problem)
}

/// The longest time that passes at once, so that a held button is repeated in time.
const TICK: Duration = Duration::from_millis(50);
/// The maximum time of a deceleration.
const REST: Duration = Duration::from_secs(5);
/// The number of statuses that are kept for a slow subscriber: more than an hour.
const LONGEST: usize = 65_536;
