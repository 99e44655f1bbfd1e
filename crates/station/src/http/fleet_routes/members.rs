//! The fleet: its members, and requests to several stations.

use std::collections::HashSet;
use std::convert::Infallible;
use std::sync::Arc;
use std::time::Duration;

use axum::extract::State;
use axum::response::sse::{Event, KeepAlive, Sse};
use axum::{Extension, Json};
use dobot_api::problem_kinds::{GIVES_NO_ARMS, NO_FLEET, UNAUTHORISED};
use dobot_api::{
    ApiRequest, FleetView, FleetWideStop, Member, MemberAnswer, Problem, Recipients, Role,
};
use dobot_supervisor::StoppedBy;
use futures_util::Stream;
use schemars::JsonSchema;
use serde::Deserialize;
use tokio::sync::{OwnedSemaphorePermit, watch};
use tokio::time::{Interval, MissedTickBehavior, interval};

use crate::http::access::tokens::digest;
use crate::http::app::{App, Caller, Peer, Stay};
use crate::http::exchange::requester::Requester;
use crate::http::exchange::responses::{Body, JOB, Maybe, Nothing, RequestFailed};
use crate::http::live::events::ALIVE_EVERY;
use crate::http::routes;
use crate::{ArmsPort, FleetPort, Members};

/// Returns the station's view of its fleet.
pub(crate) async fn fleet(State(app): State<Arc<App>>) -> Result<Json<FleetView>, RequestFailed> {
    let port = app.fleet()?;
    let members = port.look().await?.borrow().clone();
    Ok(Json(FleetView {
        name: port.name().into(),
        at_s: app.handle.state().state().at_s,
        members: members.iter().map(|member| (**member).clone()).collect(),
    }))
}

/// Streams each member when it changes, beginning with all members, and the removal of members.
pub(crate) async fn events(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
) -> Result<Sse<impl Stream<Item = Result<Event, Infallible>>>, RequestFailed> {
    let mut pace = interval(REPORT_EVERY);
    pace.set_missed_tick_behavior(MissedTickBehavior::Delay);
    let watching = Watching {
        members: app.fleet()?.look().await?,
        sent: Members::default(),
        waiting: Vec::new(),
        gone: Vec::new(),
        pace,
        _place: app.place()?,
        stay: Stay { app, caller },
    };
    let stream = futures_util::stream::unfold(watching, |mut stream| async move {
        let event = stream.next().await?;
        Some((Ok(event), stream))
    });
    Ok(Sse::new(stream).keep_alive(KeepAlive::new().interval(ALIVE_EVERY)))
}

/// The interval at which members are compared: as fast as a person sees a tile move.
const REPORT_EVERY: Duration = Duration::from_millis(100);

/// The state of one event stream.
struct Watching {
    members: watch::Receiver<Members>,
    /// The members as last sent.
    sent: Members,
    /// The members still to be sent.
    waiting: Vec<Arc<Member>>,
    /// The ids of removed members still to be sent.
    gone: Vec<String>,
    pace: Interval,
    stay: Stay,
    _place: OwnedSemaphorePermit,
}

impl Watching {
    async fn next(&mut self) -> Option<Event> {
        while self.waiting.is_empty() && self.gone.is_empty() {
            let ends = tokio::select! {
                _ = self.pace.tick() => false,
                () = self.stay.is_over() => true,
            };
            if ends {
                return None;
            }
            self.look();
        }
        if let Some(id) = self.gone.pop() {
            let text = serde_json::json!({ "id": id }).to_string();
            return Some(Event::default().event("gone").data(text));
        }
        let member = self.waiting.pop()?;
        let text = serde_json::to_string(&*member).expect("structures with text keys are JSON");
        Some(Event::default().event("member").data(text))
    }

    fn look(&mut self) {
        let now = self.members.borrow_and_update().clone();
        if !Arc::ptr_eq(&now, &self.sent) {
            let sent: HashSet<_> = self.sent.iter().map(Arc::as_ptr).collect();
            let is_new = |member: &&Arc<Member>| !sent.contains(&Arc::as_ptr(member));
            self.waiting = now.iter().filter(is_new).cloned().collect();
            let there: HashSet<_> = now.iter().map(|member| &member.id).collect();
            let known = self.sent.iter().map(|member| &member.id);
            self.gone = known
                .filter(|member| !there.contains(member))
                .cloned()
                .collect();
            self.sent = now;
        }
    }
}

/// A stop of several stations.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct FleetStop {
    /// The stations; all if absent.
    #[serde(default = "all")]
    to: Recipients,
    /// The reason, shown at the stopped arms.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
}

impl Default for FleetStop {
    fn default() -> Self {
        Self {
            to: all(),
            reason: None,
        }
    }
}

const fn all() -> Recipients {
    Recipients::All
}

/// Stops the arms of several stations. A stop of all is a stop of the fleet, which each station
/// keeps.
pub(crate) async fn stop(
    requester: Requester,
    Maybe(wanted): Maybe<FleetStop>,
) -> Result<Json<Vec<MemberAnswer>>, RequestFailed> {
    let port = requester.app.fleet()?;
    let fleet = if wanted.to == Recipients::All {
        stop_fleet(&requester, port, wanted.reason.clone()).await
    } else {
        None
    };
    // Anyone may stop; a token that another station does not know would prevent that.
    let request = ApiRequest {
        method: "POST".into(),
        path: routes::STOP.into(),
        body: Some(serde_json::json!({ "reason": wanted.reason, "fleet": fleet })),
        ..ApiRequest::default()
    };
    let answers = port.ask(&wanted.to, request).await?;
    if fleet.is_some() {
        let silent = silent(&port.members(), &answers);
        let port = port.clone();
        // The stop is sent until they answer; the requester does not wait for that.
        tokio::spawn(async move { drop(port.send_stops(silent).await) });
    }
    Ok(Json(answers))
}

/// Stops the whole fleet from this station; `None` if this station is ending. Even then the others are
/// stopped.
async fn stop_fleet(
    requester: &Requester,
    port: &FleetPort,
    reason: Option<String>,
) -> Option<FleetWideStop> {
    let by = StoppedBy {
        by: requester.at(port),
        reason,
        ..StoppedBy::default()
    };
    let stopped = requester.app.handle.stop_fleet(port.id(), by).await;
    stopped.ok().map(|(stop, _)| stop)
}

/// Returns the members that have not carried out the request.
fn silent(members: &[Arc<Member>], answers: &[MemberAnswer]) -> Vec<Arc<Member>> {
    let failed = answers.iter().filter(|answer| !answer.answer.is_success());
    let failed: HashSet<_> = failed.map(|answer| (&answer.member, &answer.id)).collect();
    let silent = members
        .iter()
        .filter(|member| failed.contains(&(&member.name, &member.id)));
    silent.cloned().collect()
}

/// Resets a stop of the whole fleet.
pub(crate) async fn reset_stop(
    requester: Requester,
    Extension(peer): Extension<Peer>,
    _: Maybe<Nothing>,
) -> Result<Json<Vec<MemberAnswer>>, RequestFailed> {
    let app = &requester.app;
    let port = app.fleet()?;
    requester.check_role(Role::Control)?;
    let has_token = requester
        .caller
        .token
        .is_some_and(|token| !app.tokens().is_local(&token));
    if !(has_token || peer.by_fleet || port.is_on_one_machine()) {
        let detail = "the rights of local programs are not valid at other stations";
        let hint = "set DOBOT_TOKEN to a token of this station with the role control; or reset the stop of this arm only with `dobot stop --reset`";
        return Err(UNAUTHORISED.hinted(detail, hint).into());
    }
    app.handle.reset_fleet_stops(&requester.at(port)).await?;
    let members = port.members().iter().cloned().collect();
    Ok(Json(port.send_stops(members).await?))
}

/// A request to several stations.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct FleetRequest {
    /// The stations.
    to: Recipients,
    /// The method, as in `POST`.
    method: String,
    /// The path with its query, as in `/api/v1/jobs/pause`.
    path: String,
    /// The token of a lease, if one station is addressed.
    #[serde(default)]
    lease: Option<String>,
    /// The sender's key of this request.
    #[serde(default)]
    key: Option<String>,
    /// The body, if any.
    #[serde(default)]
    body: Option<serde_json::Value>,
}

/// Sends a request to several stations, with the token of the caller.
pub(crate) async fn request(
    requester: Requester,
    Body(wanted): Body<FleetRequest, JOB>,
) -> Result<Json<Vec<MemberAnswer>>, RequestFailed> {
    let request = ApiRequest {
        method: wanted.method,
        path: wanted.path,
        lease: wanted.lease,
        key: wanted.key,
        body: wanted.body,
        // The token of local programs is valid here only.
        token: requester
            .token
            .filter(|token| !requester.app.tokens().is_local(&digest(token))),
    };
    Ok(Json(requester.app.fleet()?.ask(&wanted.to, request).await?))
}

impl Requester {
    /// Returns the caller and its station, for other stations.
    fn at(&self, port: &FleetPort) -> String {
        format!("{} at {}", self.caller.name, port.name())
    }
}

impl App {
    /// Returns the connection to the fleet, if the station belongs to one.
    pub(crate) fn fleet(&self) -> Result<&FleetPort, Problem> {
        let hint = "join one with `dobot up --fleet`";
        self.fleet
            .get()
            .ok_or_else(|| NO_FLEET.hinted("this station belongs to no fleet", hint))
    }

    /// Returns the host of virtual arms, if the station has one.
    pub(crate) fn arms(&self) -> Result<&ArmsPort, Problem> {
        let hint = "`GET /api/v1/fleet` shows the stations that do (`gives_arms`); `dobot up --virtual --fleet --virtual-arms 10` starts one";
        self.arms
            .get()
            .ok_or_else(|| GIVES_NO_ARMS.hinted("this station hosts no virtual arms", hint))
    }
}

/// Returns the problem of a field that is not a valid name of a fleet.
pub(crate) fn not_a_name(field: &str, found: &str, example: &str) -> String {
    let found: String = found.chars().take(60).collect();
    format!(
        "{field}: {found:?}; allowed are 1 to 40 lowercase letters a to z, digits and hyphens, beginning with a letter, as in {example}"
    )
}
