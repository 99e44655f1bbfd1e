//! Drawings, carried out.

mod virtual_arm;
