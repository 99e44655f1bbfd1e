//! The DXF reader (the text format of `AutoCAD`, also written by other programs).
//!
//! It is our own because existing readers silently skip unknown entities, including hatches.

mod code_page;
mod content;
mod cover;
mod entity;
mod file;
mod fit;
mod hatch;
mod line_type;
mod mesh;
mod mline;
mod multileader;
mod named;
mod order;
mod pairs;
mod pattern;
mod plane;
mod renderer;
mod shapes;
mod spline;
mod text;
mod wide;
mod xclip;

use dobot_geometry::{Affine, Vec2};

use self::file::File;
use self::pairs::MAX_COORDINATE;
use self::renderer::EntityRenderer;
use crate::artwork::Artwork;
use crate::error::SourceError;
use crate::options::ReadOptions;
use crate::sketch::{Sketch, Y};
use crate::warning::Warning;

/// Reads a DXF file: its layers are layers, hatches and solids are areas. The page is as large as
/// the ink and upright (Y points up), in the units of the file.
///
/// A site plan may be hundreds of kilometres from its origin; a distant drawing is read relative to
/// its own position.
pub(crate) fn read(
    text: &[u8],
    options: &ReadOptions,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    let text = pairs::with_line_feeds(text);
    let (text, unknown_code_page) = code_page::in_utf8(&text);
    let mut file = File::read(&text, &options.cancel)?;
    if options.hides {
        // Nothing else depends on it.
        let sorted = order::sort(&mut file);
        sorted.or_else(|error| file.skip(error, "the order of the file remains"))?;
    }
    let code_page = unknown_code_page.as_deref();
    let draw = |from_mm, skips_far| draw(&file, options, code_page, from_mm, skips_far);
    let far_mm = match draw(Vec2::ZERO, false) {
        Err(SourceError::TooFar { x_mm, y_mm, .. }) if x_mm.hypot(y_mm) <= 2.0 * MAX_COORDINATE => {
            Vec2::new(x_mm, y_mm)
        }
        Err(SourceError::TooFar { .. }) => Vec2::ZERO,
        drawn => return drawn,
    };
    match draw(far_mm, false) {
        Err(SourceError::TooFar { .. }) => draw(Vec2::ZERO, true),
        drawn => drawn,
    }
}

/// Draws a file relative to a point, in mm. Objects that are too far from it are an error, or else
/// left out.
fn draw(
    file: &File<'_>,
    options: &ReadOptions,
    unknown_code_page: Option<&str>,
    from_mm: Vec2,
    skips_far: bool,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    let mut sketch = Sketch::new(file.text, options)?;
    for (mistake, instead) in &file.mistakes {
        sketch.skip_mistake(Err(mistake.clone()), instead)?;
    }
    if let Some(name) = unknown_code_page {
        let instead = format!("read as Windows-1252; its header names {name:?}");
        sketch.warn(None, "file in an unknown code page", &instead);
    }
    let unit_mm = file.unit_mm.unwrap_or_else(|| {
        let instead = if file.is_imperial {
            "taken for millimetres, although $MEASUREMENT 0 stands for inches; for inches, use place.scale 25.4"
        } else {
            "taken for millimetres"
        };
        sketch.warn(None, "file without a unit ($INSUNITS)", instead);
        1.0
    });
    let frame = Affine::translate(-from_mm) * Affine::scale(unit_mm);
    EntityRenderer::new(&mut sketch, file, skips_far).all(frame)?;
    sketch.finish(Y::Up, "no lines in the file")
}

/// A first section, or the mark of a binary file.
pub(crate) fn is_certain(start: &str) -> bool {
    let is_binary = start.starts_with("AutoCAD Binary DXF") || start.starts_with("AC10");
    is_binary || first_lines(start) == [Some("0"), Some("SECTION")]
}

/// A comment at the start.
pub(crate) fn is_likely(start: &str) -> bool {
    first_lines(start)[0] == Some("999")
}

fn first_lines(start: &str) -> [Option<&str>; 2] {
    let lines = start.split(['\r', '\n']).map(str::trim);
    let mut lines = lines.filter(|line| !line.is_empty());
    [lines.next(), lines.next()]
}

#[cfg(test)]
mod tests;
