//! The action `follow_joint_trajectory`.

use std::sync::Arc;

use dobot_api::State;
use futures_util::FutureExt;
use ros2_client::action::{ExecutingGoalHandle, GoalEndStatus};
use ros2_client::builtin_interfaces::Time;
use tokio::sync::watch;

use crate::actions::{Followed, Stand, follow, take_at_rest};
use crate::follow_plan::FollowPlan;
use crate::goal::{Fault, Wanted};
use crate::goals::{Action, Outcome, Server};
use crate::joints::{JOINTS, degrees_of};
use crate::log::Log;
use crate::messages::{
    FollowFeedback, FollowGoal, FollowResult, Header, JointTrajectoryPoint, MultiDofPoint,
};
use crate::station::Station;

/// Runs trajectories.
pub(crate) struct FollowAction {
    pub(crate) station: Station,
    pub(crate) log: Arc<Log>,
    pub(crate) deviation_deg: f64,
}

impl Action for FollowAction {
    type Goal = FollowGoal;
    type Result = FollowResult;
    type Feedback = FollowFeedback;
    const NAME: &str = "follow_joint_trajectory";

    async fn carry_out(
        &self,
        goal: &FollowGoal,
        executing: &ExecutingGoalHandle<FollowGoal>,
        server: &Server<Self>,
        mut cancelled: watch::Receiver<bool>,
    ) -> Outcome<FollowResult> {
        let followed = self.follow(goal, executing, server, &mut cancelled).await;
        let (status, result) = match followed {
            Ok(Followed::Done(text)) => (GoalEndStatus::Succeeded, Ok(text)),
            Ok(Followed::Held(text)) => (GoalEndStatus::Canceled, Ok(text)),
            Err(fault) => (GoalEndStatus::Aborted, Err(fault)),
        };
        Outcome {
            status,
            text: result.clone().map_err(|error| error.text),
            result: result.into(),
        }
    }
}

impl FollowAction {
    async fn follow(
        &self,
        goal: &FollowGoal,
        executing: &ExecutingGoalHandle<FollowGoal>,
        server: &Server<Self>,
        cancelled: &mut watch::Receiver<bool>,
    ) -> Result<Followed, Fault> {
        let station = self.station.connect("trajectory").await;
        let mut station = station.map_err(Fault::invalid)?;
        let stand = take_at_rest(&mut station).await.map_err(Fault::invalid)?;
        let Stand { status, dialect } = stand;
        let wanted = Wanted::new(goal, degrees_of(&status), Time::now())?;
        let plan = FollowPlan::new(&wanted, &status, dialect, self.deviation_deg)?;
        self.log.info(&format!("{}: {}", Self::NAME, plan.summary));
        let see = |state: &State, at_s: f64| {
            if let Some(arm) = &state.arm {
                let feedback = feedback(&wanted, degrees_of(&arm.status), at_s);
                // Not awaited: a lost feedback is followed by the next one.
                let published = server.publish_feedback(executing.clone(), feedback);
                let _ = published.now_or_never();
            }
        };
        follow(&mut station, &wanted, plan, cancelled, see).await
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
