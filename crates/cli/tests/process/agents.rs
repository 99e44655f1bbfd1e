//! `dobot mcp`, with the client of the protocol's own library.

use dobot_wire::Command;
use rmcp::model::{CallToolRequest, CallToolRequestParams, CallToolResult, ClientRequest};
use rmcp::service::{PeerRequestOptions, RequestHandle, RunningService};
use rmcp::transport::TokioChildProcess;
use rmcp::{RoleClient, ServiceExt};
use serde_json::{Value, json};

use crate::support::arm::{WiredArm, fast_arm};
use crate::support::program::{command, example};
use crate::support::running_process::RunningProcess;
use crate::support::up::Up;
use crate::support::wire::Passed;

/// A station whose arm is at the end of a wire that records its packets.
pub(crate) struct Desk {
    pub(crate) up: Up,
    arm: WiredArm,
}

impl Desk {
    pub(crate) fn new() -> Self {
        let arm = WiredArm::new(fast_arm(&["--tcp", "127.0.0.1:0"]));
        let to = ["--arm", &arm.address, "--dialect", "specification"];
        let up = Up::with_arm(&to, &[]);
        wait_for_state(&up, |state| state["arm"].is_object());
        up.dobot(&["move", "200", "0", "30", "--pose-confirmed"])
            .succeeds();
        let desk = Self { up, arm };
        desk.got();
        desk
    }

    /// What the arm got since this was asked last.
    pub(crate) fn got(&self) -> Vec<Command> {
        let of_arm = |passed| match passed {
            Passed::ToArm(_, command) => Some(command),
            _ => None,
        };
        self.arm.passed.try_iter().filter_map(of_arm).collect()
    }

    /// Until the arm gets a vector.
    fn draws(&self) {
        while !matches!(self.arm.next(), Passed::ToArm(_, command) if is_vector(&command)) {}
    }
}

pub(crate) struct Agent(pub(crate) RunningService<RoleClient, ()>);

impl Agent {
    async fn new(up: &Up, arguments: &[&str]) -> Self {
        let arguments = [&["mcp", "--may-move"], arguments].concat();
        Self::of(up.command(&arguments)).await
    }

    async fn of(command: std::process::Command) -> Self {
        let child = TokioChildProcess::new(tokio::process::Command::from(command));
        let client = ().serve(child.expect("it starts")).await;
        Self(client.expect("it greets"))
    }

    pub(crate) async fn call(&self, tool: &'static str, arguments: Value) -> CallToolResult {
        let params = params(tool, arguments);
        self.0.call_tool(params).await.expect("it answers")
    }

    /// The answer of a tool that succeeds.
    #[track_caller]
    pub(crate) fn done(result: CallToolResult) -> Value {
        assert_eq!(result.is_error, Some(false), "{result:?}");
        result.structured_content.expect("it is structured")
    }

    /// The answer of a tool that refuses.
    #[track_caller]
    pub(crate) fn refused(result: CallToolResult, kind: &str) -> Value {
        assert_eq!(result.is_error, Some(true), "{result:?}");
        let refused = result.structured_content.expect("it is structured");
        assert_eq!(refused["kind"], kind, "{refused}");
        refused
    }

    pub(crate) async fn plans(&self, arguments: Value) -> Value {
        Self::done(self.call("plan_drawing", arguments).await)
    }

    /// Asks for a drawing, and waits until the arm is at it, not until it is over.
    pub(crate) async fn begins_to_draw(&self, desk: &Desk) -> RequestHandle<RoleClient> {
        let planned = self.plans(square()).await;
        let draw = json!({"drawing": planned["drawing"], "wait_s": 600});
        let request = CallToolRequest::new(params("draw", draw));
        let request = ClientRequest::CallToolRequest(request);
        let options = PeerRequestOptions::no_options();
        let drawing = self.0.send_cancellable_request(request, options).await;
        tokio::task::block_in_place(|| desk.draws());
        drawing.expect("it is sent")
    }
}

fn params(tool: &'static str, arguments: Value) -> CallToolRequestParams {
    let Value::Object(arguments) = arguments else {
        panic!("the arguments are no object: {arguments}");
    };
    CallToolRequestParams::new(tool).with_arguments(arguments)
}

/// It is drawn so slowly that it is not over before it is stopped.
pub(crate) fn square() -> Value {
    let svg = std::fs::read_to_string(example("square.svg")).expect("it is there");
    json!({"svg": svg, "options": {"place": {"pen_down": -40}, "tool": {"speed": 2}}})
}

fn is_vector(command: &Command) -> bool {
    matches!(command, Command::WriteVector(_))
}

pub(crate) fn is_motion(command: &Command) -> bool {
    is_vector(command) || matches!(command, Command::MoveTo(_) | Command::MoveJoints(_))
}

#[tokio::test(flavor = "multi_thread")]
async fn an_agent_looks_checks_a_move_and_moves_and_a_refused_move_does_not_reach_the_arm() {
    let desk = Desk::new();
    let agent = Agent::new(&desk.up, &[]).await;
    let seen = Agent::done(agent.call("look", json!({})).await);
    assert_eq!(seen["alarms"], json!([]), "{seen}");
    assert!(seen["arm"]["x_mm"].is_number(), "{seen}");
    let to = json!({"x_mm": 220, "y_mm": -30, "z_mm": 20, "path": "movj"});
    let way = Agent::done(agent.call("check_move", json!({"move_to": to})).await);
    assert!(way["takes_s"].as_f64().expect("a number") > 0.0, "{way}");
    assert!(!desk.got().iter().any(is_motion));
    let moved = Agent::done(agent.call("move_to", to).await);
    let y_mm = moved["arm"]["y_mm"].as_f64().expect("a number");
    assert!((y_mm + 30.0).abs() < 0.1, "{moved}");
    let is_there =
        |command: &Command| matches!(command, Command::MoveTo(target) if target.x_mm == 220.0);
    assert!(desk.got().iter().any(is_there));
    let into_the_table = json!({"x_mm": 220, "y_mm": 0, "z_mm": -90});
    let refused = agent.call("move_to", into_the_table).await;
    let refused = Agent::refused(refused, "policy");
    assert_eq!(refused["rule"], "table");
    assert!(refused["at_mm"].is_array(), "{refused}");
    assert!(refused["hint"].is_string(), "{refused}");
    assert!(!desk.got().iter().any(is_motion));
}

#[tokio::test(flavor = "multi_thread")]
async fn invalid_arguments_are_reported_and_move_nothing() {
    let desk = Desk::new();
    let agent = Agent::new(&desk.up, &[]).await;
    for (tool, arguments, kind, expected) in [
        (
            "move_to",
            json!({"x_mm": "NaN", "y_mm": 0, "z_mm": 20}),
            "invalid",
            "NaN",
        ),
        (
            "move_to",
            json!({"x_mm": 1e300, "y_mm": 0, "z_mm": 20}),
            "out-of-range",
            "x_mm",
        ),
        (
            "move_to",
            json!({"x_mm": null, "y_mm": 0, "z_mm": 20}),
            "invalid",
            "null",
        ),
        (
            "move_to",
            json!({"x_mm": 220, "y_mm": 0}),
            "invalid",
            "z_mm",
        ),
        (
            "move_to",
            json!({"x_mm": 220, "y_mm": 0, "z_mm": 20, "laser": true}),
            "invalid",
            "laser",
        ),
        (
            "move_to",
            json!({"x_mm": 220, "y_mm": 0, "z_mm": 20, "path": "fly"}),
            "invalid",
            "fly",
        ),
        (
            "move_joints",
            json!({"base_deg": [0], "rear_deg": 45, "fore_deg": 45}),
            "invalid",
            "f64",
        ),
        ("check_move", json!({}), "invalid", "move_to"),
        ("look", json!({"deep": true}), "invalid", "deep"),
        ("draw", json!({"drawing": 9}), "no-such-drawing", "9"),
        (
            "draw",
            json!({"drawing": 1, "wait_s": -1}),
            "out-of-range",
            "-1",
        ),
        ("plan_drawing", json!({}), "invalid", "text"),
        ("plan_drawing", json!({"svg": "no svg"}), "bad-drawing", ""),
        (
            "plan_drawing",
            json!({"text": "a", "options": {"what": {"colour": 1}}}),
            "invalid",
            "colour",
        ),
        (
            "run_program",
            json!({"program": {"text": "steps = 3"}}),
            "bad-program",
            "line 1",
        ),
        (
            "change_job",
            json!({"job": 3, "action": "explode"}),
            "invalid",
            "explode",
        ),
        ("jobs", json!({"job": 77}), "no-such-job", "77"),
    ] {
        let refused = Agent::refused(agent.call(tool, arguments).await, kind);
        let detail = refused["detail"].as_str().expect("a text");
        assert!(detail.contains(expected), "{tool}: {refused}");
    }
    assert!(!desk.got().iter().any(is_motion));
}

#[tokio::test(flavor = "multi_thread")]
async fn a_drawing_is_previewed_before_it_is_drawn_and_another_call_stops_it() {
    let desk = Desk::new();
    let agent = Agent::new(&desk.up, &[]).await;
    let planned = agent.call("plan_drawing", square()).await;
    let picture = planned
        .content
        .iter()
        .find_map(|content| content.as_image());
    assert_eq!(picture.expect("a picture").mime_type, "image/png");
    let planned = Agent::done(planned);
    assert_eq!(planned["refused"], Value::Null, "{planned}");
    assert!(!desk.got().iter().any(is_motion));
    let draw = json!({"drawing": planned["drawing"], "wait_s": 600});
    let (drawn, ()) = tokio::join!(agent.call("draw", draw), async {
        tokio::task::block_in_place(|| desk.draws());
        let stopped = agent.call("stop", json!({"reason": "a hand"})).await;
        assert!(Agent::done(stopped)["rests_within_s"].is_number());
    });
    let drawn = Agent::done(drawn);
    assert_eq!(drawn["job"]["phase"], "paused", "{drawn}");
    let seen = Agent::done(agent.call("look", json!({})).await);
    let alarm = seen["alarms"][0].as_str().expect("an alarm");
    assert!(alarm.contains("a hand"), "{seen}");
    // No tool lets it move again.
    let to = json!({"x_mm": 220, "y_mm": 0, "z_mm": 20});
    Agent::refused(agent.call("move_to", to).await, "stopped");
}

#[tokio::test(flavor = "multi_thread")]
async fn a_call_that_is_cancelled_stops_the_arm() {
    let desk = Desk::new();
    let agent = Agent::new(&desk.up, &[]).await;
    let drawing = agent.begins_to_draw(&desk).await;
    drawing
        .cancel(Some("enough".to_owned()))
        .await
        .expect("it is sent");
    stopped(&desk.up).await;
}

/// Waits until the arm is stopped because an agent gave up.
pub(crate) async fn stopped(up: &Up) {
    wait_for_state(up, |state| state["stop"].is_object());
    let other = Agent::new(up, &[]).await;
    let seen = Agent::done(other.call("look", json!({})).await);
    let alarms = seen["alarms"].to_string();
    assert!(alarms.contains("the agent cancelled"), "{seen}");
    assert_ne!(seen["job"]["phase"], "running", "{seen}");
}

/// Waits for a state of a station without blocking the agents.
fn wait_for_state(up: &Up, is_match: impl Fn(&Value) -> bool) {
    tokio::task::block_in_place(|| up.wait_for_state(is_match));
}

#[tokio::test(flavor = "multi_thread")]
async fn an_agent_that_ends_during_a_drawing_stops_the_arm() {
    let desk = Desk::new();
    let agent = Agent::new(&desk.up, &[]).await;
    let _drawing = agent.begins_to_draw(&desk).await;
    agent.0.cancel().await.expect("it ends");
    stopped(&desk.up).await;
}

#[tokio::test(flavor = "multi_thread")]
async fn if_a_person_must_be_asked_drawings_are_queued_and_nothing_moves() {
    let desk = Desk::new();
    let agent = Agent::of(desk.up.command(&["mcp"])).await;
    only_queues(&desk, &agent).await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_queue_token_moves_nothing_and_a_watch_token_queues_nothing() {
    let desk = Desk::new();
    let with_token = |role: &str| {
        let token = desk
            .up
            .dobot(&["token", "add", role, role])
            .succeeds()
            .stdout;
        let mut command = desk.up.command(&["mcp", "--station", &desk.up.page]);
        command.env("DOBOT_TOKEN", token.trim());
        command
    };
    only_queues(&desk, &Agent::of(with_token("queue")).await).await;
    let watcher = Agent::of(with_token("watch")).await;
    let planned = watcher.plans(square()).await;
    let draw = json!({"drawing": planned["drawing"]});
    Agent::refused(watcher.call("draw", draw).await, "role");
    let to = json!({"x_mm": 220, "y_mm": 0, "z_mm": 20});
    Agent::refused(watcher.call("move_to", to).await, "role");
    assert!(!desk.got().iter().any(is_motion));
    Agent::done(watcher.call("stop", json!({})).await);
}

pub(crate) async fn only_queues(desk: &Desk, agent: &Agent) {
    let to = json!({"x_mm": 220, "y_mm": 0, "z_mm": 20});
    let refused = Agent::refused(agent.call("move_to", to).await, "needs-a-person");
    let hint = refused["hint"].as_str().expect("a hint");
    assert!(hint.contains("run_program"), "{hint}");
    let planned = agent.plans(square()).await;
    let draw = json!({"drawing": planned["drawing"]});
    let queued = Agent::done(agent.call("draw", draw).await);
    assert_eq!(queued["job"]["phase"], "queued", "{queued}");
    let program =
        json!({"text": "title = \"there\"\n\n[[steps]]\ngo = { x = 200, y = 0, z = 50 }\n"});
    let run = agent.call("run_program", json!({"program": program})).await;
    assert_eq!(Agent::done(run)["job"]["phase"], "queued");
    let resume = json!({"job": queued["job"]["job"], "action": "resume"});
    Agent::refused(agent.call("change_job", resume).await, "needs-a-person");
    assert!(!desk.got().iter().any(is_motion));
}

#[tokio::test(flavor = "multi_thread")]
async fn an_agent_resumes_only_jobs_that_it_paused_itself() {
    let desk = Desk::new();
    let agent = Agent::new(&desk.up, &[]).await;
    let resume = |job: u64| json!({"job": job, "action": "resume", "wait_s": 0});
    let refused = async |job, part: &str| {
        let refused = Agent::refused(
            agent.call("change_job", resume(job)).await,
            "needs-a-person",
        );
        let detail = refused["detail"].as_str().expect("a detail");
        assert!(detail.contains(part), "{detail}");
        assert!(!desk.got().iter().any(is_motion), "{detail}");
    };
    // Its own, which it has paused.
    let planned = agent.plans(square()).await;
    let draw = json!({"drawing": planned["drawing"], "wait_s": 0});
    Agent::done(agent.call("draw", draw).await);
    tokio::task::block_in_place(|| desk.draws());
    let paused = |state: &Value| state["job"]["phase"] == "paused";
    Agent::done(
        agent
            .call("change_job", json!({"job": 1, "action": "pause"}))
            .await,
    );
    wait_for_state(&desk.up, paused);
    desk.got();
    Agent::done(agent.call("change_job", resume(1)).await);
    tokio::task::block_in_place(|| desk.draws());
    // Its own, which a person has paused.
    desk.up.dobot(&["jobs", "pause"]).succeeds();
    wait_for_state(&desk.up, paused);
    desk.got();
    refused(1, "did not pause it").await;
    desk.up.dobot(&["jobs", "cancel", "1"]).succeeds();
    // That of a person.
    let program = desk.up.folder.path().join("wait.toml");
    let text = "title = \"pen\"\n\n[[steps]]\ngo = { x = 200, y = 0, z = 50 }\n\n[[steps]]\nwait = \"change the pen\"\n\n[[steps]]\ngo = { x = 210, y = 0, z = 50 }\n";
    std::fs::write(&program, text).expect("there is room");
    let program = program.to_str().expect("it is text");
    // Without a terminal it is left paused where it waits.
    let line = desk.up.dobot(&["play", program]).waits();
    assert!(line.contains("change the pen"), "{line}");
    desk.got();
    refused(2, "another client queued it").await;
    // And its own one that waits for a person.
    let run = json!({"program": {"text": text}, "wait_s": 600});
    let waits = Agent::done(agent.call("run_program", run).await);
    assert_eq!(waits["job"]["waits_for_person"], true, "{waits}");
    desk.got();
    refused(3, "it waits for a person").await;
    // A script cannot, either; an administrator can on request.
    let start = ["jobs", "start", "3"];
    desk.up
        .dobot(&start)
        .fails(1, &["waits for a person", "change the pen"]);
    assert!(!desk.got().iter().any(is_motion));
    desk.up
        .dobot(&[&start[..], &["--as-person"]].concat())
        .succeeds();
    assert!(desk.got().iter().any(is_motion));
}

#[tokio::test(flavor = "multi_thread")]
async fn a_program_is_checked_and_run_to_its_end() {
    let up = Up::new(&[]);
    wait_for_state(&up, |state| state["arm"].is_object());
    let agent = Agent::new(&up, &[]).await;
    let program =
        json!({"text": "title = \"there\"\n\n[[steps]]\ngo = { x = 200, y = 0, z = 50 }\n"});
    let checked = Agent::done(agent.call("check_program", program.clone()).await);
    assert_eq!(checked["problems"], json!([]), "{checked}");
    let run = json!({"program": program, "times": 2, "wait_s": 600});
    let done = Agent::done(agent.call("run_program", run).await);
    assert_eq!(done["job"]["phase"], "done", "{done}");
    let jobs = Agent::done(agent.call("jobs", json!({})).await);
    assert_eq!(jobs["jobs"][0]["title"], "there", "{jobs}");
}

#[tokio::test(flavor = "multi_thread")]
async fn agents_do_not_burn_and_read_no_file_outside_their_folder() {
    let up = Up::new(&[]);
    wait_for_state(&up, |state| state["arm"].is_object());
    let folder = tempfile::tempdir().expect("there is room");
    let inside = folder.path().join("inside");
    std::fs::create_dir(&inside).expect("there is room");
    let square =
        std::fs::read(crate::support::program::example("square.svg")).expect("it is there");
    std::fs::write(inside.join("square.svg"), &square).expect("there is room");
    std::fs::write(folder.path().join("secret.svg"), &square).expect("there is room");
    let agent = Agent::new(&up, &["--files", inside.to_str().expect("it is text")]).await;
    let place = json!({"place": {"pen_down": -40}, "tool": {"laser": "plywood-engrave"}});
    let burning = agent
        .plans(json!({"file": "square.svg", "options": place}))
        .await;
    assert_eq!(burning["burns"], true, "{burning}");
    let draw = json!({"drawing": burning["drawing"]});
    let refused = Agent::refused(agent.call("draw", draw).await, "laser");
    assert!(
        refused["hint"]
            .as_str()
            .expect("a hint")
            .contains("--arm-laser")
    );
    let outside = agent
        .call("plan_drawing", json!({"file": "../secret.svg"}))
        .await;
    Agent::refused(outside, "file");
    let without = Agent::new(&up, &[]).await;
    let none = without
        .call("plan_drawing", json!({"file": "square.svg"}))
        .await;
    Agent::refused(none, "file");
    assert_eq!(up.json(&["jobs"]), json!([]));
}

#[tokio::test(flavor = "multi_thread")]
async fn an_agent_killed_during_a_move_leaves_the_arm_to_others() {
    let up = Up::new(&[]);
    wait_for_state(&up, |state| state["arm"].is_object());
    let mut killed = RunningProcess::with_input(up.command(&["mcp"]));
    killed.write_line(r#"{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"protocolVersion":"2025-06-18","capabilities":{},"clientInfo":{"name":"killed","version":"1"}}}"#);
    killed.wait_for_line("serverInfo");
    killed.write_line(r#"{"jsonrpc":"2.0","method":"notifications/initialized"}"#);
    killed.write_line(r#"{"jsonrpc":"2.0","id":2,"method":"tools/call","params":{"name":"move_to","arguments":{"x_mm":220,"y_mm":0,"z_mm":20,"pause_s":600}}}"#);
    let other = Agent::new(&up, &[]).await;
    let control = async || Agent::done(other.call("look", json!({})).await)["control"].clone();
    wait_for_state(&up, |state| state["lease"].is_object());
    assert_eq!(control().await["name"], "agent killed");
    killed.kill();
    wait_for_state(&up, |state| state["lease"].is_null());
    assert_eq!(control().await, Value::Null);
}

#[tokio::test(flavor = "multi_thread")]
async fn without_a_station_every_tool_explains_how_to_start_one() {
    let child = TokioChildProcess::new(tokio::process::Command::from(command(&["mcp"])));
    let agent = Agent(
        ().serve(child.expect("it starts"))
            .await
            .expect("it greets"),
    );
    for tool in ["look", "stop"] {
        let refused = Agent::refused(agent.call(tool, json!({})).await, "no-station");
        assert!(
            refused["hint"]
                .as_str()
                .expect("a hint")
                .contains("dobot up"),
            "{refused}"
        );
    }
}
