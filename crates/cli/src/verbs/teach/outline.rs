//! The steps of a program as rows; those inside a `repeat` or an `each` are indented.

use dobot_teach::{Action, Program, Steps, Times};
use toml::Spanned;

/// A row of the list.
#[derive(Debug)]
pub(crate) struct Row<'a> {
    pub(crate) kind: RowKind,
    /// The path of the step, counted from 0; empty for the start.
    pub(crate) path: Vec<usize>,
    /// The step; `None` for the start.
    pub(crate) step: Option<&'a Spanned<Action>>,
}

/// The kind of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RowKind {
    /// The start of the program.
    Start,
    /// A step.
    Step,
    /// The first row of a `repeat` or an `each`.
    Head,
    /// Its end.
    End,
}

/// The rows of a program. An endless repeat has no end: nothing can follow it.
pub(crate) fn outline(program: &Program) -> Vec<Row<'_>> {
    let mut rows = vec![Row {
        kind: RowKind::Start,
        path: Vec::new(),
        step: None,
    }];
    add_rows(&program.steps, &[], &mut rows);
    rows
}

fn add_rows<'a>(steps: &'a Steps, block: &[usize], rows: &mut Vec<Row<'a>>) {
    for (index, step) in steps.0.iter().enumerate() {
        let path = [block, &[index]].concat();
        let inner = inner_steps(step.get_ref());
        let row = |kind| {
            let path = path.clone();
            let step = Some(step);
            Row { kind, path, step }
        };
        let Some(inner) = inner else {
            rows.push(row(RowKind::Step));
            continue;
        };
        rows.push(row(RowKind::Head));
        let end = row(RowKind::End);
        add_rows(inner, &path, rows);
        if !is_endless(step.get_ref()) {
            rows.push(end);
        }
    }
}

impl Row<'_> {
    /// The path at which a step after this row is inserted.
    pub(crate) fn next(&self) -> Vec<usize> {
        let mut next = self.path.clone();
        match (self.kind, next.last_mut()) {
            (RowKind::Step | RowKind::End, Some(last)) => *last += 1,
            _ => next.push(0),
        }
        next
    }

    /// The number: `3`, or `3.1` for the first step inside the third one.
    pub(crate) fn number(&self) -> String {
        if self.kind == RowKind::End {
            return String::new();
        }
        let numbers = self.path.iter().map(|index| (index + 1).to_string());
        numbers.collect::<Vec<_>>().join(".")
    }

    /// The text, indented: `go = "p1", path = "movl"`.
    pub(crate) fn text(&self) -> String {
        let Some(action) = self.step.map(Spanned::get_ref) else {
            return "start".to_owned();
        };
        let text = match self.kind {
            RowKind::End => format!("end of {}", block_name(action)),
            _ => keys(action),
        };
        let indent = INDENT.repeat(self.path.len().saturating_sub(1));
        format!("{indent}{text}")
    }
}

/// The steps inside a step.
pub(crate) const fn inner_steps(action: &Action) -> Option<&Steps> {
    match action {
        Action::Repeat(_, steps) | Action::Each(_, steps) => Some(steps),
        _ => None,
    }
}

/// The key of a step that contains others.
pub(crate) const fn block_name(action: &Action) -> &'static str {
    match action {
        Action::Each(..) => "each",
        _ => "repeat",
    }
}

/// Whether a step repeats until a person ends it.
pub(crate) const fn is_endless(action: &Action) -> bool {
    matches!(action, Action::Repeat(Times::Forever, _))
}

/// The keys of a step in the text, without the steps inside it.
fn keys(action: &Action) -> String {
    let own = match action {
        Action::Repeat(times, _) => Action::Repeat(*times, Steps::default()),
        Action::Each(grids, _) => Action::Each(grids.clone(), Steps::default()),
        other => other.clone(),
    };
    let text = Program::new(vec![own]).to_toml();
    let lines = text.lines().map(str::trim);
    let lines = lines.filter(|line| !matches!(*line, "" | "[[steps]]" | "steps = []"));
    lines.collect::<Vec<_>>().join(", ")
}

const INDENT: &str = "  ";

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn steps_inside_others_are_indented_up_to_an_end() {
        let text = r#"
            [grids.tray]
            at = { x = 200, y = 0, z = 0 }
            columns = 2
            pitch = { x = 10 }
            [[steps]]
            repeat = 3
            [[steps.steps]]
            each = "tray"
            [[steps.steps.steps]]
            go = "tray"
            [[steps]]
            repeat = "forever"
            [[steps.steps]]
            pause = 1
        "#;
        let program = Program::from_toml(text).unwrap();
        let rows = outline(&program);
        let shown: Vec<String> = rows
            .iter()
            .map(|row| format!("{:5} {}", row.number(), row.text()))
            .collect();
        let expected = [
            "      start",
            "1     repeat = 3",
            "1.1     each = \"tray\"",
            "1.1.1     go = \"tray\"",
            "        end of each",
            "      end of repeat",
            "2     repeat = \"forever\"",
            "2.1     pause = 1.0",
        ];
        assert_eq!(shown, expected);
        let next: Vec<Vec<usize>> = rows.iter().map(Row::next).collect();
        let expected: [&[usize]; 8] = [
            &[0],
            &[0, 0],
            &[0, 0, 0],
            &[0, 0, 1],
            &[0, 1],
            &[1],
            &[1, 0],
            &[1, 1],
        ];
        assert_eq!(next, expected);
    }
}
