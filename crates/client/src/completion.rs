//! When a command is over: the protocol has no "done", so it is read off the statuses.
//!
//! Each command sent has a course: where it should lead. A status lies on one of the courses under
//! way; all before that one are over. An arm at rest where a course ends has finished it, and an
//! arm at rest elsewhere has not. And a status comes only while the arm's queue has room, so that
//! no more commands can be under way than fit before that.

mod geometry;

use std::collections::VecDeque;
use std::time::Duration;

use dobot_arm::{Joints, Position, Tool, forward, stock};
use dobot_wire::{
    Command, Configuration, Dialect, EndEffector, JointJogAxis, LinearJogAxis, MoveJoints, MoveTo,
    MovingMode, Status, WriteVector,
};

use self::geometry::{beside, is_at_limit, retooled};
use crate::pace::Pace;
use crate::{CommandId, Event, NotReached};

/// The commands sent and not yet seen to be over, oldest first.
#[derive(Clone, Debug, Default)]
pub(crate) struct Completion {
    under_way: VecDeque<UnderWay>,
    /// How far along the first straight course the arm was seen, so that it never goes back on it.
    progress_mm: f64,
    last: Option<Seen>,
    /// Since when the first command is the first.
    first_since: Duration,
    tool: Tool,
    pace: Pace,
}

/// The last status, and since when all its values are the same.
#[derive(Clone, Copy, Debug)]
struct Seen {
    status: Status,
    since: Duration,
    /// How many statuses in a row said the same.
    repeats: u32,
    /// The arm was elsewhere one status before.
    moving: bool,
}

#[derive(Clone, Copy, Debug)]
struct UnderWay {
    command: CommandId,
    course: Course,
    /// It says itself where it leads, from wherever.
    absolute: bool,
    pause: Duration,
    /// How long it may move at the most.
    longest: Duration,
    /// Whether its way leaves the limits of the arm, as far as that can be foreseen.
    leaves_limits: bool,
    sent: Duration,
    /// Statuses received since it was sent.
    heard: u32,
    /// Statuses received since it was sent, or since it became the first.
    statuses: u32,
}

#[derive(Clone, Copy, Debug)]
enum Course {
    /// On a straight line.
    Line { from: Position, to: Position },
    /// On some way, of which only the end is known.
    To { to: Position },
    /// On some way to an end that nobody knows.
    Somewhere,
    /// No motion, or one that goes on; `to` is where the arm is then, if that is known.
    Still { to: Option<Position> },
}

impl Completion {
    /// Takes a command that leaves with the status of `now`; `leaves_limits` tells whether
    /// its way leaves the limits. Returns how long it may take at the most.
    pub(crate) fn handle_sent(
        &mut self,
        now: Duration,
        id: CommandId,
        command: &Command,
        dialect: &Dialect,
        leaves_limits: bool,
    ) -> Duration {
        let course = self.course(command, dialect);
        self.pace.note(command);
        let (pause, longest) = (
            self.pause(command, dialect.uses_default_pause),
            self.pace.longest(command),
        );
        self.under_way.push_back(UnderWay {
            command: id,
            course,
            absolute: is_absolute(command),
            pause,
            longest,
            leaves_limits,
            sent: now,
            heard: 0,
            statuses: 0,
        });
        if self.under_way.len() == 1 {
            self.first_since = now;
        }
        pause + longest
    }

    pub(crate) fn handle_status(
        &mut self,
        now: Duration,
        status: &Status,
        mut report: impl FnMut(Event),
    ) {
        let left = self.left_its_end(status);
        self.see(now, status);
        for under_way in &mut self.under_way {
            under_way.heard += 1;
            under_way.statuses += 1;
        }
        let found = position(status);
        let (on_course, progress_mm) = self.on_course(found);
        let over = on_course
            .max(usize::from(left))
            .max(self.over_at_rest(now, found))
            .max(self.without_motion())
            .max(self.beyond_room(now));
        for _ in 0..over {
            let Some(first) = self.finish_first() else {
                break;
            };
            report(Event::Completed(first.command));
        }
        if over == on_course {
            self.progress_mm = progress_mm;
        }
        if over > 0 {
            self.first_since = now;
        } else if let Some((expected, command, reason)) = self
            .not_reached(now, status)
            .or_else(|| self.timed_out(now))
        {
            self.finish_first();
            self.first_since = now;
            self.forget_ends();
            report(Event::NotReached {
                command,
                reason,
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
        let longest = |it: &UnderWay| it.pause + it.longest;
        self.under_way.iter().map(longest).sum()
    }

    fn see(&mut self, now: Duration, status: &Status) {
        self.last = Some(match self.last {
            Some(seen) if seen.status == *status => Seen {
                repeats: seen.repeats + 1,
                moving: false,
                ..seen
            },
            before => Seen {
                status: *status,
                since: now,
                repeats: 1,
                moving: before.is_some_and(|it| position(&it.status) != position(status)),
            },
        });
    }

    /// Whether the arm has rested where the first command ends, and goes on now.
    fn left_its_end(&self, status: &Status) -> bool {
        let rested = |seen: &Seen| seen.repeats >= AT_REST && seen.status != *status;
        let (Some(seen), Some(first)) = (self.last.filter(rested), self.under_way.front()) else {
            return false;
        };
        first.statuses >= SEEN_AFTER
            && seen.since > first.sent
            && first.ends_at(position(&seen.status))
    }

    /// How many commands must be over because the arm has room again: a status comes only while
    /// three commands wait at the most, and one is executed (note N20).
    fn beyond_room(&self, now: Duration) -> usize {
        let arrived =
            |it: &&UnderWay| it.heard >= SEEN_AFTER && now.saturating_sub(it.sent) >= ARRIVED_AFTER;
        let arrived = self.under_way.iter().take_while(arrived).count();
        arrived.saturating_sub(MOST_WITH_ROOM)
    }

    /// How many commands lie before the one that the arm is seen to follow, and how far along it.
    fn on_course(&self, found: Position) -> (usize, f64) {
        for (index, under_way) in self.under_way.iter().enumerate() {
            let (from, to) = match under_way.course {
                Course::Line { from, to } => (from, to),
                Course::Still { .. } => continue,
                // An unknown way may cross those behind it.
                Course::To { .. } | Course::Somewhere => break,
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

    /// How many commands without a motion had time to act.
    fn without_motion(&self) -> usize {
        self.under_way
            .iter()
            .take_while(|it| matches!(it.course, Course::Still { .. }) && it.statuses >= SEEN_AFTER)
            .count()
    }

    /// How many commands are over because the arm rests where the last of them ends.
    fn over_at_rest(&self, now: Duration, found: Position) -> usize {
        let Some(seen) = self.last.filter(|seen| seen.repeats >= AT_REST) else {
            return 0;
        };
        // The pauses that are spent right here.
        let mut pauses = Duration::ZERO;
        let mut over = 0;
        for (index, under_way) in self.under_way.iter().enumerate() {
            let ends = match under_way.course {
                Course::Somewhere if index == 0 => seen.repeats > AT_REST,
                // A rest that no other command explains.
                Course::Somewhere => seen.repeats >= GIVEN_UP && !self.any_ends_at(found),
                _ => under_way.ends_at(found),
            };
            if !ends {
                pauses = Duration::ZERO;
                continue;
            }
            pauses += under_way.pause;
            // A later command may lead back to where the arm has stood all the time.
            let went = index == 0 || seen.since > under_way.sent || seen.repeats >= GIVEN_UP;
            let paused = now.saturating_sub(seen.since) >= pauses;
            if under_way.statuses < SEEN_AFTER || !went || !paused {
                // It explains why the arm rests here: those behind it have to wait.
                break;
            }
            over = index + 1;
        }
        over
    }

    /// The first command and its end, if the arm rests elsewhere for so long that it gave up.
    /// Statuses that come in a heap, after the computer stood still, tell of a time before.
    fn not_reached(
        &self,
        now: Duration,
        status: &Status,
    ) -> Option<(Position, CommandId, NotReached)> {
        self.last.filter(|seen| seen.repeats >= GIVEN_UP)?;
        let first = self
            .under_way
            .front()
            .filter(|it| it.statuses >= GIVEN_UP)?;
        if now.saturating_sub(first.sent.max(self.first_since)) < GIVEN_UP_AFTER {
            return None;
        }
        let end = first.end()?;
        let reason = if first.leaves_limits || is_at_limit(status, self.tool) {
            NotReached::AtLimit
        } else {
            NotReached::Stalled
        };
        // Where another one ends the arm may be pausing.
        (!self.any_ends_at(position(status))).then_some((end, first.command, reason))
    }

    /// The first command and its end, if it and all behind it would be over for long: that it is
    /// over itself need not have been seen while the arm moves on.
    fn timed_out(&self, now: Duration) -> Option<(Position, CommandId, NotReached)> {
        let first = self.under_way.front()?;
        let most = self.longest_silence() * 2 + PATIENCE;
        let waited = now.saturating_sub(self.first_since);
        (waited > most).then_some((first.end()?, first.command, NotReached::TimedOut))
    }

    fn any_ends_at(&self, found: Position) -> bool {
        self.under_way.iter().any(|it| it.ends_at(found))
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
            under_way.course = match under_way.course {
                Course::Line { to, .. } if under_way.absolute => Course::To { to },
                Course::Line { .. } => Course::Somewhere,
                Course::Still { .. } if !under_way.absolute => Course::Still { to: None },
                course => course,
            };
        }
    }

    /// Where the arm will be after all that was sent.
    pub(crate) fn end(&self) -> Option<Position> {
        match self.under_way.back() {
            Some(last) => last.end(),
            None => self
                .last
                .filter(|seen| !seen.moving)
                .map(|seen| position(&seen.status)),
        }
    }

    /// Where a vector leads: exactly so far, or to where a stock arm takes itself to be then.
    #[expect(clippy::cast_possible_truncation, reason = "as the arm calculates")]
    fn behind(&self, from: Position, vector: &WriteVector, dialect: &Dialect) -> Position {
        let way = [vector.x_mm, vector.y_mm, vector.z_mm];
        if dialect.uses_start_speed {
            let [x, y, z] = way.map(f64::from);
            return from + Position::new(x, y, z);
        }
        let from = [from.x, from.y, from.z].map(|it| it.0);
        let [x, y, z] = stock::behind(from, way, self.tool.reach().0 as f32);
        Position::new(x, y, z)
    }

    fn pause(&self, command: &Command, pauses: bool) -> Duration {
        let pause_s = match command {
            Command::MoveTo(it) => it.pause_s,
            Command::MoveJoints(it) => it.pause_s,
            _ => return Duration::ZERO,
        };
        if pauses && pause_s == 0.0 {
            return self.pace.default_pause();
        }
        Duration::try_from_secs_f32(pause_s).unwrap_or_default()
    }

    fn course(&mut self, command: &Command, dialect: &Dialect) -> Course {
        let from = self.end();
        match command {
            Command::WriteVector(it) if !it.stop => {
                line(from, from.map(|from| self.behind(from, it, dialect)))
            }
            Command::MoveTo(it) => way(it.mode, from, point(it)),
            Command::MoveJoints(it) => way(it.mode, from, place(it, self.tool)),
            Command::Configuration(Configuration::InitialAngles { rear_deg, fore_deg }) => {
                let joints = Joints::new(0.0, (*rear_deg).into(), (*fore_deg).into(), 0.0);
                Course::Still {
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
                Course::Still {
                    to: from.map(|from| retooled(from, before, self.tool)),
                }
            }
            Command::Configuration(_)
            | Command::PlaybackAdjustment(_)
            | Command::WriteVector(_) => Course::Still { to: from },
            Command::JointJog(it) => match it.axis {
                JointJogAxis::Released => Course::Somewhere,
                axis if axis.moves() => Course::Still { to: None },
                _ => Course::Still { to: from },
            },
            Command::LinearJog(it) => match it.axis {
                LinearJogAxis::Released => Course::Somewhere,
                axis if axis.moves() => Course::Still { to: None },
                _ => Course::Still { to: from },
            },
            Command::MouseMove(_) | Command::Gesture(_) | Command::Voice(_) => Course::Somewhere,
        }
    }
}

impl UnderWay {
    const fn end(&self) -> Option<Position> {
        match self.course {
            Course::Line { to, .. } | Course::To { to } => Some(to),
            Course::Still { to } => to,
            Course::Somewhere => None,
        }
    }

    fn ends_at(&self, found: Position) -> bool {
        self.end()
            .is_some_and(|end| end.distance(found).0 <= ARRIVED_MM)
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

/// Where the tool is by a status.
#[must_use]
pub fn position(status: &Status) -> Position {
    Position::new(status.x_mm.into(), status.y_mm.into(), status.z_mm.into())
}

const fn line(from: Option<Position>, to: Option<Position>) -> Course {
    match (from, to) {
        (Some(from), Some(to)) => Course::Line { from, to },
        _ => Course::Somewhere,
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

const fn is_absolute(command: &Command) -> bool {
    matches!(
        command,
        Command::MoveTo(_)
            | Command::MoveJoints(_)
            | Command::Configuration(Configuration::InitialAngles { .. })
    )
}

/// As near as this counts as arrived: a status agrees with the target to 0.01 mm on a stock arm.
const ARRIVED_MM: f64 = 0.05;
/// A command acts at the earliest in the second status after it was sent.
const SEEN_AFTER: u32 = 2;
/// That many equal statuses in a row: the arm is at rest.
const AT_REST: u32 = 2;
/// That many equal statuses in a row, more than a second: the arm will not go on by itself.
const GIVEN_UP: u32 = 15;
/// The time in which they come.
const GIVEN_UP_AFTER: Duration = Duration::from_secs(1);
/// Longer than the slowest motion, and not over.
const PATIENCE: Duration = Duration::from_secs(10);
/// By then a command has arrived that left with a status, and a status has come that left after
/// that: each takes 43.68 ms, and a bit.
const ARRIVED_AFTER: Duration = Duration::from_millis(120);
/// Three commands that wait and one that is executed: with one more no status comes.
const MOST_WITH_ROOM: usize = 4;
