//! `dobot jog`: move one axis for a while, or all of them with keys.

use std::time::Duration;

use anyhow::bail;
use dobot_api::{Button, Jog, JogFrame, Request};
use dobot_host::StationClient;
use dobot_wire::Status;

use crate::connect::To;
use crate::control::{self, arm_laser, carry_out, check_pose, take_control};
use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::output;
use crate::pendant::{self, Drive, PadArgs, Panel, Pendant, check_terminal};

/// Move one axis for a while, or all with keys; switch the suction cup or the laser
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot jog                              with keys, for as long as they are held
  dobot jog --gamepad /dev/input/js0     and with a gamepad (Linux)
  dobot jog x+ --for 1.5                 forward for a second and a half
  dobot jog base- --for 0.5 --speed 20   slowly to the right
  dobot jog suction-on
  dobot jog servo+ --frame linear        the servo with the linear jog (state 7)

The axis is released when the time is over, on Ctrl-C, and when anything goes wrong, also when this program
is killed. The laser stays off without `--arm-laser`, and where the policy forbids a light that stands
(`laser.standing`): focus with it allowed.

With keys: arrows, page up and page down move along x, y and z (Tab: the joints; a point: steps of 1 and of 0.1 mm or degrees), r and f turn the tool, o and c
move the gripper, u and j switch the pump, 1 to 9 and 0 are the speed; Space, Esc or s stops the arm, q leaves.
Most terminals do not tell when a key is let go: there the arm stops when the key repeats no more, after the
dead-man time of the policy (0.15 s), so the first press is a short step.")]
pub(crate) struct Args {
    /// base+ base- rear+ rear- fore+ fore- servo+ servo- gripper+ gripper- x+ x- y+ y- z+ z-,
    /// suction-on suction-off laser-on laser-off; without one, keys of this terminal are the buttons
    button: Option<Button>,
    /// How long, in seconds
    #[arg(long = "for", value_name = "SECONDS", default_value = "0.5", value_parser = seconds, requires = "button")]
    time: Duration,
    /// With which jog: joint (state 2) or linear (state 7); x, y and z have the linear one alone, base, rear and
    /// fore the joint one, and the others have both (default: joint)
    #[arg(long, value_name = "joint|linear", requires = "button")]
    frame: Option<JogFrame>,
    /// Share of the jog speed, in percent from 1 to 100
    #[arg(
        long,
        value_name = "PERCENT",
        default_value_t = 50.0,
        requires = "button"
    )]
    speed: f32,
    /// Let the laser be switched on for so many seconds: everybody's goggles are on
    #[arg(long, value_name = "SECONDS", value_parser = laser_seconds, requires = "button")]
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
            "name one: `dobot jog x+ --for 1`",
        )?;
    }
    let jog = async |station: &mut StationClient| match args.button {
        Some(button) => args.press(station, button).await,
        None => with_keys(station, &args.to, &args.pad, Drive::Jog, |it| it).await,
    };
    let status = args.to.with_arm("jog", jog).await?;
    Ok(output::status(&status, args.json)?)
}

impl Args {
    /// A button has to be held, and a switch has not.
    async fn press(&self, station: &mut StationClient, button: Button) -> Result<Status, Failure> {
        let button = button
            .with_frame(self.frame)
            .map_err(|it| Failure::new(it, "leave `--frame` out"))?;
        let jog = button.jog(self.speed);
        if button.moves() {
            check_pose(station, self.to.pose_confirmed).await?;
        }
        let before = control::status(station).await?;
        take_control(station).await?;
        arm_laser(station, self.arm_laser).await?;
        if button.moves() {
            let held = hold(station, jog, self.time).await;
            station.request(Request::Release).await?;
            held?;
        } else {
            carry_out(station, jog.command()).await?;
            if let Some(end) = button.end() {
                tokio::select! {
                    () = station.wait(self.time) => {}
                    () = interrupt() => {}
                }
                carry_out(station, end.command()).await?;
            }
        }
        let now = control::rest(station).await?;
        if button.moves() && now == before {
            eprintln!(
                "the arm stands where it stood: this axis is at its end, or the time was over before the arm got the \
                button; hold it longer, as in `--for 1`"
            );
        }
        Ok(now)
    }
}

/// Lets a person move the arm with keys; `panel` makes what is on the screen of a pendant.
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
    // The first press moves the arm at once.
    control::rest_soon(station).await?;
    pendant::run(station, drive, pad, panel).await?;
    control::rest(station).await
}

/// Holds a button by saying so again and again, until its time is over or Ctrl-C.
async fn hold(station: &mut StationClient, jog: Jog, time: Duration) -> Result<(), Failure> {
    let mut interrupt = std::pin::pin!(interrupt());
    // A press waits for the arm to run down; its time is that of the motion.
    control::rest_soon(station).await?;
    station.request_at_rest(Request::Jog { jog }).await?;
    let until = station.now() + time;
    while station.now() < until {
        let left = until.saturating_sub(station.now());
        tokio::select! {
            () = station.wait(BEAT.min(left)) => {}
            () = &mut interrupt => break,
        }
        if station.now() < until {
            station.request(Request::Jog { jog }).await?;
        }
    }
    Ok(())
}

fn seconds(text: &str) -> anyhow::Result<Duration> {
    match text.parse() {
        Ok(seconds) if (0.02..=60.0).contains(&seconds) => Ok(Duration::from_secs_f64(seconds)),
        _ => bail!("allowed are 0.02 to 60 seconds"),
    }
}

/// For how long a laser may be armed.
pub(crate) fn laser_seconds(text: &str) -> anyhow::Result<Duration> {
    match text.parse() {
        Ok(seconds) if (1.0..=3600.0).contains(&seconds) => Ok(Duration::from_secs_f64(seconds)),
        _ => bail!("allowed are 1 to 3600 seconds"),
    }
}

/// A third of the time after which a station lets a button go.
const BEAT: Duration = Duration::from_millis(50);
