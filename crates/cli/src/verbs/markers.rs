//! `dobot markers`: a page of markers for objects.

use std::fs;
use std::path::PathBuf;

use anyhow::Context;
use dobot_calibrate::markers_svg;

use crate::failure::Failure;
use crate::{output, values};

/// Write a page of markers to cut out and stick on objects, for a camera
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot markers markers.svg               twelve markers of 20 mm, 4 to 15
  dobot markers small.svg --side 12 --first 4 --last 40

Print the page at 100 %. Cut along the white around each marker, which the camera
needs: a sixth of the side. The markers 0 to 3 are on the calibration sheet.")]
pub(crate) struct Args {
    /// The page, an SVG file
    #[arg(value_name = "OUT.svg", value_parser = values::svg_file)]
    file: PathBuf,
    /// Side of a marker, 8 to 100 mm
    #[arg(long, value_name = "MM", default_value_t = 20.0, value_parser = values::number(8.0..=100.0, "mm"))]
    side: f64,
    /// First marker, 4 to 49
    #[arg(long, value_name = "NUMBER", default_value_t = 4)]
    first: u16,
    /// Last marker, 4 to 49
    #[arg(long, value_name = "NUMBER", default_value_t = 15)]
    last: u16,
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let file = args.file.display();
    let svg = markers_svg(args.first..=args.last, args.side).map_err(anyhow::Error::from)?;
    fs::write(&args.file, svg).with_context(|| format!("cannot write {file}"))?;
    Ok(output::line(&format!("{file}: print it at 100 %"))?)
}
