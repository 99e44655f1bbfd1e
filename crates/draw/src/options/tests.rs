#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

use dobot_geometry::{Rect, Stroke, bounds, bounds_of_strokes};

use super::*;
use crate::material::Materials;
use crate::prepare::{NamedSource, Prepared};

/// Files of this size in mm, each with its diagonal.
fn files(sizes: &[(u32, u32)]) -> Vec<NamedSource> {
    let file = |(width, height): &(u32, u32)| {
        let svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}mm" height="{height}mm" viewBox="0 0 {width} {height}"><path d="M0 0L{width} {height}" stroke="red"/></svg>"#
        );
        NamedSource {
            name: format!("{width}x{height}.svg"),
            source: svg.as_str().into(),
        }
    };
    sizes.iter().map(file).collect()
}

/// Prepares files, and the text of the options.
fn prepare(json: &str, sizes: &[(u32, u32)]) -> Result<Prepared, OptionsError> {
    let options: Options = serde_json::from_str(json).unwrap();
    let subject = Subject {
        title: "a.svg".to_owned(),
        sources: files(sizes),
    };
    let subject = match Subject::of_text(&options.what) {
        Some(text) if sizes.is_empty() => text,
        Some(text) => subject.and(text),
        None => subject,
    };
    let asked = DrawingRequest::new(options, subject, &Materials::built_in())?;
    asked.prepare(None, -40.0).map(|done| done.0)
}

fn strokes(prepared: &Prepared) -> Vec<Stroke> {
    prepared.wanted()
}

/// Width and height of ink on the paper, for a person behind the arm.
fn size(strokes: &[Stroke]) -> [f64; 2] {
    let ink = bounds_of_strokes(strokes);
    [ink.height(), ink.width()]
}

fn warnings(prepared: &Prepared) -> Vec<String> {
    prepared.warnings.iter().map(ToString::to_string).collect()
}

/// The ink of letters: everything but the longest strokes.
fn letters(prepared: &Prepared, longer_than_mm: f64) -> Rect {
    let strokes = strokes(prepared);
    let letters = strokes
        .iter()
        .filter(|stroke| stroke.length_mm() < longer_than_mm);
    bounds(letters.flat_map(|stroke| stroke.points.iter().copied()))
}

#[test]
fn a_text_has_the_requested_height_or_is_refused_with_the_height_that_fits() {
    let asked = |height: f64, place: &str| {
        let json = format!(
            r#"{{"what": {{"text": "HHHHHHHHHH", "height": {height}}}, "place": {place}}}"#
        );
        prepare(&json, &[])
    };
    for (height, place) in [
        (8.0, "{}"),
        (12.0, r#"{"paper_size": "a4", "landscape": true}"#),
        (4.0, r#"{"grid": "2x3"}"#),
    ] {
        let prepared = asked(height, place).unwrap();
        let tallest = strokes(&prepared)
            .into_iter()
            .map(|stroke| size(&[stroke])[1]);
        let tallest_mm = tallest.fold(0.0, f64::max);
        assert!((tallest_mm - height).abs() < 0.05, "{tallest_mm}");
        assert_eq!(warnings(&prepared), [""; 0]);
    }
    for place in [
        "{}",
        r#"{"paper_size": "a6", "clip": true}"#,
        r#"{"grid": "3x1"}"#,
    ] {
        let message = asked(200.0, place).unwrap_err().to_string();
        let most = message.split_once("they may be ").unwrap().1;
        let most: f64 = most.split_once(" mm").unwrap().0.parse().unwrap();
        assert!(
            message.starts_with("the text does not fit in letters of 200 mm"),
            "{message}"
        );
        asked(most, place).unwrap();
        asked(most * 1.1, place).unwrap_err();
    }
    for other in ["fit\": true", "scale\": 2"] {
        let message = asked(10.0, &format!("{{\"{other}}}"))
            .unwrap_err()
            .to_string();
        let other = other.split('"').next().unwrap();
        assert_eq!(
            message,
            format!("what.height and place.{other} exclude each other; use only one")
        );
    }
}

#[test]
fn a_text_below_a_drawing_keeps_its_requested_height_however_the_drawing_is_scaled() {
    for (place, what) in [
        (r#"{"fit": true}"#, r#""height": 6"#),
        (r#"{"scale": 0.5}"#, r#""height": 6"#),
        (
            r#"{"paper_size": "a5", "landscape": true, "fit": true}"#,
            r#""height": 6, "align": "right""#,
        ),
    ] {
        let json = format!(r#"{{"what": {{"text": "HH", {what}}}, "place": {place}}}"#);
        for file in [(30, 10), (300, 200), (10, 400)] {
            let prepared = prepare(&json, &[file]);
            let Ok(prepared) = prepared else {
                assert_eq!(file, (10, 400), "only that is too tall: {prepared:?}");
                continue;
            };
            let letters = letters(&prepared, 7.0);
            assert!(
                (letters.width() - 6.0).abs() < 0.05,
                "{place} {file:?}: {letters:?}"
            );
        }
    }
    // Without one it is scaled with the drawing.
    let json = r#"{"what": {"text": "HH"}, "place": {"scale": 0.5}}"#;
    let letters = letters(&prepare(json, &[(60, 20)]).unwrap(), 7.0);
    assert!((letters.width() - 5.0).abs() < 0.05, "{letters:?}");
    let message = |text: &str| {
        let json =
            format!(r#"{{"what": {{"text": "{text}", "height": 90}}, "place": {{"fit": true}}}}"#);
        prepare(&json, &[(60, 20)]).unwrap_err().to_string()
    };
    let word = message("HHHHHHHHHHHH");
    assert!(
        word.starts_with("the text does not fit in letters of 90 mm"),
        "{word}"
    );
    assert!(word.ends_with("mm high; make it shorter"), "{word}");
    let words = message("HHHHHH HHHHHH");
    assert!(
        words.ends_with("mm high; wrap it with what.wrap, or make it shorter"),
        "{words}"
    );
}

#[test]
fn a_drawing_that_is_scaled_down_unasked_is_reported_with_its_scale() {
    let warning = |json: &str, sizes: &[(u32, u32)]| warnings(&prepare(json, sizes).unwrap());
    let large = [(800, 100)];
    let found = warning("{}", &large);
    assert_eq!(found.len(), 1);
    assert!(
        found[0].starts_with("1 drawing: scaled down to 4"),
        "{found:?}"
    );
    assert!(
        found[0].ends_with(" % to fit; place.scale 1 keeps its size"),
        "{found:?}"
    );
    let found = warning(
        r#"{"place": {"paper_size": "a5", "landscape": true}}"#,
        &[(420, 296)],
    );
    assert_eq!(
        found,
        ["1 drawing: scaled down to 50.0 % to fit; place.scale 1 keeps its size"]
    );
    let text = format!(r#"{{"what": {{"text": "{}"}}}}"#, "H ".repeat(60));
    let found = warning(&text, &[]);
    assert!(
        found[0].contains("what.wrap breaks long lines"),
        "{found:?}"
    );
    for (json, sizes) in [
        (r#"{"place": {"fit": true}}"#, &large[..]),
        (r#"{"place": {"scale": 0.1}}"#, &large),
        ("{}", &[(60, 40)]),
    ] {
        assert_eq!(warning(json, sizes), [""; 0], "{json}");
    }
}

#[test]
fn a_text_is_wrapped_at_the_margins_of_its_sheet_or_where_requested() {
    let words = "HH HHH HHH HH HHHH HH HHH HHHHH HHH HH HH HHH HHH";
    let ink = |more: &str, place: &str| {
        let json =
            format!(r#"{{"what": {{"text": "{words}", "height": 6{more}}}, "place": {place}}}"#);
        size(&strokes(&prepare(&json, &[]).unwrap()))
    };
    let [wide, high] = ink("", r#"{"paper_size": "210x120", "margin": 40}"#);
    assert!(
        (100.0..=130.0).contains(&wide) && high > 20.0,
        "{wide} {high}"
    );
    // Justified lines fill the width but for the space beside the first and the last letter.
    let [wide, _] = ink(
        r#", "justify": true"#,
        r#"{"paper_size": "210x120", "margin": 40}"#,
    );
    assert!((126.0..=130.0).contains(&wide), "{wide}");
    let [wide, _] = ink(r#", "wrap": 80"#, "{}");
    assert!((60.0..=80.0).contains(&wide), "{wide}");
    let [high, wide] = ink(
        "",
        r#"{"paper_size": "120x180", "margin": 5, "rotate": 90, "clip": true}"#,
    );
    assert!(
        (140.0..=170.0).contains(&wide) && high > 14.0,
        "{wide} {high}"
    );
    let refused = |json: &str| prepare(json, &[]).unwrap_err().to_string();
    assert_eq!(
        refused(r#"{"what": {"text": "H", "justify": true}}"#),
        "what.justify has no effect without what.wrap or place.paper_size"
    );
    assert_eq!(
        refused(r#"{"what": {"text": "H", "wrap": 50, "justify": true, "align": "right"}}"#),
        "what.justify and what.align exclude each other; use only one"
    );
}

#[test]
fn each_file_is_fitted_to_its_cell_of_a_grid() {
    let sizes = [(10, 40), (200, 100), (30, 30)];
    let json = r#"{"place": {"grid": "3x1", "fit": true, "gap": 10}}"#;
    let mut lines = strokes(&prepare(json, &sizes).unwrap());
    // From left to right, which is -Y.
    lines.sort_by(|a, b| b.points[0].y.total_cmp(&a.points[0].y));
    let found: Vec<[f64; 2]> = lines
        .iter()
        .map(|line| size(std::slice::from_ref(line)))
        .collect();
    // Three cells of 60 x 120 mm.
    for ([width, height], expected) in found
        .iter()
        .zip([[30.0, 120.0], [60.0, 30.0], [60.0, 60.0]])
    {
        let off = (width - expected[0])
            .abs()
            .max((height - expected[1]).abs());
        assert!(off < 0.05, "{found:?}");
    }
    let whole = size(&lines);
    assert!(
        whole[0] <= 200.0 + 1e-6 && whole[1] <= 120.0 + 1e-6,
        "{whole:?}"
    );
    // On a sheet that is turned, the cells are those of the sheet.
    let json = r#"{"place": {"grid": "2x1", "fit": true, "gap": 0, "rotate": 90, "paper_size": "100x160", "margin": 10}}"#;
    let turned = strokes(&prepare(json, &[(70, 80), (10, 80)]).unwrap());
    let widest = turned.iter().map(|line| size(std::slice::from_ref(line)));
    assert!(
        widest
            .clone()
            .all(|[width, height]| width <= 80.01 && height <= 70.01),
        "{turned:?}"
    );
    assert!(
        widest.into_iter().any(|[width, _]| width > 79.9),
        "{turned:?}"
    );
    let json = r#"{"place": {"grid": "60x1", "fit": true}}"#;
    let message = prepare(json, &sizes).unwrap_err().to_string();
    assert!(message.contains("place.gap"), "{message}");
}

#[test]
fn a_sheet_with_border_and_signature_is_drawn_within_its_margin() {
    let json = r#"{"place": {"paper_size": "150x100", "margin": 10, "fit": true, "border": true, "crop_marks": true, "sign": "Hugo 漢"}}"#;
    let prepared = prepare(json, &[(60, 40)]).unwrap();
    let [width, height] = size(&strokes(&prepared));
    assert!(
        (width - 130.0).abs() < 0.01 && (height - 80.0).abs() < 0.01,
        "{width} {height}"
    );
    assert_eq!(
        warnings(&prepared),
        [
            "place.sign: 1 character: not in the script letters, left out: \"漢\"; use an installed font with --font"
        ]
    );
    let refused = |json: &str| prepare(json, &[(60, 40)]).unwrap_err().to_string();
    let message =
        refused(r#"{"place": {"paper_size": "20x20", "border": true, "crop_marks": true}}"#);
    assert!(
        message.starts_with("border, crop marks and signature take 24.0 x 24.0 mm"),
        "{message}"
    );
    assert_eq!(
        refused(r#"{"place": {"sign": " "}}"#),
        "place.sign: nothing to draw: the text is empty"
    );
}

#[test]
fn the_hint_for_a_drawing_that_does_not_fit_is_the_option_with_which_it_does() {
    let hint = |json: &str, file: (u32, u32)| {
        let error = prepare(json, &[file]).unwrap_err();
        assert_eq!(error.field(), None);
        error.hint().unwrap()
    };
    // An A5 sheet is out of reach at its upper corners, unless it lies on its side.
    let upright = r#"{"place": {"paper_size": "a5", "fit": true}}"#;
    assert_eq!(
        hint(upright, (60, 80)),
        "use `place.landscape`; then it fits"
    );
    prepare(
        r#"{"place": {"paper_size": "a5", "fit": true, "landscape": true}}"#,
        &[(60, 80)],
    )
    .unwrap();
    // A long drawing beyond a narrow sheet fits along its longer side.
    let narrow = r#"{"place": {"paper_size": "100x150", "paper": [300, 50, -40, 300, -50, -40, 310, 0, -40], "scale": 1}}"#;
    assert_ne!(
        hint(narrow, (140, 20)),
        "use `place.landscape`; then it fits"
    );
    let beyond = r#"{"place": {"paper_size": "60x120", "at": [220, 0], "scale": 1}}"#;
    assert_eq!(
        hint(beyond, (110, 20)),
        "use `place.landscape`; then it fits"
    );
    let beyond = r#"{"place": {"paper_size": "120x60", "at": [220, 0], "scale": 1}}"#;
    assert_eq!(
        hint(beyond, (20, 110)),
        "use `place.rotate 90`; then it fits"
    );
    assert_eq!(
        hint(beyond, (300, 200)),
        "use `place.fit` instead of `place.scale`; then it fits"
    );
    // No other option helps a drawing that is centred out of reach.
    let away = r#"{"place": {"at": [330, 0]}}"#;
    assert_eq!(
        hint(away, (60, 60)),
        "use `place.clip` to draw only the part that fits"
    );
    let nowhere = r#"{"place": {"at": [900, 0]}}"#;
    assert!(hint(nowhere, (60, 60)).contains("or other heights"));
}
