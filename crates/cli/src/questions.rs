//! Questions of a running program, asked in a terminal.

use std::io::IsTerminal;

use crate::failure::Failure;
use anyhow::anyhow;
use dobot_api::{Answer, GivenPlace, PendingQuestion, Question, Request};
use dobot_host::StationClient;
use indicatif::ProgressBar;
use tokio::io::{AsyncBufReadExt, BufReader, Lines, Stdin};

/// The questions of a job, and the person at the terminal.
pub(crate) struct Questions {
    job: u64,
    asked: Option<PendingQuestion>,
    /// The number of the last question that got its answer here: states may still show it.
    answered: Option<u64>,
    lines: Option<Lines<BufReader<Stdin>>>,
    is_terminal: bool,
}

impl Questions {
    pub(crate) fn of(job: u64) -> Self {
        Self {
            job,
            asked: None,
            answered: None,
            lines: None,
            is_terminal: std::io::stdin().is_terminal(),
        }
    }

    /// Handles the question of a new state; a new one is printed.
    pub(crate) fn handle(&mut self, question: Option<&PendingQuestion>, bar: &ProgressBar) {
        let question = question.filter(|pending| Some(pending.number) != self.answered);
        if self.asked.as_ref() == question {
            return;
        }
        self.asked = question.cloned();
        let Some(pending) = question else {
            return;
        };
        let text = self.text(&pending.question);
        bar.suspend(|| eprintln!("{text}"));
    }

    /// Returns whether a person is asked.
    pub(crate) const fn waits_for_line(&self) -> bool {
        self.is_terminal && self.asked.is_some()
    }

    /// Returns the failure if nobody can answer, because the arm is in this process.
    pub(crate) fn unanswerable(&self) -> Option<Failure> {
        let pending = self.asked.as_ref().filter(|_| !self.is_terminal)?;
        if pending.otherwise.is_some() {
            return None;
        }
        Some(Failure::new(
            anyhow!("the program asks: {}", pending.question),
            "run it in a terminal, or on a station (`dobot up`), where others can answer",
        ))
    }

    /// The text that asks the person, or says how to answer from elsewhere.
    fn text(&self, question: &Question) -> String {
        let job = self.job;
        let how = match (self.is_terminal, question) {
            (true, Question::Choice { .. }) => "type an answer and Enter".to_owned(),
            (true, _) => "type x y z in mm and Enter".to_owned(),
            (false, Question::Choice { .. }) => {
                format!("answer with `dobot jobs answer {job} ANSWER`")
            }
            (false, _) => format!("give it with `dobot jobs answer {job} --at X Y Z`"),
        };
        format!("job {job} asks: {question}; {how}")
    }

    /// Waits for a line of the person; forever if there is no question or no terminal.
    pub(crate) async fn line(&mut self) -> Option<String> {
        if !self.waits_for_line() {
            return std::future::pending().await;
        }
        let lines = self
            .lines
            .get_or_insert_with(|| BufReader::new(tokio::io::stdin()).lines());
        if let Ok(line) = lines.next_line().await {
            return line;
        }
        None
    }

    /// Sends the answer of the person, and reports why it is refused.
    pub(crate) async fn answer(
        &mut self,
        station: &mut StationClient,
        line: Option<String>,
        bar: &ProgressBar,
    ) {
        let Some(line) = line else {
            // The terminal is closed.
            self.is_terminal = false;
            return;
        };
        let Some(pending) = self.asked.as_ref() else {
            return;
        };
        let answer = parse(&pending.question, &line);
        let sent = match answer {
            Ok(answer) => {
                let request = Request::AnswerJob {
                    job: self.job,
                    question: Some(pending.number),
                    answer,
                };
                let sent = station.request(request).await;
                sent.map(drop).map_err(|error| error.to_string())
            }
            Err(reason) => Err(reason),
        };
        match sent {
            Ok(()) => {
                self.answered = self.asked.take().map(|pending| pending.number);
            }
            Err(reason) => bar.suspend(|| eprintln!("{reason}")),
        }
    }
}

/// Parses an answer to a question: one of the answers, or x, y, z and perhaps the rotation.
pub(crate) fn parse(question: &Question, text: &str) -> Result<Answer, String> {
    let text = text.trim();
    match question {
        Question::Choice { answers, .. } => {
            let same = |answer: &&String| answer.to_lowercase() == text.to_lowercase();
            let found = answers.iter().find(same);
            let found = found.ok_or_else(|| {
                format!("the answer is {text:?}; allowed: {}", answers.join(", "))
            })?;
            Ok(Answer::Choice(found.clone()))
        }
        Question::Place { .. } => place(text),
        Question::NextCycle => Ok(Answer::NextCycle),
    }
}

fn place(text: &str) -> Result<Answer, String> {
    let numbers: Result<Vec<f64>, _> = text.split_whitespace().map(str::parse).collect();
    match numbers.as_deref() {
        Ok([x_mm, y_mm, z_mm, rest @ ..]) if rest.len() < 2 => Ok(Answer::Place(GivenPlace {
            name: None,
            x_mm: *x_mm,
            y_mm: *y_mm,
            z_mm: *z_mm,
            rotation_deg: rest.first().copied().unwrap_or(0.0),
            sense: None,
        })),
        _ => Err(format!(
            "the position is {text:?}; allowed are x, y and z in mm, and the rotation in degrees, for example: 200 50 -20"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dobot_api::AnsweredBy;

    #[test]
    fn answers_are_found_in_any_case_and_others_are_refused_with_the_allowed_ones() {
        let question = Question::Choice {
            text: "Which colour?".into(),
            answers: vec!["red".into(), "Blue".into()],
            by: AnsweredBy::Person,
        };
        let answer = parse(&question, " BLUE\n");
        assert_eq!(answer, Ok(Answer::Choice("Blue".into())));
        let refused = parse(&question, "").expect_err("it is no answer");
        assert_eq!(refused, "the answer is \"\"; allowed: red, Blue");
    }

    #[test]
    fn a_position_is_three_numbers_and_perhaps_a_rotation() {
        let question = Question::Place {
            name: "cube".into(),
        };
        let place = |rotation_deg| {
            Answer::Place(GivenPlace {
                name: None,
                x_mm: 200.0,
                y_mm: -5.5,
                z_mm: 0.0,
                rotation_deg,
                sense: None,
            })
        };
        assert_eq!(parse(&question, "200 -5.5 0\n"), Ok(place(0.0)));
        assert_eq!(parse(&question, "200 -5.5 0 30"), Ok(place(30.0)));
        for wrong in ["", "200 0", "200,0,0", "1 2 3 4 5", "here"] {
            parse(&question, wrong).expect_err("it is no position");
        }
    }
}
