//! The metrics of the station for Prometheus (text format 0.0.4).

use std::fmt::Write;
use std::sync::Arc;

use axum::extract::State;
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};
use dobot_api::problem_kinds::ENDING;
use dobot_api::{self as api, LinkPhase};

use crate::http::app::App;
use crate::http::exchange::responses::RequestFailed;

/// Returns whether the station is alive.
pub(crate) async fn health(State(app): State<Arc<App>>) -> Result<&'static str, RequestFailed> {
    if *app.ending.borrow() {
        return Err(ENDING.problem("the station is shutting down").into());
    }
    Ok("ok\n")
}

/// Returns all metrics.
pub(crate) async fn metrics(State(app): State<Arc<App>>) -> Response {
    let text = text(app.handle.state().state());
    (
        [(CONTENT_TYPE, "text/plain; version=0.0.4; charset=utf-8")],
        text,
    )
        .into_response()
}

/// Returns the metrics of a state, in seconds, millimetres and degrees.
pub(crate) fn text(state: &api::State) -> String {
    let mut page = Page::default();
    page.gauge(
        "dobot_link_up",
        "Whether the arm is connected",
        state.link.phase == LinkPhase::Up,
    );
    page.gauge(
        "dobot_statuses_per_second",
        "Statuses of the arm per second",
        state.link.statuses_per_s,
    );
    page.counter(
        "dobot_statuses_lost_total",
        "Missing statuses",
        state.link.lost_statuses,
    );
    page.counter(
        "dobot_damaged_bytes_total",
        "Bytes outside of statuses",
        state.link.damaged_bytes,
    );
    if let Some(latency_ms) = state.link.latency_ms {
        page.gauge(
            "dobot_latency_seconds",
            "Time from a command to the status that confirms it",
            latency_ms / 1000.0,
        );
    }
    page.gauge(
        "dobot_pose_trusted",
        "Whether the reported pose is trusted",
        state.trust.trusted,
    );
    let queue = &state.queue;
    page.begin(
        "dobot_queue_commands",
        "Commands that have not finished",
        "gauge",
    );
    page.sample("dobot_queue_commands", "place=\"station\"", queue.waiting);
    page.sample("dobot_queue_commands", "place=\"arm\"", queue.under_way);
    page.gauge(
        "dobot_queue_ahead_seconds",
        "Duration of the in-flight commands",
        queue.ahead_s,
    );
    page.gauge(
        "dobot_stopped",
        "Whether the arm is stopped",
        state.stop.is_some(),
    );
    page.gauge("dobot_laser_on", "Whether the laser is on", state.laser.on);
    page.gauge(
        "dobot_laser_armed_seconds",
        "Remaining time for which the laser is armed",
        state.laser.armed_for_s,
    );
    page.gauge(
        "dobot_control_taken",
        "Whether a client has control",
        state.lease.is_some(),
    );
    page.gauge("dobot_clients", "Clients of the station", state.clients);
    if let Some(arm) = &state.arm {
        page.arm(arm);
    }
    if let Some(job) = &state.job {
        page.begin("dobot_job_commands", "Commands of the job", "gauge");
        page.sample("dobot_job_commands", "which=\"all\"", job.commands);
        page.sample("dobot_job_commands", "which=\"done\"", job.completed);
    }
    page.0
}

#[derive(Debug, Default)]
struct Page(String);

impl Page {
    fn arm(&mut self, arm: &api::ArmView) {
        let status = &arm.status;
        self.gauge("dobot_arm_moving", "Whether the arm is moving", arm.moving);
        self.gauge("dobot_suction_on", "Whether the pump is on", status.suction);
        let position = [("x", status.x_mm), ("y", status.y_mm), ("z", status.z_mm)];
        self.gauges(
            "dobot_arm_position_millimetres",
            "Position of the arm",
            "axis",
            &position,
        );
        let joints = [
            ("base", status.base_deg),
            ("rear", status.rear_deg),
            ("fore", status.fore_deg),
            ("servo", status.servo_deg),
        ];
        self.gauges(
            "dobot_arm_joint_degrees",
            "Angles of the joints",
            "joint",
            &joints,
        );
    }

    fn gauge(&mut self, name: &str, help: &str, value: impl Value) {
        self.begin(name, help, "gauge");
        self.sample(name, "", value);
    }

    /// Adds a gauge with a value for each value of a label.
    fn gauges<V: Value + Copy>(&mut self, name: &str, help: &str, label: &str, all: &[(&str, V)]) {
        self.begin(name, help, "gauge");
        for &(item, value) in all {
            self.sample(name, &format!("{label}=\"{item}\""), value);
        }
    }

    fn counter(&mut self, name: &str, help: &str, value: impl Value) {
        self.begin(name, help, "counter");
        self.sample(name, "", value);
    }

    fn begin(&mut self, name: &str, help: &str, kind: &str) {
        let _ = write!(self.0, "# HELP {name} {help}.\n# TYPE {name} {kind}\n");
    }

    fn sample(&mut self, name: &str, labels: &str, value: impl Value) {
        let value = value.number();
        let _ = if labels.is_empty() {
            writeln!(self.0, "{name} {value}")
        } else {
            writeln!(self.0, "{name}{{{labels}}} {value}")
        };
    }
}

/// A value of a metric.
trait Value {
    fn number(self) -> f64;
}

impl Value for bool {
    fn number(self) -> f64 {
        f64::from(u8::from(self))
    }
}

impl Value for f64 {
    fn number(self) -> f64 {
        self
    }
}

impl Value for f32 {
    fn number(self) -> f64 {
        f64::from(self)
    }
}

impl Value for usize {
    #[expect(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
    fn number(self) -> f64 {
        self as f64
    }
}

impl Value for u64 {
    #[expect(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
    fn number(self) -> f64 {
        self as f64
    }
}
