//! The fleet of the station.

use dobot_api::problem_kinds::{
    ALL_ARMS_GIVEN, ARM_BUSY, ARM_NOT_STARTED, DRAWING_PHASE, ENDING, GIVES_NO_ARMS, INVALID,
    JOURNAL, MALFORMED, NAME_TAKEN, NO_FLEET, NO_SUCH_ARM, NO_SUCH_MEMBER, NO_SUCH_WORK,
    ProblemKind, ROLE, TOO_MANY, TOO_MANY_CLIENTS, UNAUTHORISED, WORK_FILE, WORK_PHASE,
    WORK_REFUSED,
};
use dobot_api::{FleetView, GivenArm, GivenArms, JobView, MemberAnswer, WorkView};

use super::{DELETE, FLEET_STOP, GET, POST};
use crate::http::exchange::responses::{Body, JOB, Maybe, Nothing};
use crate::http::fleet_routes::members::{self, FleetRequest, FleetStop};
use crate::http::fleet_routes::offers::{self, FleetOffer};
use crate::http::fleet_routes::virtual_arms::{self, WantedVirtualArm};
use crate::http::fleet_routes::work::{self, FleetWork};
use crate::http::live::events::ServerSentEvent;
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    [stations(), work(), offers(), arms()].concat()
}

/// Routes for the members.
fn stations() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            "/api/v1/fleet",
            "All known stations of the fleet",
            members::fleet,
        )
        .gives::<FleetView>(200, "the fleet")
        .problems(&[NO_FLEET]),
        Route::new(
            GET,
            "/api/v1/fleet/events",
            "The stations of the fleet as server-sent events: `member`, each with a message as in `Member`, first for all \
                stations, then for each change, at most ten times per second; and `gone` with the id of a station \
                that is not listed any more, as in `{\"id\": \"...\"}`: a hosted virtual arm that has ended, or a station \
                that was replaced under its name",
            members::events,
        )
        .gives_as::<ServerSentEvent>(200, "text/event-stream", "the events")
        .problems(&[NO_FLEET, TOO_MANY_CLIENTS, ENDING]),
        Route::new(
            POST,
            FLEET_STOP,
            "Stops the arms of several stations, by default of all; anyone may. The response shows which \
                did not respond: stop those on their own pages. A stop of all is kept by every station, and applies to those that \
                join or return, until a person resets it",
            members::stop,
        )
        .brings::<Maybe<FleetStop>>()
        .example(r#"{"to": {"group": "room-2"}, "reason": "smoke"}"#)
        .gives::<Vec<MemberAnswer>>(200, "the response of each")
        .problems(ASKS),
        Route::new(
            DELETE,
            FLEET_STOP,
            "Resets a stop of all stations; an arm that was also stopped individually stays stopped. A \
                station that is away learns of it when it returns. For one arm only: `DELETE /api/v1/stop` of its station",
            members::reset_stop,
        )
        .brings::<Maybe<Nothing>>()
        .gives::<Vec<MemberAnswer>>(200, "the response of each")
        .problems(&[NO_FLEET, UNAUTHORISED, ROLE, ENDING]),
        Route::new(
            POST,
            "/api/v1/fleet/requests",
            "Sends a request to several stations: method, path and body are those of their own API. The token of this \
                request is used, and each station checks its role",
            members::request,
        )
        .brings::<Body<FleetRequest, JOB>>()
        .example(r#"{"to": {"members": ["desk-3"]}, "method": "GET", "path": "/api/v1/jobs"}"#)
        .gives::<Vec<MemberAnswer>>(200, "the response of each")
        .problems(ASKS),
    ]
}

/// Routes for jobs for any arm, at the station to which they are submitted.
fn work() -> Vec<Route> {
    vec![
        Route::new(
            POST,
            "/api/v1/fleet/work",
            "Submits a drawing or a job to any arm of the fleet with the required features: a free one runs it, once",
            work::submit,
        )
        .brings::<Body<FleetWork, JOB>>()
        .example(WORK_EXAMPLE)
        .keyed()
        .gives::<WorkView>(201, "the job waits for an arm")
        .problems(WORKS)
        .problems(&[WORK_FILE, TOO_MANY]),
        Route::new(
            GET,
            "/api/v1/fleet/work",
            "All jobs for any arm that were submitted to this station, in order",
            work::all,
        )
        .gives::<Vec<WorkView>>(200, "the work")
        .problems(WORKS),
        Route::new(
            DELETE,
            "/api/v1/fleet/work/{work}",
            "Cancels a job for any arm, unless the arm has begun it",
            work::cancel,
        )
        .gives::<WorkView>(200, "the job is cancelled, or is being withdrawn")
        .problems(WORKS)
        .problems(&[NO_SUCH_WORK, WORK_PHASE]),
        Route::new(
            POST,
            "/api/v1/fleet/work/{work}/give",
            "Moves a job that is in doubt or has failed to another arm. A person must have checked the first one: \
                parts that were drawn there may be drawn again",
            work::give,
        )
        .gives::<WorkView>(200, "the job waits for another arm")
        .problems(WORKS)
        .problems(&[NO_SUCH_WORK, WORK_PHASE]),
    ]
}

/// Routes for offers of other stations.
fn offers() -> Vec<Route> {
    vec![
        Route::new(
            POST,
            crate::OFFERS,
            "Accepts a job of the fleet under a key, if no other job is queued or running here. The response to a key \
                is final: a repeated request returns the same job, and a refused one never runs",
            offers::offer,
        )
        .brings::<Body<FleetOffer, JOB>>()
        .example(OFFER_EXAMPLE)
        .keyed()
        .gives::<JobView>(200, "the accepted job")
        .problems(&[ARM_BUSY, WORK_REFUSED, NO_FLEET, INVALID, MALFORMED, DRAWING_PHASE])
        .problems(&[TOO_MANY, JOURNAL, ENDING]),
        Route::new(
            GET,
            "/api/v1/fleet/offers/{key}",
            "The state of a job that was offered under a key",
            offers::look,
        )
        .gives::<JobView>(200, "the accepted job in its current state")
        .problems(OFFERED),
        Route::new(
            DELETE,
            "/api/v1/fleet/offers/{key}",
            "Withdraws an offer: it is refused even if it arrives later, and its job ends if it has not begun",
            offers::withdraw,
        )
        .gives::<JobView>(200, "the accepted job in its current state")
        .problems(OFFERED),
    ]
}

/// Routes for virtual arms for members without an arm.
fn arms() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            ARMS,
            "The virtual arms that this station hosts",
            virtual_arms::all,
        )
        .gives::<GivenArms>(200, "the virtual arms")
        .problems(GIVES),
        Route::new(
            POST,
            ARMS,
            "Starts a virtual arm: a station of the fleet with its own page, which accepts the tokens of this one. A repeated \
                request for the same name returns the same arm, with its jobs and recordings",
            virtual_arms::give,
        )
        .brings::<Body<WantedVirtualArm, JOB>>()
        .example(r#"{"name": "anna"}"#)
        .gives::<GivenArm>(200, "the virtual arm")
        .problems(GIVES)
        .problems(&[NO_FLEET, INVALID, NAME_TAKEN, ALL_ARMS_GIVEN, ARM_NOT_STARTED]),
        Route::new(
            DELETE,
            "/api/v1/fleet/virtual-arms/{name}",
            "Ends a virtual arm; its jobs and recordings are kept for the next one of its name",
            virtual_arms::end,
        )
        .gives::<GivenArms>(200, "the remaining virtual arms")
        .problems(GIVES)
        .problems(&[NO_SUCH_ARM]),
    ]
}

const ARMS: &str = "/api/v1/fleet/virtual-arms";

/// The problems of requests for virtual arms.
const GIVES: &[ProblemKind] = &[GIVES_NO_ARMS, ENDING, ROLE];

const WORK_EXAMPLE: &str = r#"{"drawing": {"options": {"what": {"text": "Hello"}, "place": {"at": [210, 0], "pen_down": -40}}}, "needs": ["pen", "a5"], "student": "Anna"}"#;

const OFFER_EXAMPLE: &str = r#"{"by": "desk-1", "student": "Anna", "drawing": {"options": {"what": {"text": "Hello"}, "place": {"at": [210, 0], "pen_down": -40}}}}"#;

/// The problems of requests for jobs for any arm.
const WORKS: &[ProblemKind] = &[NO_FLEET, INVALID, ENDING, ROLE];

/// The problems of an offer without a job.
const OFFERED: &[ProblemKind] = &[
    ARM_BUSY,
    WORK_REFUSED,
    NO_SUCH_WORK,
    MALFORMED,
    JOURNAL,
    ENDING,
];

/// The problems of requests to the fleet.
const ASKS: &[ProblemKind] = &[NO_FLEET, NO_SUCH_MEMBER, INVALID, ENDING];
