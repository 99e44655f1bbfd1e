//! The ink of a shape: a line, a filled area, or nothing.

use dobot_geometry::FillRule;

/// Red, green and blue; `None` for a pattern.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct InkColor(pub(crate) Option<[u8; 3]>);

/// The paint of a shape, as far as it is opaque.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Ink {
    pub(crate) line: Option<LinePaint>,
    pub(crate) fill: Option<FillPaint>,
}

impl Ink {
    /// The colour of its outline; `None` without one: white fills count as paper.
    pub(crate) fn outline(&self) -> Option<InkColor> {
        let line = self.line.as_ref().map(|line| line.color);
        line.or_else(|| self.area().map(|fill| fill.color))
    }

    /// The fill to be hatched.
    pub(crate) fn area(&self) -> Option<FillPaint> {
        self.fill.filter(|fill| fill.color.0 != Some(PAPER))
    }

    /// Whether it has a white fill only.
    pub(crate) fn is_paper(&self) -> bool {
        self.line.is_none() && self.fill.is_some() && self.area().is_none()
    }

    /// A line of length 0 is a dot if its caps are drawn, else nothing.
    pub(crate) fn has_ends(&self) -> bool {
        self.line.as_ref().is_some_and(|line| line.has_ends)
    }
}

/// A painted line.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LinePaint {
    pub(crate) color: InkColor,
    /// Its width in units of the shape; `None` for letters in the colour of a fill.
    pub(crate) width: Option<f64>,
    /// Whether its width is as given on the page, in pixels, however it is scaled.
    pub(crate) on_page: bool,
    /// Whether its caps are round or square.
    pub(crate) has_ends: bool,
    pub(crate) dashes: Option<Dashes>,
}

/// Alternating pen down and pen up.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Dashes {
    pub(crate) lengths: Vec<f64>,
    pub(crate) offset: f64,
    /// What their length is measured in.
    pub(crate) of: DashLength,
}

/// What the length of dashes is measured in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DashLength {
    /// The units of the line.
    Line,
    /// Pixels on the page, however the line is scaled.
    Page,
    /// The whole length of the path.
    Path,
}

/// A painted inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FillPaint {
    pub(crate) color: InkColor,
    pub(crate) rule: FillRule,
    /// Whether it is opaque.
    pub(crate) is_opaque: bool,
}

/// A miter limit, which no pen draws, as a mark of lines with non-scaling strokes: the library
/// exposes nothing else of them.
pub(super) const SCREEN_LINE: f32 = 9_876_543.0;
/// Another one, of lines whose dashes are fractions of their path.
pub(super) const PATH_DASHES: f32 = 9_876_544.0;
/// A third one, of lines with both.
pub(super) const SCREEN_PATH_DASHES: f32 = 9_876_545.0;
pub(super) const PAPER: [u8; 3] = [255; 3];
