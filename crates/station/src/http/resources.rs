//! Resources of the API other than the arm.

pub(crate) mod custom_buttons;
pub(crate) mod drawings;
pub(crate) mod files;
pub(crate) mod metrics;
pub(crate) mod page;
pub(crate) mod programs;
pub(crate) mod recordings;
pub(crate) mod sketch;
pub(crate) mod talk;
pub(crate) mod test_arms;
