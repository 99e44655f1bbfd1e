//! Heartbeats from the station to its watchdog.

use dobot_motion::LASER_OFF;
use dobot_wire::{Command, Dialect, JointJog, JointJogAxis, LinearJog, LinearJogAxis, Packet};

/// A heartbeat from the station to its watchdog, one byte each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Heartbeat {
    /// The station is alive.
    Alive(Hazards),
    /// The station ends properly: nothing is left to send.
    Goodbye,
}

/// The commands sent to the arm that must not outlive the station.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Hazards {
    /// The kind of the last pressed button. It stays after the release: the release may get lost,
    /// and repeating it does nothing to an arm at rest.
    pub jog: Option<JogKind>,
    /// Whether the laser was last switched on.
    pub burns: bool,
}

/// The two kinds of jog (states 2 and 7).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JogKind {
    /// Of one joint (state 2).
    Joint,
    /// Along an axis of the base frame (state 7).
    Linear,
}

impl Heartbeat {
    /// Encodes it as a byte.
    #[must_use]
    pub const fn to_byte(self) -> u8 {
        let hazards = match self {
            Self::Goodbye => return b'q',
            Self::Alive(hazards) => hazards,
        };
        match (hazards.jog, hazards.burns) {
            (None, false) => b'n',
            (None, true) => b'N',
            (Some(JogKind::Joint), false) => b'j',
            (Some(JogKind::Joint), true) => b'J',
            (Some(JogKind::Linear), false) => b'l',
            (Some(JogKind::Linear), true) => b'L',
        }
    }

    /// Decodes a byte; `None` for a byte that no station sends.
    #[must_use]
    pub const fn from_byte(byte: u8) -> Option<Self> {
        let jog = match byte {
            b'q' => return Some(Self::Goodbye),
            b'n' | b'N' => None,
            b'j' | b'J' => Some(JogKind::Joint),
            b'l' | b'L' => Some(JogKind::Linear),
            _ => return None,
        };
        let burns = byte.is_ascii_uppercase();
        Some(Self::Alive(Hazards { jog, burns }))
    }
}

impl Hazards {
    /// Returns the hazards after a packet to the arm.
    #[must_use]
    pub fn after(self, packet: &Packet, dialect: &Dialect) -> Self {
        let Ok(command) = Command::parse(packet, dialect) else {
            return self;
        };
        let jog = match command {
            Command::JointJog(jog) if jog.axis.moves() => Some(JogKind::Joint),
            Command::LinearJog(jog) if jog.axis.moves() => Some(JogKind::Linear),
            _ => self.jog,
        };
        let burns = match command {
            Command::JointJog(jog) if jog.axis == JointJogAxis::LaserOff => false,
            Command::LinearJog(jog) if jog.axis == LinearJogAxis::LaserOff => false,
            Command::WriteVector(vector) => vector.laser,
            _ => self.burns || dobot_motion::burns(&command),
        };
        Self { jog, burns }
    }

    /// Returns the packets that stop the arm and switch the laser off, in sending order.
    #[must_use]
    pub fn stop_packets(self) -> Vec<Packet> {
        let commands = match (self.jog.map(JogKind::release), self.burns) {
            (None, _) => vec![LASER_OFF],
            (Some(release), true) => vec![LASER_OFF, release],
            (Some(release), false) => vec![release, LASER_OFF],
        };
        let emit = |command: Command| command.emit(&Dialect::SPECIFICATION);
        commands.into_iter().map(emit).collect()
    }
}

impl JogKind {
    /// Returns the release of this kind of button.
    const fn release(self) -> Command {
        match self {
            Self::Joint => Command::JointJog(JointJog::new(JointJogAxis::Released, 0.0)),
            Self::Linear => Command::LinearJog(LinearJog::new(LinearJogAxis::Released, 0.0)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_heartbeat_is_a_distinct_byte_and_is_read_back() {
        let kinds = [None, Some(JogKind::Joint), Some(JogKind::Linear)];
        let alive = kinds
            .into_iter()
            .flat_map(|jog| [false, true].map(|burns| Heartbeat::Alive(Hazards { jog, burns })));
        for heartbeat in alive.chain([Heartbeat::Goodbye]) {
            assert_eq!(Heartbeat::from_byte(heartbeat.to_byte()), Some(heartbeat));
        }
        let known = (0..=u8::MAX).filter_map(Heartbeat::from_byte).count();
        assert_eq!(known, 7);
    }
}
