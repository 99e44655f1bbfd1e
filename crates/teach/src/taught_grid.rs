//! Grids taught by three corners.

use std::str::FromStr;

use dobot_arm::Position;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::axes::{Axes, dot};
use crate::recorded_path::rounded;
use crate::{Frame, Grid, Offset, Place, Point, ProgramError, RecordedPlace};

/// A grid taught by three corners, with a frame of the same name: a tray that was moved needs only new points of the
/// frame.
///
/// ```text
///   end of the first column
///        o   .   .
///        .   .   .
///        o   .   o
///   first cell   end of the first row
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TaughtGrid {
    /// The frame: its origin is the first cell, its x axis is the first row, and its z axis points up.
    pub frame: Frame,
    /// The grid in this frame.
    pub grid: Grid,
    /// The angle between the first row and the first column, in degrees; the rows of the grid are at right angles.
    pub corner_deg: f64,
}

/// The number of cells of a grid. As a text: `3x4`, or with layers `3x4x2`.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GridSize {
    /// The cells in a row, 1 to 1000.
    #[schemars(range(min = 1, max = 1000))]
    pub columns: u32,
    /// The rows in a layer, 1 to 1000.
    #[schemars(range(min = 1, max = 1000))]
    pub rows: u32,
    /// The layers, 1 to 1000.
    #[serde(default = "one")]
    #[schemars(range(min = 1, max = 1000))]
    pub layers: u32,
    /// The distance from a layer to the next one, in mm upwards; negative goes down, from the top of
    /// a stack. With one layer 0.
    #[serde(default)]
    pub layer_mm: f64,
}

const fn one() -> u32 {
    1
}

impl FromStr for GridSize {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let count = |text: &str| {
            text.trim()
                .parse()
                .ok()
                .filter(|count| (1..=MAX_CELLS).contains(count))
        };
        let counts: Option<Vec<u32>> = text.split('x').map(count).collect();
        let (columns, rows, layers) = match counts.as_deref() {
            Some([columns, rows]) => (*columns, *rows, 1),
            Some([columns, rows, layers]) => (*columns, *rows, *layers),
            _ => {
                return Err(format!(
                    "the size is {text:?}; allowed are columns x rows, for example 3x4, and columns x rows x layers, for example 3x4x2, each 1 to {MAX_CELLS}"
                ));
            }
        };
        Ok(Self {
            columns,
            rows,
            layers,
            layer_mm: 0.0,
        })
    }
}

/// The most cells of a grid in one direction.
const MAX_CELLS: u32 = 1000;

impl TaughtGrid {
    /// Computes the grid of these corners: the first cell, the end of the first row and the end of the first column.
    /// With a single column, the second place gives only the direction of the rows; with a single row, the third one
    /// only the plane.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if the corners lie on one line or are less than 1 mm apart, or several layers
    /// have no distance.
    pub fn of(
        name: &str,
        corners: &[RecordedPlace; 3],
        size: GridSize,
    ) -> Result<Self, ProgramError> {
        let GridSize {
            columns,
            rows,
            layers,
            layer_mm,
        } = size;
        if layers > 1 && layer_mm == 0.0 {
            return Err(ProgramError::new(format!(
                "the grid has {layers} layers with 0 mm between them; enter the distance from a layer to the next one"
            )));
        }
        let [first, row_end, column_end] = corners.map(|corner| {
            let [x, y, z] = corner.point_mm;
            Position::new(x, y, z)
        });
        let (row, column) = (row_end - first, column_end - first);
        let mut axes = Axes::of(first, row_end, column_end).map_err(|_| on_one_line())?;
        let mut beside = column_end;
        if axes.is_upside_down() {
            // The same plane with the third point on the other side: heights in the frame count upwards.
            beside = first - column;
            axes = Axes::of(first, row_end, beside).map_err(|_| on_one_line())?;
        }
        let [_, height, _] = axes.locate(column_end);
        let point = |at: Position| {
            let [x, y, z] = [at.x, at.y, at.z].map(|along| rounded(along.0, 100.0));
            Place::At(Point::xyz(x, y, z))
        };
        let cosine = dot(row, column) / (row.length().0 * column.length().0);
        Ok(Self {
            frame: Frame {
                origin: point(first),
                x: point(row_end),
                y: point(beside),
            },
            grid: Grid {
                at: Place::At(corners[0].point_in(name, &axes)),
                columns,
                rows,
                layers,
                pitch: Offset {
                    x: pitch(row.length().0, columns),
                    y: pitch(height, rows),
                    z: if layers > 1 { layer_mm } else { 0.0 },
                },
            },
            corner_deg: cosine.clamp(-1.0, 1.0).acos().to_degrees(),
        })
    }
}

/// The distance between cells, to a thousandth of a millimetre; 0 for a single one.
fn pitch(along_mm: f64, cells: u32) -> f64 {
    match cells {
        0 | 1 => 0.0,
        cells => rounded(along_mm / f64::from(cells - 1), 1000.0),
    }
}

fn on_one_line() -> ProgramError {
    ProgramError::new(
        "the three corners lie on one line or are less than 1 mm apart; touch the first cell, the end of its row and the end of its column",
    )
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    fn size(text: &str) -> GridSize {
        text.parse().unwrap()
    }

    #[test]
    fn a_size_is_columns_rows_and_layers() {
        let found = size("3 x 4 x 2");
        assert_eq!((found.columns, found.rows, found.layers), (3, 4, 2));
        assert_eq!(size("3x4").layers, 1);
        for wrong in ["", "3", "3x", "0x4", "3x4x1001", "3x4x2x1", "-3x4"] {
            let error = wrong.parse::<GridSize>().unwrap_err();
            assert!(error.contains("for example 3x4x2"), "{wrong}: {error}");
        }
    }

    #[test]
    fn layers_lie_above_each_other_and_need_a_distance() {
        let corners = [[200.0, 0.0, 0.0], [260.0, 0.0, 0.0], [200.0, 50.0, 0.0]].map(place);
        let stack = GridSize {
            layer_mm: 22.0,
            ..size("3x2x4")
        };
        let grid = TaughtGrid::of("tray", &corners, stack).unwrap().grid;
        assert_eq!((grid.layers, grid.pitch.z), (4, 22.0));
        let error = TaughtGrid::of("tray", &corners, size("3x2x4")).unwrap_err();
        assert!(error.to_string().contains("4 layers"), "{error}");
    }

    fn place(point_mm: [f64; 3]) -> RecordedPlace {
        RecordedPlace {
            point_mm,
            rotation_deg: 30.0,
            suction: false,
            gripper_deg: 0.0,
        }
    }

    #[test]
    fn a_turned_tray_has_its_rows_along_the_frame_and_keeps_the_rotation_of_the_tool() {
        let corners = [
            [200.0, 0.0, -40.0],
            [200.0, 60.0, -40.0],
            [170.0, 0.0, -40.0],
        ]
        .map(place);
        let taught = TaughtGrid::of("tray", &corners, size("3x2")).unwrap();
        assert_eq!(taught.grid.pitch.x, 30.0);
        assert_eq!(taught.grid.pitch.y, 30.0);
        // The x axis points to the left, 90 degrees from the base's.
        let rotation = Some(-60.0);
        let position = [0.0; 3];
        let frame = Some("tray".to_owned());
        let at = Point::Cartesian {
            position,
            rotation,
            frame,
        };
        assert_eq!(taught.grid.at, Place::At(at));
        assert!((taught.corner_deg - 90.0).abs() < 1e-9, "{taught:?}");
    }

    #[test]
    fn heights_in_a_tray_count_upwards_on_whichever_side_its_columns_are() {
        for (side, pitch) in [(1.0, 25.0), (-1.0, -25.0)] {
            let corners = [
                [200.0, 0.0, 0.0],
                [260.0, 0.0, 0.0],
                [200.0, 50.0 * side, 0.0],
            ]
            .map(place);
            let taught = TaughtGrid::of("tray", &corners, size("3x3")).unwrap();
            assert_eq!(taught.grid.pitch.y, pitch);
            assert_eq!(taught.frame.y, Place::At(Point::xyz(200.0, 50.0, 0.0)));
        }
    }

    #[test]
    fn a_single_row_has_no_distance_to_the_next_one() {
        let corners = [[200.0, 0.0, 0.0], [260.0, 0.0, 0.0], [200.0, 50.0, 0.0]].map(place);
        let pitch = TaughtGrid::of("tray", &corners, size("4x1"))
            .unwrap()
            .grid
            .pitch;
        assert_eq!((pitch.x, pitch.y), (20.0, 0.0));
    }

    #[test]
    fn corners_on_one_line_are_refused() {
        let corners = [[200.0, 0.0, 0.0], [260.0, 0.0, 0.0], [290.0, 0.0, 0.0]].map(place);
        let error = TaughtGrid::of("tray", &corners, size("2x2")).unwrap_err();
        assert!(error.to_string().contains("on one line"), "{error}");
    }
}
