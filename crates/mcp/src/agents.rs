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
    ChangeJob, CheckMove, JobAction, NewDrawing, Nothing, PlannedDrawing, ProgramArguments,
    RunProgram, StopArguments, ToJoints, ToPoint, WhichJobs, read,
};
use crate::call::{Call, Shared, result};
use crate::drawings::Drawings;
use crate::own_jobs::OwnJobs;
use crate::refused::Refused;

/// The tools by which an agent uses the arm of a station.
#[derive(Clone, Debug)]
pub struct Agents {
    shared: Arc<Shared>,
}

impl Agents {
    /// Tools with these settings.
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

    /// By what it is told that the agent is gone.
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
        description = "How the arm stands and what it is doing: pose, who has control, the jobs that are not over, and what keeps it from moving (`alarms`).",
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
        description = "Where a move would lead from where the arm stands, or by which rule it would be refused and which place nearby is allowed. Nothing moves.",
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
        description = "Moves the tool to a point in the base frame (x forward, y left, z up from the rear arm's pivot), and waits until it rests there.",
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
        description = "Moves the joints to angles, and waits until the arm rests there.",
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
        description = "Plans a drawing and shows it as a picture, with its time, its warnings and why the arm may not draw it. Nothing moves. The answer's number is what `draw` takes. It is drawn where the pen stands on the paper, or at `options.place.pen_down`.",
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
        description = "Draws what was planned, with a pen: it becomes a job. Where a person has to start jobs, it is queued only. A drawing for the laser is refused.",
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
        description = "Looks at a program: its steps, how long they take, and all that is wrong with it. Nothing moves.",
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
        description = "Runs a program as a job. Where a person has to start jobs, it is queued only.",
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
        description = "The jobs and how far they are; or one of them, when it does not run any more or the time to wait is over.",
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
        description = "Pauses a job, starts it or goes on with it, or ends it for good.",
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
        description = "Stops the arm, whoever has control. It stays stopped until a person has looked at it and resets the stop.",
        input_schema = schema::<StopArguments>(),
        annotations(idempotent_hint = true)
    )]
    async fn stop(
        &self,
        arguments: JsonObject,
        context: RequestContext<RoleServer>,
    ) -> CallToolResult {
        let call = self.call(context);
        // Whatever else was said: a stop is not refused.
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

/// What keeps the arm from moving, a sentence each.
fn alarms(state: &State) -> Vec<String> {
    let mut alarms = Vec::new();
    if state.link.phase != LinkPhase::Up {
        let why = state.link.problem.as_deref().unwrap_or("it tells nothing");
        alarms.push(format!("there is no arm: {why}"));
    }
    if let Some(stop) = &state.stop {
        alarms.push(format!("{}; a person resets that", stop.text()));
    }
    if !state.trust.trusted {
        let why = state.trust.reason.as_deref().unwrap_or("nobody has looked");
        alarms.push(format!(
            "nobody knows where the arm stands: {why}; a person looks and confirms it"
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
            format!("the station answers {other:?}"),
        )),
    }
}

/// The schema of a tool's arguments.
fn schema<T: JsonSchema + 'static>() -> Arc<JsonObject> {
    schema_for_input::<T>().expect("the arguments of a tool are an object")
}

const INSTRUCTIONS: &str = "A small robot arm on a desk, with people beside it. `look` first. Plan a drawing and look at its picture before you \
    draw. Whatever is refused comes with its rule, its place and a hint; do not try the same again. When in doubt, `stop`: a person resets it. \
    The laser is a person's business.";
