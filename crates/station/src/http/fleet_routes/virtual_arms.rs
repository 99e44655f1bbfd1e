//! Virtual arms for members of the fleet without an arm.

use axum::Json;
use axum::extract::Path;
use dobot_api::problem_kinds::INVALID;
use dobot_api::{GivenArm, GivenArms, Role, is_fleet_name};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::http::exchange::requester::Asker;
use crate::http::exchange::responses::{Body, JOB, NotDone};
use crate::http::fleet_routes::members::not_a_name;
use crate::{ArmCommand, WantedArm};

/// A request for a virtual arm.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct WantedVirtualArm {
    /// Its name in the fleet: 1 to 40 lowercase letters a to z, digits and hyphens, beginning with
    /// a letter.
    name: String,
}

/// Lists the hosted arms.
pub(crate) async fn all(asker: Asker) -> Result<Json<GivenArms>, NotDone> {
    Ok(Json(asker.app.arms()?.wish(ArmCommand::List).await?))
}

/// Starts an arm; repeated requests for the same name return the same arm.
pub(crate) async fn give(
    asker: Asker,
    Body(wanted): Body<WantedVirtualArm, JOB>,
) -> Result<Json<GivenArm>, NotDone> {
    asker.check_role(Role::Control)?;
    let WantedVirtualArm { name } = wanted;
    if !is_fleet_name(&name) {
        return Err(INVALID.problem(not_a_name("name", &name, "anna")).into());
    }
    let arms = asker.app.arms()?;
    let seen = asker.app.fleet()?.member(&name);
    let wanted = WantedArm { name, seen };
    let given = arms.wish(|reply| ArmCommand::Give(wanted, reply)).await?;
    Ok(Json(given?))
}

/// Ends an arm.
pub(crate) async fn end(
    asker: Asker,
    Path(name): Path<String>,
) -> Result<Json<GivenArms>, NotDone> {
    asker.check_role(Role::Admin)?;
    let arms = asker.app.arms()?;
    arms.wish(|reply| ArmCommand::End(name, reply)).await??;
    Ok(Json(arms.wish(ArmCommand::List).await?))
}
