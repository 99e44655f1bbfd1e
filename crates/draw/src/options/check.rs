//! Checks the options against the source and each other. An option without effect is refused.

use std::fmt;

use dobot_import::{Contents, Format, Shading, ShadingStyle, Source};

use super::fields::OPTION_RANGES;
use super::{Options, OptionsError, PlaceOptions};
use crate::prepare::NamedSource;

/// Refuses the first option without effect for these sources with a common title. Without a source
/// the test card is drawn.
pub(super) fn check(
    options: &Options,
    sources: &[NamedSource],
    title: &str,
) -> Result<(), OptionsError> {
    check_values(options)?;
    let kinds: Vec<SourceKind> = match sources {
        [] => vec![SourceKind::Card],
        all => all
            .iter()
            .map(|source| SourceKind::of(&source.source))
            .collect(),
    };
    if options.what.card.is_some() && !sources.is_empty() {
        return Err(OptionsError::Both {
            field: "what.card",
            other: "FILE",
        });
    }
    if matches!(kinds[..], [SourceKind::Text]) && options.what.height.is_some() {
        let place = &options.place;
        let sized = [
            ("place.fit", place.fit),
            ("place.scale", place.scale.is_some()),
        ];
        if let Some((other, _)) = sized.into_iter().find(|option| option.1) {
            return Err(OptionsError::Both {
                field: "what.height",
                other,
            });
        }
    }
    let apart = options.place.gap != PlaceOptions::default().gap;
    if apart && !has_gaps(&options.place) && matches!(kinds[..], [SourceKind::Text]) {
        return Err(OptionsError::Alone {
            field: "place.gap",
            needs: "place.grid, place.border, place.sign, or a file above the text",
        });
    }
    let misfit = given(options)
        .into_iter()
        .find(|(_, given, purpose)| *given && !kinds.iter().any(|kind| purpose.fits(*kind)));
    let Some((field, _, purpose)) = misfit else {
        return Ok(());
    };
    Err(OptionsError::Misfit {
        field,
        fits: purpose.to_string(),
        is: match kinds[..] {
            [SourceKind::File(format)] if format.is_picture() => format!("{title} is a picture"),
            [SourceKind::File(format)] => format!("{title} is in {} format", format.name),
            [SourceKind::Lines] => format!("{title} has lines"),
            [SourceKind::Text] => "this is a text".to_owned(),
            [SourceKind::Card] => "this is a test card".to_owned(),
            _ => "none of these is one".to_owned(),
        },
    })
}

/// Refuses the first option that is invalid for every drawing or conflicts with the others.
pub(super) fn check_values(options: &Options) -> Result<(), OptionsError> {
    counts(options)?;
    ranges(options)?;
    combinations(options)
}

/// Whether there are gaps between copies or inside marks.
const fn has_gaps(place: &PlaceOptions) -> bool {
    place.grid.is_some() || place.border || place.sign.is_some()
}

/// Checks that coordinates are finite and complete.
fn counts(options: &Options) -> Result<(), OptionsError> {
    let places = [
        ("place.at", &options.place.at, 2),
        ("place.corner", &options.place.corner, 2),
        ("place.paper", &options.place.paper, 9),
    ];
    for (field, numbers, allowed) in places {
        let found = numbers.as_ref().map_or(allowed, Vec::len);
        if found != allowed {
            return Err(OptionsError::Count {
                field,
                found,
                allowed,
            });
        }
        let mut numbers = numbers.iter().flatten();
        if let Some(&found) = numbers.find(|number| number.abs() > FARTHEST_MM || number.is_nan()) {
            return Err(OptionsError::NoPlace { field, found });
        }
    }
    Ok(())
}

/// Checks numbers against the ranges of arms and paper.
fn ranges(options: &Options) -> Result<(), OptionsError> {
    for range in &OPTION_RANGES {
        let is_refused = |found: &f64| !(range.least..=range.most).contains(found);
        if let Some(found) = (range.value)(options).filter(is_refused) {
            return Err(OptionsError::Range { found, range });
        }
    }
    Ok(())
}

/// Larger than any table.
const FARTHEST_MM: f64 = 10_000.0;

/// Two options and whether each is given.
type Pair = (&'static str, bool, &'static str, bool);

/// Refuses options that exclude each other, a layer named twice, and options that require another
/// one.
fn combinations(options: &Options) -> Result<(), OptionsError> {
    if let Some((field, _, other, _)) = exclusive(options).into_iter().find(|pair| pair.1 && pair.3)
    {
        return Err(OptionsError::Both { field, other });
    }
    let mut names: Vec<&str> = options
        .what
        .layer
        .iter()
        .map(|layer| layer.name.as_str())
        .collect();
    names.sort_unstable();
    if let Some(twice) = names.windows(2).find(|pair| pair[0] == pair[1]) {
        return Err(OptionsError::Twice(twice[0].to_owned()));
    }
    match dependent(options)
        .into_iter()
        .find(|pair| pair.1 && !pair.3)
    {
        Some((field, _, needs, _)) => Err(OptionsError::Alone { field, needs }),
        None => Ok(()),
    }
}

/// Returns the options that exclude each other.
fn exclusive(options: &Options) -> [Pair; 17] {
    let Options {
        what,
        place,
        tool,
        way,
    } = options;
    let defaults = Options::default();
    let by_pen = tool.pen != defaults.tool.pen;
    let by_laser = tool.laser.is_some();
    let tries = way.tries != defaults.way.tries;
    let touched = place.paper.is_some();
    let cornered = place.corner.is_some();
    let turned = what.hatch_angle != defaults.what.hatch_angle;
    let is_tsp = what.shade == Some(ShadingStyle::Tsp);
    let winds = what.hatch_style != defaults.what.hatch_style;
    [
        (
            "what.text",
            what.text.is_some(),
            "what.card",
            what.card.is_some(),
        ),
        ("place.fit", place.fit, "place.scale", place.scale.is_some()),
        (
            "place.pen_down",
            place.pen_down.is_some(),
            "place.paper",
            touched,
        ),
        ("place.corner", cornered, "place.at", place.at.is_some()),
        ("place.corner", cornered, "place.paper", touched),
        ("tool.pen", by_pen, "tool.laser", by_laser),
        ("way.keep_order", way.keep_order, "way.tries", tries),
        ("way.keep_order", way.keep_order, "what.shade tsp", is_tsp),
        ("tool.lift", tool.lift.is_some(), "tool.laser", by_laser),
        (
            "what.levels",
            what.levels.is_some(),
            "what.threshold",
            what.threshold.is_some(),
        ),
        (
            "what.hatch_angle",
            turned && winds,
            "what.hatch_style",
            winds,
        ),
        ("what.cross", what.cross, "what.hatch_style", winds),
        (
            "what.justify",
            what.justify,
            "what.align",
            what.align.is_some(),
        ),
        // Everything becomes one line.
        ("what.text", what.text.is_some(), "what.shade tsp", is_tsp),
        ("place.border", place.border, "what.shade tsp", is_tsp),
        (
            "place.crop_marks",
            place.crop_marks,
            "what.shade tsp",
            is_tsp,
        ),
        ("place.sign", place.sign.is_some(), "what.shade tsp", is_tsp),
    ]
}

/// Returns the options that require another one.
fn dependent(options: &Options) -> [Pair; 17] {
    let Options {
        what, place, tool, ..
    } = options;
    let defaults = Options::default();
    let by_laser = tool.laser.is_some();
    let (layered, hatched) = (what.layers.is_some(), what.hatch.is_some());
    let sheet = place.paper_size.is_some();
    let shade = what.shade.unwrap_or(Shading::default().style);
    let apart = place.gap != defaults.place.gap;
    let cornered = place.corner.is_some();
    let turned = what.hatch_angle != defaults.what.hatch_angle;
    [
        (
            "place.landscape",
            place.landscape,
            "place.paper_size",
            sheet,
        ),
        ("place.corner", cornered, "place.paper_size", sheet),
        (
            "place.gap",
            apart,
            "place.grid, place.border, place.sign or what.text",
            has_gaps(place) || what.text.is_some(),
        ),
        (
            "what.justify",
            what.justify,
            "what.wrap or place.paper_size",
            what.wrap.is_some() || sheet,
        ),
        (
            "what.levels",
            what.levels.is_some(),
            "what.shade hatch or outline",
            matches!(shade, ShadingStyle::Hatch | ShadingStyle::Outline),
        ),
        ("what.layer", !what.layer.is_empty(), "what.layers", layered),
        ("what.only", !what.only.is_empty(), "what.layers", layered),
        ("what.hatch_angle", turned, "what.hatch", hatched),
        ("what.cross", what.cross, "what.hatch", hatched),
        (
            "what.hatch_style",
            what.hatch_style != defaults.what.hatch_style,
            "what.hatch",
            hatched,
        ),
        (
            "what.hatch_inset",
            what.hatch_inset != 0.0,
            "what.hatch",
            hatched,
        ),
        (
            "tool.passes_by",
            tool.passes_by != defaults.tool.passes_by,
            "tool.laser",
            by_laser,
        ),
        ("tool.kerf", tool.kerf != 0.0, "tool.laser", by_laser),
        ("tool.lead_in", tool.lead_in != 0.0, "tool.laser", by_laser),
        ("tool.overcut", tool.overcut != 0.0, "tool.laser", by_laser),
        ("tool.tabs", tool.tabs != 0, "tool.laser", by_laser),
        (
            "tool.tab_width",
            tool.tab_width != defaults.tool.tab_width,
            "tool.tabs",
            tool.tabs != 0,
        ),
    ]
}

/// The kind of content.
#[derive(Clone, Copy, Debug)]
enum SourceKind {
    File(&'static Format),
    /// Lines computed by a program.
    Lines,
    Text,
    Card,
}

impl SourceKind {
    const fn of(source: &Source) -> Self {
        match source {
            Source::File { format, .. } => Self::File(format),
            Source::Lines(_) => Self::Lines,
            Source::Text(_) => Self::Text,
        }
    }

    const fn contents(self) -> Option<Contents> {
        match self {
            Self::File(format) => Some(format.contents),
            Self::Lines => Some(Contents::Lines),
            Self::Text | Self::Card => None,
        }
    }
}

/// The content for which an option has an effect.
#[derive(Clone, Copy, Debug)]
enum Purpose {
    Pictures,
    /// Pictures and the test card.
    Lined,
    Texts,
    Cards,
    /// The areas of drawings and texts.
    Areas,
    /// Shapes painted over each other.
    Painted,
    Pages,
    Gcode,
    /// The layers of drawings.
    Layers,
    /// Everything except the test card.
    Drawings,
}

impl Purpose {
    fn fits(self, kind: SourceKind) -> bool {
        let is_picture = matches!(kind.contents(), Some(Contents::Picture));
        let is_drawing = kind.contents().is_some() && !is_picture;
        match self {
            Self::Pictures => is_picture,
            Self::Lined => is_picture || matches!(kind, SourceKind::Card),
            Self::Texts => matches!(kind, SourceKind::Text),
            Self::Cards => matches!(kind, SourceKind::Card),
            Self::Areas => is_drawing || matches!(kind, SourceKind::Text),
            Self::Painted | Self::Pages | Self::Gcode => match kind {
                SourceKind::File(format) => self.fits_format(format),
                _ => false,
            },
            Self::Layers => is_drawing,
            Self::Drawings => !matches!(kind, SourceKind::Card),
        }
    }

    /// Whether an option applies to files of this format, for properties of only some formats.
    fn fits_format(self, format: &Format) -> bool {
        match self {
            Self::Gcode => format.name == "G-code",
            Self::Painted => matches!(format.contents, Contents::Page | Contents::Shapes),
            _ => matches!(format.contents, Contents::Page),
        }
    }
}

impl fmt::Display for Purpose {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Pictures => "pictures",
            Self::Lined => "pictures and the test card",
            Self::Texts => "the letters of what.text",
            Self::Cards => "the test card of what.card",
            Self::Areas => "the areas of drawings and texts (`what.shade hatch` is for pictures)",
            Self::Painted | Self::Pages | Self::Gcode => {
                let names = Format::names(|format| self.fits_format(format), "and");
                return write!(f, "{names} files");
            }
            Self::Layers => "the layers of drawings",
            Self::Drawings => "drawings, pictures and texts",
        })
    }
}

/// Returns each field, whether it is given, and its purpose. Values set by a material do not count.
fn given(options: &Options) -> [(&'static str, bool, Purpose); 39] {
    let Options {
        what, place, tool, ..
    } = options;
    [
        ("what.shade", what.shade.is_some(), Purpose::Pictures),
        ("what.spacing", what.spacing.is_some(), Purpose::Lined),
        ("what.invert", what.invert, Purpose::Pictures),
        ("what.brightness", what.brightness != 0.0, Purpose::Pictures),
        ("what.contrast", what.contrast != 0.0, Purpose::Pictures),
        ("what.gamma", what.gamma != 1.0, Purpose::Pictures),
        (
            "what.threshold",
            what.threshold.is_some(),
            Purpose::Pictures,
        ),
        ("what.levels", what.levels.is_some(), Purpose::Pictures),
        ("what.font", what.font.is_some(), Purpose::Texts),
        ("what.height", what.height.is_some(), Purpose::Texts),
        ("what.align", what.align.is_some(), Purpose::Texts),
        ("what.wrap", what.wrap.is_some(), Purpose::Texts),
        ("what.justify", what.justify, Purpose::Texts),
        (
            "what.card_passes",
            what.card_passes.is_some(),
            Purpose::Cards,
        ),
        ("what.card_size", what.card_size.is_some(), Purpose::Cards),
        ("what.card_gap", what.card_gap.is_some(), Purpose::Cards),
        ("what.card_label", what.card_label.is_some(), Purpose::Cards),
        ("what.hatch", what.hatch.is_some(), Purpose::Areas),
        ("what.layers", what.layers.is_some(), Purpose::Layers),
        ("what.no_crop", what.no_crop, Purpose::Pages),
        ("what.gcode", what.gcode.is_some(), Purpose::Gcode),
        ("what.hide", what.hide, Purpose::Painted),
        ("what.white_edges", what.white_edges, Purpose::Pages),
        ("place.fit", place.fit, Purpose::Drawings),
        (
            "place.paper_size",
            place.paper_size.is_some(),
            Purpose::Drawings,
        ),
        ("place.mirror", place.mirror, Purpose::Drawings),
        ("place.grid", place.grid.is_some(), Purpose::Drawings),
        ("place.scale", place.scale.is_some(), Purpose::Drawings),
        ("place.rotate", place.rotate != 0.0, Purpose::Drawings),
        ("place.margin", place.margin != 0.0, Purpose::Drawings),
        ("place.border", place.border, Purpose::Drawings),
        ("place.crop_marks", place.crop_marks, Purpose::Drawings),
        ("place.sign", place.sign.is_some(), Purpose::Drawings),
        ("place.clip", place.clip, Purpose::Drawings),
        ("tool.speed", tool.speed.is_some(), Purpose::Drawings),
        ("tool.passes", tool.passes.is_some(), Purpose::Drawings),
        ("tool.kerf", tool.kerf != 0.0, Purpose::Drawings),
        ("tool.lead_in", tool.lead_in != 0.0, Purpose::Drawings),
        ("tool.tabs", tool.tabs != 0, Purpose::Drawings),
    ]
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn refusal(json: &str) -> String {
        let options: Options = serde_json::from_str(json).unwrap();
        let file = NamedSource {
            name: "a.svg".to_owned(),
            source: Source::from("<svg/>"),
        };
        let refused = check(&options, &[file], "a.svg");
        refused.unwrap_err().to_string()
    }

    #[test]
    fn an_option_that_would_do_nothing_is_refused_from_json_too() {
        for (json, message) in [
            (
                r#"{"what": {"shade": "lines"}}"#,
                "what.shade is for pictures, and a.svg is in SVG format",
            ),
            (
                r#"{"what": {"gcode": "laser"}}"#,
                "what.gcode is for G-code files, and a.svg is in SVG format",
            ),
            (
                r#"{"place": {"fit": true, "scale": 2}}"#,
                "place.fit and place.scale exclude each other; use only one",
            ),
            (
                r#"{"tool": {"pen": "marker", "laser": "plywood-engrave"}}"#,
                "tool.pen and tool.laser exclude each other; use only one",
            ),
            (
                r#"{"what": {"cross": true}}"#,
                "what.cross has no effect without what.hatch",
            ),
            (
                r#"{"place": {"gap": 9}}"#,
                "place.gap has no effect without place.grid, place.border, place.sign or what.text",
            ),
            (
                r#"{"what": {"shade": "stipple", "levels": 3}}"#,
                "what.levels has no effect without what.shade hatch or outline",
            ),
            (
                r#"{"place": {"at": [200]}}"#,
                "place.at has 1 numbers; it takes 2",
            ),
            (
                r#"{"place": {"at": [1e300, 0]}}"#,
                "place.at has 1e300; it takes numbers of millimetres from -10000 to 10000",
            ),
            (
                r#"{"tool": {"speed": 1e9}}"#,
                "tool.speed is 1000000000 mm/s; it takes 0 to 1000 mm/s",
            ),
            (
                r#"{"what": {"gamma": 0}}"#,
                "what.gamma is 0; it takes 0.1 to 10",
            ),
            (
                r#"{"what": {"shade": "tsp"}, "way": {"keep_order": true}}"#,
                "way.keep_order and what.shade tsp exclude each other; use only one",
            ),
            (
                r#"{"what": {"layers": "color", "layer": [{"name": "red", "pen": "marker"}, {"name": "red", "pen": "pencil"}]}}"#,
                "what.layer \"red\" is given twice; use only one",
            ),
            (
                r#"{"tool": {"passes": 0}}"#,
                "tool.passes is 0 times; it takes 1 to 100 times",
            ),
            (
                r#"{"place": {"paper": [1, 2, 3, 4, -5e20, 6, 7, 8, 9]}}"#,
                "place.paper has -5e20; it takes numbers of millimetres from -10000 to 10000",
            ),
        ] {
            assert_eq!(refusal(json), message);
        }
    }

    #[test]
    fn hidden_lines_are_removed_where_shapes_cover_each_other() {
        let options: Options = serde_json::from_str(r#"{"what": {"hide": true}}"#).unwrap();
        let of = |name: &str| {
            let file = NamedSource {
                name: name.to_owned(),
                source: Source::of_file(name, Vec::new()).unwrap(),
            };
            check(&options, &[file], name)
        };
        of("a.dxf").unwrap();
        of("a.svg").unwrap();
        of("a.plt").unwrap();
        let refused = of("a.gcode").unwrap_err();
        assert_eq!(
            refused.to_string(),
            "what.hide is for SVG, DXF and HP-GL files, and a.gcode is in G-code format"
        );
    }

    #[test]
    fn an_unknown_option_is_named() {
        let unknown = serde_json::from_str::<Options>(r#"{"place": {"turn": 90}}"#);
        assert!(unknown.unwrap_err().to_string().contains("`turn`"));
    }
}
