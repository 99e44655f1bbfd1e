//! The table of tools: what a model reads about each of them.

use std::sync::Arc;

use rmcp::handler::server::tool::schema_for_input;
use rmcp::model::{JsonObject, Tool, ToolAnnotations};
use schemars::JsonSchema;
use serde_json::{Value, json};

use crate::arguments::{
    AnswerJob, ChangeJob, CheckMove, NewDrawing, Nothing, PlannedDrawing, ProgramArguments,
    RunProgram, StopArguments, ToJoints, ToPoint, WhichJobs,
};

/// A tool.
pub(crate) struct ToolRow {
    pub(crate) name: &'static str,
    title: &'static str,
    description: &'static str,
    input: fn() -> JsonObject,
    /// The fields of its result, with their JSON types; those that may be null end in `?`.
    output: &'static [(&'static str, &'static str)],
    effect: Effect,
}

/// What a tool does to its surroundings.
#[derive(PartialEq, Eq)]
enum Effect {
    /// Nothing changes.
    Reads,
    /// It may move the arm, or change a job.
    Acts,
    /// It stops the arm, also if it is stopped already.
    Stops,
}

impl ToolRow {
    /// Returns the tool for a list.
    pub(crate) fn tool(&self) -> Tool {
        let mut hints = ToolAnnotations::default();
        hints.read_only_hint = (self.effect == Effect::Reads).then_some(true);
        hints.idempotent_hint = (self.effect == Effect::Stops).then_some(true);
        let fields = self.output.iter();
        let properties = fields.map(|(name, kind)| ((*name).to_owned(), output_type(kind)));
        let mut output = JsonObject::new();
        output.insert("type".to_owned(), "object".into());
        output.insert("properties".to_owned(), Value::Object(properties.collect()));
        Tool::new(self.name, self.description, Arc::new((self.input)()))
            .with_title(self.title)
            .with_raw_output_schema(Arc::new(output))
            .with_annotations(hints)
    }
}

fn output_type(kind: &str) -> Value {
    match kind.strip_suffix('?') {
        Some(kind) => json!({ "type": [kind, "null"] }),
        None => json!({ "type": kind }),
    }
}

/// Returns the schema of arguments, without what a model does not need.
fn input<T: JsonSchema + 'static>() -> JsonObject {
    let schema = schema_for_input::<T>().expect("the arguments of a tool are an object");
    let mut schema = Value::Object(JsonObject::clone(&schema));
    shorten(&mut schema);
    if let Value::Object(mut schema) = schema {
        schema.remove("description");
        return schema;
    }
    JsonObject::new()
}

/// Returns the schema of `move_joints`; path and tool are those of `move_to`.
fn input_of_joints() -> JsonObject {
    let mut schema = input::<ToJoints>();
    for name in ["path", "suction", "gripper_deg", "pause_s"] {
        if let Some(Value::Object(argument)) = schema["properties"].get_mut(name) {
            argument.remove("description");
        }
    }
    schema
}

/// Removes what the descriptions say as well: the names of types, formats, ranges, defaults, and null for omitted
/// values.
fn shorten(schema: &mut Value) {
    match schema {
        Value::Object(fields) => {
            for name in ["$schema", "format", "default", "minimum", "maximum"] {
                fields.remove(name);
            }
            if fields
                .get("additionalProperties")
                .is_some_and(Value::is_boolean)
            {
                fields.remove("additionalProperties");
            }
            if fields.get("title").is_some_and(Value::is_string) {
                fields.remove("title");
            }
            if let Some(Value::Array(kinds)) = fields.get_mut("type") {
                kinds.retain(|kind| kind != "null");
                if let [kind] = &kinds[..] {
                    fields["type"] = kind.clone();
                }
            }
            for inner in fields.values_mut() {
                shorten(inner);
            }
        }
        Value::Array(inner) => inner.iter_mut().for_each(shorten),
        _ => {}
    }
}

pub(crate) const TOOLS: [ToolRow; 12] = [
    ToolRow {
        name: "look",
        title: "Look at the arm",
        description: "Returns where the arm is, why it cannot move (`alarms`), who controls it, and its unfinished jobs.",
        input: input::<Nothing>,
        output: &[("arm", "object?"), ("alarms", "array"), ("jobs", "array")],
        effect: Effect::Reads,
    },
    ToolRow {
        name: "check_move",
        title: "Check a move",
        description: "Checks a move from where the arm is: returns its path and time, or the rule that refuses it and the nearest allowed position. Nothing moves.",
        input: input::<CheckMove>,
        output: &[("takes_s", "number")],
        effect: Effect::Reads,
    },
    ToolRow {
        name: "move_to",
        title: "Move to a point",
        description: "Moves the tool to a point, and returns when the arm is at rest. About 130 to 320 mm from the base axis are within reach.",
        input: input::<ToPoint>,
        output: &[("arm", "object?")],
        effect: Effect::Acts,
    },
    ToolRow {
        name: "move_joints",
        title: "Move the joints",
        description: "Moves the joints to angles, and returns when the arm is at rest. Path and tool are as for `move_to`.",
        input: input_of_joints,
        output: &[("arm", "object?")],
        effect: Effect::Acts,
    },
    ToolRow {
        name: "plan_drawing",
        title: "Plan a drawing",
        description: "Plans one of text, svg or file as a drawing. Returns its number for `draw`, a picture, its duration, warnings, and why the arm may not draw it. Nothing moves. The paper is at the height of the pen now, or at `options.place.pen_down` (mm).",
        input: input::<NewDrawing>,
        output: &[
            ("drawing", "integer"),
            ("duration_s", "number"),
            ("warnings", "array"),
            ("refused", "object?"),
        ],
        effect: Effect::Reads,
    },
    ToolRow {
        name: "draw",
        title: "Draw a planned drawing",
        description: "Draws a planned drawing with the pen, as a job. Where a person starts jobs, it is only queued. Laser drawings are refused.",
        input: input::<PlannedDrawing>,
        output: &[("message", "string"), ("job", "object")],
        effect: Effect::Acts,
    },
    ToolRow {
        name: "check_program",
        title: "Check a program",
        description: "Returns the steps of a program (resources dobot://program and dobot://program-schema), their times, and all problems. Nothing moves.",
        input: input::<ProgramArguments>,
        output: &[("problems", "array"), ("steps", "array")],
        effect: Effect::Reads,
    },
    ToolRow {
        name: "run_program",
        title: "Run a program",
        description: "Runs a program as a job. Where a person starts jobs, it is only queued.",
        input: input::<RunProgram>,
        output: &[("message", "string"), ("job", "object")],
        effect: Effect::Acts,
    },
    ToolRow {
        name: "jobs",
        title: "List jobs",
        description: "Returns the jobs with their progress; or one job, when it stops running or `wait_s` is over.",
        input: input::<WhichJobs>,
        output: &[],
        effect: Effect::Reads,
    },
    ToolRow {
        name: "change_job",
        title: "Change a job",
        description: "Pauses or cancels a job, or starts or resumes one of this agent.",
        input: input::<ChangeJob>,
        output: &[("job", "object")],
        effect: Effect::Acts,
    },
    ToolRow {
        name: "answer_job",
        title: "Answer a program",
        description: "Answers the question of a running program of this agent (`question` in `jobs`): one of its answers, or the position that it asks for. Questions for a person are refused.",
        input: input::<AnswerJob>,
        output: &[("message", "string"), ("job", "object")],
        effect: Effect::Acts,
    },
    ToolRow {
        name: "stop",
        title: "Stop the arm",
        description: "Stops the arm. It stays stopped until a person has checked it and resets the stop.",
        input: input::<StopArguments>,
        output: &[("rests_within_s", "number")],
        effect: Effect::Stops,
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    fn listed() -> Vec<Value> {
        TOOLS.iter().map(|row| json!(row.tool())).collect()
    }

    #[test]
    fn the_list_of_tools_takes_less_than_8_kb() {
        let text = json!({ "tools": listed() }).to_string();
        assert!(text.len() < 8000, "{} bytes: {text}", text.len());
    }

    #[test]
    fn every_tool_has_a_title_a_description_and_both_schemas() {
        for tool in listed() {
            let name = tool["name"].as_str().expect("a name");
            assert!(
                tool["title"].is_string() && tool["description"].is_string(),
                "{name}"
            );
            assert_eq!(tool["inputSchema"]["type"], "object", "{name}");
            assert_eq!(tool["outputSchema"]["type"], "object", "{name}");
        }
    }

    #[test]
    fn every_argument_of_a_move_has_a_unit_or_an_explanation() {
        let tools = listed();
        let moves = tools.iter().find(|tool| tool["name"] == "move_to");
        let properties = moves.expect("it is there")["inputSchema"]["properties"].clone();
        for (name, argument) in properties.as_object().expect("arguments") {
            assert!(argument["description"].is_string(), "{name}: {argument}");
        }
    }
}
