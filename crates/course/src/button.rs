//! The buttons of the jog panel.

use dobot_wire::{Command, JointJog, JointJogAxis, LinearJog, LinearJogAxis};

/// What a button of the jog panel does (Table 2.5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Button {
    /// The button that was held is released.
    Released,
    /// A button is held: the axis moves until told otherwise.
    Held {
        /// What moves.
        axis: JogAxis,
        /// The share of the axis's speed, -1 to 1; its sign is the direction.
        share: f64,
    },
    /// The pump.
    Suction(bool),
    /// The laser.
    Laser(bool),
}

/// What a jog moves.
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
    /// The gripper, which moves nothing else.
    Gripper,
    /// The tool along X.
    X,
    /// The tool along Y.
    Y,
    /// The tool along Z.
    Z,
}

impl Button {
    /// The button that a command presses; `None` where it is no jog.
    #[must_use]
    pub fn of(command: &Command) -> Option<Self> {
        match command {
            Command::JointJog(jog) => Some(of_joint(*jog)),
            Command::LinearJog(jog) => Some(of_linear(*jog)),
            _ => None,
        }
    }

    /// What releases the button that a command holds: a release of the same kind, joint (state 2) or
    /// linear (state 7). On a stock arm one of the other kind runs down the axis of the same number
    /// there, the forearm for Z (note N44). `None` where the command holds no button.
    #[must_use]
    pub fn release_of(command: &Command) -> Option<Command> {
        let Self::Held { .. } = Self::of(command)? else {
            return None;
        };
        let speed_percent = 0.0;
        Some(match command {
            Command::LinearJog(_) => {
                Command::LinearJog(LinearJog::new(LinearJogAxis::Released, speed_percent))
            }
            _ => Command::JointJog(JointJog::new(JointJogAxis::Released, speed_percent)),
        })
    }
}

fn of_joint(jog: JointJog) -> Button {
    use JointJogAxis as A;
    let share = f64::from(jog.speed_percent) / 100.0;
    match jog.axis {
        A::Released => Button::Released,
        A::BasePlus => held(JogAxis::Base, share),
        A::BaseMinus => held(JogAxis::Base, -share),
        A::RearPlus => held(JogAxis::Rear, share),
        A::RearMinus => held(JogAxis::Rear, -share),
        A::ForePlus => held(JogAxis::Fore, share),
        A::ForeMinus => held(JogAxis::Fore, -share),
        A::ServoPlus => held(JogAxis::Servo, share),
        A::ServoMinus => held(JogAxis::Servo, -share),
        A::GripperOpen => held(JogAxis::Gripper, share),
        A::GripperClose => held(JogAxis::Gripper, -share),
        A::SuctionOn => Button::Suction(true),
        A::SuctionOff => Button::Suction(false),
        A::LaserOn => Button::Laser(true),
        A::LaserOff => Button::Laser(false),
    }
}

fn of_linear(jog: LinearJog) -> Button {
    use LinearJogAxis as A;
    let share = f64::from(jog.speed_percent) / 100.0;
    match jog.axis {
        A::Released => Button::Released,
        A::XPlus => held(JogAxis::X, share),
        A::XMinus => held(JogAxis::X, -share),
        A::YPlus => held(JogAxis::Y, share),
        A::YMinus => held(JogAxis::Y, -share),
        A::ZPlus => held(JogAxis::Z, share),
        A::ZMinus => held(JogAxis::Z, -share),
        A::ServoPlus => held(JogAxis::Servo, share),
        A::ServoMinus => held(JogAxis::Servo, -share),
        A::GripperOpen => held(JogAxis::Gripper, share),
        A::GripperClose => held(JogAxis::Gripper, -share),
        A::SuctionOn => Button::Suction(true),
        A::SuctionOff => Button::Suction(false),
        A::LaserOn => Button::Laser(true),
        A::LaserOff => Button::Laser(false),
    }
}

const fn held(axis: JogAxis, share: f64) -> Button {
    Button::Held { axis, share }
}
