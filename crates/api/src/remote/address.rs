//! The address of a station and the trust in its certificate.

use std::fmt;
use std::path::PathBuf;

use crate::Running;

/// The address of a station and the trust in its certificate.
///
/// ```
/// use dobot_api::StationAddress;
///
/// let address = StationAddress::new("https://lab.example:8642")?;
/// assert!(address.is_encrypted());
/// assert_eq!(address.to_string(), "https://lab.example:8642");
/// # Ok::<(), dobot_api::StationAddressError>(())
/// ```
#[derive(Clone, PartialEq, Eq)]
pub struct StationAddress {
    encrypted: bool,
    /// An IPv6 address without brackets.
    host: String,
    port: u16,
    /// The access token, required for more than watching.
    pub token: Option<String>,
    /// Why its certificate is trusted, over https.
    pub trust: Option<CertificateTrust>,
}

/// Why the certificate of a station is trusted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CertificateTrust {
    /// The SHA-256 digest of the certificate itself.
    Fingerprint([u8; 32]),
    /// It was issued by one of the certificates in this PEM file.
    Authority(PathBuf),
}

impl StationAddress {
    /// Parses an address: `http://HOST[:PORT]` or `https://HOST[:PORT]`; the default port is 8642.
    ///
    /// # Errors
    ///
    /// [`StationAddressError::Malformed`] for anything else.
    pub fn new(text: &str) -> Result<Self, StationAddressError> {
        let malformed = || StationAddressError::Malformed {
            found: text.to_owned(),
        };
        let (encrypted, rest) = match text.split_once("://") {
            Some(("http", rest)) => (false, rest),
            Some(("https", rest)) => (true, rest),
            _ => return Err(malformed()),
        };
        let (host, port) =
            host_and_port(rest.strip_suffix('/').unwrap_or(rest)).ok_or_else(malformed)?;
        Ok(Self {
            encrypted,
            host,
            port,
            token: None,
            trust: None,
        })
    }

    /// Returns the address in a running station's file.
    ///
    /// # Errors
    ///
    /// [`StationAddressError`] if the file's contents are invalid.
    pub fn of(running: &Running) -> Result<Self, StationAddressError> {
        let trust = running
            .fingerprint
            .as_deref()
            .map(fingerprint)
            .transpose()?;
        Ok(Self {
            token: running.token.clone(),
            trust: trust.map(CertificateTrust::Fingerprint),
            ..Self::new(&running.address)?
        })
    }

    /// Returns the host.
    #[must_use]
    pub fn host(&self) -> &str {
        &self.host
    }

    /// Returns the port.
    #[must_use]
    pub const fn port(&self) -> u16 {
        self.port
    }

    /// Returns whether the connection uses TLS.
    #[must_use]
    pub const fn is_encrypted(&self) -> bool {
        self.encrypted
    }

    /// Returns host and port, as in the header `Host`.
    pub(super) fn authority(&self) -> String {
        if self.host.contains(':') {
            format!("[{}]:{}", self.host, self.port)
        } else {
            format!("{}:{}", self.host, self.port)
        }
    }
}

impl fmt::Display for StationAddress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let scheme = if self.encrypted { "https" } else { "http" };
        write!(f, "{scheme}://{}", self.authority())
    }
}

/// Hides the token.
impl fmt::Debug for StationAddress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "StationAddress({self}, trust {:?})", self.trust)
    }
}

/// The error returned for an invalid station address.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum StationAddressError {
    /// Not an address.
    #[error(
        "a station's address is `{found}`; allowed is http://HOST:PORT or https://HOST:PORT, as in http://127.0.0.1:8642"
    )]
    Malformed {
        /// The whole text.
        found: String,
    },
    /// Not a digest.
    #[error(
        "a fingerprint is `{found}`; allowed are the 64 hexadecimal digits of a SHA-256 digest, with or without colons"
    )]
    Fingerprint {
        /// The whole text.
        found: String,
    },
}

/// Parses a SHA-256 digest in hexadecimal digits, with or without colons.
///
/// # Errors
///
/// [`StationAddressError::Fingerprint`] for anything else.
pub fn fingerprint(text: &str) -> Result<[u8; 32], StationAddressError> {
    let error = || StationAddressError::Fingerprint {
        found: text.to_owned(),
    };
    let digits: Option<Vec<u8>> = text
        .chars()
        .filter(|character| *character != ':')
        .map(digit)
        .collect();
    let digits = digits
        .filter(|digits| digits.len() == 64)
        .ok_or_else(error)?;
    let bytes: Vec<u8> = digits
        .chunks(2)
        .map(|pair| pair[0] << 4 | pair[1])
        .collect();
    bytes.try_into().map_err(|_| error())
}

fn digit(digit: char) -> Option<u8> {
    digit
        .to_digit(16)
        .and_then(|value| u8::try_from(value).ok())
}

fn host_and_port(text: &str) -> Option<(String, u16)> {
    let (host, port) = match text.rsplit_once(':') {
        Some((host, port)) if !port.ends_with(']') => (host, port.parse().ok()?),
        _ => (text, DEFAULT_PORT),
    };
    let host = match host.strip_prefix('[') {
        Some(inner) => inner.strip_suffix(']')?,
        None if host.contains(':') => return None,
        None => host,
    };
    let allowed =
        |character: char| character.is_ascii_alphanumeric() || "-._:%".contains(character);
    (!host.is_empty() && port > 0 && host.chars().all(allowed)).then(|| (host.to_owned(), port))
}

const DEFAULT_PORT: u16 = 8642;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn reads_what_it_writes() {
        for text in [
            "http://127.0.0.1:8642",
            "https://lab.example:443",
            "https://[::1]:8642",
        ] {
            assert_eq!(StationAddress::new(text).unwrap().to_string(), text);
        }
    }

    #[test]
    fn the_port_defaults_to_that_of_the_station() {
        for text in ["http://localhost", "http://localhost/", "https://[::1]"] {
            assert_eq!(StationAddress::new(text).unwrap().port(), 8642, "{text}");
        }
    }

    #[test]
    fn text_that_is_not_an_address_is_refused_with_what_is_allowed() {
        for text in [
            "",
            "localhost:8642",
            "ftp://localhost",
            "http://",
            "http://:8642",
            "http://a:0",
            "http://a:70000",
            "http://::1:8642",
            "http://a/b",
            "http://user@a",
            "http://a b",
        ] {
            let error = StationAddress::new(text).unwrap_err().to_string();
            assert!(error.contains("http://HOST:PORT"), "{text}: {error}");
        }
    }

    #[test]
    fn a_fingerprint_is_read_with_and_without_colons() {
        let plain = "00ff".repeat(16);
        let colons = ["00", "FF"].repeat(16).join(":");
        let expected: Vec<u8> = [0, 255].repeat(16);
        assert_eq!(fingerprint(&plain).unwrap().to_vec(), expected);
        assert_eq!(fingerprint(&colons).unwrap().to_vec(), expected);
        for text in ["", "00", &"0g".repeat(32), &"00".repeat(33)] {
            assert!(fingerprint(text).is_err(), "{text}");
        }
    }

    #[test]
    fn a_token_is_not_shown() {
        let address = StationAddress {
            token: Some("hush".into()),
            ..StationAddress::new("http://localhost").unwrap()
        };
        assert!(!format!("{address:?} {address}").contains("hush"));
    }

    proptest! {
        #[test]
        fn no_text_makes_it_panic_and_every_address_is_written_as_it_was_read(text in ".{0,40}") {
            let _ = fingerprint(&text);
            if let Ok(address) = StationAddress::new(&format!("http://{text}")) {
                prop_assert_eq!(&StationAddress::new(&address.to_string()).unwrap(), &address);
            }
        }
    }
}
