//! An arm, its station and a person.

use std::fmt;
use std::time::Duration;

use dobot_api::JobState;
use dobot_api::{ClientId, JobPhase, NewJob, Request};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_host::VirtualStation;
use dobot_journal::{Journal, JournalError};
use dobot_safety::Policy;
use dobot_sim::{Fault, RECORDING_PERIOD, SerialLine, VirtualArm};
use dobot_supervisor::Refusal;
use dobot_wire::{Command, Dialect, JointJog, JointJogAxis, LINE_TIME, Packet};

use super::jobs::{Sort, counts};
use super::paper::Paper;

/// An arm, its station and a person who has control.
#[derive(Debug)]
pub(crate) struct Scene {
    /// What happens.
    pub station: VirtualStation,
    /// The person.
    pub anna: ClientId,
    personality: Personality,
    /// Packets that were on the wire before the examined part.
    since: usize,
}

/// A violation, in one line.
#[derive(Debug)]
pub(crate) struct Wrong(pub String);

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl From<Refusal> for Wrong {
    fn from(refusal: Refusal) -> Self {
        Self(format!("refused: {refusal}"))
    }
}

impl From<JournalError> for Wrong {
    fn from(error: JournalError) -> Self {
        Self(error.to_string())
    }
}

/// How often the commands of a job were sent to the arm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct GivenCounts {
    /// Never.
    pub lost: usize,
    /// More often than once.
    pub repeated: usize,
}

impl Scene {
    /// An arm that was just switched on.
    pub(crate) fn new(personality: Personality) -> Result<Self, Wrong> {
        Self::faulty(personality, &[], 0)
    }

    /// A scene with faults.
    pub(crate) fn faulty(
        personality: Personality,
        faults: &[&str],
        seed: u64,
    ) -> Result<Self, Wrong> {
        let journal = Journal::in_memory()?;
        Self::with_journal(personality, faults, seed, journal)
    }

    /// A scene with the given journal.
    pub(crate) fn with_journal(
        personality: Personality,
        faults: &[&str],
        seed: u64,
        journal: Journal,
    ) -> Result<Self, Wrong> {
        let power_up = PowerUp::new(personality);
        let mut arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
        if !faults.is_empty() {
            let parsed: Result<Vec<Fault>, _> = faults.iter().map(|fault| fault.parse()).collect();
            let parsed = parsed.map_err(|error| Wrong(error.to_string()))?;
            arm = arm.with_faults(power_up, &parsed, seed);
        }
        arm.record(RECORDING_PERIOD);
        let mut station = VirtualStation::with_journal(arm, power_up, Policy::default(), journal);
        station.run_for(Duration::from_secs(1));
        let anna = station.client("Anna");
        station.ask(anna, Request::TakeLease)?;
        Ok(Self {
            station,
            anna,
            personality,
            since: 0,
        })
    }

    /// Keeps a job and starts it.
    pub(crate) fn begin(&mut self, job: &NewJob) -> Result<u64, Wrong> {
        self.since = self.station.packets().len();
        let number = self.station.submit(job)?;
        self.start(number)?;
        Ok(number)
    }

    /// Starts or resumes a job as a person does after looking: the laser is armed.
    pub(crate) fn start(&mut self, job: u64) -> Result<(), Wrong> {
        self.station.ask(self.anna, Request::ConfirmPose)?;
        self.station
            .ask(self.anna, Request::ArmLaser { for_s: 600.0 })?;
        self.station.start(self.anna, job)?;
        Ok(())
    }

    /// A person comes to a station that was started again.
    pub(crate) fn come_back(&mut self) -> Result<(), Wrong> {
        self.anna = self.station.client("Anna");
        self.station.ask(self.anna, Request::TakeLease)?;
        Ok(())
    }

    /// Returns the planned duration of a job.
    pub(crate) fn planned(&self) -> Duration {
        let planned_s = self
            .station
            .supervisor()
            .job()
            .and_then(|job| job.planned_s);
        Duration::try_from_secs_f64(planned_s.unwrap_or(0.0)).unwrap_or_default()
    }

    /// Waits until a job can be started or is over, and the arm rests.
    pub(crate) fn settle(&mut self, job: u64) -> Result<JobState, Wrong> {
        let latest = self.station.now() + PATIENCE;
        let works = |station: &VirtualStation| {
            station
                .supervisor()
                .job()
                .is_some_and(|job| job.phase == JobPhase::Running)
        };
        let settled = |station: &VirtualStation| {
            let kept = match state(station, job) {
                None | Some(JobState::Running) => false,
                Some(JobState::Queued) => station.supervisor().job().is_none(),
                Some(_) => true,
            };
            station.supervisor().is_at_rest() && kept && !works(station)
        };
        if self.station.run_until(latest, settled) {
            return state(&self.station, job).ok_or_else(|| Wrong("the job is gone".into()));
        }
        Err(Wrong(format!(
            "job and arm did not come to rest within {} s: {:?}",
            PATIENCE.as_secs(),
            self.station.supervisor().job()
        )))
    }

    /// Resumes a job until it is over, as often as necessary.
    pub(crate) fn finish(&mut self, job: u64) -> Result<(), Wrong> {
        for _ in 0..8 {
            match self.settle(job)? {
                JobState::Done => return Ok(()),
                JobState::Queued | JobState::Paused { .. } => self.start(job)?,
                other => return Err(Wrong(format!("the job is {other}"))),
            }
        }
        Err(Wrong("the job is paused again and again".into()))
    }

    /// Returns how often the commands of a job were sent.
    pub(crate) fn given(&self, job: &NewJob) -> GivenCounts {
        let wanted: Vec<Command> = job.commands.iter().copied().filter(counts).collect();
        let mut given: Vec<_> = self.sent(self.since).into_iter().filter(counts).collect();
        if given.len() > wanted.len() {
            given = self.given_once();
        }
        let same = wanted
            .iter()
            .zip(&given)
            .take_while(|(a, b)| a == b)
            .count();
        if same == wanted.len() && same == given.len() {
            return GivenCounts::default();
        }
        // After the first difference the others do not matter.
        GivenCounts {
            lost: wanted
                .len()
                .saturating_sub(given.len())
                .max(usize::from(given.len() == wanted.len())),
            repeated: given.len().saturating_sub(wanted.len()),
        }
    }

    /// The commands that count, in the order in which they were sent. One that a stop cut short on the line never reached
    /// the arm: the stop does not wait for the line. Where it was sent again it counts once.
    fn given_once(&self) -> Vec<Command> {
        let times = self.station.packets()[self.since..]
            .iter()
            .map(|(at, _)| *at);
        let sent: Vec<_> = times.zip(self.sent(self.since)).collect();
        let cut_short = sent
            .windows(2)
            .map(|pair| pair[1].0 < pair[0].0 + LINE_TIME);
        let cut_short = cut_short.chain([false]);
        let counted = sent
            .iter()
            .zip(cut_short)
            .filter(|((_, command), _)| counts(command));
        let counted: Vec<_> = counted.collect();
        let resent = |at: usize| {
            counted
                .get(at + 1)
                .is_some_and(|next| next.0.1 == counted[at].0.1)
        };
        let kept = counted.iter().enumerate();
        kept.filter(|(at, (_, cut_short))| !(*cut_short && resent(*at)))
            .map(|(_, ((_, command), _))| *command)
            .collect()
    }

    /// Checks that all of a job was sent once and is on the paper.
    pub(crate) fn check(&self, job: &NewJob) -> Result<(), Wrong> {
        let (given, paper) = (
            self.given(job),
            Paper::of(self.station.arm().samples(), job),
        );
        if given == GivenCounts::default() && paper.is_right() {
            return Ok(());
        }
        Err(Wrong(format!("{given:?}, {paper:?}")))
    }

    /// The commands that were put on the wire since then.
    pub(crate) fn sent(&self, since: usize) -> Vec<Command> {
        let packets = self.station.packets()[since..].iter();
        let dialect: Dialect = self.personality.dialect();
        packets
            .filter_map(|(_, bytes)| Packet::from_bytes(bytes))
            .filter_map(|packet| Command::parse(&packet, &dialect).ok())
            .collect()
    }

    /// Returns whether the laser burns.
    pub(crate) fn burns(&self) -> bool {
        burns(&self.station)
    }

    /// Returns when the arm last came to rest, according to the machine, in seconds.
    pub(crate) fn rested_s(&self) -> f64 {
        let samples = self.station.arm().samples();
        let Some(last) = samples.last() else {
            return 0.0;
        };
        let moving = samples
            .iter()
            .rev()
            .position(|sample| sample.position != last.position);
        let first_at_rest = samples.len() - moving.unwrap_or(samples.len());
        samples
            .get(first_at_rest)
            .map_or(0.0, |sample| sample.at.as_secs_f64())
    }

    /// The personality of the arm.
    pub(crate) const fn personality(&self) -> Personality {
        self.personality
    }
}

/// Returns whether the laser burns.
pub(crate) fn burns(station: &VirtualStation) -> bool {
    station.arm().controller().outputs().laser
}

fn state(station: &VirtualStation, job: u64) -> Option<JobState> {
    station.job(job).ok().map(|job| job.state)
}

/// A figure for both personalities and all sorts of jobs.
pub(crate) fn cases(count: u64) -> impl Iterator<Item = (Personality, Sort, u64)> {
    (0..count).map(|seed| {
        let at = usize::try_from(seed).unwrap_or_default();
        let personality = Personality::ALL[at % 2];
        (personality, Sort::ALL[at / 2 % 3], seed)
    })
}

/// Tries a case with each seed, on both personalities in turn; gives back what should not be, in words.
pub(crate) fn each_seed(
    count: u64,
    case: impl fmt::Display,
    mut run: impl FnMut(Personality, u64) -> Result<(), Wrong>,
) -> Vec<String> {
    let wrong = (0..count).filter_map(|seed| {
        let personality = Personality::ALL[usize::from(seed % 2 == 1)];
        let Wrong(wrong) = run(personality, seed).err()?;
        Some(format!("{personality}, {case}, seed {seed}: {wrong}"))
    });
    wrong.collect()
}

/// The command that switches the laser off.
pub(crate) const LASER_OFF: Command = Command::JointJog(JointJog::new(JointJogAxis::LaserOff, 0.0));
const PATIENCE: Duration = Duration::from_secs(120);
