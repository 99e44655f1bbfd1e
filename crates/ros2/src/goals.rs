//! Action servers: goals, results and cancellations.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use ros2_client::Message;
use ros2_client::action::{
    AsyncActionServer, CancelHandle, ExecutingGoalHandle, GoalEndStatus, GoalId, NewGoalHandle,
};
use tokio::sync::{mpsc, watch};
use tokio::time::timeout;

use crate::actions::ended;
use crate::log::Log;

/// What an action does with a goal.
pub(crate) trait Action: Send + Sync + Sized + 'static {
    type Goal: Message + Clone + Send + Sync + 'static;
    type Result: Message + Clone + Send + Sync + 'static;
    type Feedback: Message + Send + Sync + 'static;
    /// Its name for people.
    const NAME: &str;

    /// Carries out a goal until it is done or cancelled.
    fn carry_out(
        &self,
        goal: &Self::Goal,
        executing: &ExecutingGoalHandle<Self::Goal>,
        server: &Server<Self>,
        cancelled: watch::Receiver<bool>,
    ) -> impl Future<Output = Outcome<Self::Result>> + Send;
}

/// The server of an action.
pub(crate) type Server<A> =
    AsyncActionServer<<A as Action>::Goal, <A as Action>::Result, <A as Action>::Feedback>;

/// The end of a goal.
pub(crate) struct Outcome<R> {
    pub(crate) status: GoalEndStatus,
    pub(crate) result: R,
    /// The message for the log.
    pub(crate) text: Result<String, String>,
}

/// Carries out the goals of an action, one at a time: others do not get control.
pub(crate) struct Goals<A: Action> {
    action: A,
    server: Server<A>,
    log: Arc<Log>,
    /// The channels that cancel the running goals.
    running: Mutex<BTreeMap<GoalId, watch::Sender<bool>>>,
    /// Result requests are received one after the other.
    results: tokio::sync::Mutex<()>,
}

impl<A: Action> Goals<A> {
    pub(crate) fn new(action: A, server: Server<A>, log: Arc<Log>) -> Arc<Self> {
        Arc::new(Self {
            action,
            server,
            log,
            running: Mutex::default(),
            results: tokio::sync::Mutex::default(),
        })
    }

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
                            goals.handle_goal(goal).await;
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
    async fn handle_goal(&self, new: NewGoalHandle<A::Goal>) {
        let Some(goal) = self.server.get_new_goal(new.clone()) else {
            return;
        };
        let id = new.goal_id();
        let cancel = watch::Sender::new(false);
        let cancelled = cancel.subscribe();
        self.running().insert(id, cancel);
        let executing = async {
            let accepted = self.server.accept_goal(new).await?;
            self.server.start_executing_goal(accepted).await
        };
        match executing.await {
            Ok(executing) => {
                let carried_out = self
                    .action
                    .carry_out(&goal, &executing, &self.server, cancelled);
                let outcome = carried_out.await;
                self.answer(executing, outcome).await;
            }
            Err(error) => self.log.warn(&format!("cannot accept a goal: {error:?}")),
        }
        self.running().remove(&id);
    }

    /// Sends the result to a client that requests it within a timeout.
    async fn answer(&self, executing: ExecutingGoalHandle<A::Goal>, outcome: Outcome<A::Result>) {
        let Outcome {
            status,
            result,
            text,
        } = outcome;
        self.log.outcome(A::NAME, &text);
        let _one = self.results.lock().await;
        let sent = self.server.send_result_response(executing, status, result);
        match timeout(ASKED, sent).await {
            Ok(Ok(())) => {}
            Ok(Err(error)) => self.log.warn(&format!("cannot send a result: {error:?}")),
            Err(_) => self
                .log
                .warn(&format!("no client requested the result of {}", A::NAME)),
        }
    }

    fn running(&self) -> std::sync::MutexGuard<'_, BTreeMap<GoalId, watch::Sender<bool>>> {
        self.running.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The time for which a result is kept.
const ASKED: Duration = Duration::from_secs(10);
