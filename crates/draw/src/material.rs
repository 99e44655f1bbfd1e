//! Materials: named settings for pens and lasers.

mod error;
mod read;

use std::collections::BTreeMap;

pub use self::error::{MaterialError, UnknownMaterial};
use dobot_plan::DrawingTool;

/// The settings of a pen or a laser for a material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// The tool: speeds, lift of a pen, number of passes of a laser.
    pub tool: DrawingTool,
    /// The line spacing of hatched areas, in mm.
    pub spacing_mm: f64,
}

/// Materials by name.
///
/// A materials file is TOML with one table per material:
///
/// ```
/// use dobot_draw::Materials;
/// use dobot_plan::DrawingTool;
///
/// let mine = Materials::from_toml("
///     [materials.plywood-3mm]
///     tool = 'laser'
///     speed_mm_s = 4
///     passes = 3
///     spacing_mm = 0.15
/// ")?;
/// let materials = Materials::built_in().with(mine);
/// let plywood = materials.get("plywood-3mm")?;
/// assert!(matches!(plywood.tool, DrawingTool::Laser(laser) if laser.times == 3));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// | key | for | unit | from | to | if not given |
/// |---|---|---|---|---|---|
/// | `tool` | | | `"pen"` | `"laser"` | an error |
/// | `speed_mm_s` | both | mm/s | 0.1 | 500 | an error |
/// | `travel_speed_mm_s` | both | mm/s | 0.1 | 500 | 80 |
/// | `spacing_mm` | both | mm | 0.05 | 20 | 0.5 |
/// | `passes` | laser | | 1 | 100 | 1 |
/// | `cuts` | laser | | `false` | `true` | `false` |
/// | `lift_mm` | pen | mm | 0.1 | 100 | as [`Pen`](dobot_plan::Pen) |
/// | `lift_speed_mm_s` | pen | mm/s | 0.1 | 500 | as [`Pen`](dobot_plan::Pen) |
/// | `touch_mm` | pen | mm | 0 | 20 | as [`Pen`](dobot_plan::Pen) |
/// | `touch_speed_mm_s` | pen | mm/s | 0.1 | 500 | as [`Pen`](dobot_plan::Pen) |
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Materials {
    named: BTreeMap<String, Material>,
}

impl Materials {
    /// The built-in materials as a file that explains each key.
    pub const BUILT_IN_TOML: &str = include_str!("../materials.toml");

    /// Returns the built-in materials: a few pens, and a few materials for an on/off diode laser of
    /// about 500 mW. They are starting points; a [`Card`](crate::Card) finds the right values.
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "the file is part of the program")]
    pub fn built_in() -> Self {
        Self::from_toml(Self::BUILT_IN_TOML).expect("a test reads the built-in file")
    }

    /// Reads a materials file.
    ///
    /// # Errors
    ///
    /// [`MaterialError`] with the line: invalid TOML, an unknown key, a value of the wrong type or
    /// out of range, or a missing key.
    pub fn from_toml(text: &str) -> Result<Self, MaterialError> {
        let named = read::materials(text)?;
        Ok(Self { named })
    }

    /// Adds other materials; they take precedence over those of the same name.
    #[must_use]
    pub fn with(mut self, others: Self) -> Self {
        self.named.extend(others.named);
        self
    }

    /// Returns the material with this name.
    ///
    /// # Errors
    ///
    /// [`UnknownMaterial`] with the known names.
    pub fn get(&self, name: &str) -> Result<&Material, UnknownMaterial> {
        self.named.get(name).ok_or_else(|| UnknownMaterial {
            name: name.to_owned(),
            known: self.named.keys().cloned().collect(),
        })
    }

    /// Returns all materials with their names, in alphabetical order.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Material)> {
        self.named
            .iter()
            .map(|(name, material)| (name.as_str(), material))
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use dobot_plan::{Laser, Pen};

    #[test]
    fn the_built_in_materials_are_a_few_pens_and_a_few_for_the_laser() {
        let materials = Materials::built_in();
        let lasers = materials
            .iter()
            .filter(|(_, material)| matches!(material.tool, DrawingTool::Laser(_)));
        assert!(lasers.count() >= 5);
        for pen in ["fineliner", "ballpoint", "pencil", "brush-pen", "marker"] {
            assert!(
                matches!(materials.get(pen).unwrap().tool, DrawingTool::Pen(_)),
                "{pen}"
            );
        }
    }

    #[test]
    fn missing_settings_have_the_defaults_of_the_tool() {
        let text = "[materials.a]\ntool = 'pen'\nspeed_mm_s = 7.5\n\
                    [materials.b]\ntool = 'laser'\nspeed_mm_s = 2\npasses = 3\nspacing_mm = 0.1\n";
        let materials = Materials::from_toml(text).unwrap();
        let pen = Pen {
            draw_speed_mm_s: 7.5,
            ..Pen::default()
        };
        assert_eq!(materials.get("a").unwrap().tool, DrawingTool::Pen(pen));
        let laser = Laser {
            burn_speed_mm_s: 2.0,
            times: 3,
            ..Laser::default()
        };
        let burned = Material {
            tool: DrawingTool::Laser(laser),
            spacing_mm: 0.1,
        };
        assert_eq!(materials.get("b"), Ok(&burned));
    }

    #[test]
    fn a_users_material_replaces_the_built_in_one_of_its_name() {
        let mine = "[materials.fineliner]\ntool = 'pen'\nspeed_mm_s = 11\n";
        let mine = Materials::from_toml(mine).unwrap();
        let both = Materials::built_in().with(mine.clone());
        assert_eq!(both.get("fineliner"), mine.get("fineliner"));
        assert!(both.get("pencil").is_ok());
    }

    #[test]
    fn an_unknown_name_is_reported_with_the_known_ones() {
        let text = "[materials.felt]\ntool = 'pen'\nspeed_mm_s = 7\n\
                    [materials.slate]\ntool = 'laser'\nspeed_mm_s = 7\n";
        let error = Materials::from_toml(text).unwrap().get("slat").unwrap_err();
        assert_eq!(
            error.to_string(),
            "there is no material 'slat'; did you mean 'slate'? there are: felt, slate"
        );
        let error = Materials::from_toml("").unwrap().get("felt").unwrap_err();
        assert_eq!(
            error.to_string(),
            "there is no material 'felt'; there are none"
        );
    }
}
