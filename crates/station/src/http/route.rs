//! One route: its request, action and responses, for the router and the document.

use std::fmt;
use std::pin::Pin;
use std::sync::Arc;

use axum::extract::{FromRequest, Request as HttpRequest};
use axum::handler::Handler;
use axum::http::Method;
use axum::response::Response;
use axum::routing::{MethodFilter, MethodRouter, on};
#[cfg(test)]
use dobot_api::Problem;
use dobot_api::problem_kinds::{KEY_REUSED, MALFORMED, ProblemKind};
use dobot_api::{Reply, Request};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::DeserializeOwned;

use crate::http::app::App;
use crate::http::exchange::requester::Requester;
use crate::http::exchange::responses::{BODY, Body, Maybe, Nothing, OfJob, RequestFailed};
#[cfg(test)]
use crate::http::exchange::strict_json;

/// Generates the schema of a type.
type SchemaOf = fn(&mut SchemaGenerator) -> Schema;

/// One route.
#[derive(Clone, Debug)]
pub(super) struct Route {
    pub(super) method: Method,
    pub(super) path: &'static str,
    pub(super) summary: &'static str,
    /// Whether it is public, even without a token.
    pub(super) open: bool,
    /// Whether it acts for a client, so that it accepts the header `Dobot-Lease`.
    pub(super) asks: bool,
    /// Whether it queues a job, so that it accepts the header `Idempotency-Key`.
    pub(super) queues: bool,
    pub(super) takes: Option<Takes>,
    pub(super) gives: Vec<Gives>,
    pub(super) problems: Vec<ProblemKind>,
    pub(super) queries: &'static [Query],
    pub(super) action: Action,
}

/// The handler of a route. One type for all routes, since `axum` is compiled again for each type of
/// handler.
#[derive(Clone)]
pub(super) struct Action(Arc<dyn Fn(HttpRequest, Arc<App>) -> Answering + Send + Sync>);

/// A pending response.
type Answering = Pin<Box<dyn Future<Output = Response> + Send>>;

impl Action {
    fn new<T: 'static>(handler: impl Handler<T, Arc<App>, Future = Answering>) -> Self {
        Self(Arc::new(move |request, app| {
            handler.clone().call(request, app)
        }))
    }
}

impl Handler<(), Arc<App>> for Action {
    type Future = Answering;

    fn call(self, request: HttpRequest, app: Arc<App>) -> Answering {
        (self.0)(request, app)
    }
}

impl fmt::Debug for Action {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Action").finish_non_exhaustive()
    }
}

/// A request body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Takes {
    pub(super) schema: SchemaOf,
    /// Parses the body, for tests.
    #[cfg(test)]
    pub(super) reads: fn(&[u8]) -> Result<(), Problem>,
    pub(super) required: bool,
    pub(super) limit: usize,
    pub(super) example: &'static str,
}

/// A response that is not a problem.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gives {
    pub(super) status: u16,
    pub(super) what: &'static str,
    /// Its content type and schema, if it has a body.
    pub(super) body: Option<(&'static str, SchemaOf)>,
}

/// A query parameter.
#[derive(Clone, Copy, Debug)]
pub(super) struct Query {
    pub(super) name: &'static str,
    pub(super) what: &'static str,
    pub(super) schema: SchemaOf,
}

/// The body of a request to the driver.
pub(super) trait Entry:
    FromRequest<Arc<App>, Rejection = RequestFailed> + Send + 'static
{
    /// Returns its description.
    fn takes() -> Takes;
}

impl<T, const LIMIT: usize> Entry for Body<T, LIMIT>
where
    T: DeserializeOwned + JsonSchema + Send + 'static,
{
    fn takes() -> Takes {
        Takes::of::<T>(true, LIMIT)
    }
}

impl<T> Entry for Maybe<T>
where
    T: DeserializeOwned + JsonSchema + Default + Send + 'static,
{
    fn takes() -> Takes {
        Takes::of::<T>(false, BODY)
    }
}

impl Entry for OfJob {
    fn takes() -> Takes {
        Takes::of::<Nothing>(false, BODY)
    }
}

impl Takes {
    fn of<T: DeserializeOwned + JsonSchema>(required: bool, limit: usize) -> Self {
        Self {
            schema: SchemaGenerator::subschema_for::<T>,
            #[cfg(test)]
            reads: |text| strict_json::read::<T>(text).map(drop),
            required,
            limit,
            example: "{}",
        }
    }
}

impl Route {
    /// Returns a route with a handler.
    pub(super) fn new<T: 'static>(
        method: Method,
        path: &'static str,
        summary: &'static str,
        handler: impl Handler<T, Arc<App>, Future = Answering>,
    ) -> Self {
        Self::with(method, path, summary, Action::new(handler))
    }

    const fn with(
        method: Method,
        path: &'static str,
        summary: &'static str,
        action: Action,
    ) -> Self {
        Self {
            method,
            path,
            summary,
            open: false,
            asks: false,
            queues: false,
            takes: None,
            gives: Vec::new(),
            problems: Vec::new(),
            queries: &[],
            action,
        }
    }

    /// Returns the handler for the router.
    pub(super) fn handler(&self) -> MethodRouter<Arc<App>> {
        let filter = MethodFilter::try_from(self.method.clone()).expect("it is a method of HTTP");
        on(filter, self.action.clone())
    }

    pub(super) fn open(mut self) -> Self {
        self.open = true;
        self
    }

    /// Returns a route that sends the driver a request made from its body.
    pub(super) fn asks<E: Entry>(
        method: Method,
        path: &'static str,
        summary: &'static str,
        request: fn(E) -> Request,
    ) -> Self {
        let ask = move |requester: Requester, entry: E| async move {
            requester.ask(request(entry)).await
        };
        Self::new(method, path, summary, ask).brings::<E>()
    }

    /// Sets the body of a request to the driver.
    pub(super) fn brings<E: Entry>(mut self) -> Self {
        self.asks = true;
        self.takes = Some(E::takes());
        self
    }

    /// Makes the route queue a job, once for each key.
    pub(super) fn queues(self) -> Self {
        self.keyed()
            .gives::<Reply>(
                201,
                "the job is queued; the header Location contains its path",
            )
            .problems(&[MALFORMED, KEY_REUSED])
    }

    /// Makes the route carry out a request once for each key.
    pub(super) fn keyed(mut self) -> Self {
        self.queues = true;
        self
    }

    /// Sets an example of the body.
    pub(super) fn example(mut self, example: &'static str) -> Self {
        if let Some(takes) = &mut self.takes {
            takes.example = example;
        }
        self
    }

    pub(super) fn gives<T: JsonSchema>(self, status: u16, what: &'static str) -> Self {
        self.gives_as::<T>(status, "application/json", what)
    }

    pub(super) fn gives_text(self, status: u16, content: &'static str, what: &'static str) -> Self {
        self.gives_as::<String>(status, content, what)
    }

    /// Adds a response with a body of this content type; for server-sent events the schema is that
    /// of each event.
    pub(super) fn gives_as<T: JsonSchema>(
        mut self,
        status: u16,
        content: &'static str,
        what: &'static str,
    ) -> Self {
        self.gives.push(Gives {
            status,
            what,
            body: Some((content, SchemaGenerator::subschema_for::<T>)),
        });
        self
    }

    /// Adds a response without a body.
    pub(super) fn gives_nothing(mut self, status: u16, what: &'static str) -> Self {
        self.gives.push(Gives {
            status,
            what,
            body: None,
        });
        self
    }

    pub(super) fn queries(mut self, queries: &'static [Query]) -> Self {
        self.queries = queries;
        self
    }

    pub(super) fn problems(mut self, kinds: &[ProblemKind]) -> Self {
        self.problems.extend_from_slice(kinds);
        self
    }
}
