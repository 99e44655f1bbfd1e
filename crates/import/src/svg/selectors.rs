//! Selectors that the library does not support, replaced by marks: each matching element gets an
//! attribute, which the sheet selects instead.
//!
//! ```text
//!   [id^=a] { fill: red }             [marked-1] { fill: red }
//!   g:nth-child(2) > path {..}        g[marked-2] > path {..}
//! ```

use std::collections::HashMap;

use simplecss::Selector;
use usvg::roxmltree::{Document, Node};

use super::declared::Element;

/// The tests of elements, and the mark attribute of each.
#[derive(Debug, Default)]
pub(super) struct Marks {
    questions: Vec<Question>,
}

/// A test of an element that needs the document.
#[derive(Clone, Debug, PartialEq)]
enum Question {
    /// `[name^=value]` and similar; the sign selects the part of the attribute to compare.
    Part {
        name: String,
        sign: char,
        value: String,
    },
    /// `:nth-child(an+b)` and its short forms.
    Place {
        step: i64,
        offset: i64,
        of_type: bool,
        from_end: bool,
    },
    /// `:not(...)`, of classes, attributes and similar.
    Not(Vec<String>),
}

impl Marks {
    /// Rewrites a list of selectors for the library; `None` if one is still unsupported.
    pub(super) fn readable(&mut self, selectors: &str) -> Option<String> {
        let before = self.questions.len();
        let whole = self.rewritten(selectors);
        let is_known =
            |text: &String| split(text).all(|part| Selector::parse(part.trim()).is_some());
        let known = whole.filter(is_known);
        if known.is_none() {
            self.questions.truncate(before);
        }
        known
    }

    fn rewritten(&mut self, selectors: &str) -> Option<String> {
        let (mut whole, mut rest) = (String::new(), selectors);
        while let Some(at) = rest.find(['[', ':', '"', '\'', '\\', '/']) {
            whole += &rest[..at];
            rest = &rest[at..];
            let end = part_end(rest)?;
            let part = &rest[..end];
            match question(part) {
                Some(question) => {
                    let mark = self.mark(question)?;
                    whole.extend(["[", &mark, "]"]);
                }
                None => whole += part,
            }
            rest = &rest[end..];
        }
        Some(whole + rest)
    }

    /// The mark attribute of a test.
    fn mark(&mut self, question: Question) -> Option<String> {
        let known = self.questions.iter().position(|known| *known == question);
        let number = known.unwrap_or(self.questions.len());
        if known.is_none() {
            self.questions.push(question);
        }
        (number < MAX_TESTS).then(|| name(number))
    }

    /// The marks of all elements, by node number; empty without tests.
    pub(super) fn of(&self, doc: &Document<'_>) -> Vec<Vec<String>> {
        if self.questions.is_empty() {
            return Vec::new();
        }
        let mut marks = vec![Vec::new(); doc.descendants().count()];
        for (number, question) in self.questions.iter().enumerate() {
            let places = question.places(doc);
            for node in doc.descendants().filter(Node::is_element) {
                let place = places.get(node.id().get_usize()).copied();
                if question.holds(node, place.unwrap_or_default()) {
                    marks[node.id().get_usize()].push(name(number));
                }
            }
        }
        marks
    }
}

impl Question {
    /// The sibling indexes of all elements, counted from 1, if a test needs them.
    fn places(&self, doc: &Document<'_>) -> Vec<i64> {
        let Self::Place {
            of_type, from_end, ..
        } = *self
        else {
            return Vec::new();
        };
        let mut places = vec![0; doc.descendants().count()];
        for parent in doc.descendants().filter(Node::has_children) {
            let mut counts = HashMap::new();
            let mut count = |node: Node<'_, '_>| {
                let name = node.tag_name().name().to_owned();
                let kind = if of_type { name } else { String::new() };
                let place = counts.entry(kind).or_insert(0);
                *place += 1;
                places[node.id().get_usize()] = *place;
            };
            let children = parent.children().filter(Node::is_element);
            if from_end {
                children.rev().for_each(&mut count);
            } else {
                children.for_each(&mut count);
            }
        }
        places
    }

    fn holds(&self, node: Node<'_, '_>, place: i64) -> bool {
        match self {
            Self::Part { name, sign, value } => {
                let found = node.attribute(name.as_str()).unwrap_or_default();
                !value.is_empty()
                    && match sign {
                        '^' => found.starts_with(value),
                        '$' => found.ends_with(value),
                        _ => found.contains(value),
                    }
            }
            Self::Place { step, offset, .. } => {
                let distance = place - offset;
                match step {
                    0 => distance == 0,
                    _ => distance % step == 0 && distance / step >= 0,
                }
            }
            Self::Not(selectors) => {
                let mut selectors = selectors
                    .iter()
                    .filter_map(|selector| Selector::parse(selector));
                !selectors.any(|selector| selector.matches(&Element(node)))
            }
        }
    }
}

/// The test of a part of a selector, if the library does not support it.
fn question(part: &str) -> Option<Question> {
    if let Some(inner) = part.strip_prefix('[') {
        return attribute(inner.strip_suffix(']')?);
    }
    let (name, argument) = part
        .strip_prefix(':')?
        .split_once('(')
        .unwrap_or((&part[1..], ")"));
    let argument = argument.strip_suffix(')')?.trim();
    let place = |(step, offset), of_type, from_end| Question::Place {
        step,
        offset,
        of_type,
        from_end,
    };
    Some(match (name, argument) {
        ("first-of-type", "") => place((0, 1), true, false),
        ("last-of-type", "") => place((0, 1), true, true),
        ("last-child", "") => place((0, 1), false, true),
        ("nth-child", argument) => place(numbers(argument)?, false, false),
        ("nth-last-child", argument) => place(numbers(argument)?, false, true),
        ("nth-of-type", argument) => place(numbers(argument)?, true, false),
        ("nth-last-of-type", argument) => place(numbers(argument)?, true, true),
        ("not", argument) => not(argument)?,
        _ => return None,
    })
}

/// Parses `name^=value`, with or without quotes around the value.
fn attribute(inner: &str) -> Option<Question> {
    let (name, value) = inner.split_once('=')?;
    let sign = name
        .chars()
        .next_back()
        .filter(|sign| "^$*".contains(*sign))?;
    let name = name.strip_suffix(sign)?.trim();
    let value = value.trim();
    let quoted = ['"', '\''].into_iter().find_map(|name| {
        let inner = value.strip_prefix(name)?.strip_suffix(name)?;
        (!inner.contains(name)).then_some(inner)
    });
    let is_name = |text: &str| {
        text.chars()
            .all(|c| c.is_alphanumeric() || "-_".contains(c))
    };
    let value = quoted.or(Some(value).filter(|value| is_name(value)))?;
    (is_name(name) && !value.contains('\\')).then(|| Question::Part {
        name: name.to_owned(),
        sign,
        value: value.to_owned(),
    })
}

/// Whether a selector has the specificity of an attribute, as the mark has.
fn not(argument: &str) -> Option<Question> {
    let selectors = split(argument).map(str::trim);
    let count_alike = |text: &str| {
        Selector::parse(text).is_some_and(|selector| selector.specificity() == [0, 1, 0])
    };
    let selectors: Vec<&str> = selectors.collect();
    let is_simple = |text: &&str| count_alike(text) && !text.contains([' ', '>', '+']);
    let all = selectors.iter().all(is_simple);
    all.then(|| Question::Not(selectors.into_iter().map(str::to_owned).collect()))
}

/// Parses `2n+1`, `odd`, `even`, `n` or a number, as a step and an offset.
fn numbers(text: &str) -> Option<(i64, i64)> {
    let text: String = text
        .split_whitespace()
        .collect::<String>()
        .to_ascii_lowercase();
    let small = |text: &str| text.parse::<i32>().ok().map(i64::from);
    match text.as_str() {
        "odd" => return Some((2, 1)),
        "even" => return Some((2, 0)),
        _ => {}
    }
    let Some((step, offset)) = text.split_once('n') else {
        return Some((0, small(&text)?));
    };
    let step = match step {
        "" | "+" => 1,
        "-" => -1,
        _ => small(step)?,
    };
    let offset = if offset.is_empty() { 0 } else { small(offset)? };
    Some((step, offset))
}

/// The end of a selector part that starts with `[` or `:`; `None` for other parts, or unclosed
/// ones.
fn part_end(text: &str) -> Option<usize> {
    match text.as_bytes()[0] {
        b'[' => text.find(']').map(|at| at + 1),
        b':' => {
            let is_of_name = |c: char| c.is_alphanumeric() || c == '-';
            let name = text[1..].find(|text| !is_of_name(text));
            let name = name.map_or(text.len(), |name| name + 1);
            let has_argument = text[name..].starts_with('(');
            let end = has_argument.then(|| text[name..].find(')'));
            end.map_or(Some(name), |end| Some(name + end? + 1))
        }
        _ => None,
    }
}

/// The selectors of a list.
fn split(selectors: &str) -> impl Iterator<Item = &str> {
    let mut depth = 0_i32;
    selectors.split(move |c: char| {
        depth += i32::from("([".contains(c)) - i32::from(")]".contains(c));
        c == ',' && depth == 0
    })
}

fn name(number: usize) -> String {
    format!("marked-{}", number + 1)
}

/// The largest number of tests; with more, rules are ignored.
const MAX_TESTS: usize = 20;

#[cfg(test)]
mod tests {
    use super::*;

    /// The names of the elements that a selector matches, if it is supported.
    fn meant(selector: &str) -> Option<String> {
        let text = "<svg><a id='one' class='x'/><b id='two'/><a id='onetwo'><c/><c class='x y'/></a></svg>";
        let doc = Document::parse(text).expect("XML");
        let mut marks = Marks::default();
        let readable = marks.readable(selector)?;
        let marks = marks.of(&doc);
        let mark = readable.split(['[', ']']).nth(1).expect("a mark");
        let elements = doc.descendants().filter(Node::is_element);
        let meant = elements.filter(|element| {
            marks[element.id().get_usize()]
                .iter()
                .any(|element| element == mark)
        });
        let names: Vec<&str> = meant
            .map(|node| node.attribute("id").unwrap_or(node.tag_name().name()))
            .collect();
        Some(names.join(" "))
    }

    #[test]
    fn elements_are_selected_by_parts_of_attributes_by_positions_and_by_negation() {
        for (selector, names) in [
            ("[id^=one]", "one onetwo"),
            ("[id$='two']", "two onetwo"),
            ("[id*=\"net\"]", "onetwo"),
            ("[id*='']", ""),
            (":nth-child(2)", "two c"),
            (":nth-child(odd)", "svg one onetwo c"),
            (":nth-child(-n + 2)", "svg one two c c"),
            (":nth-last-child(1)", "svg onetwo c"),
            (":last-child", "svg onetwo c"),
            (":first-of-type", "svg one two c"),
            (":nth-of-type(2n)", "onetwo c"),
            (":not(.x)", "svg two onetwo c"),
            (":not(.x, [class])", "svg two onetwo c"),
        ] {
            assert_eq!(meant(selector).as_deref(), Some(names), "{selector}");
        }
    }

    #[test]
    fn unknown_and_ambiguous_selectors_stay_unread() {
        for selector in [
            ":not(a)",
            ":not(#one)",
            ":not(.x, [id])",
            ":not(a .x)",
            ":has(a)",
            ":nth-child(2 of .x)",
            ":nth-child(n+99999999999)",
            "a ~ b",
            "[id^=a b]",
            "[id^=",
            ":not(",
            "[id^='\\61']",
            "::before",
            ":is(.x)",
            "\"",
            "[id^='a' i]",
        ] {
            let mut marks = Marks::default();
            assert_eq!(
                marks.readable(&format!("{selector}, .x")),
                None,
                "{selector}"
            );
            assert!(marks.questions.is_empty());
        }
        let mut marks = Marks::default();
        let all: Vec<String> = (0..=MAX_TESTS).map(|i| format!("[a^=x{i}]")).collect();
        assert_eq!(marks.readable(&all.join(",")), None);
    }

    #[test]
    fn a_selector_keeps_its_parts_that_the_library_knows() {
        let mut marks = Marks::default();
        let readable = marks.readable("g.a:first-child > path[id^=b], #c:not(.d) + [e=f] [id^=b]");
        assert_eq!(
            readable.as_deref(),
            Some("g.a:first-child > path[marked-1], #c[marked-2] + [e=f] [marked-1]")
        );
    }
}
