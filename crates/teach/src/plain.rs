//! Plain messages for the errors of the TOML and JSON parsers.

use crate::similar::nearest;

/// Rewrites an error message of serde or of the TOML parser in the terms of a program file.
pub(crate) fn plain(message: &str) -> String {
    let message = message.trim().replace('\n', ", ");
    if let Some(rest) = message.strip_prefix("missing field ") {
        return format!("the key {rest} is missing");
    }
    if let Some(rest) = message.strip_prefix("duplicate field ") {
        return format!("the key {rest} appears twice; allowed is once");
    }
    if let Some(rest) = message.strip_prefix("unknown field ") {
        return match rest.split_once(", ") {
            Some((key, allowed)) => format!("the key {key} is unknown; {}", meant(key, allowed)),
            None => format!("the key {rest} is unknown"),
        };
    }
    if let Some(rest) = message.strip_prefix("unknown variant ") {
        return match rest.split_once(", ") {
            Some((value, allowed)) => format!("the value is {value}; {}", choices(allowed)),
            None => format!("the value {rest} is unknown"),
        };
    }
    let typed = ["invalid type: ", "invalid value: ", "invalid length "];
    if let Some(rest) = typed.iter().find_map(|start| message.strip_prefix(start)) {
        return match rest.rsplit_once(", expected ") {
            Some((value, type_name)) => {
                format!("found {}; expected {}", found(value), expected(type_name))
            }
            None => format!("found {}, which is not allowed here", found(rest)),
        };
    }
    syntax(&message)
}

/// The similar one of the allowed names, or all of them.
fn meant(name: &str, allowed: &str) -> String {
    let names = allowed.split('`').skip(1).step_by(2);
    match nearest(name.trim_matches('`'), names) {
        Some(meant) => format!("did you mean `{meant}`?"),
        None => choices(allowed),
    }
}

/// `expected one of ...` and `there are no fields`, as a list of what is allowed.
fn choices(allowed: &str) -> String {
    let list = allowed
        .strip_prefix("expected one of ")
        .or_else(|| allowed.strip_prefix("expected "));
    match list {
        Some(list) => format!("allowed: {list}"),
        None => "no keys are allowed here".to_owned(),
    }
}

/// A value, without the parser's name for its type: ``integer `3` `` is `the number 3`.
fn found(value: &str) -> String {
    let number = ["integer `", "floating point `"];
    if let Some(number) = number.iter().find_map(|start| value.strip_prefix(start)) {
        return format!("the number {}", number.trim_end_matches('`'));
    }
    if let Some(boolean) = value.strip_prefix("boolean `") {
        return boolean.trim_end_matches('`').to_owned();
    }
    if let Some(text) = value.strip_prefix("string ") {
        return format!("the text {text}");
    }
    match value {
        "map" => "a table".to_owned(),
        "sequence" => "an array".to_owned(),
        other => other.to_owned(),
    }
}

/// A Rust type in plain words.
fn expected(type_name: &str) -> &str {
    match type_name {
        "f64" | "f32" => "a number",
        "u8" | "u16" | "u32" | "u64" | "usize" => "a whole number of 0 or more",
        "i8" | "i16" | "i32" | "i64" | "isize" => "a whole number",
        "a string" | "string" => "a text in quotes",
        "a boolean" | "bool" => "true or false",
        "a sequence" => "an array",
        "a map" => "a table",
        _ if type_name.starts_with("struct ") => "a table",
        _ => type_name,
    }
}

/// A syntax error, without the terms of the parser.
fn syntax(message: &str) -> String {
    let (problem, allowed) = match message.split_once(", expected ") {
        Some((problem, allowed)) => (problem, Some(allowed)),
        None => (message, None),
    };
    let problem = match problem {
        "string values must be quoted" => return "a text must be in quotes".to_owned(),
        "invalid unquoted key" => {
            return "a key has a character that is allowed in quotes only".to_owned();
        }
        "cannot recurse further; max recursion depth met" | "recursion limit" => {
            return "values are nested too deep".to_owned();
        }
        "floating-point number overflowed"
        | "integer number overflowed"
        | "u64 value was too large" => return "a number is too large".to_owned(),
        "integers with a radix cannot be signed" => {
            return "a number with 0x, 0o or 0b must have no sign".to_owned();
        }
        "radix must be lowercase" => return "0x, 0o and 0b must be in lower case".to_owned(),
        "duplicate key" => return "a key appears twice; allowed is once".to_owned(),
        "extra assignment between key-value pairs" => "extra `=`",
        other => other,
    };
    let problem = match problem.strip_prefix("invalid ") {
        Some(rest) => format!("not a valid {rest}"),
        None => problem.to_owned(),
    };
    let allowed = allowed.map(|allowed| {
        let allowed = allowed.replace("multi-line basic string", "text in quotes");
        let allowed = allowed.replace("basic string", "text in quotes");
        allowed.replace("literal string", "text in quotes")
    });
    match allowed.as_deref() {
        Some("nothing") => format!("{problem}; nothing may follow here"),
        Some(allowed) => format!("{problem}; expected {allowed}"),
        None => problem,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parser_messages_become_plain() {
        for (message, expected) in [
            ("missing field `x`", "the key `x` is missing"),
            (
                "unknown field `way`, expected one of `go`, `path`",
                "the key `way` is unknown; allowed: `go`, `path`",
            ),
            (
                "unknown field `pth`, expected one of `go`, `path`",
                "the key `pth` is unknown; did you mean `path`?",
            ),
            (
                "unknown variant `walk`, expected `jump` or `movl`",
                "the value is `walk`; allowed: `jump` or `movl`",
            ),
            (
                "invalid type: string \"a, expected b\", expected f64",
                "found the text \"a, expected b\"; expected a number",
            ),
            (
                "invalid value: integer `-1`, expected u32",
                "found the number -1; expected a whole number of 0 or more",
            ),
            (
                "invalid type: sequence, expected struct Frame",
                "found an array; expected a table",
            ),
            (
                "key with no value, expected `=`",
                "key with no value; expected `=`",
            ),
            (
                "speed sets nothing; set percent",
                "speed sets nothing; set percent",
            ),
        ] {
            assert_eq!(plain(message), expected);
        }
    }
}
