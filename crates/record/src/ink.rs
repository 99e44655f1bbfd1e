//! The lines that the tool has drawn or burned, in pieces.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_arm::Position;
use dobot_motion::Trajectory;
use serde_json::{Value, json};

use crate::scene::{color, entity, line, points, removal, sphere};

/// The lines that the tool has drawn or burned, cut into pieces; each piece is reported once and
/// never changes. The newest ones are kept; when there are too many, the oldest are removed.
#[derive(Debug, Default)]
pub(crate) struct Ink {
    /// The line that is still growing.
    open: Option<Line>,
    kept: VecDeque<Piece>,
    /// The number of points of the kept pieces.
    kept_points: usize,
    /// The number of the newest pieces that are not reported yet.
    unreported: usize,
    /// Reported pieces that were removed.
    gone: Vec<u64>,
    count: u64,
}

/// A growing line, as far as it is not part of a piece.
#[derive(Debug)]
struct Line {
    points_mm: Vec<Position>,
    /// The time at its second point.
    since: Option<Duration>,
    burns: bool,
    /// Whether it becomes a dot if the pen is lifted now.
    is_dot: bool,
}

/// A piece of a line, reported as a unit.
#[derive(Debug)]
struct Piece {
    number: u64,
    points_mm: Vec<Position>,
    burns: bool,
}

impl Ink {
    /// Handles a finished move, by a vector or not; a pen draws below a height. A pen draws a move
    /// between two places below it, and a dot if one vector lowers it and the next one lifts it; a
    /// laser burns while it is on.
    pub(crate) fn draw(
        &mut self,
        at: Duration,
        way: &Trajectory,
        is_vector: bool,
        pen_below_mm: Option<f64>,
    ) {
        let is_low = |place: Position| pen_below_mm.is_some_and(|below_mm| place.z.0 < below_mm);
        let Ok(from) = way.place_at(0.0) else {
            return self.end_line();
        };
        let mut last = from.pose.position;
        for (place, _) in way.corners() {
            let place = place.pose.position;
            if way.laser() || is_low(last) && is_low(place) {
                self.line_to(at, last, place, way.laser());
            } else {
                self.end_line();
                self.open = is_low(place).then(|| Line::begin(place, false, is_vector));
            }
            last = place;
        }
        if self.open.as_ref().is_some_and(|open| open.is_full(at)) {
            self.cut();
        }
    }

    /// Handles a jump of the tool to another place.
    pub(crate) fn end_line(&mut self) {
        self.cut();
        self.open = None;
    }

    /// Handles time: a growing line is reported now and then.
    pub(crate) fn handle_time(&mut self, at: Duration) {
        if self.open.as_ref().is_some_and(|open| open.is_due(at)) {
            self.cut();
        }
    }

    /// The changes, if there are any.
    pub(crate) fn poll(&mut self, time: &Value, tip_mm: f64) -> Option<Value> {
        if self.unreported == 0 && self.gone.is_empty() {
            return None;
        }
        let new = self.kept.len() - std::mem::take(&mut self.unreported);
        let entities = self
            .kept
            .range(new..)
            .map(|range| range.entity(time, tip_mm));
        let gone = std::mem::take(&mut self.gone);
        let deletions = gone.iter().map(|item| removal(time, &name(*item)));
        Some(json!({
            "deletions": deletions.collect::<Vec<_>>(),
            "entities": entities.collect::<Vec<_>>(),
        }))
    }

    /// All reported and kept pieces, for a late subscriber, in messages of moderate length.
    pub(crate) fn so_far(&self, time: &Value, tip_mm: f64) -> Vec<Value> {
        let reported = self.kept.len() - self.unreported;
        let mut messages = Vec::new();
        let (mut entities, mut count) = (Vec::new(), 0);
        for (n, piece) in self.kept.range(..reported).enumerate() {
            entities.push(piece.entity(time, tip_mm));
            count += piece.points_mm.len();
            if count >= MESSAGE_POINTS || n + 1 == reported {
                let entities = std::mem::take(&mut entities);
                messages.push(json!({ "deletions": [], "entities": entities }));
                count = 0;
            }
        }
        messages
    }

    fn line_to(&mut self, at: Duration, from: Position, to: Position, burns: bool) {
        let continues = |line: &Line| line.burns == burns && line.ends_at(from);
        if !self.open.as_ref().is_some_and(continues) {
            self.end_line();
        }
        let line = self
            .open
            .get_or_insert_with(|| Line::begin(from, burns, false));
        line.points_mm.push(to);
        line.since.get_or_insert(at);
    }

    /// Makes a piece of the growing line, which continues at its end.
    fn cut(&mut self) {
        let Some(line) = &mut self.open else {
            return;
        };
        if line.points_mm.len() < 2 && !line.is_dot {
            return;
        }
        let end = *line.points_mm.last().expect("a line begins with a point");
        let next = Line::begin(end, line.burns, false);
        let line = std::mem::replace(line, next);
        self.keep(line);
    }

    fn keep(&mut self, line: Line) {
        self.kept_points += line.points_mm.len();
        self.kept.push_back(Piece {
            number: self.count,
            points_mm: line.points_mm,
            burns: line.burns,
        });
        self.count += 1;
        self.unreported += 1;
        while self.kept_points > MAX_POINTS
            && let Some(oldest) = self.kept.pop_front()
        {
            self.kept_points -= oldest.points_mm.len();
            if self.kept.len() < self.unreported {
                self.unreported = self.kept.len();
            } else {
                self.gone.push(oldest.number);
            }
        }
    }
}

impl Line {
    fn begin(point: Position, burns: bool, is_dot: bool) -> Self {
        Self {
            points_mm: vec![point],
            since: None,
            burns,
            is_dot,
        }
    }

    fn ends_at(&self, point: Position) -> bool {
        let last = self.points_mm.last();
        last.is_some_and(|last| last.distance(point).0 <= SAME_MM)
    }

    fn is_full(&self, at: Duration) -> bool {
        self.points_mm.len() >= PIECE_POINTS || self.is_due(at)
    }

    fn is_due(&self, at: Duration) -> bool {
        let since = self.since.unwrap_or(at);
        at.saturating_sub(since) >= PIECE_PERIOD
    }
}

impl Piece {
    fn entity(&self, time: &Value, tip_mm: f64) -> Value {
        let color = color(if self.burns { BURN } else { INK });
        let places = points(&self.points_mm, tip_mm);
        let (lines, spheres) = match &places[..] {
            [dot] => (vec![], vec![sphere(dot, LINE_M * 2.0, &color)]),
            _ => (vec![line(&places, LINE_M, &color)], vec![]),
        };
        entity(time, &name(self.number), &lines, &spheres)
    }
}

fn name(number: u64) -> String {
    format!("ink {number}")
}

/// The largest number of kept points: about two hours at six vectors a second.
pub(crate) const MAX_POINTS: usize = 50_000;
const PIECE_POINTS: usize = 100;
/// The interval at which a growing line is reported.
const PIECE_PERIOD: Duration = Duration::from_secs(1);
/// The number of points per message for a late subscriber, plus those of one piece.
const MESSAGE_POINTS: usize = 2000;
/// A line continues at the end of the previous one.
const SAME_MM: f64 = 0.05;
const LINE_M: f64 = 0.0005;
/// The colours of ink and burns on the station's page.
const INK: u32 = 0x16_29_3f;
const BURN: u32 = 0x4a_2c_14;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_arm::{Joints, Tool};
    use dobot_motion::{ArmPlace, Model};
    use dobot_wire::{Command, Dialect, WriteVector};

    use super::*;

    /// An arm that draws vectors, each in a tenth of a second, with a pen that is lifted by 5 mm.
    struct Hand {
        model: Model,
        ink: Ink,
        at: Duration,
        below_mm: f64,
    }

    impl Hand {
        fn new() -> Self {
            let here = ArmPlace::at_joints(Joints::new(0.0, 45.0, 45.0, 0.0), Tool::SuctionCup);
            let below_mm = here.pose.position.z.0 - 2.5;
            Self {
                model: Model::standing(Dialect::SPECIFICATION, here),
                ink: Ink::default(),
                at: Duration::ZERO,
                below_mm,
            }
        }

        fn go(&mut self, x: f32, y: f32, z: f32) {
            let command = Command::from(WriteVector::by(x, y, z, 40.0));
            let way = self.model.trajectory(&command).unwrap();
            self.at += Duration::from_millis(100);
            self.ink.draw(self.at, &way, true, Some(self.below_mm));
            self.model = self.model.after(&command, &way);
        }

        fn reported(&mut self) -> Vec<Value> {
            let reported = self.ink.poll(&json!({}), 60.0);
            reported
                .into_iter()
                .flat_map(|item| item["entities"].as_array().unwrap().clone())
                .collect()
        }
    }

    fn lines(entities: &[Value]) -> Vec<usize> {
        let points = |value: &Value| value["lines"][0]["points"].as_array().map(Vec::len);
        entities.iter().filter_map(points).collect()
    }

    #[test]
    fn low_lines_are_ink_and_lifting_lowering_and_travelling_are_not() {
        let mut hand = Hand::new();
        hand.go(5.0, 0.0, 0.0);
        hand.go(0.0, 0.0, -5.0);
        hand.go(0.0, 4.0, 0.0);
        hand.go(4.0, 0.0, 0.0);
        hand.go(0.0, 0.0, 5.0);
        hand.go(0.0, 8.0, 0.0);
        let reported = hand.reported();
        assert_eq!(lines(&reported), [3]);
        let points = reported[0]["lines"][0]["points"].as_array().unwrap();
        let along = |n: usize, axis: &str| points[n][axis].as_f64().unwrap();
        assert!((along(1, "y") - along(0, "y") - 0.004).abs() < 1e-6);
        assert!((along(2, "x") - along(1, "x") - 0.004).abs() < 1e-6);
        // The tip is 60 mm below the wrist, which was 2.5 mm below the drawing height of the pen.
        let expected = (hand.below_mm - 2.5 - 60.0) / 1000.0;
        assert!((along(0, "z") - expected).abs() < 2e-6, "{}", along(0, "z"));
        assert_eq!(hand.reported(), [] as [Value; 0]);
    }

    #[test]
    fn a_pen_that_is_lowered_and_lifted_leaves_a_dot() {
        let mut hand = Hand::new();
        hand.go(0.0, 0.0, -5.0);
        hand.go(0.0, 0.0, 5.0);
        let reported = hand.reported();
        assert_eq!(reported[0]["spheres"].as_array().map(Vec::len), Some(1));
        assert_eq!(lines(&reported), [0; 0]);
    }

    #[test]
    fn a_long_line_is_reported_in_pieces_that_join() {
        let mut hand = Hand::new();
        hand.go(0.0, 0.0, -5.0);
        let mut pieces = Vec::new();
        for n in 0..50 {
            hand.go(0.0, if n % 20 < 10 { 1.0 } else { -1.0 }, 0.0);
            pieces.extend(hand.reported());
        }
        hand.go(0.0, 0.0, 5.0);
        pieces.extend(hand.reported());
        // One second each, of ten vectors.
        assert!((4..=6).contains(&pieces.len()), "{}", pieces.len());
        let total: usize = lines(&pieces).iter().map(|line| line - 1).sum();
        assert_eq!(total, 50);
        for pair in pieces.windows(2) {
            let [before, after] = [0, 1].map(|n| pair[n]["lines"][0]["points"].as_array().unwrap());
            assert_eq!(before.last(), after.first());
            assert_ne!(pair[0]["id"], pair[1]["id"]);
        }
    }

    #[test]
    fn the_oldest_ink_is_removed_and_a_late_subscriber_gets_the_rest() {
        let mut hand = Hand::new();
        hand.go(0.0, 0.0, -5.0);
        let mut there = std::collections::BTreeSet::new();
        let mut longest = 0;
        for n in 0..2 * MAX_POINTS {
            hand.go(0.0, if n % 20 < 10 { 1.0 } else { -1.0 }, 0.0);
            if let Some(reported) = hand.ink.poll(&json!({}), 0.0) {
                longest = longest.max(reported.to_string().len());
                for entity in reported["deletions"].as_array().unwrap() {
                    assert!(there.remove(entity["id"].as_str().unwrap()));
                }
                for entity in reported["entities"].as_array().unwrap() {
                    assert!(there.insert(entity["id"].as_str().unwrap().to_owned()));
                }
            }
        }
        assert!(hand.ink.kept_points <= MAX_POINTS);
        assert!(longest < 10_000, "{longest} bytes");
        let so_far = hand.ink.so_far(&json!({}), 0.0);
        let entities = so_far
            .iter()
            .flat_map(|item| item["entities"].as_array().unwrap());
        let late: std::collections::BTreeSet<_> = entities
            .map(|entity| entity["id"].as_str().unwrap().to_owned())
            .collect();
        assert_eq!(late, there);
        let longest = so_far.iter().map(|item| item.to_string().len()).max();
        assert!(longest.unwrap() < 500_000, "{longest:?} bytes");
    }
}
