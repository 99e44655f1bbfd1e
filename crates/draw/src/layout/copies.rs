//! Copies of a drawing, or several drawings, in a grid.

use std::str::FromStr;

use dobot_geometry::{Rect, Vec2, bounds};
use dobot_import::Artwork;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A grid of columns and rows for copies or files, as in `3x2`: three columns and two rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "String", into = "String")]
#[schemars(with = "String")]
pub struct Grid {
    /// The number of columns.
    pub columns: u32,
    /// The number of rows.
    pub rows: u32,
}

impl FromStr for Grid {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let counts = text.split_once(['x', 'X']);
        let number = |text: &str| {
            text.trim()
                .parse()
                .ok()
                .filter(|number| (1..=100).contains(number))
        };
        counts
            .and_then(|(columns, rows)| {
                Some(Self {
                    columns: number(columns)?,
                    rows: number(rows)?,
                })
            })
            .ok_or("expected COLUMNSxROWS from 1x1 to 100x100, as in 3x2")
    }
}

impl From<Grid> for String {
    fn from(Grid { columns, rows }: Grid) -> Self {
        format!("{columns}x{rows}")
    }
}

impl TryFrom<String> for Grid {
    type Error = &'static str;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        text.parse()
    }
}

/// Returns a page with the ink of these pages in cells, repeated from the first, with a gap in
/// between. All cells have the size of the largest one, and the ink is centred in each.
pub(crate) fn in_cells(artworks: &[Artwork], grid: Grid, gap_mm: f64) -> Artwork {
    let inks: Vec<Rect> = artworks
        .iter()
        .map(|artwork| bounds(artwork.points()))
        .collect();
    let largest = |side: fn(&Rect) -> f64| inks.iter().map(side).fold(0.0, f64::max);
    let cell = Vec2::new(largest(Rect::width), largest(Rect::height));
    let step = cell + Vec2::new(gap_mm, gap_mm);
    let mut all = Artwork {
        width_mm: step.x * f64::from(grid.columns) - gap_mm,
        height_mm: step.y * f64::from(grid.rows) - gap_mm,
        ..Artwork::default()
    };
    let cells = (0..grid.rows).flat_map(|row| (0..grid.columns).map(move |column| (column, row)));
    for ((column, row), (artwork, ink)) in cells.zip(artworks.iter().zip(&inks).cycle()) {
        let corner = Vec2::new(f64::from(column) * step.x, f64::from(row) * step.y);
        let middle = corner + cell / 2.0;
        all.add(artwork.clone().moved(middle - ink.center().to_vec2()));
    }
    all
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_geometry::{Point, Stroke};
    use dobot_import::Layer;

    use super::*;

    #[test]
    fn copies_are_placed_in_columns_and_rows_with_a_gap() {
        let layer = Layer {
            strokes: vec![Stroke::open(vec![
                Point::new(1.0, 2.0),
                Point::new(11.0, 22.0),
            ])],
            ..Layer::default()
        };
        let page = Artwork {
            width_mm: 100.0,
            height_mm: 200.0,
            has_page: true,
            layers: vec![layer],
            ..Artwork::default()
        };
        let all = in_cells(&[page], "2x3".parse().unwrap(), 5.0);
        assert_eq!((all.width_mm, all.height_mm), (25.0, 70.0));
        let places = all.layers[0].strokes.iter().map(|stroke| stroke.points[0]);
        let places: Vec<_> = places.map(|p| (p.x, p.y)).collect();
        assert_eq!(places[..3], [(0.0, 0.0), (15.0, 0.0), (0.0, 25.0)]);
        assert_eq!(places.len(), 6);
        for wrong in ["2", "0x3", "x", "101x1", "2x-1"] {
            assert!(wrong.parse::<Grid>().is_err(), "{wrong}");
        }
    }
}
