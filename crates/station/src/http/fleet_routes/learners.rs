//! Students in lessons, as reported by their pages: their steps, and for how long. Kept for a
//! while, for the board of the fleet; no motion depends on it.

use std::collections::BTreeMap;
use std::time::Duration;

use axum::Json;
use dobot_api::problem_kinds::{INVALID, TOO_MANY};
use dobot_api::{Problem, Role};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::http::exchange::requester::{Requester, is_name};
use crate::http::exchange::responses::{Body, RequestFailed};

/// The progress of a student in a lesson.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Progress {
    /// The student's name: 1 to 60 visible characters.
    student: String,
    /// The name of the lesson's file, as in `tour`: 1 to 40 lowercase letters a to z, digits and
    /// underscores.
    lesson: String,
    /// The number of completed steps: all of them when the lesson is finished.
    done: u32,
    /// The number of steps, 1 to 1000.
    steps: u32,
}

/// A student in a lesson.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub(crate) struct LearnerView {
    /// The student's name.
    student: String,
    /// The name of the lesson's file.
    lesson: String,
    /// The number of completed steps: all of them when the lesson is finished.
    done: u32,
    /// The number of steps.
    steps: u32,
    /// The time that the student has been at this step, in seconds.
    for_s: f64,
}

/// The students with recent reports, by name: an engine without clock.
#[derive(Debug, Default)]
pub(crate) struct Learners(BTreeMap<String, Learner>);

#[derive(Debug)]
struct Learner {
    progress: Progress,
    /// When this step began.
    since: Duration,
    /// When the last report arrived.
    reported: Duration,
}

impl Learners {
    /// Handles a report of a page; repeated reports keep the student listed.
    ///
    /// # Errors
    ///
    /// [`INVALID`] if a field is out of range, [`TOO_MANY`] if [`MAX_STUDENTS`] others are listed.
    fn report(&mut self, now: Duration, progress: Progress) -> Result<LearnerView, Problem> {
        progress.check()?;
        self.forget(now);
        let before = self.0.get(&progress.student);
        if before.is_none() && self.0.len() >= MAX_STUDENTS {
            return Err(TOO_MANY.hinted(
                format!("{MAX_STUDENTS} students are in lessons here, the maximum"),
                "retry a minute after one of them has left",
            ));
        }
        let same = before.filter(|learner| learner.progress == progress);
        let since = same.map_or(now, |learner| learner.since);
        let learner = Learner {
            progress,
            since,
            reported: now,
        };
        let view = learner.view(now);
        self.0.insert(learner.progress.student.clone(), learner);
        Ok(view)
    }

    /// Returns all students with recent reports, by name.
    fn views(&mut self, now: Duration) -> Vec<LearnerView> {
        self.forget(now);
        self.0.values().map(|learner| learner.view(now)).collect()
    }

    fn forget(&mut self, now: Duration) {
        self.0
            .retain(|_, learner| now.saturating_sub(learner.reported) < KEPT_FOR);
    }
}

impl Learner {
    fn view(&self, now: Duration) -> LearnerView {
        let progress = self.progress.clone();
        LearnerView {
            student: progress.student,
            lesson: progress.lesson,
            done: progress.done,
            steps: progress.steps,
            for_s: now.saturating_sub(self.since).as_secs_f64(),
        }
    }
}

impl Progress {
    fn check(&self) -> Result<(), Problem> {
        let wrong = |text: String| Err(INVALID.problem(text));
        if !is_name(&self.student) {
            let found = self.student.chars().count();
            return wrong(format!(
                "student has {found} characters; allowed are 1 to 60 visible ones"
            ));
        }
        let plain = |char: char| char.is_ascii_lowercase() || char.is_ascii_digit() || char == '_';
        if !(1..=40).contains(&self.lesson.len()) || !self.lesson.chars().all(plain) {
            let found: String = self.lesson.chars().take(60).collect();
            return wrong(format!(
                "lesson is {found:?}; allowed are 1 to 40 lowercase letters a to z, digits and underscores, as in tour"
            ));
        }
        let (done, steps) = (self.done, self.steps);
        if !(1..=1000).contains(&steps) {
            return wrong(format!("steps is {steps}; allowed are 1 to 1000"));
        }
        if done > steps {
            return wrong(format!("done is {done}; the lesson has {steps} steps"));
        }
        Ok(())
    }
}

/// Handles the progress of a student.
pub(crate) async fn report(
    requester: Requester,
    Body(progress): Body<Progress>,
) -> Result<Json<LearnerView>, RequestFailed> {
    requester.check_role(Role::Queue)?;
    let now = requester.app.now();
    Ok(Json(requester.app.learners().report(now, progress)?))
}

/// Returns all students in lessons.
pub(crate) async fn all(requester: Requester) -> Json<Vec<LearnerView>> {
    let now = requester.app.now();
    Json(requester.app.learners().views(now))
}

/// The maximum number of students.
const MAX_STUDENTS: usize = 64;
/// The time after which a student without reports is dropped.
const KEPT_FOR: Duration = Duration::from_secs(60);

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn at_step(student: &str, done: u32) -> Progress {
        Progress {
            student: student.into(),
            lesson: "tour".into(),
            done,
            steps: 12,
        }
    }

    fn seconds(s: u64) -> Duration {
        Duration::from_secs(s)
    }

    /// Returns the students with their steps and times in seconds.
    fn progress_of(learners: &mut Learners, now_s: u64) -> Vec<(String, u32, f64)> {
        let views = learners.views(seconds(now_s));
        let plain = |learner_view: LearnerView| {
            (learner_view.student, learner_view.done, learner_view.for_s)
        };
        views.into_iter().map(plain).collect()
    }

    #[test]
    fn the_time_at_a_step_continues_while_the_step_is_the_same_and_restarts_with_the_next_one() {
        let mut learners = Learners::default();
        for (now_s, done) in [(10, 2), (30, 2), (50, 2)] {
            learners
                .report(seconds(now_s), at_step("Anna", done))
                .unwrap();
        }
        assert_eq!(progress_of(&mut learners, 55), [("Anna".into(), 2, 45.0)]);
        learners.report(seconds(60), at_step("Anna", 3)).unwrap();
        assert_eq!(progress_of(&mut learners, 61), [("Anna".into(), 3, 1.0)]);
    }

    #[test]
    fn a_student_without_reports_is_forgotten_after_a_minute() {
        let mut learners = Learners::default();
        learners.report(seconds(0), at_step("Anna", 2)).unwrap();
        learners.report(seconds(30), at_step("Ben", 0)).unwrap();
        assert_eq!(progress_of(&mut learners, 59).len(), 2);
        assert_eq!(progress_of(&mut learners, 60), [("Ben".into(), 0, 30.0)]);
    }

    #[test]
    fn a_full_class_refuses_new_students_and_still_accepts_known_ones() {
        let mut learners = Learners::default();
        for n in 0..MAX_STUDENTS {
            learners
                .report(seconds(0), at_step(&format!("student {n}"), 0))
                .unwrap();
        }
        let refused = learners.report(seconds(1), at_step("Zoë", 0)).unwrap_err();
        assert_eq!(refused.status, TOO_MANY.status);
        learners
            .report(seconds(1), at_step("student 0", 1))
            .expect("she is known");
        learners
            .report(seconds(61), at_step("Zoë", 0))
            .expect("the others are gone");
    }
}
