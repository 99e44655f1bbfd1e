//! What people say while they hold a page's button to talk.

use axum::Json;
use dobot_api::Role;
use schemars::JsonSchema;
use serde::Serialize;

use super::GET;
use crate::http::exchange::requester::Requester;
use crate::http::exchange::responses::RequestFailed;
use crate::http::resources::talk::TalkPiece;
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            "/api/v1/talk",
            "Whether a listener runs next to the station, so that orders can be spoken",
            listens,
        )
        .gives::<Listener>(200, "whether a listener runs"),
        Route::new(
            GET,
            "/api/v1/talk/audio",
            "For a listener: the audio that clients have sent as binary WebSocket messages since the last request; \
                waits up to a second for some. What it understands it sends as a request `heard`",
            audio,
        )
        .gives::<Vec<TalkPiece>>(200, "the pieces, in the order in which they were sent"),
    ]
}

/// Whether a listener runs.
#[derive(Debug, Serialize, JsonSchema)]
struct Listener {
    /// Whether it has asked for audio in the last seconds.
    listens: bool,
}

async fn listens(requester: Requester) -> Json<Listener> {
    let app = &requester.app;
    let listens = app.talk.listens(app.now());
    Json(Listener { listens })
}

async fn audio(requester: Requester) -> Result<Json<Vec<TalkPiece>>, RequestFailed> {
    requester.check_role(Role::Control)?;
    let app = &requester.app;
    app.talk.note_listener(app.now());
    Ok(Json(app.talk.fetch().await))
}
