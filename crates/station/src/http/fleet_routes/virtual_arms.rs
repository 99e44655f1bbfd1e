//! Virtual arms for members of the fleet without an arm.

use axum::Json;
use axum::extract::Path;
use dobot_api::problem_kinds::INVALID;
use dobot_api::{GivenArm, GivenArms, Role, is_fleet_name};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::http::exchange::requester::Requester;
use crate::http::exchange::responses::{Body, JOB, RequestFailed};
use crate::http::fleet_routes::members::not_a_name;
use crate::{ArmCommand, ArmSelection};

/// A request for a virtual arm.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct WantedVirtualArm {
    /// Its name in the fleet: 1 to 40 lowercase letters a to z, digits and hyphens, beginning with
    /// a letter.
    name: String,
}

/// Lists the hosted arms.
pub(crate) async fn all(requester: Requester) -> Result<Json<GivenArms>, RequestFailed> {
    Ok(Json(requester.app.arms()?.wish(ArmCommand::List).await?))
}

/// Starts an arm; repeated requests for the same name return the same arm.
pub(crate) async fn give(
    requester: Requester,
    Body(wanted): Body<WantedVirtualArm, JOB>,
) -> Result<Json<GivenArm>, RequestFailed> {
    requester.check_role(Role::Control)?;
    let WantedVirtualArm { name } = wanted;
    if !is_fleet_name(&name) {
        return Err(INVALID.problem(not_a_name("name", &name, "anna")).into());
    }
    let arms = requester.app.arms()?;
    let seen = requester.app.fleet()?.member(&name);
    let wanted = ArmSelection { name, seen };
    let given = arms.wish(|reply| ArmCommand::Give(wanted, reply)).await?;
    Ok(Json(given?))
}

/// Ends an arm.
pub(crate) async fn end(
    requester: Requester,
    Path(name): Path<String>,
) -> Result<Json<GivenArms>, RequestFailed> {
    requester.check_role(Role::Admin)?;
    let arms = requester.app.arms()?;
    arms.wish(|reply| ArmCommand::End(name, reply)).await??;
    Ok(Json(arms.wish(ArmCommand::List).await?))
}
