//! A gamepad through the joystick driver of Linux, whose events have eight bytes.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use anyhow::Context;
use dobot_wire::LinearJogAxis;
use tokio::sync::mpsc::{UnboundedReceiver, unbounded_channel};

use crate::failure::Failure;
use dobot_api::Button;

/// The gamepad option.
#[derive(Clone, Debug, Default, clap::Args)]
pub(crate) struct PadArgs {
    /// Gamepad device (Linux), for example /dev/input/js0: sticks move the arm while they are held, A and B switch
    /// the pump, the shoulder buttons move the gripper, every other button stops the arm
    #[arg(long, value_name = "DEVICE", hide_short_help = true)]
    gamepad: Option<PathBuf>,
}

/// An action of a gamepad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum PadAction {
    /// Hold a button, at a fraction of the speed.
    Hold(Button, f32),
    /// Release the held button.
    Release,
    /// Switch the pump.
    Suction(bool),
    /// Stop the arm.
    Stop,
}

/// The state of a gamepad.
#[derive(Debug)]
pub(crate) struct Gamepad {
    /// The positions of the axes, -32767 to 32767.
    axes: [i16; AXES],
    /// The held shoulder button.
    shoulder: Option<LinearJogAxis>,
}

impl Gamepad {
    /// Creates a gamepad at rest.
    pub(crate) const fn new() -> Self {
        Self {
            axes: [0; AXES],
            shoulder: None,
        }
    }

    /// Handles an event: time (4 bytes), value (2), kind, number, in native byte order.
    pub(crate) fn handle(&mut self, event: [u8; EVENT_LEN]) -> Option<PadAction> {
        let [_, _, _, _, low, high, kind, number] = event;
        let value = i16::from_ne_bytes([low, high]);
        match kind {
            AXIS => {
                *self.axes.get_mut(usize::from(number))? = value;
                Some(self.held())
            }
            BUTTON => self.press(number, value != 0),
            // The initial positions move nothing.
            _ => None,
        }
    }

    fn press(&mut self, number: u8, pressed: bool) -> Option<PadAction> {
        match (number, pressed) {
            (4 | 5, true) => {
                let closes = number == 4;
                self.shoulder = Some(if closes {
                    LinearJogAxis::GripperClose
                } else {
                    LinearJogAxis::GripperOpen
                });
                Some(self.held())
            }
            (4 | 5, false) => {
                self.shoulder = None;
                Some(self.held())
            }
            (0 | 1, true) => Some(PadAction::Suction(number == 0)),
            (_, true) => Some(PadAction::Stop),
            (_, false) => None,
        }
    }

    /// The held shoulder button, or the stick with the largest deflection.
    fn held(&self) -> PadAction {
        if let Some(axis) = self.shoulder {
            return PadAction::Hold(Button::Linear(axis), 1.0);
        }
        let deflected = STICKS.iter().map(|(axis, ..)| share(self.axes[*axis]));
        let sticks = STICKS.iter().zip(deflected);
        let strongest = sticks.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        match strongest {
            Some(((_, minus, plus), share)) if share != 0.0 => {
                let axis = if share < 0.0 { *minus } else { *plus };
                PadAction::Hold(Button::Linear(axis), share.abs())
            }
            _ => PadAction::Release,
        }
    }
}

/// The deflection of a stick beyond its dead zone, -1 to 1.
fn share(value: i16) -> f32 {
    let value = f32::from(value) / f32::from(i16::MAX);
    let beyond = ((value.abs() - DEAD_ZONE) / (1.0 - DEAD_ZONE)).clamp(0.0, 1.0);
    beyond.copysign(value)
}

impl PadArgs {
    /// Opens the gamepad, if any, and returns its events, which end with the device.
    ///
    /// # Errors
    ///
    /// If the device cannot be opened.
    pub(crate) fn open(&self) -> Result<Option<PadEvents>, Failure> {
        let Some(device) = &self.gamepad else {
            return Ok(None);
        };
        let file = open(device)?;
        let (sender, events) = unbounded_channel();
        // A blocking read cannot be cancelled: the thread ends with the device or the program.
        std::thread::spawn(move || {
            let (mut file, mut event) = (file, [0; EVENT_LEN]);
            while file.read_exact(&mut event).is_ok() && sender.send(event).is_ok() {}
        });
        Ok(Some(events))
    }
}

fn open(device: &Path) -> Result<File, Failure> {
    let file = File::open(device);
    let file = file.with_context(|| format!("cannot open the gamepad {}", device.display()));
    file.map_err(|error| {
        Failure::new(
            error,
            "name a device such as /dev/input/js0, and join the group `input` if access is denied",
        )
    })
}

/// Events of a gamepad.
pub(crate) type PadEvents = UnboundedReceiver<[u8; EVENT_LEN]>;

/// The axes with the jogs of their negative and positive sides; up and left are negative. Left stick, right
/// stick and directional pad.
const STICKS: [(usize, LinearJogAxis, LinearJogAxis); 6] = {
    use LinearJogAxis as L;
    [
        (0, L::YPlus, L::YMinus),
        (1, L::XPlus, L::XMinus),
        (3, L::ServoPlus, L::ServoMinus),
        (4, L::ZPlus, L::ZMinus),
        (6, L::YPlus, L::YMinus),
        (7, L::XPlus, L::XMinus),
    ]
};
const AXES: usize = 8;
/// `struct js_event` of Linux.
pub(crate) const EVENT_LEN: usize = 8;
const BUTTON: u8 = 1;
const AXIS: u8 = 2;
/// The maximum deflection of a stick at rest.
const DEAD_ZONE: f32 = 0.25;

#[cfg(test)]
mod tests {
    use super::*;

    fn event(kind: u8, number: u8, value: i16) -> [u8; EVENT_LEN] {
        let [low, high] = value.to_ne_bytes();
        [0, 0, 0, 0, low, high, kind, number]
    }

    const fn hold(axis: LinearJogAxis) -> PadAction {
        PadAction::Hold(Button::Linear(axis), 1.0)
    }

    #[test]
    fn a_stick_moves_beyond_its_dead_zone_and_stops_within() {
        let mut it = Gamepad::new();
        let up = it.handle(event(AXIS, 1, -32767));
        assert_eq!(up, Some(hold(LinearJogAxis::XPlus)));
        assert_eq!(it.handle(event(AXIS, 1, -8000)), Some(PadAction::Release));
        // Half of the way from a quarter to the end.
        let Some(PadAction::Hold(_, share)) = it.handle(event(AXIS, 0, 20479)) else {
            panic!("it is beyond the dead zone");
        };
        assert!((share - 0.5).abs() < 0.001, "{share}");
    }

    #[test]
    fn the_stick_that_is_farthest_counts() {
        let mut it = Gamepad::new();
        it.handle(event(AXIS, 0, 15000));
        let two = it.handle(event(AXIS, 4, 32767));
        assert_eq!(two, Some(hold(LinearJogAxis::ZMinus)));
    }

    #[test]
    fn initial_stick_positions_move_nothing() {
        let first = 0x80;
        assert_eq!(Gamepad::new().handle(event(AXIS | first, 1, -32767)), None);
        assert_eq!(Gamepad::new().handle(event(BUTTON | first, 3, 1)), None);
    }

    #[test]
    fn every_button_without_another_meaning_stops_the_arm() {
        for number in [2, 3, 6, 7, 8, 9, 255] {
            let mut it = Gamepad::new();
            assert_eq!(it.handle(event(BUTTON, number, 1)), Some(PadAction::Stop));
            assert_eq!(it.handle(event(BUTTON, number, 0)), None);
        }
        let pump = Gamepad::new().handle(event(BUTTON, 0, 1));
        assert_eq!(pump, Some(PadAction::Suction(true)));
    }

    #[test]
    fn no_event_panics() {
        for kind in 0..=255 {
            for number in 0..=255 {
                Gamepad::new().handle(event(kind, number, i16::MIN));
            }
        }
    }
}
