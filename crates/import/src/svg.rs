//! The SVG reader: visible outlines as strokes, fills as areas, in true millimetres.

mod check;
mod color;
mod css;
mod declared;
mod edits;
mod entities;
mod expand;
mod flatten;
mod font;
mod groups;
mod handles;
mod ink;
mod layers;
mod letters;
mod page;
mod page_size;
mod points;
mod readable;
mod renderer;
mod selectors;
mod sheets;
mod single_line;
mod styles;
mod substitutes;
mod unread;
mod warning_count;

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use simplecss::StyleSheet;
use usvg::fontdb::Family;
use usvg::roxmltree::{Document, Node};
use usvg::{FontResolver, ImageHrefResolver, Tree};

use self::declared::{Declared, rules};
pub(crate) use self::font::SvgFont;
use self::groups::Groups;
use self::page::SvgPage;
use self::points::lone_coordinates;
use self::readable::Readable;
use self::renderer::TreeRenderer;
use self::substitutes::{Substitutes, nearest};
use self::unread::UnreadPlaces;
use self::warning_count::{WarningCount, WarningKind};
use crate::artwork::Artwork;
use crate::error::{SourceError, SvgError};
use crate::limits::{Budget, MAX_SEGMENTS, checked_tolerance_mm};
use crate::options::{LayersBy, ReadOptions};
use crate::warning::Warning;
use crate::xml::{self, malformed};

/// Reads an SVG file like a browser, at 96 dots per inch.
///
/// Every visible shape with a stroke or a fill gives its outline, dashed if its stroke is dashed,
/// and a filled one its area too; white fills count as paper. Text gives the outlines of its
/// letters. Shapes are clipped to their clip paths, and to the page if requested. Warnings describe
/// what a pen cannot show.
pub(crate) fn read(
    text: &str,
    options: &ReadOptions,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    let substitutes = Substitutes::default();
    let (artwork, mut warnings) = draw(text, options, &substitutes)?;
    warnings.extend(substitutes.warnings());
    Ok((artwork, warnings))
}

/// The width of the first text of an SVG file from its start to that of the next letter, in the
/// units of the text; 0 without a text that can be shown.
pub(crate) fn text_width(text: &str, options: &ReadOptions) -> f64 {
    let substitutes = Substitutes::default();
    let tree = parse(text, options, &TreeWarnings::new(&substitutes)).map(|parsed| parsed.0);
    let width = tree.ok().and_then(|tree| first_text_width(tree.root()));
    width.unwrap_or_default()
}

fn first_text_width(group: &usvg::Group) -> Option<f64> {
    group.children().iter().find_map(|node| match node {
        usvg::Node::Text(text) => Some(text.bounding_box().width().into()),
        usvg::Node::Group(inner) => first_text_width(inner),
        _ => None,
    })
}

/// Whether a text with this start is an SVG file, whatever its name is.
pub(crate) fn is_certain(start: &str) -> bool {
    start.starts_with("<svg") || (start.starts_with("<?xml") && start.contains("<svg"))
}

/// Whether a text with this start is an SVG file if its name does not identify it.
pub(crate) fn is_likely(start: &str) -> bool {
    start.contains("<svg") || start.starts_with("<?xml")
}

fn draw(
    text: &str,
    options: &ReadOptions,
    substitutes: &Substitutes,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    let tolerance_mm = checked_tolerance_mm(options.tolerance_mm)?;
    let tree_warnings = TreeWarnings::new(substitutes);
    let (tree, groups, facts) = parse(text, options, &tree_warnings)?;
    let mut page = SvgPage::new(renderer::page_mm(&tree), options);
    TreeRenderer::new(&mut page, tolerance_mm, &groups).tree(&tree)?;
    // It takes as much memory as the page, which may need more of it now.
    drop(tree);
    let others = page.cut().into_iter().chain(facts.lone);
    let (artwork, mut warnings) = page.finish()?;
    tree_warnings.warn(&mut warnings);
    if artwork.layers.is_empty() {
        return Err(nothing_to_draw(&warnings, others.collect()));
    }
    let warnings = warnings
        .into_iter()
        .map(|warning| facts.unread.warning(warning));
    Ok((artwork, warnings.chain(others).collect()))
}

/// Facts about the original file, collected before it is rewritten.
struct FileFacts {
    /// The warning about points without y.
    lone: Option<Warning>,
    unread: UnreadPlaces,
}

/// Counts what is lost while the tree is built.
struct TreeWarnings<'a> {
    images: AtomicUsize,
    flowed: AtomicUsize,
    foreign: AtomicUsize,
    moved: AtomicUsize,
    sized: AtomicUsize,
    clipped: AtomicUsize,
    linked: AtomicUsize,
    rules: AtomicUsize,
    unread_sizes: AtomicUsize,
    solid: AtomicUsize,
    fontless: AtomicUsize,
    missing_glyphs: AtomicUsize,
    substitutes: &'a Substitutes,
}

impl<'a> TreeWarnings<'a> {
    const fn new(substitutes: &'a Substitutes) -> Self {
        Self {
            images: AtomicUsize::new(0),
            flowed: AtomicUsize::new(0),
            foreign: AtomicUsize::new(0),
            moved: AtomicUsize::new(0),
            sized: AtomicUsize::new(0),
            clipped: AtomicUsize::new(0),
            linked: AtomicUsize::new(0),
            rules: AtomicUsize::new(0),
            unread_sizes: AtomicUsize::new(0),
            solid: AtomicUsize::new(0),
            fontless: AtomicUsize::new(0),
            missing_glyphs: AtomicUsize::new(0),
            substitutes,
        }
    }

    fn image_resolver(&self) -> ImageHrefResolver<'_> {
        ImageHrefResolver {
            resolve_data: Box::new(|_, _, _| count(&self.images)),
            resolve_string: Box::new(|_, _| count(&self.images)),
        }
    }

    /// Like a browser, takes any font rather than none.
    fn font_resolver(&self) -> FontResolver<'_> {
        let by_name = FontResolver::default_font_selector();
        let by_character = FontResolver::default_fallback_selector();
        FontResolver {
            select_font: Box::new(move |font, fonts| {
                let found = by_name(font, fonts);
                let found = found.map(|found| nearest(font, fonts, found));
                let found = found.or_else(|| fonts.faces().next().map(|face| face.id));
                match found {
                    Some(_) if single_line::font(font).is_some() => {}
                    Some(id) => self.substitutes.note(font, fonts, id),
                    None => return count(&self.fontless),
                }
                found
            }),
            select_fallback: Box::new(move |character, used, fonts| {
                by_character(character, used, fonts).or_else(|| count(&self.missing_glyphs))
            }),
        }
    }

    /// Counts what the library drops silently.
    fn note_unread(&self, doc: &Document<'_>, rules: &StyleSheet<'_>) {
        let elements = || doc.descendants().filter(Node::is_element);
        let named = |node: &Node<'_, '_>, name: &str| node.tag_name().name() == name;
        let flowed = elements().filter(|element| named(element, "flowRoot"));
        self.flowed.store(flowed.count(), Ordering::Relaxed);
        let has_text = |element: &Node<'_, '_>| {
            let mut texts = element.descendants().filter_map(|node| node.text());
            texts.any(|text| !text.trim().is_empty())
        };
        let foreign =
            elements().filter(|element| named(element, "foreignObject") && has_text(element));
        self.foreign.store(foreign.count(), Ordering::Relaxed);
        let moves = Declared::of(rules, |name, value| {
            MOVES.contains(&name) && value != "none"
        });
        let moved = elements().filter(|element| moves.of_element(*element));
        self.moved.store(moved.count(), Ordering::Relaxed);
        let clips = Declared::of(rules, |name, value| {
            name == "clip-path" && value != "none" && !value.starts_with("url")
        });
        let clipped = elements().filter(|element| clips.of_element(*element));
        self.clipped.store(clipped.count(), Ordering::Relaxed);
        let links = |node: &Node<'_, '_>| {
            let target = node
                .attributes()
                .find(|attribute| attribute.name() == "href");
            target.is_some_and(|target| !target.value().trim().starts_with('#'))
        };
        let linked = elements().filter(|element| named(element, "use") && links(element));
        self.linked.store(linked.count(), Ordering::Relaxed);
        let sizes = Declared::of(rules, |name, _| SIZES.contains(&name));
        let sized = elements().filter(|element| {
            SHAPES.iter().any(|name| named(element, name)) && sizes.of_element(*element)
        });
        self.sized.store(sized.count(), Ordering::Relaxed);
    }

    fn warn(&self, warnings: &mut Vec<WarningCount>) {
        let counts = [
            (WarningKind::Image, &self.images),
            (WarningKind::FlowedText, &self.flowed),
            (WarningKind::ForeignText, &self.foreign),
            (WarningKind::MovedByStyle, &self.moved),
            (WarningKind::SizedByStyle, &self.sized),
            (WarningKind::ClippedByStyle, &self.clipped),
            (WarningKind::LinkedShape, &self.linked),
            (WarningKind::UnreadRule, &self.rules),
            (WarningKind::UnreadSize, &self.unread_sizes),
            (WarningKind::SolidPath, &self.solid),
            (WarningKind::TextWithoutFont, &self.fontless),
            (WarningKind::MissingGlyph, &self.missing_glyphs),
        ];
        let found = counts.map(|(kind, count)| WarningCount {
            kind,
            count: count.load(Ordering::Relaxed),
        });
        warnings.extend(found.into_iter().filter(|warning| warning.count > 0));
    }
}

fn count<T>(counter: &AtomicUsize) -> Option<T> {
    counter.fetch_add(1, Ordering::Relaxed);
    None
}

/// The tree of shapes, the names of its outermost groups if they are layers, and facts about the
/// file.
fn parse(
    text: &str,
    options: &ReadOptions,
    tree_warnings: &TreeWarnings<'_>,
) -> Result<(Tree, HashMap<String, String>, FileFacts), SourceError> {
    if text.trim().is_empty() {
        return Err(SvgError::EmptyFile.into());
    }
    entities::check(text)?;
    options.cancel.check()?;
    let doc = xml::tree(text, true)?;
    check_root(&doc)?;
    styles::check(&doc)?;
    options.cancel.check()?;
    let facts = FileFacts {
        lone: lone_coordinates(&doc),
        unread: UnreadPlaces::of(&doc, text),
    };
    let readable = Readable::of(&doc, text);
    tree_warnings
        .rules
        .store(readable.unread_rules, Ordering::Relaxed);
    tree_warnings
        .unread_sizes
        .store(readable.unread_sizes, Ordering::Relaxed);
    tree_warnings.solid.store(readable.solid, Ordering::Relaxed);
    let Some(text) = readable.text else {
        let (tree, groups) = tree_of(doc, text, options, tree_warnings)?;
        return Ok((tree, groups, facts));
    };
    // There is no memory for two.
    drop(doc);
    let doc = xml::tree(&text, true)?;
    styles::check(&doc)?;
    let (tree, groups) = tree_of(doc, &text, options, tree_warnings)?;
    Ok((tree, groups, facts))
}

/// The tree of a rewritten file whose styles were checked.
fn tree_of(
    doc: Document<'_>,
    text: &str,
    options: &ReadOptions,
    tree_warnings: &TreeWarnings<'_>,
) -> Result<(Tree, HashMap<String, String>), SourceError> {
    let segments = check::check(&doc, &mut Budget::until(MAX_SEGMENTS, &options.cancel))?;
    let rules = rules(&doc);
    expand::check(&doc, &rules, &segments)?;
    tree_warnings.note_unread(&doc, &rules);
    options.cancel.check()?;
    let usvg_options = usvg::Options {
        font_family: options.fonts.family_name(&Family::Serif).to_owned(),
        fontdb: Arc::clone(&options.fonts),
        font_resolver: tree_warnings.font_resolver(),
        image_href_resolver: tree_warnings.image_resolver(),
        ..usvg::Options::default()
    };
    if options.layers != LayersBy::Group {
        let tree = Tree::from_xmltree(&doc, &usvg_options).map_err(|error| unreadable(&error));
        return Ok((tree?, HashMap::new()));
    }
    let Groups { names, text } = Groups::new(&doc, text);
    let tree = match text {
        Cow::Borrowed(_) => Tree::from_xmltree(&doc, &usvg_options),
        Cow::Owned(text) => {
            // It is parsed again, because there is no memory for two.
            drop(doc);
            Tree::from_str(&text, &usvg_options)
        }
    };
    Ok((tree.map_err(|error| unreadable(&error))?, names))
}

fn check_root(doc: &Document<'_>) -> Result<(), SvgError> {
    let root = doc.root_element();
    let name = root.tag_name();
    if name.name() == "svg" && matches!(name.namespace(), None | Some(SVG_NAMESPACE)) {
        return Ok(());
    }
    Err(SvgError::NotSvg {
        place: doc.text_pos_at(root.range().start).into(),
        found: name.name().to_owned(),
    })
}

fn unreadable(error: &usvg::Error) -> SourceError {
    match error {
        usvg::Error::InvalidSize => SvgError::NoPage.into(),
        usvg::Error::ParsingFailed(error) => malformed(error).into(),
        other => SourceError::nothing_to_draw([other.to_string()]),
    }
}

fn nothing_to_draw(warnings: &[WarningCount], others: Vec<Warning>) -> SourceError {
    if warnings.is_empty() && others.is_empty() {
        return SourceError::nothing_to_draw(["no visible shape or text on the page".to_owned()]);
    }
    let only_text = |warning: &WarningCount| warning.kind == WarningKind::TextWithoutFont;
    if others.is_empty() && warnings.iter().all(only_text) {
        return SvgError::NoFont.into();
    }
    let all = warnings.iter().copied().map(Warning::from).chain(others);
    let texts = all.map(|message| message.to_string());
    SourceError::nothing_to_draw(texts)
}

/// Properties that move an element.
const MOVES: [&str; 4] = ["transform", "translate", "rotate", "scale"];
/// Shapes, and their geometry properties since SVG 2.
const SHAPES: [&str; 4] = ["circle", "ellipse", "path", "rect"];
const SIZES: [&str; 10] = [
    "cx", "cy", "d", "height", "r", "rx", "ry", "width", "x", "y",
];
const SVG_NAMESPACE: &str = "http://www.w3.org/2000/svg";

#[cfg(test)]
mod tests;
