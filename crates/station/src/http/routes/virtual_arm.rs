//! The station's own virtual arm: its world and its faults.

use std::sync::{Arc, PoisonError};

use axum::Json;
use axum::extract::{Query as Queries, State};
use dobot_api::problem_kinds::{BAD_FAULT, BAD_SCENE, MALFORMED, NOT_VIRTUAL};
use dobot_api::{Problem, Role};
use dobot_host::OwnVirtualArm;
use dobot_sim::Fault;
use dobot_sim::world::{Scene, World, WorldState};
use schemars::{JsonSchema, SchemaGenerator};
use serde::Deserialize;

use super::{GET, PUT};
use crate::http::app::App;
use crate::http::exchange::requester::Requester;
use crate::http::exchange::responses::{Body, RequestFailed};
use crate::http::route::{Query, Route};

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            "/api/v1/world",
            "The world of the station's own virtual arm: tool, paper, ink, objects",
            world,
        )
        .queries(&[Query {
            name: "strokes_from",
            what: "Index of the first line of ink and burns, counted from 0; the last line may still grow",
            schema: SchemaGenerator::subschema_for::<usize>,
        }])
        .gives::<WorldState>(200, "the world")
        .problems(&[MALFORMED, NOT_VIRTUAL]),
        Route::new(
            PUT,
            "/api/v1/world",
            "Replaces the world of the station's own virtual arm; the arm keeps its pose",
            set_world,
        )
        .brings::<Body<SceneText>>()
        .example(r#"{"scene": "[pen]\ndown_z_mm = -40\n"}"#)
        .gives::<WorldState>(200, "the world")
        .problems(&[BAD_SCENE, NOT_VIRTUAL]),
        Route::new(
            GET,
            "/api/v1/faults",
            "The faults of the station's own virtual arm",
            faults,
        )
        .gives::<Vec<String>>(200, "the faults")
        .problems(&[NOT_VIRTUAL]),
        Route::new(
            PUT,
            "/api/v1/faults",
            "Replaces the faults of the station's own virtual arm",
            set_faults,
        )
        .brings::<Body<NewFaults>>()
        .example(r#"{"faults": ["drop=1%", "reset@3s"], "seed": 1}"#)
        .gives::<Vec<String>>(200, "the faults")
        .problems(&[BAD_FAULT, NOT_VIRTUAL]),
    ]
}

/// The requested part of the world.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Wanted {
    #[serde(default)]
    strokes_from: usize,
}

/// A world.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SceneText {
    /// Its TOML text, as those of `examples/scenes`.
    scene: String,
}

/// The new faults.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct NewFaults {
    /// The faults, in the format of `dobot arm --fault`; times count from now.
    faults: Vec<String>,
    /// The random seed: the same faults with the same seed have the same effect.
    #[serde(default)]
    seed: u64,
}

async fn world(
    State(app): State<Arc<App>>,
    wanted: Result<Queries<Wanted>, axum::extract::rejection::QueryRejection>,
) -> Result<Json<WorldState>, RequestFailed> {
    let Queries(wanted) = wanted.map_err(|error| MALFORMED.problem(error.body_text()))?;
    let mut world = state(own_arm(&app)?)?;
    for_later(&mut world.strokes, wanted.strokes_from);
    for_later(&mut world.burns, wanted.strokes_from);
    Ok(Json(world))
}

fn for_later<T>(marks: &mut Vec<T>, from: usize) {
    marks.drain(..from.min(marks.len()));
}

async fn set_world(
    requester: Requester,
    Body(new): Body<SceneText>,
) -> Result<Json<WorldState>, RequestFailed> {
    let own = own_arm(&requester.app)?;
    requester.check_role(Role::Control)?;
    let scene = Scene::parse(&new.scene);
    let scene = scene.map_err(|error| BAD_SCENE.problem(error.to_string()))?;
    own.arm.arm().set_world(World::new(scene));
    Ok(Json(state(own)?))
}

async fn faults(State(app): State<Arc<App>>) -> Result<Json<Vec<String>>, RequestFailed> {
    own_arm(&app)?;
    let faults = app.faults.lock().unwrap_or_else(PoisonError::into_inner);
    Ok(Json(faults.clone()))
}

async fn set_faults(
    requester: Requester,
    Body(new): Body<NewFaults>,
) -> Result<Json<Vec<String>>, RequestFailed> {
    let own = own_arm(&requester.app)?;
    requester.check_role(Role::Control)?;
    let bad = |error: dobot_sim::FaultError| BAD_FAULT.problem(error.to_string());
    let faults: Result<Vec<Fault>, _> = new.faults.iter().map(|fault| fault.parse()).collect();
    let faults = faults.map_err(bad)?;
    let mut arm = own.arm.arm();
    let changed = arm.set_faults(own.power_up, &faults, new.seed);
    drop(arm);
    changed.map_err(bad)?;
    let mut faults = requester
        .app
        .faults
        .lock()
        .unwrap_or_else(PoisonError::into_inner);
    faults.clone_from(&new.faults);
    Ok(Json(new.faults))
}

fn own_arm(app: &App) -> Result<&OwnVirtualArm, Problem> {
    let none = || {
        NOT_VIRTUAL.hinted(
            "the arm is real, or served by another program",
            "start a station with its own virtual arm with `dobot up --virtual`",
        )
    };
    app.virtual_arm.as_ref().ok_or_else(none)
}

fn state(own: &OwnVirtualArm) -> Result<WorldState, Problem> {
    let arm = own.arm.arm();
    let world = arm.world().map(World::state);
    world.ok_or_else(|| NOT_VIRTUAL.problem("the virtual arm has no world"))
}
