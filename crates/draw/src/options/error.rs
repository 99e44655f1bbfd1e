//! Errors of drawing options.

use dobot_plan::PaperError;
use thiserror::Error;

use super::OptionRange;
use crate::layout::place::PlaceError;
use crate::layout::test_card::CardError;
use crate::material::UnknownMaterial;
use crate::prepare::PrepareError;

/// The error returned for invalid options.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum OptionsError {
    /// The pen or material is unknown.
    #[error(transparent)]
    Unknown(#[from] UnknownMaterial),
    /// A material is used with a pen, or a pen with the laser.
    #[error("{name} is {is}")]
    OtherKind {
        /// The given name.
        name: String,
        /// Its kind.
        is: &'static str,
        /// The field.
        field: &'static str,
    },
    /// A test card requires a laser.
    #[error("a test card needs a laser, but the tool is a pen")]
    CardByPen,
    /// The test card cannot be laid out.
    #[error(transparent)]
    Card(#[from] CardError),
    /// An option has no effect.
    #[error("{field} is for {fits}, and {is}")]
    Misfit {
        /// The field, as in `tool.kerf`.
        field: &'static str,
        /// What the option applies to.
        fits: String,
        /// The actual content.
        is: String,
    },
    /// Two options exclude each other.
    #[error("{field} and {other} exclude each other; use only one")]
    Both {
        /// The first field, as in `place.fit`.
        field: &'static str,
        /// The second field.
        other: &'static str,
    },
    /// An option has no effect without another one.
    #[error("{field} has no effect without {needs}")]
    Alone {
        /// The given field.
        field: &'static str,
        /// The missing field.
        needs: &'static str,
    },
    /// A layer is given twice.
    #[error("what.layer {0:?} is given twice; use only one")]
    Twice(String),
    /// A coordinate is not finite or too large.
    #[error("{field} has {found:?}; it takes numbers of millimetres from -10000 to 10000")]
    NoPlace {
        /// The field, as in `tool.kerf`.
        field: &'static str,
        /// The value.
        found: f64,
    },
    /// A number is outside the range of arms and paper.
    #[error(
        "{} is {}; it takes {} to {}",
        range.field,
        with_unit(*found, range.unit),
        with_unit(range.least, ""),
        with_unit(range.most, range.unit)
    )]
    Range {
        /// The value.
        found: f64,
        /// The field and its range.
        range: &'static OptionRange,
    },
    /// There are too few or too many coordinates.
    #[error("{field} has {found} numbers; it takes {allowed}")]
    Count {
        /// The field, as in `tool.kerf`.
        field: &'static str,
        /// The number found.
        found: usize,
        /// The number allowed.
        allowed: usize,
    },
    /// Two touches of a sheet are at the same place.
    #[error(
        "place.paper has the same place for the lower left corner of the sheet and for its lower edge; touch two places"
    )]
    SamePoint,
    /// A place on the paper is out of range.
    #[error(
        "the third place of place.paper lies {0:.1} mm below the lower edge of the sheet, seen from the first two; touch first the lower left corner, then another place on the lower edge, to the right of it"
    )]
    BelowSheet(f64),
    /// The calibration's heights of the paper span no surface.
    #[error(
        "the places at which the paper of the calibration was touched lie on one line, or two are the same; touch the paper again"
    )]
    NoSurface,
    /// The paper is invalid.
    #[error(transparent)]
    Paper(#[from] PaperError),
    /// The drawing does not fit, but would with another option.
    #[error("{error}")]
    DoesNotFit {
        /// The position that is out of reach, or the size that is too large.
        error: PlaceError,
        /// What to do.
        remedy: &'static str,
    },
    /// The drawing cannot be prepared.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
}

impl OptionsError {
    /// Returns the invalid field, if any, as in `tool.kerf`.
    #[must_use]
    pub const fn field(&self) -> Option<&'static str> {
        match self {
            Self::Misfit { field, .. }
            | Self::Both { field, .. }
            | Self::Alone { field, .. }
            | Self::NoPlace { field, .. }
            | Self::Count { field, .. } => Some(field),
            Self::Range { range, .. } => Some(range.field),
            _ => None,
        }
    }

    /// Returns a hint, if there is one.
    #[must_use]
    pub fn hint(&self) -> Option<String> {
        match self {
            Self::OtherKind { name, field, .. } => Some(format!(
                "`{field} {name}`; `dobot materials` lists pens and materials"
            )),
            Self::CardByPen => {
                Some("add `tool.laser MATERIAL`; `dobot materials` lists them".to_owned())
            }
            Self::DoesNotFit { remedy, .. } => Some((*remedy).to_owned()),
            Self::Prepare(PrepareError::Place(PlaceError::TooLarge { .. })) => {
                Some("use `place.fit` instead of `place.scale` to fit the drawing area, `place.clip` to draw only the part within reach, or `place.at X Y` to move its centre".into())
            }
            Self::Prepare(PrepareError::Place(PlaceError::BeyondSheet { .. })) => Some(
                "use `place.landscape` or `place.rotate 90` if the page has the other orientation, `place.fit` instead of `place.scale`, or `place.clip`".into(),
            ),
            Self::Prepare(PrepareError::Place(PlaceError::OutOfReach { .. })) => Some(
                "use `place.clip` to draw only the part within reach, `place.fit` without `place.at` and `place.paper_size` to fit the drawing, a smaller or closer sheet (`place.corner`), or other heights (`place.pen_down`, `tool.lift`)".into(),
            ),
            Self::Prepare(PrepareError::Place(PlaceError::RunOutOfReach { .. })) => {
                Some("use a lower `tool.speed`, or `place.clip`, which leaves room for the run-ups of the laser".into())
            }
            Self::Prepare(PrepareError::AllCutOff) => Some(
                "remove `place.clip` to see the position that is out of reach; `place.at` or `place.corner` move the sheet".into(),
            ),
            _ => None,
        }
    }
}

/// Formats a number as short as possible, without `.0`.
fn with_unit(value: f64, unit: &str) -> String {
    let text = format!("{value:?}");
    let text = text.strip_suffix(".0").unwrap_or(&text);
    format!("{text} {unit}").trim_end().to_owned()
}
