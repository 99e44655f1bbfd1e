//! A log of estimated and actual durations of drawings, to judge the estimates.

use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::Path;

use anyhow::Context;
use jiff::Timestamp;
use serde::Serialize;

use super::report::Times;
use crate::failure::Failure;
use crate::reach::folders;

#[derive(Serialize)]
struct EstimateLine<'a> {
    at: Timestamp,
    title: &'a str,
    estimated_s: f64,
    took_s: f64,
    error_percent: f64,
}

/// Appends a line to `estimates.jsonl` in the data folder for a drawing that was estimated and made.
pub(super) fn log(title: &str, times: Times) -> Result<(), Failure> {
    let (Some(estimated), Some(took), Some(error_percent)) =
        (times.estimated, times.took, times.error_percent())
    else {
        return Ok(());
    };
    let line = EstimateLine {
        at: Timestamp::now(),
        title,
        estimated_s: estimated.as_secs_f64(),
        took_s: took.as_secs_f64(),
        error_percent,
    };
    let mut text = serde_json::to_string(&line)?;
    text.push('\n');
    let folder = folders(None)?;
    folder
        .make_data()
        .with_context(|| format!("cannot create {}", folder.data().display()))?;
    let file = folder.data().join("estimates.jsonl");
    append(&file, &text).with_context(|| format!("cannot write {}", file.display()))?;
    Ok(())
}

fn append(file: &Path, text: &str) -> io::Result<()> {
    let mut file = OpenOptions::new().create(true).append(true).open(file)?;
    file.write_all(text.as_bytes())
}
