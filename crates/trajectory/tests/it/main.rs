//! Where commands lead.

mod course;
