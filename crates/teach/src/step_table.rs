//! Steps as tables of the text: one key selects the action, others set its details.

use std::fmt;

use dobot_api::AnsweredBy;
use dobot_wire::MovingMode;
use schemars::JsonSchema;
use serde::de::{Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::decision::{ChooseKeys, Condition, Missed, Transfer, TransferKeys, Variables, When};
use crate::number::{perhaps, within};
use crate::place::Place;
use crate::program::{Action, Arc, Drawing, Go, Here, Offset, Speed, Steps, Times};

/// A step. Exactly one of `go`, `pick`, `place`, `laser`, `wait`, `barrier`, `speed`, `tool`,
/// `repeat`, `each`, `while`, `choose`, `set`, `add`, `call`, `arc`, `circle` and `drawing` selects
/// the action; a step with only `suction`, `gripper` and `pause` acts at the current position.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
#[schemars(rename = "Step", extend("x-verbs" = verbs()))]
pub(crate) struct StepTable {
    /// Goes to a place.
    #[serde(skip_serializing_if = "Option::is_none")]
    go: Option<Place>,
    /// The path type: `jump` (default), `movl` in a straight line, or `movj` by the joints.
    #[serde(skip_serializing_if = "Option::is_none")]
    path: Option<MovingMode>,
    /// The offset from the place, in mm along the axes of its frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    offset: Option<Offset>,
    /// Whether the pump runs from here on.
    #[serde(skip_serializing_if = "Option::is_none")]
    suction: Option<bool>,
    /// The gripper's angle from here on, -90 to 90 degrees.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    gripper: Option<f64>,
    /// The pause, 0 to 655 seconds.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pause: Option<f64>,
    /// Switches the laser.
    #[serde(skip_serializing_if = "Option::is_none")]
    laser: Option<bool>,
    /// Waits for a person and shows this text of 1 to 200 characters.
    #[serde(skip_serializing_if = "Option::is_none")]
    wait: Option<String>,
    /// Waits for the other arms of a coordinated program at the barrier of this name, 1 to 40
    /// characters.
    #[serde(skip_serializing_if = "Option::is_none")]
    barrier: Option<String>,
    /// Sets speeds.
    #[serde(skip_serializing_if = "Option::is_none")]
    speed: Option<Speed>,
    /// Selects the mounted tool by name.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-names" = ["tools"]))]
    tool: Option<String>,
    /// Repeats `steps` this many times, or `"forever"`.
    #[serde(skip_serializing_if = "Option::is_none")]
    repeat: Option<Times>,
    /// Repeats `steps` for each cell of a grid, or of several grids in parallel, given by name.
    #[serde(skip_serializing_if = "Option::is_none")]
    each: Option<Names>,
    /// The steps of `repeat` and `each`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Vec<StepTable>>")]
    steps: Option<Steps>,
    /// Executes the steps of another program.
    #[serde(skip_serializing_if = "Option::is_none")]
    call: Option<String>,
    /// Follows an arc from the current position to its end.
    #[serde(skip_serializing_if = "Option::is_none")]
    arc: Option<Arc>,
    /// Follows a full circle from the current position.
    #[serde(skip_serializing_if = "Option::is_none")]
    circle: Option<Arc>,
    /// Draws a file.
    #[serde(skip_serializing_if = "Option::is_none")]
    drawing: Option<Drawing>,
    /// Asks this question of 1 to 200 characters, and executes the steps of the answer in `when`.
    #[serde(skip_serializing_if = "Option::is_none")]
    choose: Option<String>,
    /// Who answers `choose`: `person` (default), or `seen`: also a camera or another program.
    #[serde(skip_serializing_if = "Option::is_none")]
    by: Option<AnsweredBy>,
    /// Instead of `by`: a counter answers `choose`. Every such time gets the first answer, all
    /// others the second one, or nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 1, max = 1_000_000))]
    every: Option<u64>,
    /// How long `choose` waits for the answer, in seconds; without it, until it is answered.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    timeout: Option<f64>,
    /// The answer after the timeout; without it, the job is paused.
    #[serde(skip_serializing_if = "Option::is_none")]
    otherwise: Option<String>,
    /// The answers of `choose`, each with its steps.
    #[serde(skip_serializing_if = "Option::is_none")]
    when: Option<Vec<When>>,
    /// Sets variables to whole numbers.
    #[serde(skip_serializing_if = "Option::is_none")]
    set: Option<Variables>,
    /// Adds whole numbers to variables.
    #[serde(skip_serializing_if = "Option::is_none")]
    add: Option<Variables>,
    /// Repeats `steps` while this comparison holds, for example `count < 5`.
    #[serde(rename = "while", skip_serializing_if = "Option::is_none")]
    condition: Option<Condition>,
    /// Picks up the object at a place: from above, down in a straight line, and up again.
    #[serde(skip_serializing_if = "Option::is_none")]
    pick: Option<Place>,
    /// Puts the object down at a place.
    #[serde(skip_serializing_if = "Option::is_none")]
    place: Option<Place>,
    /// The height above the place from which `pick` and `place` come, 0 to 300 mm; default 20.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    approach: Option<f64>,
    /// The height above the place to which they go afterwards, 0 to 300 mm; default: `approach`.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    retreat: Option<f64>,
    /// The time to hold or release the object, 0 to 60 seconds; default 0.3.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    settle: Option<f64>,
    /// What `pick` does if nothing was picked up, as a person or a camera reports.
    #[serde(skip_serializing_if = "Option::is_none")]
    on_missed: Option<Missed>,
}

impl TryFrom<StepTable> for Action {
    type Error = String;

    fn try_from(mut table: StepTable) -> Result<Self, String> {
        let there = table.keys();
        let verbs: Vec<&str> = there
            .iter()
            .copied()
            .filter(|key| VERBS.contains(key))
            .collect();
        let verb = match verbs[..] {
            [] if there.is_empty() => return Err(format!("a step is empty; {ONE_OF}")),
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
                "a step has {key} beside {verb}; allowed beside it: {}",
                allowed(beside)
            ));
        }
        table.action(verb)
    }
}

impl StepTable {
    /// The keys that are present.
    fn keys(&self) -> Vec<&'static str> {
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
            ("choose", self.choose.is_some()),
            ("by", self.by.is_some()),
            ("every", self.every.is_some()),
            ("timeout", self.timeout.is_some()),
            ("otherwise", self.otherwise.is_some()),
            ("when", self.when.is_some()),
            ("set", self.set.is_some()),
            ("add", self.add.is_some()),
            ("while", self.condition.is_some()),
            ("pick", self.pick.is_some()),
            ("place", self.place.is_some()),
            ("approach", self.approach.is_some()),
            ("retreat", self.retreat.is_some()),
            ("settle", self.settle.is_some()),
            ("on_missed", self.on_missed.is_some()),
        ];
        keys.iter().filter(|key| key.1).map(|key| key.0).collect()
    }

    fn action(&mut self, verb: &str) -> Result<Action, String> {
        let then = self.then()?;
        if let Some(decision) = self.decision(verb) {
            return decision;
        }
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
        let actions = [
            go.take().map(|to| {
                let (path, offset) = (path.unwrap_or(MovingMode::Jump), offset.unwrap_or_default());
                Ok(Action::Go(Go {
                    to,
                    offset,
                    path,
                    then,
                }))
            }),
            laser.take().map(|on| Ok(Action::Laser(on))),
            wait.take()
                .map(|text| checked_text("wait", text, MAX_MESSAGE_LEN).map(Action::Wait)),
            barrier
                .take()
                .map(|name| checked_text("barrier", name, MAX_BARRIER_LEN).map(Action::Barrier)),
            speed
                .take()
                .map(|speed| checked_speed(speed).map(Action::Speed)),
            tool.take().map(|name| Ok(Action::Tool(name))),
            repeat
                .take()
                .map(|times| Ok(Action::Repeat(times, nested(verb, steps)?))),
            each.take()
                .map(|grids| Ok(Action::Each(grids.0, nested(verb, steps)?))),
            call.take().map(|file| Ok(Action::Call(file))),
            arc.take().map(|arc| checked_arc(arc).map(Action::Arc)),
            circle
                .take()
                .map(|circle| checked_arc(circle).map(Action::Circle)),
            drawing.take().map(|drawing| Ok(Action::Drawing(drawing))),
        ];
        actions
            .into_iter()
            .flatten()
            .next()
            .unwrap_or(Ok(Action::Here(then)))
    }

    /// The actions that decide, and those that grip.
    fn decision(&mut self, verb: &str) -> Option<Result<Action, String>> {
        if let Some(question) = self.choose.take() {
            let keys = ChooseKeys {
                by: self.by,
                every: self.every,
                timeout: self.timeout,
                otherwise: self.otherwise.take(),
                when: self.when.take(),
            };
            let question = checked_text("choose", question, MAX_MESSAGE_LEN);
            return Some(question.and_then(|question| keys.choose(question).map(Action::Choose)));
        }
        if let Some(condition) = self.condition.take() {
            let steps = nested(verb, &mut self.steps);
            return Some(steps.map(|steps| Action::While(condition, steps)));
        }
        for (variables, action) in [
            (self.set.take(), Action::Set as fn(Variables) -> Action),
            (self.add.take(), Action::Add),
        ] {
            match variables {
                Some(variables) if variables.is_empty() => {
                    return Some(Err(format!(
                        "{verb} is empty; name a variable, as {{ count = 1 }}"
                    )));
                }
                Some(variables) => return Some(Ok(action(variables))),
                None => {}
            }
        }
        let (at, action) = match (self.pick.take(), self.place.take()) {
            (Some(at), _) => (at, Action::Pick as fn(Transfer) -> Action),
            (None, Some(at)) => (at, Action::Place as fn(Transfer) -> Action),
            (None, None) => return None,
        };
        let keys = TransferKeys {
            path: self.path,
            approach: self.approach,
            retreat: self.retreat,
            settle: self.settle,
            gripper: self.gripper,
            on_missed: self.on_missed.take(),
        };
        Some(keys.transfer(at).map(action))
    }

    /// The table of a `pick` or `place`.
    fn of_transfer(transfer: Transfer) -> Self {
        let keys = TransferKeys::of(transfer);
        Self {
            path: keys.path,
            approach: keys.approach,
            retreat: keys.retreat,
            settle: keys.settle,
            gripper: keys.gripper,
            on_missed: keys.on_missed,
            ..Self::default()
        }
    }

    fn then(&self) -> Result<Here, String> {
        if let Some(gripper) = self.gripper {
            within("gripper", "°", gripper, -90.0, 90.0)?;
        }
        if let Some(pause) = self.pause {
            within("pause", " s", pause, 0.0, MAX_PAUSE_S)?;
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
        // table
        let empty = Self::default();
        match action {
            Action::Go(Go {
                to,
                offset,
                path,
                then,
            }) => Self {
                go: Some(to),
                path: Some(path).filter(|path| *path != MovingMode::Jump),
                offset: Some(offset).filter(|offset| *offset != Offset::default()),
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
            Action::Choose(choose) => {
                let keys = ChooseKeys::of(&choose);
                Self {
                    choose: Some(choose.question),
                    by: keys.by,
                    every: keys.every,
                    timeout: keys.timeout,
                    otherwise: keys.otherwise,
                    when: keys.when,
                    ..empty
                }
            }
            Action::Set(variables) => Self {
                set: Some(variables),
                ..empty
            },
            Action::Add(variables) => Self {
                add: Some(variables),
                ..empty
            },
            Action::While(condition, steps) => Self {
                condition: Some(condition),
                steps: Some(steps),
                ..empty
            },
            Action::Pick(transfer) => Self {
                pick: Some(transfer.at.clone()),
                ..Self::of_transfer(transfer)
            },
            Action::Place(transfer) => Self {
                place: Some(transfer.at.clone()),
                ..Self::of_transfer(transfer)
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
            "anyOf": [
                {"type": "string", "x-names": ["grids"]},
                {"type": "array", "items": {"type": "string"}, "minItems": 1},
            ],
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
            return Err(A::Error::custom("each has no grid; name at least one"));
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
        _ => Err(format!("{verb} has no steps; add at least one")),
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

fn checked_speed(speed: Speed) -> Result<Speed, String> {
    let percents = [
        ("percent", speed.percent),
        ("acceleration_percent", speed.acceleration_percent),
    ];
    let speeds = [
        ("joint", speed.joint),
        ("joint_acceleration", speed.joint_acceleration),
        ("servo", speed.servo),
        ("servo_acceleration", speed.servo_acceleration),
        ("line", speed.line),
        ("line_acceleration", speed.line_acceleration),
    ];
    let bounded = percents
        .map(|field| (field, 100.0))
        .into_iter()
        .chain(speeds.map(|field| (field, 10_000.0)));
    for ((key, value), most) in bounded {
        within(key, "", value.unwrap_or(most), MIN_SPEED, most)?;
    }
    within(
        "jump_height",
        " mm",
        speed.jump_height.unwrap_or(0.0),
        0.0,
        300.0,
    )?;
    if speed == Speed::default() {
        return Err(
            "speed is empty; set percent, joint, line, jump_height or another of its keys".into(),
        );
    }
    Ok(speed)
}

/// The keys allowed beside the action.
fn beside(verb: &str) -> &'static [&'static str] {
    match verb {
        "go" => &["path", "offset", "suction", "gripper", "pause"],
        "here" => &["suction", "gripper", "pause"],
        "repeat" | "each" | "while" => &["steps"],
        "choose" => &["by", "every", "timeout", "otherwise", "when"],
        "pick" => &[
            "path",
            "approach",
            "retreat",
            "settle",
            "gripper",
            "on_missed",
        ],
        "place" => &["path", "approach", "retreat", "settle", "gripper"],
        _ => &[],
    }
}

/// The actions and the keys beside each, for editors: what the schema of a table cannot say.
fn verbs() -> serde_json::Value {
    let rows = VERBS.iter().chain(&["here"]);
    rows.map(|verb| serde_json::json!({ "verb": verb, "beside": beside(verb) }))
        .collect()
}

fn allowed(keys: &[&str]) -> String {
    if keys.is_empty() {
        return "nothing".to_owned();
    }
    keys.join(", ")
}

const VERBS: [&str; 18] = [
    "go", "laser", "wait", "barrier", "speed", "tool", "repeat", "each", "call", "arc", "circle",
    "drawing", "choose", "set", "add", "while", "pick", "place",
];
const ONE_OF: &str = "it needs one of go, pick, place, suction, gripper, pause, laser, wait, barrier, speed, tool, repeat, each, while, choose, set, add, call, arc, circle and drawing";
const FOREVER: &str = "forever";
const MAX_MESSAGE_LEN: usize = 200;
const MAX_BARRIER_LEN: usize = 40;
/// The longest pause of a target (note N10).
pub(crate) const MAX_PAUSE_S: f64 = 655.0;
/// The lowest speed; a lower one would take hours.
pub(crate) const MIN_SPEED: f64 = 0.001;
