//! Calculated points.

use dobot_geometry::Point;

use crate::artwork::Artwork;
use crate::error::SourceError;
use crate::limits::LIMIT_MM;
use crate::options::ReadOptions;
use crate::sketch::{Sketch, Y};
use crate::warning::Warning;

/// Reads lines of points; an error has the line and the point in it, both counted from 1.
pub(crate) fn read(
    lines: &[Vec<Point>],
    options: &ReadOptions,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    let mut sketch = Sketch::new(b"", options)?;
    for (number, line) in (1..).zip(lines) {
        if let Some(at) = line.iter().position(|point| !is_allowed(*point)) {
            return Err(SourceError::Point {
                line: number,
                point: at + 1,
                found: line[at].into(),
            });
        }
        sketch.stroke(line.clone())?;
    }
    sketch.finish(Y::Down, "no points in the lines")
}

fn is_allowed(point: Point) -> bool {
    [point.x, point.y]
        .iter()
        .all(|value| value.abs() <= LIMIT_MM)
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn lines_become_strokes_unchanged() {
        let square = [(0.0, 0.0), (40.0, 0.0), (40.0, 30.0), (0.0, 0.0)].map(Point::from);
        let dot = vec![Point::new(20.0, 10.0)];
        let (artwork, warnings) =
            read(&[square.to_vec(), dot.clone()], &ReadOptions::default()).unwrap();
        assert!(warnings.is_empty());
        assert_eq!((artwork.width_mm, artwork.height_mm), (40.0, 30.0));
        let strokes = &artwork.layers[0].strokes;
        assert_eq!(strokes[0].points, square);
        assert_eq!(strokes[1].points, dot);
    }

    #[test]
    fn an_invalid_point_is_reported_with_its_line() {
        for (x, y, message) in [
            (f64::NAN, 0.0, "point 2 of line 1 is (NaN, 0)"),
            (0.0, f64::INFINITY, "point 2 of line 1 is (0, inf)"),
            (-1_000_001.0, 0.0, "point 2 of line 1 is (-1000001, 0)"),
        ] {
            let line = vec![Point::ZERO, Point::new(x, y)];
            let error = read(&[line], &ReadOptions::default()).unwrap_err();
            assert!(error.to_string().starts_with(message), "{error}");
        }
        assert!(read(&[], &ReadOptions::default()).is_err());
    }
}
