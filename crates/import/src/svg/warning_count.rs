//! Warnings of the SVG reader.

use crate::hidden::UNKNOWN;
use crate::warning::Warning;

/// The number of occurrences of content that a pen does not show like a browser.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct WarningCount {
    /// The content.
    pub(crate) kind: WarningKind,
    /// The number of occurrences.
    pub(crate) count: usize,
}

impl From<WarningCount> for Warning {
    fn from(WarningCount { kind, count }: WarningCount) -> Self {
        let (what, instead) = kind.words();
        Self::new(what, instead, count)
    }
}

/// Content that a pen cannot show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum WarningKind {
    /// A bitmap or another file.
    Image,
    /// A mask.
    Mask,
    /// A mask of something without width or height.
    EmptyMask,
    /// A filter, such as a blur.
    Filter,
    /// A gradient as paint.
    Gradient,
    /// A pattern as paint.
    Pattern,
    /// A shape with a white fill and without a line.
    Paper,
    /// One of them that lies on something darker.
    WhiteOnDark,
    /// A white shape among so many shapes that what is under it is not computed.
    WhiteUnknown,
    /// A fill that crosses itself too often, or has too many corners with its clip path, for
    /// clipping.
    Entangled,
    /// A shape under so many shapes that its visible part is not computed.
    Stacked,
    /// Text that flows into a shape (Inkscape before SVG 2).
    FlowedText,
    /// HTML text (diagram programs).
    ForeignText,
    /// HTML text of plain lines.
    PlainLabel,
    /// A shape or a group transformed around a place in its own box.
    MovedByStyle,
    /// A CSS clip-path by a basic shape.
    ClippedByStyle,
    /// A shape of another file.
    LinkedShape,
    /// A style sheet in another file.
    ExternalSheet,
    /// An ignored rule of a sheet.
    IgnoredRule,
    /// An ignored value of a property.
    IgnoredValue,
    /// A layer that `AxiDraw` does not draw.
    CommentLayer,
    /// A layer whose name has a pen height or a delay for `AxiDraw`.
    LayerCodes,
    /// A copy of a missing element.
    MissingTarget,
    /// A line of width 0.
    WidthZero,
    /// A width or a height of the page that is not a length.
    UnreadSize,
    /// A line with dashes as fractions of its path.
    SolidPath,
    /// A piece of text without any font.
    TextWithoutFont,
    /// A character missing in all fonts.
    MissingGlyph,
    /// A character missing in the single-line letters.
    MissingLetter,
    /// A part of a text in single-line letters with a set length.
    LettersLength,
    /// A part that runs down.
    LettersDirection,
    /// A part with a shifted base line.
    LettersBaseline,
    /// A part aligned by another base line.
    LettersAlignment,
}

impl WarningKind {
    #[expect(clippy::too_many_lines, reason = "a table")]
    const fn words(self) -> (&'static str, &'static str) {
        // table
        match self {
            Self::Image => ("image", "left out; trace it to paths"),
            Self::Mask => ("mask", "ignored; what it hides is drawn"),
            Self::EmptyMask => (
                "mask",
                "of something without width or height hides it, as in a browser; set its maskUnits to userSpaceOnUse",
            ),
            Self::Filter => ("filter", "ignored; the shape is drawn unchanged"),
            Self::Gradient => (
                "gradient",
                "drawn as one colour, the first of its stops that is not white",
            ),
            Self::Pattern => (
                "pattern",
                "of a line, or of too many tiles: left out; its area is drawn as an area",
            ),
            Self::Paper => ("white shape", "left out, because the paper is white"),
            Self::WhiteOnDark => (
                "white shape on a darker one",
                "its edge is not drawn; draw it with what.white_edges or what.hide",
            ),
            Self::WhiteUnknown => (
                "white shape",
                "among too many shapes to find what is under it: its edge, and those of later ones, are not drawn",
            ),
            Self::Entangled => (
                "filled shape",
                "not hatched, because it crosses itself too often, or too many corners lie in clip paths",
            ),
            Self::Stacked => UNKNOWN,
            Self::FlowedText => (
                "flowed text",
                "left out; convert it in Inkscape with Text > Convert to Text",
            ),
            Self::ForeignText => (
                "foreignObject",
                "left out with its text (HTML); use an option for SVG texts in the program that made the file",
            ),
            Self::PlainLabel => (
                "label",
                "in a foreignObject (HTML): drawn as plain text; check its place in the preview",
            ),
            Self::MovedByStyle => (
                "transform-box",
                "not supported: transformed around a place on the page, not in the shape; save the file as plain SVG",
            ),
            Self::ClippedByStyle => (
                "CSS clip-path",
                "of a basic shape: ignored; what it hides is drawn; save the file as plain SVG",
            ),
            Self::LinkedShape => (
                "shape",
                "of another file (use): left out; copy it into this one",
            ),
            Self::ExternalSheet => (
                "style sheet",
                "in another file: not read; copy its rules into a <style> element",
            ),
            Self::IgnoredRule => (
                "CSS rule",
                "ignored, because its selector or its at-rule is invalid or not supported; save the file as plain SVG",
            ),
            Self::IgnoredValue => (
                "style value",
                "ignored, because it is not one that its property allows, or not supported",
            ),
            Self::CommentLayer => ("layer", "with % before its name: left out, as by AxiDraw"),
            Self::LayerCodes => (
                "layer name",
                "with a pen height or delay for AxiDraw (+H +D): not read, because the paper decides the height and the arm waits only for a person; write ! first for a pause",
            ),
            Self::MissingTarget => (
                "copy",
                "(use) of an element that the file does not have: left out",
            ),
            Self::WidthZero => (
                "line of width 0",
                "left out as in a browser; set stroke-width above 0 to draw it",
            ),
            Self::UnreadSize => (
                "page size",
                "(width or height of <svg>) ignored, because it is not a length such as 200mm; the size is that of the viewBox or of the drawing, in pixels",
            ),
            Self::SolidPath => (
                "dashed line",
                "with pathLength and dashes in percent or em: drawn solid",
            ),
            Self::TextWithoutFont => (
                "text",
                "left out, because no font was found; install a font or convert it to paths",
            ),
            Self::MissingLetter => (
                "character",
                "not in the Hershey letters, left out; use another font",
            ),
            Self::LettersLength => (
                "textLength",
                "of Hershey letters, ignored: written with their own width",
            ),
            Self::LettersDirection => (
                "writing-mode",
                "of Hershey letters, ignored: written to the right",
            ),
            Self::LettersBaseline => (
                "dominant-baseline",
                "of Hershey letters, ignored: written on the base line",
            ),
            Self::LettersAlignment => (
                "alignment-baseline",
                "of Hershey letters, ignored: written on the base line",
            ),
            Self::MissingGlyph => (
                "character",
                "not in any installed font, drawn as the font's box for missing characters",
            ),
        }
    }
}
