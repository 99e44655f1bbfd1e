//! TEXT, MTEXT and attributes, in plain letters.

use dobot_geometry::{Affine, Vec2};

use super::content::{Content, line, lines};
use super::entity::Entity;
use super::pairs::Pair;
use super::plane::{Plane, from_above};
use super::renderer::EntityRenderer;
use crate::error::SourceError;
use crate::frame::way;
use crate::text::{CAPITAL, Lettering, Pose};

/// A line of text in units of the letters' grid.
#[derive(Clone, Copy, Debug, Default)]
struct LineExtent {
    /// The start of the ink of its first letter.
    begin: f64,
    /// The end of the ink of its last letter.
    end: f64,
    /// The position of a further letter.
    advance: f64,
}

impl LineExtent {
    fn of(text: &str, lettering: &mut Lettering) -> Self {
        let mut extent = Self::default();
        let rooms = text.chars().filter_map(|c| lettering.extent(c));
        for (i, room) in rooms.enumerate() {
            if i == 0 {
                extent.begin = room.ink[0];
            }
            extent.end = extent.advance + room.ink[1];
            extent.advance += room.advance;
        }
        extent
    }

    /// The line followed by another.
    fn and(self, next: Self) -> Self {
        Self {
            begin: self.begin,
            end: self.advance + next.end,
            advance: self.advance + next.advance,
        }
    }

    fn width(self) -> f64 {
        self.end - self.begin
    }
}

impl EntityRenderer<'_, '_> {
    /// Draws TEXT, ATTRIB and ATTDEF: one line.
    pub(super) fn text(
        &mut self,
        entity: &Entity<'_>,
        frame: Affine,
        is_in_block: bool,
    ) -> Result<(), SourceError> {
        let code = shown(entity, is_in_block)?;
        let Some(pair) = code.and_then(|code| entity.find(code)) else {
            return Ok(());
        };
        let whole = pair.whole_text();
        check_length(entity, &whole)?;
        let content = line(&whole).composed();
        self.warn_plain(entity, &content);
        if content.text.trim().is_empty() {
            return Ok(());
        }
        let extent = LineExtent::of(&content.text, &mut self.lettering);
        let pose = text_pose(entity, extent)?;
        if !has_size(entity, &pose)? {
            self.left_out(entity, "left out, because its letters have no size");
            return Ok(());
        }
        self.write(entity, frame, &content.text, pose)
    }

    /// Draws MTEXT: several lines. Its point and its direction are in world coordinates.
    pub(super) fn paragraphs(
        &mut self,
        entity: &Entity<'_>,
        world: Affine,
    ) -> Result<(), SourceError> {
        let whole = whole_text(entity);
        check_length(entity, &whole)?;
        let content = lines(&whole).composed();
        self.warn_plain(entity, &content);
        let unit = entity.number(40)? / CAPITAL;
        let (right, up) = paragraph_directions(entity)?;
        let pose = Pose {
            at: entity.point(10)?,
            across: right * unit,
            up: up * unit,
        };
        if !has_size(entity, &pose)? {
            self.left_out(entity, "left out, because its letters have no size");
            return Ok(());
        }
        let (column, row) = attachment(entity)?;
        let room = entity.number_or(41, 0.0)? / unit;
        let lines = self.wrapped(&content.text, room / NARROW);
        let spacing = entity.number_or(44, 1.0)? * LINE * CAPITAL;
        #[expect(clippy::cast_precision_loss, reason = "a count of lines")]
        let below = spacing * (lines.len() - 1) as f64;
        let mut y = (CAPITAL + below) * row - CAPITAL;
        for line in lines {
            let extent = LineExtent::of(&line, &mut self.lettering);
            // As wide as the letters of the program that made the file.
            let share = room / extent.width();
            let across = pose.across
                * if (NARROW..1.0).contains(&share) {
                    share
                } else {
                    1.0
                };
            let x = -extent.width() * column - extent.begin;
            let at = pose.at + across * x + pose.up * y;
            self.write(entity, world, &line, Pose { at, across, ..pose })?;
            y -= spacing;
        }
        Ok(())
    }

    /// The lines of a text, at least one, wrapped between words at the width `room`, in units of
    /// the grid; 0 for no limit.
    fn wrapped(&mut self, text: &str, room: f64) -> Vec<String> {
        let space = LineExtent::of(" ", &mut self.lettering);
        let mut lines = Vec::new();
        for paragraph in text.split('\n') {
            let mut line = String::new();
            let mut extent = LineExtent::default();
            for (i, word) in paragraph.split(' ').enumerate() {
                let own = LineExtent::of(word, &mut self.lettering);
                let longer = extent.and(space).and(own);
                if i > 0 && (room <= 0.0 || longer.width() <= room) {
                    line.extend([" ", word]);
                    extent = longer;
                    continue;
                }
                if i > 0 {
                    lines.push(std::mem::take(&mut line));
                }
                line.push_str(word);
                extent = own;
            }
            lines.push(line);
        }
        lines
    }

    fn write(
        &mut self,
        entity: &Entity<'_>,
        frame: Affine,
        text: &str,
        mut pose: Pose,
    ) -> Result<(), SourceError> {
        for character in text.chars() {
            let letter = Pose {
                at: frame * pose.at,
                across: way(frame, pose.across),
                up: way(frame, pose.up),
            };
            self.lettering
                .write(self.sketch, entity.at, character, &letter)?;
            let advance = self.lettering.extent(character).unwrap_or_default().advance;
            pose.at += pose.across * advance;
        }
        Ok(())
    }

    fn warn_plain(&mut self, entity: &Entity<'_>, content: &Content) {
        if content.is_plainer {
            let instead = "written plainly: one height, no underlines, fractions on one line";
            self.sketch.warn(entity.at, "formatted text", instead);
        }
    }
}

/// Refuses texts that are too long.
fn check_length(entity: &Entity<'_>, text: &str) -> Result<(), SourceError> {
    if text.len() <= MAX_LETTERS {
        return Ok(());
    }
    let found = format!("a text of {} bytes", text.len());
    let expected = format!("at most {MAX_LETTERS}; split it");
    Err(entity.refused(found, &expected))
}

/// The group of the visible text: of a definition its tag, or in a block its value if all copies
/// share it. `None` if nothing is visible.
fn shown(entity: &Entity<'_>, is_in_block: bool) -> Result<Option<i32>, SourceError> {
    let flags = entity.flags(70)?;
    Ok(match entity.kind {
        b"ATTRIB" | b"ATTDEF" if flags & INVISIBLE != 0 => None,
        b"ATTDEF" if is_in_block => (flags & CONSTANT != 0).then_some(1),
        b"ATTDEF" => Some(2),
        _ => Some(1),
    })
}

/// The placement of a line's letters relative to its points.
fn text_pose(entity: &Entity<'_>, extent: LineExtent) -> Result<Pose, SourceError> {
    let (column, row) = justification(entity)?;
    let has_second = entity.find(11).is_some();
    let pose = match column {
        ALIGNED | FIT if has_second => spanning_pose(entity, extent, column)?,
        _ => {
            let (right, up) = directions(entity)?;
            let tall = entity.number(40)? / CAPITAL;
            let is_at_start = (column, row) == (0, 0) || !has_second;
            Pose {
                at: entity.point(if is_at_start { 10 } else { 11 })?,
                across: right * (tall * entity.number_or(41, 1.0)?),
                up: up * tall,
            }
        }
    };
    let made = entity.flags(71)?;
    let side = |flag: u32| if made & flag == 0 { 1.0 } else { -1.0 };
    let lean = entity.number_or(51, 0.0)?.to_radians().tan();
    let tall = pose.up.length();
    let leaning = pose.across * (lean * tall / pose.across.length());
    let across = pose.across * side(BACKWARD);
    let up = (pose.up + leaning) * side(UPSIDE_DOWN);
    let before = extent.begin + extent.width() * before(column);
    let at = pose.at - across * before - up * below(column, row);
    Ok(Pose { at, across, up })
}

/// Fits between two points: as tall as that makes it, or with the given height.
fn spanning_pose(
    entity: &Entity<'_>,
    extent: LineExtent,
    column: u32,
) -> Result<Pose, SourceError> {
    let at = entity.point(10)?;
    let way = entity.point(11)? - at;
    // A single I has no width.
    let width = if extent.width() > 0.0 {
        extent.width()
    } else {
        extent.advance
    };
    let across = way * (1.0 / width);
    let tall = if column == ALIGNED {
        across.length() / entity.number_or(41, 1.0)?
    } else {
        entity.number(40)? / CAPITAL
    };
    let up = way.turn_90() * (tall / way.length());
    Ok(Pose { at, across, up })
}

/// The justification across and up.
fn justification(entity: &Entity<'_>) -> Result<(u32, u32), SourceError> {
    let vertical = if entity.kind == b"TEXT" { 73 } else { 74 };
    let (column, row) = (entity.flags(72)?, entity.flags(vertical)?);
    if column > FIT || row > TOP {
        let found = format!("{} justified {column} across and {row} up", entity.name());
        let expected = "0 to 5 across (72) and 0 to 3 up (73, of attributes 74)";
        return Err(entity.refused(found, expected));
    }
    Ok((column, row))
}

/// The fraction of a line before its point.
const fn before(column: u32) -> f64 {
    match column {
        CENTER | MIDDLE => 0.5,
        RIGHT => 1.0,
        _ => 0.0,
    }
}

/// The distance of the base line below its point, on the letters' grid.
const fn below(column: u32, row: u32) -> f64 {
    match (column, row) {
        (MIDDLE, _) | (_, HALF) => 0.5 * CAPITAL,
        (_, BOTTOM) => -DESCENT,
        (_, TOP) => CAPITAL,
        _ => 0.0,
    }
}

/// The directions along a line of text and up.
fn directions(entity: &Entity<'_>) -> Result<(Vec2, Vec2), SourceError> {
    let right = Vec2::from_angle(entity.number_or(50, 0.0)?.to_radians());
    Ok((right, right.turn_90()))
}

/// The directions of an MTEXT, which has a direction in the world or an angle, and may be seen from
/// behind or from the side.
fn paragraph_directions(entity: &Entity<'_>) -> Result<(Vec2, Vec2), SourceError> {
    let plane = Plane::of(entity)?;
    let right = if entity.find(11).is_some() {
        plane.within(entity.way(11)?).unwrap_or_default()
    } else {
        plane.right(entity.number_or(50, 0.0)?.to_radians())
    };
    Ok((from_above(right), from_above(plane.left_of(right))))
}

/// The position of the point of an MTEXT: the fractions before it and above it.
fn attachment(entity: &Entity<'_>) -> Result<(f64, f64), SourceError> {
    let number = entity.number_or(71, 1.0)?;
    let index = (1..=9_u8).find(|&i| f64::from(i) == number);
    let index = index.ok_or_else(|| {
        let found = format!("MTEXT attached at {number}");
        entity.refused(found, "an attachment point from 1 to 9")
    })? - 1;
    Ok((f64::from(index % 3) * 0.5, f64::from(index / 3) * 0.5))
}

/// The text of an MTEXT, which is split if long.
fn whole_text(entity: &Entity<'_>) -> String {
    let pieces = entity
        .pairs
        .iter()
        .filter(|pair| pair.code == 1 || pair.code == 3);
    pieces.map(Pair::whole_text).collect()
}

fn has_size(entity: &Entity<'_>, pose: &Pose) -> Result<bool, SourceError> {
    let area = pose.across.cross(pose.up);
    Ok(entity.number(40)? > 0.0 && area != 0.0 && area.is_finite())
}

/// Flags of attributes.
const INVISIBLE: u32 = 1;
const CONSTANT: u32 = 2;
/// Kinds of justification across: aligned between two points (sets the height), centered in
/// everything, fitted between two points (keeps the height).
const CENTER: u32 = 1;
const RIGHT: u32 = 2;
const ALIGNED: u32 = 3;
const MIDDLE: u32 = 4;
const FIT: u32 = 5;
/// Kinds of justification up; 0 is the base line.
const BOTTOM: u32 = 1;
const HALF: u32 = 2;
const TOP: u32 = 3;
/// Flags of mirrored letters.
const BACKWARD: u32 = 2;
const UPSIDE_DOWN: u32 = 4;
/// The descent of letters below the base line, on their grid.
const DESCENT: f64 = 7.0;
/// The width of the letters of other programs relative to ours.
const NARROW: f64 = 0.8;
/// The line distance, in heights of capitals.
const LINE: f64 = 5.0 / 3.0;
/// The largest number of bytes of a text: thirty pages.
const MAX_LETTERS: usize = 100_000;
