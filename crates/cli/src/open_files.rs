//! How many files and connections this program may have open.

/// Asks the system for as many as it gives anybody: a program usually gets 1,024, and a thousand arms or stations need more.
pub(crate) fn allow_many() {
    #[cfg(unix)]
    {
        use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};

        let limit = getrlimit(Resource::Nofile);
        // What is not granted is told when a file cannot be opened.
        let _ = setrlimit(
            Resource::Nofile,
            Rlimit {
                current: limit.maximum,
                ..limit
            },
        );
    }
}
