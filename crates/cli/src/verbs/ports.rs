//! `dobot ports`: lists the serial ports of this machine.

use crate::failure::Failure;
use crate::output;

/// List the serial ports of this machine
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot ports
  dobot ports --json

No port is opened, so that no arm is reset.")]
pub(crate) struct Args {
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let ports = dobot_session::ports()?;
    if args.json {
        let ports: Vec<_> = ports
            .iter()
            .map(|port| serde_json::json!({ "path": port.path, "device": port.device }))
            .collect();
        output::json(&ports)?;
    } else if ports.is_empty() {
        eprintln!(
            "no serial ports; check that the arm is plugged in, or serve a virtual one with `dobot arm`"
        );
    } else {
        for port in ports {
            let device = port.device.unwrap_or_default();
            output::line(format!("serial:{:24} {device}", port.path).trim_end())?;
        }
    }
    Ok(())
}
