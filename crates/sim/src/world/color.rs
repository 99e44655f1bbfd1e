//! Colours by name.

/// The colour as `#rrggbb`, from its name or from that very form.
pub(crate) fn color(text: &str) -> Option<String> {
    if let Some((_, hex)) = NAMED.iter().find(|(name, _)| *name == text) {
        return Some((*hex).to_owned());
    }
    let digits = text.strip_prefix('#')?;
    let hex = digits.len() == 6 && digits.bytes().all(|it| it.is_ascii_hexdigit());
    hex.then(|| text.to_ascii_lowercase())
}

/// The names, for error texts.
pub(crate) fn names() -> String {
    NAMED.map(|(name, _)| name).join(", ")
}

/// Calm ones, which look well beside each other on paper.
const NAMED: [(&str, &str); 13] = [
    ("black", "#2b2d33"),
    ("blue", "#3f7cb8"),
    ("brown", "#8a6244"),
    ("gray", "#8d969c"),
    ("green", "#4f9d69"),
    ("navy", "#1b2a41"),
    ("orange", "#e58a3c"),
    ("pink", "#dd86a4"),
    ("purple", "#7f62a8"),
    ("red", "#cf4c44"),
    ("teal", "#35948f"),
    ("white", "#fbfaf6"),
    ("yellow", "#ecc246"),
];
