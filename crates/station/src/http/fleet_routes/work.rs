//! Jobs for any arm, at the station to which they are submitted.

use std::time::SystemTime;

use axum::Json;
use axum::extract::Path;
use axum::http::StatusCode;
use dobot_api::problem_kinds::INVALID;
use dobot_api::{NewJob, Problem, Role, WorkView, is_fleet_name};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::http::exchange::requester::{Requester, is_name};
use crate::http::exchange::responses::{Body, JOB, RequestFailed};
use crate::http::fleet_routes::members::not_a_name;
use crate::http::fleet_routes::offers::FleetOffer;
use crate::http::resources::drawings::NewDrawing;
use crate::{NewWork, WorkCommand};

/// A drawing or a program for any arm.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct FleetWork {
    /// A drawing; the station that takes it plans it for its own arm.
    drawing: Option<NewDrawing>,
    /// A job. Its positions are those of this station's arm: an arm with another calibration
    /// refuses it.
    job: Option<NewJob>,
    /// The features that an arm must offer, as in `["pen", "a5"]`.
    needs: Vec<String>,
    /// The student who owns it; by default the caller.
    student: Option<String>,
    /// The student's group.
    group: Option<String>,
}

/// Submits a job for any arm.
pub(crate) async fn submit(
    requester: Requester,
    Body(wanted): Body<FleetWork, JOB>,
) -> Result<(StatusCode, Json<WorkView>), RequestFailed> {
    requester.check_role(Role::Queue)?;
    wanted.drawing.as_ref().map_or(Ok(()), NewDrawing::check)?;
    let port = requester.app.fleet()?;
    let work = Box::new(wanted.work(&requester, port.name())?);
    let view = port.work(|reply| WorkCommand::Submit(work, reply)).await?;
    Ok((StatusCode::CREATED, Json(view)))
}

/// Lists all jobs that were submitted here.
pub(crate) async fn all(requester: Requester) -> Result<Json<Vec<WorkView>>, RequestFailed> {
    Ok(Json(requester.app.fleet()?.work(WorkCommand::List).await?))
}

/// Cancels a job.
pub(crate) async fn cancel(
    requester: Requester,
    Path(work): Path<String>,
) -> Result<Json<WorkView>, RequestFailed> {
    requester.check_role(Role::Queue)?;
    let port = requester.app.fleet()?;
    Ok(Json(
        port.work(|reply| WorkCommand::Cancel(work, reply)).await?,
    ))
}

/// Moves a job that is in doubt or has failed to another arm: a person has checked and decided so.
pub(crate) async fn give(
    requester: Requester,
    Path(work): Path<String>,
) -> Result<Json<WorkView>, RequestFailed> {
    requester.check_role(Role::Control)?;
    let port = requester.app.fleet()?;
    Ok(Json(
        port.work(|reply| WorkCommand::Give(work, reply)).await?,
    ))
}

impl FleetWork {
    /// Returns the stored form of the job.
    fn work(self, requester: &Requester, home: &str) -> Result<NewWork, Problem> {
        let student = self
            .student
            .unwrap_or_else(|| requester.caller.name.clone());
        check_people(&student, self.group.as_deref())?;
        check_needs(&self.needs)?;
        if let Some(key) = requester.key.as_deref().filter(|key| !is_name(key)) {
            let characters = key.chars().count();
            return Err(INVALID.problem(format!(
                "the Idempotency-Key has {characters} characters; allowed are 1 to 60 visible ones"
            )));
        }
        let title = match (&self.drawing, &self.job) {
            (Some(drawing), None) => drawing.title(),
            (None, Some(job)) => job.title.chars().take(LONGEST_TITLE).collect(),
            _ => {
                return Err(
                    INVALID.problem("expected a drawing or a job; give either `drawing` or `job`")
                );
            }
        };
        let made_for = self.job.as_ref().map(|_| requester.app.planned_for().arm());
        let offer = FleetOffer {
            by: home.to_owned(),
            student: student.clone(),
            drawing: self.drawing,
            job: self.job,
            made_for: made_for.map(|made_for| made_for.to_numbers().to_vec()),
        };
        Ok(NewWork {
            title,
            student,
            group: self.group,
            needs: self.needs,
            submitted_ms: now_ms(),
            key: requester.key.clone(),
            offer: serde_json::to_value(offer)
                .map_err(|error| INVALID.problem(error.to_string()))?,
        })
    }
}

fn check_people(student: &str, group: Option<&str>) -> Result<(), Problem> {
    if !is_name(student) {
        return Err(INVALID.problem(format!(
            "student has {} characters; allowed are 1 to 60 visible ones",
            student.chars().count()
        )));
    }
    match group.filter(|name| !is_fleet_name(name)) {
        Some(group) => Err(INVALID.problem(not_a_name("group", group, "room-2"))),
        None => Ok(()),
    }
}

fn check_needs(needs: &[String]) -> Result<(), Problem> {
    if needs.len() > MAX_NEEDS {
        let found = needs.len();
        return Err(INVALID.problem(format!(
            "needs has {found} words; allowed are up to {MAX_NEEDS}"
        )));
    }
    match needs.iter().find(|need| !is_fleet_name(need)) {
        Some(need) => Err(INVALID.problem(not_a_name("needs", need, "a5"))),
        None => Ok(()),
    }
}

/// Returns the milliseconds since 1970, by the system's clock.
fn now_ms() -> i64 {
    let since = SystemTime::UNIX_EPOCH.elapsed().unwrap_or_default();
    i64::try_from(since.as_millis()).unwrap_or(i64::MAX)
}

const MAX_NEEDS: usize = 16;
const LONGEST_TITLE: usize = 200;
