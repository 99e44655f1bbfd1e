//! A Dobot Arm as tools for agents (Model Context Protocol).
//!
//! Each call opens its own connection to a running station, so that a stop always gets through
//! during other calls. All rules are the station's. The arm is stopped when a call that moves it is
//! cancelled or its agent is gone. [`serve`] serves the agent at the other end of two streams,
//! [`HttpAgents`] those of an HTTP server.
//!
//! ```no_run
//! use dobot_api::StationAddress;
//! use dobot_mcp::{Agents, Settings, serve};
//!
//! # async fn example() -> Result<(), Box<dyn std::error::Error>> {
//! let station = StationAddress::new("http://127.0.0.1:8642")?;
//! let agents = Agents::new(Settings::at(station));
//! let (_end, ending) = tokio::sync::watch::channel(false);
//! serve(agents, tokio::io::stdin(), tokio::io::stdout(), ending).await?;
//! # Ok(())
//! # }
//! ```

mod agents;
mod arguments;
mod call;
mod consent;
mod drawings;
mod files;
mod http;
mod jobs;
mod own_jobs;
mod prompts;
mod refused;
mod resources;
mod serve;
mod settings;
mod tools;

pub use agents::Agents;
pub use files::{FilesFolder, FilesFolderError};
pub use http::{HttpAgents, TooManyAgents};
pub use serve::{ServeError, serve};
pub use settings::{NoStation, Settings};
