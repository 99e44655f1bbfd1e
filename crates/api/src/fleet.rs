//! Stations that know of each other: a fleet.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Problem, State, TakesWork};

/// A fleet, as one of its stations sees it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FleetView {
    /// What the station that tells this is called in the fleet.
    pub name: String,
    /// The time since that station started, in seconds.
    pub at_s: f64,
    /// All stations that have been seen, this one among them, by name.
    pub members: Vec<Member>,
}

/// A station of a fleet, as another one sees it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Member {
    /// What it is called, as in `desk-3`.
    pub name: String,
    /// The number that it goes by as long as its data live, 32 hexadecimal digits: two stations may claim one name.
    pub id: String,
    /// Whether it is the station that tells this.
    pub here: bool,
    /// Whether it can be reached.
    pub presence: Presence,
    /// When it was heard last, in seconds since the start of the station that tells this: by no other clock.
    pub heard_at_s: f64,
    /// What it is; absent until it has told.
    pub about: Option<MemberAbout>,
    /// What it told last; absent until it has told anything.
    pub state: Option<Box<State>>,
}

/// Whether a station of a fleet can be reached.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Presence {
    /// It is there.
    Present,
    /// It is away: it ended, or the network between it and this station is cut. Its arm may still move: its own page
    /// stops it.
    Away,
    /// It is there, and nothing is asked of it.
    Refused {
        /// Why, and what to do.
        problem: Problem,
    },
}

/// What a station of a fleet is.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MemberAbout {
    /// The version of its program.
    pub version: String,
    /// Where its own page is, as others reach it; absent where it is for its own machine only.
    pub page: Option<String>,
    /// The groups that it belongs to, as in `room-2`.
    pub groups: Vec<String>,
    /// What it has for work, as in `pen`, `laser`, `a5`.
    pub offers: Vec<String>,
    /// Whether its arm is a virtual one.
    pub is_virtual: bool,
    /// What it does with work of the fleet; absent where it takes none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub takes_work: Option<TakesWork>,
    /// How many virtual arms it gives to those without an arm; absent where it gives none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gives_arms: Option<u16>,
    /// The station that gave this virtual arm to somebody; absent where it is no such arm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub given_by: Option<String>,
}

/// A stop of a whole fleet, or its reset. Every station keeps it and sends it to the others.
///
/// Of two with the same origin the one with the higher count is newer. The origin alone counts, so neither the clocks of
/// other stations nor the order of messages matter. Stops of two origins hold beside each other.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FleetWideStop {
    /// The number of the station that made it, as in [`Member::id`].
    pub origin: String,
    /// Its number among the stops of that station: at least the time when it was made, in milliseconds since
    /// 1970-01-01T00:00:00Z by the clock of that station, and always above the one before.
    pub count: u64,
    /// Who stopped the fleet.
    pub by: String,
    /// Why.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// Who reset it for the whole fleet; absent while it holds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reset_by: Option<String>,
}

impl FleetWideStop {
    /// Whether it has not been reset for the whole fleet.
    #[must_use]
    pub const fn holds(&self) -> bool {
        self.reset_by.is_none()
    }

    /// Who stopped the fleet and why, as a person reads it.
    #[must_use]
    pub fn text(&self) -> String {
        let text = format!("stopped: fleet, by {}", self.by);
        crate::state::with_reason(text, self.reason.as_deref())
    }
}

/// The virtual arms that a station gives to those without an arm.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct GivenArms {
    /// So many it gives at a time.
    pub most: u16,
    /// One that nobody looks at ends after so long, in seconds.
    pub unused_s: u64,
    /// Those that are given.
    pub arms: Vec<GivenArm>,
}

/// A virtual arm that somebody was given: a station of the fleet like any other one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct GivenArm {
    /// What it is called in the fleet.
    pub name: String,
    /// Where its page is.
    pub page: String,
}

/// A request to the API of a station, as it travels through a fleet: that of HTTP, in parts.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ApiRequest {
    /// The method, as in `POST`.
    pub method: String,
    /// The path with its query, as in `/api/v1/stop`.
    pub path: String,
    /// The token of whoever asks; one who has none may watch and stop.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub token: Option<String>,
    /// The token of a lease, as in the header `Dobot-Lease`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lease: Option<String>,
    /// What the sender calls this request, as in the header `Idempotency-Key`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub key: Option<String>,
    /// The body, JSON; absent where there is none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub body: Option<serde_json::Value>,
}

/// What a station answers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ApiAnswer {
    /// The status of HTTP.
    pub status: u16,
    /// The body: JSON, a problem where the status is 400 or above, and a text where it is no JSON.
    pub body: serde_json::Value,
}

/// Which stations of a fleet.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Recipients {
    /// Every one.
    All,
    /// Those of a group.
    Group(String),
    /// Those of these names.
    Members(Vec<String>),
}

/// What one station of a fleet answered.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MemberAnswer {
    /// What it is called.
    pub member: String,
    /// The number that it goes by.
    pub id: String,
    /// Its answer; where none came, a problem says so: what was asked may have been done all the same.
    pub answer: ApiAnswer,
    /// How long the answer took, in milliseconds.
    pub took_ms: f64,
}

impl ApiAnswer {
    /// The answer that a problem is.
    #[must_use]
    pub fn of_problem(problem: &Problem) -> Self {
        Self {
            status: problem.status,
            body: serde_json::to_value(problem).unwrap_or_default(),
        }
    }

    /// Whether what was asked for was done.
    #[must_use]
    pub const fn is_success(&self) -> bool {
        matches!(self.status, 200..=299)
    }
}

impl Recipients {
    /// Whether this station is among them.
    #[must_use]
    pub fn include(&self, member: &Member) -> bool {
        match self {
            Self::All => true,
            Self::Group(group) => {
                let about = member.about.as_ref();
                about.is_some_and(|about| about.groups.contains(group))
            }
            Self::Members(names) => names.contains(&member.name),
        }
    }
}

/// Whether a station, a group or what a station offers can be called so: 1 to 40 small letters of English, digits and hyphens,
/// the first one a letter.
#[must_use]
pub fn is_fleet_name(text: &str) -> bool {
    let plain = |it: char| it.is_ascii_lowercase() || it.is_ascii_digit() || it == '-';
    text.len() <= 40
        && text.starts_with(|it: char| it.is_ascii_lowercase())
        && text.chars().all(plain)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_of_the_fleet_can_be_part_of_an_address() {
        for good in ["desk-3", "a", "room2"] {
            assert!(is_fleet_name(good), "{good}");
        }
        for bad in [
            "",
            "3-desk",
            "Desk",
            "desk 3",
            "desk/3",
            "desk*",
            "schräg",
            &"a".repeat(41),
        ] {
            assert!(!is_fleet_name(bad), "{bad}");
        }
    }

    #[test]
    fn a_group_is_those_that_say_that_they_belong_to_it() {
        let member = |name: &str, groups: &[&str]| Member {
            name: name.into(),
            id: "0".repeat(32),
            here: false,
            presence: Presence::Present,
            heard_at_s: 0.0,
            about: Some(MemberAbout {
                groups: groups.iter().map(|&it| it.into()).collect(),
                ..MemberAbout::default()
            }),
            state: None,
        };
        let [one, other] = [member("desk-1", &["room-1"]), member("desk-2", &["room-2"])];
        let room = Recipients::Group("room-1".into());
        assert!(room.include(&one) && !room.include(&other));
        let named = Recipients::Members(vec!["desk-2".into()]);
        assert!(!named.include(&one) && named.include(&other));
        let unknown = Member { about: None, ..one };
        assert!(!room.include(&unknown) && Recipients::All.include(&unknown));
    }
}
