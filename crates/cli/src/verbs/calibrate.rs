//! `dobot calibrate`: find what is wrong with an arm.

mod comb;
mod kept;
mod paper;
mod screen;
mod test;
mod toucher;

use std::ffi::OsString;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow, bail};
use dobot_api::{CalibrationFile, Request, Zeros};
use dobot_calibrate::{check_bar, read_calibration, sheet_svg, write_calibration};
use dobot_host::StationClient;
use dobot_wire::{MoveJoints, MovingMode, Status};

use self::comb::{CombOf, read_slack};
use self::paper::PaperToucher;
use self::toucher::Toucher;
use crate::bounded;
use crate::connect::To;
use crate::control::{self, carry_out, check_pose, take_control};
use crate::failure::Failure;
use crate::output;
use crate::pendant::{Drive, PadArgs, check_terminal};
use crate::verbs::jog::with_keys;

/// Find what is wrong with an arm: touch the points of a printed sheet
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot calibrate --sheet sheet.svg         the sheet to print, at 100 %
  dobot calibrate arm.toml --bar 200        touch its points; the bar of the print was measured
  dobot draw picture.svg --calibration arm.toml
                                            draw where the sheet says
  dobot arm --calibration arm.toml          a virtual arm with the same zeros and the same backlash
  dobot calibrate arm.toml --use            the calibration of a file holds for the arm from now on
  dobot calibrate arm.toml --paper          touch the paper: three places tell its plane, nine how it is bent
  dobot calibrate arm.toml --comb base      draws lines that tell how slack the base is
  dobot calibrate --test 30                 how well the arm finds the same place again
  dobot calibrate --angles                  tells the arm its true angles, until it is switched off
  dobot calibrate --forget                  the arm is taken to be as drawn again
  dobot calibrate arm.toml --undo           what was known before

Lay the sheet in front of the arm as it says, and put the pen in. Jog with the keys of `dobot jog` until the tip
stands on the point, each time from the right and from above, so that the play of the joints is on the same side.
  Enter      the tip is on the point        n   the arm does not get there: the next point
  z          takes the last touch back         b   the tip is on the block, which stands on the point (--block)
  w  w       shows what would be kept, then keeps it; q leaves without

Four points are enough for a result, nine for its full accuracy. Nothing is kept that was not shown. What is kept holds
for this arm at once, and whenever it is there again: moves, programs, drawings and the policy speak of true places then.
After a reset of the arm its base counts anew: the touches before are forgotten.")]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a switch of the command line"
)]
pub(crate) struct Args {
    /// What is known of the arm, a TOML file; it may be new
    #[arg(required_unless_present_any = ["sheet", "forget", "angles", "test"])]
    file: Option<PathBuf>,
    /// Write the sheet to print, as SVG, and touch nothing
    #[arg(long, value_name = "OUT.svg", conflicts_with_all = ["file", "bar", "undo", "backlash"])]
    sheet: Option<PathBuf>,
    /// How long the bar of the printed sheet is, measured with a ruler, in millimetres
    #[arg(long, value_name = "MM")]
    bar: Option<f64>,
    /// How high a block is that you put on points (the key b says so), in millimetres from 5 to 100
    #[arg(long, value_name = "MM", value_parser = block, conflicts_with_all = ["sheet", "undo", "use_file", "forget", "angles", "comb", "test", "paper"])]
    block: Option<f64>,
    /// How slack base, rear arm and forearm are, in degrees from 0 to 5
    #[arg(long, value_name = "BASE,REAR,FORE", value_parser = backlash)]
    backlash: Option<[f64; 3]>,
    /// Draw lines by which you read how slack a joint is, and keep that
    #[arg(long, value_name = "JOINT", conflicts_with_all = ["bar", "backlash", "undo", "use_file"])]
    comb: Option<CombOf>,
    /// Go to the middle of the sheet so often, each time from another side, and tell how far apart it comes (ISO 9283);
    /// at a real arm you read a gauge
    #[arg(long, value_name = "TIMES", num_args = 0..=1, default_missing_value = "30", value_parser = test::times, conflicts_with_all = ["file", "sheet", "bar", "backlash", "undo", "use_file", "forget", "angles"])]
    test: Option<u32>,
    /// Bring back what was known before the last calibration, and touch nothing
    #[arg(long, conflicts_with_all = ["bar", "backlash"])]
    undo: bool,
    /// Have the calibration of the file hold for the arm, and touch nothing
    #[arg(long = "use", conflicts_with_all = ["bar", "backlash", "undo"])]
    use_file: bool,
    /// Take the arm to be as drawn again
    #[arg(long, conflicts_with_all = ["file", "sheet", "bar", "backlash", "undo", "use_file"])]
    forget: bool,
    /// Turn the base straight ahead and tell the arm its true angles (state 9, mode 3): its zeros are right until it
    /// is switched off, and its own limits hold where they should
    #[arg(long, conflicts_with_all = ["file", "sheet", "bar", "backlash", "undo", "use_file", "forget"])]
    angles: bool,
    /// Touch the paper at three places and more, wherever it lies: drawings and the policy's table follow it
    #[arg(long, conflicts_with_all = ["sheet", "bar", "backlash", "undo", "use_file", "forget", "angles", "comb", "test"])]
    paper: bool,
    /// Write a picture of how far each touch is from where it should be, when the result is kept
    #[arg(long, value_name = "OUT.svg", conflicts_with_all = ["sheet", "undo", "use_file", "forget", "angles", "comb", "test", "paper"])]
    picture: Option<PathBuf>,
    #[command(flatten)]
    pad: PadArgs,
    #[command(flatten)]
    to: To,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    if let Some(sheet) = &args.sheet {
        fs::write(sheet, sheet_svg())
            .with_context(|| format!("cannot write {}", sheet.display()))?;
        return Ok(output::line(&format!(
            "{}: print it at 100 %, and measure its bar",
            sheet.display()
        ))?);
    }
    if args.forget {
        let forget = async |station: &mut StationClient| hold(station, None).await;
        return args.to.with_arm("calibrate", forget).await;
    }
    if let Some(times) = args.test {
        let look = async |station: &mut StationClient| test::test(station, &args.to, times).await;
        return args.to.with_arm("calibrate", look).await;
    }
    if args.angles {
        let tell = async |station: &mut StationClient| tell_angles(station, &args.to).await;
        return args.to.with_arm("calibrate", tell).await;
    }
    let file = args.file.as_deref().expect("clap asks for one");
    if args.use_file {
        let known = read(file)?;
        let take = async |station: &mut StationClient| hold(station, Some(known)).await;
        return args.to.with_arm("calibrate", take).await;
    }
    if let Some(of) = args.comb {
        let known = read(file)?;
        let look = async |station: &mut StationClient| {
            read_slack(station, &args.to, file, known, of).await
        };
        return args.to.with_arm("calibrate", look).await;
    }
    if args.undo {
        return bring_back(file);
    }
    if let Some(bar_mm) = args.bar {
        check_bar(bar_mm)?;
    }
    check_terminal(
        "`dobot calibrate`",
        "a person has to look where the tip stands",
    )?;
    let before = known(file)?;
    let touch = async |station: &mut StationClient| {
        let file = file.to_owned();
        let before = before.clone();
        let status = if args.paper {
            hold_for_paper(station, before.as_ref()).await?;
            let panel = |pendant| PaperToucher::new(pendant, file.clone(), before.clone());
            with_keys(station, &args.to, &args.pad, Drive::Jog, panel).await?
        } else {
            let panel = |pendant| {
                Toucher::new(pendant, file.clone(), before.clone())
                    .with_backlash(args.backlash)
                    .with_block(args.block)
                    .with_picture(args.picture.clone())
            };
            with_keys(station, &args.to, &args.pad, Drive::Jog, panel).await?
        };
        // What was kept holds for this arm from now on.
        if let Some(kept) = known(&file)?.filter(|it| before.as_ref() != Some(it)) {
            hold(station, Some(kept)).await?;
        }
        Ok(status)
    };
    let status = args.to.with_arm("calibrate", touch).await?;
    Ok(output::status(&status, false)?)
}

/// Has a calibration hold for the arm, or none.
async fn hold(
    station: &mut StationClient,
    calibration: Option<CalibrationFile>,
) -> Result<(), Failure> {
    let calibration = calibration.map(Box::new);
    let text = match &calibration {
        Some(known) => {
            let Zeros { base, rear, fore } = known.zeros;
            let name = known.name.as_deref().unwrap_or("the arm");
            format!(
                "{name} is calibrated: all places are true ones (zeros: base {base:.2}, rear {rear:.2}, fore {fore:.2} degrees)"
            )
        }
        None => "the arm is taken to be as drawn".to_owned(),
    };
    station
        .request_at_rest(Request::Calibrate { calibration })
        .await?;
    Ok(output::line(&text)?)
}

/// Has the arm say true places, as the paper is touched at them.
async fn hold_for_paper(
    station: &mut StationClient,
    known: Option<&CalibrationFile>,
) -> Result<(), Failure> {
    if let Some(known) = known {
        return hold(station, Some(known.clone())).await;
    }
    let (arm, _) = control::arm(station).await?;
    if arm.told.is_some() {
        return Err(Failure::new(
            anyhow!("the arm is calibrated, and the file that says how is not there"),
            "name the file of its calibration, or take the arm to be as drawn: `dobot calibrate --forget`",
        ));
    }
    Ok(())
}

/// Turns the base straight ahead, and tells the arm its true angles.
async fn tell_angles(station: &mut StationClient, to: &To) -> Result<(), Failure> {
    check_pose(station, to.pose_confirmed).await?;
    take_control(station).await?;
    let (arm, _) = control::arm(station).await?;
    if arm.told.is_none() {
        return Err(Failure::new(
            anyhow!("the arm is not calibrated, so its true angles are not known"),
            "`dobot calibrate ARM.toml` finds them",
        ));
    }
    let Status {
        rear_deg,
        fore_deg,
        servo_deg,
        ..
    } = arm.status;
    // From the right, so that the play of the joints is on the side on which they were touched.
    for base_deg in [-RUN_UP_DEG, 0.0] {
        let turned = MoveJoints::to([base_deg, rear_deg, fore_deg, servo_deg]);
        carry_out(station, turned.with_mode(MovingMode::MovJ).into()).await?;
    }
    station.request_at_rest(Request::TellAngles).await?;
    control::rest(station).await?;
    Ok(output::line(
        "the arm knows its true angles until it is switched off; look at it, then `dobot confirm`",
    )?)
}

/// What is known of an arm, in a file that must be there.
pub(crate) fn read(file: &Path) -> Result<CalibrationFile, Failure> {
    known(file)?.ok_or_else(|| {
        Failure::new(
            anyhow!("{} is not there", file.display()),
            "`dobot calibrate` makes it",
        )
    })
}

/// What is known of an arm; nothing where there is no file.
fn known(file: &Path) -> Result<Option<CalibrationFile>, Failure> {
    let text = match bounded::settings(file) {
        Ok(text) => text,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => {
            let read = Err(error);
            return Ok(read.with_context(|| format!("{} cannot be read", file.display()))?);
        }
    };
    let known = read_calibration(&text).with_context(|| file.display().to_string())?;
    Ok(Some(named(known, file)))
}

/// An arm is called as its file, unless the file says its name.
fn named(known: CalibrationFile, file: &Path) -> CalibrationFile {
    let stem = file.file_stem().map(|it| it.to_string_lossy().into_owned());
    CalibrationFile {
        name: known.name.or(stem),
        ..known
    }
}

/// Keeps a calibration in place of the one before, which stays beside it.
fn keep(file: &Path, known: &CalibrationFile) -> Result<(), Failure> {
    let before = before(file);
    fs::copy(file, &before).with_context(|| format!("cannot write {}", before.display()))?;
    let text = write_calibration(known);
    Ok(fs::write(file, text).with_context(|| format!("cannot write {}", file.display()))?)
}

/// Exchanges a calibration and the one before it.
fn bring_back(file: &Path) -> Result<(), Failure> {
    let before = before(file);
    let Some(known) = known(&before)? else {
        let error = anyhow!("{} is not there", before.display());
        return Err(Failure::new(error, "no calibration was replaced yet"));
    };
    let replaced = fs::read(file).with_context(|| format!("{} cannot be read", file.display()))?;
    fs::rename(&before, file).with_context(|| format!("cannot write {}", file.display()))?;
    fs::write(&before, replaced).with_context(|| format!("cannot write {}", before.display()))?;
    output::line(&format!("{} is again:", file.display()))?;
    Ok(output::line(write_calibration(&known).trim_end())?)
}

/// Where the calibration before the last one is kept.
fn before(file: &Path) -> PathBuf {
    let mut name = OsString::from(file);
    name.push(".before");
    name.into()
}

fn block(text: &str) -> anyhow::Result<f64> {
    match text.trim().parse() {
        Ok(height_mm) if (5.0..=100.0).contains(&height_mm) => Ok(height_mm),
        _ => bail!("expected its height in millimetres, 5 to 100, as in 40"),
    }
}

fn backlash(text: &str) -> anyhow::Result<[f64; 3]> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|it| it.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[base, rear, fore])
            if [base, rear, fore].iter().all(|it| (0.0..=5.0).contains(it)) =>
        {
            Ok([base, rear, fore])
        }
        _ => bail!("expected three angles from 0 to 5 degrees, as in 0.25,0.2,0.2"),
    }
}

/// More than any joint is slack.
const RUN_UP_DEG: f32 = 6.0;
