//! Agents at a station that is built without tools for them.

use super::Harness;

#[tokio::test]
async fn an_agent_learns_how_to_get_a_station_with_tools() {
    let harness = Harness::near();
    let refused = harness.json("POST", "/mcp", "{}").await;
    refused.is(404).is_problem("not-built");
    assert!(refused.body.contains("--features full"), "{refused:?}");
}
