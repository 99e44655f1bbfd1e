//! Virtual arms: their behaviour, world and faults.

use dobot_controller::{Controller, Personality, PowerUp};
use dobot_geometry::{Point, Stroke, WorstPoint, deviation};
use dobot_sim::world::{Scene, World, WorldState};
use dobot_sim::{Fault, SerialLine, VirtualArm};
use pyo3::prelude::*;

use crate::failure::value_error;

/// The setup of a virtual arm.
pub(crate) struct VirtualSetup {
    pub(crate) power_up: PowerUp,
    scene: Option<Scene>,
    faults: Vec<Fault>,
    seed: u64,
}

impl VirtualSetup {
    /// Parses the name of a personality, the text of a scene, and faults in the format of `dobot
    /// arm --fault`.
    pub(crate) fn new(
        personality: &str,
        scene: Option<&str>,
        faults: &[String],
        seed: u64,
    ) -> PyResult<Self> {
        let personality = match personality {
            "" => Personality::default(),
            named => named.parse().map_err(|error| value_error(&error))?,
        };
        Ok(Self {
            power_up: PowerUp::new(personality),
            scene: scene.map(parsed).transpose()?,
            faults: read_faults(faults)?,
            seed,
        })
    }

    /// Returns the arm after power-up.
    pub(crate) fn arm(&self) -> VirtualArm {
        let mut arm = VirtualArm::new(Controller::power_up(self.power_up), SerialLine::STOCK);
        if !self.faults.is_empty() {
            arm = arm.with_faults(self.power_up, &self.faults, self.seed);
        }
        match &self.scene {
            Some(scene) => arm.with_world(World::new(scene.clone())),
            None => arm,
        }
    }
}

pub(crate) fn read_faults(faults: &[String]) -> PyResult<Vec<Fault>> {
    let faults = faults.iter().map(|fault| fault.parse());
    faults
        .collect::<Result<_, _>>()
        .map_err(|error| value_error(&error))
}

fn parsed(scene: &str) -> PyResult<Scene> {
    Scene::parse(scene).map_err(|error| value_error(&format!("the world: {error}")))
}

/// Returns the world of an arm as JSON; `None` if there is none.
pub(crate) fn world_json(arm: &VirtualArm) -> Option<String> {
    let state = arm.world()?.state();
    Some(serde_json::to_string(&state).expect("all keys of a world are texts"))
}

/// Returns the picture of a world, given as JSON: an SVG document.
#[pyfunction]
pub(crate) fn world_svg(py: Python<'_>, json: &str) -> PyResult<String> {
    py.detach(|| {
        let state: WorldState = serde_json::from_str(json).map_err(|error| value_error(&error))?;
        Ok(state.picture())
    })
}

/// Returns the drawn point farthest from the expected lines, and the expected point farthest from
/// the drawn ones: x, y and the distance, all in mm.
#[pyfunction]
pub(crate) fn ink_deviation(
    py: Python<'_>,
    wanted: Vec<Vec<(f64, f64)>>,
    drawn: Vec<Vec<(f64, f64)>>,
) -> ([f64; 3], [f64; 3]) {
    py.detach(|| {
        let numbers = |point: WorstPoint| [point.at.x, point.at.y, point.distance_mm];
        let found = deviation(&strokes(wanted), &strokes(drawn));
        (numbers(found.astray), numbers(found.missed))
    })
}

/// Converts lines of points to strokes.
fn strokes(lines: Vec<Vec<(f64, f64)>>) -> Vec<Stroke> {
    let lines = lines.into_iter().filter(|points| !points.is_empty());
    lines
        .map(|points| Stroke::open(points.into_iter().map(Point::from).collect()))
        .collect()
}
