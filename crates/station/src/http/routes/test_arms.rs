//! Virtual arms for the tests of other programs.

use axum::Json;
use axum::http::StatusCode;
use dobot_api::Role;
use dobot_api::problem_kinds::{
    ALL_ARMS_GIVEN, ARM_NOT_STARTED, BAD_FAULT, BAD_SCENE, INVALID, NO_SUCH_ARM,
};

use super::{DELETE, GET, POST};
use crate::http::exchange::requester::Requester;
use crate::http::exchange::responses::{Body, Number, RequestFailed};
use crate::http::resources::test_arms::{NewTestArm, TestArm};
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            ARMS,
            "The virtual arms that were started for tests",
            list,
        )
        .gives::<Vec<TestArm>>(200, "the virtual arms"),
        Route::new(
            POST,
            ARMS,
            "Starts a virtual arm for the test of a program, on a TCP port of its own. It ends when its client leaves, on \
                DELETE, or if nobody connects within a minute",
            start,
        )
        .brings::<Body<NewTestArm>>()
        .example(r#"{"personality": "firmware-1.1", "time_factor": "10"}"#)
        .gives::<TestArm>(201, "the virtual arm")
        .problems(&[INVALID, BAD_FAULT, BAD_SCENE, ALL_ARMS_GIVEN, ARM_NOT_STARTED]),
        Route::new(
            DELETE,
            "/api/v1/virtual-arms/{arm}",
            "Ends a virtual arm that was started for a test",
            end,
        )
        .gives::<Vec<TestArm>>(200, "the remaining virtual arms")
        .problems(&[NO_SUCH_ARM]),
    ]
}

const ARMS: &str = "/api/v1/virtual-arms";

async fn list(requester: Requester) -> Result<Json<Vec<TestArm>>, RequestFailed> {
    Ok(Json(requester.app.test_arms.list()))
}

async fn start(
    requester: Requester,
    Body(new): Body<NewTestArm>,
) -> Result<(StatusCode, Json<TestArm>), RequestFailed> {
    requester.check_role(Role::Control)?;
    let (address, _) = requester.app.listens;
    let arm = requester.app.test_arms.start(&new, address.ip()).await?;
    Ok((StatusCode::CREATED, Json(arm)))
}

async fn end(
    requester: Requester,
    Number(arm): Number,
) -> Result<Json<Vec<TestArm>>, RequestFailed> {
    requester.check_role(Role::Control)?;
    requester.app.test_arms.end(arm)?;
    Ok(Json(requester.app.test_arms.list()))
}
