//! Programs that decide: their text, what they compile to, and their mistakes.

use dobot_api::{Answer, NewJob, PendingQuestion, Question};
use dobot_arm::Calibration;
use dobot_teach::{Compiled, NoFiles, Program, ProgramError, continued};
use dobot_wire::Command;

const GO: &str = "[[steps]]\ngo = { x = 200, y = 0, z = 0 }\n";

fn compiled(text: &str, answers: &[&str]) -> Compiled {
    let answers: Vec<Answer> = answers
        .iter()
        .map(|answer| Answer::Choice((*answer).to_owned()))
        .collect();
    Program::from_toml(text)
        .unwrap()
        .compile_answered(&Calibration::NONE, &mut NoFiles, &answers)
        .unwrap()
}

/// The y of all targets.
fn ys(compiled: &Compiled) -> Vec<f32> {
    let y = |command: &Command| match command {
        Command::MoveTo(target) => Some(target.y_mm),
        _ => None,
    };
    compiled.commands.iter().filter_map(y).collect()
}

/// The error of parsing or compiling.
fn error(text: &str) -> String {
    let done = Program::from_toml(text).and_then(|program| program.compile(&mut NoFiles));
    done.unwrap_err().to_string()
}

#[test]
fn a_loop_runs_while_its_variable_allows_it() {
    let text = format!(
        "[variables]\nn = 1\nlast = 3\n{GO}[[steps]]\nwhile = \"n <= last\"\n\
         [[steps.steps]]\ngo = {{ x = 200, y = 10, z = 0 }}\n[[steps.steps]]\nadd = {{ n = 1 }}\n\
         [[steps]]\nset = {{ n = -5 }}\n[[steps]]\nwhile = \"n != -3\"\n\
         [[steps.steps]]\nadd = {{ n = 1 }}\n[[steps.steps]]\ngo = {{ x = 200, y = 20, z = 0 }}\n"
    );
    let compiled = compiled(&text, &[]);
    assert_eq!(ys(&compiled), [0.0, 10.0, 10.0, 10.0, 20.0, 20.0]);
    assert!(!compiled.asks);
}

#[test]
fn a_program_that_cannot_end_is_reported() {
    let never = |steps: &str| {
        error(&format!(
            "[variables]\nn = 0\nm = 0\n{GO}[[steps]]\nwhile = \"n < 5\"\n{steps}"
        ))
    };
    let still = never("[[steps.steps]]\ngo = { x = 200, y = 10, z = 0 }\n");
    assert_eq!(
        still,
        "line 6: the loop never ends: none of its steps changes n; add a step with set or add"
    );
    for away in [
        "[[steps.steps]]\nadd = { n = -1 }\n",
        "[[steps.steps]]\nadd = { m = 1 }\n",
        "[[steps.steps]]\nadd = { m = 1 }\n[[steps.steps]]\ngo = { x = 200, y = 10, z = 0 }\n",
    ] {
        let reason = never(away);
        assert!(reason.contains("the loop has not ended after"), "{reason}");
    }
    let empty = error(&format!(
        "[variables]\nn = 0\n{GO}[[steps]]\nrepeat = \"forever\"\n[[steps.steps]]\nadd = {{ n = 1 }}\n"
    ));
    assert!(
        empty.ends_with("the repeat never ends and sends nothing"),
        "{empty}"
    );
}

const COLOURS: &str = r#"
[[steps]]
go = { x = 200, y = 0, z = 0 }
[[steps]]
repeat = 2
[[steps.steps]]
choose = "Which colour?"
[[steps.steps.when]]
answer = "red"
[[steps.steps.when.steps]]
go = { x = 200, y = 10, z = 0 }
[[steps.steps.when]]
answer = "blue"
[[steps]]
go = { x = 200, y = 90, z = 0 }
"#;

#[test]
fn an_answer_only_adds_commands() {
    let answers = ["red", "blue"];
    let mut longest: Vec<Command> = Vec::new();
    for count in 0..=answers.len() {
        let path = compiled(COLOURS, &answers[..count]);
        assert!(path.commands.starts_with(&longest));
        assert_eq!(path.question.is_some(), count < answers.len());
        assert!(path.asks);
        longest = path.commands;
    }
    assert_eq!(ys(&compiled(COLOURS, &answers)), [0.0, 10.0, 90.0]);
}

#[test]
fn a_job_has_all_that_its_continuation_needs() {
    let program = Program::from_toml(COLOURS).unwrap();
    let compiled = program.compile(&mut NoFiles).unwrap();
    let start = |step| program.job(&compiled, step, &Calibration::NONE, &mut NoFiles);
    let mut job = start(0).unwrap().unwrap();
    for colour in ["blue", "red"] {
        let asking = job.program.asking.take().unwrap();
        let wrong = continued(&asking, Answer::Choice("green".into()), &Calibration::NONE);
        assert_eq!(
            wrong.unwrap_err().to_string(),
            "the answer is \"green\"; allowed: red, blue"
        );
        let longer = continued(&asking, Answer::Choice(colour.into()), &Calibration::NONE);
        let longer = longer.unwrap();
        assert!(longer.commands.starts_with(&job.commands));
        job = longer;
    }
    assert_eq!(job.program.question(), None);
    assert_eq!(
        job.commands,
        self::compiled(COLOURS, &["blue", "red"]).commands
    );
    assert!(start(1).unwrap().is_none());
}

/// The job that starts at a step of the first path, counted from 0.
fn started(text: &str, step: usize) -> Result<Option<NewJob>, ProgramError> {
    let program = Program::from_toml(text).unwrap();
    let arm = Calibration::NONE;
    let paths = program.paths(&arm, &mut NoFiles).unwrap();
    program.job(&paths[0], step, &arm, &mut NoFiles)
}

#[test]
fn a_job_that_starts_after_a_question_counts_it_as_answered_and_asks_the_next_one() {
    // The first path: red, then blue, then the last step.
    let mut job = started(COLOURS, 1).unwrap().unwrap();
    let asking = job.program.asking.take().unwrap();
    assert_eq!(asking.answers, [Answer::Choice("red".into())]);
    assert_eq!(asking.question.as_ref().unwrap().number, 2);
    let y = |command: &Command| match command {
        Command::MoveTo(target) => Some(target.y_mm),
        _ => None,
    };
    let ys = |job: &NewJob| job.commands.iter().filter_map(y).collect::<Vec<_>>();
    assert_eq!(ys(&job), [10.0]);
    let longer = continued(&asking, Answer::Choice("red".into()), &Calibration::NONE);
    assert_eq!(ys(&longer.unwrap()), [10.0, 10.0, 90.0]);
    let last = started(COLOURS, 2).unwrap().unwrap();
    assert_eq!((ys(&last), last.program.question()), (vec![90.0], None));
    assert_eq!(started(COLOURS, 3).unwrap(), None);
}

#[test]
fn a_job_cannot_start_at_a_position_that_nobody_has_given() {
    let text = format!(
        "{GO}[[steps]]\ngo = {{ from = \"bottle\" }}\n[[steps]]\ngo = {{ from = \"cup\" }}\n{GO}"
    );
    for (step, name) in [(1, "bottle"), (2, "cup")] {
        let error = started(&text, step).unwrap_err().to_string();
        let (line, number) = (1 + 2 * step, step + 1);
        assert_eq!(
            error,
            format!(
                "line {line}: step {number} goes to the position {name:?}, which is given while the program runs; start at step 1"
            )
        );
    }
    let job = started(&text, 3).unwrap().unwrap();
    assert_eq!(job.commands.len(), 1);
}

#[test]
fn questions_name_their_answers_and_their_timeout() {
    let text = COLOURS.replace(
        "choose = \"Which colour?\"",
        "choose = \"Which colour?\"\nby = \"seen\"\ntimeout = 2.5\notherwise = \"blue\"",
    );
    let question = compiled(&text, &[]).question.unwrap();
    let PendingQuestion {
        number,
        question,
        timeout_s,
        otherwise,
    } = question;
    assert_eq!(question.to_string(), "Which colour? (red, blue)");
    assert_eq!(
        (number, timeout_s, otherwise),
        (1, Some(2.5), Some(Answer::Choice("blue".into())))
    );
    let given = "[[steps]]\ngo = { x = 200, y = 0, z = 0 }\n[[steps]]\npick = { from = \"cube\", timeout = 3, otherwise = \"skip\" }\n";
    let question = compiled(given, &[]).question.unwrap();
    assert_eq!(
        question.question,
        Question::Place {
            name: "cube".into()
        }
    );
    assert_eq!(question.otherwise, Some(Answer::Skip));
}

#[test]
fn pick_and_place_come_from_above_and_go_up_again() {
    let text = "[[steps]]\npick = { x = 200, y = 0, z = -40 }\n[[steps]]\nplace = { x = 200, y = 50, z = -40 }\napproach = 30\nretreat = 0\n";
    let heights: Vec<(f32, bool)> = compiled(text, &[])
        .commands
        .iter()
        .filter_map(|command| match command {
            Command::MoveTo(target) => Some((target.z_mm, target.suction)),
            _ => None,
        })
        .collect();
    assert_eq!(
        heights,
        [
            (-20.0, false),
            (-40.0, true),
            (-20.0, true),
            (-10.0, true),
            (-40.0, false)
        ]
    );
}

#[test]
fn a_decision_is_written_as_it_was_read() {
    let text = format!(
        "[variables]\nn = 0\n{COLOURS}[[steps]]\nchoose = \"each second one\"\nevery = 2\n\
         [[steps.when]]\nanswer = \"it\"\n[[steps]]\nwhile = \"n < 2\"\n[[steps.steps]]\nadd = {{ n = 1 }}\n\
         [[steps]]\nset = {{ n = 0 }}\n[[steps]]\npick = {{ from = \"cube\", timeout = 3 }}\napproach = 5\n\
         on_missed = {{ by = \"seen\", retries = 2 }}\n[[steps]]\nplace = {{ x = 200, y = 0, z = 0 }}\nsettle = 1\n"
    );
    let program = Program::from_toml(&text).unwrap();
    assert_eq!(
        Program::from_toml(&program.to_toml()).unwrap(),
        program,
        "{}",
        program.to_toml()
    );
}

/// A step after the first motion, and a part of its error.
const BAD: &[(&str, &str)] = &[
    (
        "choose = \"which\"\n",
        "choose has no answers; add them as [[steps.when]]",
    ),
    (
        "choose = \"which\"\n[[steps.when]]\nanswer = \"a\"\n",
        "choose by person has one answer; add another one",
    ),
    (
        "choose = \"which\"\n[[steps.when]]\nanswer = \"a\"\n[[steps.when]]\nanswer = \"a\"\n",
        "the answer \"a\" appears twice",
    ),
    (
        "choose = \"which\"\nevery = 0\n[[steps.when]]\nanswer = \"a\"\n",
        "every is 0; allowed are 1 to 1000000",
    ),
    (
        "choose = \"which\"\nevery = 2\nby = \"seen\"\n[[steps.when]]\nanswer = \"a\"\n",
        "choose has by and every",
    ),
    (
        "choose = \"which\"\notherwise = \"a\"\n[[steps.when]]\nanswer = \"a\"\n",
        "add timeout, in seconds",
    ),
    (
        "choose = \"which\"\ntimeout = 1\notherwise = \"c\"\n[[steps.when]]\nanswer = \"a\"\n[[steps.when]]\nanswer = \"b\"\n",
        "otherwise is \"c\"; allowed: a, b",
    ),
    (
        "while = \"n\"\n[[steps.steps]]\npause = 1\n",
        "while is \"n\"; allowed is a variable, one of < <= = != >= >",
    ),
    (
        "while = \"n + 1 < 2\"\n[[steps.steps]]\npause = 1\n",
        "while is \"n + 1 < 2\"",
    ),
    (
        "while = \"m < 2\"\n[[steps.steps]]\npause = 1\n",
        "there is no variable \"m\"; there are n",
    ),
    (
        "while = \"n < 2\"\n",
        "while has no steps; add at least one",
    ),
    ("set = { m = 1 }\n", "there is no variable \"m\""),
    ("set = {}\n", "set is empty; name a variable"),
    ("add = { n = 0.5 }\n", "a whole number"),
    (
        "pick = { from = \"\" }\n",
        "from is \"\"; allowed is a name of 1 to 40 letters",
    ),
    ("pick = { from = \"a\", x = 1 }\n", "a point has x, from"),
    (
        "pick = { from = \"a\", otherwise = \"skip\" }\n",
        "add timeout, in seconds",
    ),
    (
        "pick = { x = 200, y = 0, z = 0 }\ngripper = 20\n",
        "the mounted tool is a suction cup; remove gripper",
    ),
    (
        "pick = { x = 200, y = 0, z = 0 }\nsuction = true\n",
        "a step has suction beside pick",
    ),
    (
        "place = { x = 200, y = 0, z = 0 }\non_missed = {}\n",
        "a step has on_missed beside place",
    ),
    (
        "arc = { through = { from = \"a\" }, to = { x = 1, y = 2, z = 3 } }\n",
        "allowed in go, pick and place only",
    ),
];

#[test]
fn mistakes_in_decisions_name_the_line_and_what_is_allowed() {
    for (step, expected) in BAD {
        let text = format!("[variables]\nn = 0\n{GO}[[steps]]\n{step}");
        let found = error(&text);
        assert!(found.contains(expected), "{step}: {found}");
        assert!(found.starts_with("line "), "{step}: {found}");
    }
    let laser = error(&format!(
        "{GO}[[steps]]\nlaser = true\n[[steps]]\ngo = {{ from = \"mark\" }}\n"
    ));
    assert!(
        laser.contains("the laser is on while the program asks"),
        "{laser}"
    );
    let first = error(
        "[[steps]]\nchoose = \"which\"\n[[steps.when]]\nanswer = \"a\"\n[[steps.when]]\nanswer = \"b\"\n",
    );
    assert!(
        first.contains("the first question comes before the first motion"),
        "{first}"
    );
}

#[test]
fn common_mistakes_are_shown_with_the_correct_line() {
    for (text, expected) in [
        (
            "[[steps]]\ngo = { x = 200,5, y = -0,25, z = 30 }\npause = 0,5\n",
            "line 2: the number 200,5 has a decimal comma; write 200.5, with a point | line 2: the number -0,25 has a decimal comma; write -0.25, with a point | line 3: the number 0,5 has a decimal comma; write 0.5, with a point",
        ),
        (
            "[[steps]]\nspeed = 50\n[[steps]]\nrepeat = 2\n[[steps.steps]]\ndrawing = \"a.svg\"\n",
            "line 2: speed needs a table; write speed = { percent = 50 } | line 6: drawing needs a table; write drawing = { file = \"a.svg\", pen_down = HEIGHT }, with the height of the wrist in mm",
        ),
        (
            "[[steps]]\ngo = { x = 200, y = 0, z = 30 }\npth = \"movl\"\n[[steps]]\nchoice = \"x\"\n",
            "line 3: the key `pth` is unknown; did you mean `path`? | line 5: the key `choice` is unknown; did you mean `choose`?",
        ),
        (
            "[points]\nhome = { x = 200, y = 0, z = 30 }\n[[steps]]\ngo = \"hoem\"\n[[steps]]\ngo = \"home\"\n",
            "line 3: there is no point \"hoem\"; did you mean \"home\"?",
        ),
        (
            "[[steps]]\ngo = { X = 200, y = 0, z = 30 }\n",
            "line 2: the key `X` is unknown; did you mean `x`?",
        ),
        (
            "[[steps]]\npick = { x = 200, y = 0, z = 30 }\non_missed = \"again\"\n[[steps]]\nadd = { n = 1 }\n",
            "line 3: on_missed needs a table; write on_missed = { by = \"person\", retries = 2 } | line 4: there is no variable \"n\"; the program has none: add n = 0 under [variables]",
        ),
    ] {
        let found = error(text);
        assert!(found.starts_with(expected), "{found}");
    }
}

#[test]
fn a_marker_that_is_seen_is_asked_for_by_its_number() {
    let text = format!("{GO}[[steps]]\ngo = {{ from = \"seen\", marker = 7, timeout = 2 }}\n");
    let program = Program::from_toml(&text).unwrap();
    let path = compiled(&text, &[]);
    let asked = path.question.unwrap();
    assert_eq!(
        asked.question,
        Question::Place {
            name: "marker 7".into()
        }
    );
    assert_eq!(asked.timeout_s, Some(2.0));
    assert_eq!(Program::from_toml(&program.to_toml()).unwrap(), program);
}

#[test]
fn a_position_that_is_seen_needs_a_marker_for_objects() {
    for (place, expected) in [
        ("{ from = \"seen\" }", "add the marker that is looked for"),
        (
            "{ from = \"cube\", marker = 7 }",
            "from is \"cube\"; allowed is \"seen\"",
        ),
        (
            "{ from = \"seen\", marker = 3 }",
            "marker is 3; allowed are 4 to 49",
        ),
        ("{ x = 200, y = 0, z = 0, marker = 7 }", "a point has"),
    ] {
        let error = Program::from_toml(&format!("[[steps]]\ngo = {place}\n")).unwrap_err();
        assert!(error.to_string().contains(expected), "{place}: {error}");
    }
}
