//! Declarations: a property and its value, in a rule or in the style of an element.

use std::borrow::Cow;

use cssparser::{
    AtRuleParser, CowRcStr, DeclarationParser, ParseError, Parser, ParserState,
    QualifiedRuleParser, RuleBodyItemParser, RuleBodyParser, Token, parse_important,
};
use selectors::parser::SelectorParseErrorKind as Error;
use svgtypes::FontShorthand;

use super::property::Property;
use super::value::link;
use super::variables::has_variables;

/// A declaration.
#[derive(Clone, Debug)]
pub(super) struct Declaration<'i> {
    pub(super) content: Content<'i>,
    pub(super) is_important: bool,
}

/// What a declaration declares.
#[derive(Clone, Debug)]
pub(super) enum Content<'i> {
    /// The value of a property.
    Value(&'static Property, Cow<'i, str>),
    /// The value of a custom property.
    Custom { name: String, value: &'i str },
    /// A property, and its value with custom properties in it.
    Pending { name: String, value: &'i str },
}

/// The values of properties.
pub(super) type Values<'i> = Vec<(&'static Property, Cow<'i, str>)>;

/// Parses a declaration after its colon; `None` if its value is invalid.
pub(super) fn declaration<'i>(
    name: &str,
    input: &mut Parser<'i>,
) -> Result<Option<Vec<Declaration<'i>>>, ParseError<Error>> {
    input.skip_whitespace();
    let start = input.position();
    let (mut has_block, mut is_important) = (false, false);
    while !is_important {
        let found = input.try_parse(parse_important);
        is_important = found.is_ok() && input.is_exhausted();
        match input.next_including_whitespace() {
            Ok(Token::CurlyBracketBlock) => has_block = true,
            Ok(_) => {}
            Err(_) => break,
        }
    }
    let value = input.slice_from(start);
    let value = value
        .rfind('!')
        .filter(|_| is_important)
        .map_or(value, |at| &value[..at])
        .trim();
    if has_block && !name.starts_with("--") {
        // It is a rule in a rule.
        return Err(ParseError::unexpected_token());
    }
    Ok(contents(name, value).map(|contents| {
        let declaration = |content| Declaration {
            content,
            is_important,
        };
        contents.into_iter().map(declaration).collect()
    }))
}

fn contents<'i>(name: &str, value: &'i str) -> Option<Vec<Content<'i>>> {
    if name.starts_with("--") {
        let name = name.to_owned();
        return Some(vec![Content::Custom { name, value }]);
    }
    if has_variables(value) {
        let name = name.to_ascii_lowercase();
        return Some(vec![Content::Pending { name, value }]);
    }
    let values = values(name, value)?.into_iter();
    let contents = values.map(|(property, value)| Content::Value(property, value));
    Some(contents.collect())
}

/// The values that a declaration sets, those of a shorthand one by one; none for properties that
/// change no drawing, and `None` if the value is invalid.
pub(super) fn values<'i>(name: &str, value: &'i str) -> Option<Values<'i>> {
    let longhands = longhands(name);
    let all = |value: &Cow<'i, str>| {
        let properties = longhands.iter().filter_map(|name| Property::of(name));
        properties
            .map(|property| (property, value.clone()))
            .collect()
    };
    if is_wide(value) {
        let properties = longhands.iter().filter_map(|name| Property::of(name));
        let values = properties.map(|property| Some((property, property.value(value)?)));
        return values.collect();
    }
    match &*name.to_ascii_lowercase() {
        "font" => font(value),
        "marker" | "mask" => Some(all(&link(value)?.into())),
        "text-decoration-line" => Some(all(&value.to_ascii_lowercase().into())),
        _ => match Property::of(name) {
            Some(property) => Some(vec![(property, property.value(value)?)]),
            None => Some(Vec::new()),
        },
    }
}

/// The properties that a declaration sets.
pub(super) fn longhands(name: &str) -> Vec<&str> {
    match name {
        "font" => FONT.to_vec(),
        "marker" => vec!["marker-start", "marker-mid", "marker-end"],
        "text-decoration-line" => vec!["text-decoration"],
        _ => vec![name],
    }
}

fn is_wide(value: &str) -> bool {
    let wide = ["inherit", "initial", "unset", "revert", "revert-layer"];
    wide.iter().any(|word| value.eq_ignore_ascii_case(word))
}

/// The parts of the shorthand `font`, whose line height no drawing shows.
fn font(value: &str) -> Option<Values<'static>> {
    let (size, rest) = value.split_once('/').unwrap_or((value, ""));
    let family = rest.trim_start().split_once(' ').map_or("", |rest| rest.1);
    let text = format!("{} {family}", size.trim_end());
    let text = text.trim();
    // The words before the size are in any order, and the library knows no other units.
    let words = text.split_whitespace().map(|word| {
        let size = Property::of("font-size").and_then(|size| size.value(word));
        size.map_or_else(|| word.to_owned(), Cow::into_owned)
    });
    let text = words.collect::<Vec<_>>().join(" ");
    let font = FontShorthand::from_str(&text).ok()?;
    let set = [
        ("font-style", font.font_style),
        ("font-variant", font.font_variant),
        ("font-weight", font.font_weight),
        ("font-stretch", font.font_stretch),
        ("font-size", Some(font.font_size)),
        ("font-family", Some(font.font_family)),
    ];
    let values = set.into_iter().map(|(name, value)| {
        let property = Property::of(name)?;
        let value = property.value(value.unwrap_or("normal"))?;
        Some((property, Cow::Owned(value.into_owned())))
    });
    values.collect()
}

/// The declarations of the style of an element, and the number of invalid ones.
pub(super) fn declarations(style: &str) -> (Vec<Declaration<'_>>, usize) {
    let mut input = Parser::new(style);
    let mut own = Declarations::default();
    let items = RuleBodyParser::new(&mut input, &mut own);
    let broken = items.filter(Result::is_err).count();
    (own.valid, own.ignored + broken)
}

/// The declarations read from a rule or the style of an element.
#[derive(Default)]
pub(super) struct Declarations<'i> {
    pub(super) valid: Vec<Declaration<'i>>,
    /// The number of those with an invalid value.
    pub(super) ignored: usize,
}

impl<'i> DeclarationParser<'i> for Declarations<'i> {
    type Declaration = ();
    type Error = Error;

    fn parse_value(
        &mut self,
        name: CowRcStr<'i>,
        input: &mut Parser<'i>,
        _start: &ParserState,
    ) -> Result<(), ParseError<Error>> {
        match declaration(&name, input)? {
            Some(mut valid) => self.valid.append(&mut valid),
            None => self.ignored += 1,
        }
        Ok(())
    }
}

impl<'i> AtRuleParser<'i> for Declarations<'i> {
    type Prelude = ();
    type AtRule = ();
    type Error = Error;
}

impl<'i> QualifiedRuleParser<'i> for Declarations<'i> {
    type Prelude = ();
    type QualifiedRule = ();
    type Error = Error;
}

impl<'i> RuleBodyItemParser<'i, (), Error> for Declarations<'i> {
    fn parse_declarations(&self) -> bool {
        true
    }

    fn parse_qualified(&self) -> bool {
        false
    }
}

const FONT: [&str; 6] = [
    "font-style",
    "font-variant",
    "font-weight",
    "font-stretch",
    "font-size",
    "font-family",
];
