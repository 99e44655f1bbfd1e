//! The address of an arm: one string format for every transport.

use std::fmt;
use std::str::FromStr;

/// The address of an arm.
///
/// | text | meaning |
/// |---|---|
/// | `virtual:` | a virtual arm in this process |
/// | `serial:/dev/ttyUSB0`, `serial:COM3@115200` | a serial port, at 9600 baud by default |
/// | `tcp:localhost:5555` | raw packets over TCP |
///
/// ```
/// use dobot_session::Address;
///
/// let address: Address = "serial:/dev/ttyUSB0".parse()?;
/// assert_eq!(address.to_string(), "serial:/dev/ttyUSB0@9600");
/// # Ok::<(), dobot_session::AddressError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Address {
    /// A virtual arm in this process.
    Virtual,
    /// A serial port.
    Serial {
        /// The port's name, such as `/dev/ttyUSB0` or `COM3`.
        path: String,
        /// Bits per second.
        baud: u32,
    },
    /// Raw packets over TCP.
    Tcp {
        /// The host name or IP address; an IPv6 address without its brackets.
        host: String,
        /// The TCP port.
        port: u16,
    },
}

/// The baud rate of a stock arm with firmware 1.1 (note N26).
pub const DEFAULT_BAUD: u32 = 9600;

impl FromStr for Address {
    type Err = AddressError;

    fn from_str(text: &str) -> Result<Self, AddressError> {
        match text.split_once(':') {
            Some(("virtual", "")) => Ok(Self::Virtual),
            Some(("serial", rest)) => serial(text, rest),
            Some(("tcp", rest)) => tcp(text, rest),
            _ => Err(AddressError::UnknownTransport {
                found: text.to_owned(),
            }),
        }
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Virtual => f.write_str("virtual:"),
            Self::Serial { path, baud } => write!(f, "serial:{path}@{baud}"),
            Self::Tcp { host, port } if host.contains(':') => write!(f, "tcp:[{host}]:{port}"),
            Self::Tcp { host, port } => write!(f, "tcp:{host}:{port}"),
        }
    }
}

/// The error returned when a text is not an address.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum AddressError {
    /// The part before the first colon is not a transport.
    #[error(
        "address is `{found}`; allowed are virtual:, serial:PORT[@BAUD] and tcp:HOST:PORT, as in serial:/dev/ttyUSB0"
    )]
    UnknownTransport {
        /// The whole text.
        found: String,
    },
    /// `serial:` without a port name.
    #[error(
        "address `{found}` has no serial port; allowed is serial:PORT[@BAUD], as in serial:/dev/ttyUSB0"
    )]
    NoPort {
        /// The whole text.
        found: String,
    },
    /// The part after `@` is not a baud rate.
    #[error(
        "address `{found}` has baud rate `{baud}`; allowed is a whole number from 300, as in serial:/dev/ttyUSB0@9600"
    )]
    BadBaud {
        /// The whole text.
        found: String,
        /// The part after `@`.
        baud: String,
    },
    /// `tcp:` without host and port.
    #[error(
        "address is `{found}`; allowed is tcp:HOST:PORT with a port from 1 to 65535, as in tcp:localhost:5555"
    )]
    BadTcp {
        /// The whole text.
        found: String,
    },
}

fn serial(text: &str, rest: &str) -> Result<Address, AddressError> {
    let (path, baud) = match rest.rsplit_once('@') {
        None => (rest, DEFAULT_BAUD),
        Some((path, baud)) => match baud.parse() {
            Ok(number) if number >= 300 => (path, number),
            _ => {
                return Err(AddressError::BadBaud {
                    found: text.to_owned(),
                    baud: baud.to_owned(),
                });
            }
        },
    };
    if path.is_empty() {
        return Err(AddressError::NoPort {
            found: text.to_owned(),
        });
    }
    Ok(Address::Serial {
        path: path.to_owned(),
        baud,
    })
}

fn tcp(text: &str, rest: &str) -> Result<Address, AddressError> {
    let error = || AddressError::BadTcp {
        found: text.to_owned(),
    };
    let (host, port) = rest.rsplit_once(':').ok_or_else(error)?;
    let host = match host.strip_prefix('[') {
        Some(inner) => inner.strip_suffix(']').ok_or_else(error)?,
        None if host.contains(':') => return Err(error()),
        None => host,
    };
    match port.parse() {
        Ok(port) if port > 0 && !host.is_empty() => Ok(Address::Tcp {
            host: host.to_owned(),
            port,
        }),
        _ => Err(error()),
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn reads_each_transport_and_writes_it_back() {
        for text in [
            "virtual:",
            "serial:/dev/ttyUSB0@9600",
            "serial:COM3@256000",
            "tcp:localhost:5555",
            "tcp:[::1]:5555",
        ] {
            assert_eq!(text.parse::<Address>().unwrap().to_string(), text);
        }
    }

    #[test]
    fn a_serial_port_without_a_baud_rate_uses_9600() {
        let address: Address = "serial:/dev/ttyACM0".parse().unwrap();
        assert_eq!(
            address,
            Address::Serial {
                path: "/dev/ttyACM0".into(),
                baud: 9600
            }
        );
    }

    #[test]
    fn a_port_name_may_contain_an_at_sign_if_the_baud_rate_is_given() {
        let address: Address = "serial:/dev/serial/by-id/usb@1@9600".parse().unwrap();
        assert_eq!(
            address,
            Address::Serial {
                path: "/dev/serial/by-id/usb@1".into(),
                baud: 9600
            }
        );
    }

    #[test]
    fn reports_the_allowed_form_of_an_address() {
        for (text, part) in [
            ("/dev/ttyUSB0", "serial:PORT[@BAUD]"),
            ("", "virtual:"),
            ("virtual:x", "virtual:"),
            ("serial:", "has no serial port"),
            ("serial:@9600", "has no serial port"),
            ("serial:/dev/ttyUSB0@fast", "baud rate `fast`"),
            ("serial:/dev/ttyUSB0@0", "baud rate `0`"),
            ("tcp:localhost", "tcp:HOST:PORT"),
            ("tcp::5555", "tcp:HOST:PORT"),
            ("tcp:localhost:0", "tcp:HOST:PORT"),
            ("tcp:localhost:70000", "tcp:HOST:PORT"),
            ("tcp:::1:5555", "tcp:HOST:PORT"),
        ] {
            let error = text.parse::<Address>().unwrap_err().to_string();
            assert!(error.contains(part), "{text}: {error}");
        }
    }
}
