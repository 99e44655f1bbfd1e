//! Detection of an arm's dialect by its motions.

mod fit;
mod step;

use std::collections::VecDeque;
use std::time::Duration;

use dobot_arm::{Joints, Position};
use dobot_motion::{ArmPlace, Model, Trajectory, TrajectoryError};
use dobot_wire::{Command, Dialect, Evidence, Finding, Packet, Status};

use self::fit::{duration_s, path_deviation_mm, path_difference_mm};
use self::step::{DetectionStep, Question, steps};
use crate::position;

/// Detects the dialect of an arm with small slow motions; an engine without I/O and clock.
///
/// No message states the dialect (note N1), so the arm runs the motions that differ between dialects.
/// The statuses then show which of the moving modes 1 and 2 is straight, which percentage of state 10
/// is the speed, and the direction of X of a vector. The arm first lifts by 6 mm, moves at most 20 mm
/// at no more than 30 mm/s, and returns to the start within half a minute. No packet makes an arm of
/// either dialect hang or lose its pose. Afterwards, playback and write speeds are those of power-up.
/// After an error the arm stays where it is and keeps its current settings.
///
/// ```
/// use dobot_session::{Detection, DetectionError};
/// use dobot_wire::Status;
///
/// // There is no room for the motions when the arm is fully extended.
/// let status = Status {
///     x_mm: 315.07,
///     z_mm: 0.0,
///     rear_deg: 35.9,
///     fore_deg: 41.6,
///     ..Status::AT_ZERO
/// };
/// let error = Detection::new(&status, |_| true).unwrap_err();
/// assert!(matches!(error, DetectionError::NoRoom { .. }));
/// ```
#[derive(Debug)]
pub struct Detection {
    steps: VecDeque<DetectionStep>,
    running: Option<Running>,
    /// The arm model of each dialect.
    models: [Model; 2],
    to_send: Option<Packet>,
    measurements: Vec<Measurement>,
    outcome: Option<Result<Finding, DetectionError>>,
    ended: bool,
}

/// The error returned when no dialect is found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DetectionError {
    /// The motions would leave the limits of the arm or the allowed space; nothing was sent.
    #[error(
        "there is no room for the motions, within 20 mm of the arm: {why}; move it to about 220, 0, 20 mm, clear of obstacles, and try again"
    )]
    NoRoom {
        /// The violated limit.
        why: String,
    },
    /// The arm is already moving, or another client moves it.
    #[error("the arm is not at rest; wait until it is, and keep other clients from moving it")]
    Moving,
    /// The arm ignores commands.
    #[error("the arm did not move within {} s, although a motion was sent three times", PATIENCE.as_secs())]
    DidNotMove,
    /// A motion ended at a point that fits neither dialect.
    #[error(
        "the arm stopped {off_mm:.2} mm from the target of the motion; check for obstacles and that its pose is correct"
    )]
    Elsewhere {
        /// The distance from the nearer target, in millimetres.
        off_mm: f64,
    },
    /// The observation fits both dialects or neither.
    #[error("cannot determine {question}: {saw}; try again with no other client on the line")]
    Unclear {
        /// The question.
        question: &'static str,
        /// The observation.
        saw: String,
    },
    /// The measurements belong to different dialects.
    #[error("the arm matches no single dialect: {}; none was selected", .0.join("; "))]
    Mixed(Vec<String>),
}

/// A step in progress and the statuses since.
#[derive(Debug)]
struct Running {
    step: DetectionStep,
    sent: Duration,
    tries: u32,
    from: Status,
    /// The motion in each dialect.
    trajectories: Option<[Trajectory; 2]>,
    seen: Vec<(Duration, Status)>,
}

/// The deviation of each dialect from the observation, and the difference between the dialects.
#[derive(Clone, Copy, Debug)]
struct Measurement {
    question: Question,
    off: [f64; 2],
    apart: f64,
    /// The observed value, in the unit of the question.
    saw: f64,
}

impl Detection {
    /// Plans the motions for an arm at rest. `allowed` returns whether a pose is allowed; it is called
    /// along the whole path, for both dialects.
    ///
    /// # Errors
    ///
    /// Returns [`DetectionError::NoRoom`] if a pose is not allowed.
    pub fn new(status: &Status, allowed: impl Fn(&Joints) -> bool) -> Result<Self, DetectionError> {
        let steps = steps(status);
        let models = Dialect::ALL.map(|dialect| Model::new(dialect, status));
        for model in models {
            check_room(model, &steps, &allowed)?;
        }
        Ok(Self {
            steps: steps.into(),
            running: None,
            models,
            to_send: None,
            measurements: Vec::new(),
            outcome: None,
            ended: false,
        })
    }

    /// Handles a status; each permits one packet.
    pub fn handle_status(&mut self, now: Duration, status: &Status) {
        if self.ended {
            return;
        }
        let done = match &mut self.running {
            None => Ok(true),
            Some(running) => {
                running.seen.push((now, *status));
                running.progress(now)
            }
        };
        match done {
            Ok(true) => self.advance(now, status),
            Ok(false) => {}
            Err(Trouble::Ignored) => self.repeat(now, status),
            Err(Trouble::Moving) => self.end(Err(DetectionError::Moving)),
        }
    }

    /// Returns the packet to send now: at most one per status.
    pub fn poll_packet(&mut self) -> Option<Packet> {
        self.to_send.take()
    }

    /// Returns the outcome once, when the detection has ended.
    pub fn poll_outcome(&mut self) -> Option<Result<Finding, DetectionError>> {
        self.outcome.take()
    }

    /// Evaluates the completed step and starts the next one.
    fn advance(&mut self, now: Duration, status: &Status) {
        if let Some(running) = self.running.take() {
            match running.measurement() {
                Ok(measurement) => self.measurements.extend(measurement),
                Err(error) => return self.end(Err(error)),
            }
            for model in &mut self.models {
                *model = after_step(model, &running.step);
            }
        }
        match self.steps.pop_front() {
            Some(step) => self.start(step, now, status, 0),
            None => self.end(self.find()),
        }
    }

    fn start(&mut self, step: DetectionStep, now: Duration, status: &Status, tries: u32) {
        for model in &mut self.models {
            model.observe(status);
        }
        let trajectories = self
            .models
            .each_ref()
            .map(|model| trajectory(model, &step).ok());
        self.to_send = Some(step.frame.into());
        self.running = Some(Running {
            step,
            sent: now,
            tries,
            from: *status,
            trajectories: trajectories[0].zip(trajectories[1]).map(Into::into),
            seen: Vec::new(),
        });
    }

    /// Sends a motion again that the arm did not begin.
    fn repeat(&mut self, now: Duration, status: &Status) {
        match self.running.take() {
            Some(running) if running.tries + 1 < TRIES => {
                self.start(running.step, now, status, running.tries + 1);
            }
            _ => self.end(Err(DetectionError::DidNotMove)),
        }
    }

    fn end(&mut self, outcome: Result<Finding, DetectionError>) {
        self.ended = true;
        self.outcome = Some(outcome);
    }

    fn find(&self) -> Result<Finding, DetectionError> {
        let evidence: Vec<Evidence> = Question::ALL
            .into_iter()
            .map(|question| self.evidence(question))
            .collect::<Result<_, _>>()?;
        let dialect = evidence[0].means;
        if evidence.iter().any(|item| item.means != dialect) {
            let lines = evidence.iter().map(ToString::to_string).collect();
            return Err(DetectionError::Mixed(lines));
        }
        Ok(Finding { dialect, evidence })
    }

    /// Evaluates a question: all its measurements must fit one dialect and not the other.
    fn evidence(&self, question: Question) -> Result<Evidence, DetectionError> {
        let all = self.measurements.iter();
        let measurements: Vec<_> = all.filter(|one| one.question == question).collect();
        let saw = words(question, &measurements);
        let fits = |dialect: usize| {
            let near = question.tolerance();
            let clear = |m: &&Measurement| m.apart > 2.0 * near && m.off[dialect] <= near;
            !measurements.is_empty() && measurements.iter().all(clear)
        };
        let means = match (fits(0), fits(1)) {
            (true, false) => Dialect::ALL[0],
            (false, true) => Dialect::ALL[1],
            _ => {
                return Err(DetectionError::Unclear {
                    question: question.words(),
                    saw,
                });
            }
        };
        Ok(Evidence {
            question: question.words().to_owned(),
            saw,
            means,
        })
    }
}

impl Running {
    /// Whether the step is completed.
    fn progress(&self, now: Duration) -> Result<bool, Trouble> {
        if !self.step.moves {
            let moved = self
                .seen
                .iter()
                .any(|(_, status)| !is_same(status, &self.from));
            return if moved {
                Err(Trouble::Moving)
            } else {
                Ok(self.seen.len() >= SETTLED)
            };
        }
        let rests = self.seen.len() >= AT_REST
            && self.seen[self.seen.len() - AT_REST..]
                .windows(2)
                .all(|pair| is_same(&pair[0].1, &pair[1].1));
        let begun = self
            .seen
            .iter()
            .any(|(_, status)| !is_same(status, &self.from));
        if !begun && now.saturating_sub(self.sent) > PATIENCE {
            return Err(Trouble::Ignored);
        }
        Ok(rests && begun)
    }

    /// Measures the motion; `None` for a step without a question.
    fn measurement(&self) -> Result<Option<Measurement>, DetectionError> {
        let (Some(trajectories), Some((_, last))) = (&self.trajectories, self.seen.last()) else {
            return Ok(None);
        };
        if !self.step.moves {
            return Ok(None);
        }
        let found = position(last);
        let off_end = trajectories
            .each_ref()
            .map(|trajectory| end(trajectory).distance(found).0);
        let nearest = off_end[0].min(off_end[1]);
        if nearest > END_MM {
            return Err(DetectionError::Elsewhere { off_mm: nearest });
        }
        Ok(self.step.question.map(|question| {
            let [one, other] = trajectories;
            let motion_s = |trajectory: &Trajectory| trajectory.motion_s().unwrap_or_default();
            let took_s = duration_s(self.sent, &self.seen) - ON_THE_LINE_S;
            let (off, apart, saw) = match question {
                Question::Modes => (
                    trajectories
                        .each_ref()
                        .map(|trajectory| path_deviation_mm(trajectory, &self.seen)),
                    path_difference_mm(one, other),
                    0.0,
                ),
                Question::Percentages => (
                    trajectories
                        .each_ref()
                        .map(|trajectory| (took_s - motion_s(trajectory)).abs()),
                    (motion_s(one) - motion_s(other)).abs(),
                    took_s,
                ),
                Question::WriteX => (
                    off_end,
                    end(one).distance(end(other)).0,
                    found.x.0 - position(&self.from).x.0,
                ),
            };
            Measurement {
                question,
                off,
                apart,
                saw,
            }
        }))
    }
}

impl Question {
    /// The largest deviation that still fits a dialect, in millimetres or seconds.
    const fn tolerance(self) -> f64 {
        match self {
            Self::Modes => 0.03,
            Self::Percentages | Self::WriteX => 0.3,
        }
    }
}

enum Trouble {
    Ignored,
    Moving,
}

/// Simulates all steps and checks that every pose is allowed.
fn check_room(
    mut model: Model,
    steps: &[DetectionStep],
    allowed: &impl Fn(&Joints) -> bool,
) -> Result<(), DetectionError> {
    let no_room = |error: TrajectoryError| DetectionError::NoRoom {
        why: error.to_string(),
    };
    for step in steps {
        let trajectory = trajectory(&model, step).map_err(no_room)?;
        trajectory.check().map_err(no_room)?;
        let motion_s = trajectory.motion_s().unwrap_or_default();
        for index in 0..=SAMPLES {
            let t_s = motion_s * f64::from(index) / f64::from(SAMPLES);
            let place = trajectory
                .place_at(t_s)
                .map_err(|error| no_room(error.into()))?;
            check_allowed(&place, allowed)?;
        }
        model = after_step(&model, step);
    }
    Ok(())
}

fn check_allowed(
    place: &ArmPlace,
    allowed: &impl Fn(&Joints) -> bool,
) -> Result<(), DetectionError> {
    if allowed(&place.joints) {
        return Ok(());
    }
    let Position { x, y, z } = place.pose.position;
    Err(DetectionError::NoRoom {
        why: format!("{:.1}, {:.1}, {:.1} mm is not allowed", x.0, y.0, z.0),
    })
}

fn command(model: &Model, step: &DetectionStep) -> Result<Command, TrajectoryError> {
    Command::parse(&step.frame.into(), &model.dialect).map_err(TrajectoryError::Invalid)
}

fn trajectory(model: &Model, step: &DetectionStep) -> Result<Trajectory, TrajectoryError> {
    model.trajectory(&command(model, step)?)
}

/// The model after a step.
fn after_step(model: &Model, step: &DetectionStep) -> Model {
    let Ok(command) = command(model, step) else {
        return *model;
    };
    match model.trajectory(&command) {
        Ok(trajectory) => model.after(&command, &trajectory),
        Err(_) => model.begun(&command),
    }
}

fn end(trajectory: &Trajectory) -> Position {
    let motion_s = trajectory.motion_s().unwrap_or_default();
    let end = trajectory.end().map(Ok);
    let place = end.unwrap_or_else(|| trajectory.place_at(motion_s));
    place.map_or(Position::default(), |place| place.pose.position)
}

/// Describes the measurements of a question.
fn words(question: Question, measurements: &[&Measurement]) -> String {
    let most = |dialect: usize| {
        measurements
            .iter()
            .map(|m| m.off[dialect])
            .fold(0.0, f64::max)
    };
    let saw: Vec<f64> = measurements.iter().map(|m| m.saw).collect();
    match question {
        Question::Modes => format!(
            "the paths deviate by up to {:.3} mm if mode 1 is straight, {:.3} mm if mode 2 is straight",
            most(0),
            most(1)
        ),
        Question::Percentages => format!(
            "with 10 and 100 % a move took {:.2} s",
            saw.first().copied().unwrap_or_default()
        ),
        Question::WriteX => format!(
            "2 and -2 in float 3 moved {:.2} and {:.2} mm along X",
            saw.first().copied().unwrap_or_default(),
            saw.get(1).copied().unwrap_or_default()
        ),
    }
}

/// Whether two statuses report the same position.
fn is_same(one: &Status, other: &Status) -> bool {
    position(one).distance(position(other)).0 < SAME_MM
}

/// A damaged status may be off by 0.01 mm (note N23).
const SAME_MM: f64 = 0.02;
const END_MM: f64 = 0.3;
/// Number of equal statuses after which the arm is at rest.
const AT_REST: usize = 4;
/// Number of statuses after which a configuration is in effect.
const SETTLED: usize = 2;
const TRIES: u32 = 3;
const PATIENCE: Duration = Duration::from_secs(3);
/// The time of a packet each way, half a tick, and half a status period.
const ON_THE_LINE_S: f64 = 0.14;
/// Checked poses per motion.
const SAMPLES: u32 = 50;
