//! Text properties that single-line letters do not support.

use dobot_lettering::StrokeFont;
use usvg::roxmltree::{Document, Node};

use super::css::Styles;
use super::warning_count::{WarningCount, WarningKind};
use crate::place::Place;
use crate::warning::Warning;

/// The first place of each unsupported property.
#[derive(Debug, Default)]
pub(super) struct UnreadPlaces(Vec<(WarningKind, Place)>);

impl UnreadPlaces {
    pub(super) fn of(doc: &Document<'_>, text: &str, styles: &Styles<'_>) -> Self {
        let mut properties = PROPERTIES
            .iter()
            .filter(|property| text.contains(property.1))
            .peekable();
        if properties.peek().is_none() {
            return Self::default();
        }
        let families = styles.inherited(doc, "font-family");
        let is_in_single_lines = |node: Node<'_, '_>| {
            let family = families[node.id().get_usize()];
            family.is_some_and(|family| first_font(family).is_some())
        };
        let first = |name: &str| {
            let has_it = |node: &Node<'_, '_>| {
                styles
                    .property(*node, name)
                    .is_some_and(|value| !AS_WRITTEN.contains(&value))
            };
            let mut having = doc.descendants().filter(has_it);
            // Fonts may be given in other ways.
            let any = having.clone().next();
            let node = having.find(|node| node.descendants().any(is_in_single_lines));
            Some(doc.text_pos_at(node.or(any)?.range().start).into())
        };
        Self(
            properties
                .filter_map(|message| Some((message.0, first(message.1)?)))
                .collect(),
        )
    }

    /// Notes the first place of what a warning counts.
    pub(super) fn note(&mut self, kind: WarningKind, place: Place) {
        self.0.push((kind, place));
    }

    /// Adds the place to a warning, if known.
    pub(super) fn warning(&self, count: WarningCount) -> Warning {
        let place = self.0.iter().find(|place| place.0 == count.kind);
        Warning {
            place: place.map(|place| place.1),
            ..Warning::from(count)
        }
    }
}

/// The single-line font at the start of a list of families.
fn first_font(families: &str) -> Option<StrokeFont> {
    let first = families.split(',').next()?;
    StrokeFont::of_family(first.trim().trim_matches(['"', '\'']))
}

const PROPERTIES: [(WarningKind, &str); 4] = [
    (WarningKind::LettersLength, "textLength"),
    (WarningKind::LettersDirection, "writing-mode"),
    (WarningKind::LettersBaseline, "dominant-baseline"),
    (WarningKind::LettersAlignment, "alignment-baseline"),
];
/// Values that leave letters unchanged.
const AS_WRITTEN: [&str; 13] = [
    "auto",
    "alphabetic",
    "baseline",
    "use-script",
    "no-change",
    "reset-size",
    "inherit",
    "horizontal-tb",
    "lr",
    "lr-tb",
    "rl",
    "rl-tb",
    "initial",
];
