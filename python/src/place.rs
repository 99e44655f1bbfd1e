//! Parsing of arm addresses.

use std::path::PathBuf;

use dobot_api::{CertificateTrust, Folders, StationAddress, StationSearch, fingerprint};
use dobot_host::LocalArm;
use dobot_safety::Policy;
use dobot_session::Address;
use dobot_wire::Dialect;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::failure::value_error;
use crate::virtual_arm::VirtualSetup;
use crate::worker::Where;

/// The options of a connection: a Python dictionary.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct ConnectOptions {
    /// The name shown to other clients.
    pub(crate) name: String,
    token: Option<String>,
    dialect: Option<String>,
    /// The watchdog program for an arm at an address.
    watchdog: Option<PathBuf>,
    /// The SHA-256 digest of a station's certificate.
    fingerprint: Option<String>,
    /// A PEM file of the certificate's issuer.
    ca: Option<PathBuf>,
    /// The text of a scene, for a virtual arm of this process.
    world: Option<String>,
    faults: Vec<String>,
    seed: u64,
}

impl ConnectOptions {
    fn trust(&self) -> PyResult<Option<CertificateTrust>> {
        match (&self.fingerprint, &self.ca) {
            (None, None) => Ok(None),
            (Some(digest), None) => {
                let digest = fingerprint(digest).map_err(|error| value_error(&error))?;
                Ok(Some(CertificateTrust::Fingerprint(digest)))
            }
            (None, Some(file)) => Ok(Some(CertificateTrust::Authority(file.clone()))),
            (Some(_), Some(_)) => Err(value_error(&"give fingerprint or ca, not both")),
        }
    }
}

/// Parses the address of an arm.
pub(crate) fn place(at: &str, options: ConnectOptions) -> PyResult<Where> {
    if let Some(personality) = at.strip_prefix("virtual:") {
        let scene = options.world.as_deref();
        let setup = VirtualSetup::new(personality, scene, &options.faults, options.seed)?;
        return Ok(Where::Virtual(Box::new(setup)));
    }
    if options.world.is_some() || !options.faults.is_empty() {
        return Err(PyValueError::new_err(format!(
            "world and faults require a virtual arm in this process (virtual:), but the arm is at `{at}`"
        )));
    }
    let trust = options.trust()?;
    let search = |address| StationSearch {
        address,
        token: options.token.clone(),
        trust: trust.clone(),
    };
    if at == "station" {
        return Ok(Where::Station(search(None)));
    }
    if at.starts_with("http://") || at.starts_with("https://") {
        StationAddress::new(at).map_err(|error| value_error(&error))?;
        return Ok(Where::Station(search(Some(at.to_owned()))));
    }
    if at.starts_with("serial:") || at.starts_with("tcp:") {
        let address = at.parse::<Address>().map_err(|error| value_error(&error))?;
        let dialect = options
            .dialect
            .as_deref()
            .map(str::parse::<Dialect>)
            .transpose();
        let folders = Folders::of_environment();
        return Ok(Where::Local(Box::new(LocalArm {
            address,
            dialect: dialect.map_err(|error| value_error(&error))?,
            policy: Policy::default(),
            folders: folders.ok_or_else(|| {
                value_error(
                    &"this user has no home folder; set the environment variable DOBOT_DATA",
                )
            })?,
            watchdog: options.watchdog,
        })));
    }
    Err(PyValueError::new_err(format!(
        "the arm is at `{at}`; allowed are virtual:, virtual:firmware-1.1, station (the one on this machine, started with `dobot up`), http://HOST:PORT, serial:PORT and tcp:HOST:PORT"
    )))
}
