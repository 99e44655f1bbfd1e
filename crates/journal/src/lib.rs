//! The journal of jobs: what has to survive a crash and a power cut.
