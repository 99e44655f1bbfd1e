//! The geometry of the arm, over its whole workspace and against real ones.

mod kinematics;
mod real_arm;
mod recorded;
