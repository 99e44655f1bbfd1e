//! The problem types, each with title, status and explanation, as served by
//! `/api/v1/problems/{kind}`.

use schemars::JsonSchema;
use serde::Serialize;

use crate::Problem;

/// A problem type with its explanation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ProblemKind {
    /// The name: the last part of the problem type's URL.
    #[serde(rename = "kind")]
    pub name: &'static str,
    /// The problem in words.
    pub title: &'static str,
    /// The HTTP status.
    pub status: u16,
    /// The meaning and the remedy.
    pub explanation: &'static str,
}

impl ProblemKind {
    /// Builds a problem of this type.
    #[must_use]
    pub fn problem(self, detail: impl Into<String>) -> Problem {
        Problem {
            kind: format!("/api/v1/problems/{}", self.name),
            title: self.title.to_owned(),
            status: self.status,
            detail: detail.into(),
            hint: None,
            rule: None,
            at_mm: None,
            nearest_mm: None,
        }
    }

    /// Builds a problem of this type with a hint.
    #[must_use]
    pub fn hinted(self, detail: impl Into<String>, hint: impl Into<String>) -> Problem {
        Problem {
            hint: Some(hint.into()),
            ..self.problem(detail)
        }
    }
}

/// Returns the problem type of this name.
#[must_use]
pub fn named(name: &str) -> Option<&'static ProblemKind> {
    ALL.iter().find(|kind| kind.name == name)
}

macro_rules! kinds {
    ($($constant:ident = $status:literal $name:literal $title:literal $explanation:literal;)*) => {
        $(
            #[doc = $title]
            pub const $constant: ProblemKind = ProblemKind {
                name: $name,
                title: $title,
                status: $status,
                explanation: $explanation,
            };
        )*

        /// All problem types.
        pub const ALL: &[ProblemKind] = &[$($constant),*];
    };
}

kinds! {
    MALFORMED = 400 "malformed" "the request cannot be understood"
        "The body is not JSON, or an address or a header is not as it has to be. The detail says at which line and column.";
    UNAUTHORISED = 401 "unauthorised" "this takes a token"
        "The station does not know who asks. Send a token as `Authorization: Bearer <token>`; a WebSocket of a browser offers the subprotocol `dobot.token.<token>`. Tokens are made on the station's machine, and a wrong one is refused even where none is needed.";
    ROLE = 403 "role" "the role does not allow this"
        "Tokens come with a role: watch sees everything and may stop the arm, queue may also queue jobs that a person starts, control may move it, admin may also choose the dialect and take control from somebody.";
    FORBIDDEN_HOST = 403 "forbidden-host" "the station does not go by this name"
        "The Host header is not a name or address of this station. That protects from pages that let their own name lead to your machine. Use the address that the station printed, or tell the station its name.";
    FORBIDDEN_ORIGIN = 403 "forbidden-origin" "another site's page may not do this"
        "A browser says that a page of another site sends this request. Only the station's own page may.";
    UNKNOWN_PATH = 404 "unknown-path" "there is nothing at this address"
        "No route of the station has this path. `/api/v1/openapi.json` lists all of them.";
    NO_SUCH_JOB = 404 "no-such-job" "there is no such job"
        "No job has this number. `/api/v1/jobs` lists all of them.";
    NO_SUCH_DRAWING = 404 "no-such-drawing" "there is no such drawing"
        "No drawing has this number: it was given up, or later ones have taken its place. Plan it again.";
    NO_SUCH_RECORDING = 404 "no-such-recording" "there is no such recording"
        "No recording has this name; the oldest are deleted when there are too many. `/api/v1/recordings` lists all of them.";
    NO_SUCH_TOKEN = 404 "no-such-token" "there is no such token"
        "No token has this name. `/api/v1/tokens` lists all of them.";
    NO_FLEET = 404 "no-fleet" "this station belongs to no fleet"
        "A station joins a fleet when it is started with `dobot up --fleet`.";
    NO_SUCH_MEMBER = 404 "no-such-member" "the fleet has no such station"
        "No station of this name, or none of this group, has been seen. `/api/v1/fleet` lists all of them.";
    NO_SUCH_WORK = 404 "no-such-work" "there is no such work"
        "This station has no work of this number for its fleet, or was offered none under this key. `GET /api/v1/fleet/work` lists what was submitted here.";
    NO_SUCH_ARM = 404 "no-such-arm" "there is no such virtual arm"
        "This station gives no virtual arm of this name now. `GET /api/v1/fleet/virtual-arms` lists those that it gives.";
    NOT_BUILT = 404 "not-built" "the station is built without this"
        "Parts that few people use are in the released archives and in builds with the feature `full`. The detail says which part this station lacks.";
    METHOD = 405 "method" "this address does not take this method"
        "The path exists, but not with this method. The Allow header lists those that it takes.";
    TIMEOUT = 408 "timeout" "the request came too slowly"
        "The body was not there in time. Nothing has changed.";
    WORK_REFUSED = 409 "work-refused" "the station does not take this work"
        "No job has come of the offer, and none will under its key: the work can be offered to another station. The detail says why.";
    ARM_BUSY = 409 "arm-busy" "the arm has other work"
        "The arm has a job that is not over. No job has come of the offer, and none will under its key: it can be offered again under another one.";
    GIVES_NO_ARMS = 409 "gives-no-arms" "this station gives no virtual arms"
        "A station gives virtual arms to those without one when it is started with `dobot up --virtual --fleet --virtual-arms N`. The members of the fleet tell which do.";
    NAME_TAKEN = 409 "name-taken" "another station has this name"
        "A station of the fleet has been seen that is called so. Two of one name would be asked for nothing: take another name.";
    ALL_ARMS_GIVEN = 409 "all-arms-given" "all virtual arms are given"
        "The station gives no more virtual arms at a time. One ends by itself when nobody has looked at it for a while, and an administrator can end one.";
    WORK_PHASE = 409 "work-phase" "this cannot be done with it now"
        "What can be done with work for any arm depends on how far it is. The detail says how far it is, and what is allowed.";
    TOKEN_TAKEN = 409 "token-taken" "another token has this name"
        "Remove the other token first, or take another name.";
    NOT_VIRTUAL = 409 "not-virtual" "the arm is no virtual one of this station"
        "World and faults are those of the virtual arm that a station has of its own: `dobot up --virtual`.";
    NO_LEASE = 409 "no-lease" "this client does not have control"
        "One client at a time has control of the arm. Take the lease with `POST /api/v1/lease`; if somebody has it, ask for it. Stopping takes no lease.";
    LEASE_GONE = 409 "lease-gone" "the lease token is not valid any more"
        "A lease that was taken over plain HTTP ends when its token is not used for ten seconds. Take it again.";
    LOCKED = 409 "locked" "the arm is locked"
        "An administrator keeps the arm for himself, as a teacher does who wants to be listened to. The detail says who, and why. Stopping takes no control.";
    SLOT = 409 "slot" "it is the time of somebody else"
        "The arm has time slots, and one of another student is under way: only that student and administrators have control meanwhile. The detail says whose it is, for how long, and when the arm is free. Stopping takes no control.";
    NOT_ASKING = 409 "not-asking" "nobody asks for control"
        "Control can be given only to a client that asks for it; the state lists those that do.";
    STOPPED = 409 "stopped" "the arm is stopped"
        "Somebody stopped the arm, and it stays so until a person has looked at it and resets the stop with `DELETE /api/v1/stop`.";
    STILL_MOVING = 409 "still-moving" "the arm still moves"
        "The arm has not come to rest yet after a stop. The detail says how long that takes at the most.";
    LET_GO = 409 "let-go" "the button was let go"
        "The station let go of a button that its client still says: the client fell silent for a while, or the arm was stopped. Release the button, then press it again.";
    NOT_DELIVERED = 503 "not-delivered" "it could not be sent to the arm"
        "There is no link to the arm, so what stops it or switches its laser off has not left this computer. It is sent as soon as the link is back; until then the arm goes on. Switch it off by hand.";
    UNGUARDED = 503 "unguarded" "no watchdog watches over the arm"
        "The process that stops the arm when the station is killed is gone, and the system starts no other one. The station tries again every few seconds; until it succeeds, nothing is jogged and the laser stays off.";
    LASER_DISARMED = 409 "laser-disarmed" "the laser is disarmed"
        "The laser burns only after a person has armed it for a while with `POST /api/v1/laser`.";
    JOB_RUNNING = 409 "job-running" "a job has the arm"
        "While a job runs, nothing else moves the arm. Pause it, or wait until it is done.";
    NO_JOB_RUNS = 409 "no-job-runs" "no job is running"
        "Only a running job can be paused. `/api/v1/jobs` lists all jobs.";
    DETECTING = 409 "detecting" "the arm is finding out its dialect"
        "While the arm makes the small motions that tell its dialect, nothing else moves it. Wait until it is done, or stop it.";
    NEEDS_PERSON = 409 "needs-a-person" "a person has to confirm this"
        "The job waits until a person has done something at the arm, such as change the pen. Only a person may say that it is done, with `POST /api/v1/jobs/{id}/confirm`; then start the job again.";
    JOB_PHASE = 409 "job-phase" "the job does not allow this now"
        "A job can be started when it is queued or paused, paused when it runs, and cancelled until it is over.";
    DRAWING_PHASE = 409 "drawing-phase" "the drawing is not planned yet"
        "A job can be made of a drawing when it is planned. Ask for the drawing until its phase is `planned`.";
    NO_VECTORS = 409 "no-vectors" "the job has no vectors"
        "Speed and height are changed on write vectors, and the job is made of targets. They keep their own.";
    CANNOT_RESUME = 409 "cannot-resume" "the job cannot be gone on with"
        "The arm is not where the job left it, or its pose is not trusted. The detail says which.";
    NOT_REACHED = 409 "not-reached" "the command was taken, but the arm is not where it leads"
        "The arm stopped at a limit, stalled, was stopped, or the link was lost. The detail says what was seen.";
    TOO_LARGE = 413 "too-large" "the request is too large"
        "The body is larger than this route takes. The detail says how much it takes.";
    MEDIA_TYPE = 415 "media-type" "the body is not JSON"
        "Bodies are JSON, with the header `Content-Type: application/json`.";
    INVALID = 422 "invalid" "a field is not as it has to be"
        "The body is JSON, but a field is missing, unknown, of the wrong type or too large. The detail names it. Nothing has changed.";
    COMMAND = 422 "command" "the command is not sent"
        "The command breaks its table of the protocol, cannot be reached, or means different things to different arms while the dialect is not known.";
    DIALECT_NOT_FOUND = 422 "dialect-not-found" "the dialect was not found"
        "The small motions did not tell which dialect the arm speaks. The detail says why. It can be said by hand, with `PUT /api/v1/dialect`.";
    BAD_TOUCHES = 422 "bad-touches" "the touches tell no calibration"
        "The touched points are too few, contradict each other, or tell of what no arm has. The detail says which, and what to do.";
    POLICY = 422 "policy" "the policy does not allow this"
        "The way of the command breaks a rule of the safety policy. `rule` names it, `at_mm` is where it would be broken, and `nearest_mm` the nearest place that is allowed.";
    BAD_POLICY = 422 "bad-policy" "the text is no policy"
        "The text cannot be used as a safety policy. The detail says which line, what was found, and what is allowed. The policy that held before holds on.";
    TOKEN_FILE = 500 "token-file" "the tokens cannot be read or written"
        "The file with the tokens cannot be read or written. Nothing has changed.";
    POLICY_FILE = 500 "policy-file" "the policy cannot be written"
        "The new policy holds, but it could not be written to its file: after the next start of the station the old one holds again.";
    RECORDING = 500 "recording" "the recordings cannot be read"
        "The folder with the recordings, or one of them, cannot be read. Look at its permissions; `dobot log` reads recordings, too.";
    INTERNAL = 500 "internal" "the station has a bug here"
        "Part of the station failed; nothing else is affected. The detail says where: please report it together with the request.";
    OUT_OF_RANGE = 422 "out-of-range" "a number is not allowed"
        "A number lies outside its range. The detail says which one, and what is allowed.";
    KEY_REUSED = 422 "key-reused" "the key was that of another request"
        "An `Idempotency-Key` is the name of one request: sent again with the same key it queues no other job, and answers with the one that is there. Another request needs another key.";
    BAD_SLOTS = 422 "bad-slots" "the time slots cannot be so"
        "Two slots overlap, a name or a time is not allowed, or there are too many. The detail says which, what was found, and what is allowed. The slots that held before hold on.";
    BAD_JOB = 422 "bad-job" "the job cannot be done"
        "A command of the job cannot be done. The detail says which one, counted from 0, and why.";
    BAD_DRAWING = 422 "bad-drawing" "it cannot be drawn"
        "The file cannot be read, an option does not suit it, or it does not fit where it is to be. The detail says what was found and what is allowed.";
    BAD_PROGRAM = 422 "bad-program" "the program cannot be done"
        "The text is no program, or a step of it cannot be done. The detail says which line, what was found, and what is allowed; `POST /api/v1/programs/check` lists all that is wrong.";
    TOKEN_NAME = 422 "token-name" "no token can have this name"
        "The detail says which names a token can have.";
    BAD_SCENE = 422 "bad-scene" "the text is no scene"
        "The text does not describe a world. The detail says which line, what was found, and what is allowed.";
    BAD_FAULT = 422 "bad-fault" "that cannot go wrong so"
        "A fault cannot be read, or cannot begin now. The detail says which one, and what is allowed.";
    UPGRADE = 426 "upgrade" "this address is a WebSocket"
        "Connect to it with a WebSocket client.";
    TOO_MANY_REQUESTS = 429 "too-many-requests" "too many requests"
        "Requests come faster than the station takes them from one address. Wait as long as the Retry-After header says.";
    TOO_MANY = 429 "too-many" "too much waits already"
        "The station holds back only a few commands of a client. Wait until some are over, or send them as a job.";
    TOO_MANY_CLIENTS = 429 "too-many-clients" "too many clients"
        "The station serves as many clients as it can. Try again later.";
    NO_LINK = 503 "no-link" "there is no arm"
        "The station has no link to an arm. The state says what it waits for.";
    MEMBER_AWAY = 503 "member-away" "the station cannot be reached"
        "The station of the fleet has ended, or the network between it and this one is cut. What was asked for may have been done all the same: look before it is asked for again. Its own page stops its arm.";
    MEMBER_REFUSED = 409 "member-refused" "nothing is asked of this station"
        "Two stations claim one name, or a station speaks another version of the fleet's messages. The detail says which, and what to do.";
    WORK_FILE = 507 "work-file" "the work cannot be written"
        "Work for the fleet is written to the disk before anybody is asked to do it, and that failed. Make room on the disk, or check the folder's permissions.";
    ENDING = 503 "ending" "the station is shutting down"
        "The station ends. The laser is off.";
    ARM_NOT_STARTED = 507 "arm-not-started" "the virtual arm cannot be started"
        "The system has no room for it: the detail says what is missing.";
    JOURNAL = 507 "journal" "the journal cannot be written"
        "Jobs are written to the disk before they run, and that failed. Make room on the disk, or check the folder's permissions.";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_has_a_name_of_its_own_and_some_sentences() {
        for (index, kind) in ALL.iter().enumerate() {
            assert!(
                ALL[..index].iter().all(|it| it.name != kind.name),
                "{kind:?}"
            );
            assert!(kind.explanation.ends_with('.'), "{kind:?}");
        }
    }
}
