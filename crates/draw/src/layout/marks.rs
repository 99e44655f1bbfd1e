//! A border, crop marks and a signature around a drawing.

use std::sync::Arc;

use dobot_geometry::{Point, Rect, Stroke, Vec2, bounds};
use dobot_import::{
    Artwork, Font, Layer, ReadOptions, Source, SourceError, StrokeFont, Text, Warning,
};

use super::place::{PlaceError, Placement};
use super::sheet::{PaperSize, SheetPlace};
use crate::prepare::Settings;

/// What is drawn around a drawing: within the margin of its sheet, or around its ink.
///
/// ```text
///    |              |
///   -+--------------+-      crop marks at the corners of the border
///    |   drawing    |
///    |        signed|
///   -+--------------+-
///    |              |
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Marks {
    /// Whether there is a border.
    pub border: bool,
    /// Whether there are crop marks, outside the border.
    pub crop_marks: bool,
    /// The signature in the lower right corner.
    pub signature: Option<String>,
}

/// Marks with the lines of their signature.
#[derive(Debug)]
pub(crate) struct DrawnMarks<'a> {
    marks: &'a Marks,
    gap_mm: f64,
    signature: Option<Artwork>,
}

impl Marks {
    /// Returns the space on each side of the drawing, in mm.
    pub(crate) fn around_mm(&self, gap_mm: f64) -> f64 {
        self.crop_mm() + if self.border { gap_mm } else { 0.0 }
    }

    fn crop_mm(&self) -> f64 {
        if self.crop_marks { CROP_MM[1] } else { 0.0 }
    }
}

impl<'a> DrawnMarks<'a> {
    /// Reads the signature.
    pub(crate) fn read(settings: &'a Settings) -> Result<(Self, Vec<Warning>), SourceError> {
        let marks = &settings.marks;
        let read = marks.signature.as_ref().map(|signature| {
            let text = Text {
                font: Font::Stroke(StrokeFont::Script),
                height_mm: SIGNATURE_MM,
                ..Text::new(signature)
            };
            Source::Text(text).read(&ReadOptions {
                tolerance_mm: settings.flatten_mm(),
                fonts: Arc::clone(&settings.fonts),
                ..ReadOptions::default()
            })
        });
        let (signature, warnings) = read.transpose()?.unzip();
        let drawn = Self {
            marks,
            gap_mm: settings.gap_mm,
            signature,
        };
        Ok((drawn, warnings.unwrap_or_default()))
    }

    /// Returns the placement with space for the marks.
    pub(crate) fn reserve(&self, placement: Placement) -> Placement {
        Placement {
            around_mm: self.marks.around_mm(self.gap_mm),
            below_mm: self.below_mm(),
            ..placement
        }
    }

    fn below_mm(&self) -> f64 {
        let height_mm = self
            .signature
            .as_ref()
            .map(|text| text.height_mm + self.gap_mm);
        height_mm.unwrap_or_default()
    }

    /// Adds the marks to placed layers: to the last one, or as a layer of their own if layers are
    /// drawn separately.
    pub(crate) fn add_to(
        self,
        layers: &mut Vec<Layer>,
        settings: &Settings,
    ) -> Result<(), PlaceError> {
        if *self.marks == Marks::default() {
            return Ok(());
        }
        let ink = bounds(layers.iter().flat_map(Layer::points));
        let strokes = self.strokes(ink, &settings.placement)?;
        match layers.last_mut().filter(|_| settings.layers.is_none()) {
            Some(last) => last.strokes.extend(strokes),
            None => layers.push(Layer {
                name: LAYER.to_owned(),
                strokes,
                ..Layer::default()
            }),
        }
        Ok(())
    }

    /// Returns the lines of the marks in the base frame, for a drawing with this ink.
    fn strokes(self, ink: Rect, placement: &Placement) -> Result<Vec<Stroke>, PlaceError> {
        let (sheet, frame) = self.frame(ink, placement);
        let mut strokes = Vec::new();
        if self.marks.border {
            strokes.push(border(frame));
        }
        if self.marks.crop_marks {
            strokes.extend(crop_marks(frame));
        }
        let border_mm = if self.marks.border { self.gap_mm } else { 0.0 };
        let room = frame.inflate(-border_mm, -border_mm);
        if let Some(signature) = self.signature {
            let (width_mm, room_mm) = (signature.width_mm, room.width());
            if width_mm > room_mm {
                return Err(PlaceError::Signature { width_mm, room_mm });
            }
            let way = Vec2::new(room.x1 - width_mm, room.y1 - signature.height_mm);
            let layers = signature.moved(way).layers;
            strokes.extend(layers.into_iter().flat_map(|layer| layer.strokes));
        }
        for p in strokes.iter_mut().flat_map(|stroke| &mut stroke.points) {
            if placement.mirrors {
                p.x = frame.x0 + frame.x1 - p.x;
            }
            *p = sheet.place(*p);
        }
        Ok(strokes)
    }

    /// Returns the rectangle of the border on the sheet, or on one around the ink.
    fn frame(&self, ink: Rect, placement: &Placement) -> (SheetPlace, Rect) {
        if let Some(sheet) = placement.sheet {
            let crop_mm = self.marks.crop_mm();
            let room = sheet.room(placement.margin_mm);
            return (sheet, room.inflate(-crop_mm, -crop_mm));
        }
        // For a person behind the arm, right is -Y.
        let size = PaperSize {
            width_mm: ink.height(),
            height_mm: ink.width(),
        };
        let border_mm = if self.marks.border { self.gap_mm } else { 0.0 };
        let signature_mm = self.signature.as_ref().map_or(0.0, |text| text.width_mm);
        let wider_mm = (signature_mm - size.width_mm).max(0.0) / 2.0;
        let room = Rect::new(0.0, 0.0, size.width_mm, size.height_mm + self.below_mm());
        let sheet = SheetPlace::centered(size, ink.center());
        (sheet, room.inflate(border_mm + wider_mm, border_mm))
    }
}

fn border(frame: Rect) -> Stroke {
    let Rect { x0, y0, x1, y1 } = frame;
    let corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)].map(Point::from);
    Stroke {
        points: corners.to_vec(),
        closed: true,
    }
}

/// Returns two lines at each corner, outside the frame.
fn crop_marks(frame: Rect) -> impl Iterator<Item = Stroke> {
    let Rect { x0, y0, x1, y1 } = frame;
    let corners = [
        (x0, y0, -1.0, -1.0),
        (x1, y0, 1.0, -1.0),
        (x1, y1, 1.0, 1.0),
        (x0, y1, -1.0, 1.0),
    ];
    corners.into_iter().flat_map(|(x, y, right, down)| {
        [Vec2::new(right, 0.0), Vec2::new(0.0, down)].map(|way| {
            let ends = CROP_MM.map(|mm| Point::new(x, y) + way * mm);
            Stroke::open(ends.to_vec())
        })
    })
}

/// Start and end of a crop mark, as distances from its corner.
const CROP_MM: [f64; 2] = [2.0, 7.0];
/// The height of the capitals of a signature.
const SIGNATURE_MM: f64 = 4.0;
/// The name of the layer of the marks.
const LAYER: &str = "marks";

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn settings(sheet: Option<&str>, margin_mm: f64, marks: Marks) -> Settings {
        let mut settings = Settings {
            marks,
            ..Settings::default()
        };
        settings.placement.margin_mm = margin_mm;
        settings.placement.sheet =
            sheet.map(|size| SheetPlace::centered(size.parse().unwrap(), Point::new(220.0, 0.0)));
        settings
    }

    /// A line of 40 x 20 mm, placed with its marks: the ink of the line, and the marks.
    fn drawn(settings: &mut Settings) -> (Rect, Vec<Stroke>) {
        let line = Stroke::open(vec![Point::new(0.0, 0.0), Point::new(40.0, 20.0)]);
        let artwork = Artwork {
            width_mm: 40.0,
            height_mm: 20.0,
            layers: vec![Layer {
                strokes: vec![line],
                ..Layer::default()
            }],
            ..Artwork::default()
        };
        let before = settings.clone();
        let (marks, warnings) = DrawnMarks::read(&before).unwrap();
        assert_eq!(warnings, []);
        settings.placement = marks.reserve(settings.placement);
        let mut layers = settings.placement.place(artwork).unwrap().layers;
        marks.add_to(&mut layers, settings).unwrap();
        let mut strokes = layers.remove(0).strokes;
        let marks = strokes.split_off(1);
        (bounds(strokes.remove(0).points), marks)
    }

    fn all(marks: &[Stroke]) -> Rect {
        bounds(
            marks
                .iter()
                .flat_map(|stroke| stroke.points.iter().copied()),
        )
    }

    #[test]
    fn a_border_is_at_the_margin_of_the_sheet_or_around_the_ink() {
        let border = Marks {
            border: true,
            ..Marks::default()
        };
        let (_, marks) = drawn(&mut settings(Some("100x80"), 10.0, border.clone()));
        assert_eq!(all(&marks), Rect::new(190.0, -40.0, 250.0, 40.0));
        assert!(marks[0].closed);
        let (ink, marks) = drawn(&mut settings(None, 0.0, border));
        assert_eq!(all(&marks), ink.inflate(5.0, 5.0));
    }

    #[test]
    fn a_fitted_drawing_has_a_gap_to_its_border_and_everything_is_within_the_margin() {
        let mut settings = settings(
            Some("100x80"),
            10.0,
            Marks {
                border: true,
                crop_marks: true,
                signature: Some("Hugo".to_owned()),
            },
        );
        settings.placement.size = crate::Size::Fit;
        let (ink, marks) = drawn(&mut settings);
        let sheet = Rect::new(180.0, -50.0, 260.0, 50.0);
        let within = all(&marks);
        assert_eq!(within, sheet.inflate(-10.0, -10.0));
        let border = all(&marks[..1]);
        assert_eq!(border, within.inflate(-7.0, -7.0));
        assert!((ink.x1 - (border.x1 - 5.0)).abs() < 1e-9, "{ink:?}");
        assert!(ink.height() < border.height() - 10.0, "{ink:?}");
        // The signature is between the ink and the lower right corner.
        let signature = all(&marks[9..]);
        assert!(
            (signature.y0 - (border.y0 + 5.0)).abs() < 1e-9,
            "{signature:?}"
        );
        assert!(
            (signature.x0 - (border.x0 + 5.0)).abs() < 1e-9,
            "{signature:?}"
        );
        assert!(signature.x1 <= ink.x0 - 5.0 + 1e-9, "{signature:?} {ink:?}");
    }

    #[test]
    fn crop_marks_are_outside_the_corners_and_do_not_touch_them() {
        let crop_marks = Marks {
            crop_marks: true,
            ..Marks::default()
        };
        let (ink, marks) = drawn(&mut settings(None, 0.0, crop_marks));
        assert_eq!(marks.len(), 8);
        assert_eq!(all(&marks), ink.inflate(7.0, 7.0));
        for mark in &marks {
            assert!(mark.points.iter().all(|p| !ink.contains(*p)), "{mark:?}");
            assert_eq!(mark.length_mm(), 5.0);
        }
    }

    #[test]
    fn a_signature_is_mirrored_with_the_drawing_and_needs_room() {
        let signed = |text: &str| Marks {
            signature: Some(text.to_owned()),
            ..Marks::default()
        };
        let mut plain = settings(Some("100x80"), 0.0, signed("Hugo"));
        let right = all(&drawn(&mut plain).1);
        plain.placement.mirrors = true;
        let left = all(&drawn(&mut plain).1);
        assert!(
            (right.y0 + 50.0).abs() < 1e-9 && (left.y1 - 50.0).abs() < 1e-9,
            "{right:?} {left:?}"
        );
        let long = settings(Some("100x80"), 0.0, signed(&"Hugo ".repeat(20)));
        let (marks, _) = DrawnMarks::read(&long).unwrap();
        let error = marks
            .add_to(&mut Vec::new(), &long)
            .unwrap_err()
            .to_string();
        assert!(
            error.starts_with("the signature is ") && error.contains("100.0 mm"),
            "{error}"
        );
        // Without a sheet the drawing may be narrower than its signature.
        let mut small = settings(None, 0.0, signed("Hugo the Second of Somewhere"));
        let (ink, marks) = drawn(&mut small);
        assert!(all(&marks).height() > ink.height());
        assert!(all(&marks).center().y.abs() < 1e-9);
    }

    #[test]
    fn marks_are_a_layer_of_their_own_if_layers_are_drawn_separately() {
        let mut separate = settings(
            None,
            0.0,
            Marks {
                border: true,
                ..Marks::default()
            },
        );
        separate.layers = Some(dobot_import::LayersBy::Color);
        let mut layers = vec![Layer {
            name: "red".to_owned(),
            strokes: vec![Stroke::open(vec![Point::ORIGIN])],
            ..Layer::default()
        }];
        let (marks, _) = DrawnMarks::read(&separate).unwrap();
        marks.add_to(&mut layers, &separate).unwrap();
        assert_eq!(layers[1].name, "marks");
        assert_eq!((layers[0].strokes.len(), layers[1].strokes.len()), (1, 1));
    }
}
