//! The sections of a file: unit, layers, blocks and entities.

use std::collections::HashMap;

use dobot_geometry::{CancelToken, Point};

use super::line_type::LineType;
use super::named::Named;
use super::pairs::{Pair, pairs};
use crate::error::SourceError;
use crate::place::beginning;
use crate::sketch::REST_LEFT_OUT;
use crate::warning::MAX_MISTAKES;

/// The index of a file.
#[derive(Debug)]
pub(super) struct File<'a> {
    pub(super) text: &'a [u8],
    /// Millimetres per unit; `None` if the file does not declare it.
    pub(super) unit_mm: Option<f64>,
    pub(super) layers: Named<LayerInfo>,
    /// Line types with gaps, by their names in upper case.
    pub(super) line_types: HashMap<String, LineType>,
    /// The line type scale ($LTSCALE).
    pub(super) line_scale: f64,
    pub(super) blocks: Named<Block<'a>>,
    pub(super) entities: Vec<Span<'a>>,
    /// Dictionaries, filters and multiline styles, by handle.
    pub(super) objects: HashMap<&'a [u8], Span<'a>>,
    /// Mistakes outside of entities, and what is left out for each.
    pub(super) mistakes: Vec<(SourceError, &'static str)>,
    /// Whether $MEASUREMENT states imperial units.
    pub(super) is_imperial: bool,
}

/// A layer of the layer table.
#[derive(Clone, Debug, Default)]
pub(super) struct LayerInfo {
    /// The colour number of `AutoCAD`; below 0 for a layer that is off.
    pub(super) color: Option<i32>,
    /// Red, green and blue as one number.
    pub(super) true_color: Option<u32>,
    pub(super) is_frozen: bool,
    /// Whether it is only displayed, not plotted.
    pub(super) is_unplotted: bool,
    /// The transparency of its entities, as in group 440 of an entity.
    pub(super) transparency: u32,
    /// The name of its line type in upper case.
    pub(super) line_type: String,
}

impl LayerInfo {
    pub(super) fn is_off(&self) -> bool {
        self.color.is_some_and(|color| color < 0)
    }

    pub(super) fn rgb(&self) -> Option<[u8; 3]> {
        if let Some(color) = self.true_color {
            let [_, red, green, blue] = color.to_be_bytes();
            return Some([red, green, blue]);
        }
        Some(match self.color?.abs() {
            1 => [255, 0, 0],
            2 => [255, 255, 0],
            3 => [0, 255, 0],
            4 => [0, 255, 255],
            5 => [0, 0, 255],
            6 => [255, 0, 255],
            // White on the screen is black on paper.
            7 => [0, 0, 0],
            8 => [128, 128, 128],
            9 => [192, 192, 192],
            _ => return None,
        })
    }
}

/// Entities drawn by INSERTs.
#[derive(Debug, Default)]
pub(super) struct Block<'a> {
    pub(super) base: Point,
    pub(super) entities: Vec<Span<'a>>,
}

/// The range of an entity in the text: from after its name to the next one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span<'a> {
    pub(super) kind: &'a [u8],
    pub(super) at: usize,
    pub(super) begin: usize,
    pub(super) end: usize,
}

impl<'a> File<'a> {
    /// Reads the sections up to the end of the file, or to the first line that is no group.
    pub(super) fn read(text: &'a [u8], cancel: &CancelToken) -> Result<Self, SourceError> {
        refuse_binary(text)?;
        let mut reader = SectionReader::new(text);
        for pair in pairs(text, beginning(text)) {
            cancel.check()?;
            let pair = match pair {
                Ok(pair) => pair,
                Err(mistake) => return Ok(reader.cut_off(mistake)),
            };
            if pair.is(0, b"EOF") {
                reader.end_entity(pair.at);
                reader.end_record();
                return Ok(reader.file);
            }
            let read = reader.pair(pair);
            read.or_else(|error| reader.file.skip(error, "its group is left out"))?;
        }
        let expected = "0 and EOF: the file is cut off";
        let mistake = SourceError::unexpected(text, text.len(), expected);
        Ok(reader.cut_off(mistake))
    }

    /// Notes a mistake, for which the drawing lacks what `instead` states. Returns other errors,
    /// and a mistake after too many of them.
    pub(super) fn skip(
        &mut self,
        error: SourceError,
        instead: &'static str,
    ) -> Result<(), SourceError> {
        if error.mistake().is_none() || self.mistakes.len() == MAX_MISTAKES {
            return Err(error);
        }
        self.mistakes.push((error, instead));
        Ok(())
    }
}

fn refuse_binary(text: &[u8]) -> Result<(), SourceError> {
    let expected = "an ASCII DXF file; save it as such";
    if text.starts_with(b"AutoCAD Binary DXF") {
        return Err(SourceError::found(text, 0, "a binary DXF file", expected));
    }
    if text.starts_with(b"AC10") {
        return Err(SourceError::found(text, 0, "a DWG file", expected));
    }
    Ok(())
}

struct SectionReader<'a> {
    file: File<'a>,
    section: &'a [u8],
    /// The name of the last header variable.
    variable: &'a [u8],
    /// The program of the last layer data.
    application: &'a [u8],
    /// The current entity, whose end is unknown.
    entity: Option<Span<'a>>,
    /// The handle of the current object.
    handle: Option<&'a [u8]>,
    /// The current block with its name.
    block: Option<(String, Block<'a>)>,
    /// The current layer with its name.
    layer: Option<(String, LayerInfo)>,
    /// The current line type: its name and its elements.
    line_type: Option<(String, Vec<f64>)>,
    /// The number of entities, layers, blocks and objects.
    count: usize,
}

impl<'a> SectionReader<'a> {
    fn new(text: &'a [u8]) -> Self {
        Self {
            file: File {
                text,
                unit_mm: None,
                layers: Named::default(),
                line_types: HashMap::new(),
                line_scale: 1.0,
                blocks: Named::default(),
                entities: Vec::new(),
                objects: HashMap::new(),
                mistakes: Vec::new(),
                is_imperial: false,
            },
            section: b"",
            variable: b"",
            application: b"",
            entity: None,
            handle: None,
            block: None,
            layer: None,
            line_type: None,
            count: 0,
        }
    }

    /// The file up to a mistake. An entity that may be incomplete is left out.
    fn cut_off(mut self, mistake: SourceError) -> File<'a> {
        self.entity = None;
        self.end_record();
        if let Some((name, block)) = self.block.take() {
            self.file.blocks.insert(name, block);
        }
        self.file.mistakes.push((mistake, REST_LEFT_OUT));
        self.file
    }

    fn pair(&mut self, pair: Pair<'a>) -> Result<(), SourceError> {
        if pair.code == 0 {
            self.end_entity(pair.at);
            self.count += 1;
        }
        if self.count > MAX_OBJECTS {
            return Err(too_many(self.file.text, pair.at));
        }
        match (pair.code, pair.value) {
            (0, b"SECTION" | b"ENDSEC") => {
                self.end_record();
                self.section = b"";
                return Ok(());
            }
            (2, name) if self.section.is_empty() => {
                self.section = name;
                return Ok(());
            }
            _ => {}
        }
        match self.section {
            b"HEADER" => self.header(pair),
            b"TABLES" => self.table(pair),
            b"BLOCKS" => self.block(pair),
            b"ENTITIES" => {
                self.entity_pair(pair);
                Ok(())
            }
            b"OBJECTS" => {
                self.object_pair(pair);
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn header(&mut self, pair: Pair<'a>) -> Result<(), SourceError> {
        if pair.code == 9 {
            self.variable = pair.value;
        } else if self.variable == b"$LTSCALE" {
            self.file.line_scale = pair.number()?;
        } else if self.variable == b"$MEASUREMENT" {
            self.file.is_imperial = pair.number()? == 0.0;
        } else if self.variable == b"$INSUNITS" {
            let code = pair.number()?;
            self.file.unit_mm = unit_mm(code);
            // 0 means unspecified.
            if code != 0.0 && self.file.unit_mm.is_none() {
                let found = format!("$INSUNITS {code}");
                let expected = "a supported unit of length: 1, 2, 4 to 6, 8 to 10, 13 or 14";
                return Err(SourceError::found(
                    self.file.text,
                    pair.value_at,
                    found,
                    expected,
                ));
            }
        }
        Ok(())
    }

    fn table(&mut self, pair: Pair<'a>) -> Result<(), SourceError> {
        if pair.code == 0 {
            self.end_record();
            if pair.value == b"LAYER" {
                self.layer = Some(Default::default());
                self.application = b"";
                self.count += LAYER_OBJECTS;
            }
            if pair.value == b"LTYPE" {
                self.line_type = Some(Default::default());
            }
            return Ok(());
        }
        if let Some((name, elements)) = &mut self.line_type {
            match pair.code {
                2 => *name = pair.text().to_uppercase(),
                49 if elements.len() < MAX_ELEMENTS => elements.push(pair.number()?),
                _ => {}
            }
            return Ok(());
        }
        let Some((name, info)) = &mut self.layer else {
            return Ok(());
        };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "numbers of colours and flags; saturates"
        )]
        match pair.code {
            2 => *name = pair.text().into_owned(),
            6 => info.line_type = pair.text().to_uppercase(),
            62 => info.color = Some(pair.number()? as i32),
            70 => info.is_frozen = pair.number()? as i32 & 1 != 0,
            290 => info.is_unplotted = pair.number()? == 0.0,
            420 => info.true_color = Some(pair.number()? as u32),
            1001 => self.application = pair.value,
            1071 if self.application == b"AcCmTransparency" => {
                info.transparency = pair.number()? as u32;
            }
            _ => {}
        }
        Ok(())
    }

    fn end_record(&mut self) {
        if let Some((name, info)) = self.layer.take() {
            self.file.layers.insert(name, info);
        }
        if let Some((name, elements)) = self.line_type.take()
            && let Some(line_type) = LineType::of(&elements)
        {
            self.file.line_types.insert(name, line_type);
        }
    }

    fn block(&mut self, pair: Pair<'a>) -> Result<(), SourceError> {
        match (pair.code, pair.value) {
            (0, b"BLOCK") => {
                self.block = Some(Default::default());
                self.count += BLOCK_OBJECTS;
            }
            (0, b"ENDBLK") => {
                if let Some((name, block)) = self.block.take() {
                    self.file.blocks.insert(name, block);
                }
            }
            _ if self.entity.is_some() || pair.code == 0 => self.entity_pair(pair),
            (code, _) => {
                let Some((name, block)) = &mut self.block else {
                    return Ok(());
                };
                match code {
                    2 => *name = pair.text().into_owned(),
                    10 => block.base.x = pair.number()?,
                    20 => block.base.y = pair.number()?,
                    _ => {}
                }
            }
        }
        Ok(())
    }

    fn entity_pair(&mut self, pair: Pair<'a>) {
        if pair.code == 0 {
            self.entity = Some(Span {
                kind: pair.value,
                at: pair.at,
                begin: pair.value_at,
                end: pair.value_at,
            });
        }
    }

    fn object_pair(&mut self, pair: Pair<'a>) {
        if pair.code == 5 && self.handle.is_none() {
            self.handle = Some(pair.value);
        }
        if matches!(
            pair.value,
            b"DICTIONARY" | b"SPATIAL_FILTER" | b"SORTENTSTABLE" | b"MLINESTYLE"
        ) {
            self.entity_pair(pair);
        }
    }

    fn end_entity(&mut self, end: usize) {
        let handle = self.handle.take();
        if let Some(mut span) = self.entity.take() {
            span.end = end;
            // After the line with its name.
            let rest = &self.file.text[span.begin..];
            span.begin += rest
                .iter()
                .position(|&byte| byte == b'\n')
                .map_or(rest.len(), |at| at + 1);
            match (&mut self.block, handle) {
                (Some((_, block)), _) => block.entities.push(span),
                (None, Some(handle)) => _ = self.file.objects.insert(handle, span),
                (None, None) => self.file.entities.push(span),
            }
        }
    }
}

/// Refuses more objects than the memory allows.
pub(super) fn too_many(text: &[u8], at: usize) -> SourceError {
    let found = format!("more than {MAX_OBJECTS} entities, layers, blocks and objects");
    let expected = "fewer; purge the drawing, or draw it in parts";
    SourceError::limit(text, at, found, expected)
}

/// The unit of a value of `$INSUNITS`.
fn unit_mm(code: f64) -> Option<f64> {
    const CODES: [(f64, f64); 11] = [
        (1.0, 25.4),
        (2.0, 304.8),
        (4.0, 1.0),
        (5.0, 10.0),
        (6.0, 1000.0),
        (8.0, 25.4e-6),
        (9.0, 0.0254),
        (10.0, 914.4),
        (13.0, 0.001),
        (14.0, 100.0),
        (21.0, 304.800_609_601_219),
    ];
    CODES.iter().find(|unit| unit.0 == code).map(|at| at.1)
}

/// Each object takes about 100 bytes, and a line as much again when drawn.
pub(super) const MAX_OBJECTS: usize = 1_000_000;
/// The cost of a layer, whose name is copied.
const LAYER_OBJECTS: usize = 10;
/// The cost of a block, whose name is copied.
const BLOCK_OBJECTS: usize = 2;
/// A line type has at most a dozen elements.
const MAX_ELEMENTS: usize = 64;
