//! The node: its topics, services and action, with their ROS 2 names and types.

use std::net::IpAddr;

use ros2_client::action::{ActionServerQosPolicies, AsyncActionServer};
use ros2_client::dds::rustdds::DomainParticipantBuilder;
use ros2_client::qos::{Durability, History, WhenFull};
use ros2_client::{
    ActionTypeName, Context, CreateError, Message, MessageTypeName, Name, Node, NodeName,
    NodeOptions, Publisher, QosProfile, Server, ServiceMapping, ServiceTypeName, Subscription,
};

use crate::messages::{
    Answer, DiagnosticArray, FollowFeedback, FollowGoal, FollowResult, JointJog, JointState,
    PoseStamped, SetBoolRequest, TfMessage, TriggerRequest, TwistStamped,
};
use crate::settings::{NODE, Settings};

/// The publishers.
pub(crate) struct Publishers {
    pub(crate) joint_states: Publisher<JointState>,
    pub(crate) tf: Publisher<TfMessage>,
    pub(crate) tf_static: Publisher<TfMessage>,
    pub(crate) diagnostics: Publisher<DiagnosticArray>,
    pub(crate) description: Publisher<String>,
}

/// The subscriptions.
pub(crate) struct Listeners {
    pub(crate) target: Subscription<PoseStamped>,
    pub(crate) twist: Subscription<TwistStamped>,
    pub(crate) joints: Subscription<JointJog>,
}

/// The servers.
pub(crate) struct Servers {
    pub(crate) stop: Server<TriggerRequest, Answer>,
    pub(crate) suction: Server<SetBoolRequest, Answer>,
    pub(crate) gripper: Server<SetBoolRequest, Answer>,
    pub(crate) follow: AsyncActionServer<FollowGoal, FollowResult, FollowFeedback>,
}

/// The error returned when the node cannot be created.
#[derive(Debug, thiserror::Error)]
#[error("cannot start DDS: {0}")]
pub struct NodeError(String);

impl From<CreateError> for NodeError {
    fn from(error: CreateError) -> Self {
        Self(error.to_string())
    }
}

/// Creates the node on the addresses of the settings.
pub(crate) fn node(settings: &Settings) -> Result<Node, NodeError> {
    let refused = |error: &dyn std::fmt::Display| NodeError(error.to_string());
    let interfaces = settings.interfaces.iter().copied().map(IpAddr::V4);
    let participant = DomainParticipantBuilder::new(settings.domain)
        .with_only_networks(interfaces)
        .build()
        .map_err(|error| refused(&error))?;
    let context = Context::from_domain_participant(participant)?;
    let name = NodeName::new(&settings.namespace, NODE).map_err(|error| refused(&error))?;
    let options = NodeOptions::new()
        .enable_rosout(true)
        .start_parameter_services(false);
    let node = context.new_node(name, options);
    node.map_err(|error| NodeError(format!("{error:?}")))
}

impl Publishers {
    pub(crate) fn new(node: &mut Node, names: Names<'_>) -> Result<Self, NodeError> {
        let (latest, kept) = (
            reliable(10),
            reliable(1).durability(Durability::TransientLocal),
        );
        Ok(Self {
            joint_states: publisher(
                node,
                &names.own("joint_states"),
                ("sensor_msgs", "JointState"),
                &latest,
            )?,
            tf: publisher(
                node,
                &of_all("tf"),
                ("tf2_msgs", "TFMessage"),
                &reliable(100),
            )?,
            tf_static: publisher(node, &of_all("tf_static"), ("tf2_msgs", "TFMessage"), &kept)?,
            diagnostics: publisher(
                node,
                &of_all("diagnostics"),
                ("diagnostic_msgs", "DiagnosticArray"),
                &latest,
            )?,
            description: publisher(
                node,
                &names.own("robot_description"),
                ("std_msgs", "String"),
                &kept,
            )?,
        })
    }
}

impl Listeners {
    pub(crate) fn new(node: &mut Node, names: Names<'_>) -> Result<Self, NodeError> {
        // A lost jog is repeated soon, and a late one is worse than none.
        let newest = QosProfile::subscription_default();
        let (target, twist, joints) = (
            names.private("target"),
            names.private("delta_twist_cmds"),
            names.private("delta_joint_cmds"),
        );
        Ok(Self {
            target: listener(
                node,
                &target,
                ("geometry_msgs", "PoseStamped"),
                &reliable(1),
            )?,
            twist: listener(node, &twist, ("geometry_msgs", "TwistStamped"), &newest)?,
            joints: listener(node, &joints, ("control_msgs", "JointJog"), &newest)?,
        })
    }
}

impl Servers {
    pub(crate) fn new(
        node: &mut Node,
        names: Names<'_>,
        mapping: ServiceMapping,
    ) -> Result<Self, NodeError> {
        let qos = reliable(10);
        let follow = node.create_action_server(
            mapping,
            &names.private("follow_joint_trajectory"),
            &ActionTypeName::new("control_msgs", "FollowJointTrajectory"),
            ActionServerQosPolicies {
                goal_service: qos.clone(),
                result_service: qos.clone(),
                cancel_service: qos.clone(),
                feedback_publisher: qos,
                status_publisher: reliable(1).durability(Durability::TransientLocal),
            },
        )?;
        let (stop, suction, gripper) = (
            names.private("stop"),
            names.private("suction"),
            names.private("gripper"),
        );
        Ok(Self {
            stop: server(node, mapping, &stop, "Trigger")?,
            suction: server(node, mapping, &suction, "SetBool")?,
            gripper: server(node, mapping, &gripper, "SetBool")?,
            follow: AsyncActionServer::new(follow),
        })
    }
}

fn publisher<M: Message>(
    node: &mut Node,
    name: &Name,
    (package, kind): (&str, &str),
    qos: &QosProfile,
) -> Result<Publisher<M>, NodeError> {
    let topic = node.create_topic(name, MessageTypeName::new(package, kind), qos)?;
    Ok(node.create_publisher(&topic, None)?)
}

fn listener<M: Message + 'static>(
    node: &mut Node,
    name: &Name,
    (package, kind): (&str, &str),
    qos: &QosProfile,
) -> Result<Subscription<M>, NodeError> {
    let topic = node.create_topic(name, MessageTypeName::new(package, kind), qos)?;
    Ok(node.create_subscription(&topic, None)?)
}

fn server<Q: Message + Clone + 'static>(
    node: &mut Node,
    mapping: ServiceMapping,
    name: &Name,
    kind: &str,
) -> Result<Server<Q, Answer>, NodeError> {
    let kind = ServiceTypeName::new("std_srvs", kind);
    let qos = reliable(10);
    Ok(node.create_server(mapping, name, &kind, qos.clone(), qos)?)
}

/// Repeated messages must not wait for slow readers.
fn reliable(depth: usize) -> QosProfile {
    QosProfile::publisher_default()
        .reliability_reliable(WhenFull::Fail)
        .history(History::KeepLast { depth })
}

/// The names of an arm, written with their namespace, since a relative name in the namespace `/`
/// gets two slashes.
#[derive(Clone, Copy)]
pub(crate) struct Names<'a> {
    pub(crate) namespace: &'a str,
}

impl Names<'_> {
    /// Returns a name in the namespace, as `joint_states`.
    fn own(self, name: &str) -> Name {
        Name::new(self.namespace, name).expect("it is a name")
    }

    /// Returns a private name of the node, as `~/target`.
    fn private(self, name: &str) -> Name {
        let namespace = self.namespace.trim_end_matches('/');
        Name::new(&format!("{namespace}/{NODE}"), name).expect("both are names")
    }
}

/// Returns a global name, as `/tf`.
fn of_all(name: &str) -> Name {
    Name::new("/", name).expect("it is a name")
}
