//! The measurements to make.

use std::time::Duration;

/// The extent of the measurements; without arguments only a smoke test.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arguments {
    /// The number of stations.
    pub(crate) stations: u16,
    /// The number of stations that share a Zenoh session, like the stations of one program.
    pub(crate) by_one_session: u16,
    /// The number of stops of all arms at rest.
    pub(crate) presses: usize,
    /// The number of stops of all arms while each laser is on.
    pub(crate) burning: usize,
    /// The number of actions on a board.
    pub(crate) actions: usize,
    /// The idle time in which the cost of the processes is measured.
    pub(crate) rest: Duration,
}

impl Arguments {
    /// Parses the arguments of this process.
    ///
    /// # Errors
    ///
    /// The invalid argument, in one line.
    pub(crate) fn read() -> Result<Self, String> {
        let mut arguments = Self {
            stations: 5,
            by_one_session: 1,
            presses: 3,
            burning: 1,
            actions: 5,
            rest: Duration::from_secs(1),
        };
        let mut words = std::env::args().skip(1);
        while let Some(name) = words.next() {
            let found = words.next().unwrap_or_default();
            let number: u16 = found
                .parse()
                .map_err(|_| format!("{name} is {found:?}; allowed are 0 to 65535"))?;
            match name.as_str() {
                "--stations" if number > 0 => arguments.stations = number,
                "--by-one-session" if number > 0 => arguments.by_one_session = number,
                "--presses" => arguments.presses = number.into(),
                "--burning" => arguments.burning = number.into(),
                "--actions" => arguments.actions = number.into(),
                "--rest" => arguments.rest = Duration::from_secs(number.into()),
                _ => {
                    return Err(format!(
                        "unknown argument {name} {found}; allowed are --stations and --by-one-session (from 1), --presses, --burning, --actions and --rest (seconds)"
                    ));
                }
            }
        }
        Ok(arguments)
    }
}
