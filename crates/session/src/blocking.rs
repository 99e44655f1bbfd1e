//! A blocking API: each call returns when the arm has completed the command.
//!
//! ```no_run
//! use dobot_session::blocking::Arm;
//! use dobot_wire::{LinearJog, LinearJogAxis};
//! use std::time::Duration;
//!
//! let mut arm = Arm::open(&"serial:/dev/ttyUSB0".parse()?, None)?;
//! println!("{:?}: does the arm stand like this?", arm.status()?);
//! // ... after a person has checked it:
//! arm.confirm_pose();
//! let up = LinearJog::new(LinearJogAxis::ZPlus, 20.0);
//! let status = arm.jog(up, Duration::from_secs(1))?;
//! println!("z = {} mm", status.z_mm);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::io;
use std::time::Duration;

use dobot_wire::{Command, Dialect, MoveJoints, MoveTo, Status};
use tokio::runtime::{Builder, Runtime};

use crate::{Address, Connection, LinkError, OpenError, Peer};

/// The blocking counterpart of [`Arm`](crate::Arm). It has its own runtime, in which time passes only
/// during a call.
#[derive(Debug)]
pub struct Arm {
    arm: crate::Arm,
    runtime: Runtime,
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
    /// If called inside an async runtime; use [`Arm`](crate::Arm) there.
    pub fn open(address: &Address, dialect: Option<Dialect>) -> Result<Self, OpenError> {
        let runtime = runtime().map_err(OpenError::Runtime)?;
        let arm = runtime.block_on(crate::Arm::open(address, dialect))?;
        Ok(Self { arm, runtime })
    }

    /// Connects to an arm in this process.
    ///
    /// # Errors
    ///
    /// Returns [`OpenError::Runtime`] if the runtime cannot be started.
    pub fn over_peer(
        peer: impl Peer + 'static,
        dialect: Option<Dialect>,
    ) -> Result<Self, OpenError> {
        Ok(Self {
            arm: crate::Arm::over(Connection::over_peer(peer, dialect)),
            runtime: runtime().map_err(OpenError::Runtime)?,
        })
    }

    /// See [`Arm::arm_laser`](crate::Arm::arm_laser).
    pub fn arm_laser(&mut self, time: Duration) {
        self.arm.arm_laser(time);
    }

    /// See [`Arm::confirm_pose`](crate::Arm::confirm_pose).
    pub fn confirm_pose(&mut self) {
        self.arm.confirm_pose();
    }

    /// See [`Arm::move_to`](crate::Arm::move_to).
    ///
    /// # Errors
    ///
    /// The same.
    pub fn move_to(&mut self, target: MoveTo) -> Result<Status, LinkError> {
        self.runtime.block_on(self.arm.move_to(target))
    }

    /// See [`Arm::move_joints`](crate::Arm::move_joints).
    ///
    /// # Errors
    ///
    /// The same.
    pub fn move_joints(&mut self, target: MoveJoints) -> Result<Status, LinkError> {
        self.runtime.block_on(self.arm.move_joints(target))
    }

    /// See [`Arm::jog`](crate::Arm::jog).
    ///
    /// # Errors
    ///
    /// The same.
    pub fn jog(&mut self, held: impl Into<Command>, time: Duration) -> Result<Status, LinkError> {
        self.runtime.block_on(self.arm.jog(held, time))
    }

    /// See [`Arm::perform`](crate::Arm::perform).
    ///
    /// # Errors
    ///
    /// The same.
    pub fn perform(&mut self, command: impl Into<Command>) -> Result<Status, LinkError> {
        self.runtime.block_on(self.arm.perform(command))
    }

    /// See [`Arm::stop`](crate::Arm::stop).
    ///
    /// # Errors
    ///
    /// The same.
    pub fn stop(&mut self) -> Result<Status, LinkError> {
        self.runtime.block_on(self.arm.stop())
    }

    /// See [`Arm::status`](crate::Arm::status).
    ///
    /// # Errors
    ///
    /// The same.
    pub fn status(&mut self) -> Result<Status, LinkError> {
        self.runtime.block_on(self.arm.status())
    }
}

fn runtime() -> io::Result<Runtime> {
    Builder::new_current_thread().enable_all().build()
}
