//! The world around a virtual arm.

use std::time::Duration;

use dobot_arm::TICK;

use super::VirtualArm;
use crate::world::{Actuators, Happened, World};

impl VirtualArm {
    /// Places the arm in a world, on which its tool acts from now on.
    #[must_use]
    pub fn with_world(mut self, world: World) -> Self {
        self.world = Some(Box::new(world));
        self.feel(self.now);
        self
    }

    /// Replaces the world and keeps the pose: held objects and marks are lost.
    pub fn set_world(&mut self, world: World) {
        self.world = Some(Box::new(world));
        self.feel(self.now);
    }

    /// The world around the arm.
    #[must_use]
    pub fn world(&self) -> Option<&World> {
        self.world.as_deref()
    }

    /// Takes the world events since the last call.
    pub fn poll_world(&mut self) -> Option<Happened> {
        self.world.as_mut()?.poll_event()
    }

    /// Applies the motion since the last event to the world; the machine is at rest at most a tick
    /// later.
    pub(super) fn go_through_world(&mut self, to: Duration) {
        let tick_over = self.last_event + TICK;
        if tick_over < to {
            self.feel(tick_over);
        }
        self.feel(to);
    }

    /// Updates the world with the true pose and the actuators since the last update.
    fn feel(&mut self, at: Duration) {
        if let Some(world) = &mut self.world {
            let outputs = self.controller.outputs();
            let actuators = Actuators {
                pump: outputs.pump,
                laser: self.controller.laser_at_motors(),
                gripper_deg: (f64::from(outputs.gripper_servo) - 500.0) * 0.18,
            };
            world.handle_arm(at, &self.mechanics.joints_at(at), actuators);
        }
    }
}
