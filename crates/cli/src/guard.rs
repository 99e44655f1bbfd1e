//! The safety policy, for arms that are reached without a station.

use anyhow::anyhow;
use dobot_client::{CommandId, Connection};
use dobot_safety::{Policy, Violation};
use dobot_wire::Command;

use crate::connect::Connected;
use crate::failure::Failure;

/// Sends a command, if the policy allows its whole way.
pub(crate) async fn send(
    arm: &mut Connection,
    policy: &Policy,
    command: Command,
) -> Result<CommandId, Failure> {
    arm.session().check(&command)?;
    if arm.session().model().is_none() {
        arm.next_status().await?;
    }
    check(arm, policy, [command])?;
    Ok(arm.send(command)?)
}

/// Whether the policy allows the whole way of all these commands, one after the other.
pub(crate) async fn check_all(
    connected: &mut Connected,
    commands: impl IntoIterator<Item = Command>,
) -> Result<(), Failure> {
    let Connected { arm, policy, .. } = connected;
    // Whoever sends them tells of an arm that says nothing, and leaves it in order.
    if arm.session().model().is_some() || arm.next_status().await.is_ok() {
        check(arm, policy, commands)?;
    }
    Ok(())
}

/// What the session does not send, because it depends on a dialect that nobody knows, is left to it.
fn check(
    arm: &Connection,
    policy: &Policy,
    commands: impl IntoIterator<Item = Command>,
) -> Result<(), Failure> {
    let session = arm.session();
    let Some(mut model) = session.model().copied() else {
        return Ok(());
    };
    for command in commands {
        if session.dialect().is_none() && command.dialect_dependent().is_some() {
            return Ok(());
        }
        let course = policy.check(&model, &command).map_err(|it| refused(&it))?;
        model = model.after(&command, &course);
    }
    Ok(())
}

/// Whether the policy allows that a button is held on.
pub(crate) fn check_held(
    arm: &Connection,
    policy: &Policy,
    button: &Command,
) -> Result<(), Failure> {
    let Some(model) = arm.session().seen_model() else {
        return Ok(());
    };
    let checked = policy.check_jog(&model, button, policy.jog.reaction_s);
    checked.map_err(|it| refused(&it))
}

fn refused(violation: &Violation) -> Failure {
    Failure::new(
        anyhow!("refused by {}: {violation}", violation.rule),
        "`dobot policy` shows the rules, `--policy FILE` takes others",
    )
}
