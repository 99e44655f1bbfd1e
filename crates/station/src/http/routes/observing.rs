//! What other programs watch the station by: whether it lives, its figures, what happens.

use super::GET;
use crate::http::live::events::{self, ServerSentEvent};
use crate::http::live::packets;
use crate::http::live::socket::WATCH_QUERIES;
use crate::http::resources::metrics;
use crate::http::route::Route;
use dobot_api::problem_kinds::{ENDING, MALFORMED, TOO_MANY_CLIENTS};

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            "/healthz",
            "Whether the station lives, for what starts it again if it does not; the arm may be away",
            metrics::health,
        )
        .open()
        .gives_text(200, "text/plain; charset=utf-8", "`ok`")
        .problems(&[ENDING]),
        Route::new(
            GET,
            "/metrics",
            "The figures of arm, link, queue, laser and job, as Prometheus reads them",
            metrics::metrics,
        )
        .gives_text(200, "text/plain; version=0.0.4; charset=utf-8", "the figures"),
        Route::new(
            GET,
            "/api/v1/events",
            "States and notices as server-sent events: `state` and `notice`, each with a message as in `ToClient`. A \
                notice has its number as its id; with `Last-Event-ID` those come first that were missed, \
                as far as the station remembers them.",
            events::events,
        )
        .queries(WATCH_QUERIES)
        .gives_as::<ServerSentEvent>(200, "text/event-stream", "the events")
        .problems(&[MALFORMED, TOO_MANY_CLIENTS, ENDING]),
        Route::new(
            GET,
            "/api/v1/packets",
            "Every packet between the station and the arm, both ways and decoded, from now on, as server-sent events: \
                `packet`, or `lost` with how many came too fast for the one who listens",
            packets::packets,
        )
        .gives_as::<ServerSentEvent>(200, "text/event-stream", "the packets")
        .problems(&[TOO_MANY_CLIENTS, ENDING]),
    ]
}
