//! The picture of a drawing: what was commanded, what was drawn, and where it lies.

use std::fmt::Write as _;

use dobot_lettering::{Anchor, lettering, width};
use resvg::tiny_skia::{Pixmap, Transform};
use thiserror::Error;

use crate::plan::{MoveKind, Plan};
use crate::point::{Bounds, Point, Stroke};
use crate::simplify::simplify;

/// A picture as a person behind the arm sees the paper from above: X up, Y to the left.
#[derive(Clone, Debug)]
pub struct Picture<'a> {
    /// Above the picture, left.
    pub title: &'a str,
    /// Below the picture: what each figure is, and the figure.
    pub figures: &'a [(String, String)],
    /// The drawing area, in the base frame.
    pub area: Bounds,
    /// The plan, for the commanded path and the travel moves.
    pub plan: &'a Plan,
    /// Where the tool was while the pen was down, in the base frame.
    pub drawn: &'a [Stroke],
    /// How much of the workspace to show.
    pub view: View,
}

/// How much of the workspace a picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum View {
    /// The paper around the drawing area.
    #[default]
    Paper,
    /// All that the arm reaches.
    Reach,
}

/// Why there is no PNG.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum PictureError {
    /// No such size.
    #[error("a picture {width_px} pixels wide cannot be made; from 16 to 16384 are allowed")]
    Width {
        /// What was asked for.
        width_px: u32,
    },
    /// The picture could not be turned into pixels.
    #[error("the picture could not be turned into pixels: {reason}")]
    Render {
        /// Why.
        reason: String,
    },
}

impl Picture<'_> {
    /// The picture as the text of an SVG file, in true millimetres. It needs no fonts.
    #[must_use]
    pub fn to_svg(&self) -> String {
        let paper = self.paper();
        let unit = unit(paper);
        let page = Bounds {
            min: paper.min - Point::new(8.0, 14.0) * unit,
            max: paper.max + Point::new(8.0, 18.0) * unit,
        };
        let (left, top) = (page.min.x, page.min.y);
        let (width, height) = (page.width(), page.height());
        let mut svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width:.1}mm" height="{height:.1}mm" viewBox="{left:.1} {top:.1} {width:.1} {height:.1}" fill="none" stroke-linecap="round" stroke-linejoin="round">
<rect x="{left:.1}" y="{top:.1}" width="{width:.1}" height="{height:.1}" fill="{DESK}"/>
"#
        );
        svg += &frame(paper, r##"fill="#fffefb""##, 3.0);
        let _ = write!(
            svg,
            r#"<clipPath id="paper">{}</clipPath><g clip-path="url(#paper)">"#,
            frame(paper, "", 3.0)
        );
        svg += &self.workspace();
        svg += &self.lines();
        svg += &scale_bar(paper);
        svg += "</g>\n";
        svg += &frame(paper, r##"stroke="#c9c3b4" stroke-width="0.3""##, 3.0);
        svg += &self.words(paper);
        svg + "</svg>\n"
    }

    /// The picture as the bytes of a PNG file.
    ///
    /// # Errors
    ///
    /// [`PictureError`] where the width is not from 16 to 16384 pixels or the memory does not
    /// suffice.
    pub fn to_png(&self, width_px: u32) -> Result<Vec<u8>, PictureError> {
        if !(16..=16_384).contains(&width_px) {
            return Err(PictureError::Width { width_px });
        }
        let render = |reason: String| PictureError::Render { reason };
        let tree = usvg::Tree::from_str(&self.to_svg(), &usvg::Options::default());
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
        resvg::render(
            &tree,
            Transform::from_scale(scale, scale),
            &mut pixmap.as_mut(),
        );
        pixmap
            .encode_png()
            .map_err(|error| render(error.to_string()))
    }

    /// What is shown, on the picture.
    fn paper(&self) -> Bounds {
        let lines = self.drawn.iter().flat_map(|s| &s.points).copied();
        let shown = Bounds::of(lines.chain([self.area.min, self.area.max]).map(on_picture));
        match self.view {
            View::Paper => {
                // Both arcs of reach, straight ahead.
                let [near, far] = REACH_MM.map(|x| on_picture(Point::new(x, 0.0)));
                shown.grown(12.0).with(near).with(far).grown(4.0)
            }
            View::Reach => {
                let corner = Point::new(REACH_MM[1], REACH_MM[1]);
                let far = Bounds {
                    min: corner * -1.0,
                    max: corner,
                };
                far.with(shown.min).with(shown.max).grown(8.0)
            }
        }
    }

    /// The ring that the arm reaches, its base, and the drawing area.
    fn workspace(&self) -> String {
        let [near, far] = REACH_MM;
        let ring = format!(
            "M{far} 0A{far} {far} 0 1 0 -{far} 0A{far} {far} 0 1 0 {far} 0M{near} 0A{near} {near} 0 1 0 -{near} 0A{near} {near} 0 1 0 {near} 0"
        );
        let unit = unit(self.paper());
        let label = |reach: f64, below: f64| {
            let text = format!("reach {reach:.0} mm");
            lettering(&text, Anchor::Middle, 0.0, below * unit - reach, 1.7 * unit)
        };
        let labels = label(near, -2.2) + &label(far, 4.2);
        let area = Bounds::of([self.area.min, self.area.max].map(on_picture));
        let area = frame(
            area,
            r##"fill="#fffefb" stroke="#9fb3c2" stroke-width="0.25" stroke-dasharray="2 1.4""##,
            1.0,
        );
        format!(
            r##"<path d="{ring}" fill="#e9f0f3" fill-rule="evenodd" stroke="#9fb3c2" stroke-width="0.4"/>
{area}<g stroke="#7d8f9b" stroke-width="0.5"><circle r="38" fill="#dfe6ea"/><circle r="22" fill="#f3f6f7"/><path d="M-5 0H5M0 -5V5"/></g><g stroke="{MUTED}" stroke-width="0.75">{labels}</g>
"##
        )
    }

    /// Travel moves below, the commanded path above them, the ink on top.
    fn lines(&self) -> String {
        let group =
            |style: &str, strokes: &[Stroke]| format!("<g {style}>\n{}</g>\n", paths(strokes));
        let travel = self.plan.paths(MoveKind::Travel);
        let commanded = self.plan.paths(MoveKind::Draw);
        let drawn: Vec<Stroke> = self.drawn.iter().map(|s| simplify(s, 0.015)).collect();
        group(TRAVEL, &travel) + &group(COMMANDED, &commanded) + &group(DRAWN, &drawn)
    }

    /// Title, legend and figures.
    fn words(&self, paper: Bounds) -> String {
        let unit = unit(paper);
        let (left, above, below) = (paper.min.x, paper.min.y - 4.5 * unit, paper.max.y);
        let title = lettering(self.title, Anchor::Left, left, above, 3.6 * unit);
        let mut words = format!(r#"<g stroke="{INK}" stroke-width="0.85">{title}</g>"#);
        let mut x = left;
        for (name, figure) in self.figures {
            let name_at = lettering(name, Anchor::Left, x, below + 6.0 * unit, 1.7 * unit);
            let figure_at = lettering(figure, Anchor::Left, x, below + 11.2 * unit, 2.9 * unit);
            let _ = writeln!(
                words,
                r#"<g stroke="{MUTED}" stroke-width="0.75">{name_at}<g stroke="{INK}">{figure_at}</g></g>"#
            );
            x += width(name, 1.7 * unit).max(width(figure, 2.9 * unit)) + 8.0 * unit;
        }
        words + &legend(Point::new(paper.max.x, above), unit)
    }
}

/// How large words are: they grow with the paper.
fn unit(paper: Bounds) -> f64 {
    paper.width() / 230.0
}

/// X up, Y to the left.
fn on_picture(p: Point) -> Point {
    Point::new(-p.y, -p.x)
}

fn frame(bounds: Bounds, style: &str, radius: f64) -> String {
    format!(
        "<rect x=\"{:.2}\" y=\"{:.2}\" width=\"{:.2}\" height=\"{:.2}\" rx=\"{radius}\" {style}/>\n",
        bounds.min.x,
        bounds.min.y,
        bounds.width(),
        bounds.height()
    )
}

fn paths(strokes: &[Stroke]) -> String {
    let mut text = String::new();
    for stroke in strokes {
        text += "<path d=\"";
        for (i, p) in stroke.points.iter().map(|p| on_picture(*p)).enumerate() {
            let _ = write!(
                text,
                "{}{:.3} {:.3}",
                if i == 0 { 'M' } else { 'L' },
                p.x,
                p.y
            );
        }
        // A dot is a line of no length with round ends.
        text += if stroke.points.len() == 1 {
            "h0.001\"/>\n"
        } else {
            "\"/>\n"
        };
    }
    text
}

fn scale_bar(paper: Bounds) -> String {
    let unit = unit(paper);
    let (x, y) = (paper.max.x - 50.0 - 6.0 * unit, paper.max.y - 5.5 * unit);
    let label = lettering(
        "50 mm",
        Anchor::Middle,
        x + 25.0,
        y - 2.0 * unit,
        1.9 * unit,
    );
    let tick = 1.2 * unit;
    format!(
        r#"<g stroke="{MUTED}" stroke-width="0.35"><path d="M{x:.2} {:.2}v{tick:.2}h50v-{tick:.2}"/><g stroke-width="0.75">{label}</g></g>
"#,
        y - tick
    )
}

/// What the lines mean, right-aligned at a place.
fn legend(at: Point, unit: f64) -> String {
    let mut legend = String::new();
    let mut x = at.x;
    for (name, style) in [
        ("travel", TRAVEL),
        ("commanded", COMMANDED),
        ("drawn", DRAWN),
    ] {
        x -= width(name, 1.9 * unit);
        let name = lettering(name, Anchor::Left, x, at.y, 1.9 * unit);
        x -= 11.0 * unit;
        let (y, long) = (at.y - 0.95 * unit, 9.0 * unit);
        let _ = writeln!(
            legend,
            r#"<g stroke="{MUTED}" stroke-width="0.75">{name}</g><path {style} d="M{x:.2} {y:.2}h{long:.2}"/>"#
        );
        x -= 6.0 * unit;
    }
    legend
}

/// How near and how far the tool of a stock arm gets from the base axis.
const REACH_MM: [f64; 2] = [129.0, 321.0];
const DESK: &str = "#f4f1e9";
const INK: &str = "#1b2a41";
const MUTED: &str = "#75838d";
const TRAVEL: &str = r##"stroke="#5b9bc8" stroke-width="0.16" stroke-dasharray="1.3 1.3""##;
const COMMANDED: &str = r##"stroke="#ffd3b0" stroke-width="0.9""##;
const DRAWN: &str = r##"stroke="#1b2a41" stroke-width="0.42""##;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use crate::plan::{Machine, Paper, Pass, Tool};

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
        let drawn = Box::leak(Box::new(strokes()));
        let pass = Pass::new(Tool::default(), drawn.clone());
        let plan = Plan::new(&[pass], &Paper::default(), &Machine::default()).unwrap();
        look(&Picture {
            title: "a < test & more",
            figures: Box::leak(Box::new([("strokes".to_owned(), "2".to_owned())])),
            area: crate::place::AREA,
            plan: Box::leak(Box::new(plan)),
            drawn,
            view,
        })
    }

    #[test]
    fn x_points_up_and_y_to_the_left() {
        let svg = picture(View::Paper, Picture::to_svg);
        assert!(svg.contains("M-50.000 -200.000L-50.000 -260.000"));
    }

    #[test]
    fn both_views_are_svg_files_of_their_size() {
        let options = usvg::Options::default();
        let size = |view| {
            let svg = picture(view, Picture::to_svg);
            usvg::Tree::from_str(&svg, &options).unwrap().size()
        };
        assert!(size(View::Reach).width() > size(View::Paper).width());
    }

    #[test]
    fn the_png_has_the_width_asked_for_and_ink_where_it_was_drawn() {
        let png = picture(View::Paper, |p| p.to_png(800).unwrap());
        let image = Pixmap::decode_png(&png).unwrap();
        assert_eq!(image.width(), 800);
        // The paper is 200 + 2 * 16 mm wide and ends 4 mm above the far arc; around it a margin of
        // 8 and a head of 14 units of 232 / 230 mm.
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
    }

    #[test]
    fn a_width_of_nothing_is_refused() {
        let error = picture(View::Paper, |p| p.to_png(0).unwrap_err());
        assert_eq!(
            error.to_string(),
            "a picture 0 pixels wide cannot be made; from 16 to 16384 are allowed"
        );
    }
}
