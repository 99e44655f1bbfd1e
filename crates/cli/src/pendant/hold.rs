//! Hold-to-run: the repeated requests of a held key, and its release.

use std::time::Duration;

/// The button held with one key, as an engine: the caller passes the time since the start.
///
/// Most terminals report only key presses, repeatedly while a key is held. There a key is released when
/// it was not reported for the dead-man time. With terminals that also report releases, the first repeat
/// may take up to [`FIRST_REPEAT`], because keyboards delay it; after that the dead-man time applies, so
/// that a lost release does not move the arm for long.
#[derive(Debug)]
pub(crate) struct HoldToRun<K, B> {
    keys: KeyReports,
    dead_man: Duration,
    held: Option<Held<K, B>>,
    /// Whether the last button was released and this was not polled yet.
    released: bool,
}

/// The key events that a terminal reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum KeyReports {
    /// Only presses, repeatedly while a key is held.
    Presses,
    /// Presses and releases.
    Releases,
}

/// A request to send now.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Beat<B> {
    /// The button is held.
    Hold(B),
    /// The button is released.
    Release,
}

#[derive(Debug)]
struct Held<K, B> {
    key: K,
    button: B,
    /// The time at which it is released.
    until: Duration,
    /// The time of the next request.
    beat: Duration,
    /// Whether it was refused, and is ignored until it is pressed again.
    refused: bool,
}

impl<K: PartialEq, B: Copy + PartialEq> HoldToRun<K, B> {
    /// Creates it without a held button. `dead_man` is the time after which a button is released without a
    /// further request.
    pub(crate) const fn new(keys: KeyReports, dead_man: Duration) -> Self {
        Self {
            keys,
            dead_man,
            held: None,
            released: false,
        }
    }

    /// Handles a press or repeat of a key. Another key replaces the held one.
    pub(crate) fn handle_press(&mut self, now: Duration, key: K, button: B) {
        self.handle_time(now);
        let again = |held: &&mut Held<K, B>| held.key == key && held.button == button;
        if let Some(held) = self.held.as_mut().filter(again) {
            held.until = now + self.dead_man;
            return;
        }
        // The first request of a button also ends the previous one.
        self.released = false;
        self.held = Some(Held {
            key,
            button,
            until: now + self.first_timeout(),
            beat: now,
            refused: false,
        });
    }

    /// Handles that a key without repeats is still held.
    pub(crate) fn handle_still(&mut self, now: Duration, key: &K) {
        if let Some(held) = self.held.as_mut().filter(|held| held.key == *key) {
            held.until = now + self.dead_man;
        }
    }

    /// Handles the release of a key.
    pub(crate) fn handle_release(&mut self, key: &K) {
        if self.held.as_ref().is_some_and(|held| held.key == *key) {
            self.release();
        }
    }

    /// Releases the held button.
    pub(crate) fn release(&mut self) {
        self.released |= self.held.take().is_some();
    }

    /// Handles that the button was refused or released by the station: it must be pressed again.
    pub(crate) fn handle_refused(&mut self) {
        if let Some(held) = &mut self.held {
            held.refused = true;
        }
    }

    /// Advances to a time.
    pub(crate) fn handle_time(&mut self, now: Duration) {
        if self.held.as_ref().is_some_and(|held| held.until <= now) {
            self.release();
        }
    }

    /// Returns the request to send now, if any.
    pub(crate) fn poll(&mut self, now: Duration) -> Option<Beat<B>> {
        if std::mem::take(&mut self.released) {
            return Some(Beat::Release);
        }
        let held = self.held.as_mut().filter(|held| !held.refused)?;
        if held.beat > now {
            return None;
        }
        held.beat = now + self.dead_man / BEATS;
        Some(Beat::Hold(held.button))
    }

    /// Returns the time of the next request or release.
    pub(crate) fn poll_wakeup(&self) -> Option<Duration> {
        let held = self.held.as_ref()?;
        Some(if held.refused {
            held.until
        } else {
            held.until.min(held.beat)
        })
    }

    /// The held button, unless it was refused.
    pub(crate) fn button(&self) -> Option<B> {
        let held = self.held.as_ref().filter(|held| !held.refused)?;
        Some(held.button)
    }

    /// Whether the button is held with a key.
    pub(crate) fn is_held_by(&self, key: &K) -> bool {
        self.held.as_ref().is_some_and(|held| held.key == *key)
    }

    /// The key events that the terminal reports.
    pub(crate) const fn keys(&self) -> KeyReports {
        self.keys
    }

    /// How long after its release a key counts as held.
    pub(crate) const fn release_delay(&self) -> Duration {
        match self.keys {
            KeyReports::Presses => self.dead_man,
            KeyReports::Releases => Duration::ZERO,
        }
    }

    fn first_timeout(&self) -> Duration {
        match self.keys {
            KeyReports::Presses => self.dead_man,
            KeyReports::Releases => FIRST_REPEAT.max(self.dead_man),
        }
    }
}

/// The number of requests within the dead-man time.
const BEATS: u32 = 3;
/// Longer than the delay of a keyboard before the first repeat.
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

    /// All actions until a time, with their times.
    fn said(it: &mut HoldToRun<char, u8>, from: u64, until: u64) -> Vec<(u64, Beat<u8>)> {
        (from..=until)
            .flat_map(|now| {
                it.handle_time(ms(now));
                std::iter::from_fn(|| it.poll(ms(now)).map(|beat| (now, beat))).collect::<Vec<_>>()
            })
            .collect()
    }

    #[test]
    fn a_key_that_is_not_repeated_is_released_after_the_dead_man_timeout() {
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
    fn a_repeating_key_is_held_until_it_stops_repeating() {
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
    fn if_the_terminal_reports_releases_the_arm_stops_with_the_key() {
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
    fn another_key_replaces_the_held_one() {
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
    fn a_refused_button_is_not_sent_again_until_the_next_press() {
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
        fn nothing_is_held_longer_than_its_timeout_for_any_events(
            events in prop::collection::vec((0_u64..400, 0_u8..4, 0_u8..3), 0..60),
            reports_releases in any::<bool>(),
        ) {
            let keys = if reports_releases { KeyReports::Releases } else { KeyReports::Presses };
            let mut it = hold(keys);
            let (mut now, mut pressed) = (0, 0);
            for (after, event, key) in events {
                for (at, beat) in said(&mut it, now, now + after) {
                    let patience = if reports_releases { 1000 } else { 150 };
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
