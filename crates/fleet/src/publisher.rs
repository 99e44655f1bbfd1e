//! The published state of this station.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use dobot_api::{MemberAbout, State, is_fleet_name};
use dobot_host::Snapshot;
use dobot_supervisor::{is_plain, plain};
use serde_json::Value;

use crate::identity::{Identity, Peer, SIGNATURE, statement};
use crate::key_expressions::MemberKey;
use crate::roster::StateReport;

/// Signs the published states. Each has a sequence number, which prevents replay.
#[derive(Clone, Debug)]
pub(crate) struct StateSigner {
    identity: Arc<Identity>,
    own: MemberKey,
    run: u64,
    count: Arc<AtomicU64>,
}

impl StateSigner {
    pub(crate) fn new(identity: Arc<Identity>, own: MemberKey, run: u64) -> Self {
        let count = Arc::default();
        Self {
            identity,
            own,
            run,
            count,
        }
    }

    /// Returns the attachment of a state: its sequence number and the signature.
    pub(crate) fn sign(&self, state: &[u8]) -> Vec<u8> {
        let count = 1 + self.count.fetch_add(1, Ordering::Relaxed);
        let signature = self
            .identity
            .sign(&state_statement(&self.own, self.run, count, state));
        [&count.to_be_bytes()[..], &signature].concat()
    }
}

/// Returns the sequence number of a member's state, if the signature is valid for this run.
pub(crate) fn number_of(
    peer: &Peer,
    member: &MemberKey,
    run: u64,
    state: &[u8],
    attachment: &[u8],
) -> Option<u64> {
    let (count, signature) = attachment.split_first_chunk::<8>()?;
    let count = u64::from_be_bytes(*count);
    let statement = state_statement(member, run, count, state);
    (signature.len() == SIGNATURE && peer.has_signed(&statement, signature)).then_some(count)
}

fn state_statement(member: &MemberKey, run: u64, count: u64, state: &[u8]) -> Vec<u8> {
    let MemberKey { name, id } = member;
    let (run, count) = (run.to_be_bytes(), count.to_be_bytes());
    statement(
        "state",
        &[name.as_bytes(), id.as_bytes(), &run, &count, state],
    )
}

/// The maximum length of a state, in bytes.
const LONGEST: usize = 256 * 1024;
/// The maximum number of groups or offers.
const MAX_WORDS: usize = 64;
/// The maximum length of a page address, in bytes.
const LONGEST_PAGE: usize = 200;

/// Parses the state of a station of this name, whose certificate names this holder. Invalid names,
/// groups and links are dropped, and so are non-printable characters.
pub(crate) fn read(message: &[u8], name: &str, holder: &str) -> Result<StateReport, String> {
    if message.len() > LONGEST {
        return Err(format!(
            "it has {} bytes; at most {LONGEST} are allowed",
            message.len()
        ));
    }
    let mut value = serde_json::from_slice(message).map_err(|error| error.to_string())?;
    strip(&mut value);
    let mut report: StateReport =
        serde_json::from_value(value).map_err(|error| error.to_string())?;
    let about = &mut report.about;
    for words in [&mut about.groups, &mut about.offers] {
        words.retain(|word| is_fleet_name(word));
        words.truncate(MAX_WORDS);
    }
    about.version = plain(&about.version, 40);
    about.page.take_if(|page| !is_page(page));
    // The holder of the certificate.
    about.given_by = (holder != name).then(|| holder.to_owned());
    Ok(report)
}

/// Removes control characters.
fn strip(value: &mut Value) {
    match value {
        Value::String(text) => text.retain(|char| char == '\n' || is_plain(char)),
        Value::Array(all) => all.iter_mut().for_each(strip),
        Value::Object(all) => all.values_mut().for_each(strip),
        Value::Null | Value::Bool(_) | Value::Number(_) => {}
    }
}

fn is_page(text: &str) -> bool {
    let place = text
        .strip_prefix("https://")
        .or_else(|| text.strip_prefix("http://"));
    let allowed = |char: char| char.is_ascii_alphanumeric() || ".-_[]:/".contains(char);
    text.len() <= LONGEST_PAGE
        && place.is_some_and(|host| !host.is_empty() && host.chars().all(allowed))
}

/// Serialises this station's state.
pub(crate) fn state_message(about: &MemberAbout, state: &Snapshot) -> Vec<u8> {
    let about = serde_json::to_vec(about).expect("structures with text keys are JSON");
    let parts: [&[u8]; 5] = [
        br#"{"about":"#,
        &about,
        br#","state":"#,
        &state.json(),
        b"}",
    ];
    parts.concat()
}

/// Decides when to publish: a change immediately, and a sign of life every second.
#[derive(Debug, Default)]
pub(crate) struct Pace {
    last: Option<(Duration, State)>,
}

/// The interval at which an unchanged state is published.
const STILL_THERE: Duration = Duration::from_secs(1);

impl Pace {
    pub(crate) fn is_due(&mut self, now: Duration, state: &State) -> bool {
        let is_due = self.last.as_ref().is_none_or(|(at, last)| {
            now.saturating_sub(*at) >= STILL_THERE
                || last.arm != state.arm
                || last.without_readings() != state.without_readings()
        });
        if is_due {
            self.last = Some((now, state.clone()));
        }
        is_due
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_api::StopView;

    use super::*;

    #[test]
    fn invalid_names_and_links_are_omitted_and_no_control_characters_reach_the_terminal() {
        let about = MemberAbout {
            version: "\u{1b}]0;pwn\u{7}1.0".into(),
            page: Some("javascript:alert(1)".into()),
            groups: vec!["\u{1b}[31mEVIL".into(), "room-1".into(), "Room 1".into()],
            offers: vec!["pen".into(), "<b>".into()],
            given_by: Some("desk-1".into()),
            ..MemberAbout::default()
        };
        let report = StateReport {
            about,
            state: Some(Box::new(State {
                stop: Some(StopView {
                    by: "An\u{1b}[2Jna".into(),
                    device: None,
                    client: None,
                    reason: Some("\u{202e}fire".into()),
                    at_s: 1.3,
                    rests_by_s: 1.4,
                    at_rest: false,
                    delivered: true,
                    of_fleet: false,
                }),
                ..State::sample()
            })),
        };
        let message = serde_json::to_vec(&report).unwrap();
        let StateReport { about, state } = read(&message, "desk-2", "desk-2").unwrap();
        assert_eq!(about.version, "]0;pwn1.0");
        assert_eq!((about.page, about.given_by), (None, None));
        assert_eq!(
            (about.groups, about.offers),
            (vec!["room-1".to_owned()], vec!["pen".to_owned()])
        );
        let stop = state.unwrap().stop.unwrap();
        assert_eq!(
            (&*stop.by, stop.reason.as_deref()),
            ("An[2Jna", Some("fire"))
        );
    }

    #[test]
    fn a_page_is_a_web_link() {
        for good in [
            "http://desk-3:8642",
            "https://[fe80::1]:8642/",
            "https://10.7.1.2:8642/fleet",
        ] {
            assert!(is_page(good), "{good}");
        }
        for bad in [
            "javascript:alert(1)",
            "https://",
            "http://a/\" onclick=\"x",
            "data:text/html,x",
            "http://user@desk-3/",
            &format!("http://{}", "a".repeat(300)),
        ] {
            assert!(!is_page(bad), "{bad}");
        }
    }

    #[test]
    fn a_stop_is_published_at_once_and_an_arm_at_rest_every_second() {
        let at = Duration::from_millis;
        let mut pace = Pace::default();
        assert!(pace.is_due(at(0), &State::sample()));
        let later = State {
            at_s: 1.2,
            ..State::sample()
        };
        assert!(!pace.is_due(at(200), &later));
        assert!(pace.is_due(at(1000), &later));
        let stopped = State {
            stop: Some(StopView {
                by: "Anna".into(),
                device: None,
                client: None,
                reason: None,
                at_s: 1.3,
                rests_by_s: 1.4,
                at_rest: false,
                delivered: true,
                of_fleet: false,
            }),
            ..later
        };
        assert!(pace.is_due(at(1100), &stopped));
    }
}
