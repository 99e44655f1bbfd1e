//! Drawings, which are planned in the background, shown and converted to jobs.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use axum::body::Bytes;
use dobot_api::problem_kinds::{BAD_DRAWING, DRAWING_PHASE, NO_SUCH_DRAWING, TOO_MANY};
use dobot_api::{NewJob, Problem};
use dobot_arm::Tool;
use dobot_draw::{
    CancelToken, DrawingRequest, FrameShape, Materials, Options, OptionsError, Prepared, Subject,
    Timeline, WITHOUT_ARM_Z_MM, frame,
};
use dobot_host::{PlannedFor, drawing_job};
use dobot_supervisor::plain;
use dobot_wire::Command;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tokio::sync::{Semaphore, watch};
use tokio::task::AbortHandle;

use crate::http::exchange::responses::beside;
use crate::http::resources::sketch::Sketch;

/// A drawing to be planned: a file, the text in the options or both, or a test card.
#[derive(Clone, Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct NewDrawing {
    /// The name of the file; its extension determines the format.
    name: Option<String>,
    /// The contents of the file, in Base64 (RFC 4648).
    file: Option<String>,
    /// The number of a stored file, instead of a name and its contents; the options of its job are
    /// stored with it.
    #[serde(skip_serializing_if = "Option::is_none")]
    stored: Option<u64>,
    /// The content of the stored file, once it is read.
    #[serde(skip)]
    content: Option<Vec<u8>>,
    /// The options, as those of `dobot draw`.
    options: Options,
}

/// A drawing with the state of its plan.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub(crate) struct DrawingView {
    /// Its number.
    pub(crate) drawing: u64,
    /// Its title.
    title: String,
    /// The phase of its planning.
    phase: DrawingPhase,
    /// The reason why it cannot be planned.
    #[serde(skip_serializing_if = "Option::is_none")]
    problem: Option<Problem>,
    /// The plan.
    #[serde(skip_serializing_if = "Option::is_none")]
    plan: Option<DrawingPlan>,
}

/// The phase of a drawing's planning.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum DrawingPhase {
    /// Waits for other drawings.
    Waiting,
    /// Is being planned.
    Planning,
    /// Is planned.
    Planned,
    /// Cannot be planned.
    Failed,
}

/// The plan of a drawing.
#[derive(Clone, Debug, Serialize, JsonSchema)]
struct DrawingPlan {
    /// The scale relative to the size in the file.
    scale: f64,
    /// Whether a laser is used.
    burns: bool,
    /// Differences between the result and the file.
    warnings: Vec<String>,
    /// The pauses for a person, with their messages.
    pauses: Vec<String>,
    /// The reason why the arm may not draw it from its current position.
    #[serde(skip_serializing_if = "Option::is_none")]
    refused: Option<Problem>,
    /// The drawing over time, pass by pass and vector by vector.
    timeline: Timeline,
}

/// The part of a drawing that a job draws.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum DrawingPart {
    /// The whole drawing.
    #[default]
    Whole,
    /// Its outline, with the pen up or the laser off.
    Frame,
}

/// A pen, or a material for the laser.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub(crate) struct MaterialView {
    /// Its name.
    name: String,
    /// Its tool: `pen` or `laser`.
    tool: Tool,
}

/// All stored drawings.
#[derive(Debug)]
pub(crate) struct Drawings {
    kept: Mutex<Kept>,
    /// The number of free planning slots.
    slots: Arc<Semaphore>,
}

#[derive(Debug, Default)]
struct Kept {
    last: u64,
    drawings: BTreeMap<u64, Drawing>,
}

#[derive(Debug)]
struct Drawing {
    title: String,
    /// The stored file that it is made from, and its options.
    stored: Option<(u64, Options)>,
    cancel: CancelToken,
    progress: watch::Receiver<Progress>,
    work: AbortHandle,
}

/// The progress of a drawing's planning.
#[derive(Clone, Debug)]
enum Progress {
    Waiting,
    Planning,
    Planned(Arc<Planned>),
    Failed(Problem),
}

/// A plan, prepared for all requests.
#[derive(Debug)]
struct Planned {
    /// The view of the drawing as JSON: it is long, and serialised once.
    view: Bytes,
    whole: NewJob,
    frame: Result<NewJob, String>,
}

impl Planned {
    /// Returns the approximate memory size.
    fn bytes(&self) -> usize {
        let frame = self.frame.as_ref().map_or(0, |frame| frame.commands.len());
        self.view.len() + (self.whole.commands.len() + frame) * size_of::<Command>()
    }
}

impl Default for Drawings {
    fn default() -> Self {
        Self {
            kept: Mutex::default(),
            slots: Arc::new(Semaphore::new(AT_ONCE)),
        }
    }
}

impl Drawings {
    /// Starts to plan a drawing; returns its initial view.
    ///
    /// # Errors
    ///
    /// A problem if an option is out of range, or too many drawings are being planned.
    pub(crate) fn begin(
        &self,
        new: NewDrawing,
        planned_for: PlannedFor,
    ) -> Result<DrawingView, Problem> {
        new.check()?;
        let mut kept = self.kept();
        kept.make_room()?;
        kept.last += 1;
        let number = kept.last;
        let drawing = self.plan_in_task(number, new, planned_for);
        let view = drawing.view(number);
        kept.drawings.insert(number, drawing);
        Ok(view)
    }

    fn plan_in_task(&self, number: u64, new: NewDrawing, planned_for: PlannedFor) -> Drawing {
        let title = new.title();
        let stored = new.stored.map(|file| (file, new.options.clone()));
        let cancel = CancelToken::default();
        let (sender, progress) = watch::channel(Progress::Waiting);
        let work = Work {
            number,
            title: title.clone(),
            new,
            planned_for,
            cancel: cancel.clone(),
        };
        let work = tokio::spawn(work.run(self.slots.clone(), sender)).abort_handle();
        Drawing {
            title,
            stored,
            cancel,
            progress,
            work,
        }
    }

    /// Returns a drawing as JSON when its plan is done, or after a second at the latest.
    ///
    /// # Errors
    ///
    /// A problem if there is no drawing with this number.
    pub(crate) async fn view(&self, number: u64) -> Result<Bytes, Problem> {
        let mut progress = self.find(number, |drawing| drawing.progress.clone())?;
        let over = progress
            .wait_for(|progress| !matches!(progress, Progress::Waiting | Progress::Planning));
        // Returns the state at that time.
        drop(tokio::time::timeout(LONGEST_WAIT, over).await);
        self.find(number, |drawing| match &*drawing.progress.borrow() {
            Progress::Planned(planned) => planned.view.clone(),
            _ => json(&drawing.view(number)),
        })
    }

    /// Plans a drawing, and returns the job for all of it.
    ///
    /// # Errors
    ///
    /// A problem if it cannot be planned, or too many drawings are being planned.
    pub(crate) async fn plan(
        &self,
        new: NewDrawing,
        planned_for: PlannedFor,
    ) -> Result<NewJob, Problem> {
        let number = self.begin(new, planned_for)?.drawing;
        let mut progress = self.find(number, |drawing| drawing.progress.clone())?;
        let over = progress
            .wait_for(|progress| !matches!(progress, Progress::Waiting | Progress::Planning));
        // A deleted drawing is not found below.
        drop(over.await);
        let job = self.job(number, DrawingPart::Whole);
        // Only used here; its slot is needed.
        let _ = self.forget(number);
        job
    }

    /// Makes a small picture of a file, fitted to the paper; `None` if it has no lines.
    ///
    /// # Errors
    ///
    /// A problem if it cannot be drawn, or only in more than two minutes.
    pub(crate) async fn sketch(
        &self,
        name: String,
        content: Vec<u8>,
    ) -> Result<Option<Sketch>, Problem> {
        let slot = self.slots.clone().acquire_owned().await;
        let cancel = CancelToken::default();
        let until = cancel.clone();
        let sketching = beside(move || {
            // Held until planning has really ended.
            let _slot = slot;
            sketched(&name, content, until)
        });
        let sketched = tokio::time::timeout(LONGEST_PLAN, sketching).await;
        sketched.unwrap_or_else(|_| {
            cancel.cancel();
            Err(too_long())
        })?
    }

    /// Deletes a drawing; a running plan is cancelled.
    ///
    /// # Errors
    ///
    /// A problem if there is no drawing with this number.
    pub(crate) fn forget(&self, number: u64) -> Result<(), Problem> {
        let drawing = self.kept().drawings.remove(&number);
        drawing.map(drop).ok_or_else(|| none(number))
    }

    /// Returns the job for a part of a planned drawing.
    ///
    /// # Errors
    ///
    /// A problem if there is no drawing with this number, or no plan of it.
    pub(crate) fn job(&self, number: u64, part: DrawingPart) -> Result<NewJob, Problem> {
        let progress = self.find(number, |drawing| drawing.progress.borrow().clone())?;
        match (progress, part) {
            (Progress::Planned(planned), DrawingPart::Whole) => Ok(planned.whole.clone()),
            (Progress::Planned(planned), DrawingPart::Frame) => {
                let frame = planned.frame.clone();
                frame.map_err(|why| BAD_DRAWING.problem(format!("its frame: {why}")))
            }
            (Progress::Failed(problem), _) => Err(problem),
            (Progress::Waiting | Progress::Planning, _) => Err(DRAWING_PHASE.hinted(
                format!("drawing {number} is not planned yet"),
                format!("poll `/api/v1/drawings/{number}` until its phase is `planned`"),
            )),
        }
    }

    /// Returns the stored file that a drawing is made from, and its options.
    pub(crate) fn stored(&self, number: u64) -> Option<(u64, Options)> {
        self.find(number, |drawing| drawing.stored.clone()).ok()?
    }

    fn find<T>(&self, number: u64, of: impl FnOnce(&Drawing) -> T) -> Result<T, Problem> {
        let kept = self.kept();
        kept.drawings
            .get(&number)
            .map(of)
            .ok_or_else(|| none(number))
    }

    fn kept(&self) -> MutexGuard<'_, Kept> {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Kept {
    /// Deletes the oldest finished drawings beyond the maximum number or memory.
    fn make_room(&mut self) -> Result<(), Problem> {
        while self.drawings.len() >= MAX_DRAWINGS || self.bytes() > MAX_BYTES {
            let oldest = self.drawings.iter().find(|(_, drawing)| drawing.is_over());
            let oldest = oldest.map(|(&number, _)| number).ok_or_else(|| {
                TOO_MANY.hinted(
                    format!("{MAX_DRAWINGS} drawings are being planned, the maximum"),
                    "wait until some are planned, or cancel some",
                )
            })?;
            self.drawings.remove(&oldest);
        }
        Ok(())
    }

    /// Returns the approximate memory size of the plans.
    fn bytes(&self) -> usize {
        let plans = self.drawings.values().map(|drawing| &drawing.progress);
        plans
            .map(|progress| match &*progress.borrow() {
                Progress::Planned(planned) => planned.bytes(),
                _ => 0,
            })
            .sum()
    }
}

impl Drawing {
    fn is_over(&self) -> bool {
        !matches!(
            *self.progress.borrow(),
            Progress::Waiting | Progress::Planning
        )
    }

    /// Returns the view without the plan.
    fn view(&self, number: u64) -> DrawingView {
        let (phase, problem) = match &*self.progress.borrow() {
            Progress::Waiting => (DrawingPhase::Waiting, None),
            Progress::Planning => (DrawingPhase::Planning, None),
            Progress::Planned(_) => (DrawingPhase::Planned, None),
            Progress::Failed(problem) => (DrawingPhase::Failed, Some(problem.clone())),
        };
        DrawingView {
            drawing: number,
            title: self.title.clone(),
            phase,
            problem,
            plan: None,
        }
    }
}

impl Drop for Drawing {
    /// Cancels the plan when the drawing is deleted or the station ends.
    fn drop(&mut self) {
        self.cancel.cancel();
        self.work.abort();
    }
}

impl NewDrawing {
    /// Checks the options against their ranges and exclusions.
    ///
    /// # Errors
    ///
    /// A problem that names the field.
    pub(crate) fn check(&self) -> Result<(), Problem> {
        self.options.check_values().map_err(|why| bad(&why))
    }

    /// Returns its title, within the limits of a job's title.
    pub(crate) fn title(&self) -> String {
        let text = Subject::of_text(&self.options.what).map(|title| title.title);
        let title = self.name.clone().or(text).unwrap_or_default();
        let title = plain(title.trim(), MAX_LETTERS);
        if title.is_empty() {
            return "drawing".to_owned();
        }
        title
    }

    /// Returns the number of the stored file that is drawn.
    pub(crate) const fn stored(&self) -> Option<u64> {
        self.stored
    }

    /// Adds name and content of the stored file.
    ///
    /// # Errors
    ///
    /// A problem if the request has another file.
    pub(crate) fn read(&mut self, name: String, content: Vec<u8>) -> Result<(), Problem> {
        if self.name.is_some() || self.file.is_some() {
            return Err(BAD_DRAWING.problem("give either `stored`, or `name` and `file`"));
        }
        (self.name, self.content) = (Some(name), Some(content));
        Ok(())
    }

    fn subject(&mut self, title: &str) -> Result<Subject, Problem> {
        let file = match (self.content.take(), &self.file, self.stored) {
            (Some(content), ..) => Some(of_bytes(title, content)?),
            (None, Some(file), _) => Some(of_file(title, file)?),
            (None, None, Some(number)) => {
                return Err(BAD_DRAWING.problem(format!(
                    "stored file {number} belongs to another station; send `name` and `file`"
                )));
            }
            (None, None, None) => None,
        };
        match (file, Subject::of_text(&self.options.what)) {
            (Some(file), Some(text)) => Ok(file.and(text)),
            (Some(only), None) | (None, Some(only)) => Ok(only),
            (None, None) => Err(BAD_DRAWING.problem(
                "the request has neither `file` nor `options.what.text` nor `options.what.card`",
            )),
        }
    }
}

/// Decodes a file in Base64.
fn of_file(title: &str, file: &str) -> Result<Subject, Problem> {
    let bytes = data_encoding::BASE64.decode(file.as_bytes());
    let bytes = bytes.map_err(|why| BAD_DRAWING.problem(format!("the file in Base64: {why}")))?;
    of_bytes(title, bytes)
}

fn of_bytes(title: &str, bytes: Vec<u8>) -> Result<Subject, Problem> {
    Subject::of_file(title, bytes).map_err(|why| BAD_DRAWING.problem(why.to_string()))
}

/// A drawing that is being planned.
struct Work {
    number: u64,
    title: String,
    new: NewDrawing,
    planned_for: PlannedFor,
    cancel: CancelToken,
}

impl Work {
    async fn run(self, slots: Arc<Semaphore>, sender: watch::Sender<Progress>) {
        let slot = slots.acquire_owned().await;
        sender.send_replace(Progress::Planning);
        let cancel = self.cancel.clone();
        let planning = beside(move || {
            // Held until planning has really ended.
            let _slot = slot;
            self.planned()
        });
        let planned = tokio::time::timeout(LONGEST_PLAN, planning).await;
        let planned = planned.unwrap_or_else(|_| {
            cancel.cancel();
            Ok(Err(too_long()))
        });
        sender.send_replace(match planned.and_then(|planned| planned) {
            Ok(planned) => Progress::Planned(Arc::new(planned)),
            Err(problem) => Progress::Failed(problem),
        });
        // A plan may be large, and its client may never return.
        tokio::time::sleep(KEPT_FOR).await;
        delete_plan(&sender);
    }

    fn planned(mut self) -> Result<Planned, Problem> {
        let subject = self.new.subject(&self.title)?;
        let asked = DrawingRequest::new(self.new.options, subject, &Materials::built_in());
        let asked = asked.map_err(|why| bad(&why))?.until(self.cancel);
        let arm = self.planned_for;
        let standing_z_mm = arm
            .status
            .map_or(WITHOUT_ARM_Z_MM, |status| status.z_mm.into());
        let (prepared, settings) = asked
            .calibrated(arm.calibration.clone())
            .prepare(arm.dialect, standing_z_mm)
            .map_err(|why| bad(&why))?;
        let Prepared { plan, passes, .. } = &prepared;
        let whole = drawing_job(plan, &self.title);
        let around = frame(
            passes,
            &settings.paper,
            plan.arm_limits(),
            FrameShape::Rectangle,
        );
        let frame = around.map(|frame| drawing_job(&frame, &format!("frame of {}", self.title)));
        let view = DrawingView {
            drawing: self.number,
            title: self.title,
            phase: DrawingPhase::Planned,
            problem: None,
            plan: Some(DrawingPlan {
                scale: prepared.scale,
                burns: plan.burns(),
                warnings: prepared.warnings.iter().map(ToString::to_string).collect(),
                pauses: whole
                    .pauses
                    .iter()
                    .map(|pause| pause.message.clone())
                    .collect(),
                refused: arm.refuses(&whole).map(Problem::from),
                timeline: prepared.timeline(),
            }),
        };
        Ok(Planned {
            view: json(&view),
            whole,
            frame: frame.map_err(|why| why.to_string()),
        })
    }
}

fn delete_plan(sender: &watch::Sender<Progress>) {
    let kept_min = KEPT_FOR.as_secs() / 60;
    sender.send_if_modified(|progress| {
        let is_planned = matches!(progress, Progress::Planned(_));
        if is_planned {
            *progress = Progress::Failed(BAD_DRAWING.hinted(
                format!("its plan was deleted after {kept_min} minutes"),
                "plan it again",
            ));
        }
        is_planned
    });
}

fn sketched(name: &str, content: Vec<u8>, until: CancelToken) -> Result<Option<Sketch>, Problem> {
    let subject = of_bytes(name, content)?;
    let mut options = Options::default();
    options.place.fit = true;
    let asked = DrawingRequest::new(options, subject, &Materials::built_in());
    let asked = asked.map_err(|why| bad(&why))?.until(until);
    let (prepared, _) = asked
        .prepare(None, WITHOUT_ARM_Z_MM)
        .map_err(|why| bad(&why))?;
    Ok(Sketch::of_plan(&prepared.timeline().path))
}

fn too_long() -> Problem {
    let most_s = LONGEST_PLAN.as_secs();
    BAD_DRAWING.hinted(
        format!("planning did not finish within {most_s} s, the maximum"),
        "draw it in parts, or allow a larger tolerance",
    )
}

/// Returns the pens and materials for drawings.
pub(crate) fn materials() -> Vec<MaterialView> {
    let all = Materials::built_in();
    let view = |(name, material): (&str, &dobot_draw::Material)| MaterialView {
        name: name.to_owned(),
        tool: material.tool.tool(),
    };
    all.iter().map(view).collect()
}

pub(crate) fn bad(why: &OptionsError) -> Problem {
    match why.hint() {
        Some(hint) => BAD_DRAWING.hinted(why.to_string(), hint),
        None => BAD_DRAWING.problem(why.to_string()),
    }
}

fn none(number: u64) -> Problem {
    NO_SUCH_DRAWING.problem(format!("there is no drawing {number}"))
}

fn json(view: &DrawingView) -> Bytes {
    serde_json::to_vec(view)
        .expect("its keys are texts and its numbers are finite")
        .into()
}

/// The number of concurrent plans: one core of a small computer of four stays free for other work.
const AT_ONCE: usize = 2;
/// The maximum number of drawings.
const MAX_DRAWINGS: usize = 16;
/// The memory size of plans from which old ones are deleted: a million vectors and their preview
/// take a third of it.
const MAX_BYTES: usize = 512 << 20;
/// The lifetime of a plan.
const KEPT_FOR: Duration = Duration::from_secs(30 * 60);
const LONGEST_PLAN: Duration = Duration::from_secs(120);
const LONGEST_WAIT: Duration = Duration::from_secs(1);
const MAX_LETTERS: usize = 150;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_api::{JobKind, JobProgram};

    use super::*;

    /// A drawing with a preview of this length, whose memory is never touched.
    fn planned(view_bytes: usize) -> Drawing {
        let planned = Planned {
            view: vec![0; view_bytes].into(),
            whole: NewJob {
                title: String::new(),
                kind: JobKind::Drawing,
                commands: Vec::new(),
                lift_mm: 0.0,
                pauses: Vec::new(),
                program: JobProgram::default(),
            },
            frame: Err(String::new()),
        };
        Drawing {
            title: String::new(),
            stored: None,
            cancel: CancelToken::default(),
            progress: watch::channel(Progress::Planned(Arc::new(planned))).1,
            work: tokio::spawn(async {}).abort_handle(),
        }
    }

    #[tokio::test]
    async fn the_oldest_plans_are_deleted_first_if_they_use_too_much_memory() {
        let mut kept = Kept::default();
        for (number, megabytes) in [(1, 1), (2, 300), (3, 100), (4, 300)] {
            kept.drawings.insert(number, planned(megabytes << 20));
        }
        kept.make_room().unwrap();
        assert_eq!(kept.drawings.keys().copied().collect::<Vec<_>>(), [3, 4]);
        kept.make_room().unwrap();
        assert_eq!(kept.drawings.len(), 2, "the others stay");
    }
}
