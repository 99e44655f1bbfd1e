//! Requests to other stations, and theirs to this one.

use std::sync::Arc;
use std::time::{Duration, Instant};

use dobot_api::problem_kinds::{MALFORMED, MEMBER_AWAY, TOO_MANY_REQUESTS};
use dobot_api::{ApiAnswer, ApiRequest, Member, MemberAnswer, Presence, Problem};
use dobot_station::{FleetAsk, StationApi};
use tokio::sync::Semaphore;
use tokio::task::JoinSet;
use zenoh::Session;
use zenoh::qos::Priority;
use zenoh::query::{ConsolidationMode, Query, QueryTarget};

use crate::keys::{API, MemberKey};

/// How long another station may take to answer: as long as its own API takes for the slowest request.
const WITHIN: Duration = Duration::from_secs(60);
/// How long one may take to say that its arm is stopped.
const STOP_WITHIN: Duration = Duration::from_secs(2);
/// How many requests of others are answered at once; a stop is answered always.
const AT_ONCE: usize = 64;

/// Asks all that are meant at the same time.
pub(crate) async fn ask(session: Option<&Session>, api: &StationApi, ask: FleetAsk) {
    let request = Arc::new(ask.request);
    let mut asked = JoinSet::new();
    for member in ask.to {
        let (session, api, request) = (session.cloned(), api.clone(), request.clone());
        asked.spawn(async move { ask_one(session.as_ref(), &api, &member, &request).await });
    }
    let mut answers = asked.join_all().await;
    answers.sort_by(|one, other| (&one.member, &one.id).cmp(&(&other.member, &other.id)));
    // Whoever asked may be gone.
    let _ = ask.answers.send(answers);
}

/// Asks one.
pub(crate) async fn ask_one(
    session: Option<&Session>,
    api: &StationApi,
    member: &Member,
    request: &ApiRequest,
) -> MemberAnswer {
    let asked = Instant::now();
    let answer = match &member.presence {
        // A stop goes to everyone who might hear it.
        Presence::Refused { problem } if !is_stop(request) => Err(problem.clone()),
        _ if member.here => Ok(api.call(request).await),
        _ => ask_other(session, member, request).await,
    };
    MemberAnswer {
        member: member.name.clone(),
        id: member.id.clone(),
        answer: answer.unwrap_or_else(|problem| ApiAnswer::of_problem(&problem)),
        took_ms: asked.elapsed().as_secs_f64() * 1e3,
    }
}

async fn ask_other(
    session: Option<&Session>,
    member: &Member,
    request: &ApiRequest,
) -> Result<ApiAnswer, Problem> {
    let away = |detail: String| {
        let hint = if is_stop(request) {
            "stop the arm on its own page, or with its switch"
        } else {
            "look at its own page"
        };
        MEMBER_AWAY.hinted(detail, hint)
    };
    let name = &member.name;
    let key = MemberKey {
        name: name.clone(),
        id: member.id.clone(),
    };
    let within = if is_stop(request) {
        STOP_WITHIN
    } else {
        WITHIN
    };
    // A stop goes before all else that is on its way.
    let priority = if is_stop(request) {
        Priority::RealTime
    } else {
        Priority::DEFAULT
    };
    let payload = serde_json::to_vec(request).expect("structures with text keys are JSON");
    let session = session.ok_or_else(|| away(format!("{name} cannot be reached yet")))?;
    let replies = session
        .get(key.resource(API))
        .payload(payload)
        .target(QueryTarget::All)
        .consolidation(ConsolidationMode::None)
        .timeout(within)
        .priority(priority)
        .express(is_stop(request))
        .await
        .map_err(|error| away(format!("{name} cannot be asked: {error}")))?;
    let Ok(reply) = replies.recv_async().await else {
        return Err(away(format!("{name} cannot be reached")));
    };
    let Ok(sample) = reply.result() else {
        let within_s = within.as_secs();
        return Err(away(format!("{name} did not answer within {within_s} s")));
    };
    serde_json::from_slice(&sample.payload().to_bytes())
        .map_err(|error| away(format!("{name} answers what nobody understands: {error}")))
}

fn is_stop(request: &ApiRequest) -> bool {
    request.method == "POST" && request.path == "/api/v1/stop"
}

/// Answers others.
#[derive(Clone, Debug)]
pub(crate) struct Answering {
    api: StationApi,
    places: Arc<Semaphore>,
}

impl Answering {
    pub(crate) fn new(api: StationApi) -> Self {
        Self {
            api,
            places: Arc::new(Semaphore::new(AT_ONCE)),
        }
    }

    /// Answers one request.
    pub(crate) async fn answer(self, query: Query) {
        let answer = match read(&query) {
            Ok(request) => self.call(&request).await,
            Err(problem) => ApiAnswer::of_problem(&problem),
        };
        let answer = serde_json::to_vec(&answer).expect("structures with text keys are JSON");
        if let Err(error) = query.reply(query.key_expr(), answer).await {
            tracing::info!(%error, "an answer to the fleet is lost");
        }
    }

    async fn call(&self, request: &ApiRequest) -> ApiAnswer {
        let place = self.places.try_acquire();
        if place.is_err() && !is_stop(request) {
            let many = format!("{AT_ONCE} requests of the fleet are being answered already");
            return ApiAnswer::of_problem(&TOO_MANY_REQUESTS.hinted(many, "ask again in a second"));
        }
        self.api.call(request).await
    }
}

fn read(query: &Query) -> Result<ApiRequest, Problem> {
    let payload = query.payload().map(|it| it.to_bytes()).unwrap_or_default();
    serde_json::from_slice(&payload).map_err(|error| {
        MALFORMED.problem(format!(
            "a request of the fleet is JSON with method and path; this one is not: {error}"
        ))
    })
}
