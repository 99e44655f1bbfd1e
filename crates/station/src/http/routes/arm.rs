//! The laser, the pose and the dialect of the arm.

use dobot_api::problem_kinds::{
    DIALECT_NOT_FOUND, JOB_RUNNING, LOCKED, NO_LEASE, NO_LINK, OUT_OF_RANGE, POLICY, SLOT, STOPPED,
};
use dobot_api::{Reply, Request};
use dobot_wire::Dialect;
use schemars::JsonSchema;
use serde::Deserialize;

use super::{DELETE, MOVES, POST, PUT};
use crate::http::exchange::responses::{Body, Maybe, Nothing};
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::asks(
            POST,
            "/api/v1/laser",
            "Arms the laser for a while: everyone present must wear \
                goggles",
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
            "Confirms that the arm is where its statuses report, after a person has checked",
            |_: Maybe<Nothing>| Request::ConfirmPose,
        )
        .gives::<Reply>(200, "the pose is trusted")
        .problems(&[NO_LEASE, LOCKED, SLOT, NO_LINK]),
        Route::asks(
            PUT,
            "/api/v1/dialect",
            "Sets the dialect of the arm (admin)",
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
            "Detects the dialect of the arm with small slow motions",
            |_: Maybe<Nothing>| Request::Detect,
        )
        .gives::<Reply>(200, "the dialect, with the evidence")
        .problems(MOVES)
        .problems(&[DIALECT_NOT_FOUND]),
    ]
}

/// The time for which the laser is armed.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ArmLaser {
    /// The time, in seconds.
    #[schemars(range(min = 1.0, max = 3600.0))]
    for_s: f64,
}

/// The dialect of the arm.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct UseDialect {
    /// The dialect.
    dialect: Dialect,
}
