//! The arm for Python: a worker thread owns the client of the rules, and Python communicates with
//! it by messages.

mod arm;
mod calibrate;
mod columns;
mod drawing;
mod failure;
mod files;
mod follow;
mod log;
mod mailbox;
mod pending;
mod place;
mod program;
mod served;
mod session;
mod simulate;
mod virtual_arm;
mod worker;

use pyo3::prelude::*;

use crate::arm::{Core, joints_warning, point_warning};
use crate::calibrate::{Calibrated, sheet_markers, sheet_points};
use crate::drawing::{Drawing, Lines, drawing_formats};
use crate::failure::kinds;
use crate::files::{Files, TalkAudio};
use crate::log::{Log, export_lerobot};
use crate::pending::{Pending, Statuses};
use crate::program::Taught;
use crate::served::Served;
use crate::simulate::Simulated;
use crate::virtual_arm::{ink_deviation, world_svg};

#[pymodule]
fn _core(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Drawing>()?;
    module.add_class::<Lines>()?;
    module.add_function(wrap_pyfunction!(drawing_formats, module)?)?;
    module.add_class::<Pending>()?;
    module.add_class::<Statuses>()?;
    module.add_class::<Taught>()?;
    module.add_class::<Simulated>()?;
    module.add_class::<Log>()?;
    module.add_class::<Calibrated>()?;
    module.add_function(wrap_pyfunction!(export_lerobot, module)?)?;
    module.add_function(wrap_pyfunction!(sheet_markers, module)?)?;
    module.add_function(wrap_pyfunction!(sheet_points, module)?)?;
    module.add_class::<Served>()?;
    module.add_class::<Files>()?;
    module.add_class::<TalkAudio>()?;
    module.add_function(wrap_pyfunction!(kinds, module)?)?;
    module.add_function(wrap_pyfunction!(world_svg, module)?)?;
    module.add_function(wrap_pyfunction!(ink_deviation, module)?)?;
    module.add_function(wrap_pyfunction!(point_warning, module)?)?;
    module.add_function(wrap_pyfunction!(joints_warning, module)?)?;
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<Core>()
}
