//! The ROS 2 messages, field by field as in their `.msg` files.
//!
//! Lengths are metres, angles radians, times seconds (REP 103). `ros2-client` serialises them as
//! CDR.

use ros2_client::Message;
use ros2_client::builtin_interfaces::{Duration, Time};
use serde::{Deserialize, Serialize};

/// Declares messages, each documented with its name in ROS 2.
macro_rules! messages {
    ($($(#[$doc:meta])* $name:ident { $($field:ident: $type:ty,)* })*) => {
        $(
            $(#[$doc])*
            #[derive(Clone, Debug, Serialize, Deserialize)]
            pub(crate) struct $name {
                $(pub(crate) $field: $type,)*
            }

            impl Message for $name {}
        )*
    };
}

messages! {
    /// `std_msgs/Header`
    Header {
        stamp: Time,
        frame_id: String,
    }

    /// `geometry_msgs/Vector3`, and `geometry_msgs/Point`, which has the same format
    Vector3 {
        x: f64,
        y: f64,
        z: f64,
    }

    /// `geometry_msgs/Quaternion`
    Quaternion {
        x: f64,
        y: f64,
        z: f64,
        w: f64,
    }

    /// `geometry_msgs/Pose`, and `geometry_msgs/Transform`, which has the same format
    Pose {
        position: Vector3,
        orientation: Quaternion,
    }

    /// `geometry_msgs/PoseStamped`
    PoseStamped {
        header: Header,
        pose: Pose,
    }

    /// `geometry_msgs/Twist`
    Twist {
        linear: Vector3,
        angular: Vector3,
    }

    /// `geometry_msgs/TwistStamped`
    TwistStamped {
        header: Header,
        twist: Twist,
    }

    /// `geometry_msgs/TransformStamped`
    TransformStamped {
        header: Header,
        child_frame_id: String,
        transform: Pose,
    }

    /// `tf2_msgs/TFMessage`
    TfMessage {
        transforms: Vec<TransformStamped>,
    }

    /// `sensor_msgs/JointState`
    JointState {
        header: Header,
        name: Vec<String>,
        position: Vec<f64>,
        velocity: Vec<f64>,
        effort: Vec<f64>,
    }

    /// `diagnostic_msgs/KeyValue`
    KeyValue {
        key: String,
        value: String,
    }

    /// `diagnostic_msgs/DiagnosticStatus`
    DiagnosticStatus {
        level: u8,
        name: String,
        message: String,
        hardware_id: String,
        values: Vec<KeyValue>,
    }

    /// `diagnostic_msgs/DiagnosticArray`
    DiagnosticArray {
        header: Header,
        status: Vec<DiagnosticStatus>,
    }

    /// `control_msgs/JointJog`
    JointJog {
        header: Header,
        joint_names: Vec<String>,
        displacements: Vec<f64>,
        velocities: Vec<f64>,
        duration: f64,
    }

    /// `trajectory_msgs/JointTrajectoryPoint`
    JointTrajectoryPoint {
        positions: Vec<f64>,
        velocities: Vec<f64>,
        accelerations: Vec<f64>,
        effort: Vec<f64>,
        time_from_start: Duration,
    }

    /// `trajectory_msgs/JointTrajectory`
    JointTrajectory {
        header: Header,
        joint_names: Vec<String>,
        points: Vec<JointTrajectoryPoint>,
    }

    /// `trajectory_msgs/MultiDOFJointTrajectoryPoint`
    MultiDofPoint {
        transforms: Vec<Pose>,
        velocities: Vec<Twist>,
        accelerations: Vec<Twist>,
        time_from_start: Duration,
    }

    /// `trajectory_msgs/MultiDOFJointTrajectory`
    MultiDofTrajectory {
        header: Header,
        joint_names: Vec<String>,
        points: Vec<MultiDofPoint>,
    }

    /// `control_msgs/JointTolerance`
    JointTolerance {
        name: String,
        position: f64,
        velocity: f64,
        acceleration: f64,
    }

    /// `control_msgs/JointComponentTolerance`
    JointComponentTolerance {
        joint_name: String,
        component: u16,
        position: f64,
        velocity: f64,
        acceleration: f64,
    }

    /// The goal of `control_msgs/FollowJointTrajectory`
    FollowGoal {
        trajectory: JointTrajectory,
        multi_dof_trajectory: MultiDofTrajectory,
        path_tolerance: Vec<JointTolerance>,
        component_path_tolerance: Vec<JointComponentTolerance>,
        goal_tolerance: Vec<JointTolerance>,
        component_goal_tolerance: Vec<JointComponentTolerance>,
        goal_time_tolerance: Duration,
    }

    /// The result of `control_msgs/FollowJointTrajectory`
    FollowResult {
        error_code: i32,
        error_string: String,
    }

    /// The feedback of `control_msgs/FollowJointTrajectory`
    FollowFeedback {
        header: Header,
        joint_names: Vec<String>,
        desired: JointTrajectoryPoint,
        actual: JointTrajectoryPoint,
        error: JointTrajectoryPoint,
        multi_dof_joint_names: Vec<String>,
        multi_dof_desired: MultiDofPoint,
        multi_dof_actual: MultiDofPoint,
        multi_dof_error: MultiDofPoint,
    }

    /// The goal of `control_msgs/ParallelGripperCommand`
    GripperGoal {
        command: JointState,
    }

    /// The result of `control_msgs/ParallelGripperCommand`
    GripperResult {
        state: JointState,
        stalled: bool,
        reached_goal: bool,
    }

    /// The feedback of `control_msgs/ParallelGripperCommand`
    GripperFeedback {
        state: JointState,
    }

    /// The request of `std_srvs/Trigger`; an empty message is serialised as one byte
    TriggerRequest {
        structure_needs_at_least_one_member: u8,
    }

    /// The request of `std_srvs/SetBool`
    SetBoolRequest {
        data: bool,
    }

    /// The response of `std_srvs/Trigger` and of `std_srvs/SetBool`
    Answer {
        success: bool,
        message: String,
    }
}

impl Header {
    /// Returns a header with the current time.
    pub(crate) fn now(frame_id: impl Into<String>) -> Self {
        Self {
            stamp: Time::now(),
            frame_id: frame_id.into(),
        }
    }
}

impl JointTrajectoryPoint {
    /// Returns a point with only these positions and this time.
    pub(crate) fn at(positions: [f64; 4], time_from_start_s: f64) -> Self {
        Self {
            positions: positions.to_vec(),
            velocities: Vec::new(),
            accelerations: Vec::new(),
            effort: Vec::new(),
            time_from_start: duration(time_from_start_s),
        }
    }
}

impl MultiDofPoint {
    /// Returns an empty message.
    pub(crate) const fn empty() -> Self {
        Self {
            transforms: Vec::new(),
            velocities: Vec::new(),
            accelerations: Vec::new(),
            time_from_start: Duration::zero(),
        }
    }
}

impl Answer {
    pub(crate) fn of(done: Result<String, String>) -> Self {
        let (success, message) = match done {
            Ok(message) => (true, message),
            Err(message) => (false, message),
        };
        Self { success, message }
    }
}

/// Converts seconds to a duration, saturating.
pub(crate) fn duration(seconds: f64) -> Duration {
    let time = std::time::Duration::try_from_secs_f64(seconds.max(0.0));
    time.unwrap_or(std::time::Duration::MAX).into()
}

/// Converts a time to seconds.
#[expect(
    clippy::cast_precision_loss,
    reason = "microseconds over years do not matter"
)]
pub(crate) fn seconds(duration: &Duration) -> f64 {
    duration.to_nanos() as f64 / 1e9
}
