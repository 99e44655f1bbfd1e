//! The packets that bring an arm to rest, said until it rests: a packet can get lost.

use std::time::Duration;

use dobot_course::LASER_OFF;

use super::Keeper;
use crate::words::{News, Refusal};

/// An arm that is being brought to rest: laser off, button released, and so again.
#[derive(Clone, Copy, Debug)]
pub(super) struct Halt {
    next: Duration,
    laser_is_next: bool,
    /// Rounds said already.
    rounds: u32,
    /// Packets that may wait in the arm behind the first release, which runs down.
    behind: u32,
    /// A status came since the last packet: the arm has room for another.
    heard: bool,
}

impl Halt {
    /// When it has something to say, unless it waits for a status.
    pub(super) fn next(&self) -> Option<Duration> {
        self.heard.then_some(self.next)
    }
}

impl Keeper {
    /// Takes that the station stood still for so long: what it would have said meanwhile is said now,
    /// as after a fault. Its guardian may have said it, too.
    pub fn handle_stall(&mut self, now: Duration, silent: Duration) {
        self.now = self.now.max(now);
        let why = format!("the station stood still for {:.1} s", silent.as_secs_f64());
        self.send_urgent(LASER_OFF);
        self.at_once = true;
        self.withdraw(Refusal::LetGo(why.clone()));
        self.tell(
            News::Trouble,
            format!("{why}: the laser was switched off and the button let go"),
        );
        self.disarm_laser(&why);
    }

    /// Laser off at once; then the release of the button that was sent last, if one was, until the arm
    /// rests. While that goes on already, or waits in the arm for its turn, it need not begin anew.
    pub(super) fn halt_now(&mut self) {
        let waits = self.session.under_way() > 0;
        if self.halt.is_some_and(|it| it.rounds == 0 || waits) {
            return;
        }
        // What was urgent before is said again in its turn.
        self.urgent.clear();
        self.send_urgent(LASER_OFF);
        self.at_once = true;
        self.halt = Some(Halt {
            next: self.now + GAP,
            laser_is_next: false,
            rounds: 0,
            behind: 0,
            heard: true,
        });
    }

    /// Lets go of the button that was sent last; one that was never sent need not be released.
    pub(super) fn release_now(&mut self) {
        // The release must not pass the button itself, should that still wait for the line.
        while let Some(packet) = self.session.poll_bytes() {
            self.urgent.push_back(packet);
        }
        if !self.release_urgently() {
            return;
        }
        self.halt = Some(Halt {
            next: self.now + AGAIN,
            laser_is_next: false,
            rounds: 1,
            behind: 0,
            heard: false,
        });
    }

    /// Says it again: a stock arm wants a gap between packets, and may have missed one. What is said
    /// again waits for a status, so that the arm's queue is not filled up with it.
    pub(super) fn repeat_halt(&mut self) {
        let due = |it: &Halt| it.next <= self.now && it.heard;
        let Some(halt) = self.halt.filter(due) else {
            return;
        };
        if !self.is_linked() {
            self.halt = None;
            return;
        }
        if halt.rounds > 0 && self.session.under_way() > 0 {
            // The arm does one thing after the other: what was said waits there for its turn, and
            // more of the same would only take up its queue.
            let next = self.now + AGAIN;
            self.halt = Some(Halt { next, ..halt });
            return;
        }
        if halt.laser_is_next {
            self.send_urgent(LASER_OFF);
        } else {
            self.release_urgently();
        }
        let behind = halt.behind + u32::from(halt.rounds > 0);
        let again = if behind >= MOST_BEHIND {
            // With one more an arm that heard all would have no room, and be silent as if it was reset.
            self.rests_within().max(AGAIN)
        } else if halt.laser_is_next {
            GAP
        } else {
            AGAIN
        };
        self.halt = (halt.rounds < ROUNDS).then_some(Halt {
            next: self.now + again,
            laser_is_next: !halt.laser_is_next,
            rounds: halt.rounds + u32::from(!halt.laser_is_next),
            behind,
            heard: false,
        });
    }

    /// Behind a laser that was just switched off: the release of the button that was sent last may have
    /// got lost with the link.
    pub(super) fn release_again(&mut self) {
        self.halt = self.session.release().map(|_| Halt {
            next: self.now + GAP,
            laser_is_next: false,
            rounds: 0,
            behind: 0,
            heard: true,
        });
    }

    /// Whether there was a button to release.
    pub(super) fn release_urgently(&mut self) -> bool {
        let release = self.session.release();
        if let Some(release) = release {
            self.send_urgent(release);
        }
        release.is_some()
    }

    /// With each status: at rest there is nothing more to say, once it has been said twice.
    pub(super) fn watch_halt(&mut self) {
        let rests = self.is_at_rest();
        if let Some(halt) = &mut self.halt {
            halt.heard = true;
        }
        self.halt = self.halt.filter(|it| !rests || it.rounds < 2);
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
