//! The client of the rules, and what goes on with it.

mod job;

use std::time::Duration;

use dobot_api::problem_kinds::BAD_PROGRAM;
use dobot_api::{Jog, RemoteError, Reply, Request, State, StationEvent};
use dobot_controller::PowerUp;
use dobot_host::StationClient;
use dobot_wire::{Command, Status};
use tokio::sync::mpsc::UnboundedReceiver;
use tokio::time::timeout;

use crate::failure::Failure;
use crate::mailbox::{Mailbox, Taken, Teller};
use crate::worker::{Answer, Ears, Job, Look, Operation, Outcome, Stop, Told, lock};

use self::job::Rests;

/// A jog button that is held.
struct Held {
    jog: Jog,
    /// When it is said again, by the arm's clock.
    next: Duration,
    /// When it is let go.
    until: Duration,
    /// Why it is not held any more.
    over: Option<Failure>,
}

/// The client, and what goes on.
pub(crate) struct Session {
    client: StationClient,
    /// How the virtual arm of this process was switched on.
    power_up: Option<PowerUp>,
    ears: Ears,
    held: Option<Held>,
    rests: Option<Rests>,
}

impl Session {
    pub(crate) const fn new(client: StationClient, power_up: Option<PowerUp>, ears: Ears) -> Self {
        Self {
            client,
            power_up,
            ears,
            held: None,
            rests: None,
        }
    }

    /// Does what is asked for, one after the other. The connection with a station is read in between, too;
    /// virtual time passes only while somebody waits.
    pub(crate) async fn serve(
        mut self,
        jobs: &mut UnboundedReceiver<Job>,
        mut stops: UnboundedReceiver<Stop>,
    ) {
        let is_virtual = self.client.virtual_arm().is_some();
        let mut listens = !is_virtual;
        loop {
            let beats = self.held.as_ref().is_some_and(|it| it.over.is_none()) && !is_virtual;
            let beat = self.time_to_beat();
            tokio::select! {
                biased;
                Some(it) = stops.recv() => self.stop(it).await,
                job = jobs.recv() => {
                    let Some(Job { operation, answer }) = job else { break };
                    let stopped = tokio::select! {
                        biased;
                        Some(it) = stops.recv() => it,
                        done = self.act(operation, &answer) => {
                            answer.tell(Told::Over(done));
                            continue;
                        }
                    };
                    self.stop(stopped).await;
                    answer.tell(Told::Over(Err(Failure::Stopped)));
                }
                () = tokio::time::sleep(beat), if beats => self.beat().await,
                // A connection that broke is told to whoever asks next.
                heard = self.client.next(), if listens => match heard {
                    Ok(event) => self.hear(&event),
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
                    "switch the arm off by hand; the stop is sent as soon as the link is back"
                        .to_owned(),
                ),
            }),
            done => done.map(|_| Outcome::Nothing).map_err(Failure::from),
        };
        answer.tell(Told::Over(done));
    }

    async fn act(&mut self, operation: Operation, told: &Teller<Told>) -> Answer {
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
                let command = command(&self.status().await?);
                self.carry_out(command).await?;
                return Ok(Outcome::Status(self.status().await?));
            }
            Operation::Draw(request) => self.draw(*request, told).await?,
            Operation::Run(run) => self.run(*run, told).await?,
            Operation::Check(source) => {
                let (_, arm) = self.planned_for().await?;
                let report = source.report(&arm);
                let report = report.map_err(|it| BAD_PROGRAM.problem(it.to_string()));
                return Ok(Outcome::Json(
                    report.map_err(|it| Failure::Refused(it.into()))?,
                ));
            }
            Operation::Look(look) => return self.look(look),
            Operation::Resume { as_person } => self.resume(as_person, told).await?,
            Operation::Cancel => self.cancel().await?,
            Operation::Wait(time) => self.wait(time).await?,
            Operation::Press(jog, at_most) => self.press(jog, at_most).await?,
            Operation::Release => self.release().await?,
            Operation::Hear(mailbox) => {
                // What comes may be taken before anybody looks here.
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
                // There is no pose before the arm has told one.
                if matches!(request, Request::ConfirmPose) {
                    self.status().await?;
                }
                self.client.request_at_rest(request).await?;
            }
        }
        Ok(Outcome::Nothing)
    }

    fn look(&mut self, look: Box<Look>) -> Answer {
        let (Some(power_up), Some(arm)) = (self.power_up, self.client.virtual_arm_mut()) else {
            return Err(Failure::Failed {
                text: "this arm is no virtual one of this process".to_owned(),
                hint: Some("`dobot_arm.connect(\"virtual:\")` has one".to_owned()),
            });
        };
        look(arm, power_up).map_err(|text| Failure::Failed {
            text,
            hint: Some("`dobot_arm.connect(\"virtual:\", world=..., faults=[...])` says what is around it and what goes wrong".to_owned()),
        })
    }

    async fn carry_out(&mut self, command: Command) -> Result<(), Failure> {
        self.client.request(Request::TakeLease).await?;
        let request = Request::Command { command };
        if let Reply::Accepted { command, .. } = self.client.request_at_rest(request).await? {
            let ears = &self.ears;
            let see = |state: &State| tell(ears, state);
            self.client.finished_with_states(command, see).await?;
        }
        Ok(())
    }

    /// What the arm tells next.
    async fn status(&mut self) -> Result<Status, Failure> {
        if self.held.is_none() {
            let state = self.client.first_state().await?;
            tell(&self.ears, &state);
            let arm = state.arm.ok_or(RemoteError::Silent)?;
            return Ok(arm.status);
        }
        let (teller, heard) = Mailbox::new();
        lock(&self.ears).push(teller);
        loop {
            if let Taken::It(status) = heard.take(Duration::ZERO) {
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

    /// Lets a little time pass: no more than this, and less where something is told. A button stays held.
    async fn pass(&mut self, time: Duration) -> Result<(), Failure> {
        if self.client.virtual_arm().is_some() {
            self.client.wait(time).await;
            while let Some(event) = self.client.buffered() {
                self.hear(&event);
            }
            // A stop gets its turn.
            tokio::task::yield_now().await;
        } else if let Ok(event) = timeout(time, self.client.next()).await {
            self.hear(&event?);
        }
        if self.time_to_beat().is_zero() {
            self.beat().await;
        }
        Ok(())
    }

    /// The first press waits until an arm that runs down has come to rest.
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

    /// Lets go of the button, and waits until the arm rests.
    async fn release(&mut self) -> Result<(), Failure> {
        let Some(held) = self.held.take() else {
            return Ok(());
        };
        if let Some(failure) = held.over {
            return Err(failure);
        }
        self.client.request(Request::Release).await?;
        let until = self.client.now() + REST;
        loop {
            let state = self.client.state().await?;
            tell(&self.ears, &state);
            let moves = state.arm.is_some_and(|it| it.moving);
            if !moves || self.client.now() >= until {
                return Ok(());
            }
        }
    }

    /// How long until the button is said again.
    fn time_to_beat(&self) -> Duration {
        match &self.held {
            Some(Held {
                next, over: None, ..
            }) => next.saturating_sub(self.client.now()),
            _ => Duration::MAX,
        }
    }

    /// Says the button again, or lets it go when its time is over.
    async fn beat(&mut self) {
        let now = self.client.now();
        let Some(held) = self.held.as_mut().filter(|it| it.over.is_none()) else {
            return;
        };
        if now >= held.until {
            let released = self.client.request(Request::Release).await;
            held.over = Some(match released {
                Ok(_) => Failure::Failed {
                    text: "the button was let go of before its `with` ended: its time was over"
                        .to_owned(),
                    hint: Some("`at_most` says how long it may be held, in seconds".to_owned()),
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

    fn hear(&self, event: &StationEvent) {
        if let StationEvent::State(state) = event {
            tell(&self.ears, state);
        }
    }
}

/// Tells all who listen. Who does not take what is told is not told any more, and finds that out.
fn tell(ears: &Ears, state: &State) {
    let Some(arm) = &state.arm else { return };
    let mut ears = lock(ears);
    ears.retain(|it| !it.is_alone() && it.untaken() < LONGEST);
    for ear in &*ears {
        ear.tell(arm.status);
    }
}

/// A third of the time after which a station lets a button go.
const BEAT: Duration = Duration::from_millis(50);
/// No motion takes longer to run down.
const REST: Duration = Duration::from_secs(5);
/// So many statuses are kept for one who does not take them: more than an hour of them.
const LONGEST: usize = 65_536;
