//! The layers to draw, their tools and their order.

use dobot_import::{Layer, Warning};
use dobot_plan::{DrawingTool, MIN_BURN_MM_S, Pass, Plan, SlowBurning};

use super::passes::counted;
use super::{PrepareError, Settings};

/// Returns the layers to draw, combined into one unless they are drawn separately.
///
/// Layers with different speeds stay separate, because the file specifies how to draw each. Layers
/// that are not drawn follow at the end.
pub(super) fn chosen(
    layers: Vec<Layer>,
    settings: &Settings,
) -> Result<(Vec<Layer>, Vec<Layer>), PrepareError> {
    let layers = not_empty(layers);
    let is_layer = |name: &str| layers.iter().any(|layer| layer.name == name);
    let only: Vec<&str> = settings
        .only
        .iter()
        .flat_map(|asked| names(asked, is_layer))
        .collect();
    let tools = settings.tools.iter().map(|(name, _)| name.as_str());
    if let Some(unknown) = only
        .iter()
        .copied()
        .chain(tools)
        .find(|name| !is_layer(name))
    {
        let named = layers.iter().filter(|layer| !layer.name.is_empty());
        let names: Vec<String> = named.map(|layer| quoted(&layer.name)).collect();
        return Err(PrepareError::NoSuchLayer {
            name: unknown.to_owned(),
            layers: names.join(", "),
        });
    }
    if settings.layers.is_none() {
        return Ok((merged(layers), Vec::new()));
    }
    let is_wanted = |layer: &Layer| only.is_empty() || only.contains(&layer.name.as_str());
    let wanted: Vec<bool> = layers.iter().map(is_wanted).collect();
    let (chosen, left_out): (Vec<_>, Vec<_>) =
        layers.into_iter().zip(wanted).partition(|pair| pair.1);
    let layers = |all: Vec<(Layer, bool)>| all.into_iter().map(|pair| pair.0).collect();
    Ok((layers(chosen), layers(left_out)))
}

/// Returns the layers with lines or areas. A pause before an empty one is made before the next.
fn not_empty(layers: Vec<Layer>) -> Vec<Layer> {
    let mut pause = None;
    let layers = layers.into_iter().filter_map(|mut layer| {
        pause = layer.pause.take().or(pause.take());
        if layer.is_empty() {
            return None;
        }
        layer.pause = pause.take();
        Some(layer)
    });
    layers.collect()
}

/// Quotes a name for a comma-separated list.
fn quoted(name: &str) -> String {
    if name.contains(',') {
        format!("{name:?}")
    } else {
        name.to_owned()
    }
}

/// Splits a request at commas, unless a layer's name contains them.
fn names(asked: &str, is_layer: impl Fn(&str) -> bool) -> Vec<&str> {
    if is_layer(asked) {
        vec![asked]
    } else {
        asked.split(',').collect()
    }
}

/// Merges neighbouring layers of the same speed without a pause between them; common names and
/// colours are kept.
fn merged(layers: Vec<Layer>) -> Vec<Layer> {
    let mut merged: Vec<Layer> = Vec::new();
    for mut layer in layers {
        match merged.last_mut() {
            Some(last) if last.speed_mm_s == layer.speed_mm_s && layer.pause.is_none() => {
                last.strokes.append(&mut layer.strokes);
                last.areas.append(&mut layer.areas);
                last.color = last.color.filter(|color| layer.color == Some(*color));
                if last.name != layer.name {
                    last.name.clear();
                }
            }
            _ => merged.push(layer),
        }
    }
    merged
}

/// Returns the tool of a layer: its own or the common one. A laser uses the laser speed in the
/// file; a pen is not faster than the file specifies. A speed set by a person takes precedence.
pub(super) fn tool(layer: &Layer, settings: &Settings) -> DrawingTool {
    let own = settings.tools.iter().find(|(name, _)| *name == layer.name);
    let all = settings.tool;
    match (own, layer.speed_mm_s.filter(|_| !settings.keeps_speed)) {
        (Some((_, tool)), _) => *tool,
        (None, Some(mm_s)) if !all.burns() => all.at_speed(mm_s.min(all.speed_mm_s())),
        (None, Some(mm_s)) if layer.is_burned => all.at_speed(mm_s),
        (None, _) => all,
    }
}

/// Warns about burned layers for which the file has a pen speed.
pub(super) fn pen_speeds(layers: &[Layer], settings: &Settings) -> Option<Warning> {
    let has_pen_speed = |layer: &&Layer| layer.speed_mm_s.is_some() && !layer.is_burned;
    let count = layers.iter().filter(has_pen_speed).count();
    let matters = settings.tool.burns() && !settings.keeps_speed;
    counted(
        if matters { count } else { 0 },
        "layer with the speed of a pen",
        "burned at the speed of the material",
    )
}

/// Warns that there is nothing to hatch.
pub(super) fn unhatched(layers: &[Layer], settings: &Settings) -> Option<Warning> {
    let has_areas = layers.iter().any(|layer| !layer.areas.is_empty());
    (settings.hatch.is_some() && !has_areas)
        .then(|| Warning::new("hatching without filled areas", "nothing is hatched", 1))
}

/// Returns the message to the person before a layer: the pen is changed between layers that are
/// drawn separately, and a file may ask for a pause. A laser needs no change.
pub(super) fn message(layer: &Layer, before: Option<&Pass>, settings: &Settings) -> Option<String> {
    let changes = settings.layers.is_some() && !settings.tool.burns();
    let before = before.filter(|before| changes && before.name != layer.name);
    let change = before.map(|before| {
        format!(
            "put in the pen for {}; that of {} is done",
            layer.name, before.name
        )
    });
    change.or_else(|| {
        let label: String = layer.pause.as_ref()?.chars().take(LONGEST_LABEL).collect();
        Some(format!(
            "the file asks for a pause before the layer \"{label}\""
        ))
    })
}

/// Warns about layers that are burned slower, and so darker, than requested.
pub(super) fn slow_burning(plan: &Plan) -> Vec<Warning> {
    let warnings = plan.passes.iter().filter_map(|pass| {
        let SlowBurning {
            slow_mm,
            burned_mm,
            even_mm_s,
        } = plan.slow_burning(pass)?;
        let asked_mm_s = pass.tool.speed_mm_s();
        let even = if even_mm_s < MIN_BURN_MM_S.into() {
            String::new()
        } else {
            format!("; at {even_mm_s:.1} mm/s nearly all of it is even")
        };
        let instead = format!(
            "{slow_mm:.0} of its {burned_mm:.0} mm, down to {even_mm_s:.1} instead of {asked_mm_s:.1} mm/s, and so darker: corners, short vectors and the link allow no more{even}"
        );
        counted(1, "layer burned slower", &instead)
    });
    warnings.collect()
}

/// In characters: a message has at most 200.
const LONGEST_LABEL: usize = 70;
