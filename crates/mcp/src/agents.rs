//! The tools of an agent.

use std::sync::Arc;

use dobot_api::{JobView, LinkPhase, Reply, Request, Role, State, fetch};
use rmcp::handler::server::tool::schema_for_input;
use rmcp::model::{CallToolResult, Implementation, JsonObject, ServerCapabilities, ServerConfig};
use rmcp::service::RequestContext;
use rmcp::{RoleServer, ServerHandler, tool, tool_handler, tool_router};
use schemars::JsonSchema;
use serde_json::{Value, json};
use tokio::sync::watch;

use crate::Settings;
use crate::arguments::{
    AnswerJob, ChangeJob, CheckMove, JobAction, NewDrawing, Nothing, PlannedDrawing,
    ProgramArguments, RunProgram, StopArguments, ToJoints, ToPoint, WhichJobs, read,
};
use crate::call::{Call, Shared, result};
use crate::drawings::Drawings;
use crate::own_jobs::OwnJobs;
use crate::refused::Refused;

/// The tools with which an agent uses the arm of a station.
#[derive(Clone, Debug)]
pub struct Agents {
    shared: Arc<Shared>,
}

impl Agents {
    /// Returns tools with these settings.
    #[must_use]
    pub fn new(settings: Settings) -> Self {
        Self {
            shared: Arc::new(Shared {
                settings,
                drawings: Drawings::default(),
                own_jobs: OwnJobs::default(),
                gone: watch::Sender::new(false),
            }),
        }
    }

    /// Returns the channel that reports that the agent is gone.
    pub(crate) fn gone(&self) -> watch::Sender<bool> {
        self.shared.gone.clone()
    }

    fn call(&self, context: RequestContext<RoleServer>) -> Call {
        Call::new(self.shared.clone(), context)
    }
}

#[tool_router]
impl Agents {
    #[tool(
        description = "Returns the state of the arm: pose, lease holder, unfinished jobs, and the reasons why it cannot move (`alarms`).",
        input_schema = schema::<Nothing>(),
        annotations(read_only_hint = true)
    )]
    async fn look(
        &self,
        arguments: JsonObject,
        context: RequestContext<RoleServer>,
    ) -> CallToolResult {
        let call = self.call(context);
        result(
            call.looking(async {
                read(arguments).map(|Nothing {}| ())?;
                look(&call).await
            })
            .await,
        )
    }

    #[tool(
        description = "Checks a move from the current position: returns where it would lead, or the rule that refuses it and the nearest allowed position. Nothing moves.",
        input_schema = schema::<CheckMove>(),
        annotations(read_only_hint = true)
    )]
    async fn check_move(
        &self,
        arguments: JsonObject,
        context: RequestContext<RoleServer>,
    ) -> CallToolResult {
        let call = self.call(context);
        result(call.looking(check_move(&call, arguments)).await)
    }

    #[tool(
        description = "Moves the tool to a point in the base frame (x forward, y left, z up from the rear arm's pivot), and waits until it is at rest.",
        input_schema = schema::<ToPoint>()
    )]
    async fn move_to(
        &self,
        arguments: JsonObject,
        context: RequestContext<RoleServer>,
    ) -> CallToolResult {
        let call = self.call(context);
        result(
            call.moving(async { call.carry_out(&read::<ToPoint>(arguments)?.target()?).await })
                .await,
        )
    }

    #[tool(
        description = "Moves the joints to angles, and waits until the arm is at rest.",
        input_schema = schema::<ToJoints>()
    )]
    async fn move_joints(
        &self,
        arguments: JsonObject,
        context: RequestContext<RoleServer>,
    ) -> CallToolResult {
        let call = self.call(context);
        result(
            call.moving(async {
                call.carry_out(&read::<ToJoints>(arguments)?.target()?)
                    .await
            })
            .await,
        )
    }

    #[tool(
        description = "Plans a drawing and returns a picture, its duration, its warnings and the reason why the arm may not draw it. Nothing moves. Pass the returned number to `draw`. The height of the paper is that of the pen now, or `options.place.pen_down`.",
        input_schema = schema::<NewDrawing>(),
        annotations(read_only_hint = true)
    )]
    async fn plan_drawing(
        &self,
        arguments: JsonObject,
        context: RequestContext<RoleServer>,
    ) -> CallToolResult {
        let call = self.call(context);
        let planned = call.looking(async { call.plan_drawing(read(arguments)?).await });
        let planned = Box::pin(planned).await;
        planned.unwrap_or_else(|error| error.result())
    }

    #[tool(
        description = "Draws a planned drawing with a pen, as a job. If a person has to start jobs, it is only queued. Drawings for the laser are refused.",
        input_schema = schema::<PlannedDrawing>()
    )]
    async fn draw(
        &self,
        arguments: JsonObject,
        context: RequestContext<RoleServer>,
    ) -> CallToolResult {
        let call = self.call(context);
        result(
            call.moving(async { call.draw(&read(arguments)?).await })
                .await,
        )
    }

    #[tool(
        description = "Checks a program: returns its steps, their durations, and all problems. Nothing moves.",
        input_schema = schema::<ProgramArguments>(),
        annotations(read_only_hint = true)
    )]
    async fn check_program(
        &self,
        arguments: JsonObject,
        context: RequestContext<RoleServer>,
    ) -> CallToolResult {
        let call = self.call(context);
        result(
            call.looking(async { call.check_program(read(arguments)?).await })
                .await,
        )
    }

    #[tool(
        description = "Runs a program as a job. If a person has to start jobs, it is only queued.",
        input_schema = schema::<RunProgram>()
    )]
    async fn run_program(
        &self,
        arguments: JsonObject,
        context: RequestContext<RoleServer>,
    ) -> CallToolResult {
        let call = self.call(context);
        result(
            call.moving(async { call.run_program(read(arguments)?).await })
                .await,
        )
    }

    #[tool(
        description = "Returns the jobs and their progress; or one job, when it stops running or the waiting time is over.",
        input_schema = schema::<WhichJobs>(),
        annotations(read_only_hint = true)
    )]
    async fn jobs(
        &self,
        arguments: JsonObject,
        context: RequestContext<RoleServer>,
    ) -> CallToolResult {
        let call = self.call(context);
        result(
            call.looking(async { call.jobs(read(arguments)?).await })
                .await,
        )
    }

    #[tool(
        description = "Pauses, starts or resumes, or cancels a job.",
        input_schema = schema::<ChangeJob>()
    )]
    async fn change_job(
        &self,
        arguments: JsonObject,
        context: RequestContext<RoleServer>,
    ) -> CallToolResult {
        let call = self.call(context);
        let change = match read::<ChangeJob>(arguments) {
            Ok(change) => change,
            Err(refused) => return refused.result(),
        };
        result(match change.action {
            JobAction::Resume => call.moving(call.resume_job(&change)).await,
            JobAction::Pause | JobAction::Cancel => call.end_job(&change).await,
        })
    }

    #[tool(
        description = "Answers the question of a running program that this agent has started (`question` in `jobs`): one of its answers, or the position that it asks for, if the policy allows it. Questions for a person are refused.",
        input_schema = schema::<AnswerJob>()
    )]
    async fn answer_job(
        &self,
        arguments: JsonObject,
        context: RequestContext<RoleServer>,
    ) -> CallToolResult {
        let call = self.call(context);
        result(
            call.moving(async { call.answer_job(read(arguments)?).await })
                .await,
        )
    }

    #[tool(
        description = "Stops the arm, with or without control. It stays stopped until a person has checked it and resets the stop.",
        input_schema = schema::<StopArguments>(),
        annotations(idempotent_hint = true)
    )]
    async fn stop(
        &self,
        arguments: JsonObject,
        context: RequestContext<RoleServer>,
    ) -> CallToolResult {
        let call = self.call(context);
        // A stop is not refused because of its arguments.
        let reason = read::<StopArguments>(arguments)
            .ok()
            .and_then(|arguments| arguments.reason);
        let stopped = call.stop(reason).await;
        result(stopped.map(|within_s| json!({ "rests_within_s": within_s })))
    }
}

#[tool_handler]
impl ServerHandler for Agents {
    fn get_info(&self) -> ServerConfig {
        let version = env!("CARGO_PKG_VERSION");
        ServerConfig::new(ServerCapabilities::builder().enable_tools().build())
            .with_server_info(Implementation::new("dobot", version))
            .with_instructions(INSTRUCTIONS)
    }
}

async fn look(call: &Call) -> Result<Value, Refused> {
    let station = call.station().await?;
    let state: State = fetch(&station, "/api/v1/state").await?;
    let mut jobs: Vec<JobView> = fetch(&station, "/api/v1/jobs").await?;
    jobs.retain(|job| !job.phase.is_over());
    let connected = call.connect().await?;
    let asks = call.asks(&connected);
    let role = if asks {
        connected.role().min(Role::Queue)
    } else {
        connected.role()
    };
    let alarms = alarms(&state);
    Ok(json!({
        "arm": state.arm, "alarms": alarms, "control": state.lease, "job": state.job, "jobs": jobs,
        "laser": state.laser, "link": state.link, "dialect": state.dialect, "role": role,
        "a_person_starts_jobs": asks,
    }))
}

/// Returns the reasons why the arm cannot move, a sentence each.
fn alarms(state: &State) -> Vec<String> {
    let mut alarms = Vec::new();
    if state.link.phase != LinkPhase::Up {
        let why = state.link.problem.as_deref().unwrap_or("it sends nothing");
        alarms.push(format!("the arm is not connected: {why}"));
    }
    if let Some(stop) = &state.stop {
        alarms.push(format!("{}; a person must reset the stop", stop.text()));
    }
    if !state.trust.trusted {
        let why = state
            .trust
            .reason
            .as_deref()
            .unwrap_or("not confirmed by a person");
        alarms.push(format!(
            "the pose of the arm is not trusted: {why}; a person must check and confirm it"
        ));
    }
    if state.laser.armed_for_s > 0.0 {
        alarms.push("the laser is armed".to_owned());
    }
    alarms
}

async fn check_move(call: &Call, arguments: JsonObject) -> Result<Value, Refused> {
    let target = read::<CheckMove>(arguments)?.target()?;
    let command = Call::command(&target, &call.state().await?)?;
    let reply = call
        .connect()
        .await?
        .request(Request::CheckCommand { command })
        .await?;
    match reply {
        Reply::Way { way } => Ok(json!(way)),
        other => Err(Refused::new(
            "no-station",
            format!("the station sent an unexpected response: {other:?}"),
        )),
    }
}

/// Returns the schema of a tool's arguments.
fn schema<T: JsonSchema + 'static>() -> Arc<JsonObject> {
    schema_for_input::<T>().expect("the arguments of a tool are an object")
}

const INSTRUCTIONS: &str = "A small robot arm on a desk, with people near it. Call `look` first. Plan a drawing and check its picture before \
    drawing it. A refusal contains the rule, the position and a hint; do not repeat the same call. When in doubt, `stop`; a person resets \
    the stop. The laser is reserved for people.";
