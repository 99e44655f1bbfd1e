//! The dialects: one packet, two readings.

use core::fmt;
use core::str::FromStr;
use core::time::Duration;

/// The differences between the published document and the stock firmware (note N1).
///
/// Only this type distinguishes versions; all other code reads one of its fields.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "a dialect is a list of choices"
)]
pub struct Dialect {
    name: &'static str,
    /// Float 8 of a target: 1 is MOVJ and 2 MOVL, instead of 1 MOVL and 2 MOVJ (note N2).
    pub codes_movj_before_movl: bool,
    /// State 10: float 3 is the speed and float 4 the acceleration, instead of the other way round
    /// (note N3).
    pub adjusts_speed_first: bool,
    /// State 4: float 3 is -X instead of X (note N4).
    pub reverses_write_x: bool,
    /// State 4: float 8 is the start speed; otherwise the end speed of the vector before counts
    /// (note N5).
    pub uses_start_speed: bool,
    /// State 4: float 6 of 1 is a stop; otherwise it is reserved (note N7).
    pub has_write_stop: bool,
    /// State 9, mode 3: float 3 is 90 - rear instead of rear (note N8).
    pub complements_initial_rear: bool,
    /// State 1: the increments swing the base, the reach and the height in units of the mouse,
    /// instead of millimetres of Y, X and Z (note N9).
    pub mouse_swings: bool,
    /// State 8: the hand position is scaled and smoothed, instead of the place to go (note N18).
    pub scales_gesture: bool,
    /// State 9, mode 1: float 9 is the pause of targets that have none, instead of nothing
    /// (note N10).
    pub uses_default_pause: bool,
    /// The pause after a MOVJ or MOVL starts again as long as nothing follows (note N47).
    pub repeats_pause: bool,
    /// A straight line to where the arm stands makes it lose its pose, instead of doing nothing
    /// (note N34).
    pub loses_pose_on_the_spot: bool,
    /// The default lift of a JUMP, in millimetres (note N11).
    pub default_jump_height_mm: f32,
    /// A JUMP lifts by its height at either end, and all joints go together on each of its three
    /// ways, instead of across above the higher end (notes N11 and N45).
    pub jumps_by_joints: bool,
    /// Each joint of a MOVJ has ramps of its own, which stretch it to the time of the slowest, and the
    /// servo the acceleration of the other joints; instead of one profile for all (notes N29 and N45).
    pub stretches_joints: bool,
    /// The tool keeps its direction along a MOVL and turns at the end, instead of evenly along the
    /// line (notes N12 and N46).
    pub turns_after_line: bool,
    /// State 4 in laser mode: the height is held, the laser stays as it was set, and vectors
    /// without it accelerate a hundredfold, instead of moving as in writing mode (note N48).
    pub has_rapid_laser_mode: bool,
    /// State 10: float 5 scales all jogs, instead of nothing (note N15).
    pub scales_jogs: bool,
    /// Voice is received on the served port; otherwise it is lost (note N50).
    pub accepts_voice: bool,
    /// Ticks of motion and pause are counted in 16 bits: none may last longer than 655 s (note N51).
    pub counts_ticks_in_16_bits: bool,
    /// A straight line that was cut short is not forgotten: the next one begins that far along
    /// (note N46).
    pub resumes_cut_lines: bool,
    /// All axes jog with one speed, which only a release runs down: a switch stops the arm and keeps
    /// it (note N44).
    pub keeps_jog_speed: bool,
    /// How often a status comes while there is room in the queue (notes N20 and N27), in
    /// milliseconds.
    pub status_period_ms: u16,
}

impl Dialect {
    /// The published document taken at its word, with the choices of `docs/protocol.md` where it
    /// contradicts itself.
    pub const SPECIFICATION: Self = Self {
        name: "specification",
        codes_movj_before_movl: false,
        adjusts_speed_first: false,
        reverses_write_x: false,
        uses_start_speed: true,
        has_write_stop: false,
        complements_initial_rear: false,
        mouse_swings: false,
        scales_gesture: false,
        uses_default_pause: true,
        repeats_pause: false,
        loses_pose_on_the_spot: false,
        default_jump_height_mm: 20.0,
        jumps_by_joints: false,
        stretches_joints: false,
        turns_after_line: false,
        has_rapid_laser_mode: false,
        scales_jogs: true,
        accepts_voice: true,
        counts_ticks_in_16_bits: false,
        resumes_cut_lines: false,
        keeps_jog_speed: false,
        status_period_ms: 80,
    };

    /// Stock arms (firmware 1.1).
    pub const FIRMWARE_1_1: Self = Self {
        name: "firmware-1.1",
        codes_movj_before_movl: true,
        adjusts_speed_first: true,
        reverses_write_x: true,
        uses_start_speed: false,
        has_write_stop: true,
        complements_initial_rear: true,
        mouse_swings: true,
        scales_gesture: true,
        uses_default_pause: false,
        repeats_pause: true,
        loses_pose_on_the_spot: true,
        default_jump_height_mm: 10.0,
        jumps_by_joints: true,
        stretches_joints: true,
        turns_after_line: true,
        has_rapid_laser_mode: true,
        scales_jogs: false,
        accepts_voice: false,
        counts_ticks_in_16_bits: true,
        resumes_cut_lines: true,
        keeps_jog_speed: true,
        status_period_ms: 80,
    };

    /// All dialects that have a name.
    pub const ALL: [Self; 2] = [Self::SPECIFICATION, Self::FIRMWARE_1_1];

    /// The name by which a user chooses the dialect.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// From one status to the next while there is room in the queue.
    #[must_use]
    pub const fn status_period(&self) -> Duration {
        Duration::from_millis(self.status_period_ms as u64)
    }
}

impl fmt::Display for Dialect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name)
    }
}

impl FromStr for Dialect {
    type Err = UnknownDialect;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        Self::ALL
            .into_iter()
            .find(|dialect| dialect.name == name)
            .ok_or(UnknownDialect)
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Dialect {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name)
    }
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for Dialect {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = alloc::string::String::deserialize(deserializer)?;
        name.parse().map_err(serde::de::Error::custom)
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for Dialect {
    fn schema_name() -> alloc::borrow::Cow<'static, str> {
        "Dialect".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "description": "What the packets mean: as the published document says, or as stock arms do (firmware 1.1).",
            "type": "string",
            "enum": Self::ALL.map(|dialect| dialect.name),
        })
    }
}

/// A name that no dialect has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no such dialect; the names are \"specification\" and \"firmware-1.1\"")]
pub struct UnknownDialect;
