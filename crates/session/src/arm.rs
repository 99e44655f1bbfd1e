//! An async API: one call per command.

use std::time::Duration;

use dobot_motion::{Button, LASER_OFF};
use dobot_wire::{Command, Dialect, MoveJoints, MoveTo, PACKET_GAP, Status};

use crate::{Address, CommandId, Connection, LinkError, OpenError};

/// An arm: each call returns when the arm has completed the command.
///
/// ```no_run
/// use dobot_session::Arm;
/// use dobot_wire::{Dialect, MoveTo, MovingMode};
///
/// # async fn example() -> Result<(), Box<dyn std::error::Error>> {
/// let address = "serial:/dev/ttyUSB0".parse()?;
/// let mut arm = Arm::open(&address, Some(Dialect::FIRMWARE_1_1)).await?;
/// println!("{:?}: does the arm stand like this?", arm.status().await?);
/// // ... after a person has checked it:
/// arm.confirm_pose();
/// let status = arm.move_to(MoveTo::to(220.0, 0.0, 20.0).with_mode(MovingMode::MovJ)).await?;
/// assert!((status.x_mm - 220.0).abs() < 0.05);
/// # Ok(())
/// # }
/// ```
///
/// Cancelling a call does not undo the commands already sent; [`Arm::stop`] ends them.
///
/// # Safety rules
///
/// * No motion is sent before the pose is confirmed ([`Arm::confirm_pose`]): for an arm at an address
///   from the start, and for any arm after a reset or a command that sets its initial angles. The pose
///   of an arm in this process ([`Peer`](crate::Peer)) is trusted from the start.
/// * A command is refused if it breaks its table, depends on a dialect that was not given, or would
///   make a stock arm lose its pose (note N34).
/// * A command is sent only after a status, at most half a second before the arm should begin it.
/// * A jog is released by the same kind of jog.
///
/// Everything else is in the station (crate `station`): the policy with limits, keep-out zones and
/// speeds; control by one client at a time; release of a jog when the client goes silent; the stop
/// latch; cleanup when a program ends early; the journal and the recording.
#[derive(Debug)]
pub struct Arm {
    connection: Connection,
}

impl Arm {
    /// Opens a serial port or a TCP connection. The arm moves only after [`Arm::confirm_pose`].
    ///
    /// # Errors
    ///
    /// Returns an [`OpenError`], which has a hint.
    ///
    /// # Panics
    ///
    /// If called outside of a tokio runtime.
    pub async fn open(address: &Address, dialect: Option<Dialect>) -> Result<Self, OpenError> {
        Ok(Self::over(Connection::open(address, dialect).await?))
    }

    /// Creates an arm from an open connection.
    #[must_use]
    pub const fn over(connection: Connection) -> Self {
        Self { connection }
    }

    /// Arms the laser for `time`, after everyone present has put on goggles. While it is disarmed,
    /// commands that light it are refused ([`SendError::LaserDisarmed`](crate::SendError::LaserDisarmed));
    /// an arm in this process needs no arming. During a call, a laser that would burn in place is
    /// switched off.
    pub fn arm_laser(&mut self, time: Duration) {
        self.connection.arm_laser(time);
    }

    /// Confirms that the arm stands where it reports. Show [`Arm::status`] to a person and ask; never
    /// call this unconditionally: opening its port makes a stock arm report its base at 0, wherever it
    /// stands (note N35), and all limits are off by the same angle.
    pub fn confirm_pose(&mut self) {
        self.connection.session_mut().confirm_pose();
    }

    /// Moves to a point, sets the tool, and returns the status then.
    ///
    /// # Errors
    ///
    /// Returns a [`LinkError`] if the command is not allowed, the arm stops elsewhere, or the link fails.
    pub async fn move_to(&mut self, target: MoveTo) -> Result<Status, LinkError> {
        self.perform(target).await
    }

    /// Moves to joint angles, sets the tool, and returns the status then.
    ///
    /// # Errors
    ///
    /// See [`Arm::move_to`].
    pub async fn move_joints(&mut self, target: MoveJoints) -> Result<Status, LinkError> {
        self.perform(target).await
    }

    /// Jogs one axis for `time`, releases it, and returns the status at rest. `held`
    /// is a [`JointJog`](dobot_wire::JointJog) or a [`LinearJog`](dobot_wire::LinearJog) of an axis that moves.
    ///
    /// The axis moves until the release arrives: with the next status, up to 0.2 s later. If this
    /// call is cancelled, the arm keeps jogging until [`Arm::stop`].
    ///
    /// # Errors
    ///
    /// See [`Arm::move_to`].
    pub async fn jog(
        &mut self,
        held: impl Into<Command>,
        time: Duration,
    ) -> Result<Status, LinkError> {
        let held = held.into();
        self.connection.send(held)?;
        let until = self.connection.now() + time;
        while self.connection.now() < until {
            self.status().await?;
        }
        match Button::release_of(&held) {
            Some(release) => self.perform(release).await,
            None => self.status().await,
        }
    }

    /// Sends any command and returns the status when it is completed.
    ///
    /// # Errors
    ///
    /// See [`Arm::move_to`].
    pub async fn perform(&mut self, command: impl Into<Command>) -> Result<Status, LinkError> {
        let id = self.connection.send(command)?;
        self.completed(id).await
    }

    /// Switches the laser off and releases a jog immediately, without waiting for a permit, and discards
    /// unsent commands. The protocol cannot stop commands that the arm has received: it finishes them
    /// within [`Session::rests_within`](crate::Session::rests_within). Returns the status at rest.
    ///
    /// # Errors
    ///
    /// Returns a [`LinkError`] if the link fails.
    pub async fn stop(&mut self) -> Result<Status, LinkError> {
        self.connection.session_mut().send_now(LASER_OFF)?;
        if let Some(release) = self.connection.session().release() {
            self.connection.pass(PACKET_GAP).await?;
            self.connection.session_mut().send_now(release)?;
        }
        let mut last = self.status().await?;
        let mut since = self.connection.now();
        loop {
            let status = self.status().await?;
            if status != last {
                last = status;
                since = self.connection.now();
            } else if self.connection.now() >= since + AT_REST {
                return Ok(status);
            }
        }
    }

    /// Waits for the next status.
    ///
    /// # Errors
    ///
    /// Returns a [`LinkError`] if none arrives.
    pub async fn status(&mut self) -> Result<Status, LinkError> {
        self.connection.next_status().await
    }

    /// The underlying connection.
    #[must_use]
    pub const fn connection(&self) -> &Connection {
        &self.connection
    }

    /// The underlying connection, mutable.
    pub const fn connection_mut(&mut self) -> &mut Connection {
        &mut self.connection
    }

    async fn completed(&mut self, id: CommandId) -> Result<Status, LinkError> {
        self.connection.completed(id).await?;
        match self.connection.session().status() {
            Some(status) => Ok(*status),
            None => self.status().await,
        }
    }
}

/// The time on the line of two packets and of a status sent after them.
const AT_REST: Duration = Duration::from_millis(240);
