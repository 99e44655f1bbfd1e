//! What can be asked of a session.

use std::time::Duration;

use dobot_motion::Model;
use dobot_wire::{Command, Counts, Dialect, Packet, Status};

use super::{LATE, Session};
use crate::{LinkQuality, Queue, SendError};

impl Session {
    /// What the arm told last.
    #[must_use]
    pub const fn status(&self) -> Option<&Status> {
        self.status.as_ref()
    }

    /// The dialect, if it is known.
    #[must_use]
    pub const fn dialect(&self) -> Option<&Dialect> {
        self.dialect.as_ref()
    }

    /// Whether something happened that nobody has been told.
    #[must_use]
    pub fn has_event(&self) -> bool {
        !self.events.is_empty()
    }

    /// Whether a packet was begun that [`Session::poll_bytes`] has not given away yet.
    #[must_use]
    pub fn has_bytes(&self) -> bool {
        !self.to_send.is_empty()
    }

    /// Commands that wait for a permit.
    #[must_use]
    pub fn waiting(&self) -> usize {
        self.belief.waiting()
    }

    /// Commands sent and not seen to be over.
    #[must_use]
    pub fn under_way(&self) -> usize {
        self.belief.under_way().asked_for()
    }

    /// What the decoder has seen.
    #[must_use]
    pub fn counts(&self) -> Counts {
        self.decoder.counts()
    }

    /// What is believed of the arm when all that was given is over, what waits included; `None`
    /// before the first status. Settings are those of a stock arm at power-up and what this session
    /// has sent since. An arm whose dialect nobody has told is taken for one of the document.
    #[must_use]
    pub fn model(&self) -> Option<&Model> {
        self.belief.after_given()
    }

    /// The same arm at the place of the last status, with what it was told: to watch a jog that is
    /// held. `None` before the first status.
    #[must_use]
    pub fn seen_model(&self) -> Option<Model> {
        let mut model = *self.belief.after_sent()?;
        model.observe(&self.status?);
        Some(model)
    }

    /// What releases the button that was sent last, of the kind that it is, joint or linear: a stock
    /// arm runs another axis down with the other kind (note N44). `None` where no button was sent since
    /// the connect, or since a reset: then there is nothing to release that this session knows of.
    ///
    /// It stays the answer when the release has been sent, since that may get lost; an arm that does
    /// not jog does nothing with it.
    #[must_use]
    pub const fn release(&self) -> Option<Command> {
        self.belief.release()
    }

    /// Whether the arm moves or may still move: something is under way, or it jogs.
    #[must_use]
    pub fn is_moving(&self) -> bool {
        !self.rests_within().is_zero()
    }

    /// Whether this is the Bluetooth port of a stock arm, as its statuses tell (note N38). Joint jogs
    /// leave with the axes that it has there.
    #[must_use]
    pub fn is_bluetooth(&self) -> bool {
        self.scheme.is_bluetooth()
    }

    /// What a packet says, by the dialect and the port of the arm: what it would do there.
    ///
    /// # Errors
    ///
    /// [`SendError::Undecided`] where that depends on a dialect that nobody has told,
    /// [`SendError::Invalid`] where a value breaks its table.
    pub fn parse(&self, packet: &Packet) -> Result<Command, SendError> {
        let read = |dialect| Command::parse(packet, dialect).map_err(SendError::Invalid);
        if let Some(dialect) = &self.dialect {
            return read(dialect).map(|it| self.on_this_port(it));
        }
        let command = read(&Dialect::SPECIFICATION).or_else(|_| read(&Dialect::FIRMWARE_1_1))?;
        match command.dialect_dependent() {
            Some(field) => Err(SendError::Undecided { field }),
            None => Ok(self.on_this_port(command)),
        }
    }

    /// What is on its way.
    #[must_use]
    pub fn queue(&self) -> Queue {
        let under_way = self.under_way();
        let silent_for = self.now.saturating_sub(self.heard);
        Queue {
            waiting: self.waiting(),
            under_way,
            ahead: self.belief.under_way().ahead(self.now),
            is_full: self.may_be_full() && silent_for > self.meter.period() + LATE,
        }
    }

    /// How long it should take until all that was sent is over, in seconds from the last time that
    /// the session was told of. A jog counts as over: it is so as soon as something follows it.
    #[must_use]
    pub fn ahead_s(&self) -> f64 {
        self.belief.under_way().ahead(self.now).as_secs_f64()
    }

    /// Within what time the arm is at rest for sure if nothing more is sent, from the last time that
    /// the session was told of; `Duration::MAX` while it jogs.
    ///
    /// The promise holds for an arm that nobody else configures, with stock settings when the session
    /// began (opening the port of a stock arm resets it), on a line of 9600 baud or faster.
    #[must_use]
    pub fn rests_within(&self) -> Duration {
        self.belief.rests_within(self.now)
    }

    /// Whether the pose that the arm tells can be believed. It is not from the start, since a reset
    /// was seen, and since somebody told the arm its initial angles (state 9, mode 3), until a person
    /// [confirms](Session::confirm_pose) it. An arm that is not trusted is sent nothing that moves it,
    /// but releases, switches and configuration.
    #[must_use]
    pub const fn is_trusted(&self) -> bool {
        self.trust.reason().is_none()
    }

    /// Why the pose is not trusted, if it is not.
    #[must_use]
    pub fn distrust_reason(&self) -> Option<&str> {
        self.trust.reason().map(String::as_str)
    }

    /// How good the link is.
    #[must_use]
    pub fn link(&self) -> LinkQuality {
        LinkQuality {
            bluetooth: self.is_bluetooth(),
            ..self.meter.quality(self.now, &self.decoder.counts())
        }
    }
}
