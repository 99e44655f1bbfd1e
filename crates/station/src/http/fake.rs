//! A fake driver, which grants everything and records its requests.

use std::collections::HashMap;
use std::sync::{Arc, Mutex};

use dobot_api::{ClientId, FleetWideStop, JobPath, JobView, LeaseView, Reply, Request, Role};
use dobot_host::{DriverChannels, Message, OfferAnswer, OfferRequest, Rules, StationHandle};
use dobot_supervisor::{Refusal, StoppedBy};
use tokio::sync::mpsc;

use crate::sample::{job, state};

/// The requests that the driver received.
#[derive(Clone, Debug, Default)]
pub(super) struct Asked(Arc<Mutex<Vec<(ClientId, Request)>>>);

impl Asked {
    pub(super) fn requests(&self) -> Vec<Request> {
        let asked = self.0.lock().expect("no test panics while it holds this");
        asked.iter().map(|(_, request)| request.clone()).collect()
    }

    pub(super) fn clients(&self) -> Vec<ClientId> {
        let asked = self.0.lock().expect("no test panics while it holds this");
        asked.iter().map(|(client, _)| *client).collect()
    }
}

/// Returns a fake driver, and the means to publish states and notices.
pub(super) fn driver() -> (StationHandle, Arc<FakeNews>, Asked) {
    let rules = Rules::of(&dobot_safety::Policy::default());
    let (handle, mut ends) = StationHandle::new(state(0.0), rules);
    let (_, nothing) = mpsc::channel(1);
    let messages = std::mem::replace(&mut ends.messages, nothing);
    let news = Arc::new(FakeNews {
        ends,
        connected: Mutex::default(),
        gone: Mutex::default(),
        trouble: Mutex::default(),
        resets: Mutex::default(),
    });
    let asked = Asked::default();
    tokio::spawn(serve(messages, news.clone(), asked.clone()));
    (handle, news, asked)
}

/// Publishes states and notices in the name of the driver.
#[derive(Debug)]
pub(super) struct FakeNews {
    pub(super) ends: DriverChannels,
    /// Clients that connected: their names, and their names for time slots.
    pub(super) connected: Mutex<Vec<(String, String)>>,
    /// Clients that left.
    pub(super) gone: Mutex<Vec<ClientId>>,
    /// Reported troubles.
    pub(super) trouble: Mutex<Vec<String>>,
    /// Who has reset the fleet's stop.
    pub(super) resets: Mutex<Vec<String>>,
}

async fn serve(mut messages: mpsc::Receiver<Message>, news: Arc<FakeNews>, asked: Asked) {
    let mut next = 1;
    let mut refusing = std::collections::HashSet::new();
    let mut offers = HashMap::new();
    while let Some(message) = messages.recv().await {
        match message {
            Message::Came {
                name,
                person,
                role,
                reply,
                device: _,
            } => {
                if name == "refused" {
                    refusing.insert(ClientId(next));
                }
                assert!(role >= Role::Watch);
                news.connected
                    .lock()
                    .expect("as above")
                    .push((name, person));
                // The receiver may be gone, here and below.
                let _ = reply.send(ClientId(next));
                next += 1;
            }
            Message::Left(client) => news.gone.lock().expect("as above").push(client),
            Message::Asked {
                client,
                request,
                reply,
            } => {
                let answer = match &request {
                    _ if refusing.contains(&client) => Err(Refusal::LaserDisarmed),
                    Request::StartJob { job: 404 } => Err(Refusal::NoSuchJob(404)),
                    request => Ok(granted(client, request)),
                };
                asked.0.lock().expect("as above").push((client, request));
                let _ = reply.send(answer);
            }
            Message::Raw { reply, .. } => {
                let _ = reply.send(Ok(()));
            }
            Message::Policy { reply, policy, .. } => {
                news.ends.change_rules(|rules| rules.policy = *policy);
                let _ = reply.send(Ok(()));
            }
            Message::Planned { .. } | Message::Answered { .. } => panic!("it plans no jobs"),
            Message::Jobs(reply) => {
                let _ = reply.send(Ok(vec![job(7)]));
            }
            Message::JobPath { job: 7, reply } => {
                let _ = reply.send(Ok(JobPath::default()));
            }
            Message::JobPath { job, reply } => {
                let _ = reply.send(Err(Refusal::NoSuchJob(job)));
            }
            Message::Offer { key, ask, reply } => {
                let _ = reply.send(Ok(answer(&mut offers, key, ask)));
            }
            Message::FleetStop { origin, by, reply } => {
                let _ = reply.send((fleet_stop(origin, by), stopping()));
            }
            Message::FleetStops { stops, reply } => {
                let _ = reply.send((stops, Some(stopping())));
            }
            Message::FleetReset { by, reply } => {
                news.resets.lock().expect("as above").push(by);
                let _ = reply.send(Vec::new());
            }
            Message::Buttons(text) | Message::Trouble(text) => {
                news.trouble.lock().expect("as above").push(text);
            }
            Message::Failed(text) => panic!("{text}"),
            Message::End => break,
        }
    }
}

/// The first stop of a station.
fn fleet_stop(origin: String, by: StoppedBy) -> FleetWideStop {
    FleetWideStop {
        origin,
        count: 1,
        by: by.by,
        reason: by.reason,
        reset_by: None,
    }
}

/// Accepts one offer, and refuses all others.
fn answer(
    offers: &mut HashMap<String, OfferAnswer>,
    key: String,
    ask: OfferRequest,
) -> OfferAnswer {
    let refused = |reason: &str, busy| OfferAnswer::Refused {
        reason: reason.into(),
        busy,
    };
    let is_busy = offers
        .values()
        .any(|answer| matches!(answer, OfferAnswer::Taken(_)));
    if let Some(known) = offers.get(&key) {
        return known.clone();
    }
    let answer = match ask {
        OfferRequest::Look => return OfferAnswer::Unknown,
        OfferRequest::Withdraw { by } => refused(&format!("withdrawn by {by}"), false),
        OfferRequest::Refuse { reason, busy } => refused(&reason, busy),
        OfferRequest::Take { .. } if is_busy => refused("job 7 is queued here", true),
        OfferRequest::Take { job: new, .. } => {
            let title = new.title;
            OfferAnswer::Taken(Box::new(JobView { title, ..job(7) }))
        }
    };
    offers.insert(key, answer.clone());
    answer
}

const fn stopping() -> Reply {
    Reply::Stopping {
        rests_within_s: 0.8,
        delivered: true,
    }
}

fn granted(client: ClientId, request: &Request) -> Reply {
    match request {
        Request::Command { .. } => Reply::Accepted {
            command: 12,
            takes_s: Some(1.5),
        },
        Request::Stop { .. } => stopping(),
        Request::TakeLease | Request::SeizeLease => Reply::Lease {
            lease: Some(LeaseView {
                client,
                name: "test".into(),
                device: None,
                person: "test".into(),
                is_program: false,
                since_s: 3.0,
                asked_by: Vec::new(),
            }),
        },
        Request::AskLease | Request::ReleaseLease | Request::GrantLease { .. } => {
            Reply::Lease { lease: None }
        }
        Request::SubmitJob { .. }
        | Request::QueueAgain { .. }
        | Request::MoveJob { .. }
        | Request::StartJob { .. }
        | Request::StepJob { .. }
        | Request::PauseJob => Reply::Job { job: job(8) },
        _ => Reply::Done,
    }
}
