//! Conversion of requested velocities to jog buttons: the arm jogs one axis at a time.

use dobot_api::{Button, Jog};
use dobot_motion::ArmSettings;
use dobot_wire::{Dialect, JointJogAxis as J, LinearJogAxis as L, single};

use crate::frames::Frames;
use crate::joints::JOINTS;
use crate::messages::{JointJog, TwistStamped, Vector3};

/// Returns the button for a twist in the base frame; `None` if all components are 0.
///
/// # Errors
///
/// The problem, and what is allowed.
pub(crate) fn of_twist(wanted: &TwistStamped, frames: &Frames) -> Result<Option<Jog>, String> {
    frames.check_base(&wanted.header)?;
    let (linear, angular) = (&wanted.twist.linear, &wanted.twist.angular);
    let Vector3 { x, y, z: turn } = *angular;
    if x != 0.0 || y != 0.0 {
        return Err(format!(
            "twist.angular tilts the tool (x {x}, y {y}); allowed are rotations about z: the arm keeps its tool level"
        ));
    }
    let (mm_s, servo_deg_s) = (top().line_mm_s, top().servo_deg_s);
    let metres = |name, speed: f64, up, down| Axis {
        name,
        speed: speed * 1000.0,
        buttons: [Button::Linear(up), Button::Linear(down)],
        top: mm_s,
        unit: Unit::Metres,
    };
    one([
        metres("twist.linear.x", linear.x, L::XPlus, L::XMinus),
        metres("twist.linear.y", linear.y, L::YPlus, L::YMinus),
        metres("twist.linear.z", linear.z, L::ZPlus, L::ZMinus),
        Axis {
            name: "twist.angular.z",
            speed: turn.to_degrees(),
            buttons: [Button::Joint(J::ServoPlus), Button::Joint(J::ServoMinus)],
            top: servo_deg_s,
            unit: Unit::Radians,
        },
    ])
}

/// Returns the button for joint velocities; `None` if all of them are 0.
///
/// # Errors
///
/// The problem, and what is allowed.
pub(crate) fn of_joints(wanted: &JointJog) -> Result<Option<Jog>, String> {
    let (names, speeds) = (&wanted.joint_names, &wanted.velocities);
    if wanted
        .displacements
        .iter()
        .any(|displacement| *displacement != 0.0)
    {
        return Err("displacements are given; allowed are velocities in rad/s".to_owned());
    }
    if names.len() != speeds.len() {
        let (names, speeds) = (names.len(), speeds.len());
        return Err(format!(
            "there are {names} joint_names and {speeds} velocities; allowed are as many of each"
        ));
    }
    let axes: Result<Vec<Axis>, String> = names.iter().zip(speeds).map(joint).collect();
    one(axes?)
}

fn joint((name, rad_s): (&String, &f64)) -> Result<Axis, String> {
    let Some(at) = JOINTS.iter().position(|joint| joint == name) else {
        return Err(format!(
            "joint_names has {name:?}; allowed are {}",
            JOINTS.join(", ")
        ));
    };
    let (top, buttons) = match at {
        0 => (top().joint_deg_s, [J::BasePlus, J::BaseMinus]),
        1 => (top().joint_deg_s, [J::RearPlus, J::RearMinus]),
        2 => (top().joint_deg_s, [J::ForePlus, J::ForeMinus]),
        _ => (top().servo_deg_s, [J::ServoPlus, J::ServoMinus]),
    };
    Ok(Axis {
        name: JOINTS[at],
        speed: rad_s.to_degrees(),
        buttons: buttons.map(Button::Joint),
        top,
        unit: Unit::Radians,
    })
}

/// An axis and its requested speed, in mm/s or degrees/s.
struct Axis {
    name: &'static str,
    speed: f64,
    /// The buttons for positive and negative speeds.
    buttons: [Button; 2],
    /// The speed of a button at 100 %.
    top: f64,
    unit: Unit,
}

enum Unit {
    Metres,
    Radians,
}

impl Unit {
    /// Formats a speed in the unit of the messages.
    fn text(&self, speed: f64) -> String {
        match self {
            Self::Metres => format!("{:.4} m/s", speed / 1000.0),
            Self::Radians => format!("{:.4} rad/s", speed.to_radians()),
        }
    }
}

/// Returns the button of the only moving axis.
fn one(axes: impl IntoIterator<Item = Axis>) -> Result<Option<Jog>, String> {
    let mut moving = axes.into_iter().filter(|axis| axis.speed != 0.0);
    let Some(axis) = moving.next() else {
        return Ok(None);
    };
    let others: Vec<_> = moving.map(|moving| moving.name).collect();
    if !others.is_empty() {
        let (name, others) = (axis.name, others.join(", "));
        return Err(format!(
            "{name} and {others} are not 0; allowed is one axis at a time"
        ));
    }
    axis.jog().map(Some)
}

impl Axis {
    fn jog(self) -> Result<Jog, String> {
        let percent = single(self.speed.abs() / self.top * 100.0);
        if !(MIN_PERCENT..=100.0).contains(&percent) {
            let least = self.unit.text(self.top / 100.0);
            let (name, found, most) = (
                self.name,
                self.unit.text(self.speed),
                self.unit.text(self.top),
            );
            return Err(format!(
                "{name} is {found}; allowed are 0, and {least} to {most} in either direction"
            ));
        }
        let [up, down] = self.buttons;
        let button = if self.speed > 0.0 { up } else { down };
        Ok(button.jog(percent))
    }
}

/// Returns the speeds of buttons at 100 %, for an arm with the default configuration.
fn top() -> dobot_motion::Speeds {
    ArmSettings::stock(&Dialect::FIRMWARE_1_1).teach
}

/// The slowest speed of a button (note N15).
const MIN_PERCENT: f32 = 1.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_wire::{JointJog as JointButton, LinearJog};

    use super::*;
    use crate::messages::{Header, Twist};

    fn twist(linear: [f64; 3], angular: [f64; 3]) -> Result<Option<Jog>, String> {
        let vector = |[x, y, z]: [f64; 3]| Vector3 { x, y, z };
        let wanted = TwistStamped {
            header: Header::now("base"),
            twist: Twist {
                linear: vector(linear),
                angular: vector(angular),
            },
        };
        of_twist(&wanted, &Frames::new("/"))
    }

    fn joints(names: &[&str], velocities: &[f64]) -> Result<Option<Jog>, String> {
        of_joints(&JointJog {
            header: Header::now(""),
            joint_names: names.iter().map(|name| (*name).to_owned()).collect(),
            displacements: Vec::new(),
            velocities: velocities.to_vec(),
            duration: 0.0,
        })
    }

    #[test]
    fn half_the_jog_speed_of_sixty_millimetres_a_second_is_fifty_percent() {
        let jog = twist([0.0, -0.03, 0.0], [0.0; 3]);
        assert_eq!(jog, Ok(Some(Jog::Linear(LinearJog::new(L::YMinus, 50.0)))));
        let jog = twist([0.0, 0.0, 0.06], [0.0; 3]);
        assert_eq!(jog, Ok(Some(Jog::Linear(LinearJog::new(L::ZPlus, 100.0)))));
        let jog = joints(&["fore", "base"], &[0.0, 3_f64.to_radians()]);
        assert_eq!(
            jog,
            Ok(Some(Jog::Joint(JointButton::new(J::BasePlus, 20.0))))
        );
    }

    #[test]
    fn a_twist_of_zeros_releases_the_button() {
        assert_eq!(twist([0.0; 3], [0.0, -0.0, 0.0]), Ok(None));
        assert_eq!(joints(&["base", "servo"], &[0.0, 0.0]), Ok(None));
        assert_eq!(joints(&[], &[]), Ok(None));
    }

    #[test]
    fn an_impossible_motion_is_refused_by_name_with_the_possible_ones() {
        for (found, expected) in [
            (
                twist([0.01, 0.0, 0.01], [0.0; 3]),
                "twist.linear.x and twist.linear.z",
            ),
            (
                twist([0.5, 0.0, 0.0], [0.0; 3]),
                "allowed are 0, and 0.0006 m/s to 0.0600 m/s",
            ),
            (
                twist([1e-6, 0.0, 0.0], [0.0; 3]),
                "twist.linear.x is 0.0000 m/s",
            ),
            (
                twist([f64::NAN, 0.0, 0.0], [0.0; 3]),
                "twist.linear.x is NaN",
            ),
            (twist([0.0; 3], [0.1, 0.0, 0.0]), "tilts"),
            (twist([0.0; 3], [0.0, f64::NAN, 0.0]), "tilts"),
            (joints(&["elbow"], &[0.1]), "base, rear, fore, servo"),
            (joints(&["base"], &[]), "1 joint_names and 0 velocities"),
            (joints(&["base"], &[f64::INFINITY]), "base is inf rad/s"),
            (joints(&["base", "base"], &[0.1, 0.1]), "base and base"),
        ] {
            let found = found.unwrap_err();
            assert!(found.contains(expected), "{found}");
        }
    }
}
