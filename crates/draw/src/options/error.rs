//! What is wrong with what was asked for.

use dobot_plan::PaperError;
use thiserror::Error;

use super::OptionRange;
use crate::layout::place::PlaceError;
use crate::layout::test_card::CardError;
use crate::material::UnknownMaterial;
use crate::prepare::PrepareError;

/// What is wrong with what was asked for.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum OptionsError {
    /// A pen or a material that nobody knows.
    #[error(transparent)]
    Unknown(#[from] UnknownMaterial),
    /// A material for a pen, or the other way round.
    #[error("{name} is {is}")]
    OtherKind {
        /// The name that was given.
        name: String,
        /// What it is.
        is: &'static str,
        /// The field that it belongs to.
        field: &'static str,
    },
    /// A test card without a laser.
    #[error("a test card is burned, and the tool is a pen")]
    CardByPen,
    /// A test card that cannot be laid out.
    #[error(transparent)]
    Card(#[from] CardError),
    /// An option that would do nothing.
    #[error("{field} is for {fits}, and {is}")]
    Misfit {
        /// The field, as in `tool.kerf`.
        field: &'static str,
        /// What it is for.
        fits: String,
        /// What there is.
        is: String,
    },
    /// Options that exclude each other.
    #[error("{field} and {other} exclude each other: give one of them")]
    Both {
        /// The one, as in `place.fit`.
        field: &'static str,
        /// The other.
        other: &'static str,
    },
    /// An option that does nothing without another one.
    #[error("{field} does nothing without {needs}")]
    Alone {
        /// The one that was given.
        field: &'static str,
        /// The one that is missing.
        needs: &'static str,
    },
    /// A layer that is to be drawn in two ways.
    #[error("what.layer {0:?} is given twice: give one of them")]
    Twice(String),
    /// A coordinate that is none.
    #[error("{field} has {found:?}; it takes numbers of millimetres from -10000 to 10000")]
    NoPlace {
        /// The field, as in `tool.kerf`.
        field: &'static str,
        /// What it has.
        found: f64,
    },
    /// A number that no arm and no paper has.
    #[error(
        "{} is {}; it takes {} to {}",
        range.field,
        with_unit(*found, range.unit),
        with_unit(range.least, ""),
        with_unit(range.most, range.unit)
    )]
    Range {
        /// What it is.
        found: f64,
        /// The field, and what it takes.
        range: &'static OptionRange,
    },
    /// Coordinates that are too few or too many.
    #[error("{field} has {found} numbers; it takes {allowed}")]
    Count {
        /// The field, as in `tool.kerf`.
        field: &'static str,
        /// How many there are.
        found: usize,
        /// How many it takes.
        allowed: usize,
    },
    /// A sheet of which one place was touched twice.
    #[error(
        "place.paper has the same place for the lower left corner of the sheet and for its lower edge; touch two places"
    )]
    SamePoint,
    /// A place on the paper that lies where none is.
    #[error(
        "the third place of place.paper lies {0:.1} mm below the lower edge of the sheet, seen from the first two; touch first the lower left corner, then another place on the lower edge, to the right of it"
    )]
    BelowSheet(f64),
    /// The calibration's heights of the paper span no surface.
    #[error(
        "the places at which the paper of the calibration was touched lie on one line, or two are the same; touch the paper again"
    )]
    NoSurface,
    /// Paper that does not lie so.
    #[error(transparent)]
    Paper(#[from] PaperError),
    /// A drawing that cannot be made so.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
}

impl OptionsError {
    /// The field that is wrong, as in `tool.kerf`, where one is.
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

    /// What to do about it, where something helps.
    #[must_use]
    pub fn hint(&self) -> Option<String> {
        match self {
            Self::OtherKind { name, field, .. } => Some(format!(
                "`{field} {name}`; `dobot materials` lists pens and materials"
            )),
            Self::CardByPen => {
                Some("add `tool.laser MATERIAL`; `dobot materials` lists them".to_owned())
            }
            Self::Prepare(PrepareError::Place(PlaceError::TooLarge { .. })) => {
                Some("`place.fit`, instead of `place.scale`, makes it as large as the drawing area allows; `place.clip` draws what of it is within reach; `place.at X Y` says where its middle lies".into())
            }
            Self::Prepare(PrepareError::Place(PlaceError::BeyondSheet { .. })) => Some(
                "`place.landscape` or `place.rotate 90` where the page lies the other way round; `place.fit` instead of `place.scale`; `place.clip`".into(),
            ),
            Self::Prepare(PrepareError::Place(PlaceError::OutOfReach { .. })) => Some(
                "`place.clip` draws what is within reach; `place.fit` without `place.at` and `place.paper_size` makes all of it fit; on a sheet, a smaller one or one that lies nearer (`place.corner`); `place.pen_down` and `tool.lift` set the heights".into(),
            ),
            Self::Prepare(PrepareError::Place(PlaceError::RunOutOfReach { .. })) => {
                Some("a lower `tool.speed`; `place.clip` leaves room for the ways of the laser".into())
            }
            Self::Prepare(PrepareError::AllCutOff) => Some(
                "without `place.clip` the place is told; `place.at` or `place.corner` say where the sheet lies".into(),
            ),
            _ => None,
        }
    }
}

/// A number without `.0`, and no longer than need be.
fn with_unit(value: f64, unit: &str) -> String {
    let text = format!("{value:?}");
    let text = text.strip_suffix(".0").unwrap_or(&text);
    format!("{text} {unit}").trim_end().to_owned()
}
