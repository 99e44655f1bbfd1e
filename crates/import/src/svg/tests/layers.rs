#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

use dobot_geometry::{Area, FillRule, bounds};
use proptest::prelude::*;

use super::*;
use crate::artwork::Layer;

fn read_by(layers: LayersBy, content: &str) -> (Vec<Layer>, Vec<Warning>) {
    let text = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
        width="100mm" height="50mm" viewBox="0 0 100 50">{content}</svg>"#
    );
    let options = ReadOptions {
        layers,
        ..ReadOptions::default()
    };
    let (artwork, warnings) = read(&text, &options).unwrap();
    (artwork.layers, warnings)
}

/// Names with how many strokes and areas.
fn contents(layers: &[Layer]) -> Vec<(&str, usize, usize)> {
    let count = |layer: &Layer| (layer.strokes.len(), layer.areas.len());
    let named = layers
        .iter()
        .map(|layer| (layer.name.as_str(), count(layer)));
    named.map(|(name, (s, a))| (name, s, a)).collect()
}

fn extent(area: &Area) -> [f64; 4] {
    let bounds = bounds(area.rings.iter().flatten().copied());
    let corners = [bounds.x0, bounds.y0, bounds.x1, bounds.y1];
    corners.map(|corner| (corner * 1e3).round() / 1e3)
}

#[test]
fn colours_become_layers_in_the_order_of_their_first_shape() {
    let (layers, _) = read_by(
        LayersBy::Color,
        r##"<path fill="none" stroke="#1b2a41" d="M0 0H5"/><path fill="none" stroke="rgb(255,0,0)" d="M0 1H5"/>
        <g stroke="#1b2a41"><path fill="none" d="M0 2H5"/></g>"##,
    );
    assert_eq!(contents(&layers), [("#1b2a41", 2, 0), ("red", 1, 0)]);
    assert_eq!(layers[1].color, Some([255, 0, 0]));
    let ys: Vec<f64> = layers[0]
        .strokes
        .iter()
        .map(|stroke| stroke.points[0].y.round())
        .collect();
    assert_eq!(ys, [0.0, 2.0]);
}

#[test]
fn line_widths_on_the_page_become_layers() {
    let (layers, _) = read_by(
        LayersBy::Width,
        r#"<g fill="none" stroke="red"><path stroke-width="0.5" d="M0 0H5"/><path stroke-width="1" d="M0 1H5"/>
        <path stroke="blue" stroke-width="0.25" transform="scale(2)" d="M0 2H5"/>
        <path stroke-width="2" transform="scale(4)" vector-effect="non-scaling-stroke" d="M0 1H5"/></g>
        <rect x="5" y="5" width="10" height="4" fill="gold" stroke="black"/>
        <rect x="25" y="5" width="10" height="4" fill="gold"/>"#,
    );
    assert_eq!(
        contents(&layers),
        [
            ("0.5 mm", 2, 0),
            ("1 mm", 2, 0),
            ("0.53 mm", 1, 0),
            ("fills", 1, 2)
        ]
    );
    // A layer of several colours has none.
    assert_eq!(layers[0].color, None);
}

#[test]
fn a_line_width_on_the_page_is_that_of_its_dashes_too() {
    let line = |attributes: &str| {
        let (layers, warnings) = read_by(
            LayersBy::Width,
            &format!(
                r#"<path transform="scale(4)" d="M0 1H5" fill="none" stroke="red" stroke-width="2" {attributes}/>"#
            ),
        );
        assert_eq!(warnings, []);
        let [layer] = &layers[..] else {
            panic!("{layers:?}");
        };
        let dash = layer.strokes[0].length_mm();
        (
            layer.name.clone(),
            layer.strokes.len(),
            (dash * 100.0).round() / 100.0,
        )
    };
    let found = |name: &str, strokes, dash_mm| (name.to_owned(), strokes, dash_mm);
    assert_eq!(line(""), found("8 mm", 1, 20.0));
    assert_eq!(line(r#"stroke-dasharray="2""#), found("8 mm", 2, 8.0));
    let shares = r#"pathLength="4" stroke-dasharray="1""#;
    assert_eq!(line(shares), found("8 mm", 2, 5.0));
    let on_page = |more: &str| line(&format!(r#"vector-effect="non-scaling-stroke" {more}"#));
    assert_eq!(on_page(""), found("0.53 mm", 1, 20.0));
    // 2 px are 0.53 mm.
    let dashed = on_page(r#"stroke-dasharray="2""#);
    assert_eq!(dashed, found("0.53 mm", 19, 0.53));
    assert_eq!(on_page(shares), found("0.53 mm", 2, 5.0));
}

#[test]
fn edges_of_white_shapes_belong_to_the_fills() {
    let options = ReadOptions {
        layers: LayersBy::Width,
        white_edges: true,
        ..ReadOptions::default()
    };
    let content = r#"<rect x="5" y="5" width="20" height="20"/>
        <path d="M5 40H9" stroke="red" stroke-width="0.5"/>
        <rect x="10" y="10" width="5" height="5" fill="white"/>"#;
    let (artwork, _) = read(&page(content), &options).unwrap();
    assert_eq!(
        contents(&artwork.layers),
        [("fills", 2, 1), ("0.5 mm", 1, 0)]
    );
}

#[test]
fn a_fill_gives_an_area_of_its_own_colour_in_addition_to_the_outline() {
    let (layers, _) = read_by(
        LayersBy::Color,
        r#"<rect x="5" y="5" width="10" height="4" fill="gold" stroke="black"/>
        <rect x="25" y="5" width="10" height="4" fill="gold"/>"#,
    );
    assert_eq!(contents(&layers), [("gold", 1, 2), ("black", 1, 0)]);
    assert_eq!(extent(&layers[0].areas[0]), [5.0, 5.0, 15.0, 9.0]);
    assert_eq!(layers[0].areas[0].rings[0].len(), 4);
}

#[test]
fn white_is_paper_in_fills_and_ink_in_lines() {
    let (layers, warnings) = read_by(
        LayersBy::Color,
        r##"<rect width="100" height="50" fill="#fff"/>
        <rect x="5" y="5" width="9" height="9" fill="white" stroke="red"/>
        <path d="M5 5H9" stroke="white"/>"##,
    );
    assert_eq!(contents(&layers), [("red", 1, 0), ("white", 1, 0)]);
    let texts: Vec<String> = warnings.iter().map(Warning::to_string).collect();
    assert_eq!(
        texts,
        ["1 white shape: left out, because the paper is white"]
    );
}

#[test]
fn a_line_that_encloses_nothing_has_no_area() {
    let (layers, _) = read_by(
        LayersBy::Color,
        r#"<path d="M5 5H50" stroke="red"/><path d="M5 5h0" stroke="red" stroke-linecap="round"/>"#,
    );
    assert_eq!(contents(&layers), [("red", 2, 0)]);
    assert_eq!(layers[0].strokes[1].points.len(), 1);
}

#[test]
fn the_fill_rule_is_kept() {
    let path = "M0 0H9V9H0ZM3 3H6V6H3Z";
    let (layers, _) = read_by(
        LayersBy::Nothing,
        &format!(r#"<path d="{path}"/><path d="{path}" fill-rule="evenodd"/>"#),
    );
    let rules: Vec<FillRule> = layers[0].areas.iter().map(|area| area.rule).collect();
    assert_eq!(rules, [FillRule::NonZero, FillRule::EvenOdd]);
    assert_eq!(layers[0].areas[1].rings.len(), 2);
}

#[test]
fn areas_are_cut_by_the_page_and_by_clip_paths() {
    let (layers, _) = read_by(
        LayersBy::Nothing,
        r#"<clipPath id="c"><rect x="20" y="10" width="10" height="10"/><rect x="40" y="10" width="10" height="10"/></clipPath>
        <rect x="-10" y="40" width="30" height="30"/>
        <rect x="25" y="5" width="50" height="10" clip-path="url(#c)"/>
        <rect x="70" y="5" width="5" height="5" clip-path="url(#c)"/>
        <rect x="200" y="5" width="5" height="5"/>"#,
    );
    let extents: Vec<[f64; 4]> = layers[0].areas.iter().map(extent).collect();
    // The page goes half a percent beyond its edge.
    assert_eq!(
        extents,
        [[-0.25, 40.0, 20.0, 50.25], [25.0, 10.0, 50.0, 15.0]]
    );
    assert_eq!(layers[0].areas[1].rings.len(), 2);
}

#[test]
fn gradients_count_as_their_first_colour_and_patterns_are_drawn() {
    let (layers, warnings) = read_by(
        LayersBy::Color,
        r#"<linearGradient id="g"><stop stop-color="navy"/><stop offset="1"/></linearGradient>
        <pattern id="p" width="2" height="2" patternUnits="userSpaceOnUse"><path d="M0 0H1" stroke="red"/></pattern>
        <rect width="9" height="9" fill="url(#g)"/><rect width="9" height="9" fill="url(#p)"/>"#,
    );
    // The pattern has lines of its own: 5 rows of 5 tiles, the last of which is half a tile.
    assert_eq!(contents(&layers), [("navy", 1, 1), ("red", 25, 0)]);
    assert_eq!(layers[1].color, Some([255, 0, 0]));
    assert_eq!(warnings.len(), 1);
}

#[test]
fn outermost_groups_become_layers_with_their_labels() {
    let (layers, _) = read_by(
        LayersBy::Group,
        r#"<path d="M0 0H5" stroke="red"/>
        <g id="layer1" inkscape:label="Sea"><g id="inner"><path d="M0 0H5" stroke="red"/></g><path d="M0 0H5" stroke="blue"/></g>
        <g id="sky" transform="translate(5 5)"><path d="M0 0H5" stroke="red"/></g>
        <g display="none"><path d="M0 0H5" stroke="red"/></g>
        <g><path d="M0 0H5" stroke="lime"/></g>
        <path d="M0 9H5" stroke="red"/>"#,
    );
    assert_eq!(
        contents(&layers),
        [
            ("outside groups", 2, 0),
            ("Sea", 2, 0),
            ("sky", 1, 0),
            ("group 4", 1, 0)
        ]
    );
    let colors: Vec<Option<[u8; 3]>> = layers.iter().map(|layer| layer.color).collect();
    assert_eq!(
        colors,
        [
            Some([255, 0, 0]),
            None,
            Some([255, 0, 0]),
            Some([0, 255, 0])
        ]
    );
}

#[test]
fn groups_are_found_in_files_that_only_a_full_reader_understands() {
    let (layers, _) = read_by(
        LayersBy::Group,
        r##"<style>.a{stroke:red}</style><defs><path id="p" d="M0 0H5"/></defs>
        <g><use href="#p" class="a"/></g><g id="b" class="a"><use href="#p"/></g><use href="#p" class="a"/>"##,
    );
    assert_eq!(
        contents(&layers),
        [("group 1", 1, 0), ("b", 1, 0), ("outside groups", 1, 0)]
    );
}

#[test]
fn a_single_layer_holds_everything_if_nothing_divides_it() {
    let (layers, _) = read_by(
        LayersBy::Nothing,
        r#"<g><path d="M0 0H5" stroke="red"/></g><path d="M0 0H5" stroke="blue"/>"#,
    );
    assert_eq!(contents(&layers), [("all", 2, 0)]);
    assert_eq!(layers[0].color, None);
}

#[test]
fn letters_are_areas_too() {
    let Some(options) = super::with_fonts() else {
        return; // A machine without fonts cannot show this.
    };
    let text = r#"<svg xmlns="http://www.w3.org/2000/svg" width="50" height="50"><text x="10" y="30" font-size="20">o</text></svg>"#;
    let (artwork, _) = read(text, &options).unwrap();
    assert_eq!(contents(&artwork.layers), [("black", 2, 1)]);
    assert_eq!(artwork.layers[0].areas[0].rings.len(), 2);
}

#[test]
fn a_missing_font_is_reported_with_its_replacement() {
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_system_fonts();
    let first = fonts.faces().next().map(|face| face.families[0].0.clone());
    let Some(here) = first else {
        return; // A machine without fonts cannot show this.
    };
    fonts.set_serif_family(&here);
    fonts.set_sans_serif_family(&here);
    let options = ReadOptions {
        fonts: Arc::new(fonts),
        ..ReadOptions::default()
    };
    let warnings = |families: &[&str]| -> Vec<String> {
        let text = |text: &&str| {
            let font = if text.is_empty() {
                String::new()
            } else {
                format!("font-family=\"{text}\"")
            };
            format!(r#"<text {font} x="10" y="30" font-size="20">o</text>"#)
        };
        let texts: String = families.iter().map(text).collect();
        let svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="50" height="50">{texts}</svg>"#
        );
        let (_, warnings) = read(&svg, &options).unwrap();
        warnings.iter().map(Warning::to_string).collect()
    };
    assert_eq!(
        warnings(&["No Such Sans", "No Such Sans"]),
        [format!(
            "1 font No Such Sans: not installed, drawn in {here}"
        )]
    );
    let known = format!("No Such Sans, {here}");
    let none: [String; 0] = [];
    assert_eq!(
        warnings(&["", "No Such Sans, sans-serif", &known, &here]),
        none
    );
}

#[test]
fn a_missing_font_is_replaced_by_one_of_the_kind_that_its_name_states() {
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_system_fonts();
    let mut names: Vec<_> = fonts
        .faces()
        .map(|face| face.families[0].0.clone())
        .collect();
    names.sort();
    names.dedup();
    let [serif, sans, mono, ..] = &names[..] else {
        return; // A machine with less than three fonts cannot show this.
    };
    fonts.set_serif_family(serif);
    fonts.set_sans_serif_family(sans);
    fonts.set_monospace_family(mono);
    let options = ReadOptions {
        fonts: Arc::new(fonts),
        ..ReadOptions::default()
    };
    for (asked, taken) in [
        ("No Such Sans", sans),
        ("Helvetica of Nowhere", sans),
        ("No Such Mono Sans", mono),
        ("No Such Roman", serif),
    ] {
        let svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="50" height="50"><text font-family="{asked}" x="10" y="30" font-size="20">o</text></svg>"#
        );
        let (_, warnings) = read(&svg, &options).unwrap();
        let message = format!("1 font {asked}: not installed, drawn in {taken}");
        let warnings: Vec<_> = warnings.iter().map(Warning::to_string).collect();
        assert!(warnings.contains(&message), "{message}: {warnings:?}");
    }
}

#[test]
fn areas_are_transformed_like_their_shapes() {
    let (layers, _) = read_by(
        LayersBy::Nothing,
        r#"<path transform="translate(10 10) scale(2 -1)" d="M0 0H10V-10H0Z"/>"#,
    );
    assert_eq!(extent(&layers[0].areas[0]), [10.0, 10.0, 30.0, 20.0]);
}

#[test]
fn the_bundled_drawing_for_three_pens_has_three_layers_with_both_divisions() {
    let text = include_str!("../../../../../examples/drawings/sailing.svg");
    let by = |layers| {
        let options = ReadOptions {
            layers,
            ..ReadOptions::default()
        };
        let (artwork, warnings) = read(text, &options).unwrap();
        assert_eq!(warnings, []);
        let layers = artwork.layers.into_iter();
        layers
            .map(|layer| (layer.name, layer.areas.len()))
            .collect::<Vec<_>>()
    };
    let named = |names: [&str; 3]| names.map(str::to_owned).into_iter().zip([1, 3, 2]);
    let colors = named(["orange", "crimson", "navy"]);
    assert_eq!(by(LayersBy::Color), colors.collect::<Vec<_>>());
    let labels = named(["orange pen", "crimson pen", "navy pen"]);
    assert_eq!(by(LayersBy::Group), labels.collect::<Vec<_>>());
}

#[test]
fn an_endlessly_self_crossing_clipped_fill_is_drawn_but_not_hatched() {
    let point = |i: i32| {
        let y = 0.006 * f64::from(i);
        let y = if i % 2 == 0 { y } else { 48.0 - y };
        format!("{} {y:.3}", -5 + 100 * (i % 2))
    };
    let points: Vec<String> = (0..8000).map(point).collect();
    let points = points.join(" ");
    let (layers, warnings) = read_by(
        LayersBy::Nothing,
        &format!(r#"<polygon points="{points}"/>"#),
    );
    assert_eq!(layers[0].areas.len(), 0);
    assert!(!layers[0].strokes.is_empty());
    assert_eq!(
        warnings[0].to_string(),
        "1 filled shape: not hatched, because it crosses itself too often, or too many corners lie in clip paths"
    );
}

#[test]
fn an_endlessly_cutting_clip_path_is_refused() {
    let comb = |point: fn(i32) -> [i32; 2]| {
        let points = (0..400).map(point).map(|[x, y]| format!("{x} {y}"));
        points.collect::<Vec<_>>().join(" ")
    };
    let upright = comb(|i| [i, 2000 * (i % 2)]);
    let across = comb(|i| [2000 * (i % 2), i]);
    let text = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="2000" height="2000">
        <clipPath id="c"><polygon points="{upright}"/></clipPath>
        <polyline points="{across}" fill="none" stroke="red" clip-path="url(#c)"/></svg>"#
    );
    let error = read(&text, &ReadOptions::default());
    assert_eq!(
        error.unwrap_err().to_string(),
        "clipping lines and areas takes too long; simplify the clip paths, or draw it in parts"
    );
}

#[test]
fn hostile_files_are_refused_with_any_division_into_layers() {
    for layers in [LayersBy::Color, LayersBy::Group, LayersBy::Nothing] {
        let options = ReadOptions {
            layers,
            ..ReadOptions::default()
        };
        for text in [
            "",
            "<svg",
            "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><g></svg>",
            "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><g/><g id=''/></svg>",
            "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><g><path d='M0 0L1e30 1'/></g></svg>",
        ] {
            let error = read(text, &options).unwrap_err().to_string();
            assert!(!error.contains('\n'), "{error}");
        }
    }
}

proptest! {
    #[test]
    fn a_damaged_file_of_groups_is_read_or_refused(
        at in 0..4000_usize,
        length in 0..40_usize,
        filler in proptest::sample::select(vec!["", "<g>", "</g>", "<g/>", "<g id=''/>", "\"", "white", "é"]),
    ) {
        let text = include_str!("../../../../../examples/drawings/sailing.svg");
        let start = at.min(text.len());
        let end = (start + length).min(text.len());
        let damaged = [&text[..start], filler, &text[end..]].concat();
        for layers in [LayersBy::Color, LayersBy::Group] {
            let options = ReadOptions { layers, ..ReadOptions::default() };
            if let Ok((artwork, _)) = read(&damaged, &options) {
                prop_assert!(artwork.layers.iter().all(|layer| !layer.is_empty()));
            }
        }
    }
}

/// An Inkscape layer with a red line and others.
fn layer(label: &str, inner: &str) -> String {
    format!(
        r#"<g xmlns:i="http://www.inkscape.org/namespaces/inkscape" i:groupmode="layer" i:label="{label}"><path d="M0 5H10" stroke="red"/>{inner}</g>"#
    )
}

#[test]
fn labels_of_layers_set_pauses_and_speeds_however_the_file_is_split() {
    let inner = layer("inner", "");
    let content = [
        layer("1 first", ""),
        layer("!2+S50 second", &inner),
        layer("3 third", ""),
        layer("4+S50", ""),
    ];
    let content = content.concat();
    // The name, the pause, the speed in mm/s, and the number of lines. An inner layer has its own speed.
    let split = |by| {
        let (layers, warnings) = read_by(by, &content);
        assert_eq!(warnings, []);
        let layers = layers.into_iter().map(|layer| {
            let speed = layer.speed_mm_s.map(f64::round);
            (layer.name, layer.pause, speed, layer.strokes.len())
        });
        layers.collect::<Vec<_>>()
    };
    let pause = Some("!2+S50 second".to_owned());
    for (by, name) in [(LayersBy::Nothing, "all"), (LayersBy::Color, "red")] {
        let name = name.to_owned();
        assert_eq!(
            split(by),
            [
                (name.clone(), None, None, 1),
                (name.clone(), pause.clone(), Some(110.0), 2),
                (name, None, None, 2),
            ]
        );
    }
    let named = |name: &str, pause, speed, lines| (name.to_owned(), pause, speed, lines);
    assert_eq!(
        split(LayersBy::Group),
        [
            named("1 first", None, None, 1),
            named("!2+S50 second", pause, Some(110.0), 1),
            named("!2+S50 second", None, None, 1),
            named("3 third", None, None, 1),
            named("4+S50", None, Some(110.0), 1),
        ]
    );
}
