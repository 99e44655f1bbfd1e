//! How a station joins.

use std::net::IpAddr;
use std::path::PathBuf;

use dobot_api::{MemberAbout, is_fleet_name};
use zenoh::Config;

use crate::Credentials;

/// How a station joins.
#[derive(Clone, Debug, Default)]
pub struct FleetConfig {
    /// What it is called: 1 to 40 small letters, digits and hyphens, the first one a letter.
    pub name: String,
    /// What it tells of itself.
    pub about: MemberAbout,
    /// The folder with the work that is submitted here for any arm; without it, none can be.
    pub work: Option<PathBuf>,
}

/// Why a station cannot join so.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FleetConfigError {
    /// A name that nothing in a fleet can have.
    #[error(
        "{what} is {found:?}; allowed are 1 to 40 small letters of English, digits and hyphens, the first one a letter, as in desk-3"
    )]
    Name {
        /// What is named.
        what: &'static str,
        /// The name.
        found: String,
    },
    /// No address of Zenoh.
    #[error(
        "{found:?} is no address of a router; allowed are tls/HOST:PORT and, on this machine, tcp/127.0.0.1:PORT"
    )]
    Address {
        /// What was found.
        found: String,
    },
    /// Others could read along and pretend to be a station.
    #[error(
        "{found:?} is reached over the network without TLS; allowed are tls/HOST:PORT with `--fleet=FOLDER`, and tcp/127.0.0.1:PORT on this machine"
    )]
    Open {
        /// The address.
        found: String,
    },
    /// TLS without credentials.
    #[error(
        "{found:?} needs a certificate; `dobot fleet certificates FOLDER NAME...` makes them, and `--fleet=FOLDER/NAME` joins with one"
    )]
    NoCredentials {
        /// The address.
        found: String,
    },
    /// Zenoh does not take it.
    #[error("the fleet cannot be joined so: {0}")]
    Zenoh(String),
}

impl FleetConfig {
    /// Looks whether every name is one.
    ///
    /// # Errors
    ///
    /// [`FleetConfigError::Name`].
    pub(crate) fn check(&self) -> Result<(), FleetConfigError> {
        let named = [("the name of the station", &self.name)];
        let groups = self.about.groups.iter().map(|it| ("a group", it));
        let offers = self.about.offers.iter().map(|it| ("what it offers", it));
        for (what, found) in named.into_iter().chain(groups).chain(offers) {
            if !is_fleet_name(found) {
                let found: String = found.chars().take(60).collect();
                return Err(FleetConfigError::Name { what, found });
            }
        }
        Ok(())
    }
}

/// What Zenoh is told where stations join.
pub(crate) fn session(
    connect: &[String],
    credentials: Option<&Credentials>,
) -> Result<Config, FleetConfigError> {
    check_addresses(connect, credentials)?;
    let mut config = Settings::new(credentials);
    if connect.is_empty() {
        config.set("mode", "\"peer\"");
        config.set("listen/endpoints", &listen(credentials.is_some()));
        config.set("scouting/multicast/enabled", "true");
        if credentials.is_none() {
            config.set("scouting/multicast/interface", "\"lo\"");
        }
    } else {
        // One way to everyone: a mesh of a hundred stations would be five thousand connections.
        config.set("mode", "\"client\"");
        config.set("listen/endpoints", "[]");
        config.set("scouting/multicast/enabled", "false");
        config.set("connect/endpoints", &json(connect));
    }
    config.done()
}

/// What a router is told.
pub(crate) fn router(
    listen: &[String],
    credentials: Option<&Credentials>,
) -> Result<Config, FleetConfigError> {
    check_addresses(listen, credentials)?;
    let mut config = Settings::new(credentials);
    config.set("mode", "\"router\"");
    config.set("listen/endpoints", &json(listen));
    config.set("scouting/multicast/enabled", "false");
    config.done()
}

/// Settings of Zenoh, written down one after another.
struct Settings {
    config: Config,
    problem: Option<String>,
}

impl Settings {
    fn new(credentials: Option<&Credentials>) -> Self {
        let mut settings = Self {
            config: Config::default(),
            problem: None,
        };
        // It goes on trying for as long as the station runs.
        settings.set("connect/timeout_ms", "-1");
        settings.set("connect/exit_on_failure", "false");
        let retry =
            r#"{"period_init_ms": 500, "period_max_ms": 2000, "period_increase_factor": 2}"#;
        settings.set("connect/retry", retry);
        // A station that is killed is missed within three seconds.
        settings.set("transport/link/tx/lease", "3000");
        settings.set("transport/link/rx/max_message_size", "83886080");
        settings.set("transport/shared_memory/enabled", "false");
        settings.set("transport/unicast/max_sessions", "2500");
        if let Some(credentials) = credentials {
            let text = |path: &std::path::Path| json(&path.display().to_string());
            let tls = |name: &str| format!("transport/link/tls/{name}");
            let [authority, certificate, key] = credentials.files().map(|it| text(&it));
            settings.set(&tls("root_ca_certificate"), &authority);
            settings.set(&tls("enable_mtls"), "true");
            for side in ["listen", "connect"] {
                settings.set(&tls(&format!("{side}_certificate")), &certificate);
                settings.set(&tls(&format!("{side}_private_key")), &key);
            }
            // Zenoh believes the authorities of the web, too: what counts is that one is found where its certificate says.
            settings.set(&tls("verify_name_on_connect"), "true");
        }
        settings
    }

    fn set(&mut self, key: &str, value: &str) {
        if let Err(error) = self.config.insert_json5(key, value) {
            self.problem
                .get_or_insert_with(|| format!("{key} = {value}: {error}"));
        }
    }

    fn done(self) -> Result<Config, FleetConfigError> {
        match self.problem {
            Some(problem) => Err(FleetConfigError::Zenoh(problem)),
            None => Ok(self.config),
        }
    }
}

fn listen(secure: bool) -> String {
    json(&[if secure {
        "tls/0.0.0.0:0"
    } else {
        "tcp/127.0.0.1:0"
    }])
}

fn json(value: &(impl serde::Serialize + ?Sized)) -> String {
    serde_json::to_string(value).expect("texts are JSON")
}

fn check_addresses(
    found: &[String],
    credentials: Option<&Credentials>,
) -> Result<(), FleetConfigError> {
    let mut all = found.iter();
    all.try_for_each(|it| check_address(it, credentials.is_some()))
}

/// Whether an address is one of Zenoh, and nobody can read along.
fn check_address(found: &str, has_credentials: bool) -> Result<(), FleetConfigError> {
    let wrong = || FleetConfigError::Address {
        found: found.chars().take(80).collect(),
    };
    let (scheme, place) = found.split_once('/').ok_or_else(wrong)?;
    let (host, port) = place.rsplit_once(':').ok_or_else(wrong)?;
    let is_plain = |it: char| it.is_ascii_alphanumeric() || ".-_[]:".contains(it);
    if host.is_empty() || !host.chars().all(is_plain) || port.parse::<u16>().is_err() {
        return Err(wrong());
    }
    let found = found.to_owned();
    match scheme {
        "tls" if has_credentials => Ok(()),
        "tls" => Err(FleetConfigError::NoCredentials { found }),
        "tcp" if is_loopback(host) => Ok(()),
        "tcp" => Err(FleetConfigError::Open { found }),
        _ => Err(wrong()),
    }
}

fn is_loopback(host: &str) -> bool {
    let bare = host.trim_start_matches('[').trim_end_matches(']');
    host == "localhost" || bare.parse::<IpAddr>().is_ok_and(|it| it.is_loopback())
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn zenoh_takes_what_it_is_told() {
        session(&[], None).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let all = Credentials::make(folder.path(), &["desk-3".parse().unwrap()]).unwrap();
        for connect in [vec![], vec!["tls/router.school:7447".to_owned()]] {
            session(&connect, Some(&all[0])).unwrap();
        }
        router(&["tcp/127.0.0.1:0".into()], None).unwrap();
    }

    #[test]
    fn an_address_where_others_read_along_is_refused_and_told_what_is_allowed() {
        for (address, word) in [
            ("tcp/192.168.0.7:7447", "without TLS"),
            (
                "tls/192.168.0.7:7447",
                "`dobot fleet certificates FOLDER NAME...`",
            ),
            ("192.168.0.7:7447", "allowed are tls/HOST:PORT"),
            ("udp/127.0.0.1:7447", "allowed are tls/HOST:PORT"),
            ("tcp/127.0.0.1", "allowed are tls/HOST:PORT"),
            ("tcp/:7447", "allowed are tls/HOST:PORT"),
            ("tcp/127.0.0.1:99999", "allowed are tls/HOST:PORT"),
            ("tcp/a#iface=eth0:1", "allowed are tls/HOST:PORT"),
        ] {
            let error = session(&[address.into()], None).unwrap_err().to_string();
            assert!(error.contains(word), "{address}: {error}");
        }
        for address in ["tcp/127.0.0.1:7447", "tcp/localhost:7447", "tcp/[::1]:7447"] {
            session(&[address.into()], None).unwrap();
        }
    }

    #[test]
    fn a_name_that_is_none_is_told_with_what_is_allowed() {
        let config = FleetConfig {
            about: MemberAbout {
                groups: vec!["Room 2".into()],
                ..MemberAbout::default()
            },
            name: "desk-3".into(),
            work: None,
        };
        let error = config.check().unwrap_err().to_string();
        assert!(
            error.starts_with("a group is \"Room 2\"; allowed are"),
            "{error}"
        );
    }
}
