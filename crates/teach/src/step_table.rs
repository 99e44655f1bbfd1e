//! A step as a table of the text: one key says what it does, others say how.

use std::fmt;

use dobot_wire::MovingMode;
use schemars::JsonSchema;
use serde::de::{Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::number::{perhaps, within};
use crate::place::Place;
use crate::program::{Action, Arc, Drawing, Go, Here, Offset, Speed, Steps, Times};

/// A step. Exactly one of `go`, `laser`, `wait`, `barrier`, `speed`, `tool`, `repeat`, `each`, `call`, `arc`, `circle`
/// and `drawing` says what it does; or it has only `suction`, `gripper` and `pause`, which act where the arm is.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
#[schemars(rename = "Step")]
pub(crate) struct StepTable {
    /// Goes to a place.
    #[serde(skip_serializing_if = "Option::is_none")]
    go: Option<Place>,
    /// The way there: `jump` (as without it), `movl` in a straight line, or `movj` by the joints.
    #[serde(skip_serializing_if = "Option::is_none")]
    path: Option<MovingMode>,
    /// So far from the place, in mm along the axes of its frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    offset: Option<Offset>,
    /// Whether the pump runs from there on.
    #[serde(skip_serializing_if = "Option::is_none")]
    suction: Option<bool>,
    /// The gripper's angle from there on, -90 to 90 degrees.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    gripper: Option<f64>,
    /// How long the arm waits there, 0 to 655 seconds.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pause: Option<f64>,
    /// Switches the laser.
    #[serde(skip_serializing_if = "Option::is_none")]
    laser: Option<bool>,
    /// Waits for a person, who is told this, in 1 to 200 letters.
    #[serde(skip_serializing_if = "Option::is_none")]
    wait: Option<String>,
    /// Waits for the other arms of a program for several, at the barrier of this name, in 1 to 40 letters.
    #[serde(skip_serializing_if = "Option::is_none")]
    barrier: Option<String>,
    /// Sets speeds.
    #[serde(skip_serializing_if = "Option::is_none")]
    speed: Option<Speed>,
    /// Says which of the named tools is mounted.
    #[serde(skip_serializing_if = "Option::is_none")]
    tool: Option<String>,
    /// Does `steps` so often, or `"forever"`.
    #[serde(skip_serializing_if = "Option::is_none")]
    repeat: Option<Times>,
    /// Does `steps` for each cell of a grid, or of several side by side, by their names.
    #[serde(skip_serializing_if = "Option::is_none")]
    each: Option<Names>,
    /// What `repeat` and `each` do.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Vec<StepTable>>")]
    steps: Option<Steps>,
    /// Does the steps of another program.
    #[serde(skip_serializing_if = "Option::is_none")]
    call: Option<String>,
    /// Goes along an arc from here to its end.
    #[serde(skip_serializing_if = "Option::is_none")]
    arc: Option<Arc>,
    /// Goes once around a circle from here.
    #[serde(skip_serializing_if = "Option::is_none")]
    circle: Option<Arc>,
    /// Draws a file.
    #[serde(skip_serializing_if = "Option::is_none")]
    drawing: Option<Drawing>,
}

impl TryFrom<StepTable> for Action {
    type Error = String;

    fn try_from(mut it: StepTable) -> Result<Self, String> {
        let there = it.there();
        let verbs: Vec<&str> = there
            .iter()
            .copied()
            .filter(|key| VERBS.contains(key))
            .collect();
        let verb = match verbs[..] {
            [] if there.is_empty() => return Err(format!("a step has nothing to do; {ONE_OF}")),
            [] => "here",
            [verb] => verb,
            [..] => return Err(format!("a step has {}; {ONE_OF}", verbs.join(" and "))),
        };
        let beside = beside(verb);
        if let Some(key) = there
            .iter()
            .find(|key| **key != verb && !beside.contains(key))
        {
            return Err(format!(
                "a step has {key} beside {verb}; allowed there: {}",
                allowed(beside)
            ));
        }
        it.action(verb)
    }
}

impl StepTable {
    /// The keys that are there.
    fn there(&self) -> Vec<&'static str> {
        let keys = [
            ("go", self.go.is_some()),
            ("path", self.path.is_some()),
            ("offset", self.offset.is_some()),
            ("suction", self.suction.is_some()),
            ("gripper", self.gripper.is_some()),
            ("pause", self.pause.is_some()),
            ("laser", self.laser.is_some()),
            ("wait", self.wait.is_some()),
            ("barrier", self.barrier.is_some()),
            ("speed", self.speed.is_some()),
            ("tool", self.tool.is_some()),
            ("repeat", self.repeat.is_some()),
            ("each", self.each.is_some()),
            ("steps", self.steps.is_some()),
            ("call", self.call.is_some()),
            ("arc", self.arc.is_some()),
            ("circle", self.circle.is_some()),
            ("drawing", self.drawing.is_some()),
        ];
        keys.iter().filter(|it| it.1).map(|it| it.0).collect()
    }

    fn action(&mut self, verb: &str) -> Result<Action, String> {
        let then = self.then()?;
        let Self {
            go,
            laser,
            wait,
            barrier,
            speed,
            tool,
            repeat,
            each,
            call,
            arc,
            circle,
            drawing,
            ..
        } = self;
        let (path, offset) = (self.path, self.offset);
        let steps = &mut self.steps;
        let told = [
            go.take().map(|to| {
                let (path, offset) = (path.unwrap_or(MovingMode::Jump), offset.unwrap_or_default());
                Ok(Action::Go(Go {
                    to,
                    offset,
                    path,
                    then,
                }))
            }),
            laser.take().map(|it| Ok(Action::Laser(it))),
            wait.take()
                .map(|it| checked_text("wait", it, LONGEST_MESSAGE).map(Action::Wait)),
            barrier
                .take()
                .map(|it| checked_text("barrier", it, LONGEST_BARRIER).map(Action::Barrier)),
            speed.take().map(|it| checked_speed(it).map(Action::Speed)),
            tool.take().map(|it| Ok(Action::Tool(it))),
            repeat
                .take()
                .map(|it| Ok(Action::Repeat(it, nested(verb, steps)?))),
            each.take()
                .map(|it| Ok(Action::Each(it.0, nested(verb, steps)?))),
            call.take().map(|it| Ok(Action::Call(it))),
            arc.take().map(|it| checked_arc(it).map(Action::Arc)),
            circle.take().map(|it| checked_arc(it).map(Action::Circle)),
            drawing.take().map(|it| Ok(Action::Drawing(it))),
        ];
        told.into_iter()
            .flatten()
            .next()
            .unwrap_or(Ok(Action::Here(then)))
    }

    fn then(&self) -> Result<Here, String> {
        if let Some(gripper) = self.gripper {
            within("gripper", "°", gripper, -90.0, 90.0)?;
        }
        if let Some(pause) = self.pause {
            within("pause", " s", pause, 0.0, LONGEST_PAUSE_S)?;
        }
        Ok(Here {
            suction: self.suction,
            gripper: self.gripper,
            pause: self.pause,
        })
    }

    fn with(then: Here) -> Self {
        Self {
            suction: then.suction,
            gripper: then.gripper,
            pause: then.pause,
            ..Self::default()
        }
    }
}

impl From<Action> for StepTable {
    fn from(action: Action) -> Self {
        let empty = Self::default();
        match action {
            Action::Go(Go {
                to,
                offset,
                path,
                then,
            }) => Self {
                go: Some(to),
                path: Some(path).filter(|it| *it != MovingMode::Jump),
                offset: Some(offset).filter(|it| *it != Offset::default()),
                ..Self::with(then)
            },
            Action::Here(then) => Self::with(then),
            Action::Laser(on) => Self {
                laser: Some(on),
                ..empty
            },
            Action::Wait(message) => Self {
                wait: Some(message),
                ..empty
            },
            Action::Barrier(name) => Self {
                barrier: Some(name),
                ..empty
            },
            Action::Speed(speed) => Self {
                speed: Some(speed),
                ..empty
            },
            Action::Tool(name) => Self {
                tool: Some(name),
                ..empty
            },
            Action::Repeat(times, steps) => Self {
                repeat: Some(times),
                steps: Some(steps),
                ..empty
            },
            Action::Each(grids, steps) => Self {
                each: Some(Names(grids)),
                steps: Some(steps),
                ..empty
            },
            Action::Call(file) => Self {
                call: Some(file),
                ..empty
            },
            Action::Arc(arc) => Self {
                arc: Some(arc),
                ..empty
            },
            Action::Circle(circle) => Self {
                circle: Some(circle),
                ..empty
            },
            Action::Drawing(drawing) => Self {
                drawing: Some(drawing),
                ..empty
            },
        }
    }
}

/// One name or several.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Names(Vec<String>);

impl JsonSchema for Names {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Names".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "description": "One name, or several.",
            "anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}, "minItems": 1}],
        })
    }
}

impl Serialize for Names {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match &self.0[..] {
            [one] => one.serialize(to),
            several => several.serialize(to),
        }
    }
}

impl<'de> Deserialize<'de> for Names {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_any(NamesVisitor)
    }
}

struct NamesVisitor;

impl<'de> Visitor<'de> for NamesVisitor {
    type Value = Names;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a grid, or several in [ ]")
    }

    fn visit_str<E>(self, name: &str) -> Result<Names, E> {
        Ok(Names(vec![name.to_owned()]))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut names: A) -> Result<Names, A::Error> {
        let mut all = Vec::new();
        while let Some(name) = names.next_element()? {
            all.push(name);
        }
        if all.is_empty() {
            return Err(A::Error::custom(
                "each names no grid; it needs one at least",
            ));
        }
        Ok(Names(all))
    }
}

impl Serialize for Times {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Count(count) => count.serialize(to),
            Self::Forever => FOREVER.serialize(to),
        }
    }
}

impl<'de> Deserialize<'de> for Times {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_any(TimesVisitor)
    }
}

impl JsonSchema for Times {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Times".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "description": "How often, or until a person ends it.",
            "anyOf": [{"type": "integer", "minimum": 1}, {"const": FOREVER}],
        })
    }
}

struct TimesVisitor;

impl Visitor<'_> for TimesVisitor {
    type Value = Times;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a whole number of 1 or more, or \"{FOREVER}\"")
    }

    fn visit_i64<E: Error>(self, times: i64) -> Result<Times, E> {
        match u64::try_from(times) {
            Ok(count) if count > 0 => Ok(Times::Count(count)),
            _ => Err(E::custom(format!(
                "repeat is {times}; allowed are 1 or more, or \"{FOREVER}\""
            ))),
        }
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Times, E> {
        if text == FOREVER {
            return Ok(Times::Forever);
        }
        Err(E::custom(format!(
            "repeat is {text:?}; allowed are 1 or more, or \"{FOREVER}\""
        )))
    }
}

fn nested(verb: &str, steps: &mut Option<Steps>) -> Result<Steps, String> {
    match steps.take() {
        Some(steps) if !steps.0.is_empty() => Ok(steps),
        _ => Err(format!("{verb} has no steps; it needs one at least")),
    }
}

fn checked_text(key: &str, text: String, longest: usize) -> Result<String, String> {
    let count = text.chars().count();
    if (1..=longest).contains(&count) {
        return Ok(text);
    }
    Err(format!(
        "{key} has {count} letters; allowed are 1 to {longest}"
    ))
}

fn checked_arc(arc: Arc) -> Result<Arc, String> {
    within("tolerance", " mm", arc.tolerance, 0.01, 10.0).map(|_| arc)
}

fn checked_speed(it: Speed) -> Result<Speed, String> {
    let percents = [
        ("percent", it.percent),
        ("acceleration_percent", it.acceleration_percent),
    ];
    let speeds = [
        ("joint", it.joint),
        ("joint_acceleration", it.joint_acceleration),
        ("servo", it.servo),
        ("servo_acceleration", it.servo_acceleration),
        ("line", it.line),
        ("line_acceleration", it.line_acceleration),
    ];
    let bounded = percents
        .map(|it| (it, 100.0))
        .into_iter()
        .chain(speeds.map(|it| (it, 10_000.0)));
    for ((key, value), most) in bounded {
        within(key, "", value.unwrap_or(most), LEAST_SPEED, most)?;
    }
    within(
        "jump_height",
        " mm",
        it.jump_height.unwrap_or(0.0),
        0.0,
        300.0,
    )?;
    if it == Speed::default() {
        return Err(
            "speed says nothing; it needs percent, joint, line, jump_height or another of its keys"
                .into(),
        );
    }
    Ok(it)
}

/// What may stand beside the key that says what a step does.
fn beside(verb: &str) -> &'static [&'static str] {
    match verb {
        "go" => &["path", "offset", "suction", "gripper", "pause"],
        "here" => &["suction", "gripper", "pause"],
        "repeat" | "each" => &["steps"],
        _ => &[],
    }
}

fn allowed(keys: &[&str]) -> String {
    if keys.is_empty() {
        return "nothing".to_owned();
    }
    keys.join(", ")
}

const VERBS: [&str; 12] = [
    "go", "laser", "wait", "barrier", "speed", "tool", "repeat", "each", "call", "arc", "circle",
    "drawing",
];
const ONE_OF: &str = "it needs one of go, suction, gripper, pause, laser, wait, barrier, speed, tool, repeat, each, call, arc, circle and drawing";
const FOREVER: &str = "forever";
const LONGEST_MESSAGE: usize = 200;
const LONGEST_BARRIER: usize = 40;
/// What a target can say (note N10).
pub(crate) const LONGEST_PAUSE_S: f64 = 655.0;
/// Slower is no speed: a way would take hours.
pub(crate) const LEAST_SPEED: f64 = 0.001;
