//! Planning of vector speeds within the limits of arm, joints and link.

pub(crate) mod acceleration;
pub(crate) mod chain;
pub(crate) mod duration_estimate;
pub(crate) mod joints;
pub(crate) mod link;
pub(crate) mod lookahead;
pub(crate) mod motion;
pub(crate) mod objective;
pub(crate) mod respeed;
pub(crate) mod sampled_acceleration;
pub(crate) mod speeds;
