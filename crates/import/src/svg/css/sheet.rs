//! The rules of style sheets.

use std::rc::Rc;

use cssparser::{
    AtRuleParser, CowRcStr, DeclarationParser, ParseError, Parser, ParserState,
    QualifiedRuleParser, RuleBodyItemParser, RuleBodyParser, StyleSheetParser,
};
use dobot_geometry::{CancelToken, Cancelled};
use selectors::SelectorList;
use selectors::parser::{ParseRelative, SelectorParseErrorKind as Error};

use super::Found;
use super::declaration::{Declaration, Declarations};
use super::media::{is_shown, is_supported};
use super::selector::{SelectorParser, SvgSelectors};

/// The rules of all sheets, in their order.
#[derive(Debug, Default)]
pub(super) struct Sheets<'i> {
    pub(super) rules: Vec<Rule<'i>>,
    /// The cascade layers, each by the path of its names, in the order of their first appearance.
    layers: Vec<Vec<String>>,
    /// The rules that are ignored, as by a browser or because they are not supported.
    pub(super) ignored_rules: Found,
    /// The declarations with an invalid value.
    pub(super) ignored_values: Found,
    /// The sheets in other files.
    pub(super) external: Found,
    /// The position of the current sheet in the file, in bytes.
    at: usize,
    selector_parser: SelectorParser,
    cancel: CancelToken,
}

/// A rule.
#[derive(Debug)]
pub(super) struct Rule<'i> {
    pub(super) selectors: SelectorList<SvgSelectors>,
    /// The path of its cascade layer; empty outside layers.
    layer: Vec<String>,
    pub(super) declarations: Rc<[Declaration<'i>]>,
}

impl<'i> Sheets<'i> {
    pub(super) fn new(cancel: &CancelToken) -> Self {
        Self {
            cancel: cancel.clone(),
            ..Self::default()
        }
    }

    /// Adds the rules of a sheet at this position in the file.
    pub(super) fn add(&mut self, at: usize, css: &'i str) -> Result<(), Cancelled> {
        let cancel = self.cancel.clone();
        self.at = at;
        self.selector_parser = SelectorParser::default();
        let mut input = Parser::new(css);
        let mut block = Block {
            sheets: self,
            layer: Vec::new(),
            parent: None,
            own: Declarations::default(),
        };
        let mut ignored = 0;
        for rule in StyleSheetParser::new(&mut input, &mut block) {
            cancel.check()?;
            ignored += usize::from(rule.is_err());
        }
        self.ignored_rules.add(ignored, at);
        Ok(())
    }

    /// The rank of the layer of a rule: of several layers the highest counts, and rules outside
    /// layers are above all.
    pub(super) fn rank(&self, rule: &Rule<'i>) -> Vec<usize> {
        let mut rank = Vec::with_capacity(rule.layer.len() + 1);
        for depth in 1..=rule.layer.len() {
            let path = &rule.layer[..depth];
            let place = self.layers.iter().position(|known| known == path);
            rank.push(place.unwrap_or(usize::MAX));
        }
        rank.push(usize::MAX);
        rank
    }

    fn note_layer(&mut self, path: &[String]) {
        for depth in 1..=path.len() {
            if !self.layers.iter().any(|known| known == &path[..depth]) {
                self.layers.push(path[..depth].to_vec());
            }
        }
    }
}

/// A block of rules, and of declarations if it is in a rule.
struct Block<'s, 'i> {
    sheets: &'s mut Sheets<'i>,
    layer: Vec<String>,
    /// The selectors of the rule around it.
    parent: Option<SelectorList<SvgSelectors>>,
    own: Declarations<'i>,
}

/// The start of an at-rule.
enum AtRule {
    /// A block whose rules apply, in the layer of this path.
    Applies(Vec<String>),
    /// A block whose rules do not apply.
    Skipped,
    /// A rule without a block, or one that draws nothing by itself.
    Done,
}

impl<'i> Block<'_, 'i> {
    /// Reads a block inside this one.
    fn inner(
        &mut self,
        layer: Vec<String>,
        parent: Option<SelectorList<SvgSelectors>>,
        input: &mut Parser<'i>,
    ) {
        let place = parent.as_ref().map(|selectors| {
            self.sheets.rules.push(Rule {
                selectors: selectors.clone(),
                layer: layer.clone(),
                declarations: Rc::new([]),
            });
            self.sheets.rules.len() - 1
        });
        let cancel = self.sheets.cancel.clone();
        let mut block = Block {
            sheets: &mut *self.sheets,
            layer,
            parent,
            own: Declarations::default(),
        };
        let mut ignored = 0;
        for item in RuleBodyParser::new(input, &mut block) {
            if cancel.is_cancelled() {
                break;
            }
            ignored += usize::from(item.is_err());
        }
        let own = block.own;
        self.sheets.ignored_rules.add(ignored, self.sheets.at);
        self.sheets.ignored_values.add(own.ignored, self.sheets.at);
        if let Some(place) = place {
            self.sheets.rules[place].declarations = own.valid.into();
        }
    }

    fn layer_path(&self, names: &str) -> Vec<String> {
        let names = names.trim().split('.').map(|name| name.trim().to_owned());
        self.layer.iter().cloned().chain(names).collect()
    }

    fn layer(&mut self, names: &str) -> AtRule {
        if names.is_empty() {
            let number = self.sheets.layers.len();
            let path = self.layer_path(&format!(" {number}"));
            self.sheets.note_layer(&path);
            return AtRule::Applies(path);
        }
        let paths: Vec<_> = names.split(',').map(|name| self.layer_path(name)).collect();
        for path in &paths {
            self.sheets.note_layer(path);
        }
        AtRule::Applies(paths.into_iter().next().unwrap_or_default())
    }

    fn namespace(&mut self, input: &mut Parser<'i>) -> Option<()> {
        let prefix = input.try_parse(Parser::expect_ident_cloned);
        let url = input.expect_url_or_string().ok()?;
        let prefix = prefix.map(|prefix| prefix.to_string()).unwrap_or_default();
        let namespaces = &mut self.sheets.selector_parser.namespaces;
        namespaces.push((prefix, url.to_string()));
        Some(())
    }
}

impl<'i> AtRuleParser<'i> for Block<'_, 'i> {
    type Prelude = AtRule;
    type AtRule = ();
    type Error = Error;

    fn parse_prelude(
        &mut self,
        name: CowRcStr<'i>,
        input: &mut Parser<'i>,
    ) -> Result<AtRule, ParseError<Error>> {
        let applies = |holds| {
            if holds {
                AtRule::Applies(self.layer.clone())
            } else {
                AtRule::Skipped
            }
        };
        match &*name.to_ascii_lowercase() {
            "media" => Ok(applies(is_shown(input))),
            "supports" => Ok(applies(is_supported(input))),
            "layer" => {
                input.skip_whitespace();
                let start = input.position();
                while input.next().is_ok() {}
                Ok(self.layer(input.slice_from(start).trim()))
            }
            "import" => {
                while input.next().is_ok() {}
                self.sheets.external.add(1, self.sheets.at);
                Ok(AtRule::Done)
            }
            "namespace" => {
                let done = self.namespace(input).map(|()| AtRule::Done);
                done.ok_or_else(ParseError::unexpected_token)
            }
            "charset"
            | "font-face"
            | "keyframes"
            | "-webkit-keyframes"
            | "page"
            | "property"
            | "counter-style"
            | "font-feature-values"
            | "font-palette-values"
            | "view-transition" => {
                while input.next().is_ok() {}
                Ok(AtRule::Done)
            }
            _ => Err(ParseError::unexpected_token()),
        }
    }

    fn rule_without_block(&mut self, _prelude: AtRule, _start: &ParserState) -> Result<(), ()> {
        Ok(())
    }

    fn parse_block(
        &mut self,
        prelude: AtRule,
        _start: &ParserState,
        input: &mut Parser<'i>,
    ) -> Result<(), ParseError<Error>> {
        match prelude {
            AtRule::Applies(layer) => self.inner(layer, self.parent.clone(), input),
            AtRule::Skipped | AtRule::Done => while input.next().is_ok() {},
        }
        Ok(())
    }
}

impl<'i> QualifiedRuleParser<'i> for Block<'_, 'i> {
    type Prelude = SelectorList<SvgSelectors>;
    type QualifiedRule = ();
    type Error = Error;

    fn parse_prelude(
        &mut self,
        input: &mut Parser<'i>,
    ) -> Result<SelectorList<SvgSelectors>, ParseError<Error>> {
        let parser = &self.sheets.selector_parser;
        let Some(parent) = &self.parent else {
            return SelectorList::parse(parser, input, ParseRelative::No);
        };
        let selectors = SelectorList::parse(parser, input, ParseRelative::ForNesting)?;
        Ok(selectors.replace_parent_selector(parent))
    }

    fn parse_block(
        &mut self,
        selectors: SelectorList<SvgSelectors>,
        _start: &ParserState,
        input: &mut Parser<'i>,
    ) -> Result<(), ParseError<Error>> {
        self.inner(self.layer.clone(), Some(selectors), input);
        Ok(())
    }
}

impl<'i> DeclarationParser<'i> for Block<'_, 'i> {
    type Declaration = ();
    type Error = Error;

    fn parse_value(
        &mut self,
        name: CowRcStr<'i>,
        input: &mut Parser<'i>,
        start: &ParserState,
    ) -> Result<(), ParseError<Error>> {
        self.own.parse_value(name, input, start)
    }
}

impl<'i> RuleBodyItemParser<'i, (), Error> for Block<'_, 'i> {
    fn parse_declarations(&self) -> bool {
        self.parent.is_some()
    }

    fn parse_qualified(&self) -> bool {
        true
    }
}
