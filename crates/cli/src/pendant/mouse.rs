//! Mouse packets of a held key (state 1).

use dobot_api::{Button, News, State};
use dobot_wire::{Command, LinearJogAxis, MouseMove};

/// The mouse packets of a held key.
#[derive(Debug)]
pub(crate) struct Mouse {
    /// The in-flight packets, at most [`MAX_IN_FLIGHT`].
    in_flight: Vec<u64>,
}

impl Mouse {
    /// Creates it without in-flight packets.
    pub(crate) const fn new() -> Self {
        Self {
            in_flight: Vec::new(),
        }
    }

    /// Checks that a mouse has a button.
    pub(crate) fn check(button: Button) -> Result<(), &'static str> {
        direction(button)
            .map(|_| ())
            .ok_or("a mouse packet moves only x, y and z; use `dobot jog` for the tool")
    }

    /// Returns the next packet; `None` while enough packets are in flight, because they are always completed.
    pub(crate) fn packet(
        &self,
        button: Button,
        speed_percent: f32,
        state: &State,
    ) -> Option<Command> {
        if self.in_flight.len() >= MAX_IN_FLIGHT {
            return None;
        }
        let status = &state.arm.as_ref()?.status;
        let units = FASTEST * speed_percent / 100.0;
        let [x, y, z] = direction(button)?.map(|axis| axis * units);
        // On a stock arm Y swings the base, and the other way round (note N9).
        let swings = state.dialect.is_some_and(|dialect| dialect.mouse_swings);
        let packet = MouseMove {
            y: if swings { 0.0 - y } else { y },
            x,
            z,
            rotation_deg: MouseMove::kept_rotation_deg(status, state.dialect),
            suction: status.suction,
        };
        Some(packet.into())
    }

    /// Handles the acceptance of a packet.
    pub(crate) fn handle_accepted(&mut self, command: u64) {
        self.in_flight.push(command);
    }

    /// Handles an event of the station.
    pub(crate) fn handle_news(&mut self, news: &News) {
        match news {
            News::CommandDone { command } | News::CommandFailed { command } => {
                self.in_flight.retain(|packet| packet != command);
            }
            News::LinkLost | News::NoLink { .. } => self.in_flight.clear(),
            _ => {}
        }
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

/// The maximum number of in-flight packets: enough for a continuous motion, and few enough for a short
/// motion after the key is released.
const MAX_IN_FLIGHT: usize = 2;
/// The increment of a packet at full speed, in units of the dialect: millimetres by the specification.
const FASTEST: f32 = 5.0;
