//! The fleet that the station belongs to.

use dobot_api::problem_kinds::{
    ALL_ARMS_GIVEN, ARM_BUSY, ARM_NOT_STARTED, DRAWING_PHASE, ENDING, GIVES_NO_ARMS, INVALID,
    JOURNAL, MALFORMED, NAME_TAKEN, NO_FLEET, NO_SUCH_ARM, NO_SUCH_MEMBER, NO_SUCH_WORK,
    ProblemKind, ROLE, TOO_MANY, TOO_MANY_CLIENTS, UNAUTHORISED, WORK_FILE, WORK_PHASE,
    WORK_REFUSED,
};
use dobot_api::{FleetView, GivenArm, GivenArms, JobView, MemberAnswer, WorkView};

use super::{DELETE, FLEET_STOP, GET, POST};
use crate::http::exchange::answer::{Body, JOB, Maybe, Nothing};
use crate::http::fleet_routes::members::{self, FleetRequest, FleetStop};
use crate::http::fleet_routes::offers::{self, FleetOffer};
use crate::http::fleet_routes::virtual_arms::{self, WantedVirtualArm};
use crate::http::fleet_routes::work::{self, FleetWork};
use crate::http::live::events::ServerSentEvent;
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    [stations(), work(), offers(), arms()].concat()
}

/// The stations together.
fn stations() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            "/api/v1/fleet",
            "All stations of the fleet that have been seen",
            members::fleet,
        )
        .gives::<FleetView>(200, "the fleet")
        .problems(&[NO_FLEET]),
        Route::new(
            GET,
            "/api/v1/fleet/events",
            "The stations of the fleet as server-sent events: `member`, each with a message as in `Member`; first all of \
                them, then each one that changes, ten times in a second at the most; and `gone` with the number of one that \
                is not kept in mind any more, as in `{\"id\": \"...\"}`: a virtual arm that was given and has ended, or one \
                that was replaced under its name",
            members::events,
        )
        .gives_as::<ServerSentEvent>(200, "text/event-stream", "the events")
        .problems(&[NO_FLEET, TOO_MANY_CLIENTS, ENDING]),
        Route::new(
            POST,
            FLEET_STOP,
            "Stops the arms of several stations, of all where nothing else is said; anyone may. The answer tells which \
                did not answer: their own pages stop them. A stop of all is kept by every station, and holds for those that \
                come or come back, until a person resets it",
            members::stop,
        )
        .brings::<Maybe<FleetStop>>()
        .example(r#"{"to": {"group": "room-2"}, "reason": "smoke"}"#)
        .gives::<Vec<MemberAnswer>>(200, "the answer of each")
        .problems(ASKS),
        Route::new(
            DELETE,
            FLEET_STOP,
            "Lets the whole fleet move again after a stop of all; an arm that was stopped by itself too stays stopped. A \
                station that is away learns of it when it comes back. For one arm alone: `DELETE /api/v1/stop` of its station",
            members::reset_stop,
        )
        .brings::<Maybe<Nothing>>()
        .gives::<Vec<MemberAnswer>>(200, "which stations know of it")
        .problems(&[NO_FLEET, UNAUTHORISED, ROLE, ENDING]),
        Route::new(
            POST,
            "/api/v1/fleet/requests",
            "Asks several stations for the same: method, path and body are those of their own API. The token of this \
                request goes with it, and each station looks by itself what its holder may do",
            members::request,
        )
        .brings::<Body<FleetRequest, JOB>>()
        .example(r#"{"to": {"members": ["desk-3"]}, "method": "GET", "path": "/api/v1/jobs"}"#)
        .gives::<Vec<MemberAnswer>>(200, "the answer of each")
        .problems(ASKS),
    ]
}

/// Work for any arm, where it is submitted.
fn work() -> Vec<Route> {
    vec![
        Route::new(
            POST,
            "/api/v1/fleet/work",
            "Submits a drawing or a job to any arm of the fleet that has what it needs: one that is free does it, once",
            work::submit,
        )
        .brings::<Body<FleetWork, JOB>>()
        .example(WORK_EXAMPLE)
        .keyed()
        .gives::<WorkView>(201, "it waits for an arm")
        .problems(WORKS)
        .problems(&[WORK_FILE, TOO_MANY]),
        Route::new(
            GET,
            "/api/v1/fleet/work",
            "All work that was submitted to this station for any arm, in the order in which it came",
            work::all,
        )
        .gives::<Vec<WorkView>>(200, "the work")
        .problems(WORKS),
        Route::new(
            DELETE,
            "/api/v1/fleet/work/{work}",
            "Cancels work: the station that has it lets it be, unless its arm is at it",
            work::cancel,
        )
        .gives::<WorkView>(200, "it is cancelled, or is being withdrawn")
        .problems(WORKS)
        .problems(&[NO_SUCH_WORK, WORK_PHASE]),
        Route::new(
            POST,
            "/api/v1/fleet/work/{work}/give",
            "Gives work that is in doubt or has failed to another arm. This is for a person who has looked at the first one: \
                what was drawn there may be drawn again",
            work::give,
        )
        .gives::<WorkView>(200, "it waits for another arm")
        .problems(WORKS)
        .problems(&[NO_SUCH_WORK, WORK_PHASE]),
    ]
}

/// Work that other stations offer.
fn offers() -> Vec<Route> {
    vec![
        Route::new(
            POST,
            crate::OFFERS,
            "Takes work of the fleet under a key, if no other job is queued or under way here. What is answered under a key \
                is the answer for good: the same request gets the same job, and what was refused is never done",
            offers::offer,
        )
        .brings::<Body<FleetOffer, JOB>>()
        .example(OFFER_EXAMPLE)
        .keyed()
        .gives::<JobView>(200, "it is taken: the job")
        .problems(&[ARM_BUSY, WORK_REFUSED, NO_FLEET, INVALID, MALFORMED, DRAWING_PHASE])
        .problems(&[TOO_MANY, JOURNAL, ENDING]),
        Route::new(
            GET,
            "/api/v1/fleet/offers/{key}",
            "What has become of work that was offered under a key",
            offers::look,
        )
        .gives::<JobView>(200, "it was taken: the job as it is now")
        .problems(OFFERED),
        Route::new(
            DELETE,
            "/api/v1/fleet/offers/{key}",
            "Takes an offer back: it is refused whenever it comes, and a job that has come of it ends if it has not begun",
            offers::withdraw,
        )
        .gives::<JobView>(200, "it was taken before: the job as it is now")
        .problems(OFFERED),
    ]
}

/// Virtual arms for those who have none.
fn arms() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            ARMS,
            "The virtual arms that this station gives to those without an arm",
            virtual_arms::all,
        )
        .gives::<GivenArms>(200, "the virtual arms")
        .problems(GIVES),
        Route::new(
            POST,
            ARMS,
            "Gives a virtual arm: a station of the fleet with a page of its own, which accepts the tokens of this one. Whoever \
                asks for the same name again gets the same arm, with its jobs and recordings",
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
            "Ends a virtual arm; its jobs and recordings stay for the next one of its name",
            virtual_arms::end,
        )
        .gives::<GivenArms>(200, "those that are left")
        .problems(GIVES)
        .problems(&[NO_SUCH_ARM]),
    ]
}

const ARMS: &str = "/api/v1/fleet/virtual-arms";

/// What virtual arms may be refused for.
const GIVES: &[ProblemKind] = &[GIVES_NO_ARMS, ENDING, ROLE];

const WORK_EXAMPLE: &str = r#"{"drawing": {"options": {"what": {"text": "Hello"}, "place": {"at": [210, 0], "pen_down": -40}}}, "needs": ["pen", "a5"], "student": "Anna"}"#;

const OFFER_EXAMPLE: &str = r#"{"by": "desk-1", "student": "Anna", "drawing": {"options": {"what": {"text": "Hello"}, "place": {"at": [210, 0], "pen_down": -40}}}}"#;

/// What work for any arm may be refused for.
const WORKS: &[ProblemKind] = &[NO_FLEET, INVALID, ENDING, ROLE];

/// What is answered about an offer of which no job has come.
const OFFERED: &[ProblemKind] = &[
    ARM_BUSY,
    WORK_REFUSED,
    NO_SUCH_WORK,
    MALFORMED,
    JOURNAL,
    ENDING,
];

/// What asking the fleet may be refused for.
const ASKS: &[ProblemKind] = &[NO_FLEET, NO_SUCH_MEMBER, INVALID, ENDING];
