//! Students in lessons.

use dobot_api::problem_kinds::{INVALID, ROLE, TOO_MANY};

use super::{GET, POST};
use crate::http::exchange::answer::{BODY, Body};
use crate::http::fleet_routes::learners::{self, LearnerView, Progress};
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            "/api/v1/learners",
            "The students in lessons of whom was told within a minute, by name, with how long each has been at a step",
            learners::all,
        )
        .gives::<Vec<LearnerView>>(200, "the students"),
        Route::new(
            POST,
            "/api/v1/learners",
            "Tells how far a student is in a lesson, for the board of the fleet. It is forgotten after a minute unless it is said \
                again",
            learners::tell,
        )
        .brings::<Body<Progress, BODY>>()
        .example(r#"{"student": "Anna", "lesson": "tour", "done": 2, "steps": 12}"#)
        .gives::<LearnerView>(200, "it is told")
        .problems(&[ROLE, INVALID, TOO_MANY]),
    ]
}
