//! Queries of a session.

use std::time::Duration;

use dobot_motion::Model;
use dobot_wire::{Command, Counts, Dialect, Packet, Status};

use super::{LATE, Session};
use crate::{LinkQuality, NoStatus, Queue, SendError};

impl Session {
    /// The last status.
    #[must_use]
    pub const fn status(&self) -> Option<&Status> {
        self.status.as_ref()
    }

    /// The dialect, if known.
    #[must_use]
    pub const fn dialect(&self) -> Option<&Dialect> {
        self.dialect.as_ref()
    }

    /// Whether [`Session::poll_event`] has an event.
    #[must_use]
    pub fn has_event(&self) -> bool {
        !self.events.is_empty()
    }

    /// Whether [`Session::poll_bytes`] has a packet.
    #[must_use]
    pub fn has_bytes(&self) -> bool {
        !self.to_send.is_empty()
    }

    /// Number of commands that wait for a permit.
    #[must_use]
    pub fn waiting(&self) -> usize {
        self.estimate.waiting()
    }

    /// Number of in-flight commands.
    #[must_use]
    pub fn in_flight(&self) -> usize {
        self.estimate.in_flight().awaited()
    }

    /// Counters of the decoder.
    #[must_use]
    pub fn counts(&self) -> Counts {
        self.decoder.counts()
    }

    /// The estimated model after all commands, waiting ones included; `None` before the first status.
    /// Settings are those of a stock arm at power-up plus what this session has sent. An unknown
    /// dialect is assumed to be that of the specification.
    #[must_use]
    pub fn model(&self) -> Option<&Model> {
        self.estimate.after_all()
    }

    /// The model after the in-flight commands, moved to the place of the last status: for watching a held
    /// jog. `None` before the first status.
    #[must_use]
    pub fn seen_model(&self) -> Option<Model> {
        let mut model = *self.estimate.after_sent()?;
        model.observe(&self.status?);
        Some(model)
    }

    /// The release of the last pressed button, joint or linear as the button was: the other kind makes a
    /// stock arm run another axis (note N44). `None` if this session has sent no button since the
    /// connect or a reset.
    ///
    /// It stays the same after the release was sent, because that may get lost; an arm that does not
    /// jog ignores it.
    #[must_use]
    pub const fn release(&self) -> Option<Command> {
        self.estimate.release()
    }

    /// Whether the arm moves or may still move: a command is in flight, or it jogs.
    #[must_use]
    pub fn is_moving(&self) -> bool {
        !self.rests_within().is_zero()
    }

    /// Whether a jog button is pressed: it was sent, and its release was not.
    #[must_use]
    pub const fn is_jogging(&self) -> bool {
        self.estimate.is_jogging()
    }

    /// Number of motions sent.
    #[must_use]
    pub fn motions_sent(&self) -> u64 {
        self.estimate.in_flight().motions_sent()
    }

    /// Whether this is the Bluetooth port of a stock arm, detected from the statuses (note N38). Joint jogs
    /// are sent with the axes of that port.
    #[must_use]
    pub fn is_bluetooth(&self) -> bool {
        self.permit_scheme.is_bluetooth()
    }

    /// Decodes a packet by the dialect and the port of the arm.
    ///
    /// # Errors
    ///
    /// [`SendError::Undecided`] if the meaning depends on the dialect, which is unknown,
    /// [`SendError::Invalid`] if a value is outside its table.
    pub fn parse(&self, packet: &Packet) -> Result<Command, SendError> {
        let read = |dialect| Command::parse(packet, dialect).map_err(SendError::Invalid);
        if let Some(dialect) = &self.dialect {
            return read(dialect).map(|command| self.on_this_port(command));
        }
        let command = read(&Dialect::SPECIFICATION).or_else(|_| read(&Dialect::FIRMWARE_1_1))?;
        match command.dialect_dependent() {
            Some(field) => Err(SendError::Undecided { field }),
            None => Ok(self.on_this_port(command)),
        }
    }

    /// The commands that are waiting or in flight.
    #[must_use]
    pub fn queue(&self) -> Queue {
        let in_flight = self.in_flight();
        let silent_for = self.now.saturating_sub(self.status_arrived);
        Queue {
            waiting: self.waiting(),
            in_flight,
            ahead: self.estimate.in_flight().ahead(self.now),
            is_full: self.may_be_full() && silent_for > self.meter.period() + LATE,
        }
    }

    /// Expected time until all in-flight commands have ended, in seconds from the last time passed to the
    /// session. A jog counts as ended, because the next command ends it.
    #[must_use]
    pub fn ahead_s(&self) -> f64 {
        self.estimate.in_flight().ahead(self.now).as_secs_f64()
    }

    /// Longest time until the arm is at rest if nothing more is sent, from the last time passed to the
    /// session; `Duration::MAX` during a jog.
    ///
    /// This holds for an arm that no other client configures, that had stock settings when the session
    /// started (opening the port of a stock arm resets it), on a line of 9600 baud or faster.
    #[must_use]
    pub fn rests_within(&self) -> Duration {
        self.estimate.rests_within(self.now)
    }

    /// Whether the reported pose is trusted. After the connect, a reset or new initial angles (state 9,
    /// mode 3) it is not, until a person [confirms](Session::confirm_pose) it. An arm that is not
    /// trusted is sent no motion, only releases, switches and configuration.
    #[must_use]
    pub const fn is_trusted(&self) -> bool {
        self.trust.reason().is_none()
    }

    /// Why the pose is not trusted; `None` if it is.
    #[must_use]
    pub fn distrust_reason(&self) -> Option<&str> {
        self.trust.reason().map(String::as_str)
    }

    /// What has arrived since the last status.
    #[must_use]
    pub fn no_status(&self) -> NoStatus {
        self.status_wait.no_status()
    }

    /// The quality of the link.
    #[must_use]
    pub fn link(&self) -> LinkQuality {
        LinkQuality {
            bluetooth: self.is_bluetooth(),
            ..self.meter.quality(self.now, &self.decoder.counts())
        }
    }
}
