//! What an agent can read about the arm and its station.

use dobot_api::fetch;
use dobot_draw::Options;
use dobot_teach::Program;
use rmcp::ErrorData;
use rmcp::model::{Resource, ResourceContents};
use schemars::schema_for;
use serde_json::{Value, json};

use crate::call::Call;

/// Returns all resources.
pub(crate) fn list() -> Vec<Resource> {
    let row = |(uri, title, description, mime): (&str, &str, &str, &str)| {
        Resource::new(uri, uri.trim_start_matches("dobot://"))
            .with_title(title)
            .with_description(description)
            .with_mime_type(mime)
    };
    ROWS.map(row).into()
}

const ROWS: [(&str, &str, &str, &str); 6] = [
    (
        OPTIONS,
        "Options of drawings",
        "The JSON Schema of `options` of `plan_drawing`",
        JSON,
    ),
    (
        PROGRAM,
        "Example of a program",
        "A program that carries cubes, with comments",
        TOML,
    ),
    (
        PROGRAM_SCHEMA,
        "Format of programs",
        "The JSON Schema of programs, with all steps and keys",
        JSON,
    ),
    (POLICY, "Safety policy", "The limits of every motion", JSON),
    (
        WORLD,
        "World of a virtual arm",
        "Its objects, ink and events; positions in mm",
        JSON,
    ),
    (
        RECORDINGS,
        "Recordings",
        "The recordings of the station: names, sizes and times",
        JSON,
    ),
];

/// Reads a resource.
pub(crate) async fn read(call: &Call, uri: &str) -> Result<ResourceContents, ErrorData> {
    let text = match uri {
        OPTIONS => {
            let mut schema = json!(schema_for!(Options));
            schema["description"] =
                "The options of a drawing, in groups; lengths in mm, angles in degrees.".into();
            schema.to_string()
        }
        PROGRAM => EXAMPLE.to_owned(),
        PROGRAM_SCHEMA => Program::schema().to_string(),
        POLICY => station(call, "/api/v1/policy").await?,
        WORLD => station(call, "/api/v1/world").await?,
        RECORDINGS => station(call, "/api/v1/recordings").await?,
        _ => {
            let known = ROWS.map(|(uri, ..)| uri).join(", ");
            let text = format!("there is no resource `{uri}`; there are {known}");
            return Err(ErrorData::resource_not_found(text, None));
        }
    };
    let mime = if uri == PROGRAM { TOML } else { JSON };
    Ok(ResourceContents::text(text, uri).with_mime_type(mime))
}

/// Returns what the station answers, as JSON.
async fn station(call: &Call, path: &str) -> Result<String, ErrorData> {
    let failed = |text: String| ErrorData::internal_error(text, None);
    let address = call
        .station()
        .await
        .map_err(|refused| failed(json!(refused).to_string()))?;
    let value: Value = fetch(&address, path)
        .await
        .map_err(|error| failed(error.to_string()))?;
    Ok(value.to_string())
}

const OPTIONS: &str = "dobot://drawing-options";
const PROGRAM: &str = "dobot://program";
const PROGRAM_SCHEMA: &str = "dobot://program-schema";
const POLICY: &str = "dobot://policy";
const WORLD: &str = "dobot://world";
const RECORDINGS: &str = "dobot://recordings";
const JSON: &str = "application/json";
const TOML: &str = "application/toml";

/// A program with the steps that are used most.
pub(crate) const EXAMPLE: &str = r#"title = "two cubes"

[points]                        # mm in the base frame; z is the height of the suction cup's flange
left = { x = 200, y = 60, z = -15 }
right = { x = 200, y = -60, z = -14 }

[[steps]]
speed = { percent = 50, acceleration_percent = 50, jump_height = 40 }

[[steps]]
repeat = 2

[[steps.steps]]
go = "left"                     # lifts, moves across and lowers (a jump)
suction = true
pause = 0.5                     # seconds, until the cup grips

[[steps.steps]]
go = "right"
suction = false
pause = 0.5

[[steps.steps]]
go = { x = 220, y = 0, z = 40 }
path = "movl"                   # a straight line; "movj" turns all joints together

[[steps.steps]]
wait = "Put the next cube on the left."    # until a person continues
"#;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_resource_has_a_title_and_a_type() {
        for resource in list() {
            assert!(resource.uri.starts_with("dobot://"));
            assert!(
                resource.title.is_some() && resource.mime_type.is_some(),
                "{}",
                resource.uri
            );
        }
    }
}
