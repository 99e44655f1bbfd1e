//! Fleets: stations that know each other.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Problem, State, TakesWork};

/// A fleet, as one of its stations sees it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FleetView {
    /// The fleet name of the reporting station.
    pub name: String,
    /// The time since the reporting station started, in seconds.
    pub at_s: f64,
    /// All stations seen, including this one, by name.
    pub members: Vec<Member>,
}

/// A station of a fleet, as another one sees it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Member {
    /// The fleet name, as in `desk-3`.
    pub name: String,
    /// The station's id, 32 hexadecimal digits, valid as long as its data folder exists: two
    /// stations may claim the same name.
    pub id: String,
    /// Whether this is the reporting station.
    pub here: bool,
    /// Whether the station can be reached.
    pub presence: Presence,
    /// When it was last heard, in seconds since the reporting station started (no other clock is
    /// involved).
    pub heard_at_s: f64,
    /// A description of the station; absent until it has sent one.
    pub about: Option<MemberAbout>,
    /// The last state it sent; absent until it has sent one.
    pub state: Option<Box<State>>,
}

/// Whether a station of a fleet can be reached.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Presence {
    /// The station is reachable.
    Present,
    /// The station has ended, or the network to it is down. Its arm may still move; stop it from
    /// its own page.
    Away,
    /// The station is reachable, but no requests are sent to it.
    Refused {
        /// The reason, and what to do.
        problem: Problem,
    },
}

/// A description of a fleet station.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MemberAbout {
    /// The program version.
    pub version: String,
    /// The address of its page for other machines; absent if it serves its own machine only.
    pub page: Option<String>,
    /// The station's groups, as in `room-2`.
    pub groups: Vec<String>,
    /// The equipment it offers for jobs, as in `pen`, `laser`, `a5`.
    pub offers: Vec<String>,
    /// Whether its arm is virtual.
    pub is_virtual: bool,
    /// How it handles fleet jobs; absent if it accepts none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub takes_work: Option<TakesWork>,
    /// The number of virtual arms it hosts for members without an arm; absent if none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gives_arms: Option<u16>,
    /// The station that hosts this virtual arm; absent for any other arm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub given_by: Option<String>,
}

/// A fleet-wide stop, or its reset. Every station stores it and sends it to the others.
///
/// Of two stops with the same origin, the one with the higher count is newer. The count is set by
/// the origin alone, so neither other stations' clocks nor the order of messages matter. Stops of
/// different origins hold independently.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FleetWideStop {
    /// The id of the station that made it, as in [`Member::id`].
    pub origin: String,
    /// The number of the stop at its origin: at least the time it was made, in milliseconds since
    /// 1970-01-01T00:00:00Z by the origin's clock, and always higher than the previous one.
    pub count: u64,
    /// Who stopped the fleet.
    pub by: String,
    /// The reason.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// Who reset it for the whole fleet; absent while it holds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reset_by: Option<String>,
}

impl FleetWideStop {
    /// Returns whether the stop has not been reset for the whole fleet.
    #[must_use]
    pub const fn holds(&self) -> bool {
        self.reset_by.is_none()
    }

    /// Returns who stopped the fleet and why, as text.
    #[must_use]
    pub fn text(&self) -> String {
        let text = format!("stopped: fleet, by {}", self.by);
        crate::state::with_reason(text, self.reason.as_deref())
    }
}

/// The virtual arms that a station hosts for members without an arm.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct GivenArms {
    /// The maximum number at a time.
    pub most: u16,
    /// The time after which an arm that no client watches ends, in seconds.
    pub unused_s: u64,
    /// The hosted arms.
    pub arms: Vec<GivenArm>,
}

/// A hosted virtual arm: a fleet station like any other.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct GivenArm {
    /// The fleet name.
    pub name: String,
    /// The address of its page.
    pub page: String,
}

/// An HTTP API request as sent through a fleet, in parts.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ApiRequest {
    /// The method, as in `POST`.
    pub method: String,
    /// The path with its query, as in `/api/v1/stop`.
    pub path: String,
    /// The requester's token; without one it may watch and stop.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub token: Option<String>,
    /// The lease token, as in the header `Dobot-Lease`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lease: Option<String>,
    /// The request's idempotency key, as in the header `Idempotency-Key`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub key: Option<String>,
    /// The JSON body; absent if there is none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub body: Option<serde_json::Value>,
}

/// A station's answer to an API request.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ApiAnswer {
    /// The HTTP status.
    pub status: u16,
    /// The body: JSON; a problem if the status is 400 or above; a string if it is not JSON.
    pub body: serde_json::Value,
}

/// The stations of a fleet that a request goes to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Recipients {
    /// All stations.
    All,
    /// The members of a group.
    Group(String),
    /// The stations with these names.
    Members(Vec<String>),
}

/// The answer of one fleet station.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MemberAnswer {
    /// The fleet name.
    pub member: String,
    /// The station's id.
    pub id: String,
    /// The answer, or a problem if none came: the request may still have been carried out.
    pub answer: ApiAnswer,
    /// The time until the answer, in milliseconds.
    pub took_ms: f64,
}

impl ApiAnswer {
    /// Builds an answer from a problem.
    #[must_use]
    pub fn of_problem(problem: &Problem) -> Self {
        Self {
            status: problem.status,
            body: serde_json::to_value(problem).unwrap_or_default(),
        }
    }

    /// Returns whether the request succeeded.
    #[must_use]
    pub const fn is_success(&self) -> bool {
        matches!(self.status, 200..=299)
    }
}

impl Recipients {
    /// Returns whether the member is a recipient.
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

/// Returns whether the text is a valid name of a station, a group or an offer: 1 to 40 lowercase
/// English letters, digits and hyphens, starting with a letter.
#[must_use]
pub fn is_fleet_name(text: &str) -> bool {
    let plain = |character: char| {
        character.is_ascii_lowercase() || character.is_ascii_digit() || character == '-'
    };
    text.len() <= 40
        && text.starts_with(|character: char| character.is_ascii_lowercase())
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
    fn a_group_consists_of_the_members_that_list_it() {
        let member = |name: &str, groups: &[&str]| Member {
            name: name.into(),
            id: "0".repeat(32),
            here: false,
            presence: Presence::Present,
            heard_at_s: 0.0,
            about: Some(MemberAbout {
                groups: groups.iter().map(|&group| group.into()).collect(),
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
