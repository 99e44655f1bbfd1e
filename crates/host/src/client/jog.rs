//! Jogs of a given duration.

use std::time::Duration;

use dobot_api::{ArmView, Jog, News, RemoteError, Request, StationEvent};
use dobot_wire::Status;

use super::{NoArm, StationClient};

/// The end of a [jog](StationClient::jog_for).
#[derive(Clone, Debug)]
pub struct JogEnd {
    /// The arm at rest.
    pub arm: ArmView,
    /// Whether a status showed that the arm moved.
    pub has_moved: bool,
}

impl StationClient {
    /// Holds a jog button until the arm has moved for this time, but at least until a status shows the motion,
    /// releases it, and waits until the arm is at rest. The client must have control. If no status shows motion
    /// within a second, or `cancelled` ends, the button is released; the station releases it if this call is
    /// dropped.
    ///
    /// # Errors
    ///
    /// [`RemoteError::Refused`] if the jog is refused, [`RemoteError::Failed`] if it was never sent to the arm,
    /// otherwise as [`rest`](Self::rest).
    pub async fn jog_for(
        &mut self,
        jog: Jog,
        time: Duration,
        cancelled: impl Future<Output = ()>,
    ) -> Result<JogEnd, NoArm> {
        let before = self.rest().await?.status;
        self.request_at_rest(Request::Jog { jog }).await?;
        let mut has_moved = false;
        let held = tokio::select! {
            held = self.hold(jog, time, &before, &mut has_moved) => held,
            () = cancelled => Ok(()),
        };
        let released = self.request(Request::Release).await;
        held.and(released.map(drop))?;
        self.end_jog(&before, has_moved).await
    }

    /// Repeats the request of a held button until its time is over.
    async fn hold(
        &mut self,
        jog: Jog,
        time: Duration,
        before: &Status,
        has_moved: &mut bool,
    ) -> Result<(), RemoteError> {
        let pressed = self.now();
        let mut beat = pressed + BEAT;
        let mut until = pressed + STARTS_WITHIN;
        while self.now() < until {
            let left = beat.min(until).saturating_sub(self.now());
            let event = self.next_within(left).await?;
            if !*has_moved && event.is_some_and(|event| shows_motion(&event, before)) {
                *has_moved = true;
                // Press and release take equally long to the arm, unless the press had to wait.
                until = pressed.max(self.now().saturating_sub(RESPONSE)) + time;
            }
            if self.now() >= beat && self.now() < until {
                self.request(Request::Jog { jog }).await?;
                beat = self.now() + BEAT;
            }
        }
        Ok(())
    }

    /// Waits until the arm is at rest after a released button.
    async fn end_jog(&mut self, before: &Status, has_moved: bool) -> Result<JogEnd, NoArm> {
        let id = self.id();
        let mut refusal = None;
        let arm = self.rest_with_events(|event| {
            if let StationEvent::Notice(notice) = event
                && matches!(notice.news, News::Refused { client, .. } if client == id)
            {
                refusal = Some(notice.text.clone());
            }
        });
        let arm = arm.await?;
        let has_moved = has_moved || arm.status != *before;
        match refusal {
            Some(text) if !has_moved => Err(RemoteError::Failed(text).into()),
            _ => Ok(JogEnd { arm, has_moved }),
        }
    }
}

/// Returns whether a state shows that the arm has moved.
fn shows_motion(event: &StationEvent, before: &Status) -> bool {
    let StationEvent::State(state) = event else {
        return false;
    };
    let arm = state.arm.as_ref();
    arm.is_some_and(|arm| arm.status != *before)
}

/// The period of the requests that hold a button: a third of the time after which a station releases it.
const BEAT: Duration = Duration::from_millis(50);
/// The longest time from a press that is sent immediately to the status that shows its motion: two packets on
/// the line, a tick and a status period (note N26), and some margin.
const RESPONSE: Duration = Duration::from_millis(200);
/// The time within which a status has to show motion.
const STARTS_WITHIN: Duration = Duration::from_secs(1);
