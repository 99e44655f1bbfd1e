//! The station's arm as a ROS 2 node.

use std::sync::Arc;
use std::time::Duration;

use dobot_host::StationClient;
use dobot_model::Model;
use futures_util::StreamExt;
use ros2_client::{Message, Server, Subscription};
use tokio::sync::{mpsc, oneshot, watch};
use tokio::time::timeout;

use crate::actions::{GRIPPER_DEG, ended, go, gripper, suction};
use crate::buttons::{Buttons, JogMessage};
use crate::follow_action::FollowAction;
use crate::frames::Frames;
use crate::goals::{self, Action, Goals};
use crate::gripper_action::GripperAction;
use crate::jog;
use crate::joints::Velocities;
use crate::log::Log;
use crate::messages::{
    Answer, JointJog, PoseStamped, SetBoolRequest, TriggerRequest, TwistStamped,
};
use crate::node::{Listeners, Names, NodeError, ParameterServers, Publishers, Servers, node};
use crate::parameters::Parameters;
use crate::settings::Settings;
use crate::station::Station;
use crate::target::target;
use crate::watch::{WantedStop, Watch};

/// Runs the node until `ending` becomes true; actions in progress then end first, with the arm at
/// rest.
///
/// # Errors
///
/// [`NodeError`] if DDS cannot be started.
///
/// # Panics
///
/// Outside of a tokio runtime.
pub async fn run(settings: Settings, mut ending: watch::Receiver<bool>) -> Result<(), NodeError> {
    let mut node = node(&settings)?;
    let names = Names {
        namespace: &settings.namespace,
    };
    let publishers = Publishers::new(&mut node, names)?;
    let listeners = Listeners::new(&mut node, names)?;
    let servers = Servers::new(&mut node, names, settings.middleware.mapping())?;
    // Without the spinner of `ros2-client`: it serves simulated time, of a wrong type, and
    // parameters, in one format only.
    let log = Arc::new(Log::new(node.logging_handle()));

    let model = Model::new(settings.tool);
    serve_parameters(
        servers.parameters,
        &Arc::new(Parameters::new(&settings, &model)),
        &log,
    );
    let station = Station::new(settings.station);
    let frames = Frames::new(&settings.namespace);
    let (stop, stops) = mpsc::channel(STOPS);
    let watch = Watch {
        station: station.clone(),
        publishers,
        frames: frames.clone(),
        model,
        log: log.clone(),
        stops,
        policy: None,
        diagnosed_s: None,
        velocities: Velocities::default(),
    };
    tokio::spawn(watch.run());
    tokio::spawn(serve_stop(servers.stop, stop, log.clone()));

    // Each action in progress holds a clone.
    let (busy, mut over) = mpsc::channel::<()>(1);
    let shared = Shared {
        station,
        log,
        frames,
        ending: ending.clone(),
        busy,
    };
    shared.serve(servers.suction, Switch::Suction);
    shared.serve(servers.gripper, Switch::Gripper);
    shared.take_targets(listeners.target);
    shared.take_jogs(listeners.twist, listeners.joints);
    let follow = FollowAction {
        station: shared.station.clone(),
        log: shared.log.clone(),
        deviation_deg: settings.deviation_deg,
    };
    let gripper = GripperAction {
        station: shared.station.clone(),
        ending: ending.clone(),
    };
    shared.accept_goals(follow, servers.follow);
    shared.accept_goals(gripper, servers.gripper_command);
    shared.log.info("the node is running");

    ended(&mut ending).await;
    drop(shared);
    let _ = timeout(PATIENCE, over.recv()).await;
    Ok(())
}

/// State shared by everything that moves the arm.
#[derive(Clone)]
struct Shared {
    station: Station,
    log: Arc<Log>,
    frames: Frames,
    ending: watch::Receiver<bool>,
    busy: mpsc::Sender<()>,
}

impl Shared {
    /// Accepts the goals of an action.
    fn accept_goals<A: Action>(&self, action: A, server: goals::Server<A>) {
        let goals = Goals::new(action, server, self.log.clone());
        tokio::spawn(goals.run(self.ending.clone(), self.busy.clone()));
    }

    /// Serves a switch.
    fn serve(&self, server: Server<SetBoolRequest, Answer>, switch: Switch) {
        let name = switch.name();
        let mut shared = self.clone();
        tokio::spawn(async move {
            let requests = server.receive_request_stream();
            tokio::pin!(requests);
            while let Some(request) = shared.next(&mut requests).await {
                let (id, SetBoolRequest { data }) = match request {
                    Ok(request) => request,
                    Err(error) => {
                        shared.unreadable(name, &error);
                        continue;
                    }
                };
                let done = shared.switch(switch, data).await;
                shared.log.outcome(name, &done);
                let answered = server.async_send_response(id, Answer::of(done));
                if let Err(error) = answered.await {
                    shared
                        .log
                        .warn(&format!("cannot send the response of {name}: {error:?}"));
                }
            }
        });
    }

    async fn switch(&mut self, switch: Switch, on: bool) -> Result<String, String> {
        let mut station = self.station.connect(switch.name()).await?;
        match switch {
            Switch::Suction => suction(&mut station, on).await,
            Switch::Gripper => {
                let angle_deg = if on { -GRIPPER_DEG } else { GRIPPER_DEG };
                gripper(&mut station, angle_deg, &mut self.ending).await
            }
        }
    }

    /// Moves to targets, one after the other; of the targets that arrive during a move only the
    /// last is used.
    fn take_targets(&self, listener: Subscription<PoseStamped>) {
        let (wanted, mut targets) = watch::channel(None);
        tokio::spawn(pass_on(listener, wanted, Some, self.log.clone()));
        let mut shared = self.clone();
        tokio::spawn(async move {
            while shared.changed(&mut targets).await {
                let wanted: Option<PoseStamped> = targets.borrow_and_update().clone();
                if let Some(wanted) = wanted {
                    let done = shared.go(&wanted).await;
                    shared.log.outcome("target", &done);
                }
            }
        });
    }

    async fn go(&mut self, wanted: &PoseStamped) -> Result<String, String> {
        let target = target(wanted, &self.frames)?;
        let mut station: StationClient = self.station.connect("target").await?;
        go(&mut station, &target, &mut self.ending).await
    }

    fn take_jogs(&self, twist: Subscription<TwistStamped>, joints: Subscription<JointJog>) {
        let (press, messages) = watch::channel::<JogMessage>(None);
        let frames = self.frames.clone();
        let of_twist = move |twist| Some(jog::of_twist(&twist, &frames));
        tokio::spawn(pass_on(twist, press.clone(), of_twist, self.log.clone()));
        let of_joints = |joints| Some(jog::of_joints(&joints));
        tokio::spawn(pass_on(joints, press, of_joints, self.log.clone()));
        let buttons = Buttons {
            station: self.station.clone(),
            log: self.log.clone(),
            messages,
            ending: self.ending.clone(),
        };
        let busy = self.busy.clone();
        let mut ending = self.ending.clone();
        tokio::spawn(async move {
            tokio::select! {
                () = buttons.run() => {}
                () = ended(&mut ending) => {}
            }
            drop(busy);
        });
    }

    /// Returns the next message of a stream, until the shutdown.
    async fn next<S: futures_util::Stream + Unpin>(&mut self, stream: &mut S) -> Option<S::Item> {
        tokio::select! {
            next = stream.next() => next,
            () = ended(&mut self.ending) => None,
        }
    }

    /// Waits for a new value, until the shutdown.
    async fn changed<T>(&mut self, value: &mut watch::Receiver<T>) -> bool {
        tokio::select! {
            changed = value.changed() => changed.is_ok(),
            () = ended(&mut self.ending) => false,
        }
    }

    fn unreadable(&self, name: &str, error: &dyn std::fmt::Debug) {
        self.log
            .warn(&format!("cannot read a message for {name}: {error:?}"));
    }
}

/// The tools that are switched by services.
#[derive(Clone, Copy)]
enum Switch {
    Suction,
    Gripper,
}

impl Switch {
    const fn name(self) -> &'static str {
        match self {
            Self::Suction => "suction",
            Self::Gripper => "gripper",
        }
    }
}

/// Forwards messages; of messages that arrive between reads only the last.
async fn pass_on<M: Message + 'static, T>(
    listener: Subscription<M>,
    to: watch::Sender<T>,
    read: impl Fn(M) -> T,
    log: Arc<Log>,
) {
    let messages = listener.async_stream();
    tokio::pin!(messages);
    while let Some(message) = messages.next().await {
        match message {
            Ok((message, _)) => {
                to.send_replace(read(message));
            }
            Err(error) => log.warn(&format!("cannot read a message: {error:?}")),
        }
    }
}

/// Serves the parameters.
fn serve_parameters(servers: ParameterServers, parameters: &Arc<Parameters>, log: &Arc<Log>) {
    /// Answers requests for as long as the node runs.
    fn serve<
        Q: Message + Clone + Send + Sync + 'static,
        A: Message + Clone + Send + Sync + 'static,
    >(
        server: Server<Q, A>,
        parameters: &Arc<Parameters>,
        answer: fn(&Parameters, &Q) -> A,
        log: &Arc<Log>,
    ) {
        let (parameters, log) = (parameters.clone(), log.clone());
        tokio::spawn(async move {
            let requests = server.receive_request_stream();
            tokio::pin!(requests);
            while let Some(request) = requests.next().await {
                let answered = match request {
                    Ok((id, request)) => {
                        let answer = answer(&parameters, &request);
                        server
                            .async_send_response(id, answer)
                            .await
                            .map_err(|error| format!("{error:?}"))
                    }
                    Err(error) => Err(format!("{error:?}")),
                };
                if let Err(error) = answered {
                    log.warn(&format!("cannot answer a request for parameters: {error}"));
                }
            }
        });
    }
    serve(servers.list, parameters, Parameters::list, log);
    serve(servers.get, parameters, Parameters::get, log);
    serve(servers.types, parameters, Parameters::types, log);
    serve(servers.describe, parameters, Parameters::describe, log);
    serve(servers.set, parameters, Parameters::set, log);
    serve(
        servers.set_atomically,
        parameters,
        Parameters::set_atomically,
        log,
    );
}

/// Serves the stop, over the observer's connection.
async fn serve_stop(
    server: Server<TriggerRequest, Answer>,
    stop: mpsc::Sender<WantedStop>,
    log: Arc<Log>,
) {
    let requests = server.receive_request_stream();
    tokio::pin!(requests);
    while let Some(request) = requests.next().await {
        // An unreadable stop is a stop too, but cannot be answered.
        let (answer, answered) = oneshot::channel();
        let passed = stop.send(answer).await.is_ok();
        let done = match answered.await {
            Ok(done) if passed => done,
            _ => Err("cannot forward the stop: the node is shutting down".to_owned()),
        };
        log.outcome("stop", &done);
        if let Ok((id, _)) = request
            && let Err(error) = server.async_send_response(id, Answer::of(done)).await
        {
            log.warn(&format!("cannot send the response of the stop: {error:?}"));
        }
    }
}

/// The maximum number of queued stops.
const STOPS: usize = 16;
/// The timeout of actions in progress at the shutdown.
const PATIENCE: Duration = Duration::from_secs(12);
