//! The table of all routes: router and document both come from it.

use std::sync::{Arc, LazyLock};

use axum::Router;
use axum::http::Method;
use axum::middleware::from_fn_with_state;
use axum::routing::{MethodRouter, delete, get, post, put};

use dobot_api::{JobView, NewJob, Notice, Reply, State};
use dobot_safety::Policy;

use super::answer::JOB;
use super::app::App;
use super::bodies::{
    Arming, Granted, Height, Heir, NewCommand, NewStop, Nothing, Press, Speech, Speed, Wish,
};
use super::kinds::{
    BAD_JOB, CANNOT_RESUME, COMMAND, DETECTING, DIALECT_NOT_FOUND, ENDING, JOB_PHASE, JOB_RUNNING,
    JOURNAL, Kind, LASER_DISARMED, MALFORMED, NO_JOB_RUNS, NO_LEASE, NO_LINK, NO_SUCH_JOB,
    NO_VECTORS, NOT_ASKING, NOT_REACHED, OUT_OF_RANGE, POLICY, STILL_MOVING, STOPPED, TOO_MANY,
    TOO_MANY_CLIENTS, UNKNOWN_PATH, UPGRADE,
};
use super::route::Route;
use super::{calls, gate, page, socket};

/// The router with everything.
pub(super) fn router(app: Arc<App>) -> Router {
    let all = ROUTES.iter().fold(Router::new(), |router, route| {
        router.route(route.path, (route.handler)())
    });
    all.method_not_allowed_fallback(calls::method)
        .fallback(calls::unknown_path)
        .layer(from_fn_with_state(app.clone(), gate::pass))
        .with_state(app)
}

/// Whether a route is for everyone, even without a token.
pub(super) fn is_open(method: &Method, path: &str) -> bool {
    let same =
        |route: &&Route| route.path == path && (route.method == *method || method == Method::HEAD);
    ROUTES.iter().find(same).is_some_and(|route| route.open)
}

/// Where the arm is stopped.
pub(super) const STOP: &str = "/api/v1/stop";

/// All routes.
pub(super) static ROUTES: LazyLock<Vec<Route>> = LazyLock::new(|| {
    [
        page_routes(),
        watch_routes(),
        motion_routes(),
        lease_routes(),
        arm_routes(),
        job_routes(),
    ]
    .concat()
});

const GET: Method = Method::GET;
const POST: Method = Method::POST;
const PUT: Method = Method::PUT;
const DELETE: Method = Method::DELETE;

/// What moving the arm may be refused for.
const MOVES: &[Kind] = &[
    NO_LEASE,
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

/// What changing a job while it runs may be refused for.
const ADJUSTS: &[Kind] = &[
    NO_LEASE,
    NO_JOB_RUNS,
    STILL_MOVING,
    NO_VECTORS,
    CANNOT_RESUME,
    OUT_OF_RANGE,
];

fn page_routes() -> Vec<Route> {
    vec![
        Route::new(GET, "/", "A page to watch and move the arm", || {
            get(page::html)
        })
        .open()
        .gives_text(200, "text/html", "the page"),
        Route::new(GET, "/page.css", "How the page looks", || get(page::css))
            .open()
            .gives_text(200, "text/css", "the style"),
        script("/page.js", "What the page does", || get(page::js)),
        script("/preview.js", "Shows a drawing in time", || {
            get(page::preview)
        }),
        script("/timeline.js", "What is at a moment of a drawing", || {
            get(page::timeline)
        }),
        script("/reader.js", "Reads the timeline of a drawing", || {
            get(page::reader)
        }),
        script("/look.js", "How a drawing in time looks", || {
            get(page::look)
        }),
        script("/sketch.js", "Draws a drawing in time", || {
            get(page::sketch)
        }),
        Route::new(GET, "/api/v1/openapi.json", "This document", || {
            get(calls::document)
        })
        .open()
        .gives::<serde_json::Value>(200, "this document"),
        Route::new(
            GET,
            "/api/v1/problems/{kind}",
            "Explains a kind of problem",
            || get(calls::problem),
        )
        .open()
        .gives::<Kind>(200, "the kind")
        .problems(&[UNKNOWN_PATH]),
    ]
}

/// A part of the page; browsers refuse it as a module unless it says that it is one.
fn script(
    path: &'static str,
    summary: &'static str,
    handler: fn() -> MethodRouter<Arc<App>>,
) -> Route {
    Route::new(GET, path, summary, handler)
        .open()
        .gives_text(200, "text/javascript", "the module")
}

fn watch_routes() -> Vec<Route> {
    vec![
        Route::new(GET, "/api/v1/state", "What the station knows now", || get(calls::state))
            .gives::<State>(200, "the state"),
        Route::new(GET, "/api/v1/notices", "What happened lately, the oldest first", || get(calls::notices))
            .gives::<Vec<Notice>>(200, "the notices"),
        Route::new(GET, "/api/v1/policy", "The safety policy, as `dobot policy` shows it", || get(calls::policy))
            .gives::<Policy>(200, "the policy"),
        Route::new(
            GET,
            "/api/v1/ws",
            "A WebSocket for states, notices and requests. The station sends messages as in `ToClient`, the client as in `FromClient`, both as text. The lease of the client ends with the connection. A browser, which cannot send headers, offers the subprotocols `dobot` and `dobot.token.<token>`.",
            || get(socket::upgrade),
        )
        .queries(socket::QUERIES)
        .gives_text(101, "text/plain", "the protocol changes to WebSocket")
        .problems(&[MALFORMED, UPGRADE, TOO_MANY_CLIENTS, ENDING]),
    ]
}

fn motion_routes() -> Vec<Route> {
    vec![
        Route::new(POST, "/api/v1/commands", "Sends one command, if the policy allows its whole way", || post(calls::command))
            .asks()
            .takes::<NewCommand>(
                r#"{"command": {"type": "move_to", "x_mm": 200, "y_mm": 0, "z_mm": 50, "rotation_deg": 0, "suction": false, "mode": "jump", "gripper_deg": 0, "pause_s": 0}, "wait": true}"#,
            )
            .gives::<Reply>(200, "the arm is where the command leads (with `wait`)")
            .gives::<Reply>(202, "the command waits for its turn")
            .problems(MOVES)
            .problems(&[NOT_REACHED]),
        Route::new(POST, "/api/v1/jog", "Holds a jog button; it is released when this is not said again within the dead-man time (150 ms by default)", || post(calls::jog))
            .asks()
            .takes::<Press>(r#"{"jog": {"frame": "linear", "axis": "x_plus", "speed_percent": 50}}"#)
            .gives::<Reply>(200, "the button is held")
            .problems(MOVES),
        Route::new(POST, "/api/v1/jog/release", "Releases the jog button", || post(calls::release_jog))
            .asks()
            .may_take::<Nothing>("{}")
            .gives::<Reply>(200, "the button is released")
            .problems(&[NO_LEASE]),
        Route::new(POST, STOP, "Stops the arm. Anyone may, at any time, without a lease", || post(calls::stop))
            .asks()
            .may_take::<NewStop>(r#"{"reason": "a hand is in the way"}"#)
            .gives::<Reply>(200, "the stopping packet is on its way")
            .problems(&[OUT_OF_RANGE, NO_LINK]),
        Route::new(DELETE, STOP, "Lets the arm move again after a stop: a person has looked at it", || delete(calls::reset_stop))
            .asks()
            .may_take::<Nothing>("{}")
            .gives::<Reply>(200, "the arm may move")
            .problems(&[STILL_MOVING, NO_LINK]),
    ]
}

fn lease_routes() -> Vec<Route> {
    vec![
        Route::new(
            POST,
            "/api/v1/lease",
            "Takes control, if nobody has it; with a lease token it renews the lease",
            || post(calls::take_lease),
        )
        .asks()
        .may_take::<Wish>(r#"{"name": "my script"}"#)
        .gives::<Granted>(200, "control")
        .problems(&[NO_LEASE, TOO_MANY_CLIENTS]),
        Route::new(DELETE, "/api/v1/lease", "Gives control back", || {
            delete(calls::release_lease)
        })
        .asks()
        .may_take::<Nothing>("{}")
        .gives::<Reply>(200, "control is free")
        .problems(&[NO_LEASE]),
        Route::new(
            POST,
            "/api/v1/lease/ask",
            "Asks the holder for control; the state tells when it is granted",
            || post(calls::ask_lease),
        )
        .asks()
        .may_take::<Wish>(r#"{"name": "my script"}"#)
        .gives::<Granted>(200, "a lease token, for when control is granted")
        .problems(&[TOO_MANY_CLIENTS]),
        Route::new(
            POST,
            "/api/v1/lease/grant",
            "Gives control to one who asked",
            || post(calls::grant_lease),
        )
        .asks()
        .takes::<Heir>(r#"{"to": 3}"#)
        .gives::<Reply>(200, "who has control now")
        .problems(&[NO_LEASE, NOT_ASKING]),
        Route::new(
            POST,
            "/api/v1/lease/seize",
            "Takes control from whoever has it (admin)",
            || post(calls::seize_lease),
        )
        .asks()
        .may_take::<Wish>(r#"{"name": "my script"}"#)
        .gives::<Granted>(200, "control")
        .problems(&[TOO_MANY_CLIENTS]),
    ]
}

fn arm_routes() -> Vec<Route> {
    vec![
        Route::new(
            POST,
            "/api/v1/laser",
            "Lets the laser be switched on for a while: a person has put the goggles on",
            || post(calls::arm_laser),
        )
        .asks()
        .takes::<Arming>(r#"{"for_s": 600}"#)
        .gives::<Reply>(200, "the laser is armed")
        .problems(&[NO_LEASE, STOPPED, OUT_OF_RANGE, POLICY, NO_LINK]),
        Route::new(
            DELETE,
            "/api/v1/laser",
            "Switches the laser off and keeps it off",
            || delete(calls::disarm_laser),
        )
        .asks()
        .may_take::<Nothing>("{}")
        .gives::<Reply>(200, "the laser is disarmed")
        .problems(&[NO_LEASE, NO_LINK]),
        Route::new(
            POST,
            "/api/v1/pose/confirm",
            "The arm stands where its statuses say: a person has looked",
            || post(calls::confirm_pose),
        )
        .asks()
        .may_take::<Nothing>("{}")
        .gives::<Reply>(200, "the pose is trusted")
        .problems(&[NO_LEASE, NO_LINK]),
        Route::new(
            PUT,
            "/api/v1/dialect",
            "Says which dialect the arm speaks (admin)",
            || put(calls::set_dialect),
        )
        .asks()
        .takes::<Speech>(r#"{"dialect": "firmware-1.1"}"#)
        .gives::<Reply>(200, "the dialect is set")
        .problems(&[NO_LEASE, JOB_RUNNING]),
        Route::new(
            POST,
            "/api/v1/dialect/detect",
            "Finds out which dialect the arm speaks, by small slow motions",
            || post(calls::detect),
        )
        .asks()
        .may_take::<Nothing>("{}")
        .gives::<Reply>(200, "what was found, and by which evidence")
        .problems(MOVES)
        .problems(&[DIALECT_NOT_FOUND]),
    ]
}

fn job_routes() -> Vec<Route> {
    vec![
        Route::new(GET, "/api/v1/jobs", "All jobs, the oldest first", || get(calls::jobs))
            .gives::<Vec<JobView>>(200, "the jobs")
            .problems(&[ENDING]),
        Route::new(POST, "/api/v1/jobs", "Queues a job", || post(calls::submit_job))
            .asks()
            .body::<NewJob>(
                r#"{"title": "there and back", "kind": "program", "commands": [{"type": "move_to", "x_mm": 200, "y_mm": 0, "z_mm": 50, "rotation_deg": 0, "suction": false, "mode": "jump", "gripper_deg": 0, "pause_s": 0}]}"#,
                true,
                JOB,
            )
            .gives::<Reply>(201, "the job is queued")
            .problems(&[BAD_JOB, POLICY, COMMAND, OUT_OF_RANGE, TOO_MANY, JOURNAL]),
        Route::new(GET, "/api/v1/jobs/{id}", "One job", || get(calls::job))
            .gives::<JobView>(200, "the job")
            .problems(&[MALFORMED, NO_SUCH_JOB, ENDING]),
        Route::new(DELETE, "/api/v1/jobs/{id}", "Ends a job for good", || delete(calls::cancel_job))
            .asks()
            .may_take::<Nothing>("{}")
            .gives::<Reply>(200, "the job is over")
            .problems(&[NO_LEASE, NO_SUCH_JOB, JOB_PHASE, JOURNAL]),
        Route::new(POST, "/api/v1/jobs/{id}/start", "Starts a queued job, or goes on with a paused one", || post(calls::start_job))
            .asks()
            .may_take::<Nothing>("{}")
            .gives::<Reply>(200, "the job runs")
            .problems(MOVES)
            .problems(&[NO_SUCH_JOB, JOB_PHASE, BAD_JOB, CANNOT_RESUME, JOURNAL]),
        Route::new(POST, "/api/v1/jobs/pause", "Pauses the running job after what the arm has got already", || post(calls::pause_job))
            .asks()
            .may_take::<Nothing>("{}")
            .gives::<Reply>(200, "the job is paused")
            .problems(&[NO_LEASE, NO_JOB_RUNS, JOURNAL]),
        Route::new(PUT, "/api/v1/jobs/speed", "Draws the vectors of the job faster or slower than planned, from the next one on that is not sent yet", || put(calls::set_job_speed))
            .asks()
            .takes::<Speed>(r#"{"percent": 80}"#)
            .gives::<Reply>(200, "the job goes at this speed")
            .problems(ADJUSTS),
        Route::new(PUT, "/api/v1/jobs/height", "Draws the job higher or lower than planned, gently, from the next command on that is not sent yet", || put(calls::set_job_height))
            .asks()
            .takes::<Height>(r#"{"offset_mm": 0.2}"#)
            .gives::<Reply>(200, "the job is drawn at this height")
            .problems(ADJUSTS)
            .problems(&[POLICY]),
    ]
}
