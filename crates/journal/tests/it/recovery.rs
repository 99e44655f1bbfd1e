//! Where the arm rests shows which command was the last one done.

use crate::lab::program::{self, LIFT_MM, lifted};
use crate::lab::vector;
use dobot_arm::{Position, Tool};
use dobot_journal::{
    Located, NEAR_MM, SPACING_MM, Unclear, Window, locate, model_at, prelude, window_end,
};
use dobot_wire::{Command, Configuration, Dialect, JointJog, JointJogAxis, PlaybackAdjustment};
use proptest::prelude::*;

#[test]
fn each_corner_of_a_square_is_located_and_its_closing_command_must_wait() {
    let square = [
        vector(20.0, 0.0, 0.0),
        vector(0.0, 20.0, 0.0),
        vector(-20.0, 0.0, 0.0),
        vector(0.0, -20.0, 0.0),
        vector(0.0, 0.0, 5.0),
    ];
    let model = program::model(Dialect::FIRMWARE_1_1);
    assert_eq!(window_end(&square, 0, &model, None, 32), 3);
    let later = program::after(&model, &square[..1]);
    assert_eq!(window_end(&square, 1, &later, None, 32), 5);

    let window = Window::at(0, 3, &model);
    for (next, [x, y]) in [[220.0, 0.0], [240.0, 0.0], [240.0, 20.0], [220.0, 20.0]]
        .iter()
        .enumerate()
    {
        let rest = Position::new(*x, *y, 20.01);
        let located = locate(&square, &window, &model, None, rest);
        assert_eq!(
            located,
            Ok(Located {
                next,
                lifted: false
            })
        );
    }
}

#[test]
fn a_lifted_pen_is_distinguished_from_a_lowered_one() {
    let line = [vector(20.0, 0.0, 0.0), vector(0.0, 20.0, 0.0)];
    let model = program::model(Dialect::SPECIFICATION);
    let window = Window::at(0, 2, &model);
    let rest = Position::new(240.0, 0.0, 25.0);
    let located = locate(&line, &window, &model, Some(LIFT_MM), rest);
    assert_eq!(
        located,
        Ok(Located {
            next: 1,
            lifted: true
        })
    );
    let error = locate(&line, &window, &model, None, rest).unwrap_err();
    assert!(matches!(error, Unclear::Nowhere { .. }), "{error}");
}

#[test]
fn a_pen_that_is_up_is_not_lowered_to_be_lifted_again() {
    let line = [
        vector(20.0, 0.0, 0.0),
        vector(0.0, 0.0, 5.0),
        vector(0.0, 20.0, 0.0),
    ];
    let model = program::model(Dialect::SPECIFICATION);
    let window = Window::at(0, window_end(&line, 0, &model, Some(LIFT_MM), 32), &model);
    assert_eq!(window.upto, 3);
    let rest = Position::new(240.0, 0.0, 25.0);
    let located = locate(&line, &window, &model, Some(LIFT_MM), rest);
    assert_eq!(
        located,
        Ok(Located {
            next: 2,
            lifted: false
        })
    );
}

#[test]
fn an_arm_that_rests_elsewhere_is_not_located() {
    let line = [vector(20.0, 0.0, 0.0)];
    let model = program::model(Dialect::SPECIFICATION);
    let window = Window::at(0, 1, &model);
    let error = locate(
        &line,
        &window,
        &model,
        None,
        Position::new(230.0, 0.0, 20.0),
    )
    .unwrap_err();
    assert_eq!(
        error.to_string(),
        "the arm rests 10.000 mm from the nearest position where it may have stopped, x 220.000 y \
         0.000 z 20.000 mm (0 commands done); up to 0.5 mm are allowed: move it there, or state \
         how far it got"
    );
    let nowhere = Position::new(f64::NAN, 0.0, 20.0);
    assert!(locate(&line, &window, &model, None, nowhere).is_err());
}

#[test]
fn two_endpoints_at_one_place_are_both_named() {
    let there_and_back = [vector(20.0, 0.0, 0.0), vector(-20.0, 0.0, 0.0)];
    let model = program::model(Dialect::SPECIFICATION);
    let window = Window::at(0, 2, &model);
    let rest = model.place.pose.position;
    let error = locate(&there_and_back, &window, &model, None, rest).unwrap_err();
    let Unclear::Between {
        nearest, second, ..
    } = error
    else {
        panic!("{error}");
    };
    let mut both = [nearest.located.next, second.located.next];
    both.sort_unstable();
    assert_eq!(both, [0, 2]);
}

#[test]
fn a_jog_is_sent_alone() {
    let jog = Command::from(JointJog::new(JointJogAxis::BasePlus, 50.0));
    let commands = [vector(20.0, 0.0, 0.0), jog, vector(20.0, 0.0, 0.0)];
    let model = program::model(Dialect::SPECIFICATION);
    assert_eq!(window_end(&commands, 0, &model, None, 32), 1);
    let later = program::after(&model, &commands[..1]);
    assert_eq!(window_end(&commands, 1, &later, None, 32), 2);
}

#[test]
fn settings_are_sent_again_once_each_and_initial_angles_never() {
    let writing = |acceleration_mm_s2| Command::from(Configuration::Writing { acceleration_mm_s2 });
    let tool = |tool: Tool| Command::from(Configuration::EndEffector { tool: tool.into() });
    let percent = |speed_percent| {
        Command::from(PlaybackAdjustment {
            speed_percent,
            acceleration_percent: 50.0,
            teach_speed_percent: 50.0,
        })
    };
    let angles = Command::from(Configuration::InitialAngles {
        rear_deg: 45.0,
        fore_deg: 45.0,
    });
    let commands = [
        writing(10.0),
        tool(Tool::Laser),
        percent(10.0),
        angles,
        vector(1.0, 0.0, 0.0),
        writing(20.0),
        percent(20.0),
        tool(Tool::Gripper),
    ];
    let wanted = [tool(Tool::Laser), writing(20.0), percent(20.0)];
    assert_eq!(prelude(&commands[..7]), wanted);
    assert_eq!(prelude(&[]), []);
}

#[test]
fn the_model_of_a_window_includes_the_settings_before_it() {
    let commands = [
        Configuration::Writing {
            acceleration_mm_s2: 33.0,
        }
        .into(),
        vector(3.0, 0.0, 0.0),
        vector(0.0, 4.0, 0.0),
    ];
    let model = program::model(Dialect::FIRMWARE_1_1);
    let there = program::after(&model, &commands[..2]);
    let found = model_at(
        Dialect::FIRMWARE_1_1,
        &commands[..2],
        &Window::at(2, 3, &there),
    )
    .unwrap();
    assert_eq!(found.settings, there.settings);
    let off_mm = found
        .place
        .pose
        .position
        .distance(there.place.pose.position)
        .0;
    assert!(
        off_mm < 1e-4,
        "found {found:?}, expected {there:?} to 1e-4 mm"
    );
    let unknown = Window {
        start: None,
        ..Window::at(2, 3, &there)
    };
    assert_eq!(
        model_at(Dialect::FIRMWARE_1_1, &commands[..2], &unknown),
        None
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn the_last_completed_command_is_found_in_any_program(
        (dialect, commands) in program::dialect()
            .prop_flat_map(|dialect| (Just(dialect), program::commands(dialect, 40))),
        begin in any::<prop::sample::Index>(),
        stop in any::<prop::sample::Index>(),
        most in 1_usize..33,
        pen in pen(),
        (noise, direction) in (0.0..=0.2_f64, direction()),
    ) {
        prop_assume!(!commands.is_empty());
        let completed = begin.index(commands.len());
        let model = program::after(&program::model(dialect), &commands[..completed]);
        let upto = window_end(&commands, completed, &model, pen.may_lift(), most);
        prop_assert!(completed < upto && upto <= commands.len() && upto <= completed + most);

        let places = Places::new(&commands[..upto], completed, model.place.pose.position, pen);
        let truth = places.pick(stop);
        let spacing_mm = places.least_spacing_mm(&commands);
        if spacing_mm < SPACING_MM {
            // Only what would never get on otherwise.
            prop_assert_eq!(upto, completed + 1);
            return Ok(());
        }
        let off_mm = (noise * spacing_mm).min(0.99 * NEAR_MM);
        let rest = truth.at + scaled(direction, off_mm);
        let found = locate(&commands, &Window::at(completed, upto, &model), &model, pen.may_lift(), rest);
        prop_assert!(truth.is(found, &commands), "found {found:?}, expected {truth:?}");
    }

    #[test]
    fn a_window_of_any_size_is_located_correctly_or_not_at_all(
        (dialect, commands) in program::dialect()
            .prop_flat_map(|dialect| (Just(dialect), program::commands(dialect, 20))),
        stop in any::<prop::sample::Index>(),
        pen in pen(),
        (noise, direction) in (0.0..=0.2_f64, direction()),
    ) {
        let model = program::model(dialect);
        let places = Places::new(&commands, 0, model.place.pose.position, pen);
        let truth = places.pick(stop);
        let rest = truth.at + scaled(direction, noise * SPACING_MM);
        let window = Window::at(0, commands.len(), &model);
        let found = locate(&commands, &window, &model, pen.may_lift(), rest);
        let unclear = matches!(found, Err(Unclear::Between { .. }));
        prop_assert!(unclear || truth.is(found, &commands), "found {found:?}, expected {truth:?}");
    }

    #[test]
    fn a_window_that_advances_does_not_go_back(
        commands in program::commands(Dialect::SPECIFICATION, 40)
            .prop_map(|commands| commands.into_iter().filter(is_vector).collect::<Vec<_>>()),
        most in 1_usize..33,
    ) {
        let mut model = program::model(Dialect::SPECIFICATION);
        let mut upto = 0;
        for completed in 0..commands.len() {
            let Ok(trajectory) = model.trajectory(&commands[completed]) else { break };
            let next = window_end(&commands, completed, &model, Some(LIFT_MM), most);
            prop_assert!(next >= upto, "{upto}, then {next}");
            upto = next;
            model = model.after(&commands[completed], &trajectory);
        }
    }
}

/// Whether the pen may have been lifted, and was.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Pen {
    NeverLifted,
    Down,
    Lifted,
}

impl Pen {
    fn may_lift(self) -> Option<f32> {
        (self != Self::NeverLifted).then_some(LIFT_MM)
    }
}

fn pen() -> impl Strategy<Value = Pen> {
    proptest::sample::select(vec![Pen::NeverLifted, Pen::Down, Pen::Lifted])
}

fn direction() -> impl Strategy<Value = Position> {
    (-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64)
        .prop_map(|(x, y, z)| Position::new(x, y, z))
        .prop_filter("a direction has a length", |direction| {
            direction.length().0 > 0.1
        })
}

fn scaled(direction: Position, length_mm: f64) -> Position {
    direction * (length_mm / direction.length().0)
}

const fn is_vector(command: &Command) -> bool {
    matches!(command, Command::WriteVector(_))
}

/// The possible rest positions of an arm, by adding increments.
struct Places {
    all: Vec<Place>,
    pen: Pen,
}

#[derive(Clone, Copy, Debug)]
struct Place {
    /// The command after the last motion.
    next: usize,
    lifted: bool,
    at: Position,
}

impl Places {
    fn new(commands: &[Command], completed: usize, start: Position, pen: Pen) -> Self {
        let down = Place {
            next: completed,
            lifted: false,
            at: start,
        };
        let mut all = vec![down];
        for (index, command) in commands.iter().enumerate().skip(completed) {
            let last = *all.last().unwrap();
            let at = program::end(last.at, command);
            // A target at the place of the arm is not a motion, nor is a setting.
            if at.distance(last.at).0 >= SPACING_MM || is_vector(command) {
                all.push(Place {
                    next: index + 1,
                    at,
                    ..last
                });
            }
        }
        if pen != Pen::NeverLifted {
            let lift = |place: &Place| Place {
                lifted: true,
                at: lifted(place.at),
                ..*place
            };
            all.extend(all.clone().iter().map(lift));
        }
        Self { all, pen }
    }

    fn pick(&self, index: prop::sample::Index) -> Place {
        let wanted = self
            .all
            .iter()
            .filter(|end| end.lifted == (self.pen == Pen::Lifted));
        **index.get(&wanted.collect::<Vec<_>>())
    }

    /// Between places that make a difference.
    fn least_spacing_mm(&self, commands: &[Command]) -> f64 {
        let mut least_mm = f64::INFINITY;
        for (index, a) in self.all.iter().enumerate() {
            for b in &self.all[..index] {
                if !a.is_as_good_as(b, commands) && !b.is_as_good_as(a, commands) {
                    least_mm = least_mm.min(a.at.distance(b.at).0);
                }
            }
        }
        least_mm
    }
}

impl Place {
    /// Returns whether it was found, or an equivalent end.
    fn is(&self, found: Result<Located, Unclear>, commands: &[Command]) -> bool {
        found.is_ok_and(|Located { next, lifted }| {
            let found = Self {
                next,
                lifted,
                ..*self
            };
            (next, lifted) == (self.next, self.lifted) || found.is_as_good_as(self, commands)
        })
    }

    /// A pen that was lifted from the lower end of a lift is at its upper end.
    fn is_as_good_as(&self, other: &Self, commands: &[Command]) -> bool {
        let between = self.next.min(other.next)..self.next.max(other.next);
        let mut moves = commands[between]
            .iter()
            .filter(|command| !matches!(command, Command::Configuration(_)));
        let way = moves
            .next()
            .map(|command| program::end(Position::default(), command));
        let up_mm = if self.next > other.next {
            LIFT_MM
        } else {
            -LIFT_MM
        };
        let up = Position::new(0.0, 0.0, up_mm.into());
        !self.lifted
            && other.lifted
            && moves.next().is_none()
            && way.is_some_and(|way| way.distance(up).0 < SPACING_MM)
    }
}
