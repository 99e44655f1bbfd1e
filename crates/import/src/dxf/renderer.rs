//! The renderer of entities and blocks.

use dobot_geometry::{Affine, Point, Vec2};

use super::entity::Entity;
use super::file::{Block, File, LayerInfo, Span};
use super::line_type::LineType;
use super::pairs::Pair;
use super::shapes::IN_SPACE;
use crate::artwork::Layer;
use crate::error::SourceError;
use crate::frame::way;
use crate::place::{printable, shortened};
use crate::sketch::Sketch;
use crate::text::Lettering;

/// A renderer of entities into a sketch.
#[derive(Debug)]
pub(super) struct EntityRenderer<'s, 'a> {
    pub(super) sketch: &'s mut Sketch<'a>,
    pub(super) file: &'s File<'a>,
    /// The number of bytes of copied entities that may still be read.
    copies_left: usize,
    /// The current layer of the sketch.
    layer: Option<String>,
    /// Whether the INSERT of the current block is opaque.
    pub(super) block_is_opaque: bool,
    /// The blocks that are being drawn.
    open_blocks: Vec<&'s Block<'a>>,
    /// Whether objects too far away are left out; otherwise they are an error.
    skips_far: bool,
    pub(super) lettering: Lettering,
}

/// The context of a block.
#[derive(Clone, Copy, Debug)]
struct Copy<'l> {
    frame: Affine,
    /// The nesting depth.
    depth: u32,
    /// The layer of the INSERT, which entities on layer 0 inherit.
    layer: &'l str,
    /// The line type of the INSERT in upper case, which entities with `ByBlock` inherit.
    line_type: &'l str,
}

impl<'s, 'a> EntityRenderer<'s, 'a> {
    pub(super) fn new(sketch: &'s mut Sketch<'a>, file: &'s File<'a>, skips_far: bool) -> Self {
        Self {
            sketch,
            file,
            copies_left: MAX_COPIED,
            layer: None,
            block_is_opaque: true,
            open_blocks: Vec::new(),
            skips_far,
            lettering: Lettering::default(),
        }
    }

    pub(super) fn all(&mut self, frame: Affine) -> Result<(), SourceError> {
        let copy = Copy {
            frame,
            depth: 0,
            layer: "0",
            line_type: "",
        };
        self.entities(&self.file.entities, copy)
    }

    fn entities(&mut self, spans: &[Span<'a>], copy: Copy<'_>) -> Result<(), SourceError> {
        let mut spans = spans.iter();
        while let Some(&span) = spans.next() {
            self.sketch.check_cancelled()?;
            if copy.depth > 0 {
                self.spend(span)?;
            }
            let part = match span.kind {
                b"POLYLINE" => Some(&b"VERTEX"[..]),
                b"INSERT" => Some(&b"ATTRIB"[..]),
                _ => None,
            };
            let rest = spans.as_slice();
            let parts = rest.iter().take_while(|byte| Some(byte.kind) == part);
            let count = parts.count();
            let drawn = self.entity(span, &rest[..count], copy);
            let is_shown = drawn.or_else(|error| self.skip(error))?;
            // The visible attributes of a block are separate entities.
            if span.kind == b"POLYLINE" || !is_shown {
                spans = rest[count..].iter();
            }
        }
        Ok(())
    }

    /// Reports a mistake in an entity, of which nothing more is drawn.
    fn skip(&mut self, error: SourceError) -> Result<bool, SourceError> {
        if matches!(error, SourceError::TooFar { .. }) && !self.skips_far {
            return Err(error);
        }
        self.sketch
            .skip_mistake(Err(error), "its object is left out")?;
        Ok(false)
    }

    /// Charges copied bytes: copies of copies may be many, although the file is small.
    pub(super) fn spend(&mut self, span: Span<'_>) -> Result<(), SourceError> {
        if let Some(left) = self.copies_left.checked_sub(span.end - span.at) {
            self.copies_left = left;
            return Ok(());
        }
        let expected = "copies of blocks (INSERT) of less than 200 MB in total";
        let found = "one copy too many";
        Err(SourceError::limit(self.file.text, span.at, found, expected))
    }

    /// Draws an entity; `false` for an invisible one.
    fn entity(
        &mut self,
        span: Span<'a>,
        parts: &[Span<'a>],
        copy: Copy<'_>,
    ) -> Result<bool, SourceError> {
        let entity = Entity::read(self.file.text, span)?;
        let own = entity.find(8).map_or_else(|| "0".into(), Pair::text);
        let layer = if own == "0" {
            copy.layer
        } else {
            self.file.layers.own_name(&own)
        };
        if self.is_hidden(&entity, layer)? {
            return Ok(false);
        }
        let line_type = self.line_type_name(&entity, layer, copy.line_type);
        let copy = Copy {
            layer,
            line_type: &line_type,
            ..copy
        };
        match entity.kind {
            b"INSERT" => self.insert(&entity, parts, copy),
            b"ACAD_TABLE" => self.table(&entity, copy),
            b"DIMENSION" | b"ARC_DIMENSION" | b"LARGE_RADIAL_DIMENSION" => {
                self.dimension(&entity, copy)
            }
            _ => self.lines(&entity, parts, copy),
        }?;
        Ok(true)
    }

    /// Draws an entity other than a block, on its layer, with its dashes.
    fn lines(
        &mut self,
        entity: &Entity<'a>,
        parts: &[Span<'a>],
        copy: Copy<'_>,
    ) -> Result<(), SourceError> {
        let mut frame = Some(copy.frame);
        if has_own_plane(entity)? {
            frame = self.seen(entity, copy.frame)?;
        }
        let Some(frame) = frame else {
            return Ok(());
        };
        self.use_layer(copy.layer)?;
        self.sketch.lift();
        let copy = Copy { frame, ..copy };
        if let Some(line_type) = self.line_type(entity, copy)? {
            let mark = self.sketch.mark();
            self.shape(entity, parts, copy)?;
            let LineType { lengths, offset } = line_type;
            return self.sketch.dash_since(&mark, &lengths, offset);
        }
        self.shape(entity, parts, copy)
    }

    /// The name in upper case of an entity's line type, which may be inherited from layer or block;
    /// empty in a file without any.
    fn line_type_name(&self, entity: &Entity<'_>, layer: &str, of_block: &str) -> String {
        if self.file.line_types.is_empty() {
            return String::new();
        }
        let own = entity.find(6).map(|at| at.text().to_uppercase());
        match own.as_deref() {
            None | Some("BYLAYER") => {
                let info = self.file.layers.get(layer);
                info.map(|info| info.line_type.clone()).unwrap_or_default()
            }
            Some("BYBLOCK") => of_block.to_owned(),
            Some(own) => own.to_owned(),
        }
    }

    /// The dashes of an entity, in mm; `None` for a solid line.
    fn line_type(
        &self,
        entity: &Entity<'_>,
        copy: Copy<'_>,
    ) -> Result<Option<LineType>, SourceError> {
        if !LINES.contains(&entity.kind) {
            return Ok(None);
        }
        let Some(line_type) = self.file.line_types.get(copy.line_type) else {
            return Ok(None);
        };
        let larger = copy.frame.determinant().abs().sqrt();
        Ok(line_type.scaled(self.file.line_scale * entity.number_or(48, 1.0)? * larger))
    }

    fn shape(
        &mut self,
        entity: &Entity<'a>,
        parts: &[Span<'a>],
        Copy { frame, depth, .. }: Copy<'_>,
    ) -> Result<(), SourceError> {
        match entity.kind {
            b"LINE" => self.straight(entity, frame),
            b"POINT" => self.dot(entity, frame),
            b"CIRCLE" | b"ARC" => self.circle(entity, frame),
            b"ELLIPSE" => self.ellipse(entity, frame),
            b"LWPOLYLINE" => self.light_polyline(entity, frame),
            b"POLYLINE" => self.polyline(entity, parts, frame),
            b"SPLINE" => self.spline(entity, frame),
            b"SOLID" | b"TRACE" => self.solid(entity, frame),
            b"3DFACE" => self.face(entity, frame),
            b"MLINE" => self.multiline(entity, frame),
            b"MESH" => self.mesh(entity, frame),
            b"LEADER" => self.leader(entity, frame),
            b"MULTILEADER" | b"MLEADER" => self.multileader(entity, frame),
            b"WIPEOUT" => self.wipeout(entity, frame),
            b"HATCH" => self.hatch(entity, frame),
            // The end of a POLYLINE, and the viewport of a layout.
            b"SEQEND" | b"VERTEX" | b"VIEWPORT" => Ok(()),
            b"TEXT" | b"ATTRIB" | b"ATTDEF" => self.text(entity, frame, depth > 0),
            b"MTEXT" => self.paragraphs(entity, frame),
            b"RAY" | b"XLINE" => {
                self.left_out(entity, "left out, because it has no end");
                Ok(())
            }
            _ => {
                self.left_out(entity, "unknown, left out");
                Ok(())
            }
        }
    }

    pub(super) fn left_out(&mut self, entity: &Entity<'_>, instead: &str) {
        self.sketch.warn(entity.at, &entity.name(), instead);
    }

    fn is_hidden(&mut self, entity: &Entity<'_>, layer: &str) -> Result<bool, SourceError> {
        // The definition points of dimensions; the format never plots this layer, whatever its
        // table declares.
        let is_for_points = layer.eq_ignore_ascii_case("Defpoints");
        if entity.flags(60)? == 1 || is_for_points && entity.kind == b"POINT" {
            return Ok(true);
        }
        let info = self.file.layers.get(layer);
        // A layer of a block that is off hides only the entities on layer 0, which inherit it.
        let is_block = entity.kind == b"INSERT";
        let is_off = !is_block && info.is_some_and(LayerInfo::is_off);
        let is_unplotted = is_for_points || info.is_some_and(|info| info.is_unplotted);
        let (what, instead) = if is_off || info.is_some_and(|info| info.is_frozen) {
            (
                "hidden object",
                "left out, because its layer is off or frozen",
            )
        } else if entity.flags(67)? == 1 {
            ("paper space object", "left out")
        } else if is_unplotted && !is_block {
            (
                "unplotted object",
                "left out, because its layer is not plotted",
            )
        } else {
            return Ok(false);
        };
        self.sketch.warn(entity.at, what, instead);
        Ok(true)
    }

    /// The frame of the entity's extrusion; `None` if it is tilted out of the plane.
    fn seen(&mut self, entity: &Entity<'_>, frame: Affine) -> Result<Option<Affine>, SourceError> {
        let (x, y) = (entity.number_or(210, 0.0)?, entity.number_or(220, 0.0)?);
        if x.hypot(y) > 1e-6 {
            let instead = "left out, because only objects in the XY plane are drawn";
            self.sketch.warn(entity.at, "tilted object", instead);
            return Ok(None);
        }
        Ok(Some(frame * Affine::scale_non_uniform(entity.side()?, 1.0)))
    }

    fn use_layer(&mut self, name: &str) -> Result<(), SourceError> {
        if self.layer.as_deref() == Some(name) {
            return Ok(());
        }
        self.layer = Some(name.to_owned());
        self.sketch.use_layer(Layer {
            name: printable(name),
            color: self.file.layers.get(name).and_then(LayerInfo::rgb),
            ..Layer::default()
        })
    }

    /// Applies colour and name of the current layer.
    pub(super) fn layer_info(&self) -> Option<&LayerInfo> {
        self.file.layers.get(self.layer.as_ref()?)
    }

    /// Draws a block, once or in rows and columns.
    fn insert(
        &mut self,
        entity: &Entity<'a>,
        attributes: &[Span<'a>],
        copy: Copy<'_>,
    ) -> Result<(), SourceError> {
        let name = entity.find(2).map(Pair::text).unwrap_or_default();
        let Some(block) = self.file.blocks.get(&name) else {
            let first = shortened(&name);
            let instead = format!("left out, because its block is not in the file: {first:?}");
            self.left_out(entity, &instead);
            return Ok(());
        };
        if [41, 42]
            .into_iter()
            .map(|code| entity.number_or(code, 1.0))
            .any(|size| size == Ok(0.0))
        {
            self.left_out(entity, "left out, because its scale is 0");
            return Ok(());
        }
        let Some(frame) = self.seen(entity, copy.frame)? else {
            return Ok(());
        };
        let clip = self.clip(entity)?;
        let turn = Affine::rotate(entity.number_or(50, 0.0)?.to_radians());
        let (columns, rows) = (entity.flags(70)?.max(1), entity.flags(71)?.max(1));
        let (wide, high) = (entity.number_or(44, 0.0)?, entity.number_or(45, 0.0)?);
        for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)))
        {
            let shift = Vec2::new(f64::from(column) * wide, f64::from(row) * high);
            let placed = frame * placed(entity, block.base, shift)?;
            let mark = self.sketch.mark();
            self.block(
                entity,
                block,
                Copy {
                    frame: placed,
                    ..copy
                },
            )?;
            if let Some(ring) = &clip {
                let ring = ring.iter().map(|&p| placed * p).collect();
                self.sketch.cut_since(&mark, ring)?;
            }
            // Those of the first are separate entities.
            for &span in attributes.iter().filter(|_| row + column > 0) {
                let frame = copy.frame * Affine::translate(way(turn, shift));
                self.spend(span)?;
                self.entity(span, &[], Copy { frame, ..copy })?;
            }
        }
        Ok(())
    }

    /// Draws a table, whose picture is a block.
    fn table(&mut self, entity: &Entity<'a>, copy: Copy<'_>) -> Result<(), SourceError> {
        let Some(block) = self.picture(entity) else {
            return Ok(());
        };
        let right = Vec2::new(entity.number_or(11, 1.0)?, entity.number_or(21, 0.0)?);
        let turn = Affine::rotate(right.atan2());
        let at = Affine::translate(entity.point(10)?.to_vec2());
        let frame = copy.frame * at * turn * Affine::translate(-block.base.to_vec2());
        self.block(entity, block, Copy { frame, ..copy })
    }

    /// Draws the picture of a dimension, which is a block in its place.
    fn dimension(&mut self, entity: &Entity<'a>, copy: Copy<'_>) -> Result<(), SourceError> {
        let Some(block) = self.picture(entity) else {
            return Ok(());
        };
        let shift = Point::new(entity.number_or(12, 0.0)?, entity.number_or(22, 0.0)?) - block.base;
        let frame = copy.frame * Affine::translate(shift);
        self.block(entity, block, Copy { frame, ..copy })
    }

    /// Draws the block that represents an entity.
    fn picture(&mut self, entity: &Entity<'_>) -> Option<&'s Block<'a>> {
        let name = entity.find(2).map(Pair::text).unwrap_or_default();
        let block = self.file.blocks.get(&name);
        if block.is_none() {
            self.left_out(entity, "left out, because its picture is not in the file");
        }
        block
    }

    /// Draws a block in a frame, one level deeper.
    fn block(
        &mut self,
        entity: &Entity<'a>,
        block: &'s Block<'a>,
        copy: Copy<'_>,
    ) -> Result<(), SourceError> {
        if self
            .open_blocks
            .iter()
            .any(|open| std::ptr::eq(*open, block))
        {
            return Err(entity.refused("a block inside itself", "blocks of other objects"));
        }
        if copy.depth == MAX_DEPTH {
            return Err(entity.refused("one more nested block", "blocks nested at most 32 deep"));
        }
        self.spend(Span {
            kind: b"",
            at: entity.at,
            begin: entity.at,
            end: entity.at + MIN_COPY,
        })?;
        let is_opaque = self.is_opaque(entity, self.file.layers.get(copy.layer))?;
        let around = std::mem::replace(&mut self.block_is_opaque, is_opaque);
        let depth = copy.depth + 1;
        self.open_blocks.push(block);
        let drawn = self.entities(&block.entities, Copy { depth, ..copy });
        self.open_blocks.pop();
        self.block_is_opaque = around;
        drawn
    }
}

/// Whether the coordinates of an entity are in the plane of its extrusion; those of others are
/// world coordinates.
fn has_own_plane(entity: &Entity<'_>) -> Result<bool, SourceError> {
    Ok(match entity.kind {
        b"POLYLINE" => entity.flags(70)? & IN_SPACE == 0,
        kind => FLAT.contains(&kind),
    })
}

/// The transform of an INSERT.
fn placed(entity: &Entity<'_>, base: Point, shift: Vec2) -> Result<Affine, SourceError> {
    let turn = Affine::rotate(entity.number_or(50, 0.0)?.to_radians());
    let size = Affine::scale_non_uniform(entity.number_or(41, 1.0)?, entity.number_or(42, 1.0)?);
    let at = Affine::translate(entity.point(10)?.to_vec2());
    Ok(at * turn * Affine::translate(shift) * size * Affine::translate(-base.to_vec2()))
}

/// Entities with a plane of their own.
const FLAT: [&[u8]; 9] = [
    b"CIRCLE",
    b"ARC",
    b"LWPOLYLINE",
    b"SOLID",
    b"TRACE",
    b"HATCH",
    b"TEXT",
    b"ATTRIB",
    b"ATTDEF",
];
/// Entities drawn in dashes.
const LINES: [&[u8]; 7] = [
    b"LINE",
    b"CIRCLE",
    b"ARC",
    b"ELLIPSE",
    b"LWPOLYLINE",
    b"POLYLINE",
    b"SPLINE",
];
const MAX_COPIED: usize = if cfg!(test) { 10_000_000 } else { 200_000_000 };
/// The cost of a copy of an empty block, in bytes.
const MIN_COPY: usize = 100;
const MAX_DEPTH: u32 = 32;
