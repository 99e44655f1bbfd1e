//! The messages of the WebSocket.

use std::borrow::Cow;

use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, de};

use crate::{ClientId, Notice, Problem, Reply, Request, Role, State};

/// What a client sends over the WebSocket.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FromClient {
    /// A number by which the client recognises the answer.
    pub id: u64,
    /// What it asks for.
    pub request: Request,
}

/// What the station sends over the WebSocket.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum ToClient<'a> {
    /// The first message.
    Hello {
        /// What the client has to know.
        hello: Hello,
    },
    /// The state changed. It is written once for all clients (`Snapshot`).
    State {
        /// The state.
        state: Box<State>,
    },
    /// Something happened.
    Notice {
        /// What.
        notice: Cow<'a, Notice>,
    },
    /// A request was granted.
    Reply {
        /// The number of the request.
        id: u64,
        /// The answer.
        reply: Reply,
    },
    /// A request was refused, or a message not understood.
    Problem {
        /// The number of the request, if it could be read.
        #[serde(skip_serializing_if = "Option::is_none")]
        id: Option<u64>,
        /// What is wrong.
        problem: Problem,
    },
}

/// What a client has to know.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Hello {
    /// The client's number.
    pub client: ClientId,
    /// What it may do.
    pub role: Role,
    /// By which name time slots know it: that of its token where this is one person's, or else what the client calls itself.
    #[serde(default)]
    pub person: String,
    /// The version of the station.
    pub version: String,
    /// How long a jog button stays pressed without being said again, in seconds.
    pub dead_man_s: f64,
}

/// A message whose contents are told by which of its fields are there: what is wrong with one of them is
/// told as such, and not as a message of no kind.
impl<'de> Deserialize<'de> for ToClient<'_> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        struct Fields {
            hello: Option<Hello>,
            state: Option<Box<State>>,
            notice: Option<Notice>,
            id: Option<u64>,
            reply: Option<Reply>,
            problem: Option<Problem>,
        }
        let it = Fields::deserialize(deserializer)?;
        let hello = it.hello.map(|hello| Self::Hello { hello });
        let state = it.state.map(|state| Self::State { state });
        let notice = it.notice.map(|it| Self::Notice {
            notice: Cow::Owned(it),
        });
        let id = it.id;
        let reply = id
            .zip(it.reply)
            .map(|(id, reply)| Self::Reply { id, reply });
        let problem = it.problem.map(|problem| Self::Problem { id, problem });
        hello
            .or(state)
            .or(notice)
            .or(reply)
            .or(problem)
            .ok_or_else(|| de::Error::custom("a message without contents"))
    }
}
