//! The requester of a route, and the routes of the policy.

use std::sync::Arc;

use axum::Json;
use axum::extract::{FromRequestParts, Path, State};
use axum::http::header::LOCATION;
use axum::http::request::Parts;
use axum::http::{HeaderName, Method, StatusCode, Uri};
use axum::response::{IntoResponse, Response};
use dobot_api::problem_kinds::{self, BAD_POLICY, METHOD, POLICY_FILE, ProblemKind, UNKNOWN_PATH};
use dobot_api::{NewJob, Notice, Reply, Request, Role, write_private};
use dobot_draw::Options;
use dobot_host::Client;
use dobot_safety::{KeepOutEdit, Policy};
use dobot_supervisor::{Refusal, is_plain};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::http::access::auth;
use crate::http::app::{App, Caller};
use crate::http::arm_facts::ArmFacts;
use crate::http::exchange::responses::{Body, RequestFailed, json};

/// The header for a lease token that was granted over plain HTTP.
pub(crate) const LEASE: HeaderName = HeaderName::from_static("dobot-lease");

/// The header for the key of a repeatable request.
pub(crate) const KEY: HeaderName = HeaderName::from_static("idempotency-key");

/// The caller of a route, with the means to send requests to the driver.
#[derive(Debug)]
pub(crate) struct Requester {
    pub(crate) app: Arc<App>,
    pub(crate) caller: Caller,
    /// The token of the request, if any.
    pub(crate) token: Option<String>,
    /// The token of a lease.
    pub(crate) lease: Option<String>,
    /// The sender's key of the request.
    pub(crate) key: Option<String>,
}

impl FromRequestParts<Arc<App>> for Requester {
    type Rejection = RequestFailed;

    async fn from_request_parts(parts: &mut Parts, app: &Arc<App>) -> Result<Self, RequestFailed> {
        let caller = parts.extensions.get::<Caller>().cloned();
        // A header that is not text is not a token or key.
        let header = |name| {
            let found = parts.headers.get(name)?;
            Some(found.to_str().unwrap_or_default().to_owned())
        };
        Ok(Self {
            app: app.clone(),
            caller: caller.expect("authorisation lets only callers in"),
            token: auth::presented(&parts.headers)?,
            lease: header(LEASE),
            key: header(KEY),
        })
    }
}

impl Requester {
    /// Checks the caller's role.
    pub(crate) fn check_role(&self, needed: Role) -> Result<(), Refusal> {
        let found = self.caller.role;
        if found < needed {
            return Err(Refusal::Role { needed, found });
        }
        Ok(())
    }

    /// Sends a request to the driver.
    pub(crate) async fn ask(&self, request: Request) -> Result<Json<Reply>, RequestFailed> {
        let client = self.client().await?;
        Ok(Json(client.request(request).await?))
    }

    /// Queues a job; the header Location contains its path.
    pub(crate) async fn queue(&self, job: NewJob) -> Result<Response, RequestFailed> {
        self.queue_of_file(job, None).await
    }

    /// Queues a job made from a stored file, with the options of its drawing.
    pub(crate) async fn queue_of_file(
        &self,
        job: NewJob,
        made: Option<(u64, Option<Options>)>,
    ) -> Result<Response, RequestFailed> {
        let key = self.key.clone();
        let reply = self.ask(Request::SubmitJob { job, key }).await?;
        if let (Reply::Job { job }, Some((file, options))) = (&reply.0, made) {
            let saved = self.app.files.set_job(file, job.job, options).await;
            // The job is queued, whatever is known about its file.
            self.app.report_unsaved(saved);
        }
        Ok(queued(reply))
    }

    /// Returns the client of the lease token, or one for this request only.
    pub(crate) async fn client(&self) -> Result<Arc<Client>, RequestFailed> {
        match &self.lease {
            Some(token) => {
                let (role, now) = (self.caller.role, self.app.now());
                Ok(self.app.http_leases.find(token, role, now)?)
            }
            None => self.come(&self.caller.name).await,
        }
    }

    /// Registers a new client.
    pub(crate) async fn come(&self, name: &str) -> Result<Arc<Client>, RequestFailed> {
        let (role, person) = (self.caller.role, self.caller.person(name));
        let client = self.app.handle.client_of(name, role, person).await?;
        Ok(Arc::new(client))
    }
}

/// Returns the response for a queued job.
pub(crate) fn queued(reply: Json<Reply>) -> Response {
    let place = match &reply.0 {
        Reply::Job { job } => format!("/api/v1/jobs/{}", job.job),
        _ => return reply.into_response(),
    };
    (StatusCode::CREATED, [(LOCATION, place)], reply).into_response()
}

/// Whether a client may have this name.
pub(crate) fn is_name(name: &str) -> bool {
    (1..=60).contains(&name.chars().count()) && name.chars().all(is_plain)
}

pub(crate) async fn state(State(app): State<Arc<App>>) -> Response {
    json(app.handle.state().json())
}

pub(crate) async fn notices(State(app): State<Arc<App>>) -> Response {
    let recent = app.handle.recent();
    let recent: Vec<&Notice> = recent.iter().map(AsRef::as_ref).collect();
    Json(recent).into_response()
}

pub(crate) async fn policy(State(app): State<Arc<App>>) -> Response {
    Json(&app.handle.rules().policy).into_response()
}

pub(crate) async fn arm(State(app): State<Arc<App>>) -> Response {
    Json(ArmFacts::of(
        &app.handle.rules(),
        app.handle.state().state(),
    ))
    .into_response()
}

/// A change of a keep-out zone in a draft of a policy.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct EditPolicy {
    /// The TOML text of the draft.
    text: String,
    /// The change.
    edit: KeepOutEdit,
}

/// A draft of a policy.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct PolicyDraft {
    /// Its TOML text.
    text: String,
}

/// Changes a keep-out zone in a draft of a policy; the active policy is unchanged.
pub(crate) async fn edit_policy(
    Body(asked): Body<EditPolicy>,
) -> Result<Json<PolicyDraft>, RequestFailed> {
    let text = asked.edit.apply(&asked.text);
    let text = text.map_err(|error| BAD_POLICY.problem(error.to_string()))?;
    Ok(Json(PolicyDraft { text }))
}

/// A new policy.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PolicyText {
    /// The TOML text, as shown by `dobot policy`.
    text: String,
    /// Whether to only check the text.
    #[serde(default)]
    check: bool,
}

/// Returns the text of the active policy, with its comments if it came from a file.
pub(crate) async fn policy_text(State(app): State<Arc<App>>) -> Response {
    let policy = &app.handle.rules().policy;
    let kept = std::fs::read_to_string(&app.policy_file).ok();
    let same = |text: &String| Policy::from_toml(text).is_ok_and(|parsed| parsed == *policy);
    let text = kept.filter(same).unwrap_or_else(|| match policy {
        policy if *policy == Policy::default() => Policy::DEFAULT_TOML.to_owned(),
        policy => policy.to_toml(),
    });
    text.into_response()
}

/// Replaces the active policy and stores the new one.
pub(crate) async fn set_policy(
    requester: Requester,
    Body(new): Body<PolicyText>,
) -> Result<Json<Policy>, RequestFailed> {
    let policy = Policy::from_toml(&new.text);
    let policy = policy.map_err(|error| BAD_POLICY.problem(error.to_string()))?;
    if new.check {
        return Ok(Json(policy));
    }
    let client = requester.client().await?;
    client.set_policy(policy.clone()).await?;
    let file = &requester.app.policy_file;
    write_private(file, &new.text).map_err(|error| {
        POLICY_FILE.problem(format!("cannot write {}: {error}", file.display()))
    })?;
    Ok(Json(policy))
}

pub(crate) async fn problem(
    Path(name): Path<String>,
) -> Result<Json<&'static ProblemKind>, RequestFailed> {
    let unknown = || UNKNOWN_PATH.problem("there is no problem type with this name");
    Ok(Json(problem_kinds::named(&name).ok_or_else(unknown)?))
}

pub(crate) async fn document() -> Response {
    json(super::document::TEXT.clone())
}

pub(crate) async fn unknown_path(uri: Uri) -> RequestFailed {
    let path: String = uri.path().chars().take(80).collect();
    let hint = "`/api/v1/openapi.json` lists all paths";
    RequestFailed(UNKNOWN_PATH.hinted(format!("there is nothing at {path}"), hint))
}

pub(crate) async fn method(method: Method, uri: Uri) -> RequestFailed {
    RequestFailed(METHOD.problem(format!("{} does not take {method}", uri.path())))
}
