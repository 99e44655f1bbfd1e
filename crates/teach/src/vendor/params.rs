//! `JogParams.json` and `PlayBackParams.json`.

use dobot_wire::{Command, Configuration, PlaybackAdjustment, single};
use serde::{Deserialize, Serialize};
use serde_json::error::Category;
use serde_json::{Map, Value};

use super::bad;
use super::text::decode;
use crate::ProgramError;
use crate::number::{finite, within};
use crate::plain::plain;
use crate::program::Speed;
use crate::step_table::MIN_SPEED;

/// Speeds of jogs (`JogParams.json`). Values missing in a file are the initial ones of the vendor's
/// software.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "camelCase")]
pub struct JogParams {
    /// Acceleration of base, rear arm and forearm, in degrees/s2.
    #[serde(deserialize_with = "finite")]
    pub joint_acceleration: f64,
    /// Speed of base, rear arm and forearm, in degrees/s.
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
    /// Speed of the servo, in degrees/s.
    #[serde(deserialize_with = "finite")]
    pub servo_velocity: f64,
    /// Factor for all speeds, in percent; part of each jog.
    #[serde(deserialize_with = "finite")]
    pub velocity_ratio: f64,
}

/// Speeds of targets (`PlayBackParams.json`). Values missing in a file are the initial ones of the
/// vendor's software.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "camelCase")]
pub struct PlaybackParams {
    /// Factor for all accelerations, in percent.
    #[serde(deserialize_with = "finite")]
    pub acceleration_ratio: f64,
    /// Acceleration of base, rear arm and forearm, in degrees/s2.
    #[serde(deserialize_with = "finite")]
    pub joint_acceleration: f64,
    /// Speed of base, rear arm and forearm, in degrees/s.
    #[serde(deserialize_with = "finite")]
    pub joint_velocity: f64,
    /// The lift of a JUMP, in mm.
    #[serde(deserialize_with = "finite")]
    pub jump_height: f64,
    /// Acceleration along a line, in mm/s2.
    #[serde(deserialize_with = "finite")]
    pub linear_acceleration: f64,
    /// Speed along a line, in mm/s.
    #[serde(deserialize_with = "finite")]
    pub linear_velocity: f64,
    /// The pause of targets without their own, presumably in milliseconds; a stock arm ignores it
    /// (note N10).
    #[serde(deserialize_with = "finite")]
    pub pause_time: f64,
    /// Acceleration of the servo, in degrees/s2.
    #[serde(deserialize_with = "finite")]
    pub servo_acceleration: f64,
    /// Speed of the servo, in degrees/s.
    #[serde(deserialize_with = "finite")]
    pub servo_velocity: f64,
    /// Factor for all speeds, in percent.
    #[serde(deserialize_with = "finite")]
    pub velocity_ratio: f64,
}

/// The parameters of a file, recognised by their keys.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Params {
    /// Those of jogs.
    Jog(JogParams),
    /// Those of targets.
    Playback(PlaybackParams),
}

impl Params {
    /// Parses a file: with a key that only targets have, `PlayBackParams.json`, otherwise
    /// `JogParams.json`.
    ///
    /// # Errors
    ///
    /// Those of [`PlaybackParams::read`] and [`JogParams::read`].
    pub fn read(bytes: &[u8]) -> Result<Self, ProgramError> {
        let (text, _) = decode(bytes);
        let object: Option<Map<String, Value>> = serde_json::from_str(&text).ok();
        let is_jog =
            object.is_some_and(|object| object.keys().all(|key| JOG_KEYS.contains(&&**key)));
        if is_jog {
            JogParams::read(bytes).map(Self::Jog)
        } else {
            PlaybackParams::read(bytes).map(Self::Playback)
        }
    }
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
    /// Parses a file.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] with the line: not JSON, an unknown key, a value that is not allowed.
    pub fn read(bytes: &[u8]) -> Result<Self, ProgramError> {
        let params: Self = json(bytes)?;
        check(&params.speeds(), &[params.velocity_ratio])?;
        Ok(params)
    }

    /// Writes a file in the format of the vendor's software.
    #[must_use]
    pub fn write(&self) -> String {
        pretty(self)
    }

    /// The command that sets the speeds (state 9, mode 0); the ratio is part of each jog.
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
    /// Parses a file.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] with the line: not JSON, an unknown key, a value that is not allowed.
    pub fn read(bytes: &[u8]) -> Result<Self, ProgramError> {
        let params: Self = json(bytes)?;
        check(
            &params.speeds(),
            &[params.velocity_ratio, params.acceleration_ratio],
        )?;
        let reason = |reason| bad(None, reason);
        within("jumpHeight", " mm", params.jump_height, 0.0, 300.0).map_err(reason)?;
        within("pauseTime", "", params.pause_time, 0.0, 655_000.0).map_err(reason)?;
        Ok(params)
    }

    /// Writes a file in the format of the vendor's software.
    #[must_use]
    pub fn write(&self) -> String {
        pretty(self)
    }

    /// The commands that set the speeds (states 9, mode 1, and 10).
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

    /// The speeds as a step of a program; the pause is lost, because programs have no default
    /// pause.
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

    /// The parameters of a speed step; omitted values are the initial ones of the vendor's
    /// software.
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
    serde_json::from_str(&text).map_err(|error| {
        let message = error.to_string();
        // The parser appends the position, which the error has as its line.
        let message = message
            .rsplit_once(" at line ")
            .map_or(&*message, |parts| parts.0);
        let reason = match error.classify() {
            Category::Eof => {
                "the file ends too soon; a settings file is one JSON object".to_owned()
            }
            Category::Syntax => format!("not valid JSON: {message}"),
            Category::Data | Category::Io => plain(message),
        };
        bad(error.line(), reason)
    })
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
        .map(|(name, speed)| (name, speed, 10_000.0));
    let ratios = ratios
        .iter()
        .zip(percents)
        .map(|(name, ratio)| (name, ratio, 100.0));
    for (name, found, most) in speeds.chain(ratios) {
        within(name, "", *found, MIN_SPEED, most).map_err(|reason| bad(None, reason))?;
    }
    Ok(())
}

/// Formats like the vendor's software: four spaces, and whole numbers without a decimal point.
fn pretty(params: &impl Serialize) -> String {
    let Ok(serde_json::Value::Object(fields)) = serde_json::to_value(params) else {
        return String::new();
    };
    let line = |(name, value): (&String, &serde_json::Value)| {
        let number = value.as_f64().unwrap_or_default();
        format!("    \"{name}\": {number}")
    };
    let lines: Vec<String> = fields.iter().map(line).collect();
    format!("{{\n{}\n}}\n", lines.join(",\n"))
}

/// The keys of `JogParams.json`, which `PlayBackParams.json` has too.
const JOG_KEYS: [&str; 7] = [
    "jointAcceleration",
    "jointVelocity",
    "linearAcceleration",
    "linearVelocity",
    "servoAcceleration",
    "servoVelocity",
    "velocityRatio",
];
