//! Concentric hatching: the outline repeated inwards.

use dobot_geometry::{
    Area, CancelToken, Line, ParamCurveNearest, Point, Polygons, SegmentIndex, Stroke, bounds,
    edges,
};

use super::{Hatch, HatchError};

/// Returns nested closed lines at the spacing. The edge of the area is drawn already: without an
/// inset, the first lies one spacing inside.
pub(super) fn contours(
    area: &Area,
    hatch: &Hatch,
    cancel: &CancelToken,
) -> Result<Vec<Stroke>, HatchError> {
    let first_mm = if hatch.inset_mm > 0.0 {
        hatch.inset_mm
    } else {
        hatch.spacing_mm
    };
    let levels = levels(area, first_mm, hatch.spacing_mm, cancel)?;
    Ok(levels.into_iter().flatten().map(Stroke::ring).collect())
}

/// Joins the nested lines to spirals: while the pen goes around one it moves on to the next, as
/// long as each has a single follower. The innermost is complete.
///
/// ```text
///   .-----------.
///   | .-------. |
///   | | .---. | |    from the edge in
///   | | '-- | | |
///   | '-----' | |
///   '---------' /
/// ```
pub(super) fn spirals(
    area: &Area,
    hatch: &Hatch,
    cancel: &CancelToken,
) -> Result<Vec<Stroke>, HatchError> {
    let levels = levels(area, hatch.inset_mm, hatch.spacing_mm, cancel)?;
    let next = followers(&levels);
    let mut strokes = Vec::new();
    let mut is_followed = vec![Vec::new(); levels.len()];
    for (level, rings) in levels.iter().enumerate() {
        is_followed[level].resize(rings.len(), false);
    }
    for (level, rings) in levels.iter().enumerate() {
        for (number, ring) in rings.iter().enumerate() {
            if is_followed[level][number] {
                continue;
            }
            let (mut points, mut here, mut at) = (Vec::new(), ring.clone(), (level, number));
            while let Some(follower) = next[at.0][at.1] {
                cancel.check()?;
                let inner = &levels[at.0 + 1][follower];
                let inner = begun_near(inner, here[0]);
                points.append(&mut coil(&here, &inner, hatch.spacing_mm));
                at = (at.0 + 1, follower);
                is_followed[at.0][at.1] = true;
                here = inner;
            }
            let is_edge = at.0 == 0 && hatch.inset_mm <= 0.0;
            if points.is_empty() && is_edge {
                // Only the edge, which is drawn already.
                continue;
            }
            points.extend(here.iter().chain(here.first()));
            strokes.push(Stroke {
                closed: points.first() == points.last(),
                points,
            });
        }
    }
    Ok(strokes)
}

/// Returns the rings of the area reduced by the first distance, then by one more spacing each,
/// until nothing is left.
fn levels(
    area: &Area,
    first_mm: f64,
    spacing_mm: f64,
    cancel: &CancelToken,
) -> Result<Vec<Vec<Vec<Point>>>, HatchError> {
    let ink = bounds(area.rings.iter().flatten().copied());
    let corners: usize = area.rings.iter().map(Vec::len).sum();
    let rounds = ink.width().min(ink.height()).max(0.0) / (2.0 * spacing_mm);
    #[expect(clippy::cast_precision_loss, reason = "no more than memory holds")]
    let corners = corners as f64 * rounds;
    if corners > f64::from(MAX_CORNERS) {
        let most = MAX_CORNERS;
        return Err(HatchError::TooManyCorners { corners, most });
    }
    let whole = Polygons::new(&area.rings, area.rule).ok_or(HatchError::Entangled)?;
    let (mut levels, mut round) = (Vec::new(), 0.0);
    // The narrower side is used up after this number of rounds, even if rounding leaves thin tips.
    while round <= rounds + 1.0 {
        cancel.check()?;
        // Offset the original area each time: repeated rounding would add ever more corners.
        let rings = whole.offset(-(first_mm + round * spacing_mm), ROUND_MM);
        if rings.is_empty() {
            break;
        }
        levels.push(rings);
        round += 1.0;
    }
    Ok(levels)
}

/// Returns for each ring its single follower on the next level, if that follows no other ring.
fn followers(levels: &[Vec<Vec<Point>>]) -> Vec<Vec<Option<usize>>> {
    let mut next: Vec<Vec<Option<usize>>> =
        levels.iter().map(|level| vec![None; level.len()]).collect();
    for (level, pair) in levels.windows(2).enumerate() {
        let (owners, edges): (Vec<usize>, Vec<(Point, Point)>) = pair[0]
            .iter()
            .enumerate()
            .flat_map(|(number, ring)| edges(ring).map(move |edge| (number, edge)))
            .unzip();
        let index = SegmentIndex::new(edges);
        let mut followed = vec![Vec::new(); pair[0].len()];
        for (number, ring) in pair[1].iter().enumerate() {
            if let Some((edge, _)) = index.nearest(ring[0]) {
                followed[owners[edge as usize]].push(number);
            }
        }
        for (ring, followers) in followed.iter().enumerate() {
            if let [only] = followers[..] {
                next[level][ring] = Some(only);
            }
        }
    }
    next
}

/// Returns a turn around a ring that ends on the inner one, a spacing away.
fn coil(ring: &[Point], inner: &[Point], spacing_mm: f64) -> Vec<Point> {
    let length_mm: f64 = edges(ring).map(|(a, b)| a.distance(b)).sum();
    let index = SegmentIndex::new(edges(inner).collect());
    let mut covered_mm = 0.0;
    let mut points = Vec::with_capacity(ring.len());
    for (a, b) in edges(ring) {
        let there = index.nearest(a).map_or(a, |(edge, _)| {
            let (p, q) = index.segment(edge);
            nearest_on((p, q), a).0
        });
        let moved = a.lerp(there, covered_mm / length_mm);
        // Within a spacing of the inner ring everything is area; farther away, as in a thin tip,
        // only the ring itself is certain.
        let is_inside = moved.distance(there) <= spacing_mm;
        points.push(if is_inside { moved } else { a });
        covered_mm += a.distance(b);
    }
    points
}

/// Returns the ring with its start at the place closest to a point.
fn begun_near(ring: &[Point], p: Point) -> Vec<Point> {
    let near = |&(_, edge): &(usize, (Point, Point))| nearest_on(edge, p).1;
    let nearest = edges(ring)
        .enumerate()
        .min_by(|a, b| near(a).total_cmp(&near(b)));
    let Some((number, edge)) = nearest else {
        return ring.to_vec();
    };
    let begin = nearest_on(edge, p).0;
    let after = &ring[number + 1..];
    let before = &ring[..=number];
    let mut begun = vec![begin];
    begun.extend(after.iter().chain(before).filter(|&&p| p != begin));
    begun
}

/// Returns the place on an edge closest to a point, and its squared distance.
fn nearest_on((a, b): (Point, Point), p: Point) -> (Point, f64) {
    if a == b {
        return (a, (p - a).hypot2());
    }
    let nearest = Line::new(a, b).nearest(p, 0.0);
    (a.lerp(b, nearest.t), nearest.distance_sq)
}

/// The maximum deviation of a rounded corner, in mm.
const ROUND_MM: f64 = 0.01;
/// As many as fit in 100 MB.
const MAX_CORNERS: u32 = 2_000_000;
