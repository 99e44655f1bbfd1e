//! Virtual arms for those of the fleet who have none.

use axum::Json;
use axum::extract::Path;
use dobot_api::problem_kinds::INVALID;
use dobot_api::{GivenArm, GivenArms, Role, is_fleet_name};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::http::exchange::answer::{Body, JOB, NotDone};
use crate::http::exchange::requester::Asker;
use crate::http::fleet_routes::members::not_a_name;
use crate::{ArmSelection, ArmWish};

/// A virtual arm that is wanted.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct WantedVirtualArm {
    /// What it is to be called in the fleet: 1 to 40 small letters of English, digits and hyphens, the first one a letter.
    name: String,
}

/// Those that are given.
pub(crate) async fn all(asker: Asker) -> Result<Json<GivenArms>, NotDone> {
    Ok(Json(asker.app.arms()?.wish(ArmWish::List).await?))
}

/// Gives one; whoever asks again for the same name gets the same.
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
    let wanted = ArmSelection { name, seen };
    let given = arms.wish(|reply| ArmWish::Give(wanted, reply)).await?;
    Ok(Json(given?))
}

/// Ends one.
pub(crate) async fn end(
    asker: Asker,
    Path(name): Path<String>,
) -> Result<Json<GivenArms>, NotDone> {
    asker.check_role(Role::Admin)?;
    let arms = asker.app.arms()?;
    arms.wish(|reply| ArmWish::End(name, reply)).await??;
    Ok(Json(arms.wish(ArmWish::List).await?))
}
