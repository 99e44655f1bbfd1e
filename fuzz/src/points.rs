use dobot_import::Source;

/// Points in CSV and JSON: an error, or ink within the limits, but never a panic.
pub fn points(input: &[u8]) {
    let text = crate::spelled(input, WORDS);
    let text = String::from_utf8_lossy(&text).into_owned();
    crate::read(&Source::Csv(text.clone()));
    crate::read(&Source::Json(text));
}

const WORDS: &[&str] = &[
    "[",
    "]",
    "[[",
    "]]",
    "[[[",
    "]]]",
    "],[",
    "{",
    "}",
    ",",
    ":",
    ";",
    "\t",
    "\n",
    "\n\n",
    " ",
    "-",
    ".",
    "e",
    "0",
    "1",
    "2.5",
    "-9",
    "1e5",
    "1e300",
    "1e999",
    "null",
    "true",
    "false",
    "\"",
    "\"x\":",
    "\"y\":",
    "\"strokes\":[",
    "\"points\":[",
    "\"layer\":\"a\"",
    "\"color\":\"#ff0000\"",
    "\"closed\":true",
    "x,y\n",
    "x;y\n",
    "stroke,x,y\n",
    "pen,x,y\n",
    "0,0\n",
    "9,9\n",
    "[0,0]",
    "[9,9]",
    "{\"x\":1,\"y\":2}",
];
