//! Sending a plan: one vector for each status, pen up and laser off at the end, whatever happens.

use std::collections::VecDeque;
use std::fmt;
use std::future::Future;
use std::pin::pin;
use std::time::Duration;

use dobot_arm::Position;
use dobot_client::{CommandId, Connection, Event, LinkError, SendError, position};
use dobot_wire::{JointJog, WriteMode, WriteVector};
use thiserror::Error;

use crate::plan::{LASER_OFF, MoveKind, Plan, Tool, approach, single, to_start, write};

/// How far a drawing has come.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Progress {
    /// Vectors seen to be over.
    pub vectors: usize,
    /// Strokes finished.
    pub strokes: usize,
    /// How much of the planned time they take, in seconds.
    pub planned_s: f64,
}

/// A drawing made to its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Finished {
    /// From the first vector sent to the last one over, by the clock of the link, without the time
    /// that a person took to change pens.
    pub time: Duration,
    /// Where the statuses saw the tool.
    pub seen: Vec<Position>,
}

/// Why a drawing was not made to its end. The pen is up and the laser off, unless `parting` says
/// that this could not be told to the arm.
#[derive(Debug, Error)]
#[non_exhaustive]
#[error(
    "the drawing was stopped after {} of {vectors} vectors and {} strokes; {parting}",
    progress.vectors,
    progress.strokes
)]
pub struct Stopped {
    /// What stopped it.
    #[source]
    pub cause: Cause,
    /// How far it got.
    pub progress: Progress,
    /// How many vectors the plan has.
    pub vectors: usize,
    /// What became of the parting words.
    pub parting: Parting,
    /// Where the statuses saw the tool.
    pub seen: Vec<Position>,
}

/// What stopped a drawing.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Cause {
    /// The person did.
    #[error("interrupted")]
    Asked,
    /// The arm or the link failed.
    #[error(transparent)]
    Failed(#[from] LinkError),
}

/// Whether pen up and laser off reached the arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parting {
    /// Nothing had been sent, so nothing was to be put right.
    Unneeded,
    /// The arm was seen to obey.
    Done,
    /// They were sent, and nobody knows whether they were heard.
    Sent,
    /// They could not be sent.
    Lost,
}

/// Draws a plan: goes to its start, sends the vectors, and waits until the last one is over.
///
/// At each break of the plan the pen is up and the laser off, everything before is over, and
/// `confirm` is given the message for the person; the drawing goes on when it completes. `stop` ends
/// the drawing when it completes; `tell` hears of each vector that is over.
///
/// # Errors
///
/// [`Stopped`], with the laser switched off and the pen lifted as far as the arm can be told so.
pub async fn run(
    arm: &mut Connection,
    plan: &Plan,
    confirm: impl AsyncFnMut(&str),
    stop: impl Future<Output = ()>,
    tell: impl FnMut(Progress),
) -> Result<Finished, Stopped> {
    let mut runner = Runner {
        arm,
        plan,
        sent: 0,
        under_way: VecDeque::new(),
        progress: Progress::default(),
        seen: Vec::new(),
        tell,
    };
    if let Err(error) = runner.check() {
        return Err(runner.stopped(Cause::Failed(error.into()), Parting::Unneeded));
    }
    let cause = {
        let mut stop = pin!(stop);
        tokio::select! {
            biased;
            () = &mut stop => Cause::Asked,
            drawn = runner.draw(confirm) => match drawn {
                Ok(time) => return Ok(Finished { time, seen: runner.seen }),
                Err(error) => Cause::Failed(error),
            },
        }
    };
    let parting = runner.part(&cause).await;
    Err(runner.stopped(cause, parting))
}

struct Runner<'a, T> {
    arm: &'a mut Connection,
    plan: &'a Plan,
    /// Vectors given to the session.
    sent: usize,
    /// Those of them that are not over, as the session knows them.
    under_way: VecDeque<CommandId>,
    progress: Progress,
    seen: Vec<Position>,
    tell: T,
}

impl<T: FnMut(Progress)> Runner<'_, T> {
    async fn draw(&mut self, mut confirm: impl AsyncFnMut(&str)) -> Result<Duration, LinkError> {
        self.approach().await?;
        let plan = self.plan;
        let mut time = Duration::ZERO;
        for pause in &plan.breaks {
            time += self.draw_to(pause.before).await?;
            self.obey(LASER_OFF).await?;
            self.ask(confirm(&pause.message)).await?;
        }
        time += self.draw_to(plan.moves.len()).await?;
        if plan.burns() {
            self.obey(LASER_OFF).await?;
        }
        Ok(time)
    }

    /// Draws the vectors before this one, and waits until they are over.
    async fn draw_to(&mut self, end: usize) -> Result<Duration, LinkError> {
        let began = self.arm.now();
        while self.progress.vectors < end {
            self.top_up(end)?;
            // A runtime that has other work (a signal that asks to stop) gets its turn.
            tokio::task::consume_budget().await;
            self.listen().await?;
        }
        Ok(self.arm.now().saturating_sub(began))
    }

    /// Waits for a person, and keeps listening to the arm, which goes on telling where it is.
    async fn ask(&mut self, person: impl Future<Output = ()>) -> Result<(), LinkError> {
        let mut person = pin!(person);
        loop {
            tokio::task::consume_budget().await;
            tokio::select! {
                biased;
                () = &mut person => return Ok(()),
                heard = self.listen() => heard?,
            }
        }
    }

    /// Sends a command and waits until it is over.
    async fn obey(&mut self, command: JointJog) -> Result<(), LinkError> {
        let id = self.arm.send(command)?;
        self.arm.completed(id).await
    }

    async fn listen(&mut self) -> Result<(), LinkError> {
        match self.arm.next_event().await?.or_failed()? {
            Event::Status(status) => self.seen.push(position(&status)),
            Event::Completed(id) => self.completed(id),
            _ => {}
        }
        Ok(())
    }

    /// Nothing is sent unless everything can be.
    fn check(&self) -> Result<(), SendError> {
        let session = self.arm.session();
        self.plan
            .moves
            .iter()
            .try_for_each(|vector| session.check(&write(vector).into()))
    }

    fn stopped(self, cause: Cause, parting: Parting) -> Stopped {
        Stopped {
            cause,
            progress: self.progress,
            vectors: self.plan.moves.len(),
            parting,
            seen: self.seen,
        }
    }

    /// Laser off, pen holder mounted, acceleration set, and then to the start of the first vector.
    async fn approach(&mut self) -> Result<(), LinkError> {
        if self.arm.session().model().is_none() {
            self.arm.next_status().await?;
        }
        for command in approach(self.plan) {
            self.arm.send(command)?;
        }
        let there = self.arm.send(to_start(self.plan))?;
        self.arm.completed(there).await
    }

    /// Keeps a few waiting in the session, which sends them no further ahead than may be regretted.
    fn top_up(&mut self, end: usize) -> Result<(), LinkError> {
        while self.arm.session().waiting() < FEW && self.sent < end {
            let id = self.arm.send(write(&self.plan.moves[self.sent]))?;
            self.under_way.push_back(id);
            self.sent += 1;
        }
        Ok(())
    }

    /// Whatever was sent before what is over is over too.
    fn completed(&mut self, id: CommandId) {
        while self.under_way.pop_front_if(|it| *it <= id).is_some() {
            let index = self.progress.vectors;
            let kind = self.plan.moves[index].kind;
            self.progress.vectors += 1;
            self.progress.strokes += usize::from(matches!(kind, MoveKind::Lift | MoveKind::Brake));
            self.progress.planned_s += self.plan.duration_of(index);
            (self.tell)(self.progress);
        }
    }

    /// Laser off first, then pen up; the vectors that the arm has already got come before.
    async fn part(&mut self, cause: &Cause) -> Parting {
        let forgotten = self.arm.session_mut().forget_waiting().len();
        let lift = self.lift(self.sent.saturating_sub(forgotten));
        if matches!(
            cause,
            Cause::Asked | Cause::Failed(LinkError::NotReached { .. })
        ) && self.obeyed(lift).await.is_ok()
        {
            return Parting::Done;
        }
        // A link that the other end closed still takes bytes for a while; they lead nowhere.
        let open = !matches!(
            cause,
            Cause::Failed(LinkError::Closed | LinkError::Broken(_))
        );
        if self.blind(lift).await.is_ok() && open {
            Parting::Sent
        } else {
            Parting::Lost
        }
    }

    async fn obeyed(&mut self, lift: Option<WriteVector>) -> Result<(), LinkError> {
        let mut last = self.arm.send(LASER_OFF)?;
        if let Some(lift) = lift {
            last = self.arm.send(lift)?;
        }
        loop {
            match self.arm.next_event().await? {
                Event::Completed(id) => {
                    self.completed(id);
                    if id >= last {
                        return Ok(());
                    }
                }
                event @ Event::LinkLost { .. } => {
                    event.or_failed()?;
                }
                _ => {}
            }
        }
    }

    /// On a link that is failing nobody waits for permits; a stock arm wants a gap between packets
    /// (note N26).
    async fn blind(&mut self, lift: Option<WriteVector>) -> Result<(), LinkError> {
        self.arm.session_mut().send_now(LASER_OFF)?;
        self.arm.flush().await?;
        if let Some(lift) = lift {
            tokio::time::sleep(GAP).await;
            self.arm.session_mut().send_now(lift)?;
            self.arm.flush().await?;
        }
        Ok(())
    }

    /// The way up from where the pen is after `sent` vectors, unless it is up. A laser stays as high
    /// as it is: there is nothing to leave.
    fn lift(&self, sent: usize) -> Option<WriteVector> {
        let moves = &self.plan.moves[..sent];
        let Tool::Pen(pen) = self.plan.passes[moves.last()?.pass as usize].tool else {
            return None;
        };
        let since_up = moves.iter().rev();
        let since_up =
            since_up.take_while(|it| matches!(it.kind, MoveKind::Lower | MoveKind::Draw));
        // On a slope a line rises and falls too: what brought the pen down is undone, no more.
        let lowered = since_up.filter(|it| it.kind == MoveKind::Lower);
        let risen_mm: f64 = lowered.map(|vector| vector.increments()[2]).sum();
        (risen_mm < -LEAST_LIFT_MM).then(|| WriteVector {
            mode: WriteMode::Writing,
            x_mm: 0.0,
            y_mm: 0.0,
            z_mm: single(-risen_mm),
            laser: false,
            start_speed_mm_s: 0.0,
            end_speed_mm_s: 0.0,
            max_speed_mm_s: single(pen.lift_speed_mm_s),
            stop: false,
        })
    }
}

impl fmt::Display for Parting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Unneeded => "nothing was sent",
            Self::Done => "the pen is up and the laser off",
            Self::Sent => "pen up and laser off were sent, but the arm does not answer",
            Self::Lost => "pen up and laser off could not be sent",
        })
    }
}

const FEW: usize = 4;
const GAP: Duration = Duration::from_millis(60);
const LEAST_LIFT_MM: f64 = 0.01;
