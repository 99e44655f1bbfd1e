//! The interface between a station and the host of its virtual arms.

use std::sync::Arc;

use dobot_api::problem_kinds::ENDING;
use dobot_api::{GivenArm, GivenArms, Member, Problem};
use tokio::sync::{mpsc, oneshot};

/// The station's requests to the host of virtual arms.
#[derive(Clone, Debug)]
pub struct ArmsPort(mpsc::Sender<ArmCommand>);

/// A request to the host of virtual arms.
#[derive(Debug)]
pub enum ArmCommand {
    /// List the arms.
    List(oneshot::Sender<GivenArms>),
    /// Start an arm.
    Give(ArmSelection, oneshot::Sender<Result<GivenArm, Problem>>),
    /// End the arm of this name.
    End(String, oneshot::Sender<Result<(), Problem>>),
}

/// A request for a virtual arm.
#[derive(Debug)]
pub struct ArmSelection {
    /// Its name in the fleet.
    pub name: String,
    /// The station of the fleet that already has this name.
    pub seen: Option<Arc<Member>>,
}

impl ArmsPort {
    /// Returns both ends.
    #[must_use]
    pub fn new() -> (Self, mpsc::Receiver<ArmCommand>) {
        // Each requester waits for its reply.
        let (wishes, wished) = mpsc::channel(64);
        (Self(wishes), wished)
    }

    /// Sends a request, and waits for the reply.
    ///
    /// # Errors
    ///
    /// [`ENDING`] if no arms are hosted any more.
    pub async fn wish<T>(
        &self,
        wish: impl FnOnce(oneshot::Sender<T>) -> ArmCommand,
    ) -> Result<T, Problem> {
        let ending =
            || ENDING.problem("the station hosts no virtual arms any more, because it is ending");
        let (reply, answer) = oneshot::channel();
        let sent = self.0.send(wish(reply)).await;
        sent.map_err(|_| ending())?;
        answer.await.map_err(|_| ending())
    }
}
