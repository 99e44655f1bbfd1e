//! The buttons of the jog panel.

use dobot_wire::{Command, JointJog, JointJogAxis, LinearJog, LinearJogAxis};

/// The effect of a jog panel button (Table 2.5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Button {
    /// The held button is released.
    Released,
    /// A button is held: the axis moves until its release.
    Held {
        /// The axis.
        axis: JogAxis,
        /// The share of the axis's speed, -1 to 1; the sign is the direction.
        share: f64,
    },
    /// The pump switches.
    Suction(bool),
    /// The laser switches.
    Laser(bool),
}

/// The axis of a jog.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum JogAxis {
    /// Joint 1.
    Base,
    /// Joint 2.
    Rear,
    /// Joint 3.
    Fore,
    /// Joint 4.
    Servo,
    /// The gripper; the arm itself does not move.
    Gripper,
    /// The tool along X.
    X,
    /// The tool along Y.
    Y,
    /// The tool along Z.
    Z,
}

impl Button {
    /// Returns the button that a command presses; `None` if it is not a jog.
    #[must_use]
    pub fn of(command: &Command) -> Option<Self> {
        match command {
            Command::JointJog(JointJog {
                axis,
                speed_percent,
            }) => {
                let joints = [JogAxis::Base, JogAxis::Rear, JogAxis::Fore];
                Some(button(*axis as u8, joints, *speed_percent))
            }
            Command::LinearJog(LinearJog {
                axis,
                speed_percent,
            }) => {
                let along = [JogAxis::X, JogAxis::Y, JogAxis::Z];
                Some(button(*axis as u8, along, *speed_percent))
            }
            _ => None,
        }
    }

    /// Returns the command that releases the button held by a command: a release of the same kind,
    /// joint (state 2) or linear (state 7). On a stock arm, a release of the other kind ramps down
    /// the axis of the same number there, the forearm for Z (note N44). `None` if the command holds
    /// no button.
    #[must_use]
    pub fn release_of(command: &Command) -> Option<Command> {
        let Self::Held { .. } = Self::of(command)? else {
            return None;
        };
        Some(match command {
            Command::LinearJog(_) => LinearJog::new(LinearJogAxis::Released, 0.0).into(),
            _ => JointJog::new(JointJogAxis::Released, 0.0).into(),
        })
    }
}

/// Returns the button of a code whose first six values move these three axes.
fn button(code: u8, [first, second, third]: [JogAxis; 3], speed_percent: f32) -> Button {
    let share = f64::from(speed_percent) / 100.0;
    let held = |axis, share| Button::Held { axis, share };
    match code {
        1 => held(first, share),
        2 => held(first, -share),
        3 => held(second, share),
        4 => held(second, -share),
        5 => held(third, share),
        6 => held(third, -share),
        7 => held(JogAxis::Servo, share),
        8 => held(JogAxis::Servo, -share),
        9 => Button::Suction(true),
        10 => Button::Suction(false),
        11 => held(JogAxis::Gripper, share),
        12 => held(JogAxis::Gripper, -share),
        13 => Button::Laser(true),
        14 => Button::Laser(false),
        _ => Button::Released,
    }
}
