//! Which dialect an arm speaks, by what it does.

mod fit;
mod step;

use std::collections::VecDeque;
use std::time::Duration;

use dobot_arm::{Joints, Position};
use dobot_motion::{Model, Trajectory, TrajectoryError};
use dobot_wire::{Command, Dialect, Evidence, Finding, Packet, Status};

use self::fit::{apart_mm, off_way_mm, took_s};
use self::step::{DetectionStep, Question, steps};
use crate::position;

/// Finds out which dialect an arm speaks by small slow motions, as an engine without I/O and clock.
///
/// Nothing on the line tells the dialect (note N1). So the arm is made to do what the dialects
/// disagree about: the statuses tell which of the moving modes 1 and 2 is straight, which percentage
/// of state 10 is the speed, and which way X of a vector goes. It lifts by 6 mm first, goes no
/// further than 20 mm, no faster than 30 mm/s, and ends where it began, in half a minute. Whatever
/// the arm speaks, no packet makes it hang or lose its pose. Playback and write speeds are those of
/// power-up afterwards. After an error the arm stays where it is, with the settings that it has.
///
/// ```
/// use dobot_session::{Detection, DetectionError};
/// use dobot_wire::Status;
///
/// // Stretched out to its limit there is no room.
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
    /// The arm as each dialect has it.
    models: [Model; 2],
    to_send: Option<Packet>,
    answers: Vec<Measurement>,
    outcome: Option<Result<Finding, DetectionError>>,
    over: bool,
}

/// Why no dialect was found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DetectionError {
    /// The motions would leave the limits of the arm or what is allowed; nothing was sent.
    #[error(
        "there is no room for the motions, within 20 mm of the arm: {why}; bring it to about 220, 0, 20 mm, clear of everything, and try again"
    )]
    NoRoom {
        /// What is in the way.
        why: String,
    },
    /// The arm moves already, or somebody else moves it.
    #[error("the arm is not at rest; wait until it is, and let nobody else move it meanwhile")]
    Moving,
    /// The arm does not obey.
    #[error("the arm did not move within {} s, though it was sent a motion three times", PATIENCE.as_secs())]
    DidNotMove,
    /// A motion ended where no dialect has it end.
    #[error(
        "the arm came to rest {off_mm:.2} mm from where the motion leads; is something in its way, or has it lost its pose?"
    )]
    Elsewhere {
        /// How far off, in millimetres.
        off_mm: f64,
    },
    /// What was seen fits both dialects, or none.
    #[error("{question} is not clear: {saw}; try again, with nothing else on the line")]
    Unclear {
        /// What was asked.
        question: &'static str,
        /// What was seen.
        saw: String,
    },
    /// The answers are those of different dialects.
    #[error("the arm speaks a dialect that is none: {}; none is chosen", .0.join("; "))]
    Mixed(Vec<String>),
}

/// A packet that left, and what was seen since.
#[derive(Debug)]
struct Running {
    step: DetectionStep,
    sent: Duration,
    tries: u32,
    from: Status,
    /// What each dialect has the arm do.
    trajectories: Option<[Trajectory; 2]>,
    seen: Vec<(Duration, Status)>,
}

/// How far off each dialect is from what was seen, and how far they are apart.
#[derive(Clone, Copy, Debug)]
struct Measurement {
    question: Question,
    off: [f64; 2],
    apart: f64,
    /// What was seen, in the unit of the question.
    saw: f64,
}

impl Detection {
    /// Plans the motions for an arm at rest. `allowed` tells whether the arm may be somewhere; it is
    /// asked along all of the way, in either dialect.
    ///
    /// # Errors
    ///
    /// [`DetectionError::NoRoom`], with what is in the way and where to go instead.
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
            answers: Vec::new(),
            outcome: None,
            over: false,
        })
    }

    /// Takes a status; each is a permit for one packet.
    pub fn handle_status(&mut self, now: Duration, status: &Status) {
        if self.over {
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
            Ok(true) => self.go_on(now, status),
            Ok(false) => {}
            Err(Trouble::NotHeard) => self.repeat(now, status),
            Err(Trouble::Moving) => self.end(Err(DetectionError::Moving)),
        }
    }

    /// The packet to send now, if there is one: at most one for each status.
    pub fn poll_packet(&mut self) -> Option<Packet> {
        self.to_send.take()
    }

    /// What was found, once, when it is over.
    pub fn poll_outcome(&mut self) -> Option<Result<Finding, DetectionError>> {
        self.outcome.take()
    }

    /// A step is over: what does it tell? Then the next one.
    fn go_on(&mut self, now: Duration, status: &Status) {
        if let Some(running) = self.running.take() {
            match running.answer() {
                Ok(answer) => self.answers.extend(answer),
                Err(error) => return self.end(Err(error)),
            }
            for model in &mut self.models {
                *model = told(model, &running.step);
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

    /// Sends a motion again that the arm did not begin: it stands where it stood.
    fn repeat(&mut self, now: Duration, status: &Status) {
        match self.running.take() {
            Some(running) if running.tries + 1 < TRIES => {
                self.start(running.step, now, status, running.tries + 1);
            }
            _ => self.end(Err(DetectionError::DidNotMove)),
        }
    }

    fn end(&mut self, outcome: Result<Finding, DetectionError>) {
        self.over = true;
        self.outcome = Some(outcome);
    }

    fn find(&self) -> Result<Finding, DetectionError> {
        let evidence: Vec<Evidence> = Question::ALL
            .into_iter()
            .map(|question| self.evidence(question))
            .collect::<Result<_, _>>()?;
        let dialect = evidence[0].means;
        if evidence.iter().any(|it| it.means != dialect) {
            let lines = evidence.iter().map(ToString::to_string).collect();
            return Err(DetectionError::Mixed(lines));
        }
        Ok(Finding { dialect, evidence })
    }

    /// All answers to a question must be those of one dialect, and of no other.
    fn evidence(&self, question: Question) -> Result<Evidence, DetectionError> {
        let answers: Vec<&Measurement> = self
            .answers
            .iter()
            .filter(|it| it.question == question)
            .collect();
        let saw = words(question, &answers);
        let fits = |dialect: usize| {
            let near = question.near();
            let clear = |it: &&Measurement| it.apart > 2.0 * near && it.off[dialect] <= near;
            !answers.is_empty() && answers.iter().all(clear)
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
    /// Whether the step is over.
    fn progress(&self, now: Duration) -> Result<bool, Trouble> {
        if !self.step.moves {
            let moved = self.seen.iter().any(|(_, it)| !is_same(it, &self.from));
            return if moved {
                Err(Trouble::Moving)
            } else {
                Ok(self.seen.len() >= SETTLED)
            };
        }
        let rests = self.seen.len() >= AT_REST
            && self.seen[self.seen.len() - AT_REST..]
                .windows(2)
                .all(|it| is_same(&it[0].1, &it[1].1));
        let begun = self.seen.iter().any(|(_, it)| !is_same(it, &self.from));
        if !begun && now.saturating_sub(self.sent) > PATIENCE {
            return Err(Trouble::NotHeard);
        }
        Ok(rests && begun)
    }

    /// What the motion tells, or why it tells nothing.
    fn answer(&self) -> Result<Option<Measurement>, DetectionError> {
        let (Some(trajectories), Some((_, last))) = (&self.trajectories, self.seen.last()) else {
            return Ok(None);
        };
        if !self.step.moves {
            return Ok(None);
        }
        let found = position(last);
        let off_end = trajectories.each_ref().map(|it| end(it).distance(found).0);
        let nearest = off_end[0].min(off_end[1]);
        if nearest > END_MM {
            return Err(DetectionError::Elsewhere { off_mm: nearest });
        }
        Ok(self.step.question.map(|question| {
            let [one, other] = trajectories;
            let duration_s = |it: &Trajectory| it.motion_s().unwrap_or_default();
            let took_s = took_s(self.sent, &self.seen) - ON_THE_LINE_S;
            let (off, apart, saw) = match question {
                Question::Modes => (
                    trajectories.each_ref().map(|it| off_way_mm(it, &self.seen)),
                    apart_mm(one, other),
                    0.0,
                ),
                Question::Percentages => (
                    trajectories
                        .each_ref()
                        .map(|it| (took_s - duration_s(it)).abs()),
                    (duration_s(one) - duration_s(other)).abs(),
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
    /// As near as this to what a dialect has the arm do fits it, in millimetres or seconds.
    const fn near(self) -> f64 {
        match self {
            Self::Modes => 0.03,
            Self::Percentages | Self::WriteX => 0.3,
        }
    }
}

enum Trouble {
    NotHeard,
    Moving,
}

/// Follows all steps by a model, and looks whether the arm may go there.
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
        for index in 0..=LOOKS {
            let t_s = motion_s * f64::from(index) / f64::from(LOOKS);
            let place = trajectory.place_at(t_s).map_err(|it| no_room(it.into()))?;
            if !allowed(&place.joints) {
                let Position { x, y, z } = place.pose.position;
                return Err(DetectionError::NoRoom {
                    why: format!("{:.1}, {:.1}, {:.1} mm is not allowed", x.0, y.0, z.0),
                });
            }
        }
        model = told(&model, step);
    }
    Ok(())
}

fn command(model: &Model, step: &DetectionStep) -> Result<Command, TrajectoryError> {
    Command::parse(&step.frame.into(), &model.dialect).map_err(TrajectoryError::Invalid)
}

fn trajectory(model: &Model, step: &DetectionStep) -> Result<Trajectory, TrajectoryError> {
    model.trajectory(&command(model, step)?)
}

/// The model behind a step.
fn told(model: &Model, step: &DetectionStep) -> Model {
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
    place.map_or(Position::default(), |it| it.pose.position)
}

/// What was seen, in words.
fn words(question: Question, answers: &[&Measurement]) -> String {
    let most = |dialect: usize| answers.iter().map(|it| it.off[dialect]).fold(0.0, f64::max);
    let saw: Vec<f64> = answers.iter().map(|it| it.saw).collect();
    match question {
        Question::Modes => format!(
            "the ways are up to {:.3} mm off those with 1 straight, {:.3} mm off those with 2 straight",
            most(0),
            most(1)
        ),
        Question::Percentages => format!(
            "with 10 and 100 % a way took {:.2} s",
            saw.first().copied().unwrap_or_default()
        ),
        Question::WriteX => format!(
            "2 and -2 in float 3 led {:.2} and {:.2} mm along X",
            saw.first().copied().unwrap_or_default(),
            saw.get(1).copied().unwrap_or_default()
        ),
    }
}

/// Whether two statuses tell of the same place.
fn is_same(one: &Status, other: &Status) -> bool {
    position(one).distance(position(other)).0 < SAME_MM
}

/// A damaged status may be off by 0.01 mm (note N23).
const SAME_MM: f64 = 0.02;
const END_MM: f64 = 0.3;
/// Statuses that say the same: the arm rests.
const AT_REST: usize = 4;
/// Statuses by which a configuration has acted.
const SETTLED: usize = 2;
const TRIES: u32 = 3;
const PATIENCE: Duration = Duration::from_secs(3);
/// A packet each way, half a tick, and half a period until the next status.
const ON_THE_LINE_S: f64 = 0.14;
/// Places of each way that are looked at.
const LOOKS: u32 = 50;
