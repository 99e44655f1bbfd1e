//! The layers of a project (cut settings).

use std::collections::{BTreeMap, HashMap};

use usvg::roxmltree::Node;

use super::field::Field;
use crate::artwork::Layer;
use crate::error::SourceError;
use crate::place::printable;
use crate::sketch::Sketch;

/// The settings of a layer.
#[derive(Clone, Debug)]
pub(super) struct Cut {
    /// The name, unique among layers.
    pub(super) name: String,
    color: Option<[u8; 3]>,
    pub(super) filling: Option<Filling>,
    pub(super) output: Output,
    /// The position of the setting, in bytes; `None` for a layer without one.
    pub(super) at: Option<usize>,
    priority: i64,
}

/// The use of a layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Output {
    /// Burned.
    On,
    /// Burned, and not displayed.
    Hidden,
    /// Output switched off.
    Off,
    /// A tool layer (T1, T2), a drawing aid.
    Tool,
}

/// The shapes of a layer that are filled together, so that one inside another is a hole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Filling {
    /// The whole layer.
    Layer,
    /// Those of an outermost group.
    Group,
    /// Each separately.
    Shape,
}

impl Cut {
    pub(super) fn layer(&self) -> Layer {
        Layer {
            name: self.name.clone(),
            color: self.color,
            ..Layer::default()
        }
    }

    fn read(file: &str, node: Node<'_, '_>, index: u32) -> Result<Self, SourceError> {
        let mode = node.attribute("type").unwrap_or_default();
        let flag = |name| {
            Field::value(node, name)
                .map(|field| field.flag(file))
                .transpose()
        };
        let is_tool = mode == "Tool" || TOOLS.contains(&index);
        let output = match (is_tool, flag("doOutput")?, flag("hide")?) {
            (true, ..) => Output::Tool,
            (_, Some(false), _) => Output::Off,
            (.., Some(true)) => Output::Hidden,
            _ => Output::On,
        };
        let filling = match Field::value(node, "scanOpt").map(|field| field.text) {
            Some("byGroup") => Filling::Group,
            Some("individual") => Filling::Shape,
            _ => Filling::Layer,
        };
        let fills = mode.contains("Scan") || mode.contains("Offset");
        let name = Field::value(node, "name").map(|field| printable(field.text.trim()));
        let priority = Field::value(node, "priority").map(|field| field.number(file));
        #[expect(clippy::cast_possible_truncation, reason = "at most 1e9")]
        let priority = priority.transpose()?.map(|result| result as i64);
        Ok(Self {
            name: name
                .filter(|name| !name.is_empty())
                .unwrap_or_else(|| code(index)),
            color: palette_color(index),
            filling: fills.then_some(filling),
            output,
            at: Some(node.range().start),
            priority: priority.unwrap_or_else(|| i64::from(index)),
        })
    }

    /// The default of a layer without a setting: lines.
    fn default_of(index: u32) -> Self {
        let is_tool = TOOLS.contains(&index);
        Self {
            name: code(index),
            color: palette_color(index),
            filling: None,
            output: if is_tool { Output::Tool } else { Output::On },
            at: None,
            priority: i64::from(index),
        }
    }
}

/// The layers by number.
#[derive(Debug)]
pub(super) struct Cuts(BTreeMap<u32, Cut>);

impl Cuts {
    /// Reads the settings; one with a mistake is reported and left out.
    pub(super) fn read(
        file: &str,
        root: Node<'_, '_>,
        sketch: &mut Sketch<'_>,
    ) -> Result<Self, SourceError> {
        let mut cuts = BTreeMap::new();
        let settings = root
            .children()
            .filter(|child| child.has_tag_name("CutSetting"));
        for node in settings {
            let read = numbered(file, node).map(|(index, cut)| _ = cuts.insert(index, cut));
            sketch.skip_mistake(read, "the settings of its layer are left out")?;
        }
        let mut counts = HashMap::new();
        for cut in cuts.values() {
            *counts.entry(cut.name.clone()).or_insert(0) += 1;
        }
        for (index, cut) in &mut cuts {
            if counts[&cut.name] > 1 {
                cut.name = format!("{} ({})", cut.name, code(*index));
            }
        }
        Ok(Self(cuts))
    }

    /// The burned layers, in order.
    pub(super) fn in_order(&self) -> Vec<&Cut> {
        let is_burned = |cut: &&Cut| matches!(cut.output, Output::On | Output::Hidden);
        let mut cuts: Vec<&Cut> = self.0.values().filter(is_burned).collect();
        cuts.sort_by_key(|cut| cut.priority);
        cuts
    }

    pub(super) fn of(&mut self, index: u32) -> &Cut {
        self.0
            .entry(index)
            .or_insert_with(|| Cut::default_of(index))
    }
}

/// A setting with the number of its layer.
fn numbered(file: &str, node: Node<'_, '_>) -> Result<(u32, Cut), SourceError> {
    let index = Field::value(node, "index").ok_or_else(|| {
        let at = node.range().start;
        let found = "a <CutSetting> without an <index>";
        SourceError::found(file.as_bytes(), at, found, "<index Value=\"0\"/> in it")
    })?;
    let index = index.count(file)?;
    Ok((index, Cut::read(file, node, index)?))
}

/// The name of a layer without a name in `LightBurn`.
fn code(index: u32) -> String {
    match TOOLS.iter().position(|tool| *tool == index) {
        Some(tool) => format!("T{}", tool + 1),
        None => format!("C{index:02}"),
    }
}

/// The numbers of the tool layers.
const TOOLS: [u32; 2] = [30, 31];

/// The colour of a layer number, as in `LightBurn`.
fn palette_color(index: u32) -> Option<[u8; 3]> {
    let rgb = *PALETTE.get(usize::try_from(index).ok()?)?;
    let [_, red, green, blue] = rgb.to_be_bytes();
    Some([red, green, blue])
}

/// C00 to C29, and the tool layers T1 and T2.
const PALETTE: [u32; 32] = [
    0x00_00_00, 0x00_00_ff, 0xff_00_00, 0x00_e0_00, 0xd0_d0_00, 0xff_80_00, 0x00_e0_e0, 0xff_00_ff,
    0xb4_b4_b4, 0x00_00_a0, 0xa0_00_00, 0x00_a0_00, 0xa0_a0_00, 0xc0_80_00, 0x00_a0_ff, 0xa0_00_a0,
    0x80_80_80, 0x7d_87_b9, 0xbb_77_84, 0x4a_6f_e3, 0xd3_3f_6a, 0x8c_d7_8c, 0xf0_b9_8d, 0xf6_c4_e1,
    0xfa_9e_d4, 0x50_0a_78, 0xb4_5a_00, 0x00_47_54, 0x86_fa_88, 0xff_db_66, 0xf3_69_26, 0x0c_96_d9,
];
