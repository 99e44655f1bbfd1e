//! Scripts in virtual time.

use dobot_controller::Personality;
use dobot_record::tables::STATUS_FLOATS;
use dobot_sim::{Plot, Script, Simulation, Snapshot, simulate_watched};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::columns::Columns;
use crate::failure::value_error;

/// The result of a script.
#[pyclass(frozen)]
pub(crate) struct Simulated {
    simulation: Simulation,
    snapshots: Vec<Snapshot>,
    title: String,
    personality: Personality,
}

#[pymethods]
impl Simulated {
    /// Runs a script; `name` is used in messages, and above its picture.
    #[new]
    fn new(py: Python<'_>, script: &str, name: &str, personality: &str) -> PyResult<Self> {
        let personality: Personality = personality.parse().map_err(|error| value_error(&error))?;
        let script = Script::parse(script)
            .map_err(|error| value_error(&format!("{name}:{}: {}", error.line, error.problem)))?;
        py.detach(|| {
            let mut snapshots = Vec::new();
            let simulation = simulate_watched(&script, personality, |at, controller| {
                snapshots.push(Snapshot::of(controller, at));
            });
            Ok(Self {
                simulation: simulation.map_err(|error| value_error(&error))?,
                snapshots,
                title: name.to_owned(),
                personality,
            })
        })
    }

    /// Returns the statuses, by the time of the control tick that queued each.
    fn statuses<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = &self.simulation.trace.statuses;
        #[allow(clippy::cast_precision_loss)] // A run has no 2^53 milliseconds.
        let seconds = all.iter().map(|packet| packet.t_ms() as f64 / 1000.0);
        let mut columns = Columns::new(py).doubles("at_s", seconds)?;
        for (at, name) in STATUS_FLOATS.into_iter().enumerate() {
            columns = columns.floats(name, all.iter().map(|packet| packet.floats[at]))?;
        }
        columns = columns.truths("suction", all.iter().map(|packet| packet.floats[8] != 0.0))?;
        let columns = columns.floats("gripper_deg", all.iter().map(|packet| packet.floats[9]))?;
        Ok(columns.finish())
    }

    /// Returns the true position and the outputs of the arm at every control tick.
    fn ticks<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = &self.snapshots;
        let mut columns =
            Columns::new(py).doubles("at_s", all.iter().map(|sample| sample.at.as_secs_f64()))?;
        for (at, name) in ["x_mm", "y_mm", "z_mm"].into_iter().enumerate() {
            columns = columns.doubles(name, all.iter().map(|sample| sample.tool_mm[at]))?;
        }
        for (at, name) in JOINTS.into_iter().enumerate() {
            columns = columns.doubles(name, all.iter().map(|sample| sample.joints_deg[at]))?;
        }
        let pulses = &self.simulation.trace.ticks;
        for (at, name) in PULSES.into_iter().enumerate() {
            let sums = pulses.iter().map(|row| row.sums[at]);
            columns = columns.integers(name, sums.take(all.len()))?;
        }
        columns = columns.truths("pump", all.iter().map(|sample| sample.pump))?;
        let columns = columns.truths("laser", all.iter().map(|sample| sample.laser))?;
        Ok(columns.finish())
    }

    /// Returns the refusals of the controller: the time in seconds, and the reason.
    #[getter]
    fn refused(&self) -> Vec<(f64, String)> {
        let all = self.simulation.refused.iter();
        all.map(|(at, why)| (at.as_secs_f64(), why.to_string()))
            .collect()
    }

    #[getter]
    fn unsent(&self) -> usize {
        self.simulation.unsent
    }

    #[getter]
    fn end_s(&self) -> f64 {
        self.simulation.end.as_secs_f64()
    }

    /// Returns the output on the unused port.
    #[getter]
    fn other_port(&self) -> String {
        String::from_utf8_lossy(&self.simulation.trace.other_port).into_owned()
    }

    fn svg(&self, py: Python<'_>) -> String {
        py.detach(|| {
            let plot = Plot {
                title: &self.title,
                personality: self.personality,
                snapshots: &self.snapshots,
                statuses: &self.simulation.trace.statuses,
            };
            plot.to_svg()
        })
    }
}

const JOINTS: [&str; 4] = ["base_deg", "rear_deg", "fore_deg", "servo_deg"];
const PULSES: [&str; 3] = ["base_pulses", "rear_pulses", "fore_pulses"];
