//! Paging of long lists.

use std::sync::Arc;

use axum::Json;
use axum::extract::rejection::QueryRejection;
use axum::extract::{FromRequestParts, Query as Queries};
use axum::http::Uri;
use axum::http::header::LINK;
use axum::http::request::Parts;
use axum::response::{IntoResponse, Response};
use dobot_api::Problem;
use dobot_api::problem_kinds::{MALFORMED, OUT_OF_RANGE};
use schemars::SchemaGenerator;
use serde::{Deserialize, Serialize};

use crate::http::app::App;
use crate::http::exchange::responses::RequestFailed;
use crate::http::route::Query;

/// The requested page of a list.
#[derive(Debug)]
pub(crate) struct Page {
    path: String,
    asked: Asked,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Asked {
    limit: Option<usize>,
    after: Option<String>,
}

/// The query parameters of paging.
pub(crate) const PAGES: &[Query] = &[
    Query {
        name: "limit",
        what: "Maximum number of items, 1 to 1000 (default: all)",
        schema: SchemaGenerator::subschema_for::<usize>,
    },
    Query {
        name: "after",
        what: "Number or name of the last item of the previous page; the header Link contains the address of the next page",
        schema: SchemaGenerator::subschema_for::<String>,
    },
];

impl FromRequestParts<Arc<App>> for Page {
    type Rejection = RequestFailed;

    async fn from_request_parts(parts: &mut Parts, app: &Arc<App>) -> Result<Self, RequestFailed> {
        let path = parts.uri.path().to_owned();
        let asked: Result<Queries<Asked>, QueryRejection> =
            Queries::from_request_parts(parts, app).await;
        let Queries(asked) = asked.map_err(|error| MALFORMED.problem(error.body_text()))?;
        if let Some(limit) = asked.limit.filter(|limit| !(1..=MAX_PAGE).contains(limit)) {
            let text = format!("limit is {limit}; allowed is 1 to {MAX_PAGE}");
            return Err(OUT_OF_RANGE.problem(text).into());
        }
        Ok(Self { path, asked })
    }
}

impl Page {
    /// Returns this page of a list, with a link to the next one. Each item has a unique name.
    pub(crate) fn of<T: Serialize>(
        self,
        all: &[T],
        name: impl Fn(&T) -> String,
    ) -> Result<Response, RequestFailed> {
        let begin = self.begin(all, &name)?;
        let end = self.asked.limit.map_or(all.len(), |limit| begin + limit);
        let page = &all[begin..end.min(all.len())];
        let body = Json(page).into_response();
        let Some((limit, last)) = self.asked.limit.zip(page.last()) else {
            return Ok(body);
        };
        if end >= all.len() {
            return Ok(body);
        }
        let next = format!("{}?limit={limit}&after={}", self.path, name(last));
        let next: Uri = next
            .parse()
            .map_err(|_| MALFORMED.problem("the name cannot be part of an address"))?;
        Ok(([(LINK, format!("<{next}>; rel=\"next\""))], body).into_response())
    }

    /// Returns the index of the first item of this page.
    fn begin<T>(&self, all: &[T], name: impl Fn(&T) -> String) -> Result<usize, Problem> {
        let Some(after) = &self.asked.after else {
            return Ok(0);
        };
        let at = all.iter().position(|item| name(item) == *after);
        let gone = || {
            OUT_OF_RANGE.problem(format!(
                "after is {after:?}, which is not in the list any more; start again without it"
            ))
        };
        Ok(at.ok_or_else(gone)? + 1)
    }
}

/// The maximum size of a page.
const MAX_PAGE: usize = 1000;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    const ALL: [&str; 5] = ["a", "b", "c", "d", "e"];

    fn page(limit: Option<usize>, after: Option<&str>) -> Page {
        let after = after.map(str::to_owned);
        Page {
            path: "/api/v1/jobs".into(),
            asked: Asked { limit, after },
        }
    }

    /// Returns the body and the Link header of a page.
    async fn shown(page: Page) -> (String, Option<String>) {
        let answer = page.of(&ALL, |page| (*page).to_owned()).unwrap();
        let next = answer.headers().get(LINK).cloned();
        let body = axum::body::to_bytes(answer.into_body(), 1000)
            .await
            .unwrap();
        let body = String::from_utf8(body.to_vec()).unwrap();
        (body, next.map(|link| link.to_str().unwrap().to_owned()))
    }

    #[tokio::test]
    async fn each_page_names_the_next_one_to_the_end() {
        let link = |after: &str| {
            Some(format!(
                "</api/v1/jobs?limit=2&after={after}>; rel=\"next\""
            ))
        };
        let two = |after| shown(page(Some(2), after));
        assert_eq!(two(None).await, (r#"["a","b"]"#.to_owned(), link("b")));
        assert_eq!(two(Some("b")).await, (r#"["c","d"]"#.to_owned(), link("d")));
        assert_eq!(two(Some("d")).await, (r#"["e"]"#.to_owned(), None));
        let all = shown(page(None, None)).await;
        assert_eq!(all, (r#"["a","b","c","d","e"]"#.to_owned(), None));
        assert_eq!(shown(page(None, Some("c"))).await.0, r#"["d","e"]"#);
    }

    #[test]
    fn a_page_after_a_deleted_item_asks_the_client_to_start_again() {
        let error = page(Some(2), Some("x"))
            .of(&ALL, |page| (*page).to_owned())
            .unwrap_err();
        assert!(error.0.detail.contains("start again without"), "{error:?}");
    }
}
