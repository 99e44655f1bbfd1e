//! Buttons that people have added to the page.

use axum::Json;
use axum::extract::Path;
use axum::http::StatusCode;
use dobot_api::Role;
use dobot_api::problem_kinds::{BAD_BUTTON, BUTTON_FILE, BUTTON_TAKEN, NO_SUCH_BUTTON};

use super::{DELETE, GET, POST};
use crate::http::exchange::requester::Requester;
use crate::http::exchange::responses::{Body, RequestFailed};
use crate::http::resources::custom_buttons::CustomButton;
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            "/api/v1/buttons",
            "The buttons that people have added to the page",
            list,
        )
        .gives::<Vec<CustomButton>>(200, "the buttons, in the order in which they were added")
        .problems(&[BUTTON_FILE]),
        Route::new(
            POST,
            "/api/v1/buttons",
            "Adds a button to all pages of the station",
            add,
        )
        .brings::<Body<CustomButton>>()
        .example(EXAMPLE)
        .gives::<Vec<CustomButton>>(201, "all buttons")
        .problems(&[BAD_BUTTON, BUTTON_TAKEN, BUTTON_FILE]),
        Route::new(
            DELETE,
            "/api/v1/buttons/{name}",
            "Removes a button from all pages of the station",
            remove,
        )
        .gives::<Vec<CustomButton>>(200, "the remaining buttons")
        .problems(&[NO_SUCH_BUTTON, BUTTON_FILE]),
    ]
}

const EXAMPLE: &str = r#"{"name": "Lift", "color": "blue", "action": {"type": "program", "text": "[[steps]]\ngo = { x = 200, y = 0, z = 80 }\n"}}"#;

async fn list(requester: Requester) -> Result<Json<Vec<CustomButton>>, RequestFailed> {
    Ok(Json(requester.app.buttons.list()?))
}

async fn add(
    requester: Requester,
    Body(button): Body<CustomButton>,
) -> Result<(StatusCode, Json<Vec<CustomButton>>), RequestFailed> {
    requester.check_role(Role::Control)?;
    let name = button.name().to_owned();
    let all = requester.app.buttons.add(button)?;
    announce(&requester, &format!("added the button {name:?}"));
    Ok((StatusCode::CREATED, Json(all)))
}

async fn remove(
    requester: Requester,
    Path(name): Path<String>,
) -> Result<Json<Vec<CustomButton>>, RequestFailed> {
    requester.check_role(Role::Control)?;
    let left = requester.app.buttons.remove(&name)?;
    announce(&requester, &format!("removed the button {name:?}"));
    Ok(Json(left))
}

/// Notifies all pages that the buttons have changed.
fn announce(requester: &Requester, what: &str) {
    let text = format!("{} {what}", requester.caller.name);
    requester.app.handle.report_buttons(text);
}
