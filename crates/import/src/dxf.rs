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
        order::sort(&mut file)?;
    }
    let code_page = unknown_code_page.as_deref();
    let (far, from_origin) = match draw(&file, options, code_page, Vec2::ZERO) {
        Err(error @ SourceError::TooFar { x_mm, y_mm, .. })
            if x_mm.hypot(y_mm) <= 2.0 * MAX_COORDINATE =>
        {
            (Vec2::new(x_mm, y_mm), error)
        }
        drawn => return drawn,
    };
    match draw(&file, options, code_page, far) {
        Err(from_there @ SourceError::TooFar { .. }) => Err(too_far(from_origin, &from_there)),
        drawn => drawn,
    }
}

/// Draws a file relative to a point, in mm.
fn draw(
    file: &File<'_>,
    options: &ReadOptions,
    unknown_code_page: Option<&str>,
    from_mm: Vec2,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    let mut sketch = Sketch::new(file.text, options)?;
    if let Some(name) = unknown_code_page {
        let instead = format!("read as Windows-1252; its header names {name:?}");
        sketch.warn(None, "file in an unknown code page", &instead);
    }
    let unit_mm = file.unit_mm.unwrap_or_else(|| {
        let instead = "taken for millimetres";
        sketch.warn(None, "file without a unit ($INSUNITS)", instead);
        1.0
    });
    let frame = Affine::translate(-from_mm) * Affine::scale(unit_mm);
    EntityRenderer::new(&mut sketch, file).all(frame)?;
    sketch.finish(Y::Up, "no lines in the file")
}

/// Refuses objects too far from the origin and from the rest of the drawing.
fn too_far(from_origin: SourceError, from_there: &SourceError) -> SourceError {
    let SourceError::TooFar {
        place,
        x_mm,
        y_mm,
        limit_mm,
    } = from_origin
    else {
        return from_origin;
    };
    match from_there {
        SourceError::TooFar { place: other, .. } if *other != place => SourceError::Found {
            place,
            found: format!("an object at ({x_mm:.0}, {y_mm:.0}) mm, far from that at {other}"),
            expected: format!(
                "all objects within {limit_mm:.0} mm; delete objects far away from the drawing"
            ),
        },
        _ => from_origin,
    }
}

/// Pairs of lines at the start: a section or a comment.
pub(crate) fn is_likely(start: &str) -> bool {
    let lines = start.split(['\r', '\n']).map(str::trim);
    let mut lines = lines.filter(|line| !line.is_empty());
    let first = (lines.next(), lines.next());
    let is_binary = start.starts_with("AutoCAD Binary DXF") || start.starts_with("AC10");
    is_binary || first == (Some("0"), Some("SECTION")) || first.0 == Some("999")
}

#[cfg(test)]
mod tests;
