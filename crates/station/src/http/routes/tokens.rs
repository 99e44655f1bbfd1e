//! The access tokens of the station.

use axum::Json;
use axum::extract::Path;
use axum::http::StatusCode;
use dobot_api::problem_kinds::{NO_SUCH_TOKEN, TOKEN_FILE, TOKEN_NAME, TOKEN_TAKEN};
use dobot_api::{Problem, Role};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{DELETE, GET, POST};
use crate::http::access::tokens::{Token, Tokens, TokensError};
use crate::http::exchange::requester::Requester;
use crate::http::exchange::responses::{Body, RequestFailed};
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            "/api/v1/tokens",
            "The tokens of the station, without their secrets; for administrators",
            list,
        )
        .gives::<Vec<TokenView>>(200, "the tokens")
        .problems(&[TOKEN_FILE]),
        Route::new(
            POST,
            "/api/v1/tokens",
            "Creates a token, whose secret is shown only now; for administrators",
            add,
        )
        .brings::<Body<TokenView>>()
        .example(r#"{"name": "phone", "role": "control"}"#)
        .gives::<NewToken>(201, "the token")
        .problems(&[TOKEN_NAME, TOKEN_TAKEN, TOKEN_FILE]),
        Route::new(
            DELETE,
            "/api/v1/tokens/{name}",
            "Removes a token: its holder loses access; for administrators",
            remove,
        )
        .gives::<Vec<TokenView>>(200, "the remaining tokens")
        .problems(&[NO_SUCH_TOKEN, TOKEN_FILE]),
    ]
}

/// A token, without its secret.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct TokenView {
    /// Its name: 1 to 40 letters, digits, dots, dashes and spaces.
    name: String,
    /// The role of its holder.
    role: Role,
    /// Whether it is shared by several people, each identified by the name that they give; any
    /// other token belongs to one person, identified by its name.
    #[serde(default)]
    shared: bool,
}

/// A newly created token.
#[derive(Debug, Serialize, JsonSchema)]
struct NewToken {
    /// Its name.
    name: String,
    /// The role of its holder.
    role: Role,
    /// The secret, which is not shown again.
    secret: String,
}

async fn list(requester: Requester) -> Result<Json<Vec<TokenView>>, RequestFailed> {
    requester.check_role(Role::Admin)?;
    Ok(Json(all_of(&requester)?))
}

async fn add(
    requester: Requester,
    Body(new): Body<TokenView>,
) -> Result<(StatusCode, Json<NewToken>), RequestFailed> {
    requester.check_role(Role::Admin)?;
    let TokenView { name, role, shared } = new;
    let token = make(&mut requester.app.tokens(), &name, role, shared);
    let token = token.map_err(|error| problem_of(&error))?;
    let secret = token.secret().to_owned();
    Ok((StatusCode::CREATED, Json(NewToken { name, role, secret })))
}

fn make(tokens: &mut Tokens, name: &str, role: Role, shared: bool) -> Result<Token, TokensError> {
    let token = tokens.add(role, name)?;
    if shared {
        tokens.share(name)?;
    }
    Ok(token)
}

async fn remove(
    requester: Requester,
    Path(name): Path<String>,
) -> Result<Json<Vec<TokenView>>, RequestFailed> {
    requester.check_role(Role::Admin)?;
    let removed = requester.app.tokens().remove(&name);
    removed.map_err(|error| problem_of(&error))?;
    requester.app.refresh_tokens();
    Ok(Json(all_of(&requester)?))
}

fn all_of(requester: &Requester) -> Result<Vec<TokenView>, Problem> {
    let mut tokens = requester.app.tokens();
    tokens.follow().map_err(|error| problem_of(&error))?;
    let view = |(name, role): (&str, Role)| TokenView {
        name: name.to_owned(),
        role,
        shared: tokens.is_shared(name),
    };
    Ok(tokens.list().map(view).collect())
}

fn problem_of(error: &TokensError) -> Problem {
    let kind = match error {
        TokensError::Name(_) => TOKEN_NAME,
        TokensError::Taken(_) => TOKEN_TAKEN,
        TokensError::Unknown(_) => NO_SUCH_TOKEN,
        _ => TOKEN_FILE,
    };
    kind.problem(error.to_string())
}
