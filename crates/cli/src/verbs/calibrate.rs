//! `dobot calibrate`: measures the errors of an arm.

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
use std::time::{SystemTime, UNIX_EPOCH};

use anyhow::{Context, anyhow, bail};
use dobot_api::{ArmView, CalibrationFile, Request, Zeros};
use dobot_calibrate::{BarError, Sheet, read_calibration, write_calibration};
use dobot_host::StationClient;
use dobot_wire::{MoveJoints, MovingMode, Status};

use self::comb::{CombOf, measure_backlash};
use self::paper::PaperToucher;
use self::toucher::Toucher;
use crate::bounded;
use crate::connect::To;
use crate::control::{self, check_pose, run_command, take_control};
use crate::failure::Failure;
use crate::pendant::{Drive, PadArgs, check_terminal};
use crate::verbs::jog::with_keys;
use crate::{output, values};

/// Calibrate an arm by touching the points of a printed sheet
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot calibrate --sheet sheet.svg       a sheet to print, at 100 %
  dobot calibrate arm.toml                touch its points; asks for the number of
                                          the sheet and the length of its bar
  dobot draw picture.svg --calibration arm.toml
                                          draw where the sheet says
  dobot calibrate arm.toml --use          apply the calibration of a file
  dobot calibrate arm.toml --touch-paper  touch the paper: 3 points find its plane,
                                          9 its shape
  dobot calibrate arm.toml --comb base    measure the backlash of the base
  dobot calibrate --test 30               measure the repeatability
  dobot calibrate --angles                send the arm its calibrated angles
  dobot calibrate --forget                use the nominal dimensions again
  dobot calibrate arm.toml --undo         restore the previous calibration

Lay the sheet in front of the arm as printed on it, and insert the pen. Jog with
the keys of `dobot jog` until the tip is on the point. Approach each point from
the right and from above, so that the backlash is on the same side.
  Enter   record the point             n   skip it: out of reach
  z       undo the last touch          b   the tip is on the block on the point
                                           (--block)
  m       the tool was measured and is where the result puts it
  w  w    show the result, then save it; q quits without saving

Four points give a result, nine its full accuracy. Nothing is saved that was
not shown. A saved calibration applies to this arm immediately and whenever it
is connected: moves, programs, drawings and the policy then use calibrated
positions. A reset of the arm discards the touches, because its base starts at
0 again.")]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a switch of the command line"
)]
pub(crate) struct Args {
    /// Calibration of the arm, a TOML file; created if it does not exist
    #[arg(required_unless_present_any = ["sheet", "forget", "angles", "test"])]
    file: Option<PathBuf>,
    /// Write the sheet to print, an SVG file
    #[arg(long, value_name = "OUT.svg", conflicts_with_all = ["file", "bar", "undo", "backlash"])]
    sheet: Option<PathBuf>,
    /// Number of the printed sheet, and the length of its bar, measured with a ruler, in mm [default: asks]
    #[arg(long, value_name = "SHEET:MM", value_parser = bar)]
    bar: Option<()>,
    /// Height of a block to put on points (key b), 5 to 100 mm
    #[arg(long, value_name = "MM", value_parser = values::number(5.0..=100.0, "mm"), conflicts_with_all = ["sheet", "undo", "use_file", "forget", "angles", "comb", "test", "touch_paper"])]
    block: Option<f64>,
    /// Backlash of base, rear arm and forearm, 0 to 5 degrees each
    #[arg(long, value_name = "BASE,REAR,FORE", value_parser = backlash)]
    backlash: Option<[f64; 3]>,
    /// Draw lines to measure the backlash of a joint, and save it
    #[arg(long, value_name = "JOINT", conflicts_with_all = ["bar", "backlash", "undo", "use_file"])]
    comb: Option<CombOf>,
    /// Measure the repeatability (ISO 9283): move to the middle of the sheet this many times, 2 to 100, from
    /// different sides; with a real arm you read a gauge [without a value: 30]
    #[arg(long, value_name = "TIMES", num_args = 0..=1, default_missing_value = "30", value_parser = test::times, conflicts_with_all = ["file", "sheet", "bar", "backlash", "undo", "use_file", "forget", "angles"])]
    test: Option<u32>,
    /// Restore the previous calibration
    #[arg(long, conflicts_with_all = ["bar", "backlash"])]
    undo: bool,
    /// Apply the calibration in the file
    #[arg(long = "use", conflicts_with_all = ["bar", "backlash", "undo"])]
    use_file: bool,
    /// Discard the calibration, and use the nominal dimensions
    #[arg(long, conflicts_with_all = ["file", "sheet", "bar", "backlash", "undo", "use_file"])]
    forget: bool,
    /// Turn the base straight ahead and send the arm its calibrated angles (state 9, mode 3): its own zeros and
    /// limits are right until it is switched off
    #[arg(long, conflicts_with_all = ["file", "sheet", "bar", "backlash", "undo", "use_file", "forget"])]
    angles: bool,
    /// Touch the paper at three or more points, wherever it lies; drawings and the policy's table follow it
    #[arg(long, conflicts_with_all = ["sheet", "bar", "backlash", "undo", "use_file", "forget", "angles", "comb", "test"])]
    touch_paper: bool,
    /// Write a picture of the error of each touch when the result is saved, an SVG file
    #[arg(long, value_name = "OUT.svg", value_parser = values::svg_file, conflicts_with_all = ["sheet", "undo", "use_file", "forget", "angles", "comb", "test", "touch_paper"])]
    picture: Option<PathBuf>,
    #[command(flatten)]
    pad: PadArgs,
    #[command(flatten)]
    to: To,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    if let Some(file) = &args.sheet {
        return write_sheet(file);
    }
    if args.forget {
        let forget = async |station: &mut StationClient| apply(station, None).await;
        return args.to.with_arm("calibrate", forget).await;
    }
    if let Some(times) = args.test {
        let run_test =
            async |station: &mut StationClient| test::test(station, &args.to, times).await;
        return args.to.with_arm("calibrate", run_test).await;
    }
    if args.angles {
        let send = async |station: &mut StationClient| send_angles(station, &args.to).await;
        return args.to.with_arm("calibrate", send).await;
    }
    let file = args.file.as_deref().expect("clap asks for one");
    if args.use_file {
        let known = read(file)?;
        let apply_file = async |station: &mut StationClient| apply(station, Some(known)).await;
        return args.to.with_arm("calibrate", apply_file).await;
    }
    if let Some(of) = args.comb {
        let known = read(file)?;
        let comb = async |station: &mut StationClient| {
            measure_backlash(station, &args.to, file, known, of).await
        };
        return args.to.with_arm("calibrate", comb).await;
    }
    if args.undo {
        return restore_previous(file);
    }
    check_terminal(
        "`dobot calibrate`",
        "run it in a terminal; a person must see where the tip is",
    )?;
    if args.bar.is_none() && !args.touch_paper {
        ask_for_bar().await?;
    }
    let before = known(file)?;
    let touch = async |station: &mut StationClient| {
        let file = file.to_owned();
        let before = before.clone();
        let status = if args.touch_paper {
            apply_for_paper(station, before.as_ref()).await?;
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
        // A saved calibration applies to this arm from now on.
        if let Some(kept) = known(&file)?.filter(|kept| before.as_ref() != Some(kept)) {
            apply(station, Some(kept)).await?;
        }
        Ok(status)
    };
    let status = args.to.with_arm("calibrate", touch).await?;
    Ok(output::status(&status, false)?)
}

/// Writes a sheet: each time another one, so that its bar has to be measured.
fn write_sheet(file: &Path) -> Result<(), Failure> {
    let since_1970 = SystemTime::now().duration_since(UNIX_EPOCH);
    let sheet = Sheet::chosen_by(since_1970.unwrap_or_default().as_secs());
    fs::write(file, sheet.svg()).with_context(|| format!("cannot write {}", file.display()))?;
    Ok(output::line(&format!(
        "{}: sheet {}; print it at 100 %, and measure its bar",
        file.display(),
        sheet.number()
    ))?)
}

/// Asks for the number of the sheet and the length of its bar, until the print has its true size.
async fn ask_for_bar() -> Result<(), Failure> {
    output::line(
        "Number of the printed sheet, and the length of its bar, measured with a ruler, in mm, as in 417:173.5?",
    )?;
    loop {
        let Some(line) = control::line_entered().await else {
            return Err(anyhow!("nothing was entered").into());
        };
        match bar(line.trim()) {
            Ok(()) => return Ok(()),
            Err(why) => output::line(&format!("{why}"))?,
        }
    }
}

/// Applies a calibration to the arm, or none.
async fn apply(
    station: &mut StationClient,
    calibration: Option<CalibrationFile>,
) -> Result<(), Failure> {
    let calibration = calibration.map(Box::new);
    let text = match &calibration {
        Some(known) => {
            let Zeros { base, rear, fore } = known.zeros;
            let name = known.name.as_deref().unwrap_or("the arm");
            format!(
                "{name} is calibrated: all positions are calibrated positions (zeros: base {base:.2}, rear {rear:.2}, fore {fore:.2} degrees)"
            )
        }
        None => "not calibrated; nominal dimensions are used".to_owned(),
    };
    station
        .request_at_rest(Request::Calibrate { calibration })
        .await?;
    Ok(output::line(&text)?)
}

/// Applies the known calibration, so that the paper is touched at calibrated positions.
async fn apply_for_paper(
    station: &mut StationClient,
    known: Option<&CalibrationFile>,
) -> Result<(), Failure> {
    if let Some(known) = known {
        return apply(station, Some(known.clone())).await;
    }
    let (arm, _) = control::arm(station).await?;
    if arm.raw.is_some() {
        return Err(Failure::new(
            anyhow!("the arm is calibrated, but its calibration file does not exist"),
            "name the file of its calibration, or discard it: `dobot calibrate --forget`",
        ));
    }
    Ok(())
}

/// Turns the base straight ahead, and sends the arm its calibrated angles.
async fn send_angles(station: &mut StationClient, to: &To) -> Result<(), Failure> {
    check_pose(station, to.pose_confirmed).await?;
    take_control(station).await?;
    let (arm, _) = control::arm(station).await?;
    check_calibrated(&arm)?;
    let Status {
        rear_deg,
        fore_deg,
        servo_deg,
        ..
    } = arm.status;
    // Approach from the right, so that the backlash is on the same side as during the touches.
    for base_deg in [-RUN_UP_DEG, 0.0] {
        let turned = MoveJoints::to([base_deg, rear_deg, fore_deg, servo_deg]);
        run_command(station, turned.with_mode(MovingMode::MovJ).into()).await?;
    }
    station.request_at_rest(Request::SetAngles).await?;
    control::wait_for_rest(station).await?;
    Ok(output::line(
        "the arm has its calibrated angles until it is switched off; look at it, then run `dobot confirm`",
    )?)
}

fn check_calibrated(arm: &ArmView) -> Result<(), Failure> {
    if arm.raw.is_some() {
        return Ok(());
    }
    Err(Failure::new(
        anyhow!("the arm is not calibrated, so that its calibrated angles are unknown"),
        "calibrate it with `dobot calibrate ARM.toml`",
    ))
}

/// Reads a calibration from a file that must exist.
pub(crate) fn read(file: &Path) -> Result<CalibrationFile, Failure> {
    known(file)?.ok_or_else(|| {
        Failure::new(
            anyhow!("{} does not exist", file.display()),
            "create it with `dobot calibrate`",
        )
    })
}

/// Reads a calibration; `None` if the file does not exist.
fn known(file: &Path) -> Result<Option<CalibrationFile>, Failure> {
    let text = match bounded::settings(file) {
        Ok(text) => text,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => {
            let read = Err(error);
            return Ok(read.with_context(|| format!("cannot read {}", file.display()))?);
        }
    };
    let known = read_calibration(&text).with_context(|| file.display().to_string())?;
    Ok(Some(named(known, file)))
}

/// Names an arm after its file, unless the file contains a name.
fn named(known: CalibrationFile, file: &Path) -> CalibrationFile {
    let stem = file
        .file_stem()
        .map(|stem| stem.to_string_lossy().into_owned());
    CalibrationFile {
        name: known.name.or(stem),
        ..known
    }
}

/// Saves a calibration, and keeps the previous one beside it.
fn save(file: &Path, known: &CalibrationFile) -> Result<(), Failure> {
    let before = before(file);
    fs::copy(file, &before).with_context(|| format!("cannot write {}", before.display()))?;
    let text = write_calibration(known);
    Ok(fs::write(file, text).with_context(|| format!("cannot write {}", file.display()))?)
}

/// Swaps a calibration with the previous one.
fn restore_previous(file: &Path) -> Result<(), Failure> {
    let before = before(file);
    let Some(known) = known(&before)? else {
        let error = anyhow!("{} does not exist", before.display());
        return Err(Failure::new(
            error,
            "leave out `--undo`; no calibration was replaced yet",
        ));
    };
    let replaced = fs::read(file).with_context(|| format!("cannot read {}", file.display()))?;
    fs::rename(&before, file).with_context(|| format!("cannot write {}", file.display()))?;
    fs::write(&before, replaced).with_context(|| format!("cannot write {}", before.display()))?;
    output::line(&format!("restored {}:", file.display()))?;
    Ok(output::line(write_calibration(&known).trim_end())?)
}

/// The file of the previous calibration.
fn before(file: &Path) -> PathBuf {
    let mut name = OsString::from(file);
    name.push(".before");
    name.into()
}

/// Checks the number of a sheet and the measured length of its bar.
fn bar(text: &str) -> anyhow::Result<()> {
    let Some((number, measured_mm)) = text.split_once(':') else {
        bail!(BarError::NotMeasured);
    };
    let numbers = number
        .trim()
        .parse()
        .ok()
        .zip(measured_mm.trim().parse().ok());
    let (number, measured_mm) = numbers.context(
        "expected the number of the sheet and the length of its bar in mm, as in 417:173.5",
    )?;
    Ok(Sheet::numbered(number)?.check_bar(measured_mm)?)
}

fn backlash(text: &str) -> anyhow::Result<[f64; 3]> {
    let numbers: Option<Vec<f64>> = text
        .split(',')
        .map(|number| number.trim().parse().ok())
        .collect();
    match numbers.as_deref() {
        Some(&[base, rear, fore])
            if [base, rear, fore]
                .iter()
                .all(|deg| (0.0..=5.0).contains(deg)) =>
        {
            Ok([base, rear, fore])
        }
        _ => bail!("expected three angles from 0 to 5 degrees, as in 0.25,0.2,0.2"),
    }
}

/// The distance of the approach: more than the backlash of any joint.
const RUN_UP_DEG: f32 = 6.0;
