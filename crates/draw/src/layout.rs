//! Layout of the artwork: sheet, placement, copies, and clipping to the reach.

pub(crate) mod clip;
pub(crate) mod copies;
pub(crate) mod frame;
pub(crate) mod marks;
pub(crate) mod multi_file;
pub(crate) mod place;
pub(crate) mod sheet;
pub(crate) mod test_card;
