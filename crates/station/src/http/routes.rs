//! The table of all routes, from which router and document are generated.
//!
//! Each request is a row, with its body type next to it: see `docs/recipes.md`, "Add a request".

mod addresses;
mod agents;
mod arm;
mod calibration;
mod custom_buttons;
mod drawings;
mod extras;
mod files;
mod fleet;
mod jobs;
mod learners;
mod leases;
mod motion;
mod observing;
mod programs;
mod recordings;
mod talk;
mod test_arms;
mod tokens;
mod virtual_arm;
mod watching;

use std::sync::{Arc, LazyLock};

use axum::Router;
use axum::http::Method;
use axum::middleware::from_fn_with_state;
use dobot_api::problem_kinds::{
    CANNOT_RESUME, COMMAND, DETECTING, JOB_RUNNING, LASER_DISARMED, LOCKED, NO_JOB_RUNS, NO_LEASE,
    NO_LINK, NO_VECTORS, OUT_OF_RANGE, POLICY, ProblemKind, SLOT, STILL_MOVING, STOPPED, TOO_MANY,
};

use crate::http::app::App;
use crate::http::route::Route;
use crate::http::{access::auth, exchange::requester, resources::page};

/// Returns the router.
pub(super) fn router(app: Arc<App>) -> Router {
    let all = ROUTES.iter().fold(Router::new(), |router, route| {
        router.route(route.path, route.handler())
    });
    all.method_not_allowed_fallback(requester::method)
        .fallback(requester::unknown_path)
        .layer(from_fn_with_state(app.clone(), auth::pass))
        .with_state(app)
}

/// Whether a route is public, even without a token.
pub(super) fn is_open(method: &Method, path: &str) -> bool {
    let same =
        |route: &&Route| route.path == path && (route.method == *method || method == Method::HEAD);
    ROUTES.iter().find(same).is_some_and(|route| route.open)
}

/// The stop of the arm.
pub(super) const STOP: &str = "/api/v1/stop";
/// The stop of the fleet's arms.
const FLEET_STOP: &str = "/api/v1/fleet/stop";
/// Requests that are exempt from the rate limit.
pub(super) const STOPS: [&str; 2] = [STOP, FLEET_STOP];

/// All routes.
pub(super) static ROUTES: LazyLock<Vec<Route>> = LazyLock::new(|| {
    [
        page::all(),
        watching::all(),
        observing::all(),
        motion::all(),
        leases::all(),
        learners::all(),
        arm::all(),
        calibration::all(),
        jobs::all(),
        programs::all(),
        custom_buttons::all(),
        talk::all(),
        recordings::all(),
        drawings::all(),
        files::all(),
        extras::all(),
        tokens::all(),
        addresses::all(),
        virtual_arm::all(),
        test_arms::all(),
        fleet::all(),
        agents::all(),
    ]
    .concat()
});

const GET: Method = Method::GET;
const POST: Method = Method::POST;
const PUT: Method = Method::PUT;
const DELETE: Method = Method::DELETE;

/// The problems of requests that move the arm.
const MOVES: &[ProblemKind] = &[
    NO_LEASE,
    LOCKED,
    SLOT,
    STOPPED,
    STILL_MOVING,
    LASER_DISARMED,
    JOB_RUNNING,
    DETECTING,
    COMMAND,
    POLICY,
    OUT_OF_RANGE,
    TOO_MANY,
    NO_LINK,
];

/// The problems of requests that change a running job.
const ADJUSTS: &[ProblemKind] = &[
    NO_LEASE,
    LOCKED,
    SLOT,
    NO_JOB_RUNS,
    STILL_MOVING,
    NO_VECTORS,
    CANNOT_RESUME,
    OUT_OF_RANGE,
];
