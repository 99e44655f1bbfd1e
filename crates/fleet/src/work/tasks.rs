//! The tasks around the engine: the disk, the other stations, and the submitters.

use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use dobot_api::problem_kinds::{ARM_BUSY, NO_FLEET, NO_SUCH_WORK, WORK_FILE, WORK_REFUSED};
use dobot_api::{ApiAnswer, ApiRequest, Problem, WorkView};
use dobot_station::{Members, NewWork, OFFERS, StationApi, WorkCommand};
use tokio::sync::oneshot;
use tokio::task::{JoinError, JoinSet, spawn_blocking};

use super::engine::{Action, Answer, Ask, What, Work};
use super::ticket::{Place, Ticket};
use super::ticket_store::TicketStore;
use crate::id::new_id;
use crate::requests::{Requester, ask_one};

/// The jobs that were submitted to this station.
pub(crate) struct WorkTasks {
    engine: Work,
    /// Absent if the station has no folder for them.
    kept: Option<Arc<TicketStore>>,
    /// The in-flight tasks.
    pub(crate) doing: JoinSet<Done>,
    /// The submitters whose tickets are being written.
    waiting: Vec<(String, Reply)>,
    /// The reason why the last write failed.
    trouble: Option<String>,
    started: Instant,
}

/// The result of a task.
pub(crate) enum Done {
    Kept(Result<(), String>),
    Submitted(Box<Ticket>, Result<(), String>, Reply),
    Answered(Ask, Answer),
    Forgotten,
}

type Reply = oneshot::Sender<Result<WorkView, Problem>>;

impl WorkTasks {
    /// Restores the tickets of the folder; also returns the problems of invalid files.
    pub(crate) fn open(folder: Option<&Path>) -> std::io::Result<(Self, Vec<String>)> {
        let (kept, tickets, wrong) = match folder {
            None => (None, Vec::new(), Vec::new()),
            Some(folder) => {
                let (kept, tickets, wrong) = TicketStore::open(folder)?;
                (Some(Arc::new(kept)), tickets, wrong)
            }
        };
        let working = Self {
            engine: Work::new(tickets, || new_id().ok()),
            kept,
            doing: JoinSet::new(),
            waiting: Vec::new(),
            trouble: None,
            started: Instant::now(),
        };
        Ok((working, wrong))
    }

    /// Whether the states of the other stations are needed.
    pub(crate) fn needs_members(&self) -> bool {
        self.engine.needs_members()
    }

    /// Handles a request.
    pub(crate) fn handle(&mut self, command: WorkCommand) {
        // The requester may be gone.
        match command {
            WorkCommand::Submit(work, reply) => self.submit(*work, reply),
            WorkCommand::List(reply) => drop(reply.send(Ok(self.engine.views()))),
            WorkCommand::Cancel(id, reply) => match self.engine.cancel(&id) {
                Ok(_) => self.waiting.push((id, reply)),
                Err(problem) => drop(reply.send(Err(problem))),
            },
            WorkCommand::Give(id, reply) => match self.engine.give(&id) {
                Ok(_) => self.waiting.push((id, reply)),
                Err(problem) => drop(reply.send(Err(problem))),
            },
        }
    }

    fn submit(&mut self, work: NewWork, reply: Reply) {
        let asked_before = work.key.as_deref();
        let asked_before =
            asked_before.and_then(|key| self.engine.asked_before(&work.student, key));
        if let Some(view) = asked_before {
            return drop(reply.send(Ok(view)));
        }
        let Some(kept) = self.kept.clone() else {
            let none = "this station stores no jobs for its fleet";
            return drop(reply.send(Err(NO_FLEET.problem(none))));
        };
        if let Err(problem) = self.engine.check_room() {
            return drop(reply.send(Err(problem)));
        }
        let id = match new_id() {
            Ok(id) => id,
            Err(error) => {
                let none = format!("the system has no random numbers: {error}");
                return drop(reply.send(Err(WORK_FILE.problem(none))));
            }
        };
        let ticket = Box::new(Ticket {
            id,
            number: self.engine.next_number(),
            title: work.title,
            student: work.student,
            group: work.group,
            needs: work.needs,
            submitted_ms: work.submitted_ms,
            key: work.key,
            at: Place::Waiting,
            refused: Vec::new(),
            before: Vec::new(),
            returned: None,
        });
        self.doing.spawn(async move {
            let copy = ticket.clone();
            let written = written(spawn_blocking(move || kept.submit(&copy, &work.offer)).await);
            Done::Submitted(ticket, written, reply)
        });
    }

    /// Handles the result of a task. Returns a disk problem once.
    pub(crate) fn settle(&mut self, done: Result<Done, JoinError>) -> Option<String> {
        let now = self.started.elapsed();
        match done {
            Ok(Done::Answered(ask, answer)) => self.engine.handle_answer(now, &ask, answer),
            Ok(Done::Submitted(ticket, Ok(()), reply)) => {
                // The requester may be gone.
                drop(reply.send(Ok(self.engine.submitted(*ticket))));
            }
            Ok(Done::Submitted(_, Err(why), reply)) => {
                drop(reply.send(Err(WORK_FILE.problem(why))));
            }
            Ok(Done::Kept(outcome)) => {
                self.engine.handle_written(now, outcome.is_ok());
                self.report_writes(outcome.as_ref().err());
                let was = std::mem::replace(&mut self.trouble, outcome.err());
                return self.trouble.clone().filter(|_| was.is_none());
            }
            Ok(Done::Forgotten) => {}
            // Tasks do not panic; after a panic the request is repeated when the station is
            // restarted.
            Err(error) => return Some(format!("jobs for the fleet: {error}")),
        }
        None
    }

    /// Reports to the submitters whether their tickets are on the disk.
    fn report_writes(&mut self, trouble: Option<&String>) {
        let engine = &self.engine;
        let ready = |(id, _): &mut (String, Reply)| trouble.is_some() || engine.is_kept(id);
        for (id, reply) in self.waiting.extract_if(.., ready) {
            // The requester may be gone.
            drop(reply.send(match trouble {
                None => engine.one(&id),
                Some(why) => Err(WORK_FILE.hinted(why, "the write is retried automatically")),
            }));
        }
    }

    /// Starts the due actions. The members are only queried if there are jobs to offer. While
    /// `held` gives a reason, nothing is offered.
    pub(crate) fn start_due(
        &mut self,
        requester: Option<&Requester>,
        api: &StationApi,
        members: impl FnOnce() -> Members,
        held: Option<String>,
    ) {
        let Some(kept) = &self.kept else {
            return;
        };
        let members = if self.needs_members() {
            members()
        } else {
            Members::default()
        };
        self.engine.update_members(&members, held);
        while let Some(action) = self.engine.poll_action(self.started.elapsed()) {
            let kept = kept.clone();
            match action {
                Action::Write(ticket) => {
                    self.doing.spawn(async move {
                        Done::Kept(written(spawn_blocking(move || kept.keep(&ticket)).await))
                    });
                }
                Action::Forget(id) => {
                    self.doing.spawn(async move {
                        // A remaining file is removed after the next start.
                        drop(spawn_blocking(move || kept.forget(&id)).await);
                        Done::Forgotten
                    });
                }
                Action::Ask(ask) => {
                    let member = members
                        .iter()
                        .find(|member| member.id == ask.member.id)
                        .cloned();
                    let (requester, api) = (requester.cloned(), api.clone());
                    self.doing.spawn(async move {
                        let answer = match (request(&kept, &ask).await, member) {
                            (Ok(request), Some(member)) => read(
                                &ask_one(requester.as_ref(), &api, &member, &request)
                                    .await
                                    .answer,
                            ),
                            (Err(why), _) => Answer::Unclear(why),
                            (_, None) => Answer::Unclear("it is away".into()),
                        };
                        Done::Answered(ask, answer)
                    });
                }
            }
        }
    }
}

/// Returns whether a write succeeded, or why it failed.
fn written(outcome: Result<std::io::Result<()>, JoinError>) -> Result<(), String> {
    let failed = |why: String| format!("jobs for the fleet cannot be written: {why}");
    match outcome {
        Ok(outcome) => outcome.map_err(|error| failed(error.to_string())),
        Err(error) => Err(failed(error.to_string())),
    }
}

/// Returns the request to a station.
async fn request(kept: &Arc<TicketStore>, ask: &Ask) -> Result<ApiRequest, String> {
    let of_key = format!("{OFFERS}/{}", ask.key);
    let (method, path) = match ask.what {
        What::Look => ("GET", of_key),
        What::Withdraw => ("DELETE", of_key),
        What::Offer => ("POST", OFFERS.to_owned()),
    };
    let body = if ask.what == What::Offer {
        let (kept, id) = (kept.clone(), ask.ticket.clone());
        let read = spawn_blocking(move || kept.offer(&id)).await;
        let read = read.map_err(|error| error.to_string())?;
        Some(read.map_err(|error| format!("the job cannot be read from the disk: {error}"))?)
    } else {
        None
    };
    Ok(ApiRequest {
        method: method.into(),
        path,
        key: Some(ask.key.clone()),
        body,
        ..ApiRequest::default()
    })
}

/// Parses a response. Only a response of the other station's journal is final.
fn read(answer: &ApiAnswer) -> Answer {
    if answer.is_success() {
        return match serde_json::from_value(answer.body.clone()) {
            Ok(job) => Answer::Taken(job),
            Err(error) => Answer::Unclear(format!("unreadable response: {error}")),
        };
    }
    let Ok(problem) = serde_json::from_value::<Problem>(answer.body.clone()) else {
        return Answer::Unclear(format!("it responded with status {}", answer.status));
    };
    let is = |name: &str| problem.kind == format!("/api/v1/problems/{name}");
    let (busy, refused) = (is(ARM_BUSY.name), is(WORK_REFUSED.name));
    if busy || refused {
        let reason = problem.detail;
        return Answer::Refused { reason, busy };
    }
    if is(NO_SUCH_WORK.name) {
        return Answer::Unknown;
    }
    Answer::Unclear(problem.detail)
}
