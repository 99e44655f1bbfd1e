//! The properties that change a drawing, and their values.

use std::borrow::Cow;

use super::value;

/// A property.
#[derive(Debug)]
pub(super) struct Property {
    pub(super) name: &'static str,
    /// Whether elements inherit it.
    pub(super) inherits: bool,
    initial: &'static str,
    pub(super) grammar: Grammar,
    /// The elements that have it; all if empty.
    elements: &'static [&'static str],
}

/// The form of the values of a property.
#[derive(Clone, Copy, Debug)]
pub(super) enum Grammar {
    /// A colour, a reference, or nothing.
    Paint,
    Color,
    /// A number from 0 to 1, or a percentage.
    Share,
    /// A number of 0 or more.
    Number,
    /// A length, with or without a unit, and whether it may be below 0.
    Length {
        below_zero: bool,
    },
    /// Lengths of dashes.
    Dashes,
    /// One of these words.
    Words(&'static [&'static str]),
    /// A length or one of these words.
    LengthOr(&'static [&'static str]),
    /// A list of fonts.
    Fonts,
    /// A list of transforms.
    Transform,
    /// One or two lengths, as `translate` has them.
    Moves,
    /// An angle, as `rotate` has it.
    Turn,
    /// One or two factors, as `scale` has them.
    Factors,
    /// `path("...")`.
    Path,
    /// Anything else; the library reads it.
    Any,
}

impl Property {
    /// The property of this name, in any case.
    pub(super) fn of(name: &str) -> Option<&'static Self> {
        let found = |property: &&Self| property.name.eq_ignore_ascii_case(name);
        PROPERTIES.iter().find(found)
    }

    /// Whether it applies to elements of this name.
    pub(super) fn is_of(&self, element: &str) -> bool {
        self.elements.is_empty() || self.elements.contains(&element)
    }

    /// Whether an attribute of its name is written in the words of CSS; geometry is not.
    pub(super) fn is_presentation(&self) -> bool {
        use Grammar as G;
        let is_transform = matches!(self.grammar, G::Transform | G::Moves | G::Turn | G::Factors);
        self.elements.is_empty() && !is_transform
    }

    /// A value in the words of the library; `None` if it is invalid.
    pub(super) fn value<'i>(&self, text: &'i str) -> Option<Cow<'i, str>> {
        let text = text.trim();
        match text.to_ascii_lowercase().as_str() {
            "inherit" => Some("inherit".into()),
            "initial" => Some(self.initial.into()),
            "unset" | "revert" | "revert-layer" => Some(self.unset().into()),
            _ => value::value(self.grammar, text),
        }
    }

    /// Its value on elements that do not set it.
    pub(super) const fn unset(&self) -> &'static str {
        if self.inherits {
            "inherit"
        } else {
            self.initial
        }
    }
}

const fn inherited(name: &'static str, initial: &'static str, grammar: Grammar) -> Property {
    Property {
        inherits: true,
        ..own(name, initial, grammar)
    }
}

const fn own(name: &'static str, initial: &'static str, grammar: Grammar) -> Property {
    Property {
        name,
        inherits: false,
        initial,
        grammar,
        elements: &[],
    }
}

const fn geometry(
    name: &'static str,
    initial: &'static str,
    grammar: Grammar,
    elements: &'static [&'static str],
) -> Property {
    Property {
        elements,
        ..own(name, initial, grammar)
    }
}

const BOXES: &[&str] = &["svg", "rect", "image", "foreignObject"];
const PLACED: &[&str] = &["svg", "rect", "image", "foreignObject", "use"];
const ROUND: &[&str] = &["circle", "ellipse"];
const ROUNDED: &[&str] = &["ellipse", "rect"];
const ANY_LENGTH: Grammar = Grammar::Length { below_zero: true };
const SIZE: Grammar = Grammar::Length { below_zero: false };
const RULES: Grammar = Grammar::Words(&["nonzero", "evenodd"]);
const SPACING: Grammar = Grammar::LengthOr(&["normal"]);

/// All properties that are read.
static PROPERTIES: [Property; 73] = [
    inherited("fill", "black", Grammar::Paint),
    inherited("stroke", "none", Grammar::Paint),
    inherited("stroke-width", "1", SIZE),
    inherited("fill-opacity", "1", Grammar::Share),
    inherited("stroke-opacity", "1", Grammar::Share),
    inherited("fill-rule", "nonzero", RULES),
    inherited("clip-rule", "nonzero", RULES),
    inherited(
        "stroke-linecap",
        "butt",
        Grammar::Words(&["butt", "round", "square"]),
    ),
    inherited(
        "stroke-linejoin",
        "miter",
        Grammar::Words(&["miter", "round", "bevel"]),
    ),
    inherited("stroke-miterlimit", "4", Grammar::Number),
    inherited("stroke-dasharray", "none", Grammar::Dashes),
    inherited("stroke-dashoffset", "0", ANY_LENGTH),
    inherited("color", "black", Grammar::Color),
    inherited(
        "visibility",
        "visible",
        Grammar::Words(&["visible", "hidden", "collapse"]),
    ),
    inherited("paint-order", "normal", Grammar::Any),
    inherited("marker-start", "none", Grammar::Any),
    inherited("marker-mid", "none", Grammar::Any),
    inherited("marker-end", "none", Grammar::Any),
    inherited("direction", "ltr", Grammar::Words(&["ltr", "rtl"])),
    inherited(
        "text-anchor",
        "start",
        Grammar::Words(&["start", "middle", "end"]),
    ),
    inherited("writing-mode", "horizontal-tb", Grammar::Any),
    inherited("letter-spacing", "normal", SPACING),
    inherited("word-spacing", "normal", SPACING),
    inherited("white-space", "normal", Grammar::Any),
    inherited("dominant-baseline", "auto", Grammar::Any),
    inherited("font-family", "serif", Grammar::Fonts),
    inherited("font-size", "medium", Grammar::LengthOr(FONT_SIZES)),
    inherited("font-size-adjust", "none", Grammar::Any),
    inherited("font-stretch", "normal", Grammar::Any),
    inherited("font-style", "normal", Grammar::Any),
    inherited("font-variant", "normal", Grammar::Any),
    inherited("font-weight", "normal", Grammar::Any),
    inherited("font-kerning", "auto", Grammar::Any),
    inherited("font-variation-settings", "normal", Grammar::Any),
    inherited("image-rendering", "auto", Grammar::Any),
    inherited("shape-rendering", "auto", Grammar::Any),
    inherited("text-rendering", "auto", Grammar::Any),
    inherited("color-interpolation-filters", "linearRGB", Grammar::Any),
    own("display", "inline", Grammar::Words(DISPLAYS)),
    own("opacity", "1", Grammar::Share),
    own("overflow", "visible", Grammar::Any),
    own("clip-path", "none", Grammar::Any),
    own("mask", "none", Grammar::Any),
    own(
        "mask-type",
        "luminance",
        Grammar::Words(&["luminance", "alpha"]),
    ),
    own("filter", "none", Grammar::Any),
    own("isolation", "auto", Grammar::Words(&["auto", "isolate"])),
    own("mix-blend-mode", "normal", Grammar::Any),
    own("stop-color", "black", Grammar::Color),
    own("stop-opacity", "1", Grammar::Share),
    own("flood-color", "black", Grammar::Color),
    own("flood-opacity", "1", Grammar::Share),
    own("lighting-color", "white", Grammar::Color),
    own("vector-effect", "none", Grammar::Any),
    own("text-decoration", "none", Grammar::Any),
    own("unicode-bidi", "normal", Grammar::Any),
    own("alignment-baseline", "baseline", Grammar::Any),
    own(
        "baseline-shift",
        "baseline",
        Grammar::LengthOr(&["baseline", "sub", "super"]),
    ),
    own("transform-origin", "0 0", Grammar::Any),
    own("transform-box", "view-box", Grammar::Any),
    own("transform", "none", Grammar::Transform),
    own("translate", "none", Grammar::Moves),
    own("rotate", "none", Grammar::Turn),
    own("scale", "none", Grammar::Factors),
    geometry("d", "none", Grammar::Path, &["path"]),
    geometry("x", "0", ANY_LENGTH, PLACED),
    geometry("y", "0", ANY_LENGTH, PLACED),
    geometry("cx", "0", ANY_LENGTH, ROUND),
    geometry("cy", "0", ANY_LENGTH, ROUND),
    geometry("r", "0", SIZE, &["circle"]),
    geometry("rx", "auto", Grammar::LengthOr(&["auto"]), ROUNDED),
    geometry("ry", "auto", Grammar::LengthOr(&["auto"]), ROUNDED),
    geometry("width", "auto", Grammar::LengthOr(&["auto"]), BOXES),
    geometry("height", "auto", Grammar::LengthOr(&["auto"]), BOXES),
];

const FONT_SIZES: &[&str] = &[
    "xx-small",
    "x-small",
    "small",
    "medium",
    "large",
    "x-large",
    "xx-large",
    "xxx-large",
    "smaller",
    "larger",
];
const DISPLAYS: &[&str] = &[
    "inline",
    "block",
    "none",
    "contents",
    "flex",
    "grid",
    "inline-block",
    "inline-flex",
    "inline-grid",
    "inline-table",
    "list-item",
    "table",
    "table-cell",
    "table-row",
    "flow-root",
    "run-in",
    "ruby",
    "math",
];
