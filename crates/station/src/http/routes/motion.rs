//! Commands, jog buttons and stops.

use std::sync::Arc;

use axum::http::StatusCode;
use axum::response::{IntoResponse, Response};
use axum::{Extension, Json};
use dobot_api::problem_kinds::{
    COMMAND, LASER_DISARMED, LOCKED, MALFORMED, NO_LEASE, NO_LINK, NOT_REACHED, OUT_OF_RANGE,
    POLICY, SLOT, STILL_MOVING,
};
use dobot_api::{Button, Device, FleetWideStop, Jog, News, Notice, Problem, Reply, Request};
use dobot_supervisor::Refusal;
use dobot_wire::Command;
use schemars::JsonSchema;
use serde::Deserialize;
use tokio::sync::broadcast;
use tokio::sync::broadcast::error::RecvError;

use super::{DELETE, MOVES, POST, STOP};
use crate::http::app::Peer;
use crate::http::exchange::requester::{Requester, is_name};
use crate::http::exchange::responses::{Body, Maybe, Nothing, RequestFailed};
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    // table
    vec![
        Route::new(
            POST,
            "/api/v1/commands",
            "Sends one command, if the policy allows its whole path",
            command,
        )
        .brings::<Body<NewCommand>>()
        .example(MOVE_EXAMPLE)
        .gives::<Reply>(200, "the arm has reached the target (with `wait`)")
        .gives::<Reply>(202, "the command is queued")
        .problems(MOVES)
        .problems(&[NOT_REACHED]),
        Route::asks(
            POST,
            "/api/v1/commands/check",
            "Checks where a command would lead if it were sent now, or why it would be refused; nothing is sent",
            |Body(check): Body<CheckCommand>| Request::CheckCommand {
                command: check.command,
            },
        )
        .example(CHECK_EXAMPLE)
        .gives::<Reply>(200, "the whole path is allowed")
        .problems(&[STILL_MOVING, LASER_DISARMED, COMMAND, POLICY, OUT_OF_RANGE, NO_LINK]),
        Route::asks(
            POST,
            "/api/v1/arm/near",
            "Returns the limits and keep-out zones near a position; nothing is sent",
            |Body(place): Body<Place>| Request::Near {
                x_mm: place.x_mm,
                y_mm: place.y_mm,
                z_mm: place.z_mm,
                rotation_deg: place.rotation_deg,
            },
        )
        .example(r#"{"x_mm": 200, "y_mm": 0, "z_mm": 130, "rotation_deg": 0}"#)
        .gives::<Reply>(200, "the limits and zones within 20 mm or 5 degrees")
        .problems(&[POLICY]),
        Route::asks(
            POST,
            "/api/v1/jog",
            "Holds a jog button; it is released unless this request is repeated \
                within the dead-man time (150 ms by default)",
            |Body(new): Body<HoldJog>| Request::Jog { jog: new.jog },
        )
        .example(r#"{"jog": {"frame": "linear", "axis": "x_plus", "speed_percent": 50}}"#)
        .gives::<Reply>(200, "the button is held")
        .problems(MOVES),
        Route::asks(
            POST,
            "/api/v1/jog/release",
            "Releases the jog button",
            |_: Maybe<Nothing>| Request::Release,
        )
        .gives::<Reply>(200, "the button is released")
        .problems(&[NO_LEASE, LOCKED, SLOT]),
        Route::asks(
            POST,
            "/api/v1/jog/step",
            "Moves by one step of a jog button, from the position after all previous commands; pump and \
                gripper do not change",
            |Body(new): Body<NewStep>| Request::Step {
                button: new.button,
                by: new.by,
            },
        )
        .example(r#"{"button": {"frame": "linear", "axis": "x_plus"}, "by": 1}"#)
        .gives::<Reply>(200, "the step is queued")
        .problems(MOVES)
        .problems(&[MALFORMED]),
        Route::new(
            POST,
            STOP,
            "Stops the arm. Anyone may, at any time, without a lease",
            stop,
        )
        .brings::<Maybe<NewStop>>()
        .example(r#"{"reason": "a hand is in the way"}"#)
        .gives::<Reply>(200, "the stopping packet is on its way")
        .problems(&[OUT_OF_RANGE, NO_LINK]),
        Route::asks(
            DELETE,
            STOP,
            "Resets a stop, after a person has checked the arm",
            |_: Maybe<Nothing>| Request::ResetStop,
        )
        .gives::<Reply>(200, "the arm may move")
        .problems(&[STILL_MOVING, NO_LINK]),
    ]
}

const MOVE_EXAMPLE: &str = r#"{"command": {"type": "move_to", "x_mm": 200, "y_mm": 0, "z_mm": 50, "rotation_deg": 0, "suction": false, "mode": "jump", "gripper_deg": 0, "pause_s": 0}, "wait": true}"#;

const CHECK_EXAMPLE: &str = r#"{"command": {"type": "move_to", "x_mm": 200, "y_mm": 0, "z_mm": 50, "rotation_deg": 0, "suction": false, "mode": "movl", "gripper_deg": 0, "pause_s": 0}}"#;

/// A command to be checked.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct CheckCommand {
    /// The command.
    command: Command,
}

/// A position of the tool.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Place {
    /// The distance forward of the axis of the base, in mm.
    x_mm: f64,
    /// The distance to the left of it, in mm.
    y_mm: f64,
    /// The height of the wrist, in mm.
    z_mm: f64,
    /// The rotation of the tool, in degrees.
    rotation_deg: f64,
}

/// A command to be sent.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct NewCommand {
    /// The command.
    command: Command,
    /// Whether to respond when the command has finished, instead of when it is queued.
    #[serde(default)]
    wait: bool,
}

/// A jog button.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct HoldJog {
    /// The button.
    jog: Jog,
}

/// A jog step.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct NewStep {
    /// The button.
    button: Button,
    /// The distance, in mm or degrees.
    #[schemars(range(min = 0.01, max = 100.0))]
    by: f32,
}

/// A stop.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct NewStop {
    /// The reason, shown at the stopped arm.
    #[serde(default)]
    reason: Option<String>,
    /// The stop of the whole fleet of which this is part; only set by other stations of the fleet.
    #[serde(default)]
    fleet: Option<FleetWideStop>,
    /// The name given by the user of a page, as for its WebSocket.
    #[serde(default)]
    name: Option<String>,
    /// The device of a page.
    #[serde(default)]
    device: Option<Device>,
}

async fn stop(
    requester: Requester,
    Extension(peer): Extension<Peer>,
    Maybe(new): Maybe<NewStop>,
) -> Result<Json<Reply>, RequestFailed> {
    // Over HTTP nobody can reset or create stops of the fleet this way.
    if let Some(fleet) = new.fleet.filter(|fleet| peer.by_fleet && fleet.holds())
        && let (_, Some(reply)) = requester.app.handle.adopt_fleet_stops(vec![fleet]).await?
    {
        return Ok(Json(reply));
    }
    let stop = Request::Stop { reason: new.reason };
    // A name that no client may have must not prevent a stop.
    let name = new.name.filter(|name| is_name(name));
    if name.is_none() && new.device.is_none() {
        return requester.ask(stop).await;
    }
    let name = requester.caller.name_of(name.as_deref(), new.device);
    let client = requester.come(&name, new.device).await?;
    Ok(Json(client.request(stop).await?))
}

async fn command(
    requester: Requester,
    Body(new): Body<NewCommand>,
) -> Result<Response, RequestFailed> {
    let mut notices = requester.app.handle.notices();
    let client = requester.client().await?;
    let command = new.command;
    let reply = client.request(Request::Command { command }).await?;
    match reply {
        Reply::Accepted { command, .. } if new.wait => over(command, &mut notices).await,
        reply => Ok((StatusCode::ACCEPTED, Json(reply)).into_response()),
    }
}

/// Waits until a command has finished.
async fn over(
    number: u64,
    notices: &mut broadcast::Receiver<Arc<Notice>>,
) -> Result<Response, RequestFailed> {
    loop {
        let notice = notices.recv().await.map_err(|error| match error {
            RecvError::Closed => Problem::from(Refusal::Ending),
            RecvError::Lagged(_) => {
                NOT_REACHED.problem("too many events: the result of the command was missed")
            }
        })?;
        match notice.news {
            News::CommandDone { command } if command == number => {
                return Ok(Json(Reply::Done).into_response());
            }
            News::CommandFailed { command } if command == number => {
                return Err(NOT_REACHED.problem(&notice.text).into());
            }
            _ => {}
        }
    }
}
