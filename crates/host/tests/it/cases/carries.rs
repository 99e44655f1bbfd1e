//! A cube that is carried there and back again and again, while packets are damaged and the station is killed.

use std::time::Duration;

use dobot_api::{ClientId, JobKind, JobPhase, JobProgram, JobRepeat, NewJob, Request};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_host::VirtualStation;
use dobot_safety::Policy;
use dobot_sim::world::{Scene, World};
use dobot_sim::{Fault, SerialLine, VirtualArm};
use dobot_wire::{Command, JointJog, JointJogAxis, MoveTo};

/// A cube before an arm with a suction cup.
const SCENE: &str = r#"
[suction-cup]
down_z_mm = -60
give_mm = 3
diameter_mm = 20
lifts_g = 500

[[box]]
name = "cube"
size_mm = [25, 25, 25]
at_mm = [200, 80]
mass_g = 12
color = "red"
"#;
/// The first position of the cube, and the other one; the cup touches it there.
pub(crate) const HERE: [f32; 3] = [200.0, 80.0, -36.0];
pub(crate) const THERE: [f32; 3] = [240.0, -80.0, -36.0];

fn to([x_mm, y_mm, z_mm]: [f32; 3], suction: bool) -> Command {
    MoveTo {
        suction,
        ..MoveTo::to(x_mm, y_mm, z_mm)
    }
    .into()
}

fn switch(axis: JointJogAxis) -> Command {
    JointJog::new(axis, 100.0).into()
}

/// Takes the cube here and puts it down there.
fn carry(from: [f32; 3], there: [f32; 3]) -> [Command; 4] {
    let (on, off) = (JointJogAxis::SuctionOn, JointJogAxis::SuctionOff);
    [to(from, false), switch(on), to(there, true), switch(off)]
}

/// Moves the cube there and back this many times.
pub(crate) fn shuttle(times: Option<u64>) -> NewJob {
    let above = to([220.0, 0.0, 40.0], false);
    let commands = [&[above][..], &carry(HERE, THERE), &carry(THERE, HERE)].concat();
    NewJob {
        title: "to and fro".into(),
        kind: JobKind::Program,
        lift_mm: 0.0,
        pauses: Vec::new(),
        program: JobProgram {
            steps: vec![0, 1, 3, 5, 7],
            repeat: Some(JobRepeat { from: 1, times }),
            ..JobProgram::default()
        },
        commands,
    }
}

pub(crate) fn station(
    personality: Personality,
    faults: &[&str],
    seed: u64,
) -> (VirtualStation, ClientId) {
    let power_up = PowerUp::new(personality);
    let faults: Vec<Fault> = faults
        .iter()
        .map(|fault| fault.parse().expect("on the twin this works"))
        .collect();
    let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK)
        .with_faults(power_up, &faults, seed)
        .with_world(World::new(
            Scene::parse(SCENE).expect("on the twin this works"),
        ));
    let mut station = VirtualStation::with_arm(arm, power_up, Policy::default());
    station.run_for(Duration::from_secs(1));
    let anna = station.client("Anna");
    station
        .ask(anna, Request::TakeLease)
        .expect("on the twin this works");
    (station, anna)
}

/// Returns whether the cube lies at a position of the cup.
pub(crate) fn cube_is_at(station: &VirtualStation, place: [f32; 3]) -> bool {
    let objects = station
        .arm()
        .world()
        .expect("on the twin this works")
        .state()
        .objects;
    let cube = objects
        .iter()
        .find(|object| object.name == "cube")
        .expect("on the twin this works");
    let [x, y] = [f64::from(place[0]), f64::from(place[1])];
    (cube.at_mm.x - x).hypot(cube.at_mm.y - y) < 0.5
}

/// A person looks at the arm, confirms its pose, and resumes the job.
pub(crate) fn attend(station: &mut VirtualStation, job: u64) {
    let anna = station.client("Anna");
    station
        .ask(anna, Request::TakeLease)
        .expect("on the twin this works");
    // The arm may still be on its way.
    station.run_for(Duration::from_secs(12));
    if station
        .job(job)
        .expect("on the twin this works")
        .state
        .is_over()
    {
        return;
    }
    station
        .ask(anna, Request::ConfirmPose)
        .expect("on the twin this works");
    station.start(anna, job).expect("on the twin this works");
}

/// The outcome for the cube.
#[derive(Debug)]
pub(crate) struct Carries {
    pub(crate) cycles: u64,
    pub(crate) kills: u64,
    /// How often a command was lost and sent again.
    pub(crate) again: usize,
    /// Whether the cube is in the right place and was never left on its way.
    pub(crate) is_right: bool,
    /// On the arm's clock.
    pub(crate) took: Duration,
    /// The final state of the job.
    pub(crate) state: String,
}

/// Runs this many cycles, with one damaged packet in a thousand in each direction and a kill every fifty cycles.
pub(crate) fn run(cycles: u64) -> Carries {
    let (mut station, anna) = station(Personality::Specification, &[ONE_PACKET_OF_A_THOUSAND], 11);
    let job = station
        .submit(&shuttle(Some(cycles)))
        .expect("on the twin this works");
    station.start(anna, job).expect("on the twin this works");
    let (mut kills, mut again) = (0, 0);
    while !station
        .job(job)
        .expect("on the twin this works")
        .state
        .is_over()
        && kills * KILLED_EVERY < 2 * cycles
    {
        let until = (kills + 1) * KILLED_EVERY * 8 + kills % 8;
        let latest = station.now() + Duration::from_secs(10 * 3600);
        station.run_until(latest, |station| {
            let progress = station.supervisor().job_progress();
            progress.is_none_or(|progress| progress.0 as u64 > until)
        });
        if station.supervisor().job_progress().is_none() {
            station.run_for(Duration::from_secs(1));
            break;
        }
        station.run_for(Duration::from_millis(137 * (kills % 17)));
        station
            .crash(Duration::from_millis(100 * (kills % 40)))
            .expect("on the twin this works");
        kills += 1;
        attend(&mut station, job);
    }
    again += station
        .notices()
        .iter()
        .filter(|notice| notice.text.contains("sent again"))
        .count();
    Carries {
        cycles,
        kills,
        again,
        is_right: cube_is_at(&station, HERE),
        took: station.now(),
        state: station
            .job(job)
            .expect("on the twin this works")
            .state
            .to_string(),
    }
}

/// By bytes.
const ONE_PACKET_OF_A_THOUSAND: &str = "flip=0.0024%";
const KILLED_EVERY: u64 = 50;

/// Neither the supervisor nor the journal has it at work: the arm rests.
fn rests(station: &VirtualStation, job: u64) -> bool {
    let works = |phase| matches!(phase, JobPhase::Queued | JobPhase::Running);
    let current = station.supervisor().job().filter(|view| view.job == job);
    let stored = station.job(job).expect("on the twin this works");
    !works(stored.state.phase()) && !current.is_some_and(|current| works(current.phase))
}

/// Runs until the job rests, for ten hours at most.
#[track_caller]
pub(crate) fn run_until_rest(station: &mut VirtualStation, job: u64) {
    let latest = station.now() + Duration::from_secs(36_000);
    let rested = station.run_until(latest, |station| rests(station, job));
    assert!(rested, "{:?}", station.supervisor().job());
}
