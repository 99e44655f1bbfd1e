//! The packets that bring an arm to rest, said until it rests: a packet can get lost.

use std::time::Duration;

use dobot_motion::LASER_OFF;

use super::arm::Arm;

/// An arm that is being brought to rest, if it is: laser off, button released, and so again.
#[derive(Debug, Default)]
pub(super) struct StopSequence {
    round: Option<Round>,
}

#[derive(Clone, Copy, Debug)]
struct Round {
    next: Duration,
    laser_is_next: bool,
    /// Rounds said already.
    rounds: u32,
    /// Packets that may wait in the arm behind the first release, which runs down.
    behind: u32,
    /// A status came since the last packet: the arm has room for another.
    heard: bool,
    /// The laser was switched off in it: a button that is let go of says nothing of the laser.
    is_dark: bool,
}

impl Round {
    /// The laser has just been switched off, and the release is next.
    const fn first(now: Duration) -> Self {
        Self {
            next: now.saturating_add(GAP),
            laser_is_next: false,
            rounds: 0,
            behind: 0,
            heard: true,
            is_dark: true,
        }
    }

    /// What is said behind that, if anything.
    fn after(self, arm: &Arm, unknown: Duration) -> Option<Self> {
        let behind = self.behind + u32::from(self.rounds > 0);
        let again = if behind >= MOST_BEHIND {
            // With one more an arm that heard all would have no room, and be silent as if it was reset.
            arm.rests_within(unknown).max(AGAIN)
        } else if self.laser_is_next {
            GAP
        } else {
            AGAIN
        };
        (self.rounds < ROUNDS).then_some(Self {
            next: arm.now() + again,
            laser_is_next: !self.laser_is_next,
            rounds: self.rounds + u32::from(!self.laser_is_next),
            behind,
            heard: false,
            is_dark: self.is_dark || self.laser_is_next,
        })
    }
}

impl StopSequence {
    /// When it has something to say, unless it waits for a status.
    pub(super) fn next(&self) -> Option<Duration> {
        self.round.filter(|it| it.heard).map(|it| it.next)
    }

    /// There is nothing more to say: the arm is to move again.
    pub(super) const fn forget(&mut self) {
        self.round = None;
    }

    /// Laser off at once; then the release of the button that was sent last, if one was, until the arm
    /// rests. While that goes on already, or waits in the arm for its turn, it need not begin anew.
    pub(super) fn begin(&mut self, arm: &mut Arm) {
        let waits = arm.session().in_flight() > 0;
        let goes_on = |it: &Round| it.is_dark && (it.rounds == 0 || waits);
        if self.round.as_ref().is_some_and(goes_on) {
            return;
        }
        // What was urgent before is said again in its turn.
        arm.send_first(LASER_OFF);
        self.round = Some(Round::first(arm.now()));
    }

    /// Lets go of the button that was sent last; one that was never sent need not be released.
    pub(super) fn release(&mut self, arm: &mut Arm) {
        // The release must not pass the button itself, should that still wait for the line.
        arm.hasten();
        if !arm.release_urgently() {
            return;
        }
        self.round = Some(Round {
            next: arm.now() + AGAIN,
            laser_is_next: false,
            rounds: 1,
            behind: 0,
            heard: false,
            is_dark: false,
        });
    }

    /// Behind a laser that was just switched off: the release of the button that was sent last may have
    /// got lost with the link.
    pub(super) fn release_again(&mut self, arm: &Arm) {
        let release = arm.session().release();
        self.round = release.map(|_| Round::first(arm.now()));
    }

    /// Says it again: a stock arm wants a gap between packets, and may have missed one. What is said
    /// again waits for a status, so that the arm's queue is not filled up with it. How long the arm may
    /// be at what the session does not know of, is `unknown`.
    pub(super) fn repeat(&mut self, arm: &mut Arm, is_linked: bool, unknown: Duration) {
        let due = |it: &Round| it.next <= arm.now() && it.heard;
        let Some(round) = self.round.filter(due) else {
            return;
        };
        if !is_linked {
            self.round = None;
            return;
        }
        if round.rounds > 0 && arm.session().in_flight() > 0 {
            // The arm does one thing after the other: what was said waits there for its turn, and
            // more of the same would only take up its queue.
            let next = arm.now() + AGAIN;
            self.round = Some(Round { next, ..round });
            return;
        }
        if round.laser_is_next {
            arm.send_urgent(LASER_OFF);
        } else {
            arm.release_urgently();
        }
        self.round = round.after(arm, unknown);
    }

    /// With each status: at rest there is nothing more to say, once it has been said twice.
    pub(super) fn handle_status(&mut self, rests: bool) {
        if let Some(round) = &mut self.round {
            round.heard = true;
        }
        self.round = self.round.filter(|it| !rests || it.rounds < 2);
    }
}

/// More than a packet takes on the line, and the 8 ms that a stock arm wants between two (note N26).
const GAP: Duration = dobot_wire::PACKET_GAP;
/// Two statuses may show that it was heard.
const AGAIN: Duration = Duration::from_millis(240);
/// From the fourth packet that waits on a stock arm withholds its statuses (note N27).
const MOST_BEHIND: u32 = 3;
/// An arm that has not heard it by then does not hear.
const ROUNDS: u32 = 3;
