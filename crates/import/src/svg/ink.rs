//! The ink of a shape: a line, a filled area, or nothing.

use dobot_geometry::FillRule;

/// Red, green and blue; `None` where a pattern has no one colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct InkColor(pub(crate) Option<[u8; 3]>);

/// How a shape is painted, as far as it is opaque at all.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Ink {
    pub(crate) line: Option<LinePaint>,
    pub(crate) fill: Option<FillPaint>,
}

impl Ink {
    /// The colour of its outline; `None` where it has none: white fills are paper.
    pub(crate) fn outline(&self) -> Option<InkColor> {
        let line = self.line.as_ref().map(|line| line.color);
        line.or_else(|| self.area().map(|fill| fill.color))
    }

    /// The fill to be hatched.
    pub(crate) fn area(&self) -> Option<FillPaint> {
        self.fill.filter(|fill| fill.color.0 != Some(PAPER))
    }

    /// Whether all of it is white fill.
    pub(crate) fn is_paper(&self) -> bool {
        self.line.is_none() && self.fill.is_some() && self.area().is_none()
    }

    /// A line without length is a dot where its ends are drawn, and nothing where they are cut off.
    pub(crate) fn has_ends(&self) -> bool {
        self.line.as_ref().is_some_and(|line| line.has_ends)
    }
}

/// A painted line.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LinePaint {
    pub(crate) color: InkColor,
    /// Its ends are round or square.
    pub(crate) has_ends: bool,
    pub(crate) dashes: Option<Dashes>,
}

/// Pen down and pen up in turn.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Dashes {
    pub(crate) lengths: Vec<f64>,
    pub(crate) offset: f64,
    /// They are as long on the page as they are told, in pixels, however the line is scaled.
    pub(crate) on_page: bool,
}

/// A painted inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FillPaint {
    pub(crate) color: InkColor,
    pub(crate) rule: FillRule,
    /// Nothing shows through it.
    pub(crate) is_opaque: bool,
}

/// A limit of mitres, which no pen draws, that marks lines whose strokes do not scale: the library reads nothing else of them.
pub(super) const SCREEN_DASHES: f32 = 9_876_543.0;
pub(super) const PAPER: [u8; 3] = [255; 3];
