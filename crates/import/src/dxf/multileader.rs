//! MULTILEADER: a note with leader lines.

use dobot_geometry::Affine;

use super::entity::Entity;
use super::pairs::Pair;
use super::renderer::EntityRenderer;
use crate::error::SourceError;

/// The groups of a MULTILEADER by part, because their codes differ between parts.
#[derive(Debug, Default)]
struct Parts<'a> {
    note: Vec<Pair<'a>>,
    leaders: Vec<LeaderPairs<'a>>,
}

/// The groups of one leader.
#[derive(Debug, Default)]
struct LeaderPairs<'a> {
    /// The point where its lines meet.
    own: Vec<Pair<'a>>,
    lines: Vec<Vec<Pair<'a>>>,
}

/// The part of a MULTILEADER that a group belongs to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Place {
    Outside,
    Note,
    Leader,
    Line,
}

impl<'a> Parts<'a> {
    fn of(pairs: &[Pair<'a>]) -> Self {
        let (mut parts, mut place) = (Self::default(), Place::Outside);
        for &pair in pairs {
            place = match (place, pair.code) {
                (Place::Outside, 300) if pair.value == b"CONTEXT_DATA{" => Place::Note,
                (Place::Note, 302) if pair.value == b"LEADER{" => {
                    parts.leaders.push(LeaderPairs::default());
                    Place::Leader
                }
                (Place::Leader, 304) if pair.value == b"LEADER_LINE{" => {
                    if let Some(leader) = parts.leaders.last_mut() {
                        leader.lines.push(Vec::new());
                    }
                    Place::Line
                }
                (Place::Line, 305) => Place::Leader,
                (Place::Leader, 303) => Place::Note,
                (Place::Note, 301) => Place::Outside,
                _ => {
                    parts.push(place, pair);
                    place
                }
            };
        }
        parts
    }

    fn push(&mut self, place: Place, pair: Pair<'a>) {
        let leader = self.leaders.last_mut();
        let pairs = match place {
            Place::Outside => None,
            Place::Note => Some(&mut self.note),
            Place::Leader => leader.map(|leader| &mut leader.own),
            Place::Line => leader.and_then(|leader| leader.lines.last_mut()),
        };
        if let Some(pairs) = pairs {
            pairs.push(pair);
        }
    }
}

impl EntityRenderer<'_, '_> {
    /// Draws the leader lines, the landing line and the note. Arrows are not drawn.
    pub(super) fn multileader(
        &mut self,
        entity: &Entity<'_>,
        frame: Affine,
    ) -> Result<(), SourceError> {
        let parts = Parts::of(&entity.pairs);
        let mut has_lines = false;
        for leader in &parts.leaders {
            let own = entity.with(leader.own.clone());
            let mut end = own.points(10)?;
            end.truncate(1);
            if let (Some(&at), true) = (end.first(), own.find(11).is_some()) {
                end.push(at + own.point(11)?.to_vec2() * own.number_or(40, 0.0)?);
            }
            for line in &leader.lines {
                let mut points = entity.with(line.clone()).points(10)?;
                points.extend(&end);
                points.dedup();
                has_lines |= points.len() > 1;
                let points = self.places(entity, frame, &points)?;
                self.sketch.stroke(points)?;
            }
        }
        if has_lines {
            self.left_out(entity, "drawn without its arrow");
        }
        let note = entity.with(parts.note);
        if note.flags(296)? == 1 {
            self.left_out(entity, "the block at its end left out");
        }
        if note.flags(290)? == 1 && note.find(304).is_some() {
            let text = note.pairs.iter().filter_map(as_paragraph).collect();
            self.paragraphs(&entity.with(text), frame)?;
        }
        Ok(())
    }
}

/// Converts a group of the note to that of an MTEXT.
fn as_paragraph<'a>(pair: &Pair<'a>) -> Option<Pair<'a>> {
    let code = match pair.code {
        304 => 1,
        12 | 22 | 13 | 23 => pair.code - 2,
        41 => 40,
        43 => 41,
        45 => 44,
        171 => 71,
        _ => return None,
    };
    Some(pair.with_code(code))
}
