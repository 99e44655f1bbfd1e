//! Configuration of a station's membership.

use std::collections::BTreeSet;
use std::net::IpAddr;
use std::path::PathBuf;

use dobot_api::{MemberAbout, is_fleet_name};
use zenoh::Config;

use crate::Credentials;

/// Configuration of a station's membership.
#[derive(Clone, Debug, Default)]
pub struct FleetConfig {
    /// The name of the station: 1 to 40 lowercase letters, digits and hyphens, beginning with a
    /// letter.
    pub name: String,
    /// The description that the station publishes.
    pub about: MemberAbout,
    /// The folder of the jobs that are submitted here for any arm; without it, none can be
    /// submitted.
    pub work: Option<PathBuf>,
}

/// The error returned when the configuration of a fleet is invalid.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FleetConfigError {
    /// An invalid name.
    #[error(
        "{what} is {found:?}; allowed are 1 to 40 lowercase letters a to z, digits and hyphens, beginning with a letter, as in desk-3"
    )]
    Name {
        /// The kind of name.
        what: &'static str,
        /// The name.
        found: String,
    },
    /// An invalid address of a router.
    #[error(
        "{found:?} is not the address of a router; allowed is quic/HOST:PORT, as in quic/router.school:7447"
    )]
    Address {
        /// The invalid text.
        found: String,
    },
    /// An address on another machine, without a certificate that is valid there.
    #[error(
        "{found:?} is on another machine, which requires a certificate; `dobot fleet certificates FOLDER NAME...` creates certificates, and `--fleet=FOLDER/NAME` joins with one. Without one, allowed is quic/127.0.0.1:PORT"
    )]
    NoCredentials {
        /// The address.
        found: String,
    },
    /// A station whose name differs from that of its certificate.
    #[error(
        "the station is named {name}, but its certificate is for {certificate}; start it with `--name {certificate}`, or with the certificate of {name}"
    )]
    OtherName {
        /// The name of the station.
        name: String,
        /// The name in its certificate.
        certificate: String,
    },
    /// Zenoh refuses the configuration.
    #[error("Zenoh refuses the configuration of the fleet: {0}")]
    Zenoh(String),
}

impl FleetConfig {
    /// Checks all names. The station's name must be that of its certificate, or of a virtual arm
    /// hosted by the certificate's station.
    ///
    /// # Errors
    ///
    /// [`FleetConfigError::Name`], [`FleetConfigError::OtherName`].
    pub(crate) fn check(&self, certificate: &str) -> Result<(), FleetConfigError> {
        let named = [("the name of the station", &self.name)];
        let groups = self.about.groups.iter().map(|group| ("a group", group));
        let offers = self
            .about
            .offers
            .iter()
            .map(|offer| ("an offered feature", offer));
        for (what, found) in named.into_iter().chain(groups).chain(offers) {
            if !is_fleet_name(found) {
                let found: String = found.chars().take(60).collect();
                return Err(FleetConfigError::Name { what, found });
            }
        }
        let holder = self.about.given_by.as_ref().unwrap_or(&self.name);
        if holder != certificate {
            return Err(FleetConfigError::OtherName {
                name: self.name.clone(),
                certificate: certificate.into(),
            });
        }
        Ok(())
    }
}

/// Returns the Zenoh configuration of a station's session.
pub(crate) fn session(
    connect: &[String],
    credentials: &Credentials,
) -> Result<Config, FleetConfigError> {
    check_addresses(connect, credentials)?;
    let mut config = Settings::new(credentials);
    if connect.is_empty() {
        config.set("mode", "\"peer\"");
        config.set("scouting/multicast/enabled", "true");
        if credentials.is_local() {
            config.set("listen/endpoints", "[\"quic/127.0.0.1:0\"]");
            config.set("scouting/multicast/interface", "\"lo\"");
        } else {
            config.set("listen/endpoints", "[\"quic/0.0.0.0:0\"]");
        }
    } else {
        // One link to a router: a mesh of a hundred stations would be five thousand connections.
        config.set("mode", "\"client\"");
        config.set("listen/endpoints", "[]");
        config.set("scouting/multicast/enabled", "false");
        config.set("connect/endpoints", &json(connect));
    }
    config.done()
}

/// Returns the Zenoh configuration of a router.
pub(crate) fn router(
    listen: &[String],
    credentials: &Credentials,
) -> Result<Config, FleetConfigError> {
    check_addresses(listen, credentials)?;
    let mut config = Settings::new(credentials);
    config.set("mode", "\"router\"");
    config.set("listen/endpoints", &json(listen));
    config.set("scouting/multicast/enabled", "false");
    config.done()
}

/// Zenoh settings, collected one by one.
struct Settings {
    config: Config,
    problem: Option<String>,
}

impl Settings {
    fn new(credentials: &Credentials) -> Self {
        let mut settings = Self {
            config: Config::default(),
            problem: None,
        };
        // Zenoh retries for as long as the station runs.
        settings.set("connect/timeout_ms", "-1");
        settings.set("connect/exit_on_failure", "false");
        let retry =
            r#"{"period_init_ms": 500, "period_max_ms": 2000, "period_increase_factor": 2}"#;
        settings.set("connect/retry", retry);
        // A killed station is noticed within three seconds.
        settings.set("transport/link/tx/lease", "3000");
        settings.set("transport/link/rx/max_message_size", "83886080");
        settings.set("transport/shared_memory/enabled", "false");
        settings.set("transport/unicast/max_sessions", "2500");
        // Zenoh's TLS link is not sound under load (eclipse-zenoh/zenoh#2557); QUIC has streams for
        // each direction. Set for both directions: stations connect to the addresses that others
        // announce.
        settings.set("transport/link/protocols", "[\"quic\"]");
        let mut tls =
            |name: &str, value: &str| settings.set(&format!("transport/link/tls/{name}"), value);
        let [authority, certificate, key] = credentials.base64().map(|part| json(&part));
        tls("root_ca_certificate_base64", &authority);
        tls("enable_mtls", "true");
        for side in ["listen", "connect"] {
            tls(&format!("{side}_certificate_base64"), &certificate);
            tls(&format!("{side}_private_key_base64"), &key);
        }
        tls("close_link_on_expiration", "true");
        // Zenoh also trusts public authorities, so the host must match the name in its certificate.
        tls("verify_name_on_connect", "true");
        if !credentials.revoked().is_empty() {
            settings.set("access_control", &denied(credentials.revoked()));
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

/// Returns the access rules that deny everything to holders of revoked certificates.
fn denied(revoked: &BTreeSet<String>) -> String {
    let messages = [
        "put",
        "delete",
        "declare_subscriber",
        "query",
        "declare_queryable",
        "reply",
        "liveliness_token",
        "declare_liveliness_subscriber",
        "liveliness_query",
    ];
    let rule = serde_json::json!({
        "id": "nothing", "key_exprs": ["**"], "messages": messages,
        "flows": ["ingress", "egress"], "permission": "deny",
    });
    json(&serde_json::json!({
        "enabled": true,
        "default_permission": "allow",
        "rules": [rule],
        "subjects": [{"id": "revoked", "cert_common_names": revoked}],
        "policies": [{"rules": ["nothing"], "subjects": ["revoked"]}],
    }))
}

fn json(value: &(impl serde::Serialize + ?Sized)) -> String {
    serde_json::to_string(value).expect("texts are JSON")
}

fn check_addresses(found: &[String], credentials: &Credentials) -> Result<(), FleetConfigError> {
    let mut all = found.iter();
    all.try_for_each(|address| check_address(address, credentials.is_local()))
}

/// Checks that an address is a Zenoh address and that the certificate is valid there.
fn check_address(found: &str, is_local: bool) -> Result<(), FleetConfigError> {
    let wrong = || FleetConfigError::Address {
        found: found.chars().take(80).collect(),
    };
    let place = found.strip_prefix("quic/").ok_or_else(wrong)?;
    let (host, port) = place.rsplit_once(':').ok_or_else(wrong)?;
    let is_plain = |char: char| char.is_ascii_alphanumeric() || ".-_[]:".contains(char);
    if host.is_empty() || !host.chars().all(is_plain) || port.parse::<u16>().is_err() {
        return Err(wrong());
    }
    if is_local && !is_loopback(host) {
        let found = found.to_owned();
        return Err(FleetConfigError::NoCredentials { found });
    }
    Ok(())
}

fn is_loopback(host: &str) -> bool {
    let bare = host.trim_start_matches('[').trim_end_matches(']');
    host == "localhost" || bare.parse::<IpAddr>().is_ok_and(|ip| ip.is_loopback())
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn local() -> (tempfile::TempDir, Credentials) {
        let folder = tempfile::tempdir().unwrap();
        let credentials = Credentials::local(&folder.path().join("own"), "desk-3").unwrap();
        (folder, credentials)
    }

    #[test]
    fn zenoh_accepts_its_configuration() {
        let (_folder, own) = local();
        session(&[], &own).unwrap();
        router(&["quic/127.0.0.1:0".into()], &own).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let names = ["desk-3", "desk-4"].map(|name| name.parse().unwrap());
        Credentials::make(folder.path(), &names).unwrap();
        Credentials::revoke(folder.path(), "desk-4").unwrap();
        let desk = Credentials::read(&folder.path().join("desk-3")).unwrap();
        for connect in [vec![], vec!["quic/router.school:7447".to_owned()]] {
            session(&connect, &desk).unwrap();
        }
    }

    #[test]
    fn every_link_is_quic_in_both_directions() {
        let (_folder, own) = local();
        for config in [
            session(&[], &own),
            router(&["quic/127.0.0.1:0".into()], &own),
        ] {
            let protocols = config.unwrap().get_json("transport/link/protocols");
            assert_eq!(protocols.unwrap(), "[\"quic\"]");
        }
        let listen = session(&[], &own)
            .unwrap()
            .get_json("listen/endpoints")
            .unwrap();
        assert!(listen.contains("quic/127.0.0.1:0"), "{listen}");
    }

    #[test]
    fn an_address_without_certificate_check_is_refused_with_what_is_allowed() {
        let (_folder, own) = local();
        for (address, word) in [
            ("tcp/192.168.0.7:7447", "allowed is quic/HOST:PORT"),
            ("tcp/127.0.0.1:7447", "allowed is quic/HOST:PORT"),
            (
                "quic/192.168.0.7:7447",
                "`dobot fleet certificates FOLDER NAME...`",
            ),
            ("192.168.0.7:7447", "allowed is quic/HOST:PORT"),
            ("udp/127.0.0.1:7447", "allowed is quic/HOST:PORT"),
            ("quic/127.0.0.1", "allowed is quic/HOST:PORT"),
            ("quic/:7447", "allowed is quic/HOST:PORT"),
            ("quic/127.0.0.1:99999", "allowed is quic/HOST:PORT"),
            ("quic/a#iface=eth0:1", "allowed is quic/HOST:PORT"),
        ] {
            let error = session(&[address.into()], &own).unwrap_err().to_string();
            assert!(error.contains(word), "{address}: {error}");
        }
        for address in [
            "quic/127.0.0.1:7447",
            "quic/localhost:7447",
            "quic/[::1]:7447",
        ] {
            session(&[address.into()], &own).unwrap();
        }
    }

    #[test]
    fn a_station_has_the_name_of_its_certificate_or_one_from_its_host() {
        let mut config = FleetConfig {
            name: "desk-3".into(),
            ..FleetConfig::default()
        };
        config.check("desk-3").unwrap();
        let error = config.check("desk-4").unwrap_err().to_string();
        assert!(error.contains("`--name desk-4`"), "{error}");
        config.about.given_by = Some("hall".into());
        config.check("hall").unwrap();
    }

    #[test]
    fn an_invalid_name_is_reported_with_what_is_allowed() {
        let config = FleetConfig {
            about: MemberAbout {
                groups: vec!["Room 2".into()],
                ..MemberAbout::default()
            },
            name: "desk-3".into(),
            work: None,
        };
        let error = config.check("desk-3").unwrap_err().to_string();
        assert!(
            error.starts_with("a group is \"Room 2\"; allowed are"),
            "{error}"
        );
    }
}
