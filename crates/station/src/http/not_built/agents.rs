//! The endpoint for agents, in a build without them.

use dobot_api::problem_kinds::NOT_BUILT;
use dobot_api::{NotBuilt, StationAddress};

use crate::http::exchange::responses::RequestFailed;

/// Answers agents that this build has no tools for them.
#[derive(Debug)]
pub(super) struct HttpAgents;

impl HttpAgents {
    pub(super) fn new(_: StationAddress) -> Self {
        Self
    }

    #[expect(
        clippy::unused_self,
        reason = "with the feature `full` sessions end here"
    )]
    pub(super) fn end(&self) {}
}

/// Refuses an agent.
pub(super) async fn agents() -> Result<(), RequestFailed> {
    let text = NotBuilt("tools for agents (MCP)").to_string();
    Err(NOT_BUILT.hinted(text, NotBuilt::HINT).into())
}
