//! `dobot materials`: lists the pens and the materials for the laser.

use std::path::PathBuf;

use dobot_draw::{Material, Materials};
use dobot_plan::DrawingTool;

use crate::failure::Failure;
use crate::output;
use crate::verbs::draw::materials;

/// List the pens and materials that `dobot draw` knows
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot materials
  dobot materials --toml > mine.toml     edit it, then `dobot draw --materials mine.toml`
  dobot draw --card 2,5,10,20 --laser cardboard-engrave
                                         burn a test card to find the right speed")]
pub(crate) struct Args {
    /// TOML file with more pens and materials
    #[arg(long, value_name = "FILE", conflicts_with = "toml")]
    materials: Option<PathBuf>,
    /// Print the built-in pens and materials as a TOML file, with a comment for each key
    #[arg(long)]
    toml: bool,
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    if args.toml {
        output::bytes(Materials::BUILT_IN_TOML.as_bytes())?;
        return Ok(());
    }
    for (name, material) in materials(args.materials.as_deref())?.iter() {
        output::line(&line(name, material))?;
    }
    Ok(())
}

fn line(name: &str, material: &Material) -> String {
    let spacing = format!("hatched {} mm apart", material.spacing_mm);
    match material.tool {
        DrawingTool::Pen(pen) => format!(
            "{name:<20} pen    {:>4} mm/s, lifted {} mm, {spacing}",
            pen.draw_speed_mm_s, pen.lift_mm
        ),
        DrawingTool::Laser(laser) => format!(
            "{name:<20} laser  {:>4} mm/s, {}, {spacing}",
            laser.burn_speed_mm_s,
            match laser.times {
                1 => "once".to_owned(),
                times => format!("{times} times"),
            }
        ),
    }
}
