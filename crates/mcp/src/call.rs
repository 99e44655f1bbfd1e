//! One call of a tool: its own connection to the station, and the stop on cancellation.

use std::sync::Arc;
use std::time::Duration;

use dobot_api::{Reply, Request, Role, State, StationAddress, fetch};
use dobot_host::{StationClient, Target, TargetPlace};
use dobot_supervisor::is_plain;
use rmcp::RoleServer;
use rmcp::model::{CallToolResult, ProgressNotificationParam};
use rmcp::service::RequestContext;
use serde::Serialize;
use serde_json::{Value, json};
use tokio::sync::watch;

use crate::Settings;
use crate::consent::Questions;
use crate::drawings::Drawings;
use crate::http::Visit;
use crate::own_jobs::OwnJobs;
use crate::refused::Refused;

/// State shared by all calls.
#[derive(Debug)]
pub(crate) struct Shared {
    pub(crate) settings: Settings,
    pub(crate) drawings: Drawings,
    pub(crate) own_jobs: OwnJobs,
    /// Whether the agent is gone.
    pub(crate) gone: watch::Sender<bool>,
}

/// One call of a tool.
pub(crate) struct Call {
    pub(crate) shared: Arc<Shared>,
    pub(crate) context: RequestContext<RoleServer>,
    pub(crate) questions: Questions,
}

impl Call {
    pub(crate) const fn new(
        shared: Arc<Shared>,
        context: RequestContext<RoleServer>,
        questions: Questions,
    ) -> Self {
        Self {
            shared,
            context,
            questions,
        }
    }

    /// Returns the station; an agent over HTTP is identified by its own token.
    pub(crate) async fn station(&self) -> Result<StationAddress, Refused> {
        let mut station = self.shared.settings.station().await?;
        if let Some(visit) = self.visit() {
            station.token.clone_from(&visit.token);
        }
        Ok(station)
    }

    fn visit(&self) -> Option<&Visit> {
        Visit::of(&self.context.extensions)
    }

    /// Opens a connection to the station that ends with the call.
    pub(crate) async fn connect(&self) -> Result<StationClient, Refused> {
        let address = self.station().await?;
        Ok(StationClient::connect(&address, &self.name()).await?)
    }

    pub(crate) async fn state(&self) -> Result<State, Refused> {
        Ok(fetch(&self.station().await?, "/api/v1/state").await?)
    }

    /// Runs a call that moves the arm; if the call is cancelled or its agent is gone, the arm is
    /// stopped.
    pub(crate) async fn moving<T>(
        &self,
        act: impl Future<Output = Result<T, Refused>>,
    ) -> Result<T, Refused> {
        tokio::select! {
            biased;
            () = self.given_up() => {}
            done = act => return done,
        }
        self.stop(Some("the agent cancelled its request".to_owned()))
            .await?;
        Err(Refused::new(
            "given-up",
            "the agent cancelled the call; the arm is stopped",
        ))
    }

    /// Runs a call that moves nothing, until it is cancelled.
    pub(crate) async fn looking<T>(
        &self,
        act: impl Future<Output = Result<T, Refused>>,
    ) -> Result<T, Refused> {
        tokio::select! {
            biased;
            () = self.given_up() => Err(Refused::new("given-up", "the agent cancelled the call")),
            done = act => done,
        }
    }

    async fn given_up(&self) {
        let mut gone = self.shared.gone.subscribe();
        let left = async {
            match self.visit() {
                Some(visit) => visit.is_over().await,
                None => std::future::pending().await,
            }
        };
        tokio::select! {
            () = self.context.ct.cancelled() => {}
            _ = gone.wait_for(|gone| *gone) => {}
            () = left => {}
        }
    }

    pub(crate) async fn stop(&self, reason: Option<String>) -> Result<f64, Refused> {
        match self
            .connect()
            .await?
            .request(Request::Stop { reason })
            .await?
        {
            Reply::Stopping {
                delivered: false, ..
            } => Err(Refused::new(
                "not-delivered",
                "the stop was NOT DELIVERED: there is no link to the arm",
            )
            .hinted("ask the person at the arm to switch it off immediately")),
            Reply::Stopping { rests_within_s, .. } => Ok(rests_within_s),
            _ => Ok(0.0),
        }
    }

    /// Whether a person has to start the jobs of this client.
    pub(crate) fn asks(&self, station: &StationClient) -> bool {
        // Over HTTP the token decides; without a token an agent can only queue jobs.
        let asks = match Visit::of(&self.context.extensions) {
            Some(visit) => visit.token.is_none(),
            None => self.shared.settings.asks,
        };
        asks || station.role() == Role::Queue
    }

    /// Returns the command for a target, from the current state.
    pub(crate) fn command(target: &Target, state: &State) -> Result<dobot_wire::Command, Refused> {
        let arm = state.arm.as_ref().ok_or_else(no_arm)?;
        Ok(target.command(&arm.status))
    }

    /// Moves to a target, and returns the state at rest.
    pub(crate) async fn carry_out(&self, target: &Target) -> Result<Value, Refused> {
        let mut station = self.connect().await?;
        self.check_may_move(&station, &target_text(target)).await?;
        let command = Self::command(target, &self.state().await?)?;
        station.request(Request::TakeLease).await?;
        let reply = station
            .request_at_rest(Request::Command { command })
            .await?;
        if let Reply::Accepted { command, .. } = reply {
            station.finished(command).await?;
        }
        let state = self.state().await?;
        Ok(json!({ "arm": state.arm }))
    }

    /// Reports the progress of this call, if its agent asked for that.
    pub(crate) async fn report_progress(&self, completed: usize, commands: usize, title: &str) {
        let Some(token) = self.context.meta.get_progress_token() else {
            return;
        };
        #[expect(
            clippy::cast_precision_loss,
            reason = "a job has at most a million commands"
        )]
        let [progress, total] = [completed, commands].map(|count| count as f64);
        let report = ProgressNotificationParam::new(token, progress)
            .with_total(total)
            .with_message(title);
        // An agent that is gone is noticed by the call.
        let _ = self.context.peer.notify_progress(report).await;
    }

    /// Returns the agent's name for others.
    pub(crate) fn name(&self) -> String {
        let info = self.context.client_info();
        let name = info.map_or_else(String::new, |info| info.name);
        let name: String = name
            .chars()
            .filter(|character| is_plain(*character))
            .take(50)
            .collect();
        format!("agent {name}").trim_end().to_owned()
    }
}

/// Returns a motion for a question to a person.
fn target_text(target: &Target) -> String {
    match target.place {
        TargetPlace::Point { mm: [x, y, z], .. } => {
            format!("move the arm to x {x}, y {y}, z {z} mm")
        }
        TargetPlace::Joints([base, rear, fore]) => {
            format!("turn the arm to base {base}, rear arm {rear}, forearm {fore} degrees")
        }
    }
}

/// Checks a waiting time.
pub(crate) fn wait(wait_s: f64) -> Result<Duration, Refused> {
    if (0.0..=3600.0).contains(&wait_s) {
        return Ok(Duration::from_secs_f64(wait_s));
    }
    let detail = format!("wait_s is {wait_s}; allowed are 0 to 3600 seconds");
    Err(Refused::new("out-of-range", detail))
}

/// Returns the result of a call.
pub(crate) fn result(done: Result<impl Serialize, Refused>) -> CallToolResult {
    match done {
        Ok(answer) => CallToolResult::structured(json!(answer)),
        Err(refused) => refused.result(),
    }
}

pub(crate) fn no_arm() -> Refused {
    Refused::new("no-link", "the station has no connection to an arm").hinted(
        "check that the arm is switched on and plugged in; `look` shows the state of the link",
    )
}
