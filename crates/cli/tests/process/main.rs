//! The program as a process: exit codes, standard output and errors.

#[cfg(target_os = "linux")]
mod accuracy;
#[cfg(all(unix, feature = "full"))]
mod agents;
mod arguments;
mod calibrating;
#[cfg(feature = "full")]
mod captures;
mod conformance;
#[cfg(feature = "full")]
mod datasets;
mod decoding;
mod defaults;
mod doctor;
mod drawing;
mod files;
#[cfg(unix)]
mod guarding;
#[cfg(all(unix, feature = "full"))]
mod http_agents;
#[cfg(unix)]
mod killing;
#[cfg(unix)]
mod links;
#[cfg(unix)]
mod logging;
mod models;
#[cfg(target_os = "linux")]
mod pendant;
mod playing;
mod policy;
mod recordings;
#[cfg(unix)]
mod services;
mod simulating;
#[cfg(unix)]
mod states;
#[cfg(unix)]
mod stations;
#[path = "../support/mod.rs"]
mod support;
#[cfg(feature = "fleet")]
mod together;
#[cfg(unix)]
mod upgrades;
mod worlds;
