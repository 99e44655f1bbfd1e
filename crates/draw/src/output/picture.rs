//! The picture of a drawing: ink, accuracy and position.

mod colors;
mod lines;
mod page;
mod words;

use resvg::tiny_skia::{Color, Pixmap, Transform};
use thiserror::Error;

pub use self::colors::Colors;
use self::lines::{area_on_picture, by_class, on_picture, seen};
use self::page::{frame, workspace};
use crate::layout::sheet::SheetPlace;
use crate::output::estimate::PassFigures;
use crate::output::ink::InkLine;
use dobot_geometry::{Point, Rect, Stroke, bounds};
use dobot_lettering::{ShapeStyle, Sheet};
use dobot_plan::{MoveKind, Plan};

/// A picture of the paper from above as seen from behind the arm: X up, Y to the left.
#[derive(Clone, Debug)]
pub struct Picture<'a> {
    /// The title above the picture, on the left.
    pub title: &'a str,
    /// The names and values below the picture.
    pub figures: &'a [(String, String)],
    /// The statistics of each pass, shown below if there are several.
    pub passes: &'a [PassFigures],
    /// The drawing area, in the base frame.
    pub area: Rect,
    /// The sheet, instead of the area.
    pub sheet: Option<SheetPlace>,
    /// The plan: the wanted lines and the travel moves.
    pub plan: &'a Plan,
    /// The ink; the wanted lines show through where it is missing.
    pub drawn: &'a [InkLine],
    /// The meaning of the ink's colours.
    pub colors: Colors,
    /// The visible part of the workspace.
    pub view: View,
}

/// The visible part of the workspace.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum View {
    /// The paper around the drawing area.
    #[default]
    Paper,
    /// The whole reach of the arm.
    Reach,
}

/// The error returned when a picture cannot be converted to PNG.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum PictureError {
    /// The size is out of range.
    #[error("the picture width is {0} pixels; allowed are 16 to 16384")]
    Width(u32),
    /// The picture could not be rendered.
    #[error("the picture could not be rendered: {0}")]
    Render(String),
}

impl Picture<'_> {
    /// Returns the picture as SVG, in true millimetres. It needs no fonts.
    #[must_use]
    pub fn to_svg(&self) -> String {
        let paper = self.paper();
        let unit = unit(paper);
        let side = 8.0 * unit;
        let page = Rect::new(
            paper.x0 - side,
            paper.y0 - 14.0 * unit,
            paper.x1 + side,
            paper.y1 + self.words_high() * unit,
        );
        let mut sheet = Sheet::with_background(frame(page));
        sheet.paper(&frame(paper), 3.0, |sheet| {
            workspace(sheet, self.area, self.sheet.as_ref(), unit);
            self.lines(sheet);
            let corner = [paper.x1 - 6.0 * unit, paper.y1 - 5.5 * unit];
            sheet.scale_bar(corner, 50.0, unit);
        });
        self.words(&mut sheet, paper);
        sheet.finish()
    }

    /// Returns the picture as PNG.
    ///
    /// # Errors
    ///
    /// [`PictureError`] if the width is not 16 to 16384 pixels or there is not enough memory.
    pub fn to_png(&self, width_px: u32) -> Result<Vec<u8>, PictureError> {
        if !(16..=16_384).contains(&width_px) {
            return Err(PictureError::Width(width_px));
        }
        let render = PictureError::Render;
        let tree = resvg::usvg::Tree::from_str(&self.to_svg(), &resvg::usvg::Options::default());
        let tree = tree.map_err(|error| render(error.to_string()))?;
        #[expect(clippy::cast_precision_loss, reason = "at most 16384")]
        let scale = width_px as f32 / tree.size().width();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a few thousand"
        )]
        let height_px = (tree.size().height() * scale).ceil() as u32;
        let mut pixmap =
            Pixmap::new(width_px, height_px).ok_or_else(|| render("out of memory".to_owned()))?;
        // The last row may be covered in part.
        pixmap.fill(Color::WHITE);
        resvg::render(
            &tree,
            Transform::from_scale(scale, scale),
            &mut pixmap.as_mut(),
        );
        encoded(&pixmap).map_err(|error| render(error.to_string()))
    }

    /// Returns the sheet or the area, on the picture.
    fn ground(&self) -> Rect {
        let corners = self
            .sheet
            .map(|sheet| bounds(sheet.corners().map(on_picture)));
        corners.unwrap_or(area_on_picture(self.area))
    }

    /// Returns the visible part, on the picture.
    fn paper(&self) -> Rect {
        let lines = self
            .drawn
            .iter()
            .flat_map(|line| &line.stroke.points)
            .copied();
        let shown = bounds(lines.map(on_picture)).union(self.ground());
        match self.view {
            View::Paper => {
                // Both arcs of the reach, straight ahead.
                let [near, far] = REACH_MM.map(|x| on_picture(Point::new(x, 0.0)));
                let shown = shown.inflate(12.0, 12.0);
                shown.union_pt(near).union_pt(far).inflate(4.0, 4.0)
            }
            View::Reach => {
                let [_, far] = REACH_MM;
                Rect::new(-far, -far, far, far)
                    .union(shown)
                    .inflate(8.0, 8.0)
            }
        }
    }

    /// Draws travel moves, wanted lines and ink, from bottom to top.
    fn lines(&self, sheet: &mut Sheet) {
        let planned = [MoveKind::Draw, MoveKind::Burn].map(|kind| self.plan.paths(kind));
        for (strokes, look) in [(self.travel(), TRAVEL), (planned.concat(), PLANNED)] {
            sheet.curves(strokes.iter().map(|stroke| seen(&stroke.points)), &look);
        }
        let class = |line: &InkLine, i: usize| self.colors.class(line, i);
        for (class, pieces) in by_class(self.drawn, class) {
            let (color, width) = self.colors.style(class, self.plan);
            let pieces = pieces.iter().map(|piece| seen(piece));
            sheet.curves(pieces, &ShapeStyle::line(&color, width));
        }
    }

    /// Returns the paths without ink, including the run-up and run-out of a laser.
    fn travel(&self) -> Vec<Stroke> {
        use MoveKind::{Brake, RunOut, RunUp, Travel};
        let kinds = [Travel, RunUp, RunOut, Brake];
        kinds.map(|kind| self.plan.paths(kind)).concat()
    }
}

/// Returns the text size, which grows with the paper.
fn unit(paper: Rect) -> f64 {
    paper.width() / 230.0
}

/// Returns a PNG file of an opaque picture. Filters suit photos: flat colours are packed faster and
/// smaller without.
fn encoded(pixmap: &Pixmap) -> Result<Vec<u8>, png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, pixmap.width(), pixmap.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_filter(png::Filter::NoFilter);
    let pixels = pixmap.pixels().iter();
    let bytes: Vec<u8> = pixels
        .flat_map(|pixel| [pixel.red(), pixel.green(), pixel.blue()])
        .collect();
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&bytes)?;
    writer.finish()?;
    Ok(file)
}

/// The minimum and maximum reach of a stock arm's tool from the base axis.
const REACH_MM: [f64; 2] = [129.0, 321.0];
const TRAVEL: ShapeStyle<'_> = ShapeStyle::line("#5b9bc8", 0.16).dashed("1.3 1.3");
const PLANNED: ShapeStyle<'_> = ShapeStyle::line("#cfc8b8", 0.3);

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use dobot_plan::{ArmLimits, DrawingTool, Paper, Pass};

    fn strokes() -> Vec<Stroke> {
        let line = |points: &[(f64, f64)]| {
            Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
        };
        vec![
            line(&[(200.0, 50.0), (260.0, 50.0)]),
            line(&[(200.0, -50.0)]),
        ]
    }

    fn picture<T>(view: View, look: impl Fn(&Picture<'static>) -> T) -> T {
        let drawn = InkLine::measured(strokes(), &strokes());
        let pass = Pass::new(DrawingTool::default(), strokes());
        let plan = Plan::new(&[pass], &Paper::default(), &ArmLimits::default()).unwrap();
        look(&Picture {
            title: "a < test & more",
            figures: Box::leak(Box::new([("strokes".to_owned(), "2".to_owned())])),
            passes: &[],
            area: crate::layout::place::AREA,
            sheet: None,
            plan: Box::leak(Box::new(plan)),
            drawn: drawn.leak(),
            colors: Colors::Error { tolerance_mm: 0.05 },
            view,
        })
    }

    #[test]
    fn x_points_up_and_y_to_the_left() {
        let svg = picture(View::Paper, Picture::to_svg);
        assert!(svg.contains("M-50 -200L-50 -260"));
    }

    #[test]
    fn both_views_are_svg_files_of_their_size() {
        let options = resvg::usvg::Options::default();
        let size = |view| {
            let svg = picture(view, Picture::to_svg);
            resvg::usvg::Tree::from_str(&svg, &options).unwrap().size()
        };
        assert!(size(View::Reach).width() > size(View::Paper).width());
    }

    #[test]
    fn the_png_has_the_requested_width_and_ink_where_it_was_drawn() {
        let png = picture(View::Paper, |p| p.to_png(800).unwrap());
        let image = Pixmap::decode_png(&png).unwrap();
        assert_eq!(image.width(), 800);
        // The paper is 200 + 2 * 16 mm wide and ends 4 mm above the far arc; around it are a margin
        // of 8 and a head of 14 units of 232 / 230 mm.
        let unit = 232.0 / 230.0;
        let per_mm = 800.0 / (232.0 + 16.0 * unit);
        let at = |x: f64, y: f64| {
            let place = [116.0 + 8.0 * unit - y, 14.0 * unit + 4.0 + 321.0 - x];
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "small"
            )]
            let [across, down] = place.map(|mm| (mm * per_mm) as u32);
            image.pixel(across, down).unwrap()
        };
        assert!(at(230.0, 50.0).red() < 120);
        assert!(at(230.0, 40.0).red() > 240);
        let last = image.pixel(0, image.height() - 1).unwrap();
        assert!(last.red() > 200 && last.alpha() == 255, "{last:?}");
    }

    #[test]
    fn a_width_of_zero_is_refused() {
        let error = picture(View::Paper, |p| p.to_png(0).unwrap_err());
        assert_eq!(
            error.to_string(),
            "the picture width is 0 pixels; allowed are 16 to 16384"
        );
    }
}
