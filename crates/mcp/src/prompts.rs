//! Prompts that a person selects.

use rmcp::ErrorData;
use rmcp::model::{
    GetPromptRequestParams, GetPromptResult, Prompt, PromptArgument, PromptMessage, Role,
};

/// Returns all prompts.
pub(crate) fn list() -> Vec<Prompt> {
    let row = |(name, title, description, argument, about): (&str, &str, &str, &str, &str)| {
        let argument = PromptArgument::new(argument)
            .with_description(about)
            .with_required(true);
        Prompt::new(name, Some(description), Some(vec![argument])).with_title(title)
    };
    ROWS.map(row).into()
}

const ROWS: [(&str, &str, &str, &str, &str); 2] = [
    (
        "draw",
        "Draw this",
        "Plans a drawing, shows it, and draws it",
        "what",
        "What to draw",
    ),
    (
        "sort",
        "Sort these",
        "Moves objects to their places",
        "how",
        "The objects and where each of them belongs",
    ),
];

/// Returns a prompt with its argument.
pub(crate) fn get(request: &GetPromptRequestParams) -> Result<GetPromptResult, ErrorData> {
    let row = ROWS.iter().find(|(name, ..)| *name == request.name);
    let Some((name, _, description, argument, _)) = row else {
        let text = format!(
            "there is no prompt `{}`; there are draw, sort",
            request.name
        );
        return Err(ErrorData::invalid_params(text, None));
    };
    let given = request
        .arguments
        .as_ref()
        .and_then(|given| given.get(*argument)?.as_str());
    let Some(given) = given else {
        let text = format!("the prompt `{name}` needs the argument `{argument}`, a text");
        return Err(ErrorData::invalid_params(text, None));
    };
    let text = text(name, given);
    let message = PromptMessage::new_text(Role::User, text);
    Ok(GetPromptResult::new(vec![message]).with_description(*description))
}

fn text(name: &str, given: &str) -> String {
    match name {
        "draw" => format!(
            "Draw this with the arm: {given}\n\nCall `look`. Make it a text or an SVG document of simple strokes, and call `plan_drawing`. \
             Show the picture with duration and warnings, and ask whether to draw it. Then call `draw`."
        ),
        _ => format!(
            "Sort these objects with the arm: {given}\n\nCall `look`, and read the resources dobot://world and dobot://program. Write a program, \
             and call `check_program` until there are no problems. Show its steps and ask whether to run it. Then call `run_program`."
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_prompt_contains_what_the_person_wants_and_needs_it() {
        let mut request = GetPromptRequestParams::new("draw");
        let error = get(&request).expect_err("an argument is missing");
        assert!(error.message.contains("`what`"), "{error}");
        let arguments = serde_json::json!({ "what": "a house" });
        request.arguments = arguments.as_object().cloned();
        let prompt = serde_json::json!(get(&request).expect("a prompt"));
        assert!(
            prompt["messages"][0]["content"]["text"]
                .as_str()
                .expect("a text")
                .contains("a house")
        );
        assert_eq!(list().len(), 2);
    }
}
