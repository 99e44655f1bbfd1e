//! The way between a station and what gives virtual arms to those without one.

use std::sync::Arc;

use dobot_api::problem_kinds::ENDING;
use dobot_api::{GivenArm, GivenArms, Member, Problem};
use tokio::sync::{mpsc, oneshot};

/// What the station asks of what gives virtual arms.
#[derive(Clone, Debug)]
pub struct ArmsPort(mpsc::Sender<ArmWish>);

/// What is wanted of what gives virtual arms.
#[derive(Debug)]
pub enum ArmWish {
    /// To know those that are given.
    List(oneshot::Sender<GivenArms>),
    /// To be given one.
    Give(ArmSelection, oneshot::Sender<Result<GivenArm, Problem>>),
    /// That the one of this name ends.
    End(String, oneshot::Sender<Result<(), Problem>>),
}

/// A virtual arm that somebody wants.
#[derive(Debug)]
pub struct ArmSelection {
    /// What it is to be called in the fleet.
    pub name: String,
    /// The station of the fleet that is called so already.
    pub seen: Option<Arc<Member>>,
}

impl ArmsPort {
    /// The two ends.
    #[must_use]
    pub fn new() -> (Self, mpsc::Receiver<ArmWish>) {
        // Each one who asks waits for its answer.
        let (wishes, wished) = mpsc::channel(64);
        (Self(wishes), wished)
    }

    /// Wants something, and waits for what comes of it.
    ///
    /// # Errors
    ///
    /// [`ENDING`] where no arms are given any more.
    pub async fn wish<T>(
        &self,
        wish: impl FnOnce(oneshot::Sender<T>) -> ArmWish,
    ) -> Result<T, Problem> {
        let ending = || ENDING.problem("the station gives no virtual arms any more: it ends");
        let (reply, answer) = oneshot::channel();
        let sent = self.0.send(wish(reply)).await;
        sent.map_err(|_| ending())?;
        answer.await.map_err(|_| ending())
    }
}
