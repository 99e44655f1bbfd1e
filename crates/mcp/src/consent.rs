//! The consent of the person who uses the agent, where the agent's program can ask for it (elicitation).

use std::collections::BTreeMap;
use std::sync::OnceLock;
use std::time::Duration;

use dobot_api::Role;
use dobot_host::StationClient;
use dobot_supervisor::plain;
use rmcp::model::{
    CallToolRequestParams, ClientResult, ElicitRequest, ElicitRequestParams, ElicitationAction,
    ElicitationSchema, InputRequest, InputRequiredResult, ProtocolVersion, ServerRequest,
};
use serde_json::Value;
use tokio::time::timeout;

use crate::call::Call;
use crate::http::Visit;
use crate::refused::Refused;

/// The answer to a question, and the question that this call has to ask first. Since its version 2026-07-28 the protocol
/// has no questions during a call: the call ends with the question, and is made again with the answer.
#[derive(Debug, Default)]
pub(crate) struct Questions {
    answered: Option<(String, Value)>,
    to_ask: OnceLock<String>,
}

impl Questions {
    pub(crate) fn new(request: &CallToolRequestParams) -> Self {
        let answers = request.input_responses.as_ref();
        let answer = answers.and_then(|answers| answers.get(QUESTION).cloned());
        Self {
            answered: request.request_state.clone().zip(answer),
            to_ask: OnceLock::new(),
        }
    }

    /// Returns the result of a call that has to ask first.
    pub(crate) fn to_ask(&self) -> Option<InputRequiredResult> {
        let what = self.to_ask.get()?;
        let request = InputRequest::Elicitation(ElicitRequest::new(question(what)));
        let requests = BTreeMap::from([(QUESTION.to_owned(), request)]);
        Some(InputRequiredResult::new(Some(requests), Some(what.clone())))
    }

    /// Returns the answer, if it is one to this question.
    fn answer(&self, what: &str) -> Option<bool> {
        let (asked, answer) = self.answered.as_ref()?;
        (asked == what).then(|| answer["action"] == "accept")
    }
}

/// Asks whether something may be done, such as `move the arm`.
fn question(what: &str) -> ElicitRequestParams {
    ElicitRequestParams::FormElicitationParams {
        meta: None,
        message: format!(
            "May the agent {what}? Look at the arm first: nobody may be near it, and nothing in its way."
        ),
        requested_schema: ElicitationSchema::new(BTreeMap::new()),
    }
}

impl Call {
    /// Asks the person who started this program whether something may be done: `None` if the agent's
    /// program cannot ask. Over HTTP nobody is asked: nobody there has set up the agent at this
    /// station.
    ///
    /// # Errors
    ///
    /// `needs-a-person` if the person has not allowed it.
    async fn consent(&self, station: &StationClient, what: &str) -> Result<Option<()>, Refused> {
        let is_remote = Visit::of(&self.context.extensions).is_some();
        if is_remote || station.role() == Role::Queue || !self.can_ask() {
            return Ok(None);
        }
        let version = self.context.protocol_version();
        let is_allowed = if version.is_some_and(|version| version >= ProtocolVersion::V_2026_07_28)
        {
            self.questions.answer(what).ok_or_else(|| {
                let _ = self.questions.to_ask.set(what.to_owned());
                Refused::new("needs-a-person", "the person has to be asked first")
            })?
        } else {
            self.ask(what).await?
        };
        if is_allowed {
            return Ok(Some(()));
        }
        let text = format!("the person did not let the agent {what}");
        Err(Refused::new("needs-a-person", text).hinted("ask the person what to do instead"))
    }

    /// Asks during the call; no answer in time is a refusal.
    async fn ask(&self, what: &str) -> Result<bool, Refused> {
        let request = ServerRequest::ElicitRequest(ElicitRequest::new(question(what)));
        match timeout(PATIENCE, self.context.peer.send_request(request)).await {
            Ok(Ok(ClientResult::ElicitResult(answer))) => {
                Ok(answer.action == ElicitationAction::Accept)
            }
            Ok(other) => Err(Refused::new(
                "needs-a-person",
                format!("the agent's program did not ask the person: {other:?}"),
            )),
            Err(_) => Ok(false),
        }
    }

    /// Whether the agent's program can show a person a question.
    fn can_ask(&self) -> bool {
        let capabilities = self.context.client_capabilities();
        let asks = capabilities.and_then(|capabilities| capabilities.elicitation);
        // One that names no kind of question has the first one, forms.
        asks.is_some_and(|asks| asks.form.is_some() || asks.url.is_none())
    }

    /// Whether a job that is to be queued may be started at once; otherwise it waits for a person.
    ///
    /// # Errors
    ///
    /// `needs-a-person` if a person was asked and has not allowed it.
    pub(crate) async fn may_start(
        &self,
        station: &StationClient,
        what: &str,
    ) -> Result<bool, Refused> {
        Ok(!self.asks(station) || self.consent(station, what).await?.is_some())
    }

    /// Checks that the agent may move the arm; a person may have to allow it.
    ///
    /// # Errors
    ///
    /// `needs-a-person`.
    pub(crate) async fn check_may_move(
        &self,
        station: &StationClient,
        what: &str,
    ) -> Result<(), Refused> {
        if self.may_start(station, what).await? {
            return Ok(());
        }
        Err(Refused::new(
            "needs-a-person",
            "agents may move the arm only with drawings and programs, and a person has to start each of them",
        )
        .hinted("queue a drawing with `draw` or a program with `run_program`; a person starts it on the station's page"))
    }
}

/// Returns a title for a question: the agent may have made it up.
pub(crate) fn short(title: &str) -> String {
    plain(title, TITLE_LENGTH)
}

/// The name of the only question of a call.
const QUESTION: &str = "consent";
/// The maximum length of a title in a question.
const TITLE_LENGTH: usize = 60;
/// The time that a person has for an answer.
const PATIENCE: Duration = Duration::from_secs(120);

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn questions(state: &str, answer: Value) -> Questions {
        let mut request = CallToolRequestParams::new("move_to");
        request.request_state = Some(state.to_owned());
        request.input_responses = Some(BTreeMap::from([(QUESTION.to_owned(), answer)]));
        Questions::new(&request)
    }

    #[test]
    fn only_an_accepted_answer_to_the_same_question_allows_anything() {
        let accepted = json!({ "action": "accept", "content": {} });
        assert_eq!(questions("go", accepted.clone()).answer("go"), Some(true));
        assert_eq!(questions("go", accepted).answer("go farther"), None);
        for other in [json!({ "action": "decline" }), json!({}), json!("accept")] {
            assert_eq!(questions("go", other).answer("go"), Some(false));
        }
        let call = Questions::new(&CallToolRequestParams::new("move_to"));
        assert_eq!(call.answer("go"), None);
    }

    #[test]
    fn a_question_names_what_the_agent_wants_and_has_no_fields() {
        let call = Questions::default();
        assert!(call.to_ask().is_none());
        call.to_ask
            .set("draw \"a house\"".to_owned())
            .expect("it is the first");
        let asked = json!(call.to_ask().expect("it has to ask"));
        assert_eq!(asked["requestState"], "draw \"a house\"");
        let params = &asked["inputRequests"][QUESTION]["params"];
        let message = params["message"].as_str().expect("a text");
        assert!(
            message.starts_with("May the agent draw \"a house\"?"),
            "{message}"
        );
        assert_eq!(params["requestedSchema"]["properties"], json!({}));
    }
}
