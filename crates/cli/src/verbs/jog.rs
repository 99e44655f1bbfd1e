//! `dobot jog`: moves one axis for a time, or all of them with keys.

use std::time::Duration;

use dobot_api::{Button, JogFrame};
use dobot_host::StationClient;
use dobot_wire::Status;

use crate::connect::To;
use crate::control::{self, arm_laser, check_pose, run_command, take_control};
use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::pendant::{self, Drive, PadArgs, Panel, Pendant, check_terminal};
use crate::{output, values};

/// Move an axis for a time, or all axes with keys; switch pump and laser
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot jog                               with keys, while they are held
  dobot jog --gamepad /dev/input/js0      also with a gamepad (Linux)
  dobot jog x+ --for 1.5                  forward for 1.5 s
  dobot jog base- --for 0.5 --percent 20  slowly to the right
  dobot jog suction-on
  dobot jog servo+ --frame linear         the servo by linear jog (state 7)

The axis stops when the time is over, on Ctrl-C, and if anything fails, even if
this program is killed. The laser stays off without `--arm-laser`, and if the
policy forbids it to be on while the arm stands still (`laser.standing`): to
focus it, use a policy that allows this.

Keys: arrows, page up and page down move along x, y and z (Tab: the joints;
.: steps of 1 and 0.1 mm or degrees), r and f turn the tool, o and c move the
gripper, u and j switch the pump, 1 to 9 and 0 set the speed; Space, Esc or s
stops the arm, q quits. Most terminals do not report when a key is released:
there the arm stops when the key no longer repeats, after the dead-man time of
the policy (0.15 s), so that the first press is a short step.")]
pub(crate) struct Args {
    /// Axis or switch: base+ base- rear+ rear- fore+ fore- servo+ servo- gripper+ gripper- x+ x- y+ y- z+ z-,
    /// suction-on suction-off laser-on laser-off (default: jog with the keyboard)
    button: Option<Button>,
    /// Duration of the motion, 0.02 to 60 seconds, at least until a status shows it (about 0.2 s)
    #[arg(long = "for", value_name = "SECONDS", default_value = "0.5", value_parser = values::seconds(0.02..=60.0), requires = "button")]
    time: Duration,
    /// Kind of jog: joint (state 2) or linear (state 7); x, y and z have only linear, base, rear and fore only
    /// joint, the others both (default: joint)
    #[arg(
        long,
        value_name = "joint|linear",
        requires = "button",
        hide_short_help = true
    )]
    frame: Option<JogFrame>,
    /// Percentage of the jog speed, 1 to 100
    #[arg(
        long,
        value_name = "PERCENT",
        default_value = "50",
        value_parser = values::number(1.0..=100.0_f32, "percent"),
        requires = "button"
    )]
    percent: f32,
    /// Arm the laser for this many seconds, 1 to 3600; everyone present must wear goggles
    #[arg(long, value_name = "SECONDS", value_parser = values::laser_seconds, requires = "button")]
    arm_laser: Option<Duration>,
    #[command(flatten)]
    pad: PadArgs,
    #[command(flatten)]
    to: To,
    /// Print the last status as JSON
    #[arg(long)]
    json: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    if args.button.is_none() {
        check_terminal(
            "`dobot jog` without an axis",
            "name an axis: `dobot jog x+ --for 1`",
        )?;
    }
    let jog = async |station: &mut StationClient| match args.button {
        Some(button) => args.press(station, button).await,
        None => with_keys(station, &args.to, &args.pad, Drive::Jog, |pendant| pendant).await,
    };
    let status = args.to.with_arm("jog", jog).await?;
    Ok(output::status(&status, args.json)?)
}

impl Args {
    /// Presses a button: holds an axis, or sets a switch.
    async fn press(&self, station: &mut StationClient, button: Button) -> Result<Status, Failure> {
        let button = button
            .with_frame(self.frame)
            .map_err(|error| Failure::usage(error).with_hint("leave out `--frame`"))?;
        let jog = button.jog(self.percent);
        if button.moves() {
            check_pose(station, self.to.pose_confirmed).await?;
        }
        // After its start, a station has to hear from the arm first.
        control::status(station).await?;
        take_control(station).await?;
        arm_laser(station, self.arm_laser).await?;
        if button.moves() {
            let end = station.jog_for(jog, self.time, interrupt()).await?;
            if !end.has_moved {
                eprintln!("the arm did not move: the axis is at its limit");
            }
            return Ok(end.arm.status);
        }
        run_command(station, jog.command()).await?;
        self.hold_switch(station, button).await?;
        control::wait_for_rest(station).await
    }

    /// Keeps a switch as it is for the time, if it has a button that ends that.
    async fn hold_switch(
        &self,
        station: &mut StationClient,
        button: Button,
    ) -> Result<(), Failure> {
        let Some(end) = button.end() else {
            return Ok(());
        };
        tokio::select! {
            () = station.wait(self.time) => {}
            () = interrupt() => {}
        }
        run_command(station, end.command()).await?;
        Ok(())
    }
}

/// Lets a person move the arm with keys. `panel` creates the screen around the pendant.
pub(crate) async fn with_keys<P: Panel>(
    station: &mut StationClient,
    to: &To,
    pad: &PadArgs,
    drive: Drive,
    panel: impl FnOnce(Pendant) -> P,
) -> Result<Status, Failure> {
    let pad = pad.open()?;
    check_pose(station, to.pose_confirmed).await?;
    take_control(station).await?;
    // The first press then moves the arm immediately.
    control::wait_briefly_for_rest(station).await?;
    pendant::run(station, drive, pad, panel).await?;
    control::wait_for_rest(station).await
}
