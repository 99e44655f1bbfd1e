//! `JogParams.json` and `PlayBackParams.json`.

use dobot_wire::{Command, Configuration, PlaybackAdjustment, single};
use serde::{Deserialize, Serialize};

use super::bad;
use super::text::decode;
use crate::ProgramError;
use crate::number::{finite, within};
use crate::program::Speed;
use crate::step_table::LEAST_SPEED;

/// How fast jogs are: `JogParams.json`. What a file does not say is as the vendor's program has it at first.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "camelCase")]
pub struct JogParams {
    /// Acceleration of base, rear arm and forearm, in degrees/s2.
    #[serde(deserialize_with = "finite")]
    pub joint_acceleration: f64,
    /// Their speed, in degrees/s.
    #[serde(deserialize_with = "finite")]
    pub joint_velocity: f64,
    /// Acceleration along an axis, in mm/s2.
    #[serde(deserialize_with = "finite")]
    pub linear_acceleration: f64,
    /// Speed along an axis, in mm/s.
    #[serde(deserialize_with = "finite")]
    pub linear_velocity: f64,
    /// Acceleration of the servo, in degrees/s2.
    #[serde(deserialize_with = "finite")]
    pub servo_acceleration: f64,
    /// Its speed, in degrees/s.
    #[serde(deserialize_with = "finite")]
    pub servo_velocity: f64,
    /// All speeds, in percent: each jog carries it.
    #[serde(deserialize_with = "finite")]
    pub velocity_ratio: f64,
}

/// How fast targets are gone to: `PlayBackParams.json`. What a file does not say is as the vendor's program has it at
/// first.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "camelCase")]
pub struct PlaybackParams {
    /// All accelerations, in percent.
    #[serde(deserialize_with = "finite")]
    pub acceleration_ratio: f64,
    /// Acceleration of base, rear arm and forearm, in degrees/s2.
    #[serde(deserialize_with = "finite")]
    pub joint_acceleration: f64,
    /// Their speed, in degrees/s.
    #[serde(deserialize_with = "finite")]
    pub joint_velocity: f64,
    /// How high a JUMP lifts, in mm.
    #[serde(deserialize_with = "finite")]
    pub jump_height: f64,
    /// Acceleration along a line, in mm/s2.
    #[serde(deserialize_with = "finite")]
    pub linear_acceleration: f64,
    /// Speed along a line, in mm/s.
    #[serde(deserialize_with = "finite")]
    pub linear_velocity: f64,
    /// The pause of targets that have none, presumably in milliseconds; a stock arm takes no notice of it (note N10).
    #[serde(deserialize_with = "finite")]
    pub pause_time: f64,
    /// Acceleration of the servo, in degrees/s2.
    #[serde(deserialize_with = "finite")]
    pub servo_acceleration: f64,
    /// Its speed, in degrees/s.
    #[serde(deserialize_with = "finite")]
    pub servo_velocity: f64,
    /// All speeds, in percent.
    #[serde(deserialize_with = "finite")]
    pub velocity_ratio: f64,
}

impl Default for JogParams {
    fn default() -> Self {
        Self {
            joint_acceleration: 50.0,
            joint_velocity: 15.0,
            linear_acceleration: 40.0,
            linear_velocity: 40.0,
            servo_acceleration: 10.0,
            servo_velocity: 30.0,
            velocity_ratio: 50.0,
        }
    }
}

impl Default for PlaybackParams {
    fn default() -> Self {
        Self {
            acceleration_ratio: 38.0,
            joint_acceleration: 200.0,
            joint_velocity: 200.0,
            jump_height: 20.0,
            linear_acceleration: 200.0,
            linear_velocity: 200.0,
            pause_time: 100.0,
            servo_acceleration: 200.0,
            servo_velocity: 200.0,
            velocity_ratio: 48.0,
        }
    }
}

impl JogParams {
    /// Reads a file.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] with the line: no JSON, an unknown key, a value that is not allowed.
    pub fn read(bytes: &[u8]) -> Result<Self, ProgramError> {
        let it: Self = json(bytes)?;
        check(&it.speeds(), &[it.velocity_ratio])?;
        Ok(it)
    }

    /// Writes a file, as the vendor's program does.
    #[must_use]
    pub fn write(&self) -> String {
        pretty(self)
    }

    /// The command that sets it (state 9, mode 0); the ratio is part of each jog.
    #[must_use]
    pub fn command(&self) -> Command {
        Configuration::teach(self.speeds().map(single)).into()
    }

    const fn speeds(&self) -> [f64; 6] {
        [
            self.joint_velocity,
            self.joint_acceleration,
            self.servo_velocity,
            self.servo_acceleration,
            self.linear_velocity,
            self.linear_acceleration,
        ]
    }
}

impl PlaybackParams {
    /// Reads a file.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] with the line: no JSON, an unknown key, a value that is not allowed.
    pub fn read(bytes: &[u8]) -> Result<Self, ProgramError> {
        let it: Self = json(bytes)?;
        check(&it.speeds(), &[it.velocity_ratio, it.acceleration_ratio])?;
        let reason = |reason| bad(None, reason);
        within("jumpHeight", " mm", it.jump_height, 0.0, 300.0).map_err(reason)?;
        within("pauseTime", "", it.pause_time, 0.0, 655_000.0).map_err(reason)?;
        Ok(it)
    }

    /// Writes a file, as the vendor's program does.
    #[must_use]
    pub fn write(&self) -> String {
        pretty(self)
    }

    /// The commands that set it (states 9, mode 1, and 10).
    #[must_use]
    pub fn commands(&self) -> [Command; 2] {
        let speeds = self.speeds().map(single);
        let adjustment = PlaybackAdjustment {
            speed_percent: single(self.velocity_ratio),
            acceleration_percent: single(self.acceleration_ratio),
            teach_speed_percent: 100.0,
        };
        let pause_s = single(self.pause_time / 1000.0);
        [
            Configuration::playback(speeds, pause_s, single(self.jump_height)).into(),
            adjustment.into(),
        ]
    }

    /// The same as a step of a program, which has no pause for targets that say none.
    #[must_use]
    pub const fn speed(&self) -> Speed {
        Speed {
            percent: Some(self.velocity_ratio),
            acceleration_percent: Some(self.acceleration_ratio),
            joint: Some(self.joint_velocity),
            joint_acceleration: Some(self.joint_acceleration),
            servo: Some(self.servo_velocity),
            servo_acceleration: Some(self.servo_acceleration),
            line: Some(self.linear_velocity),
            line_acceleration: Some(self.linear_acceleration),
            jump_height: Some(self.jump_height),
        }
    }

    /// What a speed step says; what it does not say is as the vendor's program has it at first.
    #[must_use]
    pub fn of_speed(speed: &Speed) -> Self {
        let vendor = Self::default();
        Self {
            velocity_ratio: speed.percent.unwrap_or(vendor.velocity_ratio),
            acceleration_ratio: speed
                .acceleration_percent
                .unwrap_or(vendor.acceleration_ratio),
            joint_velocity: speed.joint.unwrap_or(vendor.joint_velocity),
            joint_acceleration: speed
                .joint_acceleration
                .unwrap_or(vendor.joint_acceleration),
            servo_velocity: speed.servo.unwrap_or(vendor.servo_velocity),
            servo_acceleration: speed
                .servo_acceleration
                .unwrap_or(vendor.servo_acceleration),
            linear_velocity: speed.line.unwrap_or(vendor.linear_velocity),
            linear_acceleration: speed
                .line_acceleration
                .unwrap_or(vendor.linear_acceleration),
            jump_height: speed.jump_height.unwrap_or(vendor.jump_height),
            ..vendor
        }
    }

    const fn speeds(&self) -> [f64; 6] {
        [
            self.joint_velocity,
            self.joint_acceleration,
            self.servo_velocity,
            self.servo_acceleration,
            self.linear_velocity,
            self.linear_acceleration,
        ]
    }
}

fn json<T: for<'de> Deserialize<'de>>(bytes: &[u8]) -> Result<T, ProgramError> {
    let (text, _) = decode(bytes);
    serde_json::from_str(&text).map_err(|error| bad(error.line(), error.to_string()))
}

fn check(speeds: &[f64], percents: &[f64]) -> Result<(), ProgramError> {
    let names = [
        "jointVelocity",
        "jointAcceleration",
        "servoVelocity",
        "servoAcceleration",
        "linearVelocity",
        "linearAcceleration",
    ];
    let ratios = ["velocityRatio", "accelerationRatio"];
    let speeds = names
        .iter()
        .zip(speeds)
        .map(|(name, it)| (name, it, 10_000.0));
    let ratios = ratios
        .iter()
        .zip(percents)
        .map(|(name, it)| (name, it, 100.0));
    for (name, found, most) in speeds.chain(ratios) {
        within(name, "", *found, LEAST_SPEED, most).map_err(|reason| bad(None, reason))?;
    }
    Ok(())
}

/// As the vendor's program writes it: four spaces, and whole numbers without a point.
fn pretty(it: &impl Serialize) -> String {
    let Ok(serde_json::Value::Object(fields)) = serde_json::to_value(it) else {
        return String::new();
    };
    let line = |(name, value): (&String, &serde_json::Value)| {
        let number = value.as_f64().unwrap_or_default();
        format!("    \"{name}\": {number}")
    };
    let lines: Vec<String> = fields.iter().map(line).collect();
    format!("{{\n{}\n}}\n", lines.join(",\n"))
}
