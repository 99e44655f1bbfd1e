//! Requests to other stations, and requests from them.

use std::collections::BTreeMap;
use std::fmt::Display;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use dobot_api::problem_kinds::{MALFORMED, MEMBER_AWAY, ROLE, TOO_MANY_REQUESTS, UNAUTHORISED};
use dobot_api::{ApiAnswer, ApiRequest, Member, MemberAnswer, Presence, Problem};
use dobot_station::{FleetAsk, PROOF, StationApi, prove};
use tokio::sync::Semaphore;
use tokio::task::JoinSet;
use zenoh::Session;
use zenoh::bytes::ZBytes;
use zenoh::handlers::{DefaultHandler, FifoChannelHandler};
use zenoh::qos::Priority;
use zenoh::query::{ConsolidationMode, Query, QueryTarget, Reply};
use zenoh::sample::Sample;
use zenoh::session::SessionGetBuilder;

use crate::id::new_id;
use crate::identity::{Identity, Peer, statement};
use crate::key_expressions::{API, MemberKey, SEALED};
use crate::sealing::{Agreed, Half, KEY, Meetings};

/// The certificates of the members that accept requests.
pub(crate) type Peers = Arc<Mutex<BTreeMap<MemberKey, Arc<Peer>>>>;

/// The session, identity and peers with which requests are sent.
#[derive(Clone, Debug)]
pub(crate) struct Requester {
    pub(crate) session: Session,
    pub(crate) identity: Arc<Identity>,
    pub(crate) peers: Peers,
}

impl Requester {
    fn peer(&self, member: &MemberKey) -> Option<Arc<Peer>> {
        let peers = self.peers.lock();
        let peers = peers.unwrap_or_else(PoisonError::into_inner);
        peers.get(member).cloned()
    }

    /// Sends a request with real-time priority to a resource of a member. The response is signed.
    pub(crate) async fn ask_first(
        &self,
        member: &MemberKey,
        what: &str,
        payload: &[u8],
        within: Duration,
    ) -> Result<Vec<u8>, String> {
        let peer = self.peer(member).ok_or("has not shown its certificate")?;
        let asking = MemberRequest {
            requester: self,
            peer: &peer,
        };
        let key = member.resource(what);
        asking
            .signed(&key, payload, within, Priority::RealTime)
            .await
    }
}

/// The timeout for a response: that of the slowest request of a station's own API.
const WITHIN: Duration = Duration::from_secs(60);
/// The timeout for the response to a stop.
const STOP_WITHIN: Duration = Duration::from_secs(2);
/// The timeout for the handshake.
const MEET_WITHIN: Duration = Duration::from_secs(10);
/// The maximum length of a stop request, in bytes; it may contain a reason.
const LONGEST_STOP: usize = 4096;
/// The maximum number of requests that are served concurrently. A stop is always served.
const AT_ONCE: usize = 64;

/// Sends a request to all addressed members concurrently.
pub(crate) async fn ask(requester: Option<&Requester>, api: &StationApi, ask: FleetAsk) {
    let request = Arc::new(ask.request);
    let mut asked = JoinSet::new();
    for member in ask.to {
        let (requester, api, request) = (requester.cloned(), api.clone(), request.clone());
        asked.spawn(async move { ask_one(requester.as_ref(), &api, &member, &request).await });
    }
    let mut answers = asked.join_all().await;
    answers.sort_by(|one, other| (&one.member, &one.id).cmp(&(&other.member, &other.id)));
    // The requester may be gone.
    let _ = ask.answers.send(answers);
}

/// Sends a request to one member.
pub(crate) async fn ask_one(
    requester: Option<&Requester>,
    api: &StationApi,
    member: &Member,
    request: &ApiRequest,
) -> MemberAnswer {
    let asked = Instant::now();
    let answer = match &member.presence {
        // A stop goes to every station that might receive it.
        Presence::Refused { problem } if !is_stop(request) => Err(problem.clone()),
        _ if member.here => Ok(api.call(request).await),
        _ => ask_other(requester, member, request).await,
    };
    MemberAnswer {
        member: member.name.clone(),
        id: member.id.clone(),
        answer: answer.unwrap_or_else(|problem| ApiAnswer::of_problem(&problem)),
        took_ms: asked.elapsed().as_secs_f64() * 1e3,
    }
}

async fn ask_other(
    requester: Option<&Requester>,
    member: &Member,
    request: &ApiRequest,
) -> Result<ApiAnswer, Problem> {
    let away = |detail: String| {
        let hint = if is_stop(request) {
            "stop the arm on its own page, or with its power switch"
        } else {
            "check its own page"
        };
        MEMBER_AWAY.hinted(detail, hint)
    };
    let name = &member.name;
    let requester = requester.ok_or_else(|| away(format!("{name} cannot be reached yet")))?;
    let key = MemberKey {
        name: name.clone(),
        id: member.id.clone(),
    };
    let peer = requester.peer(&key);
    let peer = peer.ok_or_else(|| away(format!("{name} has not shown its certificate")))?;
    let asking = MemberRequest {
        requester,
        peer: &peer,
    };
    let answer = if is_open(request) {
        asking.openly(&key.resource(API), request).await
    } else {
        let checked = requester.identity.check(&peer);
        checked.map_err(|why| away(format!("the certificate of {name} cannot be used: {why}")))?;
        asking.sealed(&key.resource(SEALED), request).await
    };
    let answer = answer.map_err(|why| away(format!("{name} {why}")))?;
    serde_json::from_slice(&answer)
        .map_err(|error| away(format!("{name} sent an unreadable response: {error}")))
}

/// Whether every member may send and read this request. All other requests are sealed.
fn is_open(request: &ApiRequest) -> bool {
    let is_secret = request.token.is_some() || request.lease.is_some();
    !is_secret && (request.method == "GET" || is_stop(request))
}

/// A request to one station. Responses that other stations send in its name are ignored.
struct MemberRequest<'a> {
    requester: &'a Requester,
    peer: &'a Peer,
}

impl MemberRequest<'_> {
    /// Sends a public request or a stop without a handshake. The response is signed.
    async fn openly(&self, key: &str, request: &ApiRequest) -> Result<Vec<u8>, String> {
        let (within, priority) = if is_stop(request) {
            // A stop overtakes all other messages.
            (STOP_WITHIN, Priority::RealTime)
        } else {
            (WITHIN, Priority::DEFAULT)
        };
        self.signed(key, &json(request), within, priority).await
    }

    /// Sends a public request. The response is signed.
    async fn signed(
        &self,
        key: &str,
        payload: &[u8],
        within: Duration,
        priority: Priority,
    ) -> Result<Vec<u8>, String> {
        let nonce = new_id().map_err(not_asked)?;
        let question = self.question(key, payload, within).attachment(&nonce);
        let question = question
            .priority(priority)
            .express(priority == Priority::RealTime);
        let replies = question.await.map_err(not_asked)?;
        first(&replies, within, |sample| {
            let answer = sample.payload().to_bytes();
            let signature = sample.attachment()?.to_bytes();
            let statement = answered(key, nonce.as_bytes(), payload, &answer);
            let is_its_own = self.peer.has_signed(&statement, &signature);
            is_its_own.then(|| answer.into_owned())
        })
        .await
    }

    /// Sends any other request: the receiver authenticates first, and only it can read the request.
    async fn sealed(&self, key: &str, request: &ApiRequest) -> Result<Vec<u8>, String> {
        let own = &self.requester.identity;
        let random = || "cannot be asked: the system has no random numbers".to_owned();
        let half = Half::new(own).ok_or_else(random)?;
        let replies = self.question(key, &half.public, MEET_WITHIN);
        let replies = replies.await.map_err(not_asked)?;
        let mut half = Some(half);
        let agreed = first(&replies, MEET_WITHIN, |sample| {
            let theirs = sample.payload().to_bytes();
            let signature = sample.attachment()?.to_bytes();
            // A key is for one use: it is consumed by a response that the receiver has signed.
            let is_signed = half.as_ref()?.is_met(key, self.peer, &theirs, &signature);
            let agreed = is_signed
                .then(|| half.take()?.agree(key, &theirs))
                .flatten()?;
            Some((theirs.into_owned(), agreed))
        })
        .await;
        let (theirs, agreed) = agreed?;
        let request = proved(&agreed, request);
        let sealed = agreed.seal_request(own, &request).ok_or_else(random)?;
        let replies = self.question(key, &[theirs, sealed].concat(), WITHIN);
        let replies = replies.await.map_err(not_asked)?;
        first(&replies, WITHIN, |sample| {
            agreed.open_answer(&sample.payload().to_bytes())
        })
        .await
    }

    /// Returns a query to this station only.
    fn question<'q>(
        &'q self,
        key: &'q str,
        payload: &[u8],
        within: Duration,
    ) -> SessionGetBuilder<'q, 'q, DefaultHandler> {
        let question = self.requester.session.get(key).payload(payload);
        question
            .target(QueryTarget::All)
            .consolidation(ConsolidationMode::None)
            .timeout(within)
    }
}

/// Returns the request without its token, preceded by a proof that the sender holds the token. The
/// receiver does not learn the token.
fn proved(agreed: &Agreed, request: &ApiRequest) -> Vec<u8> {
    let mut request = request.clone();
    let token = request.token.take();
    let request = json(&request);
    let proof = token.map_or(NO_PROOF, |token| prove(&token, &agreed.statement(&request)));
    [&proof[..], &request].concat()
}

/// Placeholder for a request without a token.
const NO_PROOF: [u8; PROOF] = [0; PROOF];

fn not_asked(error: impl Display) -> String {
    format!("cannot be asked: {error}")
}

/// Returns the first authentic response of the station.
async fn first<T>(
    replies: &FifoChannelHandler<Reply>,
    within: Duration,
    mut accept: impl FnMut(&Sample) -> Option<T>,
) -> Result<T, String> {
    let (mut forged, mut is_late) = (0_u32, false);
    while let Ok(reply) = replies.recv_async().await {
        match reply.result() {
            Ok(sample) => match accept(sample) {
                Some(answer) => return Ok(answer),
                None => forged += 1,
            },
            Err(_) => is_late = true,
        }
    }
    let within_s = within.as_secs();
    Err(match forged {
        0 if is_late => format!("did not answer within {within_s} s"),
        0 => "cannot be reached".to_owned(),
        _ => format!("did not answer; {forged} forged responses were ignored"),
    })
}

/// The statement that a station signs with a public response.
fn answered(key: &str, nonce: &[u8], request: &[u8], answer: &[u8]) -> Vec<u8> {
    statement("answer", &[key.as_bytes(), nonce, request, answer])
}

fn json(value: &impl serde::Serialize) -> Vec<u8> {
    serde_json::to_vec(value).expect("structures with text keys are JSON")
}

fn is_stop(request: &ApiRequest) -> bool {
    request.method == "POST" && request.path == "/api/v1/stop"
}

/// Whether this is a request to stop. Longer messages are not parsed.
pub(crate) fn asks_to_stop(query: &Query) -> bool {
    let payload = query
        .payload()
        .filter(|payload| payload.len() <= LONGEST_STOP);
    payload.is_some() && read(&bytes(payload)).is_ok_and(|request| is_stop(&request))
}

/// Serves the requests of other stations.
#[derive(Clone)]
pub(crate) struct Responder {
    api: StationApi,
    own: MemberKey,
    identity: Arc<Identity>,
    meetings: Arc<Meetings>,
    places: Arc<Semaphore>,
}

impl Responder {
    pub(crate) fn new(api: StationApi, own: MemberKey, identity: Arc<Identity>) -> Self {
        Self {
            api,
            own,
            identity,
            meetings: Arc::default(),
            places: Arc::new(Semaphore::new(AT_ONCE)),
        }
    }

    /// Serves a public request.
    pub(crate) async fn answer(self, query: Query) {
        let request = bytes(query.payload());
        let answer = match read(&request) {
            Ok(request) if is_open(&request) => self.call(&request, None).await,
            Ok(_) => ApiAnswer::of_problem(&ROLE.hinted(
                "this request is readable by every member of the fleet; only GET and stop without a token are allowed",
                "send it through a station of the fleet, which seals it: `POST /api/v1/fleet/requests`",
            )),
            Err(problem) => ApiAnswer::of_problem(&problem),
        };
        self.reply(&query, API, &request, json(&answer)).await;
    }

    /// Sends a signed response from one of this station's resources.
    pub(crate) async fn reply(&self, query: &Query, what: &str, request: &[u8], answer: Vec<u8>) {
        let nonce = bytes(query.attachment());
        let statement = answered(&self.own.resource(what), &nonce, request, &answer);
        let signature = self.identity.sign(&statement);
        let reply = query
            .reply(query.key_expr(), answer)
            .attachment(&signature[..]);
        if let Err(error) = reply.await {
            tracing::info!(%error, "cannot send a response to the fleet");
        }
    }

    /// Authenticates this station, or serves a sealed request. Anything else gets no response.
    pub(crate) async fn answer_sealed(self, query: Query) {
        let asked = bytes(query.payload());
        let reply = if asked.len() == KEY {
            let met = self
                .meetings
                .meet(&self.identity, &self.own.resource(SEALED), &asked);
            let Some((key, signature)) = met else {
                return;
            };
            query
                .reply(query.key_expr(), &key[..])
                .attachment(&signature[..])
        } else {
            let Some(answer) = self.answer_of(&asked).await else {
                tracing::info!("a request of the fleet is not sealed for this station");
                return;
            };
            query.reply(query.key_expr(), answer)
        };
        if let Err(error) = reply.await {
            tracing::info!(%error, "cannot send a response to the fleet");
        }
    }

    /// Returns the sealed response to a sealed request.
    async fn answer_of(&self, asked: &[u8]) -> Option<Vec<u8>> {
        let (key, sealed) = asked.split_at_checked(KEY)?;
        let agreed = self.meetings.take(key)?;
        let answer = match agreed.open_request(&self.identity, sealed) {
            Ok((peer, request)) => {
                tracing::debug!(by = peer.common_name, "request of the fleet");
                self.answer_proved(&agreed, &request).await
            }
            Err(why) => ApiAnswer::of_problem(&UNAUTHORISED.problem(format!(
                "the certificate of the requesting station is not accepted: {why}"
            ))),
        };
        agreed.seal_answer(json(&answer))
    }

    /// Serves a request with a proof of its token.
    async fn answer_proved(&self, agreed: &Agreed, request: &[u8]) -> ApiAnswer {
        let Some((proof, text)) = request.split_at_checked(PROOF) else {
            return ApiAnswer::of_problem(
                &MALFORMED.problem("a sealed request begins with a proof"),
            );
        };
        match read(text) {
            Ok(request) if proof == NO_PROOF => self.call(&request, None).await,
            Ok(request) => {
                let proof = Some((&*agreed.statement(text), proof));
                self.call(&request, proof).await
            }
            Err(problem) => ApiAnswer::of_problem(&problem),
        }
    }

    /// Calls the API of this station, with a statement and the proof of a token for it, if any.
    async fn call(&self, request: &ApiRequest, proof: Option<(&[u8], &[u8])>) -> ApiAnswer {
        let place = self.places.try_acquire();
        if place.is_err() && !is_stop(request) {
            let many = format!("{AT_ONCE} requests of the fleet are already in progress");
            return ApiAnswer::of_problem(&TOO_MANY_REQUESTS.hinted(many, "retry after a second"));
        }
        match proof {
            Some((statement, proof)) => self.api.call_proved(request, statement, proof).await,
            None => self.api.call(request).await,
        }
    }
}

fn bytes(found: Option<&ZBytes>) -> Vec<u8> {
    found
        .map(|bytes| bytes.to_bytes().into_owned())
        .unwrap_or_default()
}

fn read(request: &[u8]) -> Result<ApiRequest, Problem> {
    serde_json::from_slice(request).map_err(|error| {
        MALFORMED.problem(format!(
            "a request of the fleet must be JSON with method and path: {error}"
        ))
    })
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use crate::credentials::Credentials;

    /// The agreement of two members after a handshake.
    fn meet() -> Agreed {
        let folder = tempfile::tempdir().unwrap();
        let names = ["desk-1", "desk-2"].map(|name| name.parse().unwrap());
        let all = Credentials::make(folder.path(), &names).unwrap();
        let [asker, asked] = [0, 1].map(|index| all[index].identity().unwrap());
        let half = Half::new(&asker).unwrap();
        let meetings = Meetings::default();
        let (key, _) = meetings.meet(&asked, "desk-2", &half.public).unwrap();
        half.agree("desk-2", &key).unwrap()
    }

    #[test]
    fn the_recipient_gets_a_proof_for_this_request_and_not_the_token() {
        let token = "0123456789abcdef".repeat(4);
        let request = ApiRequest {
            method: "POST".into(),
            path: "/api/v1/lease".into(),
            token: Some(token.clone()),
            ..ApiRequest::default()
        };
        let [one, two] = [meet(), meet()].map(|agreed| proved(&agreed, &request));
        let holds = |sent: &[u8]| {
            sent.windows(16)
                .any(|window| token.as_bytes().starts_with(window))
        };
        assert!(!holds(&one) && !holds(&two));
        assert_eq!(one[PROOF..], two[PROOF..], "the request is the same");
        assert_ne!(one[..PROOF], two[..PROOF], "the proof is not");
        let without = ApiRequest {
            token: None,
            ..request
        };
        assert_eq!(proved(&meet(), &without)[..PROOF], NO_PROOF);
    }
}
