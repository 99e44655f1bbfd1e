//! The parts of the API that serve a fleet: members, virtual arms, offers, work and learners.

pub(crate) mod learners;
pub(crate) mod members;
pub(crate) mod offers;
pub(crate) mod virtual_arms;
pub(crate) mod work;
