//! The packets that bring an arm to rest, repeated until it is at rest: a packet can get lost.

use std::time::Duration;

use dobot_motion::LASER_OFF;

use super::arm::Arm;

/// The sequence that brings an arm to rest: laser off, button release, and repetitions.
#[derive(Debug, Default)]
pub(super) struct StopSequence {
    round: Option<Round>,
}

#[derive(Clone, Copy, Debug)]
struct Round {
    next: Duration,
    laser_is_next: bool,
    /// Completed rounds.
    rounds: u32,
    /// Packets that may wait in the arm after the first release, while it slows down.
    waiting: u32,
    /// Whether a status has arrived since the last packet: the arm has room for another.
    received: bool,
    /// Whether the laser was switched off in this sequence; a button release alone does not do
    /// that.
    is_dark: bool,
}

impl Round {
    /// Starts after a laser-off packet; the release is next.
    const fn first(now: Duration) -> Self {
        Self {
            next: now.saturating_add(GAP),
            laser_is_next: false,
            rounds: 0,
            waiting: 0,
            received: true,
            is_dark: true,
        }
    }

    /// Returns the next round, if any.
    fn after(self, arm: &Arm, unknown: Duration) -> Option<Self> {
        let waiting = self.waiting + u32::from(self.rounds > 0);
        let again = if waiting >= MAX_WAITING {
            // One packet more would fill the queue of an arm that received all, and it would fall
            // silent as after a reset.
            arm.rests_within(unknown).max(RETRY_DELAY)
        } else if self.laser_is_next {
            GAP
        } else {
            RETRY_DELAY
        };
        (self.rounds < ROUNDS).then_some(Self {
            next: arm.now() + again,
            laser_is_next: !self.laser_is_next,
            rounds: self.rounds + u32::from(!self.laser_is_next),
            waiting,
            received: false,
            is_dark: self.is_dark || self.laser_is_next,
        })
    }
}

impl StopSequence {
    /// Returns when the next packet is due, unless it waits for a status.
    pub(super) fn next(&self) -> Option<Duration> {
        self.round
            .filter(|round| round.received)
            .map(|round| round.next)
    }

    /// Ends the sequence, because the arm is to move again.
    pub(super) const fn forget(&mut self) {
        self.round = None;
    }

    /// Sends laser off immediately, then releases the last button, if any, until the arm is at
    /// rest. A sequence that is already running, or waits in the arm for its turn, is not
    /// restarted.
    pub(super) fn begin(&mut self, arm: &mut Arm) {
        let waits = arm.session().in_flight() > 0;
        let continues = |round: &Round| round.is_dark && (round.rounds == 0 || waits);
        if self.round.as_ref().is_some_and(continues) {
            return;
        }
        // Earlier urgent packets are repeated in their turn.
        arm.send_first(LASER_OFF);
        self.round = Some(Round::first(arm.now()));
    }

    /// Releases the button sent last; one that was never sent need not be released.
    pub(super) fn release(&mut self, arm: &mut Arm) {
        // The release must not overtake the button itself, which may still wait for the line.
        arm.hasten();
        if !arm.release_urgently() {
            return;
        }
        self.round = Some(Round {
            next: arm.now() + RETRY_DELAY,
            laser_is_next: false,
            rounds: 1,
            waiting: 0,
            received: false,
            is_dark: false,
        });
    }

    /// Repeats the release after a laser-off packet: it may have been lost with the link.
    pub(super) fn release_again(&mut self, arm: &Arm) {
        let release = arm.session().release();
        self.round = release.map(|_| Round::first(arm.now()));
    }

    /// Sends the next packet when due: a stock arm needs a gap between packets and may have missed
    /// one. A repetition waits for a status, so that the arm's queue does not fill up. `unknown` is
    /// the duration of motion that the session does not know of.
    pub(super) fn repeat(&mut self, arm: &mut Arm, is_linked: bool, unknown: Duration) {
        let due = |round: &Round| round.next <= arm.now() && round.received;
        let Some(round) = self.round.filter(due) else {
            return;
        };
        if !is_linked {
            self.round = None;
            return;
        }
        if round.rounds > 0 && arm.session().in_flight() > 0 {
            // The arm executes commands in order: earlier packets wait there for their turn, and
            // more would only fill its queue.
            let next = arm.now() + RETRY_DELAY;
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

    /// Handles a status: at rest, after two rounds, the sequence is over.
    pub(super) fn handle_status(&mut self, rests: bool) {
        if let Some(round) = &mut self.round {
            round.received = true;
        }
        self.round = self.round.filter(|round| !rests || round.rounds < 2);
    }
}

/// Longer than a packet on the line plus the 8 ms that a stock arm needs between two (note N26).
const GAP: Duration = dobot_wire::PACKET_GAP;
/// Long enough for two statuses to show the effect.
const RETRY_DELAY: Duration = Duration::from_millis(240);
/// From the fourth waiting packet on, a stock arm withholds its statuses (note N27).
const MAX_WAITING: u32 = 3;
/// An arm that has not reacted after this many rounds does not receive.
const ROUNDS: u32 = 3;
