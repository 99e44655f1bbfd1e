//! The laser, the pose and the dialect of the arm.

use dobot_api::problem_kinds::{
    DIALECT_NOT_FOUND, JOB_RUNNING, LOCKED, NO_LEASE, NO_LINK, OUT_OF_RANGE, POLICY, SLOT, STOPPED,
};
use dobot_api::{Reply, Request};
use dobot_wire::Dialect;
use schemars::JsonSchema;
use serde::Deserialize;

use super::{DELETE, MOVES, POST, PUT};
use crate::http::exchange::answer::{Body, Maybe, Nothing};
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::asks(
            POST,
            "/api/v1/laser",
            "Lets the laser be switched on for a while: a person has put the \
                goggles on",
            |Body(new): Body<ArmLaser>| Request::ArmLaser { for_s: new.for_s },
        )
        .example(r#"{"for_s": 600}"#)
        .gives::<Reply>(200, "the laser is armed")
        .problems(&[
            NO_LEASE,
            LOCKED,
            SLOT,
            STOPPED,
            OUT_OF_RANGE,
            POLICY,
            NO_LINK,
        ]),
        Route::asks(
            DELETE,
            "/api/v1/laser",
            "Switches the laser off and keeps it off",
            |_: Maybe<Nothing>| Request::DisarmLaser,
        )
        .gives::<Reply>(200, "the laser is disarmed")
        .problems(&[NO_LEASE, LOCKED, SLOT, NO_LINK]),
        Route::asks(
            POST,
            "/api/v1/pose/confirm",
            "The arm stands where its statuses say: a person has looked",
            |_: Maybe<Nothing>| Request::ConfirmPose,
        )
        .gives::<Reply>(200, "the pose is trusted")
        .problems(&[NO_LEASE, LOCKED, SLOT, NO_LINK]),
        Route::asks(
            PUT,
            "/api/v1/dialect",
            "Says which dialect the arm speaks (admin)",
            |Body(new): Body<UseDialect>| Request::SetDialect {
                dialect: new.dialect,
            },
        )
        .example(r#"{"dialect": "firmware-1.1"}"#)
        .gives::<Reply>(200, "the dialect is set")
        .problems(&[NO_LEASE, LOCKED, SLOT, JOB_RUNNING]),
        Route::asks(
            POST,
            "/api/v1/dialect/detect",
            "Finds out which dialect the arm speaks, by small slow motions",
            |_: Maybe<Nothing>| Request::Detect,
        )
        .gives::<Reply>(200, "what was found, and by which evidence")
        .problems(MOVES)
        .problems(&[DIALECT_NOT_FOUND]),
    ]
}

/// For how long the laser may be switched on.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ArmLaser {
    /// In seconds.
    #[schemars(range(min = 1.0, max = 3600.0))]
    for_s: f64,
}

/// Which dialect the arm speaks.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct UseDialect {
    /// The dialect.
    dialect: Dialect,
}
