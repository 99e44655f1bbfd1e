//! The features of a dataset: the columns of its frames.

use dobot_wire::Status;
use serde_json::{Value, json};

use super::cell::{Cell, Column, Kind, column};
use super::frames::{FPS, Frame};
use super::summary::{QUANTILES, Summary};

/// A feature of a dataset.
pub(crate) struct Feature {
    pub(crate) name: &'static str,
    /// The names of its numbers; none for a single number.
    names: &'static [&'static str],
    is_integer: bool,
}

/// All features, in the order of [`values`].
pub(crate) const FEATURES: [Feature; 8] = [
    numbers("observation.state", &STATE),
    numbers(
        "observation.pose",
        &["x_mm", "y_mm", "z_mm", "rotation_deg"],
    ),
    numbers("action", &STATE),
    numbers("timestamp", &[]),
    integer("frame_index"),
    integer("episode_index"),
    integer("index"),
    integer("task_index"),
];

const STATE: [&str; 6] = [
    "base_deg",
    "rear_deg",
    "fore_deg",
    "servo_deg",
    "suction",
    "gripper_deg",
];

const fn numbers(name: &'static str, names: &'static [&'static str]) -> Feature {
    Feature {
        name,
        names,
        is_integer: false,
    }
}

const fn integer(name: &'static str) -> Feature {
    Feature {
        name,
        names: &[],
        is_integer: true,
    }
}

impl Feature {
    /// The number of its values.
    pub(crate) fn len(&self) -> usize {
        self.names.len().max(1)
    }

    pub(crate) fn column(&self) -> Column {
        let kind = match (self.is_integer, self.names.is_empty()) {
            (true, _) => Kind::Integer,
            (false, true) => Kind::Float,
            (false, false) => Kind::Floats,
        };
        column(self.name, kind)
    }

    /// The entry in `info.json`.
    pub(crate) fn about(&self) -> Value {
        json!({
            "dtype": if self.is_integer { "int64" } else { "float32" },
            "shape": [self.len()],
            "names": (!self.names.is_empty()).then_some(self.names),
        })
    }

    #[expect(
        clippy::cast_possible_truncation,
        reason = "angles and lengths were f32 in the status, and integers are counted here"
    )]
    pub(crate) fn cell(&self, values: &[f64]) -> Cell {
        match (self.is_integer, self.names.is_empty()) {
            (true, _) => Cell::Integer(values[0] as i64),
            (false, true) => Cell::Float(values[0] as f32),
            (false, false) => Cell::Floats(values.iter().map(|value| *value as f32).collect()),
        }
    }
}

/// The values of each feature for a frame, with the numbers of its episode, itself and its task. The
/// action of a frame is the state of the next one.
pub(crate) fn values(frame: &Frame, next: &Status, counters: [u32; 3]) -> [Vec<f64>; 8] {
    let status = &frame.status;
    let number = f64::from(frame.number);
    let [episode, index, task] = counters.map(|counter| vec![f64::from(counter)]);
    [
        state(status),
        [status.x_mm, status.y_mm, status.z_mm, status.rotation_deg]
            .map(f64::from)
            .to_vec(),
        state(next),
        vec![number / f64::from(FPS)],
        vec![number],
        episode,
        index,
        task,
    ]
}

fn state(status: &Status) -> Vec<f64> {
    let suction = if status.suction { 1.0 } else { 0.0 };
    let [base, rear, fore, servo, gripper] = [
        status.base_deg,
        status.rear_deg,
        status.fore_deg,
        status.servo_deg,
        status.gripper_deg,
    ]
    .map(f64::from);
    vec![base, rear, fore, servo, suction, gripper]
}

/// The summaries of all features.
#[derive(Clone)]
pub(crate) struct Summaries(Vec<Summary>);

impl Summaries {
    pub(crate) fn new() -> Self {
        Self(
            FEATURES
                .iter()
                .map(|feature| Summary::new(feature.len()))
                .collect(),
        )
    }

    pub(crate) fn push(&mut self, values: &[Vec<f64>; 8]) {
        for (summary, values) in self.0.iter_mut().zip(values) {
            summary.push(values);
        }
    }

    /// The summaries in the form of `stats.json`.
    pub(crate) fn to_json(&self) -> Value {
        let each = FEATURES.iter().zip(&self.0).map(|(feature, summary)| {
            let mut stats = json!({
                "min": summary.min,
                "max": summary.max,
                "mean": summary.mean,
                "std": summary.std(),
                "count": [summary.count],
            });
            for ((name, _), quantile) in QUANTILES.iter().zip(summary.quantiles()) {
                stats[name] = quantile.into();
            }
            (feature.name.to_owned(), stats)
        });
        Value::Object(each.collect())
    }

    /// The columns of the summaries of an episode.
    pub(crate) fn columns() -> impl Iterator<Item = Column> {
        FEATURES.iter().flat_map(|feature| {
            let one = |stat: &str, kind| column(format!("stats/{}/{stat}", feature.name), kind);
            let mut columns = vec![
                one("min", Kind::Doubles),
                one("max", Kind::Doubles),
                one("mean", Kind::Doubles),
                one("std", Kind::Doubles),
                one("count", Kind::Integers),
            ];
            columns.extend(QUANTILES.map(|(name, _)| one(name, Kind::Doubles)));
            columns
        })
    }

    /// The cells of these columns.
    pub(crate) fn cells(&self) -> impl Iterator<Item = Cell> {
        self.0.iter().flat_map(|summary| {
            let mut cells = vec![
                Cell::Doubles(summary.min.clone()),
                Cell::Doubles(summary.max.clone()),
                Cell::Doubles(summary.mean.clone()),
                Cell::Doubles(summary.std()),
                Cell::Integers(vec![summary.count.into()]),
            ];
            cells.extend(summary.quantiles().map(Cell::Doubles));
            cells
        })
    }
}
