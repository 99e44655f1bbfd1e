//! The daemon that owns an arm's port and keeps people and arm safe.
