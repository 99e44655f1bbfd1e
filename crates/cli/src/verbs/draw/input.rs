//! Input of a drawing: files, standard input, a text or a test card.

use std::fs::File;
use std::io::{self, ErrorKind};
use std::path::Path;

use anyhow::{Context, anyhow};

use dobot_draw::{DrawingRequest, Materials, Options, Subject};
use dobot_import::{Source, SourceError};

use super::args::Args;
use super::defaults::{fitted, located};
use crate::bounded;
use crate::failure::Failure;
use crate::verbs::calibrate;

/// Reads what is to be drawn, and drops defaults that do not fit it.
pub(super) fn drawing_request(args: Args) -> Result<(Args, DrawingRequest), Failure> {
    let args = with_font(args)?;
    let subject = subject(&args)?;
    let args = fitted(args, &subject)?;
    let materials = materials(args.materials.as_deref())?;
    let calibration = args.calibration.as_deref().map(calibrate::read);
    let asked = DrawingRequest::new(dated(&args.options.0), subject, &materials);
    let asked = asked.map_err(|error| located(&args, error))?;
    let asked = asked.calibrated(calibration.transpose()?);
    Ok((args, asked))
}

/// The files, and the text or the test card.
fn subject(args: &Args) -> Result<Subject, Failure> {
    let standard_inputs = args.files.iter().filter(|file| *file == Path::new("-"));
    if standard_inputs.count() > 1 {
        return Err(Failure::usage(anyhow!(
            "- is given more than once; there is only one standard input"
        ))
        .with_hint("write one of the drawings to a file"));
    }
    let files = args.files.iter().map(|file| of_file(file));
    let text = Subject::of_text(&args.options.0.what).map(Ok);
    let all = files.chain(text).reduce(|all, next| Ok(all?.and(next?)));
    all.expect("the options ask for one")
}

/// Replaces the name of a font file by its content.
fn with_font(mut args: Args) -> Result<Args, Failure> {
    let font = &mut args.options.0.what.font;
    let is_file = |name: &&String| name.to_ascii_lowercase().ends_with(".svg");
    if let Some(name) = font.as_ref().filter(is_file) {
        let hint = "name an SVG font, an installed font, or one that `dobot draw --help` lists";
        let bytes = read(Path::new(name)).map_err(|failure| failure.with_hint(hint))?;
        let text = String::from_utf8(bytes);
        let text = text.with_context(|| format!("{name} is not a text in UTF-8"))?;
        *font = Some(text);
    }
    Ok(args)
}

/// Puts the date on a test card unless it has a label.
fn dated(options: &Options) -> Options {
    let mut options = options.clone();
    let what = &mut options.what;
    if what.card.is_some() && what.card_label.is_none() {
        let name = options.tool.laser.as_deref().unwrap_or_default();
        let day = jiff::Zoned::now().date();
        what.card_label = Some(format!("{name} {day}"));
    }
    options
}

/// The built-in materials, and those of a file.
pub(crate) fn materials(file: Option<&Path>) -> Result<Materials, Failure> {
    let known = Materials::built_in();
    let Some(file) = file else {
        return Ok(known);
    };
    let text =
        bounded::settings(file).with_context(|| format!("cannot read {}", file.display()))?;
    let mine = Materials::from_toml(&text).with_context(|| file.display().to_string())?;
    Ok(known.with(mine))
}

fn of_file(file: &Path) -> Result<Subject, Failure> {
    let (path, name) = match file.file_name() {
        Some(name) if file != Path::new("-") => {
            (file.display().to_string(), name.to_string_lossy())
        }
        _ => (STANDARD_INPUT.to_owned(), STANDARD_INPUT.into()),
    };
    let bytes = read(file)?;
    if is_program(file) {
        let hint = format!("to run a program, use `dobot play {path}`");
        return Err(Failure::new(
            anyhow!("{path} is a program, not a drawing"),
            hint,
        ));
    }
    Subject::of_file(&name, bytes).map_err(|error| match error {
        // The error contains the name.
        SourceError::UnknownKind { .. } if path == name => error.into(),
        _ => anyhow::Error::from(error).context(path).into(),
    })
}

/// Whether a file is a program of `dobot play`, by its name.
fn is_program(file: &Path) -> bool {
    let extension = file.extension().and_then(|extension| extension.to_str());
    extension.is_some_and(|extension| ["toml", "play"].contains(&extension))
}

/// Reads a file, or standard input for `-`, up to the maximum size plus one byte.
fn read(file: &Path) -> Result<Vec<u8>, Failure> {
    if file == Path::new("-") {
        let read = bounded::bytes(io::stdin().lock(), Source::most_bytes);
        return Ok(read.context("cannot read standard input")?);
    }
    let read = File::open(file).and_then(|file| bounded::bytes(file, Source::most_bytes));
    read.map_err(|error| read_failure(file, error))
}

fn read_failure(file: &Path, error: io::Error) -> Failure {
    let missing = error.kind() == ErrorKind::NotFound;
    let error = anyhow::Error::from(error).context(format!("cannot read {}", file.display()));
    if missing {
        return Failure::new(
            error,
            "name a drawing; examples/drawings/ contains some of each kind",
        );
    }
    error.into()
}

const STANDARD_INPUT: &str = "standard input";
