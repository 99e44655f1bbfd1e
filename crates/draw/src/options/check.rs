//! Checks that the options fit the source and each other. An option that would do nothing is refused.

use std::fmt;

use dobot_source::{Contents, Format, Shading, ShadingStyle, Source};

use super::{Options, OptionsError, PlaceOptions};
use crate::prepare::NamedSource;

/// Refuses the first option that would do nothing for any of these sources, which have this title together.
/// Without a source the test card is drawn.
pub(super) fn check(
    options: &Options,
    sources: &[NamedSource],
    title: &str,
) -> Result<(), OptionsError> {
    counts(options)?;
    ranges(options)?;
    together(options)?;
    let kinds: Vec<SourceKind> = match sources {
        [] => vec![SourceKind::Card],
        all => all.iter().map(|it| SourceKind::of(&it.source)).collect(),
    };
    if options.what.card.is_some() && !sources.is_empty() {
        return Err(OptionsError::Both {
            option: "--card",
            other: "FILE",
        });
    }
    let apart = options.place.gap != PlaceOptions::default().gap;
    if apart && options.place.grid.is_none() && matches!(kinds[..], [SourceKind::Text]) {
        return Err(OptionsError::Alone {
            option: "--gap",
            needs: "--grid, or a file above the text",
        });
    }
    let misfit = given(options)
        .into_iter()
        .find(|(_, given, purpose)| *given && !kinds.iter().any(|it| purpose.fits(*it)));
    let Some((option, _, purpose)) = misfit else {
        return Ok(());
    };
    Err(OptionsError::Misfit {
        option,
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

/// Places have as many numbers as they need, and all are numbers.
fn counts(options: &Options) -> Result<(), OptionsError> {
    let places = [
        ("--at", &options.place.at, 2),
        ("--corner", &options.place.corner, 2),
        ("--paper", &options.place.paper, 9),
    ];
    for (option, numbers, allowed) in places {
        let found = numbers.as_ref().map_or(allowed, Vec::len);
        if found != allowed {
            return Err(OptionsError::Count {
                option,
                found,
                allowed,
            });
        }
        let mut numbers = numbers.iter().flatten();
        if let Some(&found) = numbers.find(|it| it.abs() > FARTHEST_MM || it.is_nan()) {
            return Err(OptionsError::NoPlace { option, found });
        }
    }
    Ok(())
}

/// Numbers that no arm and no paper has.
fn ranges(options: &Options) -> Result<(), OptionsError> {
    let Options {
        what,
        place,
        tool,
        way,
    } = options;
    let numbers = [
        ("--hatch-inset", Some(what.hatch_inset), 0.0, 20.0, "mm"),
        (
            "--brightness",
            Some(what.brightness),
            -100.0,
            100.0,
            "percent",
        ),
        ("--contrast", Some(what.contrast), -100.0, 100.0, "percent"),
        ("--gamma", Some(what.gamma), 0.1, 10.0, ""),
        ("--threshold", what.threshold, 0.01, 0.99, ""),
        ("--speed", tool.speed, 0.0, 1000.0, "mm/s"),
        ("--travel-speed", tool.travel_speed, 0.0, 1000.0, "mm/s"),
        (
            "--acceleration",
            Some(tool.acceleration),
            0.0,
            10_000.0,
            "mm/s2",
        ),
        ("--lift", tool.lift, 0.0, 200.0, "mm"),
        ("--join", way.join, 0.0, 20.0, "mm"),
        ("--gap", Some(place.gap), 0.0, 1000.0, "mm"),
        ("--passes", tool.passes.map(f64::from), 1.0, 100.0, "times"),
        ("--kerf", Some(tool.kerf), -5.0, 5.0, "mm"),
        ("--lead-in", Some(tool.lead_in), 0.0, 20.0, "mm"),
        ("--overcut", Some(tool.overcut), 0.0, 20.0, "mm"),
        ("--tabs", Some(tool.tabs.into()), 0.0, 100.0, "tabs"),
        ("--tab-width", Some(tool.tab_width), 0.1, 20.0, "mm"),
        ("--offset", Some(place.offset), -100.0, 100.0, "mm"),
        ("--pen-down", place.pen_down, -500.0, 500.0, "mm"),
    ];
    for (option, found, least, most, unit) in numbers {
        let is_refused = |it: &f64| !(least..=most).contains(it);
        if let Some(found) = found.filter(is_refused) {
            return Err(OptionsError::Range {
                option,
                found,
                least,
                most,
                unit,
            });
        }
    }
    Ok(())
}

/// No table is larger.
const FARTHEST_MM: f64 = 10_000.0;

/// Options that exclude each other, and those that need another one.
fn together(options: &Options) -> Result<(), OptionsError> {
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
    let winds = what.hatch_style != defaults.what.hatch_style;
    let exclusive = [
        ("--text", what.text.is_some(), "--card", what.card.is_some()),
        ("--fit", place.fit, "--scale", place.scale.is_some()),
        ("--pen-down", place.pen_down.is_some(), "--paper", touched),
        ("--corner", cornered, "--at", place.at.is_some()),
        ("--corner", cornered, "--paper", touched),
        ("--pen", by_pen, "--laser", by_laser),
        ("--keep-order", way.keep_order, "--tries", tries),
        (
            "--keep-order",
            way.keep_order,
            "--shade tsp",
            what.shade == Some(ShadingStyle::Tsp),
        ),
        ("--lift", tool.lift.is_some(), "--laser", by_laser),
        (
            "--levels",
            what.levels.is_some(),
            "--threshold",
            what.threshold.is_some(),
        ),
        ("--hatch-angle", turned && winds, "--hatch-style", winds),
        ("--cross", what.cross, "--hatch-style", winds),
    ];
    if let Some((option, _, other, _)) = exclusive.into_iter().find(|it| it.1 && it.3) {
        return Err(OptionsError::Both { option, other });
    }
    let mut names: Vec<&str> = what.layer.iter().map(|it| it.name.as_str()).collect();
    names.sort_unstable();
    if let Some(twice) = names.windows(2).find(|it| it[0] == it[1]) {
        return Err(OptionsError::Twice(twice[0].to_owned()));
    }
    let (layered, hatched) = (what.layers.is_some(), what.hatch.is_some());
    let sheet = place.paper_size.is_some();
    let shade = what.shade.unwrap_or(Shading::default().style);
    let apart = place.gap != defaults.place.gap;
    let dependent = [
        ("--landscape", place.landscape, "--paper-size", sheet),
        ("--corner", cornered, "--paper-size", sheet),
        (
            "--gap",
            apart,
            "--grid or --text",
            place.grid.is_some() || what.text.is_some(),
        ),
        (
            "--levels",
            what.levels.is_some(),
            "--shade hatch or outline",
            matches!(shade, ShadingStyle::Hatch | ShadingStyle::Outline),
        ),
        ("--layer", !what.layer.is_empty(), "--layers", layered),
        ("--only", !what.only.is_empty(), "--layers", layered),
        ("--hatch-angle", turned, "--hatch", hatched),
        ("--cross", what.cross, "--hatch", hatched),
        (
            "--hatch-style",
            what.hatch_style != defaults.what.hatch_style,
            "--hatch",
            hatched,
        ),
        ("--hatch-inset", what.hatch_inset != 0.0, "--hatch", hatched),
        (
            "--passes-by",
            tool.passes_by != defaults.tool.passes_by,
            "--laser",
            by_laser,
        ),
        ("--kerf", tool.kerf != 0.0, "--laser", by_laser),
        ("--lead-in", tool.lead_in != 0.0, "--laser", by_laser),
        ("--overcut", tool.overcut != 0.0, "--laser", by_laser),
        ("--tabs", tool.tabs != 0, "--laser", by_laser),
        (
            "--tab-width",
            tool.tab_width != defaults.tool.tab_width,
            "--tabs",
            tool.tabs != 0,
        ),
    ];
    match dependent.into_iter().find(|it| it.1 && !it.3) {
        Some((option, _, needs, _)) => Err(OptionsError::Alone { option, needs }),
        None => Ok(()),
    }
}

/// What kind of thing is drawn.
#[derive(Clone, Copy, Debug)]
enum SourceKind {
    File(&'static Format),
    /// Lines that a program has calculated.
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

/// What an option is for.
#[derive(Clone, Copy, Debug)]
enum Purpose {
    Pictures,
    /// Pictures and the test card.
    Lined,
    Texts,
    Cards,
    /// The areas of drawings and texts.
    Areas,
    /// Shapes that are painted over each other.
    Painted,
    Pages,
    /// The layers of drawings.
    Layers,
    /// All but the test card.
    Drawings,
}

impl Purpose {
    const fn fits(self, kind: SourceKind) -> bool {
        let is_picture = matches!(kind.contents(), Some(Contents::Picture));
        let is_drawing = kind.contents().is_some() && !is_picture;
        match self {
            Self::Pictures => is_picture,
            Self::Lined => is_picture || matches!(kind, SourceKind::Card),
            Self::Texts => matches!(kind, SourceKind::Text),
            Self::Cards => matches!(kind, SourceKind::Card),
            Self::Areas => is_drawing || matches!(kind, SourceKind::Text),
            Self::Painted | Self::Pages => match kind {
                SourceKind::File(format) => self.fits_format(format),
                _ => false,
            },
            Self::Layers => is_drawing,
            Self::Drawings => !matches!(kind, SourceKind::Card),
        }
    }

    /// Whether it is for files of this format, for what only some formats have.
    const fn fits_format(self, format: &Format) -> bool {
        match self {
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
            Self::Texts => "the letters of --text",
            Self::Cards => "the test card of --card",
            Self::Areas => "the areas of drawings and texts (`--shade hatch` is for pictures)",
            Self::Painted | Self::Pages => {
                let names = Format::names(|format| self.fits_format(format), "and");
                return write!(f, "{names} files");
            }
            Self::Layers => "the layers of drawings",
            Self::Drawings => "drawings, pictures and texts",
        })
    }
}

/// Each option, whether it was given, and what it is for. What a material sets does not count.
fn given(options: &Options) -> [(&'static str, bool, Purpose); 32] {
    let Options {
        what, place, tool, ..
    } = options;
    [
        ("--shade", what.shade.is_some(), Purpose::Pictures),
        ("--spacing", what.spacing.is_some(), Purpose::Lined),
        ("--invert", what.invert, Purpose::Pictures),
        ("--brightness", what.brightness != 0.0, Purpose::Pictures),
        ("--contrast", what.contrast != 0.0, Purpose::Pictures),
        ("--gamma", what.gamma != 1.0, Purpose::Pictures),
        ("--threshold", what.threshold.is_some(), Purpose::Pictures),
        ("--levels", what.levels.is_some(), Purpose::Pictures),
        ("--font", what.font.is_some(), Purpose::Texts),
        ("--height", what.height.is_some(), Purpose::Texts),
        ("--align", what.align.is_some(), Purpose::Texts),
        ("--card-passes", what.card_passes.is_some(), Purpose::Cards),
        ("--card-size", what.card_size.is_some(), Purpose::Cards),
        ("--card-gap", what.card_gap.is_some(), Purpose::Cards),
        ("--card-label", what.card_label.is_some(), Purpose::Cards),
        ("--hatch", what.hatch.is_some(), Purpose::Areas),
        ("--layers", what.layers.is_some(), Purpose::Layers),
        ("--no-crop", what.no_crop, Purpose::Pages),
        ("--hide", what.hide, Purpose::Painted),
        ("--fit", place.fit, Purpose::Drawings),
        (
            "--paper-size",
            place.paper_size.is_some(),
            Purpose::Drawings,
        ),
        ("--mirror", place.mirror, Purpose::Drawings),
        ("--grid", place.grid.is_some(), Purpose::Drawings),
        ("--scale", place.scale.is_some(), Purpose::Drawings),
        ("--rotate", place.rotate != 0.0, Purpose::Drawings),
        ("--margin", place.margin != 0.0, Purpose::Drawings),
        ("--clip", place.clip, Purpose::Drawings),
        ("--speed", tool.speed.is_some(), Purpose::Drawings),
        ("--passes", tool.passes.is_some(), Purpose::Drawings),
        ("--kerf", tool.kerf != 0.0, Purpose::Drawings),
        ("--lead-in", tool.lead_in != 0.0, Purpose::Drawings),
        ("--tabs", tool.tabs != 0, Purpose::Drawings),
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
        for (json, told) in [
            (
                r#"{"what": {"shade": "lines"}}"#,
                "--shade is for pictures, and a.svg is in SVG format",
            ),
            (
                r#"{"place": {"fit": true, "scale": 2}}"#,
                "--fit and --scale exclude each other: give one of them",
            ),
            (
                r#"{"tool": {"pen": "marker", "laser": "plywood-engrave"}}"#,
                "--pen and --laser exclude each other: give one of them",
            ),
            (
                r#"{"what": {"cross": true}}"#,
                "--cross does nothing without --hatch",
            ),
            (
                r#"{"place": {"gap": 9}}"#,
                "--gap does nothing without --grid or --text",
            ),
            (
                r#"{"what": {"shade": "stipple", "levels": 3}}"#,
                "--levels does nothing without --shade hatch or outline",
            ),
            (
                r#"{"place": {"at": [200]}}"#,
                "--at has 1 numbers; it takes 2",
            ),
            (
                r#"{"place": {"at": [1e300, 0]}}"#,
                "--at has 1e300; it takes numbers of millimetres from -10000 to 10000",
            ),
            (
                r#"{"tool": {"speed": 1e9}}"#,
                "--speed is 1000000000 mm/s; it takes 0 to 1000 mm/s",
            ),
            (
                r#"{"what": {"gamma": 0}}"#,
                "--gamma is 0; it takes 0.1 to 10",
            ),
            (
                r#"{"what": {"shade": "tsp"}, "way": {"keep_order": true}}"#,
                "--keep-order and --shade tsp exclude each other: give one of them",
            ),
            (
                r#"{"what": {"layers": "color", "layer": [{"name": "red", "pen": "marker"}, {"name": "red", "pen": "pencil"}]}}"#,
                "--layer \"red\" is given twice: give one of them",
            ),
            (
                r#"{"tool": {"passes": 0}}"#,
                "--passes is 0 times; it takes 1 to 100 times",
            ),
            (
                r#"{"place": {"paper": [1, 2, 3, 4, -5e20, 6, 7, 8, 9]}}"#,
                "--paper has -5e20; it takes numbers of millimetres from -10000 to 10000",
            ),
        ] {
            assert_eq!(refusal(json), told);
        }
    }

    #[test]
    fn hidden_lines_are_left_out_where_shapes_are_painted_over_each_other() {
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
            "--hide is for SVG, DXF and HP-GL files, and a.gcode is in G-code format"
        );
    }

    #[test]
    fn a_word_that_no_option_knows_is_named() {
        let unknown = serde_json::from_str::<Options>(r#"{"place": {"turn": 90}}"#);
        assert!(unknown.unwrap_err().to_string().contains("`turn`"));
    }
}
