//! Following a job to its end.

use std::io::IsTerminal;
use std::time::Duration;

use anyhow::anyhow;
use dobot_api::{JobPhase, JobView, ProgramView, RemoteError, Request, State, StationEvent};
use dobot_host::{JobWatch, StationClient};
use indicatif::{ProgressBar, ProgressStyle};

use crate::control::take_control;
use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::output::time_left;
use crate::questions::Questions;

/// Starts or resumes a job, and follows it to its end. The client must have control, which is released
/// while the job runs unless it burns, so that other clients can change its speed.
///
/// Ctrl-C pauses the job with the tool lifted and asks how to proceed. `see` is called with every state.
/// Returns the time that the arm worked on the job.
pub(crate) async fn start(
    station: &mut StationClient,
    job: u64,
    burns: bool,
    see: impl FnMut(&State),
) -> Result<Duration, Failure> {
    let bar = progress_bar(station);
    start_shown(station, job, burns, &bar, see).await
}

/// Starts or resumes a job like [`start`], with a given progress bar.
pub(crate) async fn start_shown(
    station: &mut StationClient,
    job: u64,
    burns: bool,
    bar: &ProgressBar,
    mut see: impl FnMut(&State),
) -> Result<Duration, Failure> {
    let mut is_confirmed = false;
    loop {
        begin(station, job, burns, is_confirmed).await?;
        let ended = follow(station, job, bar, &mut see).await?;
        if matches!(ended, End::Paused(_) | End::Interrupted) {
            // The arm finishes its in-flight commands and lifts the tool.
            station.idle().await?;
        }
        let why = match ended {
            End::Done => return took(station, job).await,
            End::Over(text) => return Err(anyhow!(text).into()),
            End::Paused(text) => text,
            End::Interrupted if burns => "interrupted; the laser is off".to_owned(),
            End::Interrupted => "interrupted; the tool is up".to_owned(),
        };
        ask_to_resume(station, (job, burns), &why).await?;
        is_confirmed = true;
    }
}

/// Starts or resumes a job, and keeps control only if it burns.
async fn begin(
    station: &mut StationClient,
    job: u64,
    burns: bool,
    is_confirmed: bool,
) -> Result<(), Failure> {
    take_control(station).await?;
    if is_confirmed {
        confirm(station, job).await?;
    }
    station.request_at_rest(Request::StartJob { job }).await?;
    if !burns {
        station.request(Request::ReleaseLease).await?;
    }
    Ok(())
}

/// Confirms that a person has done what a paused job waits for, if it waits. The client must have control.
pub(crate) async fn confirm(station: &mut StationClient, job: u64) -> Result<(), Failure> {
    if waits_for_person(station, job).await? {
        station.request(Request::ConfirmJob { job }).await?;
    }
    Ok(())
}

async fn waits_for_person(station: &mut StationClient, job: u64) -> Result<bool, Failure> {
    let jobs = station.jobs().await?;
    let mut jobs = jobs.iter();
    Ok(jobs.any(|one| one.job == job && one.waits_for_person))
}

/// Runs the next step of a job, and waits for the pause after it.
pub(crate) async fn step(station: &mut StationClient, job: u64) -> Result<(), Failure> {
    take_control(station).await?;
    station.request_at_rest(Request::StepJob { job }).await?;
    let bar = progress_bar(station);
    let ended = follow(station, job, &bar, |_| {}).await?;
    station.idle().await?;
    match ended {
        End::Over(text) => Err(anyhow!(text).into()),
        End::Done | End::Paused(_) | End::Interrupted => Ok(()),
    }
}

/// Formats the progress of a program: `cycle 12 of 40, 8.3 s each`.
pub(crate) fn place(program: &ProgramView) -> String {
    let step = format!(
        "step {} of {}",
        (program.step + 1).min(program.steps),
        program.steps
    );
    let cycle_s = program.mean_cycle_s.or(program.planned_cycle_s);
    let each = cycle_s.map_or_else(String::new, |cycle_s| format!(", {cycle_s:.1} s each"));
    let cycle = program.cycles_done + 1;
    match program.cycles {
        Some(1) => step,
        Some(cycles) => format!("cycle {} of {cycles}{each}, {step}", cycle.min(cycles)),
        None => format!("cycle {cycle}{each}, {step}"),
    }
}

/// Returns the time that the arm worked on a finished job, without pauses; after a crash, the time since
/// then.
async fn took(station: &mut StationClient, job: u64) -> Result<Duration, Failure> {
    let jobs = station.jobs().await?;
    let job = jobs.iter().find(|one| one.job == job);
    let took_s = job.and_then(|job| job.took_s).unwrap_or_default();
    Ok(Duration::try_from_secs_f64(took_s).unwrap_or_default())
}

/// Asks a person whether to resume a paused job, for example after a change of pen.
async fn ask_to_resume(
    station: &mut StationClient,
    (job, burns): (u64, bool),
    why: &str,
) -> Result<(), Failure> {
    let why = why
        .strip_prefix(&format!("job {job} is paused: "))
        .unwrap_or(why);
    let answer = match ask_person(job, why).await {
        // A virtual arm in this process is harmless, and nobody changes its pen.
        None if station.virtual_arm().is_some() => PausedChoice::Resume,
        answer => answer.unwrap_or(PausedChoice::Leave),
    };
    match answer {
        PausedChoice::Resume => Ok(()),
        PausedChoice::Cancel => {
            station.request(Request::CancelJob { job }).await?;
            Err(anyhow!("job {job} is cancelled").into())
        }
        PausedChoice::Leave => Err(paused(station, (job, burns), why).await?),
    }
}

/// The end of a run of a job.
#[derive(Clone, Debug, PartialEq)]
enum End {
    Done,
    /// Ended for good.
    Over(String),
    Paused(String),
    /// Paused by Ctrl-C.
    Interrupted,
}

/// The decision about a paused job.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum PausedChoice {
    Resume,
    Cancel,
    Leave,
}

/// Follows a job until it no longer runs.
async fn follow(
    station: &mut StationClient,
    job: u64,
    bar: &ProgressBar,
    mut see: impl FnMut(&State),
) -> Result<End, Failure> {
    bar.reset();
    // The time of a virtual arm in this process is not real time.
    let is_virtual = station.virtual_arm().is_some();
    let mut interrupt = std::pin::pin!(interrupt());
    let mut interrupted = false;
    let mut watch = JobWatch::new(job);
    let mut questions = Questions::of(job);
    loop {
        let event = tokio::select! {
            // Virtual time stands still while a person answers.
            event = station.next(), if !(is_virtual && questions.waits_for_line()) => event?,
            () = &mut interrupt, if !interrupted => {
                interrupted = true;
                pause(station).await?;
                continue;
            }
            line = questions.line() => {
                questions.answer(station, line, bar).await;
                continue;
            }
        };
        match event {
            StationEvent::State(state) => {
                if let Some(view) = state.job.as_ref().filter(|view| view.job == job) {
                    show(bar, view, is_virtual);
                    questions.handle(view.question.as_ref(), bar);
                    if is_virtual && let Some(failure) = questions.unanswerable() {
                        return Err(failure);
                    }
                }
                see(&state);
            }
            StationEvent::Notice(notice) => {
                let rests = watch.handle_notice(&notice);
                if let Some(end) = rests.map(|(phase, text)| end(phase, text, interrupted)) {
                    bar.finish_and_clear();
                    return Ok(end);
                }
            }
        }
    }
}

fn end(phase: JobPhase, text: String, interrupted: bool) -> End {
    match phase {
        JobPhase::Done => End::Done,
        JobPhase::Paused if interrupted => End::Interrupted,
        JobPhase::Paused => End::Paused(text),
        _ => End::Over(text),
    }
}

/// Pauses the running job; it may have just ended.
async fn pause(station: &mut StationClient) -> Result<(), RemoteError> {
    match station.request(Request::PauseJob).await {
        Err(RemoteError::Refused(_)) | Ok(_) => Ok(()),
        Err(error) => Err(error),
    }
}

/// Returns the end of a run that leaves its job paused.
async fn paused(
    station: &mut StationClient,
    (job, burns): (u64, bool),
    text: &str,
) -> Result<Failure, Failure> {
    let to = station.arm_address();
    let to = to.map_or_else(String::new, |address| format!(" --to {address}"));
    let laser = if burns { " --arm-laser SECONDS" } else { "" };
    let hint = format!(
        "resume it with `dobot jobs start {job}{to}{laser}`, or end it with `dobot jobs cancel {job}{to}`"
    );
    Ok(if waits_for_person(station, job).await? {
        Failure::waiting(job, anyhow!("{text}"), hint)
    } else {
        Failure::new(anyhow!("job {job} is paused: {text}"), hint)
    })
}

/// Asks the person at the terminal, if there is one.
async fn ask_person(job: u64, why: &str) -> Option<PausedChoice> {
    if !std::io::stdin().is_terminal() {
        return None;
    }
    eprintln!(
        "{why}\njob {job} is paused: press g and Enter to resume, c and Enter to cancel, Enter to leave it paused"
    );
    Some(tokio::select! {
        line = tokio::task::spawn_blocking(read_line) => {
            line.ok().map_or(PausedChoice::Leave, |line| answer(&line))
        }
        () = interrupt() => PausedChoice::Leave,
    })
}

fn read_line() -> String {
    let mut line = String::new();
    // An unreadable line is no answer.
    let _ = std::io::stdin().read_line(&mut line);
    line
}

fn answer(line: &str) -> PausedChoice {
    match line.trim() {
        "g" | "G" => PausedChoice::Resume,
        "c" | "C" => PausedChoice::Cancel,
        _ => PausedChoice::Leave,
    }
}

/// Creates the progress bar for a job of an arm.
pub(crate) fn progress_bar(station: &StationClient) -> ProgressBar {
    match station.virtual_arm() {
        Some(_) => share_bar(),
        None => ProgressBar::new(1)
            .with_style(style("{wide_bar:.cyan/dim} {pos}/{len} commands, {msg}")),
    }
}

/// Creates a progress bar in percent, for simulated work.
pub(crate) fn share_bar() -> ProgressBar {
    ProgressBar::new(1).with_style(share_style())
}

/// The style of a bar in percent, with the current task as its prefix.
pub(crate) fn share_style() -> ProgressStyle {
    style("{wide_bar:.cyan/dim} {prefix}{msg}")
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).expect("the template is well-formed")
}

fn show(bar: &ProgressBar, job: &JobView, is_virtual: bool) {
    bar.set_length(job.commands as u64);
    bar.set_position(job.completed as u64);
    let place = job.program.as_ref().map(place);
    let left = if is_virtual {
        let percent = 100 * job.completed / job.commands.max(1);
        Some(format!("{percent} %"))
    } else {
        job.left_s.map(|left_s| time_left(Some(left_s)))
    };
    let parts: Vec<String> = [place, left].into_iter().flatten().collect();
    bar.set_message(parts.join(", "));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_job_paused_by_the_person_is_distinguished_from_other_pauses() {
        let text = || "the arm was stopped".to_owned();
        let paused = |interrupted| end(JobPhase::Paused, text(), interrupted);
        assert_eq!(paused(true), End::Interrupted);
        assert_eq!(paused(false), End::Paused(text()));
        assert_eq!(end(JobPhase::Failed, text(), true), End::Over(text()));
    }

    #[test]
    fn only_clear_answers_move_the_arm_or_end_the_job() {
        assert_eq!(answer("g\n"), PausedChoice::Resume);
        assert_eq!(answer("c\n"), PausedChoice::Cancel);
        for line in ["", "\n", "go\n", "cancel?\n"] {
            assert_eq!(answer(line), PausedChoice::Leave, "{line:?}");
        }
    }
}
