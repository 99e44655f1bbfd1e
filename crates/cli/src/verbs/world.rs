//! `dobot world`: shows the objects around a virtual arm.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::{Context, anyhow};
use dobot_sim::DEFAULT_WORLD;
use dobot_sim::world::{Object, Scene, ToolAction, WorldState};
use tokio::io::AsyncReadExt;
use tokio::net::TcpStream;
use tokio::time::timeout;

use crate::failure::Failure;
use crate::{output, values};

/// Show the objects around a virtual arm
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot arm --world scene.toml        serve an arm with objects, in another terminal
  dobot world                         show its paper, objects, strokes and events
  dobot world --picture world.svg     draw a picture
  dobot world --json                  print everything as JSON

examples/scenes/ contains scenes to start with.")]
pub(crate) struct Args {
    /// Address of the arm's surroundings, as printed by `dobot arm --world`
    #[arg(long, value_name = "HOST:PORT", default_value_t = DEFAULT_WORLD.to_string())]
    address: String,
    /// Draw a picture in an SVG file
    #[arg(long, value_name = "FILE", value_parser = values::svg_file)]
    picture: Option<PathBuf>,
    /// Print the whole state as JSON
    #[arg(long)]
    json: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let state = fetch(&args.address).await?;
    if let Some(file) = &args.picture {
        fs::write(file, state.picture())
            .with_context(|| format!("cannot write {}", file.display()))?;
    }
    if args.json {
        output::json(&state)?;
        return Ok(());
    }
    for line in summary(&state) {
        output::line(&line)?;
    }
    if let Some(file) = &args.picture {
        output::line(&fact("picture", &file.display().to_string()))?;
    }
    Ok(())
}

/// Reads a scene file.
pub(crate) fn read_scene(file: &Path) -> Result<Scene, Failure> {
    let bytes = fs::read(file).map_err(|error| {
        let missing = error.kind() == ErrorKind::NotFound;
        let error = anyhow::Error::from(error).context(format!("cannot read {}", file.display()));
        if missing {
            Failure::new(error, "name a scene file; examples/scenes/ contains some")
        } else {
            error.into()
        }
    })?;
    let text = String::from_utf8(bytes)
        .map_err(|_| anyhow!("{} is not a scene: expected UTF-8 text", file.display()))?;
    Ok(Scene::parse(&text).with_context(|| file.display().to_string())?)
}

/// Reads the state of the surroundings.
async fn fetch(address: &str) -> Result<WorldState, Failure> {
    let document = timeout(PATIENCE, read(address)).await.map_err(|_| {
        Failure::new(
            anyhow!("no answer from {address} within {} s", PATIENCE.as_secs()),
            NOT_THE_ARM,
        )
    })?;
    let document = document.map_err(|error| {
        let refused = error.kind() == ErrorKind::ConnectionRefused;
        let error = anyhow::Error::from(error).context(format!("cannot connect to {address}"));
        if refused {
            Failure::new(error, "start one with `dobot arm --world SCENE`")
        } else {
            error.into()
        }
    })?;
    serde_json::from_slice(&document).map_err(|_| {
        Failure::new(
            anyhow!("the answer from {address} is not the state of a world"),
            NOT_THE_ARM,
        )
    })
}

async fn read(address: &str) -> std::io::Result<Vec<u8>> {
    let stream = TcpStream::connect(address).await?;
    let mut document = Vec::new();
    stream.take(LONGEST).read_to_end(&mut document).await?;
    Ok(document)
}

/// Formats the state, with one line for each object.
fn summary(state: &WorldState) -> Vec<String> {
    let mut lines = vec![fact("time", &format!("{:.2} s", state.time_s))];
    if let Some(arm) = &state.arm {
        lines.push(fact(
            state.tool.tool().label(),
            &format!(
                "x {:.2}  y {:.2}  z {:.2} mm  turn {:.2}°, {:.2} mm above the table",
                arm.x_mm, arm.y_mm, arm.z_mm, arm.rotation_deg, arm.tip_mm
            ),
        ));
    }
    match state.tool.action {
        ToolAction::Pen { .. } => lines.push(fact("strokes", &state.strokes.len().to_string())),
        ToolAction::Laser { .. } => {
            lines.push(fact("burns", &state.burns.len().to_string()));
            lines.push(fact("holes", &state.holes.len().to_string()));
        }
        _ => {}
    }
    lines.extend(state.objects.iter().map(|one| object(one, state)));
    let events = state.events.iter();
    lines.extend(events.map(|event| fact("event", &event.to_string())));
    lines
}

fn object(object: &Object, state: &WorldState) -> String {
    let held = if state.held.contains(&object.name) {
        ", held"
    } else {
        ""
    };
    let place = format!(
        "x {:.2}  y {:.2} mm  turn {:.2}°, {:.2} mm above the table{held}",
        object.at_mm.x, object.at_mm.y, object.turn_deg, object.bottom_mm
    );
    fact(&object.name, &place)
}

fn fact(name: &str, value: &str) -> String {
    format!("{name:<18} {value}")
}

const NOT_THE_ARM: &str = "use the address of the surroundings that `dobot arm --world SCENE` prints; the arm itself has another port";
/// The time limit of an answer.
const PATIENCE: Duration = Duration::from_secs(10);
/// The maximum size of an answer: 256 MiB.
const LONGEST: u64 = 256 << 20;
