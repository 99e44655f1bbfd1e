//! Pasted text is no key press: it is discarded.

use std::time::Duration;

use crossterm::event::{Event, KeyCode, KeyEvent, KeyEventKind};
use dobot_api::JogFrame;

use super::keys::{KeyMeaning, folded, meaning};

/// Discards pasted text, and bursts of different keys from terminals that do not mark pasted text.
/// A pressed key is held back for [`BURST`] to see whether it begins a burst. A key that stops the
/// arm is never held back.
#[derive(Debug, Default)]
pub(crate) struct PasteFilter {
    /// A pressed key, and when it arrived.
    held_back: Option<(Duration, Event)>,
    /// The time until which keys belong to the burst.
    burst_until: Option<Duration>,
    has_discarded: bool,
}

impl PasteFilter {
    /// Handles an event; returns the events that a person caused.
    pub(crate) fn handle_event(&mut self, now: Duration, event: Event) -> Vec<Event> {
        let before = self.handle_time(now);
        match &event {
            Event::Paste(_) => {
                self.has_discarded = true;
                before.into_iter().collect()
            }
            Event::Key(key) if key.kind == KeyEventKind::Press && !stops(key) => {
                let passed = self.handle_press(now, key.code, event);
                before.into_iter().chain(passed).collect()
            }
            _ => {
                let held_back = self.held_back.take().map(|(_, event)| event);
                before.into_iter().chain(held_back).chain([event]).collect()
            }
        }
    }

    fn handle_press(&mut self, now: Duration, code: KeyCode, event: Event) -> Option<Event> {
        if self.burst_until.is_some_and(|until| now < until) {
            self.burst_until = Some(now + BURST);
            return None;
        }
        match self.held_back.replace((now, event)) {
            Some((_, Event::Key(key))) if folded(key.code) != folded(code) => {
                self.held_back = None;
                self.burst_until = Some(now + BURST);
                self.has_discarded = true;
                None
            }
            same => same.map(|(_, event)| event),
        }
    }

    /// Returns the key that was held back, once it is no burst.
    pub(crate) fn handle_time(&mut self, now: Duration) -> Option<Event> {
        let (_, event) = self.held_back.take_if(|(at, _)| now >= *at + BURST)?;
        Some(event)
    }

    /// Returns the time at which to call [`handle_time`](Self::handle_time) next.
    pub(crate) fn poll_wakeup(&self) -> Option<Duration> {
        self.held_back.as_ref().map(|(at, _)| *at + BURST)
    }

    /// Returns whether anything was discarded since the last call.
    pub(crate) fn take_discarded(&mut self) -> bool {
        std::mem::take(&mut self.has_discarded)
    }
}

/// Returns whether a key stops the arm.
fn stops(key: &KeyEvent) -> bool {
    meaning(key, JogFrame::Joint, false) == KeyMeaning::Stop
}

/// What is shown after something was discarded.
pub(crate) const IGNORED: &str = "pasted text was ignored; press the keys one after the other";
/// Nobody presses two different keys within this time.
const BURST: Duration = Duration::from_millis(5);

#[cfg(test)]
mod tests {
    use crossterm::event::KeyModifiers;

    use super::*;

    fn press(letter: char) -> Event {
        Event::Key(KeyEvent::new(KeyCode::Char(letter), KeyModifiers::NONE))
    }

    fn ms(ms: u64) -> Duration {
        Duration::from_millis(ms)
    }

    /// The events that a filter passes for keys at these times, in milliseconds.
    fn passed(keys: &[(u64, char)]) -> (Vec<Event>, bool) {
        let mut filter = PasteFilter::default();
        let mut passed = Vec::new();
        for &(at, letter) in keys {
            passed.extend(filter.handle_event(ms(at), press(letter)));
        }
        passed.extend(filter.handle_time(ms(1000)));
        (passed, filter.take_discarded())
    }

    #[test]
    fn keys_typed_by_a_person_are_passed_in_order() {
        let keys = [(0, 'w'), (40, 'w'), (90, 'q')];
        assert_eq!(passed(&keys), (['w', 'w', 'q'].map(press).into(), false));
    }

    #[test]
    fn a_burst_of_different_keys_is_discarded() {
        let text = "glue the logo".replace(' ', "");
        let keys: Vec<_> = text.chars().map(|letter| (0, letter)).collect();
        assert_eq!(passed(&keys), (Vec::new(), true));
    }

    #[test]
    fn a_key_after_a_burst_is_passed() {
        let keys = [(0, 'g'), (1, 'l'), (2, 'u'), (50, 'g')];
        assert_eq!(passed(&keys), (vec![press('g')], true));
    }

    #[test]
    fn a_repeated_key_is_passed_at_any_rate() {
        let keys = [(0, 'o'), (1, 'o'), (2, 'o')];
        assert_eq!(passed(&keys), (vec![press('o'); 3], false));
    }

    #[test]
    fn a_stop_is_passed_at_once_even_in_a_burst() {
        let mut filter = PasteFilter::default();
        for letter in ['g', 'l', 'u'] {
            assert_eq!(filter.handle_event(ms(0), press(letter)), []);
        }
        assert_eq!(filter.handle_event(ms(0), press(' ')), [press(' ')]);
    }

    #[test]
    fn a_release_follows_its_press() {
        let mut filter = PasteFilter::default();
        let release = Event::Key(KeyEvent::new_with_kind(
            KeyCode::Char('o'),
            KeyModifiers::NONE,
            KeyEventKind::Release,
        ));
        assert_eq!(filter.handle_event(ms(0), press('o')), []);
        let both = filter.handle_event(ms(1), release.clone());
        assert_eq!(both, [press('o'), release]);
    }

    #[test]
    fn marked_text_is_discarded() {
        let mut filter = PasteFilter::default();
        let text = Event::Paste("grab, hold, left".to_owned());
        assert_eq!(filter.handle_event(ms(0), text), []);
        assert!(filter.take_discarded());
    }
}
