//! The colours of a picture.

use dobot_lettering::ShapeStyle;
use dobot_plan::Plan;

use crate::output::ink::InkLine;

/// The meaning of the ink's colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Colors {
    /// The distance from the wanted path: green up to half the tolerance, amber up to the
    /// tolerance, red and wide beyond.
    Error {
        /// The tolerance, in mm.
        tolerance_mm: f64,
    },
    /// The pass: the colour in its file, darkened if it would be invisible on white, or one of
    /// eight colours.
    Passes,
}

impl Colors {
    /// Returns the class of a point: the number of its style.
    pub(super) fn class(self, line: &InkLine, point: usize) -> usize {
        let Self::Error { tolerance_mm } = self else {
            return line.pass as usize;
        };
        let error_mm = line.errors_mm[point];
        usize::from(error_mm > tolerance_mm / 2.0) + usize::from(error_mm > tolerance_mm)
    }

    /// Returns the colour and line width in mm of a class.
    pub(super) fn style(self, class: usize, plan: &Plan) -> (String, f64) {
        match self {
            Self::Error { .. } => (ERRORS[class].0.to_owned(), ERRORS[class].1),
            Self::Passes => (pass_color(plan, class), INK_MM),
        }
    }

    /// Returns the names and styles in the legend.
    pub(super) fn legend(self) -> Vec<(String, ShapeStyle<'static>)> {
        let Self::Error { tolerance_mm } = self else {
            return Vec::new();
        };
        let names = [
            format!("off by 0 to {} mm", tolerance_mm / 2.0),
            format!("to {tolerance_mm} mm"),
            "more".to_owned(),
        ];
        let looks = ERRORS.map(|(color, width)| ShapeStyle::line(color, width));
        names.into_iter().zip(looks).collect()
    }
}

/// Returns the colour of a pass.
pub(super) fn pass_color(plan: &Plan, pass: usize) -> String {
    match plan.passes.get(pass).and_then(|pass| pass.color) {
        Some(color) => {
            let [red, green, blue] = seen_on_white(color);
            format!("#{red:02x}{green:02x}{blue:02x}")
        }
        None => PASSES[pass % PASSES.len()].to_owned(),
    }
}

/// Darkens a colour that is too bright.
fn seen_on_white(rgb: [u8; 3]) -> [u8; 3] {
    let [red, green, blue] = rgb.map(f64::from);
    let brightness = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    if brightness <= BRIGHTEST {
        return rgb;
    }
    let darker = DARKER / brightness;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "less than it was"
    )]
    [red, green, blue].map(|shade| (shade * darker) as u8)
}

/// Colours that can be distinguished with colour blindness; the width is a second cue.
const ERRORS: [(&str, f64); 3] = [("#007a5a", 0.34), ("#e69f00", 0.42), ("#d1341f", 0.95)];
const PASSES: [&str; 8] = [
    "#1b2a41", "#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7a5195",
];
const INK_MM: f64 = 0.42;
const BRIGHTEST: f64 = 200.0;
const DARKER: f64 = 130.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use dobot_geometry::{Point, Stroke};
    use dobot_plan::{ArmLimits, DrawingTool, Paper, Pass};

    #[test]
    fn a_place_is_green_amber_or_red() {
        let line = InkLine {
            stroke: Stroke::default(),
            errors_mm: vec![0.0, 0.025, 0.03, 0.05, 0.051],
            pass: 3,
        };
        let classes = |colors: Colors| (0..5).map(|i| colors.class(&line, i)).collect::<Vec<_>>();
        assert_eq!(
            classes(Colors::Error { tolerance_mm: 0.05 }),
            [0, 0, 1, 1, 2]
        );
        assert_eq!(classes(Colors::Passes), [3; 5]);
    }

    #[test]
    fn a_pass_has_the_colour_of_its_file_unless_it_would_be_invisible() {
        let pass = |color| Pass {
            color,
            ..Pass::new(
                DrawingTool::default(),
                vec![Stroke::open(vec![Point::new(200.0, 0.0)])],
            )
        };
        let passes = [Some([204, 0, 16]), Some([255, 255, 250]), None].map(pass);
        let plan = Plan::new(&passes, &Paper::default(), &ArmLimits::default()).unwrap();
        assert_eq!(pass_color(&plan, 0), "#cc0010");
        // All three are darkened in the ratio of 130 to 255.
        assert_eq!(pass_color(&plan, 1), "#82827f");
        assert_eq!(pass_color(&plan, 2), PASSES[2]);
    }
}
