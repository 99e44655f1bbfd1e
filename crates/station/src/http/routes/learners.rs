//! Students in lessons.

use dobot_api::problem_kinds::{INVALID, ROLE, TOO_MANY};

use super::{GET, POST};
use crate::http::exchange::responses::{BODY, Body};
use crate::http::fleet_routes::learners::{self, LearnerView, Progress};
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            "/api/v1/learners",
            "The students in lessons that were reported within a minute, by name, with the time at their steps",
            learners::all,
        )
        .gives::<Vec<LearnerView>>(200, "the students"),
        Route::new(
            POST,
            "/api/v1/learners",
            "Reports the progress of a student in a lesson, for the board of the fleet. It expires after a minute unless it is \
                repeated",
            learners::report,
        )
        .brings::<Body<Progress, BODY>>()
        .example(r#"{"student": "Anna", "lesson": "tour", "done": 2, "steps": 12}"#)
        .gives::<LearnerView>(200, "the reported progress")
        .problems(&[ROLE, INVALID, TOO_MANY]),
    ]
}
