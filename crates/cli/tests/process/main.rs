//! The program as a process: exit codes, standard output and errors.

#[cfg(unix)]
mod agents;
mod arguments;
mod calibrating;
mod conformance;
mod decoding;
mod defaults;
mod drawing;
mod going;
#[cfg(unix)]
mod guarding;
#[cfg(unix)]
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
mod program;
mod recordings;
#[cfg(unix)]
mod services;
mod simulating;
#[cfg(unix)]
mod states;
#[cfg(unix)]
mod stations;
#[cfg(target_os = "linux")]
mod terminal;
#[cfg(feature = "fleet")]
mod together;
#[cfg(target_os = "linux")]
mod touching;
#[cfg(unix)]
mod wire;
mod worlds;
