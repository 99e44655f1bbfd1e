//! Reading, checking, editing and compiling taught programs of an original Dobot Arm.
//!
//! A program is TOML: named points, and steps that go to them. See `docs/teaching.md`.
//!
//! ```
//! use dobot_safety::Policy;
//! use dobot_teach::{NoFiles, Program, check};
//! use dobot_motion::Model;
//! use dobot_wire::{Dialect, Status};
//!
//! let program = Program::from_toml(r#"
//!     title = "one cube, to and fro"
//!     start_speed_percent = 20
//!
//!     [points]
//!     here = { x = 200, y = 60, z = 0 }
//!     there = { x = 200, y = -60, z = 0 }
//!
//!     [[steps]]
//!     repeat = "forever"
//!     [[steps.steps]]
//!     go = "here"
//!     suction = true
//!     pause = 0.5
//!     [[steps.steps]]
//!     go = "there"
//!     suction = false
//!     pause = 0.5
//! "#)?;
//! let compiled = program.compile(&mut NoFiles)?;
//! // The first cycle starts softly, so it precedes the repeated ones.
//! assert_eq!(compiled.repeat.map(|repeat| repeat.from), Some(4));
//!
//! let start = Model::new(Dialect::SPECIFICATION, &Status::AT_ZERO);
//! let report = check(&compiled, &Policy::default(), start);
//! assert!(report.problems.is_empty() && report.steps_s.len() == 4);
//!
//! let error = Program::from_toml("[[steps]]\ngo = \"there\"").unwrap_err();
//! assert!(error.to_string().starts_with("line 1: there is no point \"there\""));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod asking;
mod axes;
mod check;
mod compile;
mod compiled;
mod corrections;
mod decision;
mod document;
mod error;
mod files;
mod from_step;
mod lines;
mod mistakes;
mod number;
mod place;
mod plain;
mod program;
mod program_form;
mod read;
mod recorded_path;
mod round;
mod similar;
mod step_table;
mod taught_grid;
pub mod vendor;

pub use asking::{EXAMPLE_PLACE, continued, first_step_at};
pub use check::{Problem, Report, check};
pub use compiled::{Compiled, CompiledStep, barrier_reason};
pub use decision::{
    AfterTimeout, AnswerWait, Choose, ChosenBy, Comparison, Condition, ExternalPlace, Missed,
    Operand, Transfer, Variables, When,
};
pub use document::{ProgramDocument, with_content};
pub use error::ProgramError;
pub use files::{Files, NoFiles};
pub use place::{Place, Point};
pub use program::{
    Action, Arc, DEFAULT_TOLERANCE_MM, Drawing, Frame, Go, Grid, Here, MountedTool, Offset,
    Program, Speed, Steps, Times,
};
pub use program_form::ProgramForm;
pub use recorded_path::{RecordedPlace, ToolState, path_steps, simplified};
pub use similar::nearest;
pub use taught_grid::{GridSize, TaughtGrid};
