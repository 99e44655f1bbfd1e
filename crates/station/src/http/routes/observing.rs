//! Monitoring: health, metrics, events.

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
            "Whether the station is alive, for a supervisor that restarts it; the arm may be disconnected",
            metrics::health,
        )
        .open()
        .gives_text(200, "text/plain; charset=utf-8", "`ok`")
        .problems(&[ENDING]),
        Route::new(
            GET,
            "/metrics",
            "The metrics of arm, link, queue, laser and job, for Prometheus",
            metrics::metrics,
        )
        .gives_text(200, "text/plain; version=0.0.4; charset=utf-8", "the metrics"),
        Route::new(
            GET,
            "/api/v1/events",
            "States and notices as server-sent events: `state` and `notice`, each with a message as in `ToClient`. A \
                notice has its number as its id; with `Last-Event-ID` the missed ones are sent first, \
                as far as the station has kept them.",
            events::events,
        )
        .queries(WATCH_QUERIES)
        .gives_as::<ServerSentEvent>(200, "text/event-stream", "the events")
        .problems(&[MALFORMED, TOO_MANY_CLIENTS, ENDING]),
        Route::new(
            GET,
            "/api/v1/packets",
            "All packets between the station and the arm, in both directions and decoded, from now on, as server-sent events: \
                `packet`, or `lost` with the number of packets that were dropped because the client was too slow",
            packets::packets,
        )
        .gives_as::<ServerSentEvent>(200, "text/event-stream", "the packets")
        .problems(&[TOO_MANY_CLIENTS, ENDING]),
    ]
}
