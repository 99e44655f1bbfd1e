//! One route: what it takes, does and answers, for the router and the document alike.

use std::sync::Arc;

use axum::http::Method;
use axum::routing::MethodRouter;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::DeserializeOwned;

use super::answer::BODY;
use super::app::App;
use super::kinds::Kind;
#[cfg(test)]
use super::strict;
#[cfg(test)]
use dobot_api::Problem;

/// One route.
#[derive(Clone, Debug)]
pub(super) struct Route {
    pub(super) method: Method,
    pub(super) path: &'static str,
    pub(super) summary: &'static str,
    /// Whether it is for everyone, even without a token.
    pub(super) open: bool,
    /// Whether it acts for a client, so that it takes the header `Dobot-Lease`.
    pub(super) asks: bool,
    pub(super) takes: Option<Takes>,
    pub(super) gives: Vec<Gives>,
    pub(super) problems: Vec<Kind>,
    pub(super) queries: &'static [Query],
    pub(super) handler: fn() -> MethodRouter<Arc<App>>,
}

/// A body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Takes {
    pub(super) schema: fn(&mut SchemaGenerator) -> Schema,
    /// Whether the body is as it has to be.
    #[cfg(test)]
    pub(super) reads: fn(&[u8]) -> Result<(), Problem>,
    pub(super) required: bool,
    pub(super) limit: usize,
    pub(super) example: &'static str,
}

/// An answer that is no problem.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gives {
    pub(super) status: u16,
    pub(super) what: &'static str,
    pub(super) content: &'static str,
    pub(super) schema: Option<fn(&mut SchemaGenerator) -> Schema>,
}

/// A parameter of the query.
#[derive(Clone, Copy, Debug)]
pub(super) struct Query {
    pub(super) name: &'static str,
    pub(super) what: &'static str,
    pub(super) schema: fn(&mut SchemaGenerator) -> Schema,
}

impl Route {
    pub(super) fn new(
        method: Method,
        path: &'static str,
        summary: &'static str,
        handler: fn() -> MethodRouter<Arc<App>>,
    ) -> Self {
        Self {
            method,
            path,
            summary,
            open: false,
            asks: false,
            takes: None,
            gives: Vec::new(),
            problems: Vec::new(),
            queries: &[],
            handler,
        }
    }

    pub(super) fn open(mut self) -> Self {
        self.open = true;
        self
    }

    pub(super) fn asks(mut self) -> Self {
        self.asks = true;
        self
    }

    pub(super) fn takes<T: DeserializeOwned + JsonSchema>(self, example: &'static str) -> Self {
        self.body::<T>(example, true, BODY)
    }

    pub(super) fn may_take<T: DeserializeOwned + JsonSchema>(self, example: &'static str) -> Self {
        self.body::<T>(example, false, BODY)
    }

    pub(super) fn body<T: DeserializeOwned + JsonSchema>(
        mut self,
        example: &'static str,
        required: bool,
        limit: usize,
    ) -> Self {
        self.takes = Some(Takes {
            schema: SchemaGenerator::subschema_for::<T>,
            #[cfg(test)]
            reads: |text| strict::read::<T>(text).map(drop),
            required,
            limit,
            example,
        });
        self
    }

    pub(super) fn gives<T: JsonSchema>(mut self, status: u16, what: &'static str) -> Self {
        self.gives.push(Gives {
            status,
            what,
            content: "application/json",
            schema: Some(SchemaGenerator::subschema_for::<T>),
        });
        self
    }

    pub(super) fn gives_text(
        mut self,
        status: u16,
        content: &'static str,
        what: &'static str,
    ) -> Self {
        self.gives.push(Gives {
            status,
            what,
            content,
            schema: None,
        });
        self
    }

    pub(super) fn queries(mut self, queries: &'static [Query]) -> Self {
        self.queries = queries;
        self
    }

    pub(super) fn problems(mut self, kinds: &[Kind]) -> Self {
        self.problems.extend_from_slice(kinds);
        self
    }
}
