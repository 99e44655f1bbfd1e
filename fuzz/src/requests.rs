use std::time::Duration;

use dobot_api::{FromClient, Reply, Request};
use dobot_controller::{Personality, PowerUp};
use dobot_host::VirtualStation;
use dobot_safety::Policy;
use dobot_wire::{Command, Decoder, Dialect, Packet};

/// Requests that anybody sends to a station: an error, or a request that is written and read again
/// unchanged, and that the rules carry out without a panic. Jobs that are kept can be read, what
/// reaches the arm makes sense, and when the time is over that a stop promises, it is dark.
pub fn requests(input: &[u8]) {
    let text = crate::spelled(input, WORDS);
    let requests: Vec<Request> = String::from_utf8_lossy(&text)
        .lines()
        .filter_map(read)
        .collect();
    if !requests.is_empty() {
        ask(requests);
    }
}

/// A request, alone or in a message of the WebSocket.
fn read(line: &str) -> Option<Request> {
    let message = serde_json::from_str(line).map(|message: FromClient| message.request);
    let request = message.or_else(|_| serde_json::from_str(line)).ok()?;
    let again = serde_json::to_string(&request).expect("a request is JSON");
    // A number beyond single precision is read as infinite, for which JSON has no number.
    if let Ok(again) = serde_json::from_str::<Request>(&again) {
        assert_eq!(again, request);
    }
    Some(request)
}

/// Asks for one after the other, a tenth of a second apart.
fn ask(requests: Vec<Request>) {
    let power_up = PowerUp::new(Personality::Firmware11);
    let mut station = VirtualStation::new(power_up, Policy::default());
    station.run_for(Duration::from_millis(500));
    let anna = station.client("Anna");
    for request in [Request::TakeLease, Request::ConfirmPose] {
        station.ask(anna, request).expect("she is alone");
    }
    for request in requests {
        if let Err(refusal) = station.ask(anna, request) {
            assert!(!refusal.to_string().is_empty() && !refusal.kind().is_empty());
        }
        station.run_for(Duration::from_millis(100));
    }
    station.jobs().expect("what was kept can be read");
    let stop = station.ask(anna, Request::Stop { reason: None });
    let Ok(Reply::Stopping { rests_within_s, .. }) = stop else {
        panic!("anyone may stop at any time: {stop:?}");
    };
    // What the arm has been sent already, it finishes first; laser off waits behind that.
    station.run_for(Duration::from_secs_f64(rests_within_s) + Duration::from_millis(500));
    for (at, bytes) in station.packets() {
        let mut decoder = Decoder::commands();
        let packets: Vec<Packet> = decoder.feed(bytes).collect();
        let [packet] = &packets[..] else {
            panic!("{at:?}: {bytes:?} are no packet");
        };
        let command = Command::parse(packet, &Dialect::FIRMWARE_1_1);
        assert!(command.is_ok(), "{at:?}: {command:?}");
    }
    assert!(!station.into_arm().controller().laser());
}

const WORDS: &[&str] = &[
    "{\"type\":\"command\",\"command\":{\"type\":\"move_to\",\"x_mm\":220,\"y_mm\":30,\"z_mm\":30,\
     \"rotation_deg\":0,\"suction\":false,\"mode\":\"movl\",\"gripper_deg\":0,\"pause_s\":0}}\n",
    "{\"type\":\"command\",\"command\":{\"type\":\"write_vector\",\"mode\":\"laser\",\"x_mm\":9,\"y_mm\":9,\
     \"z_mm\":0,\"laser\":true,\"start_speed_mm_s\":20,\"end_speed_mm_s\":20,\
     \"max_speed_mm_s\":20,\"stop\":false}}\n",
    "{\"type\":\"command\",\"command\":{\"type\":\"configuration\",\"mode\":\"end_effector\",\
     \"tool\":\"laser\"}}\n",
    "{\"type\":\"jog\",\"jog\":{\"frame\":\"joint\",\"axis\":\"laser_on\",\"speed_percent\":50}}\n",
    "{\"type\":\"jog\",\"jog\":{\"frame\":\"linear\",\"axis\":\"z_minus\",\"speed_percent\":90}}\n",
    "{\"type\":\"submit_job\",\"job\":{\"title\":\"t\",\"kind\":\"program\",\"commands\":[\
     {\"type\":\"move_joints\",\"base_deg\":20,\"rear_deg\":30,\"fore_deg\":40,\"servo_deg\":0,\
     \"suction\":true,\"mode\":\"movj\",\"gripper_deg\":0,\"pause_s\":1}]}}\n",
    "{\"type\":\"command\",\"command\":",
    "{\"type\":\"move_to\",\"x_mm\":220,\"y_mm\":0,\"z_mm\":30,",
    "{\"type\":\"move_to\",\"x_mm\":200,\"y_mm\":-50,\"z_mm\":",
    "{\"type\":\"move_joints\",\"base_deg\":20,\"rear_deg\":30,\"fore_deg\":40,\"servo_deg\":",
    "\"rotation_deg\":0,",
    "\"suction\":true,\"mode\":\"jump\",\"gripper_deg\":0,\"pause_s\":0}",
    "\"suction\":false,\"mode\":\"movl\",\"gripper_deg\":0,\"pause_s\":",
    "{\"type\":\"write_vector\",\"mode\":\"writing\",\"x_mm\":20,\"y_mm\":-9,\"z_mm\":1,\"laser\":false,",
    "{\"type\":\"write_vector\",\"mode\":\"laser\",\"x_mm\":9,\"y_mm\":9,\"z_mm\":0,\"laser\":true,",
    "\"start_speed_mm_s\":0,\"end_speed_mm_s\":0,\"max_speed_mm_s\":40,\"stop\":false}",
    "\"start_speed_mm_s\":20,\"end_speed_mm_s\":20,\"max_speed_mm_s\":20,\"stop\":false}",
    "\"start_speed_mm_s\":0,\"end_speed_mm_s\":9,\"stop\":true,\"max_speed_mm_s\":",
    "{\"type\":\"configuration\",\"mode\":\"end_effector\",\"tool\":\"laser\"}",
    "{\"type\":\"configuration\",\"mode\":\"writing\",\"acceleration_mm_s2\":",
    "{\"type\":\"configuration\",\"mode\":\"initial_angles\",\"rear_deg\":45,\"fore_deg\":",
    "{\"type\":\"playback_adjustment\",\"speed_percent\":50,\"acceleration_percent\":50}",
    "{\"type\":\"gesture\",\"x\":1,\"y\":1,\"z\":1,\"grab\":true}",
    "{\"type\":\"mouse_move\",\"x\":1,\"y\":1,\"z\":1,\"rotation_deg\":0,\"suction\":false}",
    "{\"type\":\"jog\",\"jog\":{\"frame\":\"joint\",\"axis\":\"base_plus\",\"speed_percent\":",
    "{\"type\":\"jog\",\"jog\":{\"frame\":\"joint\",\"axis\":\"laser_on\",\"speed_percent\":",
    "{\"type\":\"jog\",\"jog\":{\"frame\":\"linear\",\"axis\":\"z_minus\",\"speed_percent\":",
    "{\"type\":\"linear_jog\",\"axis\":\"released\",\"speed_percent\":",
    "{\"type\":\"release\"}\n",
    "{\"type\":\"stop\"}\n",
    "{\"type\":\"stop\",\"reason\":\"",
    "{\"type\":\"reset_stop\"}\n",
    "{\"type\":\"take_lease\"}\n",
    "{\"type\":\"release_lease\"}\n",
    "{\"type\":\"ask_lease\"}\n",
    "{\"type\":\"grant_lease\",\"to\":1}\n",
    "{\"type\":\"seize_lease\"}\n",
    "{\"type\":\"arm_laser\",\"for_s\":60}\n",
    "{\"type\":\"arm_laser\",\"for_s\":",
    "{\"type\":\"disarm_laser\"}\n",
    "{\"type\":\"confirm_pose\"}\n",
    "{\"type\":\"set_dialect\",\"dialect\":\"firmware-1.1\"}\n",
    "{\"type\":\"detect\"}\n",
    "{\"type\":\"submit_job\",\"job\":{\"title\":\"t\",\"kind\":\"drawing\",\"commands\":[",
    "{\"type\":\"submit_job\",\"job\":{\"title\":\"u\",\"kind\":\"program\",\"commands\":[",
    "],\"lift_mm\":5,\"pauses\":[{\"before\":1,\"message\":\"pen\"}]}}\n",
    "],\"lift_mm\":",
    "]}}\n",
    "{\"type\":\"start_job\",\"job\":1}\n",
    "{\"type\":\"pause_job\"}\n",
    "{\"type\":\"set_job_speed\",\"percent\":150}\n",
    "{\"type\":\"set_job_speed\",\"percent\":",
    "{\"type\":\"set_job_height\",\"offset_mm\":-1}\n",
    "{\"type\":\"set_job_height\",\"offset_mm\":",
    "{\"type\":\"cancel_job\",\"job\":1}\n",
    "{\"id\":1,\"request\":",
    "}}\n",
    "}\n",
    "}",
    "{",
    "\"",
    ":",
    ",",
    "]",
    "0",
    "1",
    "220",
    "-50",
    "1e39",
    "-1e-9",
    "null",
    "\n",
    "\\u0000",
];
