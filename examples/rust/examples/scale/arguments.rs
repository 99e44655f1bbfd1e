//! What is to be measured.

use std::time::Duration;

/// How much is to be measured; without arguments only as much as shows that it works.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arguments {
    /// How many stations.
    pub(crate) stations: u16,
    /// How many of them join by the same session of Zenoh, as the stations of one program do.
    pub(crate) by_one_session: u16,
    /// How many stops of all arms at rest.
    pub(crate) presses: usize,
    /// How many stops of all arms while each burns.
    pub(crate) burning: usize,
    /// How many actions of a board.
    pub(crate) actions: usize,
    /// For how long nothing is asked while what the processes cost is counted.
    pub(crate) rest: Duration,
}

impl Arguments {
    /// Those of this process.
    ///
    /// # Errors
    ///
    /// Which one is none, in one line.
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
                .map_err(|_| format!("{name} is {found:?}; allowed is 0 to 65535"))?;
            match name.as_str() {
                "--stations" if number > 0 => arguments.stations = number,
                "--by-one-session" if number > 0 => arguments.by_one_session = number,
                "--presses" => arguments.presses = number.into(),
                "--burning" => arguments.burning = number.into(),
                "--actions" => arguments.actions = number.into(),
                "--rest" => arguments.rest = Duration::from_secs(number.into()),
                _ => {
                    return Err(format!(
                        "{name} {found} is no argument; allowed are --stations and --by-one-session (from 1), --presses, --burning, --actions and --rest (seconds)"
                    ));
                }
            }
        }
        Ok(arguments)
    }
}
