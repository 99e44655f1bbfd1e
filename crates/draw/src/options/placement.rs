//! The placement that the options describe: sheet, marks and the width of texts.

use dobot_geometry::Point;
use dobot_import::{Source, Wrap};

use super::{Options, OptionsError, PlaceOptions};
use crate::layout::marks::Marks;
use crate::layout::place::{AREA, Placement, Size};
use crate::layout::sheet::SheetPlace;
use crate::prepare::NamedSource;

/// Returns position and size of a drawing of these sources.
pub(super) fn placement(
    options: &Options,
    sources: &[NamedSource],
) -> Result<Placement, OptionsError> {
    // A picture beside other files has the size given by its resolution.
    let fills = !sources.is_empty() && sources.iter().all(|source| !source.source.has_size());
    let sheet = sheet(&options.place)?;
    Ok(Placement {
        size: match (options.place.fit || fills, options.place.scale) {
            (_, Some(factor)) => Size::Scaled(factor),
            (true, None) => Size::Fit,
            (false, None) => Size::Within,
        },
        margin_mm: options.place.margin,
        rotate_deg: options.place.rotate,
        center: center(options).filter(|_| sheet.is_none()),
        mirrors: options.place.mirror,
        sheet,
        clips: options.place.clip,
        ..Placement::default()
    })
}

/// Returns what is drawn around the drawing.
pub(super) fn marks(place: &PlaceOptions) -> Marks {
    Marks {
        border: place.border,
        crop_marks: place.crop_marks,
        signature: place.sign.clone(),
    }
}

/// Wraps the texts among sources.
pub(super) fn wrap_texts(sources: &mut [NamedSource], options: &Options, placement: &Placement) {
    let reserved = Placement {
        around_mm: marks(&options.place).around_mm(options.place.gap),
        ..*placement
    };
    let wrap = wrap(options, &reserved);
    for named in sources {
        if let Source::Text(text) = &mut named.source {
            text.wrap = wrap;
        }
    }
}

/// Returns how texts are wrapped: at the requested width, or on a sheet at its margins. A text that
/// is scaled by a factor is wrapped before.
fn wrap(options: &Options, placement: &Placement) -> Option<Wrap> {
    let Options { what, place, .. } = options;
    let at_margins = || {
        place.paper_size?;
        // Without any room, the placement is refused.
        let room = placement.room_mm().ok()?;
        let columns = place.grid.map_or(1.0, |grid| f64::from(grid.columns));
        let column_mm = (room.x - (columns - 1.0) * place.gap) / columns;
        let scale = place.scale.filter(|_| what.height.is_none());
        Some(column_mm / scale.unwrap_or(1.0))
    };
    Some(Wrap {
        width_mm: what.wrap.or_else(at_margins)?,
        justify: what.justify,
    })
}

/// Returns the sheet: through the touched points, at its corner or centre, or as close in front of
/// the arm as its whole lower edge can be reached.
fn sheet(place: &PlaceOptions) -> Result<Option<SheetPlace>, OptionsError> {
    let Some(size) = place.paper_size else {
        return Ok(None);
    };
    let size = if place.landscape {
        size.landscape()
    } else {
        size
    };
    if let Some(&[ax, ay, _, bx, by, _, cx, cy, _]) = place.paper.as_deref() {
        let [a, b, c] = [(ax, ay), (bx, by), (cx, cy)].map(Point::from);
        let touched = SheetPlace::through(size, a, b).ok_or(OptionsError::SamePoint)?;
        let below_mm = touched.on_sheet(c).y - size.height_mm;
        if below_mm > TOUCHED_BELOW_MM {
            return Err(OptionsError::BelowSheet(below_mm));
        }
        return Ok(Some(touched));
    }
    if let Some(&[x_mm, y_mm]) = place.corner.as_deref() {
        let corner = Point::new(x_mm, y_mm);
        return Ok(Some(SheetPlace::from_lower_left(size, corner)));
    }
    let middle = match place.at.as_deref() {
        Some(&[x_mm, y_mm]) => Point::new(x_mm, y_mm),
        _ => Point::new(
            (NEAREST_MM + size.height_mm / 2.0).max(AREA.center().x),
            0.0,
        ),
    };
    Ok(Some(SheetPlace::centered(size, middle)))
}

/// Returns the requested centre.
pub(super) fn center(options: &Options) -> Option<Point> {
    match options.place.at.as_deref() {
        Some(&[x_mm, y_mm]) => Some(Point::new(x_mm, y_mm)),
        _ => None,
    }
}

/// The minimum distance of a sheet's lower edge in front of the arm.
const NEAREST_MM: f64 = 140.0;
/// The distance below the sheet's lower edge at which the touches may be, because people rarely hit
/// the edge exactly.
const TOUCHED_BELOW_MM: f64 = 5.0;
