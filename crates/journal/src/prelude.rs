//! What an arm has to be told again that may have been reset.

use std::mem::{Discriminant, discriminant};

use dobot_motion::Model;
use dobot_wire::{Command, Configuration, Dialect};

use crate::Window;

/// The last settings of each kind among commands, in their order: to be sent again where the arm may have forgotten
/// them.
///
/// The initial angles are none of them: they say where the arm was then, not where it is.
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

/// The model of the arm as command `window.completed` finds it, where `before` are the commands before it; `None` where
/// the window does not know its start.
#[must_use]
pub fn model_at<'a>(
    dialect: Dialect,
    before: impl IntoIterator<Item = &'a Command>,
    window: &Window,
) -> Option<Model> {
    let model = Model::new(dialect, window.start.as_ref()?);
    let told = prelude(before);
    Some(
        told.iter()
            .fold(model, |model, command| model.begun(command)),
    )
}

/// Whether a command only sets something that stays set and may be set again.
pub(crate) fn is_setting(command: &Command) -> bool {
    kind(command).is_some()
}

/// What overwrites what.
#[derive(Clone, Copy, PartialEq)]
struct Kind(Discriminant<Command>, Option<Discriminant<Configuration>>);

fn kind(command: &Command) -> Option<Kind> {
    match command {
        Command::Configuration(Configuration::InitialAngles { .. }) => None,
        Command::Configuration(it) => Some(Kind(discriminant(command), Some(discriminant(it)))),
        Command::PlaybackAdjustment(_) => Some(Kind(discriminant(command), None)),
        _ => None,
    }
}
