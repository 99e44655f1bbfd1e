//! Where the artwork goes: sheet, place, copies, and the border of the reach.

pub(crate) mod clip;
pub(crate) mod copies;
pub(crate) mod frame;
pub(crate) mod multi_file;
pub(crate) mod place;
pub(crate) mod sheet;
pub(crate) mod test_card;
