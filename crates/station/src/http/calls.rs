//! What each route does.

use std::sync::Arc;

use axum::Json;
use axum::extract::{FromRequestParts, Path, State};
use axum::http::request::Parts;
use axum::http::{HeaderName, Method, StatusCode, Uri};
use axum::response::{IntoResponse, Response};
use dobot_api::{JobView, NewJob, News, Notice, Problem, Reply, Request};
use dobot_rules::{Client, Refusal, is_plain};
use tokio::sync::broadcast;
use tokio::sync::broadcast::error::RecvError;

use super::answer::{Body, JOB, Maybe, NotDone, Number, json};
use super::app::{App, Visitor};
use super::bodies::{
    Arming, Granted, Height, Heir, NewCommand, NewStop, Nothing, Press, Speech, Speed, Wish,
};
use super::kinds::{self, INVALID, Kind, METHOD, NO_LEASE, NOT_REACHED, UNKNOWN_PATH};
use super::visits::LASTS;

/// The header with the token of a lease that was taken over plain HTTP.
pub(super) const LEASE: HeaderName = HeaderName::from_static("dobot-lease");

/// One who asks the owner of the arm for something.
#[derive(Debug)]
pub(super) struct Asker {
    app: Arc<App>,
    visitor: Visitor,
    lease: Option<String>,
}

impl FromRequestParts<Arc<App>> for Asker {
    type Rejection = NotDone;

    async fn from_request_parts(parts: &mut Parts, app: &Arc<App>) -> Result<Self, NotDone> {
        let visitor = parts.extensions.get::<Visitor>().cloned();
        let lease = parts
            .headers
            .get(LEASE)
            .map(|it| it.to_str().unwrap_or_default().to_owned());
        Ok(Self {
            app: app.clone(),
            visitor: visitor.expect("the gate lets only visitors in"),
            lease,
        })
    }
}

impl Asker {
    async fn ask(&self, request: Request) -> Result<Json<Reply>, NotDone> {
        let client = self.client().await?;
        Ok(Json(client.request(request).await?))
    }

    /// The client that has the lease token, or one for this request only.
    async fn client(&self) -> Result<Arc<Client>, NotDone> {
        match &self.lease {
            Some(token) => {
                let (role, now) = (self.visitor.role, self.app.now());
                Ok(self.app.visits.find(token, role, now)?)
            }
            None => self.come(&self.visitor.name).await,
        }
    }

    async fn come(&self, name: &str) -> Result<Arc<Client>, NotDone> {
        let client = self.app.handle.client(name, self.visitor.role).await?;
        Ok(Arc::new(client))
    }

    /// Asks for control, and keeps the client if that is granted.
    async fn hold(&self, wish: Wish, request: Request) -> Result<Json<Granted>, NotDone> {
        let name = called(wish, &self.visitor)?;
        let client = match &self.lease {
            Some(_) => self.client().await?,
            None => self.come(&name).await?,
        };
        let reply = client.request(request).await?;
        let token = match &self.lease {
            Some(token) => token.clone(),
            None => self
                .app
                .visits
                .keep(client, self.app.now())?
                .secret()
                .into(),
        };
        let lease = match reply {
            Reply::Lease { lease } => lease,
            _ => self.app.handle.state().state().lease.clone(),
        };
        Ok(Json(Granted {
            token,
            lasts_s: LASTS.as_secs(),
            lease,
        }))
    }
}

/// What a client wants to be called, or else what its token is called.
fn called(wish: Wish, visitor: &Visitor) -> Result<String, Problem> {
    let Some(name) = wish.name else {
        return Ok(visitor.name.clone());
    };
    if is_name(&name) {
        return Ok(name);
    }
    Err(INVALID.problem("name: this takes 1 to 60 characters that can be printed"))
}

pub(super) fn is_name(name: &str) -> bool {
    (1..=60).contains(&name.chars().count()) && name.chars().all(is_plain)
}

pub(super) async fn state(State(app): State<Arc<App>>) -> Response {
    json(app.handle.state().json())
}

pub(super) async fn notices(State(app): State<Arc<App>>) -> Response {
    let recent = app.handle.recent();
    let recent: Vec<&Notice> = recent.iter().map(AsRef::as_ref).collect();
    Json(recent).into_response()
}

pub(super) async fn policy(State(app): State<Arc<App>>) -> Response {
    Json(&app.handle.rules().policy).into_response()
}

pub(super) async fn command(
    asker: Asker,
    Body(new): Body<NewCommand>,
) -> Result<Response, NotDone> {
    let mut notices = asker.app.handle.notices();
    let client = asker.client().await?;
    let command = new.command;
    let reply = client.request(Request::Command { command }).await?;
    match reply {
        Reply::Accepted { command, .. } if new.wait => over(command, &mut notices).await,
        reply => Ok((StatusCode::ACCEPTED, Json(reply)).into_response()),
    }
}

/// Waits until a command is over.
async fn over(
    number: u64,
    notices: &mut broadcast::Receiver<Arc<Notice>>,
) -> Result<Response, NotDone> {
    loop {
        let notice = notices.recv().await.map_err(|error| match error {
            RecvError::Closed => Problem::from(Refusal::Ending),
            RecvError::Lagged(_) => NOT_REACHED
                .problem("so much happened that it was not seen whether the command is over"),
        })?;
        match notice.news {
            News::CommandDone { command } if command == number => {
                return Ok(Json(Reply::Done).into_response());
            }
            News::CommandFailed { command } if command == number => {
                return Err(NOT_REACHED.problem(&notice.text).into());
            }
            _ => {}
        }
    }
}

pub(super) async fn stop(asker: Asker, Maybe(new): Maybe<NewStop>) -> Result<Json<Reply>, NotDone> {
    let reason = new.reason;
    asker.ask(Request::Stop { reason }).await
}

pub(super) async fn reset_stop(asker: Asker, _: Maybe<Nothing>) -> Result<Json<Reply>, NotDone> {
    asker.ask(Request::ResetStop).await
}

pub(super) async fn take_lease(
    asker: Asker,
    Maybe(wish): Maybe<Wish>,
) -> Result<Json<Granted>, NotDone> {
    asker.hold(wish, Request::TakeLease).await
}

pub(super) async fn ask_lease(
    asker: Asker,
    Maybe(wish): Maybe<Wish>,
) -> Result<Json<Granted>, NotDone> {
    asker.hold(wish, Request::AskLease).await
}

pub(super) async fn seize_lease(
    asker: Asker,
    Maybe(wish): Maybe<Wish>,
) -> Result<Json<Granted>, NotDone> {
    asker.hold(wish, Request::SeizeLease).await
}

pub(super) async fn grant_lease(
    asker: Asker,
    Body(heir): Body<Heir>,
) -> Result<Json<Reply>, NotDone> {
    asker.ask(Request::GrantLease { to: heir.to }).await
}

pub(super) async fn release_lease(asker: Asker, _: Maybe<Nothing>) -> Result<Json<Reply>, NotDone> {
    let Some(token) = asker.lease.clone() else {
        return Err(NO_LEASE
            .hinted(
                "this request comes without a lease token",
                "send it as header `Dobot-Lease`",
            )
            .into());
    };
    let reply = asker.ask(Request::ReleaseLease).await;
    asker.app.visits.end(&token);
    reply
}

pub(super) async fn arm_laser(
    asker: Asker,
    Body(new): Body<Arming>,
) -> Result<Json<Reply>, NotDone> {
    asker.ask(Request::ArmLaser { for_s: new.for_s }).await
}

pub(super) async fn disarm_laser(asker: Asker, _: Maybe<Nothing>) -> Result<Json<Reply>, NotDone> {
    asker.ask(Request::DisarmLaser).await
}

pub(super) async fn confirm_pose(asker: Asker, _: Maybe<Nothing>) -> Result<Json<Reply>, NotDone> {
    asker.ask(Request::ConfirmPose).await
}

pub(super) async fn set_dialect(
    asker: Asker,
    Body(new): Body<Speech>,
) -> Result<Json<Reply>, NotDone> {
    let dialect = new.dialect;
    asker.ask(Request::SetDialect { dialect }).await
}

pub(super) async fn detect(asker: Asker, _: Maybe<Nothing>) -> Result<Json<Reply>, NotDone> {
    asker.ask(Request::Detect).await
}

pub(super) async fn jog(asker: Asker, Body(press): Body<Press>) -> Result<Json<Reply>, NotDone> {
    asker.ask(Request::Jog { jog: press.jog }).await
}

pub(super) async fn release_jog(asker: Asker, _: Maybe<Nothing>) -> Result<Json<Reply>, NotDone> {
    asker.ask(Request::Release).await
}

pub(super) async fn jobs(State(app): State<Arc<App>>) -> Result<Json<Vec<JobView>>, NotDone> {
    Ok(Json(app.handle.jobs().await?))
}

pub(super) async fn job(
    State(app): State<Arc<App>>,
    Number(job): Number,
) -> Result<Json<JobView>, NotDone> {
    let found = app
        .handle
        .jobs()
        .await?
        .into_iter()
        .find(|it| it.job == job);
    found
        .map(Json)
        .ok_or_else(|| Refusal::NoSuchJob(job).into())
}

pub(super) async fn submit_job(
    asker: Asker,
    Body(job): Body<NewJob, JOB>,
) -> Result<Response, NotDone> {
    let reply = asker.ask(Request::SubmitJob { job }).await?;
    Ok((StatusCode::CREATED, reply).into_response())
}

pub(super) async fn start_job(
    asker: Asker,
    Number(job): Number,
    _: Maybe<Nothing>,
) -> Result<Json<Reply>, NotDone> {
    asker.ask(Request::StartJob { job }).await
}

pub(super) async fn pause_job(asker: Asker, _: Maybe<Nothing>) -> Result<Json<Reply>, NotDone> {
    asker.ask(Request::PauseJob).await
}

pub(super) async fn set_job_speed(
    asker: Asker,
    Body(Speed { percent }): Body<Speed>,
) -> Result<Json<Reply>, NotDone> {
    asker.ask(Request::SetJobSpeed { percent }).await
}

pub(super) async fn set_job_height(
    asker: Asker,
    Body(Height { offset_mm }): Body<Height>,
) -> Result<Json<Reply>, NotDone> {
    asker.ask(Request::SetJobHeight { offset_mm }).await
}

pub(super) async fn cancel_job(
    asker: Asker,
    Number(job): Number,
    _: Maybe<Nothing>,
) -> Result<Json<Reply>, NotDone> {
    asker.ask(Request::CancelJob { job }).await
}

pub(super) async fn problem(Path(name): Path<String>) -> Result<Json<&'static Kind>, NotDone> {
    let unknown = || UNKNOWN_PATH.problem("there is no kind of problem of this name");
    Ok(Json(kinds::named(&name).ok_or_else(unknown)?))
}

pub(super) async fn document() -> Response {
    json(super::document::TEXT.clone())
}

pub(super) async fn unknown_path(uri: Uri) -> NotDone {
    let path: String = uri.path().chars().take(80).collect();
    let hint = "`/api/v1/openapi.json` lists all addresses";
    NotDone(UNKNOWN_PATH.hinted(format!("there is nothing at {path}"), hint))
}

pub(super) async fn method(method: Method, uri: Uri) -> NotDone {
    NotDone(METHOD.problem(format!("{} does not take {method}", uri.path())))
}
