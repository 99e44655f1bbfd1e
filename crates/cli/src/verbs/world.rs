//! `dobot world`: what is around a virtual arm.

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
use crate::output;

/// Tell what is around a virtual arm: its paper, its objects and what its tool did to them
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot arm --world scene.toml          serve an arm in a world, in another terminal
  dobot world                           what there is
  dobot world --picture world.svg       its picture
  dobot world --json                    all of it, for programs

examples/scenes/ has some scenes to begin with.")]
pub(crate) struct Args {
    /// Where the arm tells its world: what `dobot arm --world` printed
    #[arg(long, value_name = "HOST:PORT", default_value_t = DEFAULT_WORLD.to_string())]
    from: String,
    /// Make a picture, in a file that ends in .svg
    #[arg(long, value_name = "FILE", value_parser = svg_file)]
    picture: Option<PathBuf>,
    /// Print the whole state as JSON
    #[arg(long)]
    json: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let state = ask(&args.from).await?;
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
            Failure::new(
                error,
                "give the name of a scene file; examples/scenes/ has some",
            )
        } else {
            error.into()
        }
    })?;
    let text = String::from_utf8(bytes)
        .map_err(|_| anyhow!("{} is not text, so it is no scene", file.display()))?;
    Ok(Scene::parse(&text).with_context(|| file.display().to_string())?)
}

async fn ask(from: &str) -> Result<WorldState, Failure> {
    let document = timeout(PATIENCE, read(from)).await.map_err(|_| {
        Failure::new(
            anyhow!(
                "nobody at {from} tells of a world within {} s",
                PATIENCE.as_secs()
            ),
            NOT_THE_ARM,
        )
    })?;
    let document = document.map_err(|error| {
        let refused = error.kind() == ErrorKind::ConnectionRefused;
        let error = anyhow::Error::from(error).context(format!("cannot ask {from}"));
        if refused {
            Failure::new(error, "`dobot arm --world SCENE` serves an arm in a world")
        } else {
            error.into()
        }
    })?;
    serde_json::from_slice(&document).map_err(|_| {
        Failure::new(
            anyhow!("what {from} tells is not the state of a world"),
            NOT_THE_ARM,
        )
    })
}

async fn read(from: &str) -> std::io::Result<Vec<u8>> {
    let stream = TcpStream::connect(from).await?;
    let mut document = Vec::new();
    stream.take(LONGEST).read_to_end(&mut document).await?;
    Ok(document)
}

/// The state for a person, a line for each thing.
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
    lines.extend(state.objects.iter().map(|it| object(it, state)));
    lines.extend(state.events.iter().map(|it| fact("event", &it.to_string())));
    lines
}

fn object(it: &Object, state: &WorldState) -> String {
    let held = if state.held.contains(&it.name) {
        ", held"
    } else {
        ""
    };
    let place = format!(
        "x {:.2}  y {:.2} mm  turn {:.2}°, {:.2} mm above the table{held}",
        it.at_mm.x, it.at_mm.y, it.turn_deg, it.bottom_mm
    );
    fact(&it.name, &place)
}

fn fact(name: &str, value: &str) -> String {
    format!("{name:<18} {value}")
}

fn svg_file(text: &str) -> Result<PathBuf, String> {
    let file = PathBuf::from(text);
    let svg = file
        .extension()
        .is_some_and(|it| it.eq_ignore_ascii_case("svg"));
    if svg {
        Ok(file)
    } else {
        Err("allowed are names that end in .svg".into())
    }
}

const NOT_THE_ARM: &str =
    "`dobot arm --world SCENE` prints where its world is told; its arm is at another port";
/// How long an arm may take to tell.
const PATIENCE: Duration = Duration::from_secs(10);
/// Longer than any world: 256 MiB.
const LONGEST: u64 = 256 << 20;
