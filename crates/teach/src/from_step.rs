//! The remainder of a program from one of its steps.

use std::ops::Range;

use dobot_api::{JobPause, JobRepeat};
use dobot_wire::{Command, PlaybackAdjustment, single};

use crate::{Compiled, CompiledStep};

impl Compiled {
    /// Returns the program from a step on, counted from 0 among [`steps`](Self::steps), preceded by
    /// the speed and tool settings before it. Its first motion is as slow as that of the program.
    /// The rest of the current cycle runs once, then the remaining cycles. `None` if there is no
    /// such step.
    #[must_use]
    pub fn from_step(&self, step: usize) -> Option<Self> {
        let first = self.steps.get(step)?.first;
        let settings = self.commands[..first]
            .iter()
            .filter(|command| is_setting(command));
        let mut rest = Self {
            title: self.title.clone(),
            commands: settings.copied().collect(),
            ..Self::default()
        };
        let soft = self.soft_start(first);
        match soft {
            Some((target, [slow, normal])) => {
                rest.append(self, first..target);
                rest.commands.push(slow);
                rest.append(self, target..target + 1);
                rest.commands.push(normal);
                rest.append(self, target + 1..self.commands.len());
            }
            None => rest.append(self, first..self.commands.len()),
        }
        let is_in_cycle = |index: usize| self.repeat.is_some_and(|repeat| index >= repeat.from);
        rest.repeat = match self.repeat {
            Some(repeat)
                if first > repeat.from || soft.is_some_and(|(target, _)| is_in_cycle(target)) =>
            {
                rest.append_cycle(self, repeat)
            }
            Some(repeat) => Some(JobRepeat {
                from: repeat.from + rest.commands.len() - self.commands.len(),
                ..repeat
            }),
            None => None,
        };
        Some(rest)
    }

    /// Returns the first target of the commands from `first` on, and the settings before and after
    /// it for a soft start; `None` if the program has none, or has not moved before `first`.
    fn soft_start(&self, first: usize) -> Option<(usize, [Command; 2])> {
        let percent = self.start_speed_percent?;
        self.commands[..first]
            .iter()
            .find(|command| moves(command))?;
        let mut rest = self.commands[first..].iter();
        let target = first + rest.position(moves)?;
        let set = self.commands[..target].iter().rev();
        let normal = set.copied().find_map(|command| match command {
            Command::PlaybackAdjustment(normal) => Some(normal),
            _ => None,
        })?;
        if matches!(self.commands[target], Command::WriteVector(_)) {
            return None;
        }
        let slow = PlaybackAdjustment {
            speed_percent: normal.speed_percent * single(percent / 100.0),
            ..normal
        };
        Some((target, [slow.into(), normal.into()]))
    }

    /// Appends the whole cycle after the rest of this one, if it runs again.
    fn append_cycle(&mut self, whole: &Self, repeat: JobRepeat) -> Option<JobRepeat> {
        let times = repeat.times.map(|time| time.saturating_sub(1));
        if times == Some(0) {
            return None;
        }
        let from = self.commands.len();
        self.append(whole, repeat.from..whole.commands.len());
        Some(JobRepeat { from, times })
    }

    /// Appends some commands of a program with their steps and pauses.
    fn append(&mut self, whole: &Self, part: Range<usize>) {
        let at = |index: usize| index - part.start + self.commands.len();
        let steps = whole.steps.iter().filter(|step| part.contains(&step.first));
        let steps: Vec<CompiledStep> = steps
            .map(|step| CompiledStep {
                first: at(step.first),
                ..step.clone()
            })
            .collect();
        let pauses = whole
            .pauses
            .iter()
            .filter(|pause| part.contains(&pause.before));
        let pauses: Vec<JobPause> = pauses
            .map(|pause| JobPause {
                before: at(pause.before),
                ..pause.clone()
            })
            .collect();
        self.steps.extend(steps);
        self.pauses.extend(pauses);
        self.commands.extend(&whole.commands[part]);
    }
}

/// Whether the command is a setting that persists, wherever the arm is.
const fn is_setting(command: &Command) -> bool {
    matches!(
        command,
        Command::Configuration(_) | Command::PlaybackAdjustment(_)
    )
}

/// Whether the command moves the arm.
const fn moves(command: &Command) -> bool {
    matches!(
        command,
        Command::MoveTo(_) | Command::MoveJoints(_) | Command::WriteVector(_)
    )
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::{NoFiles, Program};

    fn text(repeat: &str) -> String {
        format!(
            r#"
            [[steps]]
            go = {{ x = 200, y = 0, z = 0 }}
            [[steps]]
            speed = {{ percent = 30 }}
            [[steps]]
            repeat = {repeat}
            [[steps.steps]]
            go = {{ x = 210, y = 0, z = 0 }}
            [[steps.steps]]
            wait = "look"
            [[steps.steps]]
            go = {{ x = 220, y = 0, z = 0 }}
            [[steps.steps]]
            go = {{ x = 230, y = 0, z = 0 }}
            "#
        )
    }

    fn compiled(repeat: &str) -> Compiled {
        let program = Program::from_toml(&text(repeat)).unwrap();
        program.compile(&mut NoFiles).unwrap()
    }

    /// The x of all targets, cycle by cycle.
    fn targets(compiled: &Compiled, cycles: u64) -> Vec<f32> {
        let x = |command: &Command| match command {
            Command::MoveTo(compiled) => Some(compiled.x_mm),
            _ => None,
        };
        let from = compiled
            .repeat
            .map_or(compiled.commands.len(), |repeat| repeat.from);
        let times = compiled
            .repeat
            .map_or(0, |repeat| repeat.times.unwrap_or(cycles));
        let (once, cycle) = compiled.commands.split_at(from);
        let again = (0..times).flat_map(|_| cycle.iter());
        once.iter().chain(again).filter_map(x).collect()
    }

    #[test]
    fn the_rest_visits_the_remaining_targets_of_the_program() {
        let whole = compiled("3");
        let all = targets(&whole, 3);
        for step in 0..whole.steps.len() {
            let rest = whole.from_step(step).unwrap();
            let left = targets(&rest, 3);
            assert!(all.ends_with(&left), "step {step}: {left:?} of {all:?}");
            let before = targets(
                &Compiled {
                    commands: whole.commands[..whole.steps[step].first].to_vec(),
                    ..Compiled::default()
                },
                0,
            );
            assert_eq!(before.len() + left.len(), all.len(), "step {step}");
        }
    }

    #[test]
    fn an_endless_cycle_stays_endless() {
        let whole = compiled("\"forever\"");
        let last = whole.from_step(whole.steps.len() - 1).unwrap();
        // A wait is a target at the position of the arm.
        assert_eq!(targets(&last, 1), [230.0, 210.0, 210.0, 220.0, 230.0]);
        assert_eq!(last.repeat.unwrap().times, None);
    }

    /// The speed of each target, in percent, cycle by cycle.
    fn speeds(compiled: &Compiled) -> Vec<f32> {
        let cycle = compiled
            .repeat
            .map_or(&[][..], |repeat| &compiled.commands[repeat.from..]);
        let mut percent = 0.0;
        let speed = |command: &Command| match command {
            Command::PlaybackAdjustment(set) => {
                percent = set.speed_percent;
                None
            }
            Command::MoveTo(_) => Some(percent),
            _ => None,
        };
        compiled
            .commands
            .iter()
            .chain(cycle)
            .filter_map(speed)
            .collect()
    }

    #[test]
    fn the_first_motion_of_the_rest_is_slow_and_no_other_one() {
        for repeat in ["1", "3", "\"forever\""] {
            let text = format!("start_speed_percent = 20\n{}", text(repeat));
            let whole = Program::from_toml(&text).unwrap();
            let whole = whole.compile(&mut NoFiles).unwrap();
            for step in 0..whole.steps.len() {
                let rest = speeds(&whole.from_step(step).unwrap());
                let normal = if step == 0 { 50.0 } else { 30.0 };
                assert!(
                    (rest[0] - normal * 0.2).abs() < 1e-4,
                    "step {step}: {rest:?}"
                );
                assert!(
                    rest[1..].iter().all(|speed| *speed == 30.0),
                    "step {step}: {rest:?}"
                );
            }
        }
    }

    #[test]
    fn speeds_set_before_the_step_still_apply() {
        let whole = compiled("1");
        let last = whole.from_step(whole.steps.len() - 1).unwrap();
        let set = whole
            .commands
            .iter()
            .find(|command| is_setting(command))
            .unwrap();
        assert!(last.commands.contains(set), "{:?}", last.commands);
    }

    #[test]
    fn steps_and_pauses_stay_with_their_commands() {
        let whole = compiled("2");
        for step in 0..whole.steps.len() {
            let rest = whole.from_step(step).unwrap();
            for step in &rest.steps {
                let same = |other: &&CompiledStep| other.line == step.line;
                let other = whole.steps.iter().find(same).unwrap();
                assert_eq!(rest.commands[step.first], whole.commands[other.first]);
            }
            assert!(
                rest.pauses
                    .iter()
                    .all(|pause| pause.before <= rest.commands.len())
            );
        }
        assert!(whole.from_step(whole.steps.len()).is_none());
    }
}
