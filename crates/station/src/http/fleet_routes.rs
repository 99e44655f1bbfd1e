//! The routes that serve a fleet: members, virtual arms, offers, jobs for any arm and learners.

pub(crate) mod learners;
pub(crate) mod members;
pub(crate) mod offers;
pub(crate) mod virtual_arms;
pub(crate) mod work;
