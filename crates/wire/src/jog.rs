//! Shared parts of the two jogs: fields and codes (Tables 3.5 and 2.5).

use crate::table::{Table, whole_number};
use crate::{Frame, ParseError};

/// Reads the axis, one of all in the order of their codes, and the speed.
pub(crate) fn parse<A: Copy>(frame: &Frame, axes: &[A; 15]) -> Result<(A, f32), ParseError> {
    let axis = Table("Table 2.5").float(frame, 2, "Axis");
    let axis = axis.code(axes, "0 to 14")?;
    let moves = whole_number(frame.float(2)).is_some_and(moves);
    Ok((axis, TABLE.float(frame, 8, "StarVel").jog_speed(moves)?))
}

pub(crate) fn emit(state: f32, code: u8, speed_percent: f32) -> Frame {
    Frame::ZERO
        .with(1, state)
        .with(2, f32::from(code))
        .with(8, speed_percent)
}

/// Whether something moves for as long as the button is held: all but the release and the switches of
/// pump and laser.
pub(crate) const fn moves(code: u8) -> bool {
    !matches!(code, 0 | 9 | 10 | 13 | 14)
}

pub(crate) const TABLE: Table = Table("Table 3.5");
