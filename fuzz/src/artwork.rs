//! Drawings that were read.

use dobot_import::{Artwork, Format, ReadOptions, Source};

/// Reads a source: what comes back lies within the limits of a drawing.
pub(crate) fn read(source: &Source) -> Option<Artwork> {
    let (artwork, _) = source.read(&ReadOptions::default()).ok()?;
    assert!(artwork.points().next().is_some());
    // Twice as far as allowed from the origin: the page begins at the ink.
    lies_on(&artwork, [2e6, 2e6]);
    Some(artwork)
}

/// A file with this extension, whatever it holds.
pub(crate) fn file(extension: &str, bytes: impl Into<Vec<u8>>) -> Source {
    let format = Format::of_name(&format!("a.{extension}"));
    Source::File {
        format: format.expect("a format has this extension"),
        bytes: bytes.into(),
    }
}

/// The ink lies on a page of this width and height.
pub(crate) fn lies_on(artwork: &Artwork, [width_mm, height_mm]: [f64; 2]) {
    assert!(artwork.width_mm.is_finite() && artwork.height_mm.is_finite());
    // Half a percent beyond the edge is on a page.
    let slack_mm = ON_EDGE_MM + 0.005 * width_mm.min(height_mm);
    let within = |at: f64, most: f64| (-slack_mm..=most + slack_mm).contains(&at);
    for p in artwork.points() {
        let is_on = within(p.x, width_mm) && within(p.y, height_mm);
        assert!(
            is_on,
            "{p:?} is not on a page of {width_mm} x {height_mm} mm"
        );
    }
}

/// What lies that near to the edge of a page counts as on it.
const ON_EDGE_MM: f64 = 2e-3;
