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
        "The body is not JSON, or an address or a header is invalid. The detail gives line and column.";
    UNAUTHORISED = 401 "unauthorised" "an access token is required"
        "The request is not authenticated. Send a token as `Authorization: Bearer <token>`; a browser's WebSocket offers the subprotocol `dobot.token.<token>`. Tokens are created on the station's machine, and an invalid one is refused even if none is required.";
    ROLE = 403 "role" "the role does not allow this"
        "Each token has a role: watch may observe and stop the arm, queue may also queue jobs that a person starts, control may move the arm, admin may also set the dialect and take control from another client.";
    FORBIDDEN_HOST = 403 "forbidden-host" "unknown host name"
        "The Host header is not a name or address of this station. This check protects against pages that point their own name at your machine. Use the address that the station printed, or configure the station's name.";
    FORBIDDEN_ORIGIN = 403 "forbidden-origin" "another site's page may not do this"
        "According to the browser, a page of another site sent this request. Only the station's own page may.";
    UNKNOWN_PATH = 404 "unknown-path" "there is nothing at this address"
        "No route of the station has this path. `/api/v1/openapi.json` lists all of them.";
    NO_SUCH_JOB = 404 "no-such-job" "there is no such job"
        "No job has this number. `/api/v1/jobs` lists all of them.";
    NO_SUCH_DRAWING = 404 "no-such-drawing" "there is no such drawing"
        "No drawing has this number: it was cancelled, or replaced by later ones. Plan it again.";
    NO_SUCH_RECORDING = 404 "no-such-recording" "there is no such recording"
        "No recording has this name; the oldest are deleted when there are too many. `/api/v1/recordings` lists all of them.";
    NO_SUCH_FILE = 404 "no-such-file" "there is no such file"
        "No stored file has this number: it was deleted, or a part of the page is not installed. `/api/v1/files` lists all stored files.";
    NO_SUCH_TOKEN = 404 "no-such-token" "there is no such token"
        "No token has this name. `/api/v1/tokens` lists all of them.";
    NO_SUCH_BUTTON = 404 "no-such-button" "there is no such button"
        "Nobody has added a button with this name to the page, or it was removed. `/api/v1/buttons` lists all of them.";
    NO_LISTENER = 409 "no-listener" "nothing listens to what is said"
        "Audio needs a listener next to the station: `python -m dobot_arm.listen`.";
    NO_FLEET = 404 "no-fleet" "this station belongs to no fleet"
        "A station joins a fleet when it is started with `dobot up --fleet`.";
    NO_SUCH_MEMBER = 404 "no-such-member" "the fleet has no such station"
        "No station of this name, or none of this group, has been seen. `/api/v1/fleet` lists all of them.";
    NO_SUCH_WORK = 404 "no-such-work" "there is no such fleet job"
        "This station has no fleet job with this number, or no offer with this key. `GET /api/v1/fleet/work` lists what was submitted here.";
    NO_SUCH_ARM = 404 "no-such-arm" "there is no such virtual arm"
        "This station hosts no virtual arm of this name now. `GET /api/v1/fleet/virtual-arms` lists those it hosts.";
    NOT_BUILT = 404 "not-built" "not included in this build"
        "Some parts are only in the released archives and in builds with the feature `full`. The detail names the missing part.";
    METHOD = 405 "method" "this path does not support this method"
        "The path exists, but not with this method. The Allow header lists the supported methods.";
    TIMEOUT = 408 "timeout" "the request came too slowly"
        "The body did not arrive in time. Nothing has changed.";
    WORK_REFUSED = 409 "work-refused" "the station does not accept this fleet job"
        "No job resulted from the offer, and none will with its key: it can be offered to another station. The detail gives the reason.";
    ARM_BUSY = 409 "arm-busy" "the arm has another job"
        "The arm has an unfinished job. No job resulted from the offer, and none will with its key: it can be offered again with another key.";
    GIVES_NO_ARMS = 409 "gives-no-arms" "this station hosts no virtual arms"
        "A station hosts virtual arms for fleet members without an arm when started with `dobot up --virtual --fleet --virtual-arms N`. The list of fleet members shows which stations do.";
    NAME_TAKEN = 409 "name-taken" "another station has this name"
        "Another station of the fleet has this name. Requests are not sent to stations with the same name: use another name.";
    ALL_ARMS_GIVEN = 409 "all-arms-given" "all virtual arms are in use"
        "The station hosts no more virtual arms at a time. One ends by itself when no client has watched it for a while, and an administrator can end one.";
    WORK_PHASE = 409 "work-phase" "the fleet job does not allow this now"
        "What can be done with a fleet job depends on its phase. The detail gives the phase and what is allowed.";
    TOKEN_TAKEN = 409 "token-taken" "another token has this name"
        "Remove the other token first, or use another name.";
    BUTTON_TAKEN = 409 "button-taken" "another button has this name"
        "Remove the other button first, or use another name.";
    FILE_EXISTS = 409 "file-exists" "another file has this name"
        "A stored file with other content has this name. Repeat the request with `existing` set to `replace` or `keep_both`, or use another name.";
    FILE_CHANGED = 409 "file-changed" "the file has changed"
        "Somebody changed the file after it was read: another page or program. Nothing has changed now. Read it again, then repeat the change.";
    NOT_VIRTUAL = 409 "not-virtual" "the arm is not a virtual arm of this station"
        "World and faults exist only for a station's own virtual arm: `dobot up --virtual`.";
    NO_LEASE = 409 "no-lease" "this client does not have control"
        "One client at a time has control of the arm. Take control with `POST /api/v1/lease`; if another client has it, ask for it with `POST /api/v1/lease/ask`. Stopping does not require control.";
    LEASE_GONE = 409 "lease-gone" "the lease token is no longer valid"
        "Control taken over plain HTTP ends when its lease token is not used for ten seconds. Take control again.";
    LOCKED = 409 "locked" "the arm is locked"
        "An administrator has locked the arm, for example a teacher who needs attention. The detail says who, and why. Stopping does not require control.";
    SLOT = 409 "slot" "the arm is reserved for another student"
        "The arm is in another student's time slot: only that student and administrators can have control. The detail says whose it is, for how long, and when the arm is free. Stopping does not require control.";
    NOT_ASKING = 409 "not-asking" "the client has not asked for control"
        "Control can be granted only to a client that has asked for it; the state lists them.";
    STOPPED = 409 "stopped" "the arm is stopped"
        "The arm stays stopped until a person has checked it and clears the stop with `DELETE /api/v1/stop`.";
    STILL_MOVING = 409 "still-moving" "the arm is still moving"
        "The arm has not come to rest yet. The detail says how long that takes at most.";
    LET_GO = 409 "let-go" "the button was released"
        "The station released a button that its client still holds: the client fell silent for a while, or the arm was stopped. Release the button, then press it again.";
    NOT_DELIVERED = 503 "not-delivered" "it could not be sent to the arm"
        "There is no link to the arm, so the packets that stop it or switch its laser off have not left this computer. They are sent as soon as the link is back; until then the arm continues. Switch it off by hand.";
    UNGUARDED = 503 "unguarded" "no watchdog guards the arm"
        "The process that stops the arm when the station is killed is gone, and the system cannot start another one. The station tries again every few seconds; until then jogging is refused and the laser stays off.";
    LASER_DISARMED = 409 "laser-disarmed" "the laser is disarmed"
        "The laser burns only after a person has armed it for a while with `POST /api/v1/laser`.";
    JOB_RUNNING = 409 "job-running" "a job is using the arm"
        "While a job runs, nothing else moves the arm. Pause it, or wait until it is done.";
    NO_QUESTION = 409 "no-question" "the job does not wait for an answer"
        "A running program asks at rest, after the commands before the question. `question` in `/api/v1/jobs` shows it.";
    BAD_ANSWER = 422 "bad-answer" "the answer does not fit"
        "The answer is none of those that the program allows, or the arm may not go where it leads. The job still waits.";
    NO_JOB_RUNS = 409 "no-job-runs" "no job is running"
        "Only a running job can be paused. `/api/v1/jobs` lists all jobs.";
    DETECTING = 409 "detecting" "the dialect is being detected"
        "While the arm makes the small motions of the detection, nothing else may move it. Wait until it is done, or stop it.";
    NEEDS_PERSON = 409 "needs-a-person" "a person has to confirm this"
        "The job waits until a person has done something at the arm, such as change the pen. Only a person may confirm it, with `POST /api/v1/jobs/{id}/confirm`; then start the job again.";
    JOB_PHASE = 409 "job-phase" "the job does not allow this now"
        "A job can be started when it is queued or paused, paused when it runs, and cancelled until it is over.";
    DRAWING_PHASE = 409 "drawing-phase" "the drawing is not planned yet"
        "A drawing can be queued as a job once it is planned. Poll the drawing until its phase is `planned`.";
    NO_VECTORS = 409 "no-vectors" "the job has no vectors"
        "Speed and height can be changed for write vectors only, and the job consists of targets.";
    CANNOT_RESUME = 409 "cannot-resume" "the job cannot be resumed"
        "The arm is not where the job left it, or its pose is not trusted. The detail says which.";
    NOT_REACHED = 409 "not-reached" "the arm did not reach the end of the command"
        "The arm stopped at a limit, stalled, was stopped, or the link was lost. The detail says what was observed.";
    TOO_LARGE = 413 "too-large" "the request is too large"
        "The body is larger than this route allows. The detail gives the limit.";
    MEDIA_TYPE = 415 "media-type" "the body is not JSON"
        "Bodies are JSON, with the header `Content-Type: application/json`.";
    INVALID = 422 "invalid" "a field is invalid"
        "The body is JSON, but a field is missing, unknown, of the wrong type or too large. The detail names it. Nothing has changed.";
    COMMAND = 422 "command" "the command cannot be sent"
        "The command violates its table in the specification, leads out of reach, or means different things to different arms while the dialect is unknown.";
    DIALECT_NOT_FOUND = 422 "dialect-not-found" "the dialect could not be detected"
        "The small motions did not determine the dialect. The detail says why. It can be set by hand with `PUT /api/v1/dialect`.";
    BAD_TOUCHES = 422 "bad-touches" "no calibration fits the touched points"
        "The touched points are too few, contradict each other, or imply impossible values. The detail says which, and what to do.";
    POLICY = 422 "policy" "the policy does not allow this"
        "The path of the command breaks a rule of the safety policy. `rule` names it, `at_mm` is where it would be broken, and `nearest_mm` is the nearest allowed position.";
    BAD_POLICY = 422 "bad-policy" "the policy is invalid"
        "The text cannot be used as a safety policy. The detail says which line, what was found, and what is allowed. The previous policy stays in force.";
    NOT_RECORDED = 503 "not-recorded" "nothing is recorded"
        "A mark needs a recording: that of a station whose disk has room. The detail says what is missing.";
    TOKEN_FILE = 500 "token-file" "the tokens cannot be read or written"
        "The file with the tokens cannot be read or written. Nothing has changed.";
    BUTTON_FILE = 500 "button-file" "the buttons cannot be read or written"
        "The file with the buttons of the page cannot be read or written. Nothing has changed.";
    POLICY_FILE = 500 "policy-file" "the policy cannot be written"
        "The new policy is in force, but could not be written to its file: after the next start of the station the old one applies again.";
    RECORDING = 500 "recording" "the recordings cannot be read"
        "The folder of recordings, or one of them, cannot be read. Check its permissions; `dobot log` reads recordings too.";
    INTERNAL = 500 "internal" "the station has a bug here"
        "Part of the station failed; nothing else is affected. The detail says where: please report it together with the request.";
    OUT_OF_RANGE = 422 "out-of-range" "a number is out of range"
        "A number is outside its range. The detail says which one, and what is allowed.";
    KEY_REUSED = 422 "key-reused" "the key was used for another request"
        "An `Idempotency-Key` identifies one request: a repeated request with the same key queues no second job and returns the existing one. A different request needs a new key.";
    BAD_SLOTS = 422 "bad-slots" "the time slots are invalid"
        "Two slots overlap, a name or a time is not allowed, or there are too many. The detail says which, what was found, and what is allowed. The previous slots stay.";
    BAD_JOB = 422 "bad-job" "the job cannot run"
        "A command of the job cannot be executed. The detail says which one, counted from 0, and why.";
    BAD_DRAWING = 422 "bad-drawing" "it cannot be drawn"
        "The file cannot be read, an option does not suit it, or it does not fit its place. The detail says what was found and what is allowed.";
    BAD_PROGRAM = 422 "bad-program" "the program cannot run"
        "The text is not a program, or one of its steps cannot be executed. The detail says which line, what was found, and what is allowed; `POST /api/v1/programs/check` lists all errors.";
    FILE_NAME = 422 "file-name" "no file can have this name"
        "The detail says which names are allowed. The ending of the name decides what the file is: a drawing, a photo or a program.";
    TOKEN_NAME = 422 "token-name" "no token can have this name"
        "The detail says which names a token can have.";
    BAD_BUTTON = 422 "bad-button" "the button is invalid"
        "The detail says what is wrong with its name or its program, and what is allowed.";
    BAD_SCENE = 422 "bad-scene" "the scene is invalid"
        "The text does not describe a world. The detail says which line, what was found, and what is allowed.";
    BAD_FAULT = 422 "bad-fault" "the fault is invalid"
        "A fault cannot be parsed, or cannot begin now. The detail says which one, and what is allowed.";
    UPGRADE = 426 "upgrade" "this address is a WebSocket"
        "Connect to it with a WebSocket client.";
    TOO_MANY_REQUESTS = 429 "too-many-requests" "too many requests"
        "Requests from one address arrive faster than the station allows. Wait for the time in the Retry-After header.";
    TOO_MANY = 429 "too-many" "too many commands are waiting"
        "The station queues only a few commands per client. Wait until some are over, or send them as a job.";
    TOO_MANY_CLIENTS = 429 "too-many-clients" "too many clients"
        "The station has reached its limit of clients. Try again later.";
    NO_LINK = 503 "no-link" "there is no arm"
        "The station has no link to an arm. The state says what it is waiting for.";
    MEMBER_AWAY = 503 "member-away" "the station cannot be reached"
        "The station of the fleet has ended, or the network between it and this one is cut. The request may still have been carried out: check before repeating it. Its arm can be stopped from its own page.";
    MEMBER_REFUSED = 409 "member-refused" "no requests are sent to this station"
        "Two stations claim the same name, or a station uses another version of the fleet messages. The detail says which, and what to do.";
    WORK_FILE = 507 "work-file" "the fleet job cannot be saved"
        "Fleet jobs are saved to the disk before they are offered, and that failed. Free disk space, or check the folder's permissions.";
    ENDING = 503 "ending" "the station is shutting down"
        "The station is ending. The laser is off.";
    ARM_NOT_STARTED = 507 "arm-not-started" "the virtual arm cannot be started"
        "The system lacks resources for it; the detail says which.";
    FILES_FULL = 507 "files-full" "the space for files is used up"
        "The stored files have reached their limit. Nothing has changed. The detail says how much is left, and the hint which files are the largest.";
    FILES_UNUSABLE = 507 "files-unusable" "the files cannot be read or written"
        "The folder of stored files, or one of them, cannot be read or written. Nothing has changed. Free disk space, or check its permissions.";
    JOURNAL = 507 "journal" "the journal cannot be written"
        "Jobs are written to the disk before they run, and that failed. Free disk space, or check the folder's permissions.";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_has_a_unique_name_and_an_explanation() {
        for (index, kind) in ALL.iter().enumerate() {
            assert!(
                ALL[..index].iter().all(|earlier| earlier.name != kind.name),
                "{kind:?}"
            );
            assert!(kind.explanation.ends_with('.'), "{kind:?}");
        }
    }
}
