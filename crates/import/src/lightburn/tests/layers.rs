use super::*;

fn square(cut: u32, side_mm: f64, x: f64) -> String {
    let attributes = format!("Type=\"Rect\" CutIndex=\"{cut}\" W=\"{side_mm}\" H=\"{side_mm}\"");
    shape(&attributes, &format!("1 0 0 1 {x} 0"), "")
}

/// The number of areas of a layer, and of rings of each.
fn rings(artwork: &Artwork) -> Vec<usize> {
    let areas = artwork.layers.iter().flat_map(|layer| &layer.areas);
    areas.map(|area| area.rings.len()).collect()
}

#[test]
fn layers_have_their_names_and_colours_in_the_order_of_the_laser() {
    let named = |index: u32, name: &str, priority: u32| {
        let more = format!("<priority Value=\"{priority}\"/>");
        let named = cut(index, "Cut", &more);
        named.replace(&format!("\"C{index:02}\""), &format!("\"{name}\""))
    };
    let cuts = named(1, "edge", 2) + &named(2, "marks", 0) + &named(17, "marks", 1);
    let shapes = square(1, 9.0, 0.0) + &square(2, 3.0, 0.0) + &square(17, 2.0, 0.0);
    let (artwork, _) = read_text(&project(&(cuts + &shapes)));
    let layers: Vec<_> = artwork
        .layers
        .iter()
        .map(|layer| (layer.name.as_str(), layer.color))
        .collect();
    let expected = [
        ("marks (C02)", Some([0xff, 0, 0])),
        ("marks (C17)", Some([0x7d, 0x87, 0xb9])),
        ("edge", Some([0, 0, 0xff])),
    ];
    assert_eq!(layers, expected);
}

#[test]
fn a_shape_of_a_fill_layer_is_an_area_and_a_shape_inside_it_is_a_hole() {
    let shapes = square(0, 9.0, 0.0) + &square(0, 3.0, 0.0);
    let with = |mode: &str, more: &str| read_text(&project(&(cut(0, mode, more) + &shapes))).0;
    assert_eq!(rings(&with("Cut", "")), [0; 0]);
    assert_eq!(rings(&with("Scan", "")), [2]);
    assert_eq!(rings(&with("Scan+Cut", "")), [2]);
    assert_eq!(
        rings(&with("Scan", "<scanOpt Value=\"individual\"/>")),
        [1, 1]
    );
    assert_eq!(strokes(&with("Scan", "")).len(), 2);
    let area = &with("Scan", "").layers[0].areas[0];
    assert_eq!(area.rule, dobot_geometry::FillRule::EvenOdd);
}

#[test]
fn groups_are_filled_together_if_the_layer_requests_it() {
    let pair = |x: f64| {
        let both = square(0, 9.0, x) + &square(0, 3.0, x);
        shape(
            "Type=\"Group\"",
            HERE,
            &format!("<Children>{both}</Children>"),
        )
    };
    let cut = cut(0, "Scan", "<scanOpt Value=\"byGroup\"/>");
    let (artwork, _) = read_text(&project(&(cut + &pair(0.0) + &pair(20.0))));
    assert_eq!(rings(&artwork), [2, 2]);
}

#[test]
fn an_open_line_of_a_fill_layer_is_a_line() {
    let line = shape(
        "Type=\"Path\" CutIndex=\"0\"",
        HERE,
        "<VertList>V0 0V4 0V4 4</VertList><PrimList>L0 1L1 2</PrimList>",
    );
    let (artwork, warnings) = read_text(&project(&(cut(0, "Scan", "") + &line)));
    assert_eq!((strokes(&artwork).len(), rings(&artwork).len()), (1, 0));
    assert!(
        warnings[0].contains("1 unclosed fill: drawn as a line"),
        "{warnings:?}"
    );
}

#[test]
fn objects_that_a_laser_would_not_burn_are_skipped_and_reported() {
    let cuts = cut(0, "Cut", "")
        + &cut(3, "Cut", "<doOutput Value=\"0\"/>")
        + &cut(4, "Cut", "<hide Value=\"1\"/>")
        + &cut(30, "Tool", "");
    let shapes =
        square(3, 9.0, 0.0) + &square(0, 3.0, 0.0) + &square(30, 5.0, 0.0) + &square(3, 2.0, 0.0);
    let (artwork, warnings) = read_text(&project(&(cuts.clone() + &shapes)));
    assert_eq!(strokes(&artwork).len(), 1);
    let message = warnings.join("\n");
    for part in [
        "2 switched-off shapes: left out, because the output of its layer is off in LightBurn (C03)",
        "1 tool-layer shape: left out, because LightBurn does not output tool layers (C30)",
    ] {
        assert!(message.contains(part), "{message}");
    }
    let (artwork, warnings) = read_text(&project(&(cuts + &square(4, 2.0, 0.0))));
    assert_eq!(strokes(&artwork).len(), 1);
    assert!(
        warnings[0].contains("1 hidden shape: drawn"),
        "{warnings:?}"
    );
}

#[test]
fn if_nothing_is_output_the_error_gives_the_reason() {
    let text = project(&(cut(2, "Cut", "<doOutput Value=\"0\"/>") + &square(2, 9.0, 0.0)));
    let error = error(&text);
    let begin = "nothing to draw: no shapes that are output; ";
    assert!(error.starts_with(begin), "{error}");
    assert!(error.contains("1 switched-off shape: left out"), "{error}");
}

#[test]
fn a_layer_without_settings_is_drawn_as_lines() {
    let (artwork, warnings) = read_text(&project(&square(5, 9.0, 0.0)));
    assert_eq!(artwork.layers[0].name, "C05");
    assert!(
        warnings[0].contains("1 unlisted shape: drawn as lines"),
        "{warnings:?}"
    );
}
