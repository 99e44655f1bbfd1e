//! When a command is over: the protocol has no "done", so it is read off the statuses.
//!
//! Each command sent has a course: where it should lead. A status lies on one of the courses under
//! way; all before that one are over. An arm at rest where a course ends has finished it, and an
//! arm at rest elsewhere has not.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_arm::{Joints, Position, Tool, forward};
use dobot_wire::{Command, Configuration, EndEffector, MoveJoints, MoveTo, MovingMode, Status};

use crate::CommandId;

/// The commands sent and not yet seen to be over, oldest first.
#[derive(Debug, Default)]
pub(crate) struct Completion {
    under_way: VecDeque<UnderWay>,
    /// How far along the first straight course the arm was seen, so that it never goes back on it.
    progress_mm: f64,
    last: Option<Seen>,
    tool: Tool,
}

/// What became of a command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Outcome {
    Completed(CommandId),
    NotReached {
        command: CommandId,
        expected: Position,
        found: Position,
    },
}

/// The last status, and since when all its values are the same.
#[derive(Clone, Copy, Debug)]
struct Seen {
    status: Status,
    since: Duration,
    /// How many statuses in a row said the same.
    repeats: u32,
}

#[derive(Clone, Copy, Debug)]
struct UnderWay {
    command: CommandId,
    course: Course,
    pause: Duration,
    sent: Duration,
    /// Statuses received since it was sent, or since it became the first.
    statuses: u32,
}

#[derive(Clone, Copy, Debug)]
enum Course {
    /// On a straight line.
    Line { from: Position, to: Position },
    /// On some way, of which only the end is known.
    To { to: Position },
    /// No motion, or one whose end nobody knows; `to` is where the arm is then, if that is known.
    Open { to: Option<Position> },
}

impl Completion {
    /// Takes a command that leaves with the status of `now`.
    pub(crate) fn handle_sent(&mut self, now: Duration, id: CommandId, command: &Command) {
        let course = self.course(command);
        self.under_way.push_back(UnderWay {
            command: id,
            course,
            pause: pause(command),
            sent: now,
            statuses: 0,
        });
    }

    pub(crate) fn handle_status(
        &mut self,
        now: Duration,
        status: &Status,
        mut report: impl FnMut(Outcome),
    ) {
        self.see(now, status);
        for under_way in &mut self.under_way {
            under_way.statuses += 1;
        }
        let found = position(status);
        let (on_course, progress_mm) = self.on_course(found);
        let over = on_course
            .max(self.over_at_rest(now, found))
            .max(self.instant());
        for _ in 0..over {
            let Some(first) = self.finish_first() else {
                break;
            };
            report(Outcome::Completed(first.command));
        }
        if over == on_course {
            self.progress_mm = progress_mm;
        }
        if over == 0
            && let Some((expected, first)) = self.not_reached(now, found)
        {
            self.finish_first();
            self.forget_ends();
            report(Outcome::NotReached {
                command: first,
                expected,
                found,
            });
        }
    }

    /// The tool that was set last.
    pub(crate) const fn tool(&self) -> Tool {
        self.tool
    }

    pub(crate) fn len(&self) -> usize {
        self.under_way.len()
    }

    /// How long the commands under way may take at the most before the arm has room for another:
    /// a full queue keeps an arm silent for just that long (note N20).
    pub(crate) fn longest_silence(&self) -> Duration {
        self.under_way.iter().map(UnderWay::longest).sum()
    }

    fn see(&mut self, now: Duration, status: &Status) {
        self.last = match self.last {
            Some(seen) if seen.status == *status => Some(Seen {
                repeats: seen.repeats + 1,
                ..seen
            }),
            _ => Some(Seen {
                status: *status,
                since: now,
                repeats: 1,
            }),
        };
    }

    /// How many commands lie before the one that the arm is seen to follow, and how far along it.
    fn on_course(&self, found: Position) -> (usize, f64) {
        for (index, under_way) in self.under_way.iter().enumerate() {
            let Course::Line { from, to } = under_way.course else {
                continue;
            };
            let (aside, along) = beside(from, to, found);
            let back = index == 0 && along < self.progress_mm - ARRIVED_MM;
            // The start of a later course may be the end of an earlier one, passed again and again.
            let begun = index == 0 || along > ARRIVED_MM;
            if aside <= ARRIVED_MM && begun && !back {
                return (index, along);
            }
        }
        (0, self.progress_mm)
    }

    /// How many commands without a motion to be seen had time to act.
    fn instant(&self) -> usize {
        self.under_way
            .iter()
            .take_while(|it| matches!(it.course, Course::Open { .. }) && it.statuses >= SEEN_AFTER)
            .count()
    }

    /// How many commands are over because the arm rests where the last of them ends.
    fn over_at_rest(&self, now: Duration, found: Position) -> usize {
        let Some(seen) = self.last.filter(|seen| seen.repeats >= AT_REST) else {
            return 0;
        };
        let mut pauses = Duration::ZERO;
        let mut over = 0;
        for (index, under_way) in self.under_way.iter().enumerate() {
            pauses += under_way.pause;
            let ended = under_way
                .end()
                .is_some_and(|end| end.distance(found).0 <= ARRIVED_MM);
            // A later command may lead back to where the arm has stood all the time.
            let went = index == 0 || seen.since > under_way.sent || seen.repeats >= GIVEN_UP;
            let paused = now.saturating_sub(seen.since) >= pauses;
            if under_way.statuses >= SEEN_AFTER && ended && went && paused {
                over = index + 1;
            }
        }
        over
    }

    /// The first command and its end, if the arm rests elsewhere for so long that it gave up.
    fn not_reached(&self, now: Duration, found: Position) -> Option<(Position, CommandId)> {
        let seen = self.last.filter(|seen| seen.repeats >= GIVEN_UP)?;
        let first = self
            .under_way
            .front()
            .filter(|it| it.statuses >= GIVEN_UP)?;
        let pauses: Duration = self.under_way.iter().map(|it| it.pause).sum();
        let end = first.end()?;
        let elsewhere = end.distance(found).0 > ARRIVED_MM;
        (elsewhere && now.saturating_sub(seen.since) >= pauses).then_some((end, first.command))
    }

    fn finish_first(&mut self) -> Option<UnderWay> {
        self.progress_mm = 0.0;
        let first = self.under_way.pop_front()?;
        if let Some(next) = self.under_way.front_mut() {
            next.statuses = next.statuses.min(1);
        }
        Some(first)
    }

    /// After a command fell short, nobody knows where the relative ones behind it lead.
    fn forget_ends(&mut self) {
        for under_way in &mut self.under_way {
            under_way.course = Course::Open { to: None };
        }
    }

    /// Where the arm will be after all that was sent.
    pub(crate) fn end(&self) -> Option<Position> {
        match self.under_way.back() {
            Some(last) => last.end(),
            None => self.last.map(|seen| position(&seen.status)),
        }
    }

    fn course(&mut self, command: &Command) -> Course {
        let from = self.end();
        match command {
            Command::WriteVector(it) if !it.stop => {
                let by = Position::new(it.x_mm.into(), it.y_mm.into(), it.z_mm.into());
                line(from, from.map(|from| from + by))
            }
            Command::MoveTo(it) => way(it.mode, from, point(it)),
            Command::MoveJoints(it) => way(it.mode, from, place(it, self.tool)),
            Command::Configuration(Configuration::InitialAngles { rear_deg, fore_deg }) => {
                let joints = Joints::new(0.0, (*rear_deg).into(), (*fore_deg).into(), 0.0);
                Course::Open {
                    to: Some(forward(&joints, self.tool).position),
                }
            }
            Command::Configuration(Configuration::EndEffector { tool }) => {
                let before = self.tool;
                self.tool = match tool {
                    EndEffector::SuctionCup => Tool::SuctionCup,
                    EndEffector::Gripper => Tool::Gripper,
                    EndEffector::Laser => Tool::Laser,
                };
                Course::Open {
                    to: from.map(|from| retooled(from, before, self.tool)),
                }
            }
            Command::Configuration(_)
            | Command::PlaybackAdjustment(_)
            | Command::WriteVector(_) => Course::Open { to: from },
            _ => Course::Open { to: None },
        }
    }
}

impl UnderWay {
    const fn end(&self) -> Option<Position> {
        match self.course {
            Course::Line { to, .. } | Course::To { to } => Some(to),
            Course::Open { to } => to,
        }
    }

    fn longest(&self) -> Duration {
        let way_mm = match self.course {
            Course::Line { from, to } => from.distance(to).0,
            Course::To { .. } => LONGEST_WAY_MM,
            Course::Open { .. } => 0.0,
        };
        self.pause + Duration::from_secs_f64(way_mm / SLOWEST_MM_S) + Duration::from_secs(1)
    }
}

/// Where a command leads straight, if it says so.
pub(crate) fn straight_target(command: &Command, tool: Tool) -> Option<Position> {
    match command {
        Command::MoveTo(it) if it.mode == MovingMode::MovL => Some(point(it)),
        Command::MoveJoints(it) if it.mode == MovingMode::MovL => Some(place(it, tool)),
        _ => None,
    }
}

/// The position in a status.
pub(crate) fn position(status: &Status) -> Position {
    Position::new(status.x_mm.into(), status.y_mm.into(), status.z_mm.into())
}

const fn line(from: Option<Position>, to: Option<Position>) -> Course {
    match (from, to) {
        (Some(from), Some(to)) => Course::Line { from, to },
        _ => Course::Open { to: None },
    }
}

fn point(target: &MoveTo) -> Position {
    Position::new(target.x_mm.into(), target.y_mm.into(), target.z_mm.into())
}

fn place(target: &MoveJoints, tool: Tool) -> Position {
    let joints = [target.base_deg, target.rear_deg, target.fore_deg].map(f64::from);
    forward(&Joints::new(joints[0], joints[1], joints[2], 0.0), tool).position
}

fn way(mode: MovingMode, from: Option<Position>, to: Position) -> Course {
    match (mode, from) {
        (MovingMode::MovL, Some(from)) => Course::Line { from, to },
        _ => Course::To { to },
    }
}

fn pause(command: &Command) -> Duration {
    let pause_s = match command {
        Command::MoveTo(it) => it.pause_s,
        Command::MoveJoints(it) => it.pause_s,
        _ => 0.0,
    };
    Duration::try_from_secs_f32(pause_s).unwrap_or_default()
}

/// How far a point lies aside of a line, and how far along it, in millimetres.
fn beside(from: Position, to: Position, point: Position) -> (f64, f64) {
    let length_mm = from.distance(to).0;
    if length_mm == 0.0 {
        return (point.distance(from).0, 0.0);
    }
    let (way, part) = (to - from, point - from);
    let dot = way.x.0 * part.x.0 + way.y.0 * part.y.0 + way.z.0 * part.z.0;
    let along_mm = (dot / length_mm).clamp(0.0, length_mm);
    let foot = from + way * (along_mm / length_mm);
    (point.distance(foot).0, along_mm)
}

/// The same joint angles with another tool: the position moves along the reach.
fn retooled(position: Position, before: Tool, after: Tool) -> Position {
    let reach_mm = position.reach().0;
    let factor = (reach_mm + after.reach().0 - before.reach().0) / reach_mm;
    Position {
        x: position.x * factor,
        y: position.y * factor,
        z: position.z,
    }
}

/// As near as this counts as arrived: a status agrees with the target to 0.01 mm on a stock arm.
const ARRIVED_MM: f64 = 0.05;
/// A command acts at the earliest in the second status after it was sent.
const SEEN_AFTER: u32 = 2;
/// That many equal statuses in a row: the arm is at rest.
const AT_REST: u32 = 2;
/// That many equal statuses in a row, more than a second: the arm will not go on by itself.
const GIVEN_UP: u32 = 15;
/// Nobody moves slower than that on purpose.
const SLOWEST_MM_S: f64 = 2.0;
/// Across the whole workspace.
const LONGEST_WAY_MM: f64 = 700.0;
