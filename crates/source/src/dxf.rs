//! Reading DXF, the text format of `AutoCAD`, as other programs write it too.
//!
//! A reader of our own: those there are skip what they do not know in silence, hatches among it.

mod code_page;
mod content;
mod cover;
mod entity;
mod file;
mod hatch;
mod line_type;
mod mesh;
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

use self::file::File;
use self::renderer::EntityRenderer;
use crate::artwork::Artwork;
use crate::error::SourceError;
use crate::options::ReadOptions;
use crate::sketch::{Sketch, Y};
use crate::warning::Warning;

/// Reads a DXF file: its layers are layers, hatches and solids are areas. The page is as large as the
/// ink and upright (Y points up), in the units that the file tells.
pub(crate) fn read(
    text: &[u8],
    options: &ReadOptions,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    let (text, unknown_code_page) = code_page::in_utf8(text);
    let mut sketch = Sketch::new(&text, options)?;
    if let Some(name) = unknown_code_page {
        let instead = format!("its letters taken for western ones; its header tells {name:?}");
        sketch.warn(None, "file in an unknown code page", &instead);
    }
    let mut file = File::read(&text)?;
    if sketch.hides() {
        // Nothing else depends on it.
        order::sort(&mut file)?;
    }
    let unit_mm = file.unit_mm.unwrap_or_else(|| {
        let instead = "taken for millimetres";
        sketch.warn(None, "file without a unit ($INSUNITS)", instead);
        1.0
    });
    let mut renderer = EntityRenderer::new(&mut sketch, &file);
    renderer.all(unit_mm)?;
    sketch.finish(Y::Up, "no lines in the file")
}

#[cfg(test)]
mod tests;
