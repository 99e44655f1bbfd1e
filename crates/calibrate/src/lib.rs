//! Calibration of one Dobot Arm: fits joint zeros, tool offset and paper plane to touched points of
//! a printed sheet.
//!
//! This crate uses no port and no files: it takes touches and returns a result with its trust. The
//! mapping itself is [`dobot_arm::Calibration`].
//!
//! ```
//! use dobot_arm::{Calibration, Position, Tool};
//! use dobot_calibrate::{SHEET_POINTS, Touch, fit};
//!
//! // An arm whose forearm stands 5 degrees further than reported touches the nine points.
//! let arm = Calibration { fore_deg: 5.0, ..Calibration::default() };
//! let touch = |[x, y]: [f64; 2]| {
//!     let raw = arm.raw_joints(Position::new(x, y, -40.0), Tool::SuctionCup).unwrap();
//!     Touch { place_mm: [x, y], height_mm: 0.0, raw }
//! };
//! let found = fit(&SHEET_POINTS.map(touch), Tool::SuctionCup)?;
//! assert!(found.typical_mm < 0.1);
//! # Ok::<(), dobot_calibrate::FitError>(())
//! ```

mod approach;
mod comb;
mod file;
mod fit;
mod marker;
mod outliers;
mod paper;
mod picture;
mod procedure;
mod repeatability;
mod sheet;
mod solve;
mod touch;
mod why;

pub use approach::{Approach, OtherSide};
pub use comb::{COMB_PAIRS, COMB_STEP_DEG, SlackJoint, comb};
pub use file::{FileError, found, read_calibration, write_calibration};
pub use fit::{Advice, Fit, Trust, Unsure, fit};
pub use marker::{Marker, MarkersError, markers_svg};
pub use paper::{PaperTouchError, TouchedPaper, paper};
pub use picture::residuals_svg;
pub use procedure::Procedure;
pub use repeatability::{Repeatability, repeatability};
pub use sheet::{BarError, SHEET_POINTS, Sheet, check_bar, sheet_markers};
pub use touch::Touch;
pub use why::FitError;
