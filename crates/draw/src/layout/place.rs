//! Placement on the paper, and the check of the arm's reach.

mod error;

use std::{fmt, iter};

pub use self::error::PlaceError;
use crate::layout::sheet::SheetPlace;
use dobot_arm::Position;
use dobot_geometry::{Point, Rect, Vec2, bounds, direction, steps};
use dobot_import::{Artwork, Layer};
use dobot_plan::{MoveKind, Paper, Plan};

/// The default drawing area: 120 mm deep and 200 mm wide, entirely within reach.
pub const AREA: Rect = Rect::new(150.0, -100.0, 270.0, 100.0);

/// The position and size of a drawing on the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// The drawing area in the base frame, in mm.
    pub area: Rect,
    /// The margin along its edges, in mm, at least 0.
    pub margin_mm: f64,
    /// The space on each side of the drawing for border and crop marks, in mm.
    pub around_mm: f64,
    /// The additional space below the drawing for a signature, in mm.
    pub below_mm: f64,
    /// The size of the drawing.
    pub size: Size,
    /// The rotation of the drawing on the paper, counterclockwise, in degrees.
    pub rotate_deg: f64,
    /// The centre in the base frame; by default that of the area. A sheet has its own position.
    pub center: Option<Point>,
    /// The minimum and maximum distance from the axis at which the arm reaches the paper, in mm: a
    /// drawing larger than the area may be placed anywhere in between.
    pub reach: Option<[f64; 2]>,
    /// Whether left and right are swapped.
    pub mirrors: bool,
    /// The sheet to draw on, instead of the area.
    pub sheet: Option<SheetPlace>,
    /// Whether parts beyond the sheet or out of reach are cut off instead of refused.
    pub clips: bool,
}

impl Placement {
    /// Places a page in the base frame.
    ///
    /// For a person behind the arm, looking forward, the drawing is upright: its right is -Y and
    /// its down is -X. The ink is placed, not the page around it.
    ///
    /// # Errors
    ///
    /// [`PlaceError`] if a setting is not a number or out of range, or the drawing is larger than
    /// the area and neither fitted nor centred explicitly.
    pub fn place(&self, artwork: Artwork) -> Result<Placed, PlaceError> {
        let turn = self.turn()?;
        let side = if self.mirrors { -1.0 } else { 1.0 };
        let turned = |p: Point| Vec2::new(side * p.x, p.y).rotate_scale(turn).to_point();
        let ink = bounds(artwork.points().map(turned));
        if let Some(sheet) = &self.sheet {
            let Artwork {
                width_mm: w,
                height_mm: h,
                ..
            } = artwork;
            let corners = [(0.0, 0.0), (w, 0.0), (w, h), (0.0, h)];
            let page = bounds(corners.map(|corner| turned(corner.into())));
            return self.place_on(sheet, artwork, page, ink, turned);
        }
        let scale = self.scale(ink)?;
        let (from, to) = (ink.center(), self.middle(ink, scale));
        let place = |p: &mut Point| {
            let way = (turned(*p) - from) * scale;
            *p = Point::new(to.x - way.y, to.y - way.x);
        };
        let mut layers = artwork.layers;
        layers
            .iter_mut()
            .flat_map(Layer::points_mut)
            .for_each(place);
        Ok(Placed { layers, scale })
    }

    /// Places a page on a sheet: the page of a file keeps its upper left corner, unless it is
    /// fitted; content without a page is centred.
    fn place_on(
        &self,
        sheet: &SheetPlace,
        artwork: Artwork,
        page: Rect,
        ink: Rect,
        turned: impl Fn(Point) -> Point,
    ) -> Result<Placed, PlaceError> {
        let room = self.sheet_room(sheet)?;
        let is_page = artwork.has_page;
        let fits = self.size == Size::Fit;
        let frame = if is_page && !fits { page } else { ink };
        let fitting = (room.width() / frame.width()).min(room.height() / frame.height());
        let scale = match self.size {
            Size::Scaled(factor) if factor > 0.0 && factor.is_finite() => factor,
            Size::Scaled(factor) => return Err(PlaceError::Scale(factor)),
            Size::Fit if fitting.is_finite() => fitting,
            // Page sizes in inches are rounded.
            Size::Within if fitting < 1.0 - SAME_SCALE => fitting,
            Size::Fit | Size::Within | Size::True => 1.0,
        };
        let (from, to) = if is_page && !fits {
            (frame.origin(), room.origin())
        } else {
            (frame.center(), room.center())
        };
        let mut layers = artwork.layers;
        for p in layers.iter_mut().flat_map(Layer::points_mut) {
            *p = sheet.place(to + (turned(*p) - from) * scale);
        }
        Ok(Placed { layers, scale })
    }

    fn sheet_room(&self, sheet: &SheetPlace) -> Result<Rect, PlaceError> {
        let margin_mm = self.margin_mm;
        let most_mm = sheet.size.width_mm.min(sheet.size.height_mm) / 2.0;
        if !(0.0..most_mm).contains(&margin_mm) {
            return Err(PlaceError::Margin { margin_mm, most_mm });
        }
        let Rect { x0, y0, x1, y1 } = sheet.room(margin_mm);
        let taken = self.taken();
        if taken.x >= x1 - x0 || taken.y >= y1 - y0 {
            return Err(self.no_room(Vec2::new(x1 - x0, y1 - y0)));
        }
        let around_mm = self.around_mm;
        let bottom = y1 - around_mm - self.below_mm;
        Ok(Rect::new(
            x0 + around_mm,
            y0 + around_mm,
            x1 - around_mm,
            bottom,
        ))
    }

    /// Returns width and height that the marks around the drawing take.
    fn taken(&self) -> Vec2 {
        let sides_mm = 2.0 * self.around_mm;
        Vec2::new(sides_mm, sides_mm + self.below_mm)
    }

    fn no_room(&self, room: Vec2) -> PlaceError {
        let taken = self.taken();
        PlaceError::MarksTooLarge {
            taken_mm: [taken.x, taken.y],
            room_mm: [room.x, room.y],
        }
    }

    /// Returns width and height of the room for the drawing before it is rotated; for odd angles,
    /// as for the nearest quarter of a turn.
    pub(crate) fn room_mm(&self) -> Result<Vec2, PlaceError> {
        let room = match &self.sheet {
            Some(sheet) => self.sheet_room(sheet)?.size().to_vec2(),
            None => self
                .room()
                .map(|[width, height]| Vec2::new(width, height))?,
        };
        let is_on_its_side = (45.0..135.0).contains(&self.rotate_deg.rem_euclid(180.0));
        Ok(if is_on_its_side {
            Vec2::new(room.y, room.x)
        } else {
            room
        })
    }

    /// Returns the centre of the drawing: with its marks in the middle of the area, or if they are
    /// larger, of the reachable positions.
    fn middle(&self, ink: Rect, scale: f64) -> Point {
        let size = ink.size().to_vec2() * scale;
        let whole = size + self.taken();
        let is_larger = whole.x > self.area.height() || whole.y > self.area.width();
        let reached = self.reached(size).filter(|_| is_larger);
        let middle = reached.unwrap_or(self.area.center());
        // A signature is closer to the arm than the drawing.
        let above = Vec2::new(self.below_mm / 2.0, 0.0);
        self.center.unwrap_or(middle + above)
    }

    /// Returns the middle of the positions in which the arm reaches a drawing of this size,
    /// including its marks and margins. The base may turn by at most a quarter of a circle, because
    /// the servo keeps the tool's direction.
    ///
    /// ```text
    ///        far       .-----.
    ///                *---------*        (begin + depth)2 + (width / 2)2 = far2
    ///        near    '---   ---'        begin >= near, begin >= width / 2
    ///                    `-'
    /// ```
    fn reached(&self, size: Vec2) -> Option<Point> {
        let [near, far] = self.reach?;
        let size = size + self.taken();
        let margin_mm = 2.0 * self.margin_mm;
        let (half, deep) = (f64::midpoint(size.x, margin_mm), size.y + margin_mm);
        let first = near.max(half * QUARTER);
        let last = (far * far - half * half).max(0.0).sqrt() - deep;
        (first <= last).then(|| Point::new(f64::midpoint(first, last) + deep / 2.0, 0.0))
    }

    /// Returns the largest scale at which the arm reaches everything.
    fn reaching(&self, ink: Rect) -> f64 {
        let longer = ink.width().max(ink.height());
        let Some([_, far]) = self.reach.filter(|_| longer > 0.0) else {
            return 0.0;
        };
        let (mut fits, mut too_large) = (0.0, 2.0 * far / longer);
        for _ in 0..HALVINGS {
            let scale = f64::midpoint(fits, too_large);
            match self.reached(ink.size().to_vec2() * scale) {
                Some(_) => fits = scale,
                None => too_large = scale,
            }
        }
        fits
    }

    /// Returns the direction of the drawing's right on the page, where y points down.
    fn turn(&self) -> Result<Vec2, PlaceError> {
        if !self.rotate_deg.is_finite() {
            return Err(PlaceError::Rotate(self.rotate_deg));
        }
        Ok(direction(-self.rotate_deg))
    }

    fn scale(&self, ink: Rect) -> Result<f64, PlaceError> {
        let [wide, deep] = self.room()?;
        let in_area = (wide / ink.width()).min(deep / ink.height());
        let fitting = if self.size == Size::Fit {
            in_area
        } else {
            in_area.max(self.reaching(ink))
        };
        let scale = match self.size {
            Size::Scaled(factor) if factor > 0.0 && factor.is_finite() => factor,
            Size::Scaled(factor) => return Err(PlaceError::Scale(factor)),
            Size::Fit if fitting.is_finite() => fitting,
            Size::Within => fitting.min(1.0),
            // A dot fits at any scale.
            Size::Fit | Size::True => 1.0,
        };
        let may_exceed = self.center.is_some() || self.clips;
        if scale > fitting * (1.0 + 1e-9) && !may_exceed {
            return Err(PlaceError::TooLarge {
                width_mm: ink.width() * scale,
                height_mm: ink.height() * scale,
                area_width_mm: fitting.max(0.0) * ink.width(),
                area_height_mm: fitting.max(0.0) * ink.height(),
            });
        }
        Ok(scale)
    }

    /// Returns width and depth of the area without margins.
    fn room(&self) -> Result<[f64; 2], PlaceError> {
        let margin_mm = self.margin_mm;
        let [wide, deep] = [self.area.height(), self.area.width()].map(|mm| mm - 2.0 * margin_mm);
        if margin_mm >= 0.0 && wide > 0.0 && deep > 0.0 {
            let taken = self.taken();
            if taken.x >= wide || taken.y >= deep {
                return Err(self.no_room(Vec2::new(wide, deep)));
            }
            return Ok([wide - taken.x, deep - taken.y]);
        }
        let most_mm = self.area.height().min(self.area.width()) / 2.0;
        Err(PlaceError::Margin { margin_mm, most_mm })
    }
}

impl Default for Placement {
    /// Returns true size, upright, centred in [`AREA`], without margins.
    fn default() -> Self {
        Self {
            area: AREA,
            margin_mm: 0.0,
            around_mm: 0.0,
            below_mm: 0.0,
            size: Size::True,
            rotate_deg: 0.0,
            center: None,
            reach: None,
            mirrors: false,
            sheet: None,
            clips: false,
        }
    }
}

/// The size of a drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Size {
    /// True size: a millimetre in the file is a millimetre.
    True,
    /// True size times a factor above 0.
    Scaled(f64),
    /// True size, or smaller if the area requires it.
    Within,
    /// As large as the area allows, with the aspect ratio kept.
    Fit,
}

/// Placed layers in the base frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// The layers, in mm.
    pub layers: Vec<Layer>,
    /// Their scale relative to the page.
    pub scale: f64,
}

/// Checks every position of a plan, at most 2 mm apart, with the pen down and up: an interrupted
/// drawing must be able to lift the pen anywhere.
///
/// # Errors
///
/// [`PlaceError::OutOfReach`], [`PlaceError::RunOutOfReach`] or [`PlaceError::WayOutOfReach`] with
/// the first position that `reachable` refuses, and its reason.
pub fn check_reach<E: fmt::Display>(
    plan: &Plan,
    paper: &Paper,
    reachable: impl Fn(Position) -> Result<(), E>,
) -> Result<(), PlaceError> {
    let mut here = Point::new(plan.start[0], plan.start[1]);
    let lift_mm = plan.lift_mm();
    let refused_at = |p: Point| {
        let down_mm = paper.z_at(p);
        [down_mm, down_mm + lift_mm].into_iter().find_map(|z_mm| {
            let place = Position::new(p.x, p.y, z_mm);
            Some((place, reachable(place).err()?.to_string()))
        })
    };
    let mut refused = plan.positions().enumerate().filter_map(|(i, [x, y, _])| {
        let there = Point::new(x, y);
        // Check the end first: the way to an unreachable place is unreachable too.
        let mut places = iter::once(there).chain(steps(here, there, STEP_MM));
        here = there;
        let (p, refused) = places.find_map(|p| Some((p, refused_at(p)?)))?;
        let is_way = plan.moves[i].kind == MoveKind::Travel && p != there;
        Some(if is_way {
            way_out_of_reach(refused)
        } else {
            out_of_reach(plan, i, refused)
        })
    });
    let Some(first) = refused.next() else {
        return Ok(());
    };
    let line = match &first {
        // If the line itself is out of reach, burning slower does not help.
        PlaceError::RunOutOfReach { .. } => {
            refused.find(|error| matches!(error, PlaceError::OutOfReach { .. }))
        }
        _ => None,
    };
    Err(line.unwrap_or(first))
}

/// Returns the error for a position on a vector, or at its end if it leaves no trace.
fn out_of_reach(plan: &Plan, vector: usize, (place, reason): (Position, String)) -> PlaceError {
    let [x_mm, y_mm, z_mm] = [place.x, place.y, place.z].map(|mm| mm.0);
    let mut kinds = plan.moves[vector..].iter().map(|vector| vector.kind);
    // The next vector begins where a travel ends.
    match kinds.find(|kind| *kind != MoveKind::Travel) {
        Some(MoveKind::RunUp | MoveKind::RunOut | MoveKind::Brake) => PlaceError::RunOutOfReach {
            x_mm,
            y_mm,
            z_mm,
            reason,
        },
        _ => PlaceError::OutOfReach {
            x_mm,
            y_mm,
            z_mm,
            reason,
        },
    }
}

fn way_out_of_reach((place, reason): (Position, String)) -> PlaceError {
    let [x_mm, y_mm, z_mm] = [place.x, place.y, place.z].map(|mm| mm.0);
    PlaceError::WayOutOfReach {
        x_mm,
        y_mm,
        z_mm,
        reason,
    }
}

const STEP_MM: f64 = 2.0;
/// Slightly more than a quarter, because positions are rounded.
const QUARTER: f64 = 1.01;
const HALVINGS: u32 = 60;
/// The share by which a page may exceed the sheet at true size.
const SAME_SCALE: f64 = 0.002;

#[cfg(test)]
mod tests;
