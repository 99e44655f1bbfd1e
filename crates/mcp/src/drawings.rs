//! Drawings: planned, shown as pictures, drawn.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use dobot_api::{CalibrationFile, NewJob, Problem, Request};
use dobot_draw::{
    AREA, CancelToken, Colors, DrawingRequest, InkLine, Materials, Options, Picture, Prepared,
    Settings, Subject, View,
};
use dobot_host::{PlannedFor, StationClient, drawing_job, run_long};
use dobot_wire::Dialect;
use rmcp::model::{CallToolResult, ContentBlock};
use serde_json::{Value, json};

use crate::arguments::{NewDrawing, PlannedDrawing};
use crate::call::{Call, no_arm, wait};
use crate::consent::short;
use crate::refused::Refused;

/// The latest planned drawings.
#[derive(Debug, Default)]
pub(crate) struct Drawings(Mutex<Kept>);

#[derive(Debug, Default)]
struct Kept {
    last: u64,
    drawings: BTreeMap<u64, Arc<Drawing>>,
}

/// A planned drawing, and the arm it is planned for.
#[derive(Debug)]
struct Drawing {
    job: NewJob,
    burns: bool,
    dialect: Option<Dialect>,
    calibration: Option<CalibrationFile>,
}

impl Drawings {
    fn keep(&self, drawing: Drawing) -> u64 {
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        kept.last += 1;
        let number = kept.last;
        kept.drawings.insert(number, Arc::new(drawing));
        if kept.drawings.len() > MAX_DRAWINGS {
            kept.drawings.pop_first();
        }
        number
    }

    fn find(&self, number: u64) -> Result<Arc<Drawing>, Refused> {
        let kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let found = kept.drawings.get(&number).cloned();
        found.ok_or_else(|| {
            Refused::new("no-such-drawing", format!("there is no drawing {number}")).hinted(
                format!("plan it with `plan_drawing`; the latest {MAX_DRAWINGS} are kept"),
            )
        })
    }
}

impl Call {
    /// Plans a drawing for the arm of the station, and returns a picture.
    pub(crate) async fn plan_drawing(&self, new: NewDrawing) -> Result<CallToolResult, Refused> {
        let mut station = self.connect().await?;
        let arm = self.planned_for(&mut station).await?;
        let request = self.request(new).await?;
        let cancel = CancelToken::default();
        let _cancel_on_drop = CancelOnDrop(cancel.clone());
        let planning = run_long(move || plan(request.until(cancel), &arm));
        let planned = tokio::time::timeout(LONGEST_PLAN, planning).await;
        let planned = planned.map_err(|_| {
            let most_s = LONGEST_PLAN.as_secs();
            bad(&format!(
                "planning did not finish within {most_s} s, the maximum"
            ))
            .hinted("draw it in parts, or allow a larger tolerance")
        })?;
        let Planned {
            drawing,
            mut figures,
            png,
        } = planned??;
        figures["drawing"] = self.shared.drawings.keep(drawing).into();
        let mut result = CallToolResult::structured(figures);
        let png = data_encoding::BASE64.encode(&png);
        result.content.push(ContentBlock::image(png, "image/png"));
        Ok(result)
    }

    /// Queues a planned drawing, and starts it or leaves that to a person.
    pub(crate) async fn draw(&self, asked: &PlannedDrawing) -> Result<Value, Refused> {
        let time = wait(asked.wait_s)?;
        let drawing = self.shared.drawings.find(asked.drawing)?;
        if drawing.burns {
            return Err(Refused::new("laser", "the drawing is for the laser, which agents may not use")
                .hinted("a person at the arm can draw it, wearing goggles: `dobot draw FILE --laser MATERIAL --arm-laser SECONDS`"));
        }
        let mut station = self.connect().await?;
        let arm = self.planned_for(&mut station).await?;
        if arm.dialect != drawing.dialect || arm.calibration != drawing.calibration {
            return Err(Refused::new(
                "drawing-phase",
                "the drawing was planned for another arm, or the arm was calibrated since",
            )
            .hinted("plan it again with `plan_drawing`"));
        }
        let what = format!("draw \"{}\"", short(&drawing.job.title));
        let may_start = self.may_start(&station, &what).await?;
        if may_start {
            // Nothing is queued that cannot be started.
            station.request(Request::TakeLease).await?;
        }
        let job = station.submit(drawing.job.clone()).await?;
        self.start_new(&mut station, job, time, may_start).await
    }

    async fn planned_for(&self, station: &mut StationClient) -> Result<PlannedFor, Refused> {
        let arm = station.planned_for(&self.state().await?).await?;
        if arm.status.is_none() {
            return Err(no_arm());
        }
        Ok(arm)
    }

    async fn request(&self, new: NewDrawing) -> Result<DrawingRequest, Refused> {
        let mut options = new.options;
        let given = [&new.text, &new.svg, &new.file];
        let given = given.into_iter().flatten().count();
        if given + usize::from(Subject::of_text(&options.what).is_some()) != 1 {
            return Err(Refused::new(
                "invalid",
                "give one of `text`, `svg` and `file`, or a text or a card in the options",
            ));
        }
        if new.text.is_some() {
            options.what.text = new.text;
        }
        let file = match (new.svg, new.file) {
            (Some(svg), _) => Some(("drawing.svg".to_owned(), svg.into_bytes())),
            (None, Some(file)) => Some(self.file(file).await?),
            (None, None) => None,
        };
        let reading = run_long(move || {
            let subject = subject(&options, file)?;
            let request = DrawingRequest::new(options, subject, &Materials::built_in());
            request.map_err(|error| bad(&error))
        });
        reading.await?
    }
}

/// Returns what to draw: a text or a card of the options, or a file with its name.
fn subject(options: &Options, file: Option<(String, Vec<u8>)>) -> Result<Subject, Refused> {
    match (Subject::of_text(&options.what), file) {
        (Some(text), _) => Ok(text),
        (None, Some((name, bytes))) => Subject::of_file(&name, bytes).map_err(|error| bad(&error)),
        (None, None) => Err(bad(&"there is nothing to draw")),
    }
}

struct Planned {
    drawing: Drawing,
    figures: Value,
    png: Vec<u8>,
}

fn plan(request: DrawingRequest, arm: &PlannedFor) -> Result<Planned, Refused> {
    let title = request.title.clone();
    let standing_z_mm = arm.status.ok_or_else(no_arm)?.z_mm.into();
    let (prepared, settings) = request
        .calibrated(arm.calibration.clone())
        .prepare(arm.dialect, standing_z_mm)
        .map_err(|error| bad(&error))?;
    let png = picture(&title, &prepared, &settings)?;
    let Prepared {
        plan,
        warnings,
        scale,
        ..
    } = &prepared;
    let job = drawing_job(plan, &title);
    let summary = plan.summary();
    let warnings: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    let pauses: Vec<&str> = job
        .pauses
        .iter()
        .map(|pause| pause.message.as_str())
        .collect();
    let refused = arm
        .refuses(&job)
        .map(|refuse| Refused::from(Problem::from(&refuse)));
    let figures = json!({
        "title": title,
        "duration_s": summary.duration_s,
        "strokes": summary.strokes,
        "vectors": summary.vectors,
        "drawn_mm": summary.drawn_mm,
        "scale": scale,
        "burns": plan.burns(),
        "warnings": warnings,
        "pauses": pauses,
        "refused": refused,
    });
    let drawing = Drawing {
        burns: plan.burns(),
        job,
        dialect: arm.dialect,
        calibration: arm.calibration.clone(),
    };
    Ok(Planned {
        drawing,
        figures,
        png,
    })
}

/// Draws the paper as seen from above by a person behind the arm.
fn picture(title: &str, prepared: &Prepared, settings: &Settings) -> Result<Vec<u8>, Refused> {
    let ink = InkLine::measured(prepared.planned(), &prepared.wanted());
    let picture = Picture {
        title,
        figures: &[],
        passes: &[],
        area: AREA,
        sheet: settings.placement.sheet,
        plan: &prepared.plan,
        drawn: &ink,
        colors: Colors::Passes,
        view: View::Paper,
    };
    picture.to_png(WIDTH_PX).map_err(|error| bad(&error))
}

fn bad(why: &dyn std::fmt::Display) -> Refused {
    Refused::new("bad-drawing", why.to_string())
}

/// Cancels a plan when its call ends.
struct CancelOnDrop(CancelToken);

impl Drop for CancelOnDrop {
    fn drop(&mut self) {
        self.0.cancel();
    }
}

/// The number of drawings that are kept, as many as at a station.
const MAX_DRAWINGS: usize = 16;
const LONGEST_PLAN: Duration = Duration::from_secs(120);
const WIDTH_PX: u32 = 1000;
