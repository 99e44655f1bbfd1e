//! Reading the projects of `LightBurn`: XML, older ones (`.lbrn`) and newer ones (`.lbrn2`).
//!
//! Nobody has published the format; this is what files and the readers of others tell.

mod cut;
mod field;
mod fill;
mod list;
mod palette;
mod path;
mod renderer;
mod shapes;

use self::cut::Cuts;
use self::renderer::ShapeRenderer;
use crate::artwork::Artwork;
use crate::error::SourceError;
use crate::options::ReadOptions;
use crate::sketch::{Sketch, Y};
use crate::warning::Warning;
use crate::xml;

/// Reads a project: its layers are layers, in the order in which `LightBurn` runs them, and what they fill is areas.
/// The page is as large as the ink, in the orientation that `LightBurn` shows.
pub(crate) fn read(
    text: &str,
    options: &ReadOptions,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    let mut sketch = Sketch::new(text.as_bytes(), options)?;
    let document = xml::tree(text, false)?;
    let root = document.root_element();
    if !root.has_tag_name(ROOT) {
        let found = format!("<{}>", root.tag_name().name());
        return Err(sketch.found(root.range().start, found, "<LightBurnProject"));
    }
    let cuts = Cuts::read(text, root)?;
    let mut renderer = ShapeRenderer::new(text, &mut sketch, root, cuts);
    renderer.all(root)?;
    renderer.finish()?;
    let is_mirrored = root.attribute("MirrorY") == Some(TRUE);
    let y = if is_mirrored { Y::Down } else { Y::Up };
    sketch.finish(y, "no shapes that are output")
}

/// Whether a file that begins so is a project of `LightBurn`, whatever its name says.
pub(crate) fn is_certain(start: &[u8]) -> bool {
    let mark = b"<LightBurnProject";
    start.windows(mark.len()).any(|window| window == mark)
}

const ROOT: &str = "LightBurnProject";
/// How a project says that an axis is mirrored.
const TRUE: &str = "True";

#[cfg(test)]
mod tests;
