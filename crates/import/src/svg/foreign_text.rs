//! Plain texts in `foreignObject`, as diagram programs write labels, as SVG texts.

use usvg::roxmltree::Node;

use super::css::Styles;
use super::edits::{Additions, Edit, escaped};

/// A label of plain lines as a text; `None` if it has anything else, or needs wrapping.
pub(super) fn plain_text(text: &str, node: Node<'_, '_>, styles: &Styles<'_>) -> Option<Edit> {
    let is_label = node.tag_name().name() == "foreignObject";
    // In a switch, a text for other programs follows.
    let is_alternative = node.parent_element()?.tag_name().name() == "switch";
    if !is_label || is_alternative {
        return None;
    }
    let mut label = Label::default();
    label.read(node, styles)?;
    let lines: Vec<&str> = label.lines.iter().map(|line| line.trim()).collect();
    let lines: Vec<&str> = lines.into_iter().filter(|line| !line.is_empty()).collect();
    let longest = lines.iter().map(|line| line.chars().count()).max()?;
    let length = |name: &str| {
        let value = styles.property(node, name)?;
        value
            .strip_suffix("px")
            .unwrap_or(value)
            .parse::<f64>()
            .ok()
    };
    let [width, x, y] = [
        length("width")?,
        length("x").unwrap_or(0.0),
        length("y").unwrap_or(0.0),
    ];
    let size = label.size.unwrap_or(DEFAULT_SIZE);
    if count(longest) * NARROW_EM * size > width + size {
        return None;
    }
    let (x, anchor) = if label.is_centred {
        (x + width / 2.0, "middle")
    } else {
        (x, "start")
    };
    let step = label.line_height.unwrap_or(DEFAULT_LINE) * size;
    let tag = text[node.range().start + 1..]
        .split("foreignObject")
        .next()?;
    let text_of = |(number, line): (usize, &str)| {
        let base = y + step * (count(number) + 0.5) + MIDDLE_EM * size;
        let line = escaped(line);
        format!("<{tag}tspan x=\"{x}\" y=\"{base}\">{line}</{tag}tspan>")
    };
    let spans: String = lines.into_iter().enumerate().map(text_of).collect();
    let attributes = [
        ("font-size", Some(size.to_string())),
        ("text-anchor", Some(anchor.to_owned())),
        ("fill", Some(label.color)),
        ("font-family", label.family),
        ("transform", node.attribute("transform").map(str::to_owned)),
    ];
    let mut added = Additions::default();
    for (name, value) in attributes {
        if let Some(value) = value {
            added.attribute(name, &value);
        }
    }
    let words = format!("<{tag}text{}>{spans}</{tag}text>", added.attributes());
    Some(Edit {
        range: node.range(),
        words,
    })
}

#[expect(clippy::cast_precision_loss, reason = "a short text")]
const fn count(number: usize) -> f64 {
    number as f64
}

/// The lines of a label, and how they are written.
#[derive(Debug, Default)]
struct Label {
    lines: Vec<String>,
    size: Option<f64>,
    line_height: Option<f64>,
    family: Option<String>,
    color: String,
    is_centred: bool,
}

impl Label {
    /// Adds the texts in an element; `None` if it has more than texts.
    fn read(&mut self, node: Node<'_, '_>, styles: &Styles<'_>) -> Option<()> {
        for child in node.children() {
            if let Some(text) = child.text().filter(|_| child.is_text()) {
                self.add(text, child, styles);
            }
            if !child.is_element() {
                continue;
            }
            let name = child.tag_name().name();
            if styles.property(child, "display") == Some("none") {
                continue;
            }
            let style = child
                .attribute("style")
                .unwrap_or_default()
                .replace(' ', "");
            self.is_centred |= style.contains("text-align:center")
                || child.attribute("align") == Some("center")
                || name == "center";
            let height = style
                .split("line-height:")
                .nth(1)
                .and_then(|rest| rest.split(';').next());
            self.line_height = height
                .and_then(|height| height.parse().ok())
                .or(self.line_height);
            match name {
                "br" => self.lines.push(String::new()),
                _ if BLOCKS.contains(&name) => {
                    self.lines.push(String::new());
                    self.read(child, styles)?;
                    self.lines.push(String::new());
                }
                _ if INLINE.contains(&name) => self.read(child, styles)?,
                _ => return None,
            }
        }
        Some(())
    }

    fn add(&mut self, text: &str, node: Node<'_, '_>, styles: &Styles<'_>) {
        let words: Vec<&str> = text.split_whitespace().collect();
        if words.is_empty() {
            return;
        }
        let inherited = |name: &str| {
            node.ancestors()
                .find_map(|outer| styles.property(outer, name))
        };
        let size = inherited("font-size")
            .and_then(|size| size.strip_suffix("px").unwrap_or(size).parse().ok());
        self.size = self.size.or(size);
        self.family = self
            .family
            .take()
            .or_else(|| inherited("font-family").map(str::to_owned));
        if self.color.is_empty() {
            inherited("color")
                .unwrap_or("black")
                .clone_into(&mut self.color);
        }
        if self.lines.is_empty() {
            self.lines.push(String::new());
        }
        let Some(line) = self.lines.last_mut() else {
            return;
        };
        if text.starts_with(char::is_whitespace) {
            line.push(' ');
        }
        line.push_str(&words.join(" "));
        if text.ends_with(char::is_whitespace) {
            line.push(' ');
        }
    }
}

const BLOCKS: [&str; 9] = [
    "body", "center", "div", "h1", "h2", "h3", "h4", "p", "section",
];
const INLINE: [&str; 10] = [
    "a", "b", "code", "em", "font", "i", "label", "small", "span", "strong",
];
/// The font size of a web page, in pixels.
const DEFAULT_SIZE: f64 = 16.0;
const DEFAULT_LINE: f64 = 1.2;
/// A letter of a narrow font.
const NARROW_EM: f64 = 0.4;
/// From the middle of a line of text to its base line.
const MIDDLE_EM: f64 = 0.35;
