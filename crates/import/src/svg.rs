//! The SVG reader: visible outlines as strokes, fills as areas, in true millimetres.

mod check;
mod color;
mod css;
mod dtd;
mod edits;
mod entities;
mod expand;
mod flatten;
mod font;
mod foreign_text;
mod groups;
mod handles;
mod ink;
mod layer_code;
mod layers;
mod letters;
mod mask;
mod page;
mod page_size;
mod pattern;
mod points;
mod readable;
mod renderer;
mod single_line;
mod substitutes;
mod unread;
mod warning_count;

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use dobot_geometry::CancelToken;
use usvg::fontdb::Family;
use usvg::roxmltree::{Document, Node};
use usvg::{FontResolver, ImageHrefResolver, ImageKind, Tree};

use self::check::Damage;
use self::css::{Found, Styles};
pub(crate) use self::font::SvgFont;
use self::groups::{Groups, LayerGroup, has_controls};
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
use crate::sketch::REST_LEFT_OUT;
use crate::warning::{Warning, Warnings};
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
    let tree = parse(text, options, &TreeWarnings::new(&substitutes), 0).map(|parsed| parsed.0);
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
    let (tree, groups, facts) = parse(text, options, &tree_warnings, 0)?;
    let mut page = SvgPage::new(renderer::page_mm(&tree), options);
    TreeRenderer::new(&mut page, tolerance_mm, &groups).tree(&tree)?;
    // It takes as much memory as the page, which may need more of it now.
    drop(tree);
    let inner = tree_warnings
        .inner
        .lock()
        .unwrap_or_else(PoisonError::into_inner);
    let (inner, counts) = inner.clone();
    let others = page.cut().into_iter().chain(facts.warnings).chain(inner);
    let (artwork, mut warnings) = page.finish()?;
    let mut mistakes = Warnings::new(text.as_bytes());
    if let Some(mistake) = facts.mistake {
        if artwork.layers.is_empty() {
            return Err(mistake);
        }
        mistakes.add_mistake(mistake, REST_LEFT_OUT)?;
    }
    let others = mistakes.into_list().into_iter().chain(others);
    warnings.extend(facts.counts.into_iter().chain(counts));
    tree_warnings.warn(&mut warnings);
    if artwork.layers.is_empty() {
        return Err(nothing_to_draw(&warnings, others.collect()));
    }
    let warnings = merged(warnings)
        .into_iter()
        .map(|warning| facts.unread.warning(warning));
    Ok((artwork, warnings.chain(others).collect()))
}

/// Facts about the original file, collected before it is rewritten.
struct FileFacts {
    /// Warnings with places: about points without y, and about invalid values.
    warnings: Vec<Warning>,
    counts: Vec<WarningCount>,
    unread: UnreadPlaces,
    /// The error after which nothing was read.
    mistake: Option<SourceError>,
}

/// Counts what is lost while the tree is built.
struct TreeWarnings<'a> {
    images: AtomicUsize,
    flowed: AtomicUsize,
    foreign: AtomicUsize,
    clipped: AtomicUsize,
    fontless: AtomicUsize,
    missing_glyphs: AtomicUsize,
    /// The warnings of images that are SVG files.
    inner: Mutex<(Vec<Warning>, Vec<WarningCount>)>,
    /// The number of elements that the file and its images may still have.
    elements_left: AtomicU64,
    substitutes: &'a Substitutes,
}

impl<'a> TreeWarnings<'a> {
    fn new(substitutes: &'a Substitutes) -> Self {
        Self {
            images: AtomicUsize::new(0),
            flowed: AtomicUsize::new(0),
            foreign: AtomicUsize::new(0),
            clipped: AtomicUsize::new(0),
            fontless: AtomicUsize::new(0),
            missing_glyphs: AtomicUsize::new(0),
            inner: Mutex::default(),
            elements_left: AtomicU64::new(expand::MAX_ELEMENTS),
            substitutes,
        }
    }

    /// Reads images that are SVG files, except those in such images, and counts others.
    fn image_resolver<'s>(&'s self, options: &'s ReadOptions, depth: u32) -> ImageHrefResolver<'s> {
        let inner = move |kind: &str, data: &[u8]| {
            let is_svg = kind == "image/svg+xml" && depth == 0;
            let tree = is_svg.then(|| self.inner_tree(data, options));
            tree.flatten()
                .map(ImageKind::SVG)
                .or_else(|| count(&self.images))
        };
        ImageHrefResolver {
            resolve_data: Box::new(move |kind, data, _| inner(kind, &data)),
            resolve_string: Box::new(|_, _| count(&self.images)),
        }
    }

    /// The tree of an image that is an SVG file.
    fn inner_tree(&self, data: &[u8], options: &ReadOptions) -> Option<Tree> {
        let options = ReadOptions {
            layers: LayersBy::Color,
            ..options.clone()
        };
        let text = str::from_utf8(data).ok()?;
        let (tree, _, facts) = parse(text, &options, self, 1).ok()?;
        let mut inner = self.inner.lock().unwrap_or_else(PoisonError::into_inner);
        // Their places are in another text.
        let warnings = facts.warnings.into_iter().map(|warning| Warning {
            place: None,
            ..warning
        });
        inner.0.extend(warnings);
        inner.1.extend(facts.counts);
        Some(tree)
    }

    /// Refuses a file whose images have too many elements together with it.
    fn spend_elements(&self, elements: u64) -> Result<(), SvgError> {
        let left = self
            .elements_left
            .load(Ordering::Relaxed)
            .checked_sub(elements);
        self.elements_left
            .store(left.unwrap_or_default(), Ordering::Relaxed);
        let limit = expand::MAX_ELEMENTS;
        left.map(|_| ()).ok_or(SvgError::TooManyElements { limit })
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
    fn note_unread(&self, doc: &Document<'_>) {
        let elements = || doc.descendants().filter(Node::is_element);
        let named = |node: &Node<'_, '_>, name: &str| node.tag_name().name() == name;
        let flowed = elements().filter(|element| named(element, "flowRoot"));
        self.flowed.fetch_add(flowed.count(), Ordering::Relaxed);
        let has_text = |element: &Node<'_, '_>| {
            let mut texts = element.descendants().filter_map(|node| node.text());
            texts.any(|text| !text.trim().is_empty())
        };
        let foreign =
            elements().filter(|element| named(element, "foreignObject") && has_text(element));
        self.foreign.fetch_add(foreign.count(), Ordering::Relaxed);
        let is_clipped = |element: &Node<'_, '_>| {
            let clip = element.attribute("clip-path").unwrap_or("none");
            clip != "none" && !clip.starts_with("url")
        };
        let clipped = elements().filter(is_clipped);
        self.clipped.fetch_add(clipped.count(), Ordering::Relaxed);
    }

    fn warn(&self, warnings: &mut Vec<WarningCount>) {
        let counts = [
            (WarningKind::Image, &self.images),
            (WarningKind::FlowedText, &self.flowed),
            (WarningKind::ForeignText, &self.foreign),
            (WarningKind::ClippedByStyle, &self.clipped),
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

/// The tree of shapes, its groups that make layers, and facts about the
/// file, which is an image in another one if `depth` is above 0.
fn parse(
    text: &str,
    options: &ReadOptions,
    tree_warnings: &TreeWarnings<'_>,
    depth: u32,
) -> Result<(Tree, HashMap<String, LayerGroup>, FileFacts), SourceError> {
    if text.trim().is_empty() {
        return Err(SvgError::EmptyFile.into());
    }
    entities::check(text)?;
    options.cancel.check()?;
    let text = &*dtd::with_defaults(text, &options.cancel)?;
    let mut part = String::new();
    let xml::Readable {
        text,
        document: doc,
        error: mistake,
    } = xml::tree_before_error(text, true, usize::MAX, &mut part)?;
    check_root(&doc)?;
    let (rewritten, mut facts) = rewritten(&doc, text, &options.cancel)?;
    facts.mistake = mistake;
    let Some(text) = rewritten else {
        let (tree, groups) = tree_of(doc, text, options, tree_warnings, depth)?;
        return Ok((tree, groups, facts));
    };
    // There is no memory for two.
    drop(doc);
    let doc = xml::tree(&text, true)?;
    let (tree, groups) = tree_of(doc, &text, options, tree_warnings, depth)?;
    Ok((tree, groups, facts))
}

/// The file as the library reads it, if it differs, and facts about the original one.
fn rewritten(
    doc: &Document<'_>,
    text: &str,
    cancel: &CancelToken,
) -> Result<(Option<String>, FileFacts), SourceError> {
    let sheets = css::sheet_texts(doc);
    let styles = Styles::of(doc, &sheets, cancel)?;
    let Damage {
        edits, warnings, ..
    } = Damage::of(doc, cancel)?;
    let Readable {
        text: new,
        warnings: counts,
    } = Readable::of(doc, text, &styles, edits, cancel)?;
    let mut unread = UnreadPlaces::of(doc, text, &styles);
    for (kind, found) in &counts {
        if let Some(at) = found.first {
            unread.note(*kind, doc.text_pos_at(at).into());
        }
    }
    let count = |(kind, found): (WarningKind, Found)| WarningCount {
        kind,
        count: found.count,
    };
    let facts = FileFacts {
        warnings: lone_coordinates(doc).into_iter().chain(warnings).collect(),
        counts: counts.into_iter().map(count).collect(),
        unread,
        mistake: None,
    };
    Ok((new, facts))
}

/// The tree of a rewritten file.
fn tree_of(
    doc: Document<'_>,
    text: &str,
    options: &ReadOptions,
    tree_warnings: &TreeWarnings<'_>,
    depth: u32,
) -> Result<(Tree, HashMap<String, LayerGroup>), SourceError> {
    let segments = check::segments(&doc, &mut Budget::until(MAX_SEGMENTS, &options.cancel))?;
    tree_warnings.spend_elements(expand::check(&doc, &segments)?)?;
    tree_warnings.note_unread(&doc);
    options.cancel.check()?;
    let usvg_options = usvg::Options {
        font_family: options.fonts.family_name(&Family::Serif).to_owned(),
        fontdb: Arc::clone(&options.fonts),
        font_resolver: tree_warnings.font_resolver(),
        image_href_resolver: tree_warnings.image_resolver(options, depth),
        ..usvg::Options::default()
    };
    let outermost_are_layers = options.layers == LayersBy::Group;
    if !outermost_are_layers && !has_controls(&doc) {
        let tree = Tree::from_xmltree(&doc, &usvg_options).map_err(|error| unreadable(&error));
        // A cancelled image is none.
        options.cancel.check()?;
        return Ok((tree?, HashMap::new()));
    }
    let Groups { by_id, text } = Groups::new(&doc, text, outermost_are_layers);
    let tree = match text {
        Cow::Borrowed(_) => Tree::from_xmltree(&doc, &usvg_options),
        Cow::Owned(text) => {
            // It is parsed again, because there is no memory for two.
            drop(doc);
            Tree::from_str(&text, &usvg_options)
        }
    };
    options.cancel.check()?;
    Ok((tree.map_err(|error| unreadable(&error))?, by_id))
}

/// The counts, each kind once.
fn merged(counts: Vec<WarningCount>) -> Vec<WarningCount> {
    let mut merged: Vec<WarningCount> = Vec::new();
    for found in counts {
        match merged.iter_mut().find(|known| known.kind == found.kind) {
            Some(known) => known.count += found.count,
            None => merged.push(found),
        }
    }
    merged
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

const SVG_NAMESPACE: &str = "http://www.w3.org/2000/svg";

#[cfg(test)]
mod tests;
