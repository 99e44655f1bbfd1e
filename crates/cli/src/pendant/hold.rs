//! Hold-to-run: what a key that is held says again and again, and when it counts as let go.

use std::time::Duration;

/// What is held with one key, as an engine: the caller passes the time since it began.
///
/// Most terminals tell only that a key is pressed, and tell it again while it is held. There a key
/// counts as let go when it was not told for the dead-man time. Those that also tell when a key is
/// let go are given [`FIRST_REPEAT`] for the first repeat, because a keyboard waits before it repeats;
/// from then on the same holds, so that a key whose end is lost moves no arm for long.
#[derive(Debug)]
pub(crate) struct HoldToRun<K, B> {
    keys: KeyReports,
    dead_man: Duration,
    held: Option<Held<K, B>>,
    /// The last one was let go, and that was not polled yet.
    released: bool,
}

/// What a terminal tells of its keys.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum KeyReports {
    /// Presses alone, again and again while a key is held.
    Presses,
    /// Also when a key is let go.
    Releases,
}

/// What has to be said now.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Beat<B> {
    /// The button is held.
    Hold(B),
    /// The button is let go.
    Release,
}

#[derive(Debug)]
struct Held<K, B> {
    key: K,
    button: B,
    /// When it counts as let go.
    until: Duration,
    /// When it is to be said again.
    beat: Duration,
    /// It was refused, and does nothing until it is pressed anew.
    refused: bool,
}

impl<K: PartialEq, B: Copy + PartialEq> HoldToRun<K, B> {
    /// Nothing is held. `dead_man` is how long a button stays pressed without being said again.
    pub(crate) const fn new(keys: KeyReports, dead_man: Duration) -> Self {
        Self {
            keys,
            dead_man,
            held: None,
            released: false,
        }
    }

    /// Takes that a key is pressed, or repeats. Another key takes the place of the one before.
    pub(crate) fn handle_press(&mut self, now: Duration, key: K, button: B) {
        self.handle_time(now);
        let again = |it: &&mut Held<K, B>| it.key == key && it.button == button;
        if let Some(held) = self.held.as_mut().filter(again) {
            held.until = now + self.dead_man;
            return;
        }
        // A button that takes the place of another one is told by its first beat.
        self.released = false;
        self.held = Some(Held {
            key,
            button,
            until: now + self.first_patience(),
            beat: now,
            refused: false,
        });
    }

    /// Takes that a key is still held that does not repeat by itself.
    pub(crate) fn handle_still(&mut self, now: Duration, key: &K) {
        if let Some(held) = self.held.as_mut().filter(|it| it.key == *key) {
            held.until = now + self.dead_man;
        }
    }

    /// Takes that a key is let go.
    pub(crate) fn handle_release(&mut self, key: &K) {
        if self.held.as_ref().is_some_and(|it| it.key == *key) {
            self.release();
        }
    }

    /// Lets go of whatever is held.
    pub(crate) fn release(&mut self) {
        self.released |= self.held.take().is_some();
    }

    /// Takes that the button was refused, or let go for the person: it has to be pressed anew.
    pub(crate) fn handle_refused(&mut self) {
        if let Some(held) = &mut self.held {
            held.refused = true;
        }
    }

    /// Takes the passing of time.
    pub(crate) fn handle_time(&mut self, now: Duration) {
        if self.held.as_ref().is_some_and(|it| it.until <= now) {
            self.release();
        }
    }

    /// What has to be said now, if anything.
    pub(crate) fn poll(&mut self, now: Duration) -> Option<Beat<B>> {
        if std::mem::take(&mut self.released) {
            return Some(Beat::Release);
        }
        let held = self.held.as_mut().filter(|it| !it.refused)?;
        if held.beat > now {
            return None;
        }
        held.beat = now + self.dead_man / BEATS;
        Some(Beat::Hold(held.button))
    }

    /// When something has to be said, or counts as let go.
    pub(crate) fn poll_wakeup(&self) -> Option<Duration> {
        let held = self.held.as_ref()?;
        Some(if held.refused {
            held.until
        } else {
            held.until.min(held.beat)
        })
    }

    /// The button that acts.
    pub(crate) fn button(&self) -> Option<B> {
        let held = self.held.as_ref().filter(|it| !it.refused)?;
        Some(held.button)
    }

    /// Whether it is held with this key.
    pub(crate) fn is_held_by(&self, key: &K) -> bool {
        self.held.as_ref().is_some_and(|it| it.key == *key)
    }

    /// What the terminal tells.
    pub(crate) const fn keys(&self) -> KeyReports {
        self.keys
    }

    fn first_patience(&self) -> Duration {
        match self.keys {
            KeyReports::Presses => self.dead_man,
            KeyReports::Releases => FIRST_REPEAT.max(self.dead_man),
        }
    }
}

/// How often a button is said within the dead-man time.
const BEATS: u32 = 3;
/// Longer than a keyboard waits before a key repeats.
const FIRST_REPEAT: Duration = Duration::from_secs(1);

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const DEAD_MAN: Duration = Duration::from_millis(150);

    fn ms(ms: u64) -> Duration {
        Duration::from_millis(ms)
    }

    fn hold(keys: KeyReports) -> HoldToRun<char, u8> {
        HoldToRun::new(keys, DEAD_MAN)
    }

    /// All that is said until a time, with when.
    fn said(it: &mut HoldToRun<char, u8>, from: u64, until: u64) -> Vec<(u64, Beat<u8>)> {
        (from..=until)
            .flat_map(|now| {
                it.handle_time(ms(now));
                std::iter::from_fn(|| it.poll(ms(now)).map(|beat| (now, beat))).collect::<Vec<_>>()
            })
            .collect()
    }

    #[test]
    fn a_key_that_is_not_repeated_is_let_go_after_the_dead_man_time() {
        let mut it = hold(KeyReports::Presses);
        it.handle_press(ms(0), 'x', 1);
        let expected = [
            (0, Beat::Hold(1)),
            (50, Beat::Hold(1)),
            (100, Beat::Hold(1)),
            (150, Beat::Release),
        ];
        assert_eq!(said(&mut it, 0, 1000), expected);
    }

    #[test]
    fn a_key_that_repeats_is_held_until_it_repeats_no_more() {
        let mut it = hold(KeyReports::Presses);
        let mut all = Vec::new();
        for at in (0..2000).step_by(100) {
            it.handle_press(ms(at), 'x', 1);
            all.extend(said(&mut it, at, at + 99));
        }
        assert!(
            all.iter().all(|(_, beat)| *beat == Beat::Hold(1)),
            "{all:?}"
        );
        // Pressed last at 1900 ms.
        let end = said(&mut it, 2000, 3000);
        assert_eq!(end.last(), Some(&(2050, Beat::Release)), "{end:?}");
    }

    #[test]
    fn where_the_terminal_tells_the_release_the_arm_stops_with_it() {
        let mut it = hold(KeyReports::Releases);
        it.handle_press(ms(0), 'x', 1);
        let before = said(&mut it, 0, 600);
        assert!(before.iter().all(|(_, beat)| *beat == Beat::Hold(1)));
        it.handle_release(&'x');
        assert_eq!(said(&mut it, 600, 2000), [(600, Beat::Release)]);
    }

    #[test]
    fn a_release_that_is_lost_moves_the_arm_for_a_second_at_most() {
        let mut it = hold(KeyReports::Releases);
        it.handle_press(ms(0), 'x', 1);
        assert_eq!(
            said(&mut it, 0, 5000).last(),
            Some(&(1000, Beat::Release)),
            "no repeat came"
        );
        it.handle_press(ms(6000), 'x', 1);
        it.handle_press(ms(6500), 'x', 1);
        assert_eq!(
            said(&mut it, 6500, 9000).last(),
            Some(&(6650, Beat::Release)),
            "its repeats ended"
        );
    }

    #[test]
    fn another_key_takes_the_place_of_the_one_that_is_held() {
        let mut it = hold(KeyReports::Releases);
        it.handle_press(ms(0), 'x', 1);
        assert_eq!(it.poll(ms(0)), Some(Beat::Hold(1)));
        it.handle_press(ms(10), 'y', 2);
        it.handle_release(&'x');
        assert_eq!(it.poll(ms(10)), Some(Beat::Hold(2)));
        it.handle_release(&'y');
        assert_eq!(it.poll(ms(20)), Some(Beat::Release));
    }

    #[test]
    fn a_button_that_was_refused_is_said_no_more_until_it_is_pressed_anew() {
        let mut it = hold(KeyReports::Presses);
        it.handle_press(ms(0), 'x', 1);
        assert_eq!(it.poll(ms(0)), Some(Beat::Hold(1)));
        it.handle_refused();
        it.handle_press(ms(100), 'x', 1);
        assert_eq!(said(&mut it, 100, 1000), [(250, Beat::Release)]);
        it.handle_press(ms(2000), 'x', 1);
        assert_eq!(it.poll(ms(2000)), Some(Beat::Hold(1)));
    }

    proptest! {
        #[test]
        fn nothing_is_held_longer_than_its_patience_whatever_comes(
            events in prop::collection::vec((0_u64..400, 0_u8..4, 0_u8..3), 0..60),
            tells in any::<bool>(),
        ) {
            let keys = if tells { KeyReports::Releases } else { KeyReports::Presses };
            let mut it = hold(keys);
            let (mut now, mut pressed) = (0, 0);
            for (after, event, key) in events {
                for (at, beat) in said(&mut it, now, now + after) {
                    let patience = if tells { 1000 } else { 150 };
                    prop_assert!(beat == Beat::Release || at < pressed + patience);
                }
                now += after;
                match event {
                    0 | 1 => {
                        pressed = now;
                        it.handle_press(ms(now), char::from(b'a' + key), key);
                    }
                    2 => it.handle_release(&char::from(b'a' + key)),
                    _ => it.handle_refused(),
                }
            }
            let rest = said(&mut it, now, now + 1100);
            prop_assert!(it.button().is_none() && it.poll_wakeup().is_none());
            prop_assert!(!rest.iter().any(|(at, _)| *at > pressed + 1000));
        }
    }
}
