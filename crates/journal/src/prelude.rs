//! Settings to send again after a possible reset of the arm.

use std::mem::{Discriminant, discriminant};

use dobot_motion::Model;
use dobot_wire::{Command, Configuration, Dialect};

use crate::Window;

/// Returns the last setting of each kind among commands, in order: to be sent again if the arm may
/// have lost them.
///
/// Initial angles are not included: they state where the arm was then, not where it is.
#[must_use]
pub fn prelude<'a>(commands: impl IntoIterator<Item = &'a Command>) -> Vec<Command> {
    let mut kept: Vec<(Kind, Command)> = Vec::new();
    for command in commands {
        if let Some(kind) = kind(command) {
            kept.retain(|(other, _)| *other != kind);
            kept.push((kind, *command));
        }
    }
    kept.into_iter().map(|(_, command)| command).collect()
}

/// Returns the model of the arm before command `window.completed`, where `before` are the commands
/// before it; `None` if the window's start is unknown.
#[must_use]
pub fn model_at<'a>(
    dialect: Dialect,
    before: impl IntoIterator<Item = &'a Command>,
    window: &Window,
) -> Option<Model> {
    let model = Model::new(dialect, window.start.as_ref()?);
    let settings = prelude(before);
    Some(
        settings
            .iter()
            .fold(model, |model, command| model.begun(command)),
    )
}

/// Returns whether a command only sets something that persists and may be set again.
pub(crate) fn is_setting(command: &Command) -> bool {
    kind(command).is_some()
}

/// The kind of a setting: a later one of the same kind overwrites it.
#[derive(Clone, Copy, PartialEq)]
struct Kind(Discriminant<Command>, Option<Discriminant<Configuration>>);

fn kind(command: &Command) -> Option<Kind> {
    match command {
        Command::Configuration(Configuration::InitialAngles { .. }) => None,
        Command::Configuration(configuration) => Some(Kind(
            discriminant(command),
            Some(discriminant(configuration)),
        )),
        Command::PlaybackAdjustment(_) => Some(Kind(discriminant(command), None)),
        _ => None,
    }
}
