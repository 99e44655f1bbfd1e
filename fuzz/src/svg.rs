use dobot_import::Source;

/// SVG of any kind: an error, or ink on the file's page, but never a panic.
pub fn svg(input: &[u8]) {
    let text = crate::spelled(input, WORDS);
    let mut text = String::from_utf8_lossy(&text).into_owned();
    // Most of what is spelled is inside a page, so that it is looked at.
    if input.first().is_some_and(|kind| kind % 4 == 1) {
        text = format!("{BEGIN}{text}</svg>");
    }
    if let Some(artwork) = crate::read(&Source::Svg(text)) {
        crate::lies_on(&artwork, [artwork.width_mm, artwork.height_mm]);
    }
}

const BEGIN: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" \
    xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"40mm\" height=\"30mm\" \
    viewBox=\"0 0 40 30\">";

const WORDS: &[&str] = &[
    "<g ",
    "</g>",
    "<path d=\"",
    "<path stroke=\"red\" fill=\"none\" d=\"",
    "<rect width=\"9\" height=\"7\" ",
    "<circle r=\"8\" ",
    "<ellipse rx=\"5\" ry=\"1e-9\" ",
    "<line x2=\"20\" y2=\"20\" stroke=\"#00f\" ",
    "<polygon points=\"0,0 9,0 9,9\" ",
    "<polyline points=\"",
    "<use href=\"#a\" ",
    "<use xlink:href=\"#b\" x=\"3\" ",
    "<symbol id=\"b\" viewBox=\"0 0 1 1\">",
    "</symbol>",
    "<defs>",
    "</defs>",
    "<clipPath id=\"c\">",
    "</clipPath>",
    "<mask id=\"m\">",
    "</mask>",
    "<marker id=\"k\" markerWidth=\"3\" markerHeight=\"3\">",
    "</marker>",
    "<pattern id=\"p\" width=\"1\" height=\"1\">",
    "</pattern>",
    "<style>",
    "</style>",
    "<switch>",
    "</switch>",
    "<text x=\"1\">a</text>",
    "<image href=\"data:image/png;base64,\"/>",
    "<svg x=\"2\" width=\"50%\" viewBox=\"-9 -9 18 18\" ",
    "</svg>",
    "/>",
    ">",
    "\"",
    " id=\"a\" ",
    " clip-path=\"url(#c)\" ",
    " mask=\"url(#m)\" ",
    " marker-end=\"url(#k)\" ",
    " fill=\"url(#p)\" ",
    " fill=\"black\" ",
    " stroke=\"black\" ",
    " stroke-width=\"3\" ",
    " stroke-dasharray=\"1 2\" ",
    " stroke-dasharray=\"1e-9 0\" ",
    " stroke-dashoffset=\"-1e9\" ",
    " fill-rule=\"evenodd\" ",
    " opacity=\"0\" ",
    " display=\"none\" ",
    " transform=\"rotate(30)\" ",
    " transform=\"scale(1e9)\" ",
    " transform=\"scale(0)\" ",
    " transform=\"matrix(1 2 3 4 5 6)\" ",
    " transform=\"skewX(90)\" ",
    " style=\"stroke:red;fill:none\" ",
    " preserveAspectRatio=\"none\" ",
    ".s{stroke:red}",
    " class=\"s\" ",
    "M0 0",
    "M10 10",
    "L30 5",
    "H1e6",
    "v-9",
    "C0 20 20 20 20 0",
    "S9 9 8 8",
    "Q5 9 10 0",
    "t1 1",
    "A9 3 40 1 0 20 20",
    "a1e-6 1e6 0 0 1 1 1",
    "Z",
    " ",
    ",",
    "-",
    ".",
    "1",
    "5",
    "1e38",
    "1e-38",
    "NaN",
    "&amp;",
    "&#x41;",
    "<!-- ",
    " -->",
    "<![CDATA[",
    "]]>",
    "<!DOCTYPE svg [<!ENTITY e \"M0 0\">]>",
    "&e;",
    "\n",
];
