//! The codes for `AxiDraw` in the labels of Inkscape layers.

use usvg::roxmltree::Node;

use super::groups::INKSCAPE;
use crate::place::printable;

/// What the label of a layer means to `AxiDraw` (its documentation, Layer Control).
///
/// ```text
///   %guides            ! 5 +S30 +H50 +D100 red
///   |                  | |   |    |    |    name
///   not drawn      pause |   |    |    delay in ms before it
///                   number   |    pen height in %
///                            speed in %
/// ```
///
/// A code counts only at the start, after the number, or right after another code; of two of a kind
/// the last.
#[derive(Debug, PartialEq)]
pub(super) enum LayerCode {
    /// It is never drawn.
    Comment,
    /// How it is drawn; by default if it has no codes.
    Control(LayerControl),
}

/// How a layer is drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct LayerControl {
    /// The label, if the arm pauses before the layer.
    pub(super) pause: Option<String>,
    /// The largest speed, in mm/s.
    pub(super) speed_mm_s: Option<f64>,
    /// Whether it has a pen height or a delay.
    pub(super) has_others: bool,
}

/// The codes of an Inkscape layer; `None` for other elements.
pub(super) fn layer_code(node: Node<'_, '_>) -> Option<LayerCode> {
    let is_layer = node.attribute((INKSCAPE, "groupmode")) == Some("layer");
    let label = node.attribute((INKSCAPE, "label")).unwrap_or_default();
    let label = label.trim();
    if !is_layer {
        return None;
    }
    if label.starts_with('%') {
        return Some(LayerCode::Comment);
    }
    let (pauses, codes) = match label.strip_prefix('!') {
        Some(codes) => (true, codes),
        None => (false, label),
    };
    let mut control = LayerControl {
        pause: pauses.then(|| printable(label)),
        ..LayerControl::default()
    };
    let mut rest = codes.trim_start_matches(|c: char| c.is_ascii_digit());
    while let Some((kind, number, after)) = code(rest) {
        match kind {
            b'S' if (1..=100).contains(&number) => {
                control.speed_mm_s = Some(f64::from(number) / 100.0 * FULL_SPEED_MM_S);
            }
            b'S' => {}
            _ => control.has_others = true,
        }
        rest = after;
    }
    Some(LayerCode::Control(control))
}

/// A code at the start of a text: its letter, its number, and the text after it.
fn code(text: &str) -> Option<(u8, u32, &str)> {
    let kind = text.strip_prefix('+')?.bytes().next()?.to_ascii_uppercase();
    let number = text.get(2..).filter(|_| b"SHD".contains(&kind))?;
    let after = number.trim_start_matches(|c: char| c.is_ascii_digit());
    let digits = &number[..number.len() - after.len()];
    Some((kind, digits.parse().ok()?, after))
}

/// The speed of 100 %: 8.6979 inches per second, in the default resolution.
const FULL_SPEED_MM_S: f64 = 8.6979 * 25.4;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use usvg::roxmltree::Document;

    use super::*;

    fn of(label: &str) -> Option<LayerCode> {
        let text = format!(
            r#"<svg xmlns:inkscape="{INKSCAPE}"><g inkscape:groupmode="layer" inkscape:label="{label}"/></svg>"#
        );
        let doc = Document::parse(&text).unwrap();
        layer_code(doc.root_element().first_element_child().unwrap())
    }

    #[test]
    fn labels_of_layers_have_codes_for_axidraw() {
        for label in ["%guides", " % guides"] {
            assert_eq!(of(label), Some(LayerCode::Comment), "{label}");
        }
        for label in [
            "red + Sea",
            "50 % red",
            "red+s30",
            "5 red +S30",
            "+S",
            "+S0",
            "+Sea",
            "",
        ] {
            let plain = LayerCode::Control(LayerControl::default());
            assert_eq!(of(label), Some(plain), "{label}");
        }
        // The label, whether it pauses, the speed in %, and whether it has other codes.
        for (label, pauses, percent, has_others) in [
            ("!red", true, None, false),
            (" ! 1 red", true, None, false),
            ("5+S30+H50red", false, Some(30.0), true),
            ("!12+s7", true, Some(7.0), false),
            ("+d100+S20+S40 red", false, Some(40.0), true),
            ("+S101+D5", false, None, true),
        ] {
            let Some(LayerCode::Control(found)) = of(label) else {
                panic!("{label}");
            };
            assert_eq!(
                found.pause,
                pauses.then(|| label.trim().to_owned()),
                "{label}"
            );
            let found_percent = found.speed_mm_s.map(|mm_s| (mm_s / 2.20927).round());
            assert_eq!(found_percent, percent, "{label}");
            assert_eq!(found.has_others, has_others, "{label}");
        }
    }
}
