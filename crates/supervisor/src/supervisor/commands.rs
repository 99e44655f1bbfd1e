//! Single commands of clients: translation for the arm and tracking until they are over.

use std::collections::HashMap;
use std::time::Duration;

use dobot_api::{ClientId, Jog};
use dobot_arm::Pose;
use dobot_motion::{Button, Model, TrajectoryError};
use dobot_safety::Violation;
use dobot_session::{CommandId, SendError};
use dobot_wire::{Command, JointJog, JointJogAxis, MoveTo, MovingMode, VoiceOrder};

use super::arm::Arm;
use super::still_moving;
use crate::refusal::Refusal;

/// Commands of clients that are not over, and their senders.
#[derive(Debug, Default)]
pub(super) struct Commands {
    pending: HashMap<CommandId, ClientId>,
}

impl Commands {
    /// Handles a command of an authorized client: sends it if its whole path is allowed.
    pub(super) fn handle_command(
        &mut self,
        arm: &mut Arm,
        client: ClientId,
        command: &Command,
        rests_within: Duration,
    ) -> Result<CommandId, Refusal> {
        let command = translate(arm, command, rests_within)?;
        check_waiting(arm)?;
        if leads_somewhere(&command) && !knows_start(arm) {
            return Err(still_moving(rests_within));
        }
        let pieces = line_pieces(arm, &command)?;
        let mut last = None;
        for piece in pieces.iter().chain([&command]) {
            last = Some(arm.send(piece)?);
        }
        let id = last.expect("the command itself is sent");
        self.pending.insert(id, client);
        Ok(id)
    }

    /// Handles a finished or dropped command; returns whether it was a client's.
    pub(super) fn handle_over(&mut self, id: CommandId) -> bool {
        self.pending.remove(&id).is_some()
    }

    pub(super) fn any_of(&self, client: ClientId) -> bool {
        self.pending.values().any(|sender| *sender == client)
    }

    /// Returns the commands that are not over.
    pub(super) fn ids(&self) -> impl Iterator<Item = CommandId> {
        self.pending.keys().copied()
    }
}

fn check_waiting(arm: &Arm) -> Result<(), Refusal> {
    let waiting = arm.session().waiting();
    if waiting >= MAX_WAITING {
        return Err(Refusal::TooMany {
            waiting,
            most: MAX_WAITING,
        });
    }
    Ok(())
}

/// Returns whether the start of a motion is known: after a jog, or a motion that ended elsewhere,
/// only once the arm was seen at rest.
fn knows_start(arm: &Arm) -> bool {
    arm.session().model().is_none_or(Model::knows_place)
}

/// Translates a command for this arm: a voice order to a stock arm, which has no voice recognition
/// or uses other numbers, becomes the motion or the button that the words mean (note N50).
pub(super) fn translate(
    arm: &Arm,
    command: &Command,
    rests_within: Duration,
) -> Result<Command, Refusal> {
    let Command::Voice(voice) = command else {
        return Ok(*command);
    };
    let Some(dialect) = arm.session().dialect() else {
        let field = "voice";
        return Err(Refusal::Send(SendError::Undecided { field }));
    };
    if dialect.accepts_voice && !arm.session().is_bluetooth() {
        // From the first byte of a text on, a running motion would stop and lose its position.
        return if arm.is_at_rest() && !arm.session().is_moving() {
            Ok(*command)
        } else {
            Err(still_moving(rests_within))
        };
    }
    let (Some(order), Some(model)) = (VoiceOrder::parse(voice), arm.session().model()) else {
        let error = TrajectoryError::NotUnderstood;
        return Err(Refusal::Policy(Box::new(Violation::of_trajectory(&error))));
    };
    Ok(spoken(order, model))
}

/// Returns the button of a command that moves the arm while held, or of its release, in whichever
/// form it is sent.
pub(super) fn button(command: &Command) -> Option<Jog> {
    let switches = matches!(
        Button::of(command),
        Some(Button::Suction(_) | Button::Laser(_))
    );
    match command {
        Command::JointJog(jog) if !switches => Some(Jog::Joint(*jog)),
        Command::LinearJog(jog) if !switches => Some(Jog::Linear(*jog)),
        _ => None,
    }
}

/// Returns the targets to send before a straight line that takes longer than `queue.line_s`, so
/// that each piece is short enough. Pump and gripper keep their state until the last piece. Every
/// piece is allowed by the policy.
fn line_pieces(arm: &Arm, command: &Command) -> Result<Vec<Command>, Refusal> {
    let (Command::MoveTo(target), Some(begin)) = (command, arm.session().model()) else {
        return Ok(Vec::new());
    };
    if target.mode != MovingMode::MovL {
        return Ok(Vec::new());
    }
    let policy = arm.policy();
    let pieces = piece_count(begin, command, policy.queue.line_s);
    if pieces == 1 {
        return Ok(Vec::new());
    }
    let share = |piece: u16| f32::from(piece) / f32::from(pieces);
    let before_last: Vec<_> = (1..pieces)
        .map(|piece| on_line(begin, target, share(piece)))
        .collect();
    let mut model = *begin;
    for piece in before_last.iter().chain([command]) {
        let trajectory = policy.check(&model, piece)?;
        model = model.after(piece, &trajectory);
    }
    Ok(before_last)
}

/// Returns into how many pieces a line is cut so that none takes longer than `line_s`.
fn piece_count(begin: &Model, line: &Command, line_s: f64) -> u16 {
    // A line without a trajectory is refused when it is sent.
    let takes_s = begin
        .trajectory(line)
        .ok()
        .and_then(|trajectory| trajectory.motion_s());
    let is_enough =
        |pieces: &u16| takes_s.is_none_or(|takes_s| takes_s <= f64::from(*pieces) * line_s);
    (1..MAX_PIECES).find(is_enough).unwrap_or(MAX_PIECES)
}

/// Returns the target at a share, from 0 to 1, of the line to a target.
fn on_line(begin: &Model, target: &MoveTo, share: f32) -> Command {
    let status = begin.status();
    let between = |from: f32, to: f32| from + share * (to - from);
    Command::from(MoveTo {
        x_mm: between(status.x_mm, target.x_mm),
        y_mm: between(status.y_mm, target.y_mm),
        z_mm: between(status.z_mm, target.z_mm),
        rotation_deg: status.rotation_deg,
        suction: begin.suction,
        gripper_deg: status.gripper_deg,
        pause_s: 0.0,
        ..*target
    })
}

/// Returns whether the path of a command starts where the arm is.
const fn leads_somewhere(command: &Command) -> bool {
    match command {
        Command::WriteVector(vector) => !vector.stop,
        Command::MoveTo(_)
        | Command::MoveJoints(_)
        | Command::MouseMove(_)
        | Command::Gesture(_)
        | Command::Voice(_) => true,
        _ => false,
    }
}

/// Translates an order to a command for every arm: a straight line at the current line speed with
/// pump and gripper unchanged, or the pump's button.
#[expect(
    clippy::cast_possible_truncation,
    reason = "a packet carries single precision"
)]
fn spoken(order: VoiceOrder, model: &Model) -> Command {
    let button = |axis| Command::from(JointJog::new(axis, 0.0));
    match order {
        VoiceOrder::Catch => button(JointJogAxis::SuctionOn),
        VoiceOrder::Release => button(JointJogAxis::SuctionOff),
        VoiceOrder::Move { x_mm, y_mm, z_mm } => {
            let Pose { position, rotation } = model.place.pose;
            MoveTo {
                x_mm: position.x.0 as f32 + x_mm,
                y_mm: position.y.0 as f32 + y_mm,
                z_mm: position.z.0 as f32 + z_mm,
                rotation_deg: rotation.0 as f32,
                suction: model.suction,
                mode: MovingMode::MovL,
                gripper_deg: model.gripper_deg as f32,
                pause_s: 0.0,
            }
            .into()
        }
    }
}

/// The maximum number of pieces of a line. A very slow line has longer pieces instead.
const MAX_PIECES: u16 = 32;
/// A client with more waiting commands should send a job.
const MAX_WAITING: usize = 64;
