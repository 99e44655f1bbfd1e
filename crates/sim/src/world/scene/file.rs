//! The keys of a scene file.

use serde::Deserialize;
use toml::Spanned;

use super::SceneError;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(super) struct File {
    pub(super) table: Option<Table>,
    pub(super) paper: Option<Paper>,
    pub(super) pen: Option<Spanned<Pen>>,
    pub(super) laser: Option<Spanned<Laser>>,
    pub(super) suction_cup: Option<Spanned<SuctionCup>>,
    pub(super) gripper: Option<Spanned<Gripper>>,
    #[serde(default)]
    pub(super) r#box: Vec<Spanned<Box>>,
    #[serde(default)]
    pub(super) cylinder: Vec<Spanned<Cylinder>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Table {
    pub(super) z_mm: Spanned<f64>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Paper {
    pub(super) x_mm: Spanned<[f64; 2]>,
    pub(super) y_mm: Spanned<[f64; 2]>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(
    clippy::struct_field_names,
    reason = "a number carries its unit; these happen to have the same"
)]
pub(super) struct Pen {
    pub(super) down_z_mm: Option<Spanned<f64>>,
    pub(super) give_mm: Option<Spanned<f64>>,
    pub(super) width_mm: Option<Spanned<f64>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Laser {
    pub(super) down_z_mm: Option<Spanned<f64>>,
    pub(super) give_mm: Option<Spanned<f64>>,
    pub(super) focus_mm: Option<Spanned<f64>>,
    pub(super) depth_mm: Option<Spanned<f64>>,
    pub(super) power_w: Option<Spanned<f64>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SuctionCup {
    pub(super) down_z_mm: Option<Spanned<f64>>,
    pub(super) give_mm: Option<Spanned<f64>>,
    pub(super) diameter_mm: Option<Spanned<f64>>,
    pub(super) lifts_g: Option<Spanned<f64>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Gripper {
    pub(super) down_z_mm: Option<Spanned<f64>>,
    pub(super) give_mm: Option<Spanned<f64>>,
    pub(super) open_mm: Option<Spanned<f64>>,
    pub(super) closed_mm: Option<Spanned<f64>>,
    pub(super) lifts_g: Option<Spanned<f64>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Box {
    pub(super) name: Option<Spanned<String>>,
    pub(super) size_mm: Spanned<[f64; 3]>,
    pub(super) at_mm: Spanned<[f64; 2]>,
    pub(super) turn_deg: Option<Spanned<f64>>,
    pub(super) mass_g: Option<Spanned<f64>>,
    pub(super) color: Option<Spanned<String>>,
    pub(super) on: Option<Spanned<String>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Cylinder {
    pub(super) name: Option<Spanned<String>>,
    pub(super) diameter_mm: Spanned<f64>,
    pub(super) height_mm: Spanned<f64>,
    pub(super) at_mm: Spanned<[f64; 2]>,
    pub(super) mass_g: Option<Spanned<f64>>,
    pub(super) color: Option<Spanned<String>>,
    pub(super) on: Option<Spanned<String>>,
}

pub(super) fn read(text: &str) -> Result<File, SceneError> {
    toml::from_str(text).map_err(|error| SceneError::Syntax {
        line: line(text, error.span().map_or(0, |span| span.start)),
        reason: error.message().lines().collect::<Vec<_>>().join(", "),
    })
}

/// The line of a byte of the text, from 1.
pub(super) fn line(text: &str, byte: usize) -> usize {
    let before = text.get(..byte).unwrap_or(text);
    1 + before.matches('\n').count()
}
