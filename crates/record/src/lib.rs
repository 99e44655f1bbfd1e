//! Recordings of everything on the wire, as MCAP files, and their replay.
