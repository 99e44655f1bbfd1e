//! An arm to work with.

use std::time::Duration;

use dobot_motion::{Button, LASER_OFF};
use dobot_wire::{Command, Dialect, MoveJoints, MoveTo, PACKET_GAP, Status};

use crate::{Address, CommandId, Connection, LinkError, OpenError};

/// An arm to work with: each call returns when the arm has done it.
///
/// ```no_run
/// use dobot_session::Arm;
/// use dobot_wire::{Dialect, MoveTo, MovingMode};
///
/// # async fn example() -> Result<(), Box<dyn std::error::Error>> {
/// let address = "serial:/dev/ttyUSB0".parse()?;
/// let mut arm = Arm::open(&address, Some(Dialect::FIRMWARE_1_1)).await?;
/// println!("{:?}: does it stand so?", arm.status().await?);
/// // ... a person looks, and says yes:
/// arm.confirm_pose();
/// let status = arm.move_to(MoveTo::to(220.0, 0.0, 20.0).with_mode(MovingMode::MovJ)).await?;
/// assert!((status.x_mm - 220.0).abs() < 0.05);
/// # Ok(())
/// # }
/// ```
///
/// A call that is cancelled has sent what it has sent: [`Arm::stop`] ends it.
///
/// # Which rules it has
///
/// * Nothing moves an arm whose pose nobody has confirmed ([`Arm::confirm_pose`]): an arm at an address
///   from the start, any arm when it was reset or told its initial angles. One in this process
///   ([`Peer`](crate::Peer)) is trusted from the start.
/// * What breaks its table is refused, and so is what means different things in dialects that nobody has told, or
///   would make a stock arm lose its pose on the spot (note N34).
/// * A command leaves only with a status, half a second at the most before the arm should begin it.
/// * A button is released by its own kind of jog.
///
/// All else has only the station (the crate `station`): the policy with its limits, keep-outs and
/// speeds; control by one client at a time; the button that is let go when its holder falls silent;
/// a stop that holds; what is done when a program ends in the middle; the journal and the recording.
#[derive(Debug)]
pub struct Arm {
    connection: Connection,
}

impl Arm {
    /// Opens a serial port or a TCP connection. The arm moves only after [`Arm::confirm_pose`].
    ///
    /// # Errors
    ///
    /// [`OpenError`], with what to do about it.
    ///
    /// # Panics
    ///
    /// Outside of a tokio runtime.
    pub async fn open(address: &Address, dialect: Option<Dialect>) -> Result<Self, OpenError> {
        Ok(Self::over(Connection::open(address, dialect).await?))
    }

    /// An arm over a connection that is open.
    #[must_use]
    pub const fn over(connection: Connection) -> Self {
        Self { connection }
    }

    /// Lets the laser be lit for so long: a person has put the goggles on. Until then, and afterwards,
    /// what burns is refused ([`SendError::LaserDisarmed`](crate::SendError::LaserDisarmed)); that of an
    /// arm in this process needs no arming. A laser that would burn on the spot is switched off, while a
    /// call goes on.
    pub fn arm_laser(&mut self, time: Duration) {
        self.connection.arm_laser(time);
    }

    /// A person says that the arm stands where it tells. To be asked for, with what [`Arm::status`]
    /// tells, and not to be called for granted: opening its port makes a stock arm say that its base is
    /// at 0, wherever that stands (note N35), and all limits are off by as much.
    pub fn confirm_pose(&mut self) {
        self.connection.session_mut().confirm_pose();
    }

    /// Goes to a point, sets the tool, and returns what the arm tells then.
    ///
    /// # Errors
    ///
    /// [`LinkError`]: the command is not allowed, the arm came to rest elsewhere, or the link failed.
    pub async fn move_to(&mut self, target: MoveTo) -> Result<Status, LinkError> {
        self.perform(target).await
    }

    /// Goes to joint angles, sets the tool, and returns what the arm tells then.
    ///
    /// # Errors
    ///
    /// As of [`Arm::move_to`].
    pub async fn move_joints(&mut self, target: MoveJoints) -> Result<Status, LinkError> {
        self.perform(target).await
    }

    /// Jogs one axis for a while, releases it, and returns what the arm tells when it rests. `held`
    /// is a [`JointJog`](dobot_wire::JointJog) or a [`LinearJog`](dobot_wire::LinearJog) of an axis that moves.
    ///
    /// The axis moves until the release arrives: with the next status, up to 0.2 s later. If this
    /// call is cancelled the arm jogs on, until [`Arm::stop`].
    ///
    /// # Errors
    ///
    /// As of [`Arm::move_to`].
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

    /// Sends any command and returns what the arm tells when it is over.
    ///
    /// # Errors
    ///
    /// As of [`Arm::move_to`].
    pub async fn perform(&mut self, command: impl Into<Command>) -> Result<Status, LinkError> {
        let id = self.connection.send(command)?;
        self.completed(id).await
    }

    /// Stops: switches the laser off and releases a jog at once, without waiting for a permit, and
    /// forgets what was not sent. The protocol has no stop for what the arm has got: that it
    /// finishes, within [`Session::rests_within`](crate::Session::rests_within). Returns what the
    /// arm tells when it rests.
    ///
    /// # Errors
    ///
    /// [`LinkError`] when the link fails.
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

    /// The next thing that the arm tells.
    ///
    /// # Errors
    ///
    /// [`LinkError`] when nothing comes.
    pub async fn status(&mut self) -> Result<Status, LinkError> {
        self.connection.next_status().await
    }

    /// The connection, for everything else.
    #[must_use]
    pub const fn connection(&self) -> &Connection {
        &self.connection
    }

    /// The connection, for everything else.
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

/// What the two packets take on the line, and a status that left after them.
const AT_REST: Duration = Duration::from_millis(240);
