use super::*;

/// The lines of a page with a style sheet in two groups: a class, and a shape.
fn drawn(sheet: &str, shape: &str) -> usize {
    let marker = r#"<path d="M1 1H2" stroke="red"/>"#;
    let content = format!("{sheet}{marker}{shape}");
    let (strokes, _) = draw(&content);
    strokes.len() - 1
}

fn layers_of(content: &str) -> Vec<String> {
    let (artwork, _) = super::super::draw(
        &page(content),
        &options(),
        &super::super::Substitutes::default(),
    )
    .unwrap();
    artwork.layers.into_iter().map(|layer| layer.name).collect()
}

#[test]
fn words_and_names_of_styles_are_read_in_any_case() {
    for style in [
        r#"style="STROKE:red""#,
        r#"style="stroke:RED""#,
        r#"stroke="RED""#,
        r#"style="color:red;stroke:currentcolor""#,
        r#"color="red" stroke="currentcolor""#,
        r#"color="red" stroke="CURRENTCOLOR""#,
        r#"style="stroke:Rgb(255 0 0)""#,
        r#"style="stroke:#F00""#,
        r#"style="Stroke-Width:2PX;stroke:red""#,
    ] {
        let content = format!(r#"<path d="M0 10H50" fill="NONE" {style}/>"#);
        assert_eq!(layers_of(&content), ["red"], "{style}");
    }
    let hidden = r#"<path d="M0 10H50" stroke="red" style="DISPLAY:none"/>"#;
    assert_eq!(drawn("", hidden), 0);
    let hidden = hidden.replace("DISPLAY:none", "visibility:HIDDEN");
    assert_eq!(drawn("", &hidden), 0);
}

#[test]
fn colours_are_those_of_a_light_screen() {
    for (color, name) in [
        ("rebeccapurple", "#663399"),
        ("CanvasText", "black"),
        ("LinkText", "#0000ee"),
        ("light-dark(red, blue)", "red"),
        ("color-mix(in srgb, red, blue)", "purple"),
        ("color-mix(in srgb, red 0%, blue)", "blue"),
        ("hsl(120deg 100% 50%)", "lime"),
        ("color(display-p3 1 0 0)", "red"),
        ("rgb(from red r g b)", "red"),
    ] {
        let content = format!(r#"<path d="M0 10H50" style="stroke:{color}"/>"#);
        assert_eq!(layers_of(&content), [name], "{color}");
    }
}

#[test]
fn an_invalid_value_is_ignored_and_one_before_it_counts() {
    for style in [
        r#"style="stroke:red;stroke:nonsense""#,
        r#"stroke="red" style="stroke:abc""#,
        r#"style="stroke:red;stroke:#12""#,
        r#"style="stroke:red;stroke-width:2;stroke-width:-3""#,
        r#"style="stroke:red;stroke-linejoin:arcs""#,
        r#"style="stroke:red;display:nowhere""#,
        r#"style="stroke:red;stroke-dasharray:5,,5""#,
        r#"style="stroke:red;stroke-width:2 3""#,
        r#"style="stroke:red;visibility:hidden!wichtig""#,
    ] {
        let content = format!(r#"<path d="M0 10H50" {style}/>"#);
        let (_, warnings) = draw(&content);
        assert_eq!(layers_of(&content), ["red"], "{style}");
        assert!(
            warnings[0]
                .to_string()
                .contains("1 style value: ignored, because"),
            "{style}: {warnings:?}"
        );
    }
    let group = r#"<g stroke="red"><path d="M0 10H50" stroke="nonsense"/></g>"#;
    assert_eq!(layers_of(group), ["red"]);
    let unknown = r#"<path d="M0 10H50" stroke="red" style="-inkscape-stroke:none;zoom:2"/>"#;
    assert_eq!(draw(unknown).1, []);
}

#[test]
fn attributes_of_other_elements_are_not_styles() {
    let line = r#"<path d="M0 10H50" stroke="red">"#;
    let other = r#"<animate attributeName="d" fill="freeze" dur="1s"/></path><a xmlns="urn:a" fill="odd" opacity="much"/>"#;
    assert_eq!(draw(&format!("{line}{other}")).1, []);
}

#[test]
fn the_words_for_inherited_and_initial_values_are_read() {
    for (style, name) in [
        ("stroke:inherit", "blue"),
        ("stroke:unset", "blue"),
        ("stroke:REVERT", "blue"),
        ("stroke:initial;fill:red", "red"),
        ("stroke:var(--none)", "blue"),
    ] {
        let content = format!(
            r#"<g stroke="blue"><path d="M0 10H50V20Z" fill="none" stroke="lime" style="{style}"/></g>"#
        );
        assert_eq!(layers_of(&content), [name], "{style}");
    }
    let own = r#"<g opacity="0.5" display="inline"><path d="M0 9H50" stroke="red" style="opacity:unset;display:initial"/></g>"#;
    assert_eq!(drawn("", own), 1);
}

#[test]
fn important_declarations_win_in_sheets_and_in_styles() {
    for (sheet, style, name) in [
        ("path{stroke:red !important}", "stroke:blue", "red"),
        ("path{stroke:red ! IMPORTANT}", "stroke:blue", "red"),
        (
            "path{stroke:red !important}",
            "stroke:blue !important",
            "blue",
        ),
        (".a{stroke:red!important} #b{stroke:lime}", "", "red"),
        ("", "stroke:red !important;stroke:blue", "red"),
        (
            "@layer a{.a{stroke:red!important}} .a{stroke:lime!important}",
            "",
            "red",
        ),
        ("@layer a{#b{stroke:red}} .a{stroke:lime}", "", "lime"),
        (
            "@layer b, a; @layer a{.a{stroke:red}} @layer b{.a{stroke:lime}}",
            "",
            "red",
        ),
        (".a.a{stroke:red} .a{stroke:lime}", "", "red"),
    ] {
        let content = format!(
            r#"<style>{sheet}</style><path id="b" class="a" d="M0 10H50" style="{style}"/>"#
        );
        assert_eq!(layers_of(&content), [name], "{sheet} {style}");
    }
}

#[test]
fn only_sheets_for_a_light_screen_are_read() {
    let sheet = |attributes: &str| format!("<style {attributes}>.a{{stroke:red}}</style>");
    let line = r#"<path class="a" d="M0 10H50"/>"#;
    for attributes in [
        "",
        r#"type="""#,
        r#"type="TEXT/CSS""#,
        r#"media="""#,
        r#"media="screen and (min-width: 1px)""#,
        r#"media="print, screen""#,
        r#"media="NOT print""#,
    ] {
        assert_eq!(drawn(&sheet(attributes), line), 1, "{attributes}");
    }
    for attributes in [
        r#"media="print""#,
        r#"media="not screen""#,
        r#"type="text/less""#,
        r#"media="(prefers-color-scheme: dark)""#,
        r#"media="(odd)""#,
    ] {
        assert_eq!(drawn(&sheet(attributes), line), 0, "{attributes}");
    }
}

#[test]
fn rules_apply_if_their_conditions_hold_on_a_light_screen() {
    for (condition, applies) in [
        ("@media (min-width:1px)", true),
        ("@media (min-width:99999px)", false),
        ("@media (prefers-color-scheme:light)", true),
        ("@media (prefers-color-scheme:dark)", false),
        ("@media not all and (prefers-color-scheme:dark)", true),
        ("@media not (prefers-color-scheme:dark)", true),
        ("@media screen and (max-width:1px), screen", true),
        ("@media (width > 100px)", true),
        ("@media (100px <= width < 200px)", false),
        ("@media (min-width:1px) and (not (hover:none))", true),
        ("@media (prefers-reduced-motion)", false),
        ("@media print", false),
        ("@media only screen", true),
        ("@supports (fill:red)", true),
        ("@supports not (fill:red)", false),
        ("@supports (grid-area:a)", false),
        ("@supports (fill:nonsense) or (stroke:red)", true),
        ("@layer x", true),
    ] {
        let sheet = format!("<style>{condition}{{.a{{stroke:red}}}}</style>");
        let sheet = sheet.replace("<=", "&lt;=").replace("< 2", "&lt; 2");
        let found = drawn(&sheet, r#"<path class="a" d="M0 10H50"/>"#);
        assert_eq!(found, usize::from(applies), "{condition}");
    }
}

#[test]
fn selectors_are_those_of_a_browser() {
    for (selector, is_match) in [
        ("path:is(.b, .a)", true),
        (":where(#p)", true),
        ("g > path:not(.b)", true),
        ("g:has(.a) path", true),
        ("rect ~ path", true),
        ("path:nth-child(2 of path)", false),
        ("path:last-child", true),
        ("[class='A' i]", true),
        (".a:hover", false),
        ("path::before", false),
        (":root path", true),
        ("PATH", false),
        ("*|path", true),
    ] {
        let sheet = format!(
            "<style>{}{{stroke:red}}</style>",
            selector.replace('>', "&gt;")
        );
        let shape = r#"<g><rect/><path id="p" class="a" d="M0 10H50"/></g>"#;
        assert_eq!(drawn(&sheet, shape), usize::from(is_match), "{selector}");
    }
    for nested in [
        "g { .a { stroke:red } }",
        "g { &amp; &gt; path { stroke:red } }",
        "g { fill:none; @media screen { .a { stroke:red } } }",
        "@namespace s 'http://www.w3.org/2000/svg'; s|path { stroke:red }",
        ".b, .a { stroke:red }",
    ] {
        let sheet = format!("<style>{nested}</style>");
        let shape = r#"<g><path class="a" d="M0 10H50"/></g>"#;
        assert_eq!(drawn(&sheet, shape), 1, "{nested}");
    }
}

#[test]
fn custom_properties_are_inherited_and_have_fallbacks() {
    for (style, name) in [
        ("stroke:var(--c)", "blue"),
        ("stroke:var(--no, red)", "red"),
        ("stroke:var(--no, var(--c))", "blue"),
        ("--c:red;stroke:var(--c)", "red"),
        ("stroke:rgb(var(--r) 0 0)", "red"),
        ("stroke:VAR(--c)", "blue"),
        ("--x:var(--y);--y:var(--x);stroke:var(--x, red)", "red"),
    ] {
        let content =
            format!(r#"<g style="--c:blue;--r:255"><path d="M0 10H50" style="{style}"/></g>"#);
        assert_eq!(layers_of(&content), [name], "{style}");
    }
}

#[test]
fn geometry_and_transforms_of_styles_are_drawn() {
    for (shape, like) in [
        (
            r#"<circle style="cx:20px;cy:20px;r:5px" fill="red"/>"#,
            r#"<circle cx="20" cy="20" r="5" fill="red"/>"#,
        ),
        (
            r#"<circle cx="9" style="cx:20;cy:20;r:5" fill="red"/>"#,
            r#"<circle cx="20" cy="20" r="5" fill="red"/>"#,
        ),
        (
            r#"<rect style="x:5px;y:6px;width:10px;height:11px;rx:2px" fill="red"/>"#,
            r#"<rect x="5" y="6" width="10" height="11" rx="2" fill="red"/>"#,
        ),
        (
            r#"<path style="d:path('M5 5H50')" stroke="red"/>"#,
            r#"<path d="M5 5H50" stroke="red"/>"#,
        ),
        (
            r#"<path d="M5 5H9" style="transform:translate(5px, 6px) rotate(0.25turn)" stroke="red"/>"#,
            r#"<path d="M5 5H9" transform="translate(5 6) rotate(90)" stroke="red"/>"#,
        ),
        (
            r#"<path d="M5 5H9" style="transform:scale(2);transform-origin:5px 5px" stroke="red"/>"#,
            r#"<path d="M5 5H13" stroke="red"/>"#,
        ),
        (
            r#"<path d="M5 5H9" style="translate:5px 6px;scale:200%" stroke="red"/>"#,
            r#"<path d="M15 16H23" stroke="red"/>"#,
        ),
        (
            r#"<rect style="width:calc(1px + 9px);height:min(10px, 20px)" fill="red"/>"#,
            r#"<rect width="10" height="10" fill="red"/>"#,
        ),
        (
            r#"<path d="M5 5H9" style="marker:none;stroke:red"/>"#,
            r#"<path d="M5 5H9" stroke="red"/>"#,
        ),
    ] {
        assert_eq!(draw(shape), draw(like), "{shape}");
    }
}

#[test]
fn what_styles_leave_out_is_reported_with_its_count() {
    for (content, reported) in [
        (
            r##"<use href="#nowhere"/>"##,
            "1 copy: (use) of an element that the file does not have",
        ),
        (
            r#"<path d="M0 0H9" stroke="red" style="stroke-width:0"/>"#,
            "1 line of width 0: left out",
        ),
        (
            r#"<g stroke-width="0"><path d="M0 0H9" stroke="red"/><path d="M0 0H9" stroke="red"/></g>"#,
            "2 line of width 0",
        ),
        (
            "<style>@import 'a.css'; @import url(b.css);</style>",
            "2 style sheets: in another file",
        ),
        (
            "<style>a b c:unknown { fill:red } @container (width > 1px) { a { fill:red } }</style>",
            "2 CSS rules: ignored",
        ),
    ] {
        let line = r#"<path d="M10 10H90" stroke="red"/>"#;
        let (strokes, warnings) = draw(&format!("{content}{line}"));
        assert_eq!(strokes.len(), 1, "{content}");
        assert_eq!(warnings.len(), 1, "{content}: {warnings:?}");
        assert!(warnings[0].to_string().contains(reported), "{warnings:?}");
    }
    let text = format!(
        "<?xml-stylesheet href='a.css'?>{}",
        page(r#"<path d="M0 0H9" stroke="red"/>"#)
    );
    let (_, warnings) = Drawing::from_svg(&text, &options()).unwrap();
    assert!(
        warnings[0]
            .to_string()
            .contains("1 style sheet: in another file")
    );
}

#[test]
fn hostile_styles_end_with_an_error_or_a_drawing() {
    let siblings = "<g/>".repeat(3_000);
    let slow = format!(
        "<style>.no ~ g, g:has(~ .no), :not(g:nth-last-child(3 of .no)) + g {{fill:red}}</style>{siblings}"
    );
    assert!(error(&page(&slow)).contains("the styles (CSS) take too long to read"));
    let deep = "calc(".repeat(100_000);
    let line = |style: &str| format!(r#"<path d="M10 10H90" stroke="red" style="{style}"/>"#);
    assert_eq!(draw(&line(&format!("stroke-width:{deep}"))).0.len(), 1);
    let many = "fill:red;".repeat(100_000);
    assert_eq!(draw(&line(&many)).0.len(), 1);
}

#[test]
fn what_is_ignored_is_reported_with_its_first_place() {
    let places = |content: &str| -> Vec<(u32, String)> {
        let (_, warnings) = draw(&format!("<path d='M0 0H9' stroke='red'/>\n{content}"));
        let mut places: Vec<(u32, String)> = warnings
            .into_iter()
            .map(|warning| {
                let what = warning.what.split(':').next().unwrap().to_owned();
                (warning.place.map_or(0, |place| place.line), what)
            })
            .collect();
        places.sort();
        places
    };
    let found = places(
        "<path d='M0 1H9' stroke='nonsense'/>\n<g style='fill:nonsense'/>\n<style>a:odd{fill:red} a{fill:nonsense} @import 'a.css';</style>\n<use href='#no'/>\n<use href='a.svg#b'/>\n<path d='M0 1H9 x' stroke='red'/>\n<path d='M0 0H9' stroke='red' stroke-width='0'/>",
    );
    let wanted = [
        (2, "style value"),
        (4, "CSS rule"),
        (4, "style sheet"),
        (5, "copy"),
        (6, "shape"),
        (7, "invalid path"),
        (8, "line of width 0"),
    ];
    let wanted: Vec<_> = wanted.map(|(line, what)| (line, what.to_owned())).into();
    assert_eq!(found, wanted);
}
