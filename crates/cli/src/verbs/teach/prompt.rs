//! The prompts of `dobot teach`, as an engine: questions, and the answers of a person.

use std::mem;

use crossterm::event::KeyCode;
use dobot_arm::Tool;
use dobot_teach::{GridSize, MountedTool, Program, RecordedPlace, Times};

use super::lesson::TouchedGrid;

/// A question to the person, with what was answered so far.
#[derive(Debug)]
pub(crate) struct Prompt {
    question: Question,
    /// The text so far.
    text: String,
}

/// What the person has taught with a prompt.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Answer {
    /// Another name for a point.
    Rename { from: String, to: String },
    /// A repeat begins.
    Repeat(Times),
    /// A tool is mounted.
    Tool(MountedTool),
    /// A grid.
    Grid(TouchedGrid),
    /// A frame: its origin, a point on its x axis, and one on the side of its y axis.
    Frame(String, [RecordedPlace; 3]),
    /// The next points are taught in this frame; `None` for the base frame.
    UseFrame(Option<String>),
    /// Another program is called.
    Call(String),
}

/// The result of a key or of a place.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Outcome {
    /// The prompt waits for more.
    Asks,
    /// The input is not allowed: where, what was found, what is allowed.
    Refused(String),
    /// The current position is wanted: see [`Prompt::handle_place`].
    WantsPlace,
    /// Everything is answered. The prompt keeps its answers until the program has accepted them.
    Answered(Answer),
    /// The person went back before the first question.
    Cancelled,
}

/// How a question is answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Input {
    /// With one letter.
    Choice,
    /// With a text.
    Text,
    /// With the arm: Enter takes its position.
    Place,
}

#[derive(Clone, Debug)]
enum Question {
    /// What to add. The point that can be named, if there is one.
    What(Option<String>),
    /// The name of this point.
    PointName(String),
    Times,
    Tool,
    Length(Tool),
    Name(Shape),
    /// Whether to use this frame or to teach it again.
    KnownFrame(String),
    Place {
        shape: Shape,
        name: String,
        touched: Vec<RecordedPlace>,
    },
    Size {
        name: String,
        corners: [RecordedPlace; 3],
    },
    LayerPitch {
        name: String,
        corners: [RecordedPlace; 3],
        size: GridSize,
    },
    Call,
}

impl Question {
    const fn first_place(shape: Shape, name: String) -> Self {
        Self::Place {
            shape,
            name,
            touched: Vec::new(),
        }
    }

    /// Returns which letters an answer may have, and their description.
    fn letters(&self) -> (fn(char) -> bool, &'static str) {
        match self {
            Self::Times => (|letter| letter.is_ascii_digit(), "digits"),
            Self::Length(_) => (
                |letter| letter.is_ascii_digit() || letter == '.',
                "digits and .",
            ),
            Self::Size { .. } => (
                |letter| letter.is_ascii_digit() || letter == 'x',
                "digits and x",
            ),
            Self::LayerPitch { .. } => (
                |letter| letter.is_ascii_digit() || letter == '.' || letter == '-',
                "digits, . and -",
            ),
            Self::Call => (|letter| !letter.is_control(), "letters"),
            _ => (
                |letter| letter.is_alphanumeric() || letter == '_' || letter == '-',
                "letters, digits, _ and -",
            ),
        }
    }
}

/// What is taught by three places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shape {
    Grid,
    Frame,
}

impl Prompt {
    /// Asks what to add; `point` is the point that can be named.
    pub(crate) const fn new(point: Option<String>) -> Self {
        Self {
            question: Question::What(point),
            text: String::new(),
        }
    }

    /// How the question is answered.
    pub(crate) const fn input(&self) -> Input {
        match self.question {
            Question::What(_) | Question::Tool | Question::KnownFrame(_) => Input::Choice,
            Question::Place { .. } => Input::Place,
            _ => Input::Text,
        }
    }

    /// The text so far.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// Handles a key that neither stops nor moves the arm. The program has the names that are known.
    pub(crate) fn handle_key(&mut self, key: KeyCode, program: &Program) -> Outcome {
        match (key, self.input()) {
            (KeyCode::Backspace | KeyCode::Delete, _) => self.go_back(),
            (KeyCode::Char(letter), Input::Choice) => self.choose(letter.to_ascii_lowercase()),
            (KeyCode::Char(letter), Input::Text) => self.write(letter),
            (KeyCode::Enter, Input::Text) => self.accept(program),
            (KeyCode::Enter, Input::Place) => Outcome::WantsPlace,
            _ => Outcome::Asks,
        }
    }

    /// Handles pasted text: its letters up to the end of the first line, as if they were typed.
    pub(crate) fn handle_paste(&mut self, text: &str) -> Outcome {
        if self.input() != Input::Text {
            return Outcome::Refused("pasted text was ignored; this question has no text".into());
        }
        let line = text.trim().lines().next().unwrap_or_default();
        let written = line.chars().filter(|letter| !letter.is_whitespace());
        written.fold(Outcome::Asks, |before, letter| match self.write(letter) {
            Outcome::Asks => before,
            refused => refused,
        })
    }

    /// Handles the position of the arm after [`Outcome::WantsPlace`].
    pub(crate) fn handle_place(&mut self, place: RecordedPlace) -> Outcome {
        let Question::Place {
            shape,
            name,
            touched,
        } = &mut self.question
        else {
            return Outcome::Asks;
        };
        if let Some(at) = touched.iter().position(|other| is_near(other, &place)) {
            return Outcome::Refused(format!(
                "the arm is less than {NEAR_MM} mm from {}; jog to {}",
                shape.places()[at],
                shape.places()[touched.len()]
            ));
        }
        touched.push(place);
        let [first, second, third] = touched[..] else {
            return Outcome::Asks;
        };
        let places = [first, second, third];
        match shape {
            Shape::Frame => {
                // Kept until the program has accepted it: then Enter takes the third place again.
                touched.pop();
                Outcome::Answered(Answer::Frame(name.clone(), places))
            }
            Shape::Grid => {
                let name = mem::take(name);
                self.ask(Question::Size {
                    name,
                    corners: places,
                })
            }
        }
    }

    fn ask(&mut self, question: Question) -> Outcome {
        self.question = question;
        self.text.clear();
        Outcome::Asks
    }

    /// Removes a letter, or goes back to the previous question.
    fn go_back(&mut self) -> Outcome {
        if self.text.pop().is_some() {
            return Outcome::Asks;
        }
        let before = match self.question.clone() {
            Question::Length(_) => Question::Tool,
            Question::KnownFrame(_) => Question::Name(Shape::Frame),
            Question::Place {
                shape,
                name,
                touched,
            } => before_place(shape, name, touched),
            Question::Size { name, corners } => Question::Place {
                shape: Shape::Grid,
                name,
                touched: corners[..2].to_vec(),
            },
            Question::LayerPitch { name, corners, .. } => Question::Size { name, corners },
            _ => return Outcome::Cancelled,
        };
        self.ask(before)
    }

    fn choose(&mut self, letter: char) -> Outcome {
        let next = match (&self.question, letter) {
            (Question::What(Some(point)), 'n') => Question::PointName(point.clone()),
            (Question::What(None), 'n') => {
                return Outcome::Refused(
                    "no point can be named: no step up to the selected one goes to a point".into(),
                );
            }
            (Question::What(_), 'r') => Question::Times,
            (Question::What(_), 't') => Question::Tool,
            (Question::What(_), 'g') => Question::Name(Shape::Grid),
            (Question::What(_), 'f') => Question::Name(Shape::Frame),
            (Question::What(_), 'c') => Question::Call,
            (Question::Tool, letter) => match tool_of(letter) {
                Some(tool) => Question::Length(tool),
                None => return self.refuse_choice(letter),
            },
            (Question::KnownFrame(name), 'u') => {
                return Outcome::Answered(Answer::UseFrame(Some(name.clone())));
            }
            (Question::KnownFrame(name), 't') => Question::first_place(Shape::Frame, name.clone()),
            _ => return self.refuse_choice(letter),
        };
        self.ask(next)
    }

    fn refuse_choice(&self, letter: char) -> Outcome {
        let choices = self.choices();
        let allowed: Vec<&str> = choices.iter().map(|(key, _)| *key).collect();
        Outcome::Refused(format!(
            "{letter} is no choice; allowed are {}, or Backspace to go back",
            allowed.join(" ")
        ))
    }

    fn write(&mut self, letter: char) -> Outcome {
        let (is_allowed, allowed) = self.question.letters();
        if !is_allowed(letter) {
            return Outcome::Refused(format!(
                "{letter:?} is not allowed here; allowed are {allowed}"
            ));
        }
        if self.text.chars().count() >= MAX_LEN {
            return Outcome::Refused(format!("the text has {MAX_LEN} letters, the most allowed"));
        }
        self.text.push(letter);
        Outcome::Asks
    }

    fn accept(&mut self, program: &Program) -> Outcome {
        let text = self.text.as_str();
        let answered = match &self.question {
            Question::PointName(from) => point_name(text, from, program).map(|to| Answer::Rename {
                from: from.clone(),
                to,
            }),
            Question::Times => times(text).map(Answer::Repeat),
            Question::Length(kind) => length(text).map(|length| {
                let kind = *kind;
                Answer::Tool(MountedTool { kind, length })
            }),
            Question::Size { name, corners } => match text.parse::<GridSize>() {
                Ok(size) if size.layers > 1 => {
                    let (name, corners) = (name.clone(), *corners);
                    return self.ask(Question::LayerPitch {
                        name,
                        corners,
                        size,
                    });
                }
                Ok(size) => Ok(touched_grid(name, corners, size)),
                Err(reason) => Err(reason),
            },
            Question::LayerPitch {
                name,
                corners,
                size,
            } => layer_mm(text).map(|layer_mm| {
                let size = GridSize { layer_mm, ..*size };
                touched_grid(name, corners, size)
            }),
            Question::Call if text.is_empty() => {
                Err("the name is empty; enter the file of a program, for example lid.toml".into())
            }
            Question::Call => Ok(Answer::Call(text.to_owned())),
            Question::Name(Shape::Frame) if text.is_empty() => Ok(Answer::UseFrame(None)),
            Question::Name(shape) => {
                let shape = *shape;
                return match shape_name(shape, text, program) {
                    Ok(question) => self.ask(question),
                    Err(reason) => Outcome::Refused(reason),
                };
            }
            _ => return Outcome::Asks,
        };
        answered.map_or_else(Outcome::Refused, Outcome::Answered)
    }

    /// The letters that answer a question, with their meaning.
    pub(crate) fn choices(&self) -> &'static [(&'static str, &'static str)] {
        match self.question {
            Question::What(_) => &[
                ("n", "name of the point"),
                ("r", "repeat"),
                ("t", "tool"),
                ("g", "grid"),
                ("f", "frame"),
                ("c", "call"),
            ],
            Question::Tool => &[
                ("c", "suction cup"),
                ("g", "gripper"),
                ("p", "pen"),
                ("l", "laser"),
            ],
            Question::KnownFrame(_) => &[("u", "use it"), ("t", "teach its points again")],
            _ => &[],
        }
    }

    /// The question as a text.
    pub(crate) fn question(&self) -> String {
        match &self.question {
            Question::What(_) => "add what?".into(),
            Question::PointName(from) => format!("new name of point {from}:"),
            Question::Times => format!("repeat how often? 1 to {MAX_TIMES} times, 0: forever"),
            Question::Tool => "which tool is mounted?".into(),
            Question::Length(tool) => format!(
                "{}: length from the wrist down to the tip, 0 to {MAX_LENGTH_MM} mm (0: teach the wrist):",
                tool.label()
            ),
            Question::Name(Shape::Grid) => "name of the grid, for example tray:".into(),
            Question::Name(Shape::Frame) => {
                "name of the frame (nothing: teach points in the base frame):".into()
            }
            Question::KnownFrame(name) => format!("frame {name} exists:"),
            Question::Place {
                shape,
                name,
                touched,
            } => format!(
                "{} {name}, place {} of 3: jog to {}, then press Enter",
                shape.name(),
                touched.len() + 1,
                shape.places()[touched.len().min(2)]
            ),
            Question::Size { name, .. } => {
                format!(
                    "grid {name}: cells in the first row x rows, for example 3x4, or x layers: 3x4x2:"
                )
            }
            Question::LayerPitch { name, .. } => format!(
                "grid {name}: from a layer to the next one, in mm upwards (-20: 20 mm down, from the top of a stack):"
            ),
            Question::Call => "program to call, a file beside this one:".into(),
        }
    }
}

impl Shape {
    const fn name(self) -> &'static str {
        match self {
            Self::Grid => "grid",
            Self::Frame => "frame",
        }
    }

    /// The places to touch.
    const fn places(self) -> [&'static str; 3] {
        match self {
            Self::Grid => [
                "the first cell",
                "the end of the first row",
                "the end of the first column",
            ],
            Self::Frame => [
                "the origin",
                "a place on the x axis",
                "a place on the side of the y axis",
            ],
        }
    }
}

/// Checks the new name of a point.
fn point_name(name: &str, from: &str, program: &Program) -> Result<String, String> {
    check_name(name)?;
    if name != from {
        is_free(name, "point", program.points.contains_key(name))?;
        is_free(name, "grid", program.grids.contains_key(name))?;
    }
    Ok(name.to_owned())
}

/// Checks the name of a grid or of a frame, and returns the next question.
fn shape_name(shape: Shape, name: &str, program: &Program) -> Result<Question, String> {
    check_name(name)?;
    let has_frame = program.frames.contains_key(name);
    if shape == Shape::Frame && has_frame {
        return Ok(Question::KnownFrame(name.to_owned()));
    }
    if shape == Shape::Grid {
        is_free(name, "point", program.points.contains_key(name))?;
        // The grid gets a frame of its name.
        is_free(
            name,
            "frame",
            has_frame && !program.grids.contains_key(name),
        )?;
    }
    Ok(Question::first_place(shape, name.to_owned()))
}

/// Returns the question before the next place: without places that for the name.
fn before_place(shape: Shape, name: String, mut touched: Vec<RecordedPlace>) -> Question {
    match touched.pop() {
        Some(_) => Question::Place {
            shape,
            name,
            touched,
        },
        None => Question::Name(shape),
    }
}

/// Returns the tool whose short name begins with a letter.
fn tool_of(letter: char) -> Option<Tool> {
    let mut tools = Tool::ALL.into_iter();
    tools.find(|tool| tool.short().starts_with(letter))
}

fn check_name(name: &str) -> Result<(), String> {
    if name.is_empty() {
        return Err(format!(
            "the name is empty; enter 1 to {MAX_LEN} letters, digits, _ and -, or go back with Backspace"
        ));
    }
    Ok(())
}

fn is_free(name: &str, kind: &str, is_taken: bool) -> Result<(), String> {
    if is_taken {
        return Err(format!(
            "there is already a {kind} {name:?}; enter another name"
        ));
    }
    Ok(())
}

fn times(text: &str) -> Result<Times, String> {
    match text.parse() {
        Ok(0) => Ok(Times::Forever),
        Ok(count @ 1..=MAX_TIMES) => Ok(Times::Count(count)),
        _ => Err(format!(
            "the count is {text:?}; allowed are 1 to {MAX_TIMES}, or 0: forever"
        )),
    }
}

fn length(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(length) if (0.0..=MAX_LENGTH_MM).contains(&length) => Ok(length),
        _ => Err(format!(
            "the length is {text:?}; allowed are 0 to {MAX_LENGTH_MM} mm"
        )),
    }
}

fn touched_grid(name: &str, corners: &[RecordedPlace; 3], size: GridSize) -> Answer {
    Answer::Grid(TouchedGrid {
        name: name.to_owned(),
        corners: *corners,
        size,
    })
}

fn layer_mm(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(mm) if mm != 0.0 && mm.abs() <= MAX_LAYER_MM => Ok(mm),
        _ => Err(format!(
            "the distance is {text:?}; allowed are -{MAX_LAYER_MM} to {MAX_LAYER_MM} mm without 0"
        )),
    }
}

fn is_near(one: &RecordedPlace, other: &RecordedPlace) -> bool {
    let squares = one.point_mm.iter().zip(other.point_mm);
    let squared: f64 = squares.map(|(a, b)| (a - b).powi(2)).sum();
    squared.sqrt() < NEAR_MM
}

/// The longest text.
const MAX_LEN: usize = 40;
/// The most cycles of a repeat.
const MAX_TIMES: u64 = 1_000_000;
/// The longest tool, in mm.
const MAX_LENGTH_MM: f64 = 200.0;
/// The largest distance of layers, in mm.
const MAX_LAYER_MM: f64 = 300.0;
/// Places of a grid or a frame are at least this far from each other, in mm.
const NEAR_MM: f64 = 1.0;

#[cfg(test)]
mod tests {
    use super::*;

    fn place(x: f64, y: f64) -> RecordedPlace {
        RecordedPlace {
            point_mm: [x, y, 0.0],
            rotation_deg: 0.0,
            suction: false,
            gripper_deg: 0.0,
        }
    }

    fn program() -> Program {
        let text = "[points]\np1 = { x = 200, y = 0, z = 0 }\np2 = { x = 210, y = 0, z = 0 }
[frames]\nplate = { origin = \"p1\", x = \"p2\", y = { x = 200, y = 10, z = 0 } }\n[[steps]]\ngo = \"p1\"\n";
        Program::from_toml(text).expect("it is a program")
    }

    /// The outcome of the last key; `\n` is Enter, `<` Backspace.
    fn keyed(it: &mut Prompt, keys: &str) -> Outcome {
        let code = |key| match key {
            '\n' => KeyCode::Enter,
            '<' => KeyCode::Backspace,
            letter => KeyCode::Char(letter),
        };
        let program = program();
        let mut outcome = Outcome::Asks;
        for key in keys.chars() {
            outcome = it.handle_key(code(key), &program);
        }
        outcome
    }

    fn prompt(keys: &str) -> (Prompt, Outcome) {
        let mut it = Prompt::new(Some("p2".into()));
        let outcome = keyed(&mut it, keys);
        (it, outcome)
    }

    fn answer(keys: &str) -> Answer {
        match prompt(keys).1 {
            Outcome::Answered(answer) => answer,
            other => panic!("{keys:?}: {other:?}"),
        }
    }

    fn refusal(keys: &str) -> String {
        match prompt(keys).1 {
            Outcome::Refused(reason) => reason,
            other => panic!("{keys:?}: {other:?}"),
        }
    }

    #[test]
    fn names_counts_and_tools_are_answered_with_text() {
        let (from, to) = ("p2".to_owned(), "tray_3".to_owned());
        assert_eq!(answer("ntray_3\n"), Answer::Rename { from, to });
        assert_eq!(answer("r12\n"), Answer::Repeat(Times::Count(12)));
        assert_eq!(answer("r0\n"), Answer::Repeat(Times::Forever));
        let (kind, length) = (Tool::Gripper, 42.5);
        assert_eq!(
            answer("tg42.5\n"),
            Answer::Tool(MountedTool { kind, length })
        );
        assert_eq!(answer("clid.toml\n"), Answer::Call("lid.toml".into()));
        assert_eq!(answer("f\n"), Answer::UseFrame(None));
    }

    #[test]
    fn input_that_is_not_allowed_is_refused_with_what_is_allowed() {
        for (keys, found, allowed) in [
            ("k", "k is no choice", "n r t g f c"),
            ("tx", "x is no choice", "c g p l"),
            ("n\n", "empty", "1 to 40 letters"),
            ("na.", "'.'", "letters, digits"),
            ("np1\n", "already a point \"p1\"", "another name"),
            ("r\n", "\"\"", "1 to 1000000, or 0"),
            ("r1000001\n", "\"1000001\"", "1 to 1000000"),
            ("tc201\n", "\"201\"", "0 to 200 mm"),
            ("tc1.2.3\n", "\"1.2.3\"", "0 to 200 mm"),
            ("gp1\n", "already a point \"p1\"", "another name"),
            ("gplate\n", "already a frame \"plate\"", "another name"),
        ] {
            let reason = refusal(keys);
            assert!(
                reason.contains(found) && reason.contains(allowed),
                "{keys:?}: {reason}"
            );
        }
        let mut it = Prompt::new(None);
        assert!(
            matches!(keyed(&mut it, "n"), Outcome::Refused(_)),
            "there is no point"
        );
    }

    #[test]
    fn a_grid_is_three_corners_and_a_size() {
        let (mut it, _) = prompt("gtray\n");
        assert_eq!(it.input(), Input::Place);
        let corners = [place(200.0, 0.0), place(260.0, 0.0), place(200.0, 90.0)];
        for corner in corners {
            assert_eq!(keyed(&mut it, "\n"), Outcome::WantsPlace);
            assert_eq!(it.handle_place(corner), Outcome::Asks);
        }
        for wrong in ["\n", "3\n", "<0x4\n"] {
            let outcome = keyed(&mut it, wrong);
            assert!(
                matches!(outcome, Outcome::Refused(_)),
                "{wrong:?}: {outcome:?}"
            );
        }
        let grid = TouchedGrid {
            name: "tray".into(),
            corners,
            size: "3x4".parse().expect("columns and rows"),
        };
        // The size that the program refused can be corrected.
        for keys in ["<<<3x4\n", "\n"] {
            let answered = Outcome::Answered(Answer::Grid(grid.clone()));
            assert_eq!(keyed(&mut it, keys), answered);
        }
        // With layers, their distance is asked.
        assert_eq!(keyed(&mut it, "x2\n"), Outcome::Asks);
        assert!(matches!(keyed(&mut it, "0\n"), Outcome::Refused(_)));
        let size = GridSize {
            layers: 2,
            layer_mm: -22.5,
            ..grid.size
        };
        let answered = Outcome::Answered(Answer::Grid(TouchedGrid { size, ..grid }));
        assert_eq!(keyed(&mut it, "<-22.5\n"), answered);
        assert_eq!(keyed(&mut it, "<<<<<<"), Outcome::Asks);
        assert_eq!(it.input(), Input::Text);
    }

    #[test]
    fn a_place_that_was_touched_already_is_refused_and_the_last_one_can_be_touched_again() {
        let (mut it, _) = prompt("fbase\n");
        it.handle_place(place(200.0, 0.0));
        let near = it.handle_place(place(200.5, 0.0));
        assert!(
            matches!(&near, Outcome::Refused(reason) if reason.contains("from the origin; jog to a place on the x axis")),
            "{near:?}"
        );
        it.handle_place(place(230.0, 0.0));
        assert_eq!(keyed(&mut it, "<"), Outcome::Asks);
        it.handle_place(place(240.0, 0.0));
        let points = [place(200.0, 0.0), place(240.0, 0.0), place(200.0, 30.0)];
        for _ in 0..2 {
            // Also a second time, if the program has refused the first.
            let answered = it.handle_place(points[2]);
            assert_eq!(
                answered,
                Outcome::Answered(Answer::Frame("base".into(), points))
            );
        }
    }

    #[test]
    fn a_frame_that_exists_is_used_or_taught_again() {
        let used = Answer::UseFrame(Some("plate".into()));
        assert_eq!(answer("fplate\nu"), used);
        let (it, _) = prompt("fplate\nt");
        assert_eq!(it.input(), Input::Place);
    }

    #[test]
    fn backspace_goes_back_to_the_beginning_and_out() {
        let (mut it, _) = prompt("gtray\n");
        it.handle_place(place(200.0, 0.0));
        for _ in 0..2 {
            assert_eq!(keyed(&mut it, "<"), Outcome::Asks);
        }
        assert_eq!(it.input(), Input::Text);
        assert_eq!(keyed(&mut it, "<"), Outcome::Cancelled);
    }

    #[test]
    fn pasted_text_is_text_and_accepts_nothing() {
        let (mut it, _) = prompt("n");
        assert_eq!(it.handle_paste("left tray\nq\n"), Outcome::Asks);
        assert_eq!(it.text(), "lefttray");
        let (mut it, _) = prompt("gtray\n");
        assert!(matches!(it.handle_paste("\n"), Outcome::Refused(_)));
    }
}
