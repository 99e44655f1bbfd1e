//! The tools of an agent.

use std::sync::Arc;

use dobot_api::{JobView, LinkPhase, Reply, Request, Role, State, fetch};
use rmcp::model::{
    CallToolRequestParams, CallToolResponse, CallToolResult, GetPromptRequestParams,
    GetPromptResponse, Implementation, JsonObject, ListPromptsResult, ListResourcesResult,
    ListToolsResult, PaginatedRequestParams, ReadResourceRequestParams, ReadResourceResponse,
    ReadResourceResult, ServerCapabilities, ServerConfig, Tool,
};
use rmcp::service::RequestContext;
use rmcp::{ErrorData, RoleServer, ServerHandler};
use serde_json::{Value, json};
use tokio::sync::watch;

use crate::Settings;
use crate::arguments::{
    ChangeJob, CheckMove, JobAction, Nothing, StopArguments, ToJoints, ToPoint, read,
};
use crate::call::{Call, Shared, result};
use crate::consent::Questions;
use crate::drawings::Drawings;
use crate::own_jobs::OwnJobs;
use crate::refused::Refused;
use crate::tools::{TOOLS, ToolRow};
use crate::{prompts, resources};

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

    fn call(&self, context: RequestContext<RoleServer>, questions: Questions) -> Call {
        Call::new(self.shared.clone(), context, questions)
    }
}

impl ServerHandler for Agents {
    fn get_info(&self) -> ServerConfig {
        let version = env!("CARGO_PKG_VERSION");
        let capabilities = ServerCapabilities::builder()
            .enable_prompts()
            .enable_resources()
            .enable_tools()
            .build();
        ServerConfig::new(capabilities)
            .with_server_info(Implementation::new("dobot", version))
            .with_instructions(INSTRUCTIONS)
    }

    async fn list_tools(
        &self,
        _: Option<PaginatedRequestParams>,
        _: RequestContext<RoleServer>,
    ) -> Result<ListToolsResult, ErrorData> {
        let tools = TOOLS.iter().map(ToolRow::tool).collect();
        Ok(ListToolsResult::with_all_items(tools))
    }

    fn get_tool(&self, name: &str) -> Option<Tool> {
        let row = TOOLS.iter().find(|row| row.name == name);
        row.map(ToolRow::tool)
    }

    async fn call_tool(
        &self,
        request: CallToolRequestParams,
        context: RequestContext<RoleServer>,
    ) -> Result<CallToolResponse, ErrorData> {
        let call = self.call(context, Questions::new(&request));
        let arguments = request.arguments.unwrap_or_default();
        let done = Box::pin(run(&call, &request.name, arguments)).await;
        let unknown = || {
            let names: Vec<&str> = TOOLS.iter().map(|row| row.name).collect();
            let names = names.join(", ");
            let text = format!("there is no tool `{}`; there are {names}", request.name);
            ErrorData::invalid_params(text, None)
        };
        if let Some(question) = call.questions.to_ask() {
            return Ok(question.into());
        }
        done.map(CallToolResponse::from).ok_or_else(unknown)
    }

    async fn list_resources(
        &self,
        _: Option<PaginatedRequestParams>,
        _: RequestContext<RoleServer>,
    ) -> Result<ListResourcesResult, ErrorData> {
        Ok(ListResourcesResult::with_all_items(resources::list()))
    }

    async fn read_resource(
        &self,
        request: ReadResourceRequestParams,
        context: RequestContext<RoleServer>,
    ) -> Result<ReadResourceResponse, ErrorData> {
        let call = self.call(context, Questions::default());
        let contents = resources::read(&call, &request.uri).await?;
        Ok(ReadResourceResult::new(vec![contents]).into())
    }

    async fn list_prompts(
        &self,
        _: Option<PaginatedRequestParams>,
        _: RequestContext<RoleServer>,
    ) -> Result<ListPromptsResult, ErrorData> {
        Ok(ListPromptsResult::with_all_items(prompts::list()))
    }

    async fn get_prompt(
        &self,
        request: GetPromptRequestParams,
        _: RequestContext<RoleServer>,
    ) -> Result<GetPromptResponse, ErrorData> {
        prompts::get(&request).map(Into::into)
    }
}

/// Runs a tool; `None` if there is none of this name.
async fn run(call: &Call, name: &str, arguments: JsonObject) -> Option<CallToolResult> {
    Some(match name {
        "look" => {
            let looked = async {
                read(arguments).map(|Nothing {}| ())?;
                look(call).await
            };
            result(call.looking(looked).await)
        }
        "check_move" => result(call.looking(check_move(call, arguments)).await),
        "move_to" => {
            let moved = async { call.carry_out(&read::<ToPoint>(arguments)?.target()?).await };
            result(call.moving(moved).await)
        }
        "move_joints" => {
            let moved = async {
                call.carry_out(&read::<ToJoints>(arguments)?.target()?)
                    .await
            };
            result(call.moving(moved).await)
        }
        "plan_drawing" => {
            let planned = call.looking(async { call.plan_drawing(read(arguments)?).await });
            Box::pin(planned)
                .await
                .unwrap_or_else(|error| error.result())
        }
        "draw" => {
            let drawn = async { call.draw(&read(arguments)?).await };
            result(call.moving(drawn).await)
        }
        "check_program" => {
            let checked = async { call.check_program(read(arguments)?).await };
            result(call.looking(checked).await)
        }
        "run_program" => {
            let done = async { call.run_program(read(arguments)?).await };
            result(call.moving(done).await)
        }
        "jobs" => {
            let jobs = async { call.jobs(read(arguments)?).await };
            result(call.looking(jobs).await)
        }
        "change_job" => match read::<ChangeJob>(arguments) {
            Err(refused) => refused.result(),
            Ok(change) => result(match change.action {
                JobAction::Resume => call.moving(call.resume_job(&change)).await,
                JobAction::Pause | JobAction::Cancel => call.end_job(&change).await,
            }),
        },
        "answer_job" => {
            let answered = async { call.answer_job(read(arguments)?).await };
            result(call.moving(answered).await)
        }
        "stop" => {
            // A stop is not refused because of its arguments.
            let arguments = read::<StopArguments>(arguments).ok();
            let stopped = call.stop(arguments.and_then(|stop| stop.reason)).await;
            result(stopped.map(|within_s| json!({ "rests_within_s": within_s })))
        }
        _ => return None,
    })
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

const INSTRUCTIONS: &str = "A small robot arm on a desk, with people near it. Lengths are millimetres in the base frame (x forward, y left, \
    z up from the rear arm's pivot), angles degrees, times seconds. Call `look` first. Plan a drawing and check its picture before \
    drawing it. A refusal contains the rule, the position and a hint; do not repeat the same call. When in doubt, `stop`; a person resets \
    the stop. The laser is reserved for people.";
