//! WebSocket messages.

use std::borrow::Cow;

use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, de};

use crate::{ClientId, Notice, Problem, Reply, Request, Role, State};

/// A message from a client over the WebSocket.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FromClient {
    /// A number, repeated in the answer.
    pub id: u64,
    /// The request.
    pub request: Request,
}

/// A message from the station over the WebSocket.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum ToClient<'a> {
    /// The first message.
    Hello {
        /// Information for the client.
        hello: Hello,
    },
    /// The state changed. It is serialized once for all clients (`Snapshot`).
    State {
        /// The state.
        state: Box<State>,
    },
    /// An event.
    Notice {
        /// The notice.
        notice: Cow<'a, Notice>,
    },
    /// A request was granted.
    Reply {
        /// The number of the request.
        id: u64,
        /// The answer.
        reply: Reply,
    },
    /// A request was refused, or a message was not understood.
    Problem {
        /// The number of the request, if it could be read.
        #[serde(skip_serializing_if = "Option::is_none")]
        id: Option<u64>,
        /// The problem.
        problem: Problem,
    },
}

/// Information for a client that has connected.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Hello {
    /// The client's number.
    pub client: ClientId,
    /// The client's role.
    pub role: Role,
    /// The person the client counts as for time slots: the name of its token if the token belongs
    /// to a person, otherwise the client's name.
    #[serde(default)]
    pub person: String,
    /// The version of the station.
    pub version: String,
    /// The name of the station in its fleet, if it belongs to one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fleet: Option<String>,
    /// The version of the station's page, as in the address of its files.
    #[serde(default)]
    pub page: String,
    /// The dead-man time: how long a jog button stays pressed without a repeated request, in
    /// seconds.
    pub dead_man_s: f64,
}

/// All fields of messages to clients.
#[derive(Deserialize)]
struct ToClientFields {
    hello: Option<Hello>,
    state: Option<Box<State>>,
    notice: Option<Notice>,
    id: Option<u64>,
    reply: Option<Reply>,
    problem: Option<Problem>,
}

/// The kind of a message follows from its fields, so an error inside one is reported as such and
/// not as an unknown message.
impl<'de> Deserialize<'de> for ToClient<'_> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let fields = ToClientFields::deserialize(deserializer)?;
        let hello = fields.hello.map(|hello| Self::Hello { hello });
        let state = fields.state.map(|state| Self::State { state });
        let notice = fields.notice.map(|notice| Self::Notice {
            notice: Cow::Owned(notice),
        });
        let id = fields.id;
        let reply = id
            .zip(fields.reply)
            .map(|(id, reply)| Self::Reply { id, reply });
        let problem = fields.problem.map(|problem| Self::Problem { id, problem });
        hello
            .or(state)
            .or(notice)
            .or(reply)
            .or(problem)
            .ok_or_else(|| de::Error::custom("a message without contents"))
    }
}
