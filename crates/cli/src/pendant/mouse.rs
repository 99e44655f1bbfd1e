//! Mouse packets for a key that is held (state 1).

use dobot_api::{Button, News, State};
use dobot_wire::{Command, Dialect, LinearJogAxis, MouseMove, Status};

/// How far the arm is with the mouse packets of a key that is held.
#[derive(Debug)]
pub(crate) struct Mouse {
    /// The packets that are not over; at most [`AHEAD`].
    under_way: Vec<u64>,
}

impl Mouse {
    /// Nothing is under way.
    pub(crate) const fn new() -> Self {
        Self {
            under_way: Vec::new(),
        }
    }

    /// Whether a mouse has this button.
    pub(crate) fn check(button: Button) -> Result<(), &'static str> {
        direction(button)
            .map(|_| ())
            .ok_or("a mouse packet moves x, y and z alone; `dobot jog` has the tool too")
    }

    /// The next packet; none while enough are under way, because those are carried out to their end.
    pub(crate) fn packet(
        &self,
        button: Button,
        speed_percent: f32,
        state: &State,
    ) -> Option<Command> {
        if self.under_way.len() >= AHEAD {
            return None;
        }
        let status = &state.arm.as_ref()?.status;
        let units = FASTEST * speed_percent / 100.0;
        let [x, y, z] = direction(button)?.map(|it| it * units);
        // On a stock arm Y swings the base, and the other way round (note N9).
        let swings = state.dialect.is_some_and(|it| it.mouse_swings);
        let packet = MouseMove {
            y: if swings { 0.0 - y } else { y },
            x,
            z,
            rotation_deg: kept_rotation_deg(status, state.dialect),
            suction: status.suction,
        };
        Some(packet.into())
    }

    /// Takes that the station accepted a packet.
    pub(crate) fn handle_accepted(&mut self, command: u64) {
        self.under_way.push(command);
    }

    /// Takes that something happened.
    pub(crate) fn handle_news(&mut self, news: &News) {
        match news {
            News::CommandDone { command } | News::CommandFailed { command } => {
                self.under_way.retain(|it| it != command);
            }
            News::LinkLost => self.under_way.clear(),
            _ => {}
        }
    }
}

/// The rotation of a mouse move that leaves the tool as it is, in degrees (notes N9 and N49).
pub(crate) fn kept_rotation_deg(from: &Status, dialect: Option<Dialect>) -> f32 {
    let takes_servo = dialect.is_some_and(|it| it.mouse_swings);
    if takes_servo {
        from.servo_deg
    } else {
        from.rotation_deg
    }
}

/// Along x, y and z.
const fn direction(button: Button) -> Option<[f32; 3]> {
    use LinearJogAxis as L;
    Some(match button {
        Button::Linear(L::XPlus) => [1.0, 0.0, 0.0],
        Button::Linear(L::XMinus) => [-1.0, 0.0, 0.0],
        Button::Linear(L::YPlus) => [0.0, 1.0, 0.0],
        Button::Linear(L::YMinus) => [0.0, -1.0, 0.0],
        Button::Linear(L::ZPlus) => [0.0, 0.0, 1.0],
        Button::Linear(L::ZMinus) => [0.0, 0.0, -1.0],
        _ => return None,
    })
}

/// So many packets may be under way: the arm goes on without a break, and no more than this is left
/// when the key is let go.
const AHEAD: usize = 2;
/// The increment of a packet at full speed, in units of the dialect: millimetres by the specification.
const FASTEST: f32 = 5.0;
