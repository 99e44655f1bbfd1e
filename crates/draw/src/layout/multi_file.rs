//! Several files on one page, with a text below.

use dobot_geometry::{Rect, Vec2, bounds};
use dobot_import::{Align, Artwork, Source};

use crate::layout::copies::{Grid, in_cells};
use crate::layout::place::{PlaceError, Size};
use crate::prepare::Settings;

/// Combines all parts on one page: files at their places on their own pages or in the cells of a
/// grid, and texts below all files, on the side to which their lines are aligned.
///
/// # Errors
///
/// [`PlaceError::Cells`] if the grid has fewer cells than there are files.
pub(crate) fn combine(
    parts: Vec<(&Source, Artwork)>,
    settings: &Settings,
) -> Result<Artwork, PlaceError> {
    let is_text = |file: &(&Source, Artwork)| is_text(file.0);
    let (texts, files): (Vec<_>, Vec<_>) = if parts.iter().all(is_text) {
        (Vec::new(), parts)
    } else {
        parts.into_iter().partition(is_text)
    };
    let mut page = side_by_side(files.into_iter().map(|file| file.1).collect(), settings)?;
    for (source, text) in texts {
        let align = match source {
            Source::Text(text) => text.align,
            _ => Align::Left,
        };
        page = captioned(page, text, align, settings.gap_mm);
    }
    Ok(page)
}

/// Returns the scale of each source on the page, if the page is drawn at `page_scale`: a file that
/// is fitted to its cell of a grid fills it, and a text below files may keep its height on the
/// paper. `inks` are the extents of the sources.
///
/// # Errors
///
/// [`PlaceError`] if margin, marks or gaps leave no space for the cells.
pub(crate) fn scales(
    sources: &[&Source],
    inks: &[Rect],
    settings: &Settings,
    page_scale: f64,
) -> Result<Vec<f64>, PlaceError> {
    let cell = match settings
        .grid
        .filter(|_| settings.placement.size == Size::Fit)
    {
        Some(grid) => Some(cell(grid, settings)?),
        None => None,
    };
    let has_files = !sources.iter().all(|source| is_text(source));
    let scale = |(source, ink): (&&Source, &Rect)| {
        if has_files && is_text(source) {
            let scale = if settings.keeps_text_height {
                page_scale
            } else {
                1.0
            };
            return scale.recip();
        }
        let fitting = cell.map(|cell| (cell.x / ink.width()).min(cell.y / ink.height()));
        // A dot fits at any scale.
        fitting.filter(|scale| scale.is_finite()).unwrap_or(1.0)
    };
    Ok(sources.iter().zip(inks).map(scale).collect())
}

/// Returns width and height of a cell on the paper.
fn cell(grid: Grid, settings: &Settings) -> Result<Vec2, PlaceError> {
    let room = settings.placement.room_mm()?;
    let side = |room_mm: f64, count: u32| {
        let count = f64::from(count);
        (room_mm - (count - 1.0) * settings.gap_mm) / count
    };
    let cell = Vec2::new(side(room.x, grid.columns), side(room.y, grid.rows));
    if cell.x > 0.0 && cell.y > 0.0 {
        return Ok(cell);
    }
    Err(PlaceError::Gaps {
        room_mm: [room.x, room.y],
    })
}

pub(crate) const fn is_text(source: &Source) -> bool {
    matches!(source, Source::Text(_))
}

fn side_by_side(files: Vec<Artwork>, settings: &Settings) -> Result<Artwork, PlaceError> {
    if let Some(grid) = settings.grid {
        let cells = grid.columns * grid.rows;
        if files.len() > cells as usize {
            let files = files.len();
            return Err(PlaceError::Cells { cells, files });
        }
        return Ok(in_cells(&files, grid, settings.gap_mm));
    }
    let mut files = files.into_iter();
    let mut page = files.next().unwrap_or_default();
    for file in files {
        page.width_mm = page.width_mm.max(file.width_mm);
        page.height_mm = page.height_mm.max(file.height_mm);
        page.has_page |= file.has_page;
        page.add(file);
    }
    Ok(page)
}

/// Adds a text below the ink of a page. The page grows if the text exceeds it.
fn captioned(mut page: Artwork, text: Artwork, align: Align, gap_mm: f64) -> Artwork {
    let [ink, letters] = [&page, &text].map(|artwork| bounds(artwork.points()));
    let x = match align {
        Align::Left => ink.x0 - letters.x0,
        Align::Center => ink.center().x - letters.center().x,
        Align::Right => ink.x1 - letters.x1,
    };
    let way = Vec2::new(x, ink.y1 + gap_mm - letters.y0);
    let grown = Rect::new(0.0, 0.0, page.width_mm, page.height_mm).union(letters + way);
    page.add(text.moved(way));
    Artwork {
        width_mm: grown.width(),
        height_mm: grown.height(),
        ..page.moved(-grown.origin().to_vec2())
    }
}

#[cfg(test)]
mod tests {
    use dobot_geometry::{Point, Stroke};
    use dobot_import::{Layer, Text};

    use super::*;

    /// A page of 100 x 50 mm with a line between two places on it.
    fn page(name: &str, from: (f64, f64), to: (f64, f64)) -> Artwork {
        let line = Stroke::open(vec![Point::from(from), Point::from(to)]);
        Artwork {
            width_mm: 100.0,
            height_mm: 50.0,
            has_page: true,
            layers: vec![Layer {
                name: name.to_owned(),
                strokes: vec![line],
                ..Layer::default()
            }],
            ..Artwork::default()
        }
    }

    fn place(artwork: &Artwork, layer: usize, stroke: usize) -> (f64, f64) {
        let p = artwork.layers[layer].strokes[stroke].points[0];
        (p.x, p.y)
    }

    #[test]
    fn files_keep_their_places_on_the_page_and_share_layers_of_the_same_name() {
        let file = Source::from("");
        let parts = vec![
            (&file, page("red", (10.0, 5.0), (20.0, 5.0))),
            (&file, page("blue", (30.0, 5.0), (40.0, 5.0))),
            (&file, page("red", (70.0, 5.0), (80.0, 5.0))),
        ];
        let all = combine(parts, &Settings::default()).expect("there is no grid");
        assert_eq!((all.width_mm, all.height_mm), (100.0, 50.0));
        let names: Vec<_> = all.layers.iter().map(|layer| layer.name.as_str()).collect();
        assert_eq!(names, ["red", "blue"]);
        assert_eq!(place(&all, 0, 1), (70.0, 5.0));
    }

    #[test]
    fn a_grid_has_a_cell_for_each_file_or_reports_how_many_are_missing() {
        let file = Source::from("");
        let parts = || {
            vec![
                (&file, page("a", (10.0, 5.0), (30.0, 15.0))),
                (&file, page("b", (0.0, 0.0), (10.0, 10.0))),
            ]
        };
        let in_grid = |grid: &str| {
            let grid = grid.parse().ok();
            let settings = Settings {
                grid,
                ..Settings::default()
            };
            combine(parts(), &settings)
        };
        // Cells of 20 x 10 mm, 5 mm apart; b is centred in the second and the fourth.
        let all = in_grid("2x2").expect("there are enough cells");
        assert_eq!((all.width_mm, all.height_mm), (45.0, 25.0));
        assert_eq!(place(&all, 0, 1), (0.0, 15.0));
        assert_eq!(place(&all, 1, 0), (30.0, 0.0));
        assert_eq!(place(&all, 1, 1), (30.0, 15.0));
        let error = in_grid("1x1").expect_err("there are too few").to_string();
        assert!(
            error.contains("1 cell") && error.contains("2 files"),
            "{error}"
        );
    }

    #[test]
    fn a_text_is_placed_below_the_ink_and_the_page_grows_for_it() {
        let file = Source::from("");
        let text = |align| {
            Source::Text(Text {
                align,
                ..Text::new("")
            })
        };
        let letters = page("text", (0.0, 0.0), (40.0, 10.0));
        for (align, x) in [
            (Align::Left, 10.0),
            (Align::Center, 20.0),
            (Align::Right, 30.0),
        ] {
            let text = text(align);
            let drawing = page("red", (10.0, 5.0), (70.0, 42.0));
            let parts = vec![(&text, letters.clone()), (&file, drawing)];
            let all = combine(parts, &Settings::default()).expect("there is no grid");
            assert_eq!(place(&all, 1, 0), (x, 47.0));
            assert_eq!((all.width_mm, all.height_mm), (100.0, 57.0));
        }
    }
}
