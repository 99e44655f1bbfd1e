//! Virtual arms: how they behave, what is around them, and what goes wrong with them.

use dobot_controller::{Controller, Personality, PowerUp};
use dobot_geometry::{Point, Stroke, WorstPoint, deviation};
use dobot_sim::world::{Scene, World, WorldState};
use dobot_sim::{Fault, SerialLine, VirtualArm};
use pyo3::prelude::*;

use crate::failure::value_error;

/// How a virtual arm is switched on.
pub(crate) struct VirtualSetup {
    pub(crate) power_up: PowerUp,
    scene: Option<Scene>,
    faults: Vec<Fault>,
    seed: u64,
}

impl VirtualSetup {
    /// By the name of a personality, the text of a scene, and faults as `dobot arm --fault` takes them.
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

    /// The arm, switched on.
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

/// What is around an arm, as JSON, and nothing where nothing is.
pub(crate) fn world_json(arm: &VirtualArm) -> Option<String> {
    let state = arm.world()?.state();
    Some(serde_json::to_string(&state).expect("a world has no keys that are no texts"))
}

/// The picture of a world, told as JSON: an SVG document.
#[pyfunction]
pub(crate) fn world_svg(py: Python<'_>, json: &str) -> PyResult<String> {
    py.detach(|| {
        let state: WorldState = serde_json::from_str(json).map_err(|error| value_error(&error))?;
        Ok(state.picture())
    })
}

/// The drawn point that lies farthest from what was wanted, and the wanted one that lies farthest from what was drawn:
/// x, y and the distance, all in mm.
#[pyfunction]
pub(crate) fn ink_deviation(
    py: Python<'_>,
    wanted: Vec<Vec<(f64, f64)>>,
    drawn: Vec<Vec<(f64, f64)>>,
) -> ([f64; 3], [f64; 3]) {
    py.detach(|| {
        let told = |point: WorstPoint| [point.at.x, point.at.y, point.distance_mm];
        let found = deviation(&strokes(wanted), &strokes(drawn));
        (told(found.astray), told(found.missed))
    })
}

/// Strokes of points.
fn strokes(lines: Vec<Vec<(f64, f64)>>) -> Vec<Stroke> {
    let lines = lines.into_iter().filter(|points| !points.is_empty());
    lines
        .map(|points| Stroke::open(points.into_iter().map(Point::from).collect()))
        .collect()
}
