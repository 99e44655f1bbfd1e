//! Which options fit which source: one that would do nothing is refused.

use anyhow::anyhow;

use super::args::Args;
use crate::failure::Failure;

/// What kind of thing is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A file of lines and areas.
    Lines,
    Picture,
    Text,
    Card,
}

/// Refuses the first option that would do nothing for this source, of this title.
pub(super) fn check(args: &Args, kind: Kind, title: &str) -> Result<(), Failure> {
    let misfit = options(args)
        .into_iter()
        .find(|(_, given, fit)| *given && !fit.kinds().contains(&kind));
    let Some((option, _, fit)) = misfit else {
        return Ok(());
    };
    let is = match kind {
        Kind::Lines => format!("{title} is a file of lines"),
        Kind::Picture => format!("{title} is a picture"),
        Kind::Text => "this is a text".to_owned(),
        Kind::Card => "this is a test card".to_owned(),
    };
    Err(anyhow!("{option} is for {}, and {is}", fit.told()).into())
}

/// What an option is for.
#[derive(Clone, Copy)]
enum Fit {
    Pictures,
    Texts,
    Cards,
    Areas,
    Layers,
    Drawings,
}

impl Fit {
    const fn kinds(self) -> &'static [Kind] {
        match self {
            Self::Pictures => &[Kind::Picture],
            Self::Texts => &[Kind::Text],
            Self::Cards => &[Kind::Card],
            Self::Areas => &[Kind::Lines, Kind::Text],
            Self::Layers => &[Kind::Lines],
            Self::Drawings => &[Kind::Lines, Kind::Picture, Kind::Text],
        }
    }

    const fn told(self) -> &'static str {
        match self {
            Self::Pictures => "PNG and JPEG pictures",
            Self::Texts => "the letters of --text",
            Self::Cards => "the test card of --card",
            Self::Areas => "the areas of drawings and texts (`--shade hatch` is for pictures)",
            Self::Layers => "the layers of drawings",
            Self::Drawings => "drawings, pictures and texts",
        }
    }
}

/// Each option, whether it was given, and what it is for. What a material sets is no option.
fn options(args: &Args) -> [(&'static str, bool, Fit); 16] {
    let Args {
        what, place, tool, ..
    } = args;
    [
        ("--shade", what.shade.is_some(), Fit::Pictures),
        ("--spacing", what.spacing.is_some(), Fit::Pictures),
        ("--invert", what.invert, Fit::Pictures),
        ("--font", what.font.is_some(), Fit::Texts),
        ("--height", what.height.is_some(), Fit::Texts),
        ("--align", what.align.is_some(), Fit::Texts),
        ("--card-passes", what.card_passes.is_some(), Fit::Cards),
        ("--hatch", what.hatch.is_some(), Fit::Areas),
        ("--layers", what.layers.is_some(), Fit::Layers),
        ("--fit", place.fit, Fit::Drawings),
        ("--scale", place.scale.is_some(), Fit::Drawings),
        ("--rotate", place.rotate != 0.0, Fit::Drawings),
        ("--margin", place.margin != 0.0, Fit::Drawings),
        ("--clip", place.clip, Fit::Drawings),
        ("--speed", tool.speed.is_some(), Fit::Drawings),
        ("--passes", tool.passes.is_some(), Fit::Drawings),
    ]
}
