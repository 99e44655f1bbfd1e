//! The `LightBurn` project reader: XML, older (`.lbrn`) and newer (`.lbrn2`).
//!
//! The format is unpublished; this reader is based on files and other readers.

mod cut;
mod field;
mod fill;
mod list;
mod path;
mod renderer;
mod shapes;

use usvg::roxmltree::Document;

use self::cut::Cuts;
use self::renderer::ShapeRenderer;
use crate::artwork::Artwork;
use crate::error::SourceError;
use crate::options::ReadOptions;
use crate::sketch::{REST_LEFT_OUT, Sketch, Y};
use crate::warning::Warning;
use crate::xml;

/// Reads a project: its layers are layers, in the order in which `LightBurn` runs them, and its
/// fills are areas. The page is as large as the ink, in the orientation of `LightBurn`.
pub(crate) fn read(
    text: &str,
    options: &ReadOptions,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    let mut sketch = Sketch::new(text.as_bytes(), options)?;
    let mut part = String::new();
    // Half a shape would be another one.
    let read = xml::tree_before_error(text, false, 1, &mut part)?;
    sketch.skip_mistake(read.error.map_or(Ok(()), Err), REST_LEFT_OUT)?;
    draw(read.text, &read.document, sketch)
}

/// Draws a project; places in its text are those in the file.
fn draw(
    text: &str,
    document: &Document<'_>,
    mut sketch: Sketch<'_>,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    let root = document.root_element();
    if !root.has_tag_name(ROOT) {
        let found = format!("<{}>", root.tag_name().name());
        return Err(sketch.found(root.range().start, found, "<LightBurnProject"));
    }
    let cuts = Cuts::read(text, root, &mut sketch)?;
    let mut renderer = ShapeRenderer::new(text, &mut sketch, root, cuts);
    renderer.all(root)?;
    renderer.finish()?;
    let is_mirrored = root.attribute("MirrorY") == Some(TRUE);
    let y = if is_mirrored { Y::Down } else { Y::Up };
    sketch.finish(y, "no shapes that are output")
}

/// Whether a file with this start is a `LightBurn` project, whatever its name is.
pub(crate) fn is_certain(start: &[u8]) -> bool {
    let mark = b"<LightBurnProject";
    start.windows(mark.len()).any(|window| window == mark)
}

const ROOT: &str = "LightBurnProject";
/// The value of a mirrored axis.
const TRUE: &str = "True";

#[cfg(test)]
mod tests;
