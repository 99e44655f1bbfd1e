//! The action `follow_joint_trajectory`: its goals, results and cancellations.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use dobot_api::State;
use futures_util::FutureExt;
use ros2_client::action::{
    AsyncActionServer, CancelHandle, ExecutingGoalHandle, GoalEndStatus, GoalId, NewGoalHandle,
};
use ros2_client::builtin_interfaces::Time;
use tokio::sync::{mpsc, watch};
use tokio::time::timeout;

use crate::actions::{Followed, Stand, ended, follow, take_at_rest};
use crate::follow_plan::FollowPlan;
use crate::goal::{Fault, Wanted};
use crate::joints::{JOINTS, degrees_of};
use crate::log::Log;
use crate::messages::{
    FollowFeedback, FollowGoal, FollowResult, Header, JointTrajectoryPoint, MultiDofPoint,
};
use crate::station::Station;

/// The server of the action.
pub(crate) type Server = AsyncActionServer<FollowGoal, FollowResult, FollowFeedback>;

/// Runs trajectories, one at a time: others do not get control.
pub(crate) struct Goals {
    pub(crate) server: Server,
    pub(crate) station: Station,
    pub(crate) log: Arc<Log>,
    pub(crate) deviation_deg: f64,
    /// The channels that cancel the running goals.
    pub(crate) running: Mutex<BTreeMap<GoalId, watch::Sender<bool>>>,
    /// Result requests are received one after the other.
    pub(crate) results: tokio::sync::Mutex<()>,
}

impl Goals {
    /// Accepts goals until the shutdown; then all of them are cancelled.
    pub(crate) async fn run(
        self: Arc<Self>,
        mut ending: watch::Receiver<bool>,
        busy: mpsc::Sender<()>,
    ) {
        loop {
            tokio::select! {
                goal = self.server.receive_new_goal() => match goal {
                    Ok(goal) => {
                        let (goals, busy) = (self.clone(), busy.clone());
                        tokio::spawn(async move {
                            goals.take(goal).await;
                            drop(busy);
                        });
                    }
                    Err(error) => self.log.warn(&format!("cannot read a goal: {error:?}")),
                },
                cancel = self.server.receive_cancel_request() => match cancel {
                    Ok(cancel) => self.cancel(&cancel).await,
                    Err(error) => self.log.warn(&format!("cannot read a cancel request: {error:?}")),
                },
                () = ended(&mut ending) => break,
            }
        }
        for goal in self.running().values() {
            goal.send_replace(true);
        }
    }

    async fn cancel(&self, request: &CancelHandle) {
        let goals: Vec<GoalId> = request.goals().collect();
        let answered = self
            .server
            .respond_to_cancel_requests(request, goals.iter().copied());
        if let Err(error) = answered.await {
            self.log
                .warn(&format!("cannot answer a cancel request: {error:?}"));
        }
        let running = self.running();
        for goal in goals {
            if let Some(cancel) = running.get(&goal) {
                cancel.send_replace(true);
            }
        }
    }

    /// Accepts a goal. An invalid goal is accepted too and aborted immediately, since a rejection
    /// has no text.
    async fn take(&self, new: NewGoalHandle<FollowGoal>) {
        let Some(goal) = self.server.get_new_goal(new.clone()) else {
            return;
        };
        let id = new.goal_id();
        let cancel = watch::Sender::new(false);
        let mut cancelled = cancel.subscribe();
        self.running().insert(id, cancel);
        let executing = async {
            let accepted = self.server.accept_goal(new).await?;
            self.server.start_executing_goal(accepted).await
        };
        match executing.await {
            Ok(executing) => {
                let followed = self.follow(&goal, &executing, &mut cancelled).await;
                self.answer(executing, followed).await;
            }
            Err(error) => self.log.warn(&format!("cannot accept a goal: {error:?}")),
        }
        self.running().remove(&id);
    }

    async fn follow(
        &self,
        goal: &FollowGoal,
        executing: &ExecutingGoalHandle<FollowGoal>,
        cancelled: &mut watch::Receiver<bool>,
    ) -> Result<Followed, Fault> {
        let mut station = self
            .station
            .connect("trajectory")
            .await
            .map_err(Fault::invalid)?;
        let stand = take_at_rest(&mut station).await.map_err(Fault::invalid)?;
        let Stand { status, period } = stand;
        let wanted = Wanted::new(goal, degrees_of(&status), Time::now())?;
        let plan = FollowPlan::new(&wanted, &status, period, self.deviation_deg)?;
        self.log
            .info(&format!("follow_joint_trajectory: {}", plan.summary));
        let see = |state: &State, at_s: f64| {
            if let Some(arm) = &state.arm {
                let feedback = feedback(&wanted, degrees_of(&arm.status), at_s);
                // Not awaited: a lost feedback is followed by the next one.
                let _ = self
                    .server
                    .publish_feedback(executing.clone(), feedback)
                    .now_or_never();
            }
        };
        follow(&mut station, &wanted, plan, cancelled, see).await
    }

    /// Sends the result to a client that requests it within a timeout.
    async fn answer(
        &self,
        executing: ExecutingGoalHandle<FollowGoal>,
        followed: Result<Followed, Fault>,
    ) {
        let (status, result) = match followed {
            Ok(Followed::Done(text)) => (GoalEndStatus::Succeeded, Ok(text)),
            Ok(Followed::Held(text)) => (GoalEndStatus::Canceled, Ok(text)),
            Err(fault) => (GoalEndStatus::Aborted, Err(fault)),
        };
        let text = result.clone().map_err(|error| error.text);
        self.log.outcome("follow_joint_trajectory", &text);
        let _one = self.results.lock().await;
        let sent = self
            .server
            .send_result_response(executing, status, result.into());
        match timeout(ASKED, sent).await {
            Ok(Ok(())) => {}
            Ok(Err(error)) => self.log.warn(&format!("cannot send a result: {error:?}")),
            Err(_) => self
                .log
                .warn("no client requested the result of a trajectory"),
        }
    }

    fn running(&self) -> std::sync::MutexGuard<'_, BTreeMap<GoalId, watch::Sender<bool>>> {
        self.running.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Returns the desired and actual positions of the joints at a time.
fn feedback(wanted: &Wanted, actual_deg: [f64; 4], at_s: f64) -> FollowFeedback {
    let desired_deg = wanted.at(at_s);
    let error_deg: [f64; 4] = std::array::from_fn(|joint| desired_deg[joint] - actual_deg[joint]);
    let point = |deg: [f64; 4]| JointTrajectoryPoint::at(deg.map(f64::to_radians), at_s);
    FollowFeedback {
        header: Header::now(""),
        joint_names: JOINTS.map(str::to_owned).to_vec(),
        desired: point(desired_deg),
        actual: point(actual_deg),
        error: point(error_deg),
        multi_dof_joint_names: Vec::new(),
        multi_dof_desired: MultiDofPoint::empty(),
        multi_dof_actual: MultiDofPoint::empty(),
        multi_dof_error: MultiDofPoint::empty(),
    }
}

/// The time for which a result is kept.
const ASKED: Duration = Duration::from_secs(10);
