//! The reasons why the arm cannot move, as `diagnostic_msgs`.

use dobot_api::{LinkPhase, LinkView, State};
use dobot_safety::Policy;

use crate::messages::{DiagnosticArray, DiagnosticStatus, Header, KeyValue};

/// Returns the diagnostics for `/diagnostics`; the name of each status begins with the node's name.
pub(crate) fn of_state(node: &str, state: &State, rules: Option<&Policy>) -> DiagnosticArray {
    let statuses = [
        policy(rules),
        link(&state.link),
        pose(state),
        stop(state),
        queue(state),
        control(state),
        laser(state),
    ];
    let hardware_id = state.link.address.clone().unwrap_or_default();
    array(node, &hardware_id, statuses.into_iter().collect())
}

/// Returns the diagnostics while the station does not respond.
pub(crate) fn of_no_station(node: &str, why: &str) -> DiagnosticArray {
    let silent = Diagnosis::new("station", Level::Error, why);
    array(node, "", vec![silent])
}

fn array(node: &str, hardware_id: &str, found: Vec<Diagnosis>) -> DiagnosticArray {
    let message = |diagnosis: Diagnosis| DiagnosticStatus {
        level: diagnosis.level as u8,
        name: format!("{node}: {}", diagnosis.name),
        message: diagnosis.message,
        hardware_id: hardware_id.to_owned(),
        values: diagnosis.values,
    };
    DiagnosticArray {
        header: Header::now(""),
        status: found.into_iter().map(message).collect(),
    }
}

/// The state of one component.
struct Diagnosis {
    name: &'static str,
    level: Level,
    message: String,
    values: Vec<KeyValue>,
}

/// The levels of `diagnostic_msgs/DiagnosticStatus`.
#[derive(Clone, Copy)]
enum Level {
    Ok = 0,
    Warn = 1,
    Error = 2,
    Stale = 3,
}

impl Diagnosis {
    fn new(name: &'static str, level: Level, message: impl Into<String>) -> Self {
        Self {
            name,
            level,
            message: message.into(),
            values: Vec::new(),
        }
    }

    #[expect(clippy::needless_pass_by_value, reason = "more readable calls")]
    fn with(mut self, key: &str, value: impl ToString) -> Self {
        self.values.push(KeyValue {
            key: key.to_owned(),
            value: value.to_string(),
        });
        self
    }
}

fn link(link: &LinkView) -> Diagnosis {
    let (level, usual) = match link.phase {
        LinkPhase::Up => (Level::Ok, "statuses come"),
        LinkPhase::Searching => (Level::Error, "no arm has been found yet"),
        LinkPhase::Listening => (Level::Stale, "the port is open, but the arm sends nothing"),
        LinkPhase::Lost => (Level::Error, "no more statuses arrive"),
    };
    let message = link.problem.as_deref().unwrap_or(usual);
    let found = Diagnosis::new("link", level, message)
        .with("statuses_per_s", format!("{:.1}", link.statuses_per_s))
        .with("lost_statuses", link.lost_statuses)
        .with("damaged_bytes", link.damaged_bytes);
    let found = match &link.remedy {
        Some(remedy) => found.with("remedy", remedy),
        None => found,
    };
    match link.latency_ms {
        Some(ms) => found.with("latency_ms", format!("{ms:.0}")),
        None => found,
    }
}

fn pose(state: &State) -> Diagnosis {
    let trust = &state.trust;
    if trust.trusted {
        return Diagnosis::new("pose", Level::Ok, "the reported pose is trusted");
    }
    let why = trust
        .reason
        .as_deref()
        .unwrap_or("not confirmed by a person");
    Diagnosis::new(
        "pose",
        Level::Error,
        format!(
            "the pose of the arm is not trusted: {why}; a person must check and confirm it on the station's page"
        ),
    )
}

fn stop(state: &State) -> Diagnosis {
    let Some(stop) = &state.stop else {
        return Diagnosis::new("stop", Level::Ok, "the arm may move");
    };
    let text = format!("{}; a person must reset the stop", stop.text());
    Diagnosis::new("stop", Level::Error, text).with("at_rest", stop.at_rest)
}

fn queue(state: &State) -> Diagnosis {
    let message = match &state.job {
        Some(job) => format!("job {}: {}", job.job, job.title),
        None => "no job is running".to_owned(),
    };
    let queue = &state.queue;
    Diagnosis::new("queue", Level::Ok, message)
        .with("waiting", queue.waiting)
        .with("under_way", queue.under_way)
        .with("ahead_s", format!("{:.2}", queue.ahead_s))
}

fn control(state: &State) -> Diagnosis {
    let message = match &state.lease {
        Some(lease) => format!("{} has control", lease.name),
        None => "control is free".to_owned(),
    };
    Diagnosis::new("control", Level::Ok, message).with("clients", state.clients)
}

fn policy(policy: Option<&Policy>) -> Diagnosis {
    let Some(policy) = policy else {
        return Diagnosis::new(
            "policy",
            Level::Stale,
            "the policy of the station is not available",
        );
    };
    let (joints, workspace, speed) = (&policy.joints, &policy.workspace, &policy.speed);
    Diagnosis::new(
        "policy",
        Level::Ok,
        "every path is checked against the policy",
    )
    .with("base_deg", joints.base_deg)
    .with("rear_deg", joints.rear_deg)
    .with("fore_deg", joints.fore_deg)
    .with("servo_deg", joints.servo_deg)
    .with("reach_mm", workspace.reach_mm)
    .with("z_mm", workspace.z_mm)
    .with("joint_deg_s", speed.joint_deg_s)
    .with("line_mm_s", speed.line_mm_s)
    .with("keep_outs", policy.keep_out.len())
}

fn laser(state: &State) -> Diagnosis {
    let laser = &state.laser;
    let (level, message) = if laser.on {
        (Level::Warn, "the laser may be on")
    } else if laser.armed_for_s > 0.0 {
        (Level::Warn, "the laser is armed")
    } else {
        (Level::Ok, "the laser is disarmed")
    };
    Diagnosis::new("laser", level, message).with("armed_for_s", format!("{:.0}", laser.armed_for_s))
}

#[cfg(test)]
mod tests {
    use dobot_controller::{Personality, PowerUp};
    use dobot_host::StationClient;

    use super::*;

    async fn state() -> State {
        let power_up = PowerUp::new(Personality::Firmware11);
        let mut station = StationClient::with_virtual_arm(power_up, Policy::default(), "test");
        station.first_state().await.expect("the station reports")
    }

    fn level(found: &DiagnosticArray, name: &str) -> u8 {
        let named = |status: &&DiagnosticStatus| status.name == format!("dobot: {name}");
        found
            .status
            .iter()
            .find(named)
            .expect("it is reported")
            .level
    }

    #[tokio::test]
    async fn an_arm_without_faults_is_ok_in_everything() {
        let mut state = state().await;
        // A virtual arm is harmless, so its laser is armed.
        state.laser.armed_for_s = 0.0;
        let found = of_state("dobot", &state, Some(&Policy::default()));
        assert!(
            found.status.iter().all(|status| status.level == 0),
            "{found:?}"
        );
        assert_eq!(found.status.len(), 7);
    }

    #[tokio::test]
    async fn a_lost_link_is_reported_with_its_remedy() {
        let mut state = state().await;
        state.link.phase = LinkPhase::Lost;
        state.link.remedy = Some("plug the cable in".to_owned());
        let found = of_state("dobot", &state, Some(&Policy::default()));
        let link = found
            .status
            .iter()
            .find(|status| status.name == "dobot: link");
        let values = &link.expect("it is reported").values;
        assert!(
            values
                .iter()
                .any(|value| value.value == "plug the cable in"),
            "{values:?}"
        );
    }

    #[tokio::test]
    async fn anything_that_prevents_motion_is_an_error_with_its_reason() {
        let mut state = state().await;
        state.link.phase = LinkPhase::Lost;
        state.trust.trusted = false;
        state.trust.reason = Some("it was reset".to_owned());
        state.laser.armed_for_s = 60.0;
        let found = of_state("dobot", &state, None);
        assert_eq!(level(&found, "link"), 2);
        assert_eq!(level(&found, "pose"), 2);
        assert_eq!(level(&found, "stop"), 0);
        assert_eq!(level(&found, "laser"), 1);
        let is_reported = found
            .status
            .iter()
            .any(|status| status.message.contains("it was reset"));
        assert!(is_reported, "{found:?}");
    }
}
