//! Speed over time, and the path types.

use dobot_arm::{Degrees, Limits, Millimeters, Pose, Position, Tool, forward};
use dobot_motion::{JointMove, Jump, LineMove, Profile, Speeds};

use dobot_lettering::{Anchor, ShapeStyle};

use crate::canvas::{BLUE, Canvas, FAINT, GREEN, INK, ORANGE, PAPER, PURPLE, SHADE, SOFT, dashed};

/// A trapezoid, a triangle, and an end speed that cannot be reached.
pub(crate) fn profiles() -> String {
    let mut c = Canvas::new(960, 330);
    let plans = [
        ("far enough", 60.0, [10.0, 20.0]),
        ("shorter", 14.0, [10.0, 20.0]),
        ("too short for the end speed", 6.0, [10.0, 40.0]),
    ];
    for (n, (title, distance, [start, end])) in (0..).zip(plans) {
        let profile =
            Profile::new(distance, start, end, 50.0, 60.0).expect("the limits are positive");
        c.place([60.0 + 310.0 * f64::from(n), 270.0], [125.0, 3.6]);
        speed_over_time(&mut c, &profile, distance);
        c.title([0.0, 66.0], Anchor::Left, title);
        if profile.end_speed() < end {
            c.line([0.0, end], [1.9, end], &dashed(ORANGE, 1.3));
            c.note([1.9, end + 3.2], Anchor::Right, "end speed asked for");
        }
    }
    c.finish()
}

/// The jump from the side, a dot every 100 ms.
pub(crate) fn jump() -> String {
    let mut c = Canvas::new(820, 370);
    c.place([120.0, 300.0], [2.6, 2.6]);
    let [from, to] = [pose(180.0, 35.0, 10.0), pose(230.0, -15.0, 40.0)];
    let height = Millimeters(30.0);
    let jump = Jump::new(from, to, height, &SPEEDS).expect("the numbers are in range");
    let mut way_mm = 0.0;
    let mut before = from.position;
    let track: Vec<[f64; 2]> = times(jump.duration_s(), 0.002)
        .map(|t_s| {
            let here = jump.pose_at(t_s).position;
            way_mm += Position {
                z: before.z,
                ..here
            }
            .distance(before)
            .0;
            before = here;
            [way_mm, here.z.0]
        })
        .collect();
    let top = to.position.z.0 + height.0;
    c.line([-30.0, top], [way_mm + 60.0, top], &dashed(FAINT, 1.5));
    c.line([-30.0, 40.0], [way_mm + 60.0, 40.0], &dashed(FAINT, 1.5));
    c.path(&track, &ShapeStyle::line(BLUE, 3.0));
    for point in track.iter().step_by(50) {
        c.dot(*point, 4.0, PAPER, BLUE);
    }
    c.arrow([-30.0, -8.0], [way_mm + 75.0, -8.0], SOFT, 1.5);
    c.text([way_mm + 75.0, -16.0], Anchor::Right, INK, "way across");
    c.arrow([-30.0, -8.0], [-30.0, 96.0], SOFT, 1.5);
    c.text([-26.0, 98.0], Anchor::Left, INK, "z");
    c.measure([way_mm + 40.0, 40.0], [way_mm + 40.0, top]);
    c.text([way_mm + 44.0, 55.0], Anchor::Left, INK, "height");
    c.text([-5.0, 40.0], Anchor::Right, BLUE, "up");
    c.text(
        [way_mm / 2.0, top + 9.0],
        Anchor::Middle,
        BLUE,
        "across: reach and base angle change evenly",
    );
    c.text([way_mm + 5.0, 58.0], Anchor::Left, BLUE, "down");
    c.text([5.0, 10.0], Anchor::Left, INK, "from");
    c.text([way_mm - 4.0, 36.0], Anchor::Right, INK, "to");
    c.note(
        [way_mm / 2.0, 24.0],
        Anchor::Middle,
        "a dot every 100 ms; each phase starts and ends at rest",
    );
    c.finish()
}

/// The three paths between the same two positions, from above, with a dot every 100 ms.
pub(crate) fn ways() -> String {
    let mut c = Canvas::new(820, 520);
    c.place([100.0, 228.0], [1.42, 1.42]);
    let [from, to] = [pose(150.0, 55.0, -20.0), pose(305.0, -35.0, 20.0)];
    let solve = |pose: &Pose| {
        Limits::STOCK
            .solve(pose, TOOL)
            .expect("both places are allowed")
    };
    let joint_move = JointMove::new(solve(&from), solve(&to), &SPEEDS).expect("all in range");
    let line_move = LineMove::new(from, to, &SPEEDS).expect("all in range");
    let jump = Jump::new(from, to, Millimeters(20.0), &SPEEDS).expect("all in range");
    axes(&mut c);
    let joint_at = |t_s| forward(&joint_move.joints_at(t_s), TOOL);
    track(&mut c, joint_at, joint_move.duration_s(), GREEN);
    track(
        &mut c,
        |t_s| line_move.pose_at(t_s),
        line_move.duration_s(),
        ORANGE,
    );
    track(&mut c, |t_s| jump.pose_at(t_s), jump.duration_s(), BLUE);
    for (name, pose, aside_mm, anchor) in [
        ("from", from, -9.0, Anchor::Right),
        ("to", to, 9.0, Anchor::Left),
    ] {
        let at = above(pose);
        c.dot(at, 6.5, INK, PAPER);
        c.text([at[0] + aside_mm, at[1]], anchor, INK, name);
    }
    let legend = [
        (GREEN, "MOVJ: joints together", joint_move.duration_s()),
        (ORANGE, "MOVL: a straight line", line_move.duration_s()),
        (BLUE, "JUMP: up, across, down", jump.duration_s()),
    ];
    for (n, (color, words, duration_s)) in (0..).zip(legend) {
        let y = 142.0 - 15.0 * f64::from(n);
        c.line([262.0, y], [280.0, y], &ShapeStyle::line(color, 3.0));
        c.text(
            [286.0, y],
            Anchor::Left,
            INK,
            &format!("{words}, {duration_s:.2} s"),
        );
    }
    c.note(
        [262.0, 95.0],
        Anchor::Left,
        "seen from above, a dot every 100 ms",
    );
    c.finish()
}

fn speed_over_time(c: &mut Canvas, profile: &Profile, distance: f64) {
    let end_s = profile.duration_s();
    let mut points = vec![[0.0, 0.0]];
    points.extend(times(end_s, 0.005).map(|t_s| [t_s, profile.speed_at(t_s)]));
    points.extend([[end_s, profile.end_speed()], [end_s, 0.0]]);
    c.area(&points, SHADE);
    c.line([0.0, 50.0], [1.9, 50.0], &dashed(PURPLE, 1.3));
    c.note([1.9, 53.2], Anchor::Right, "maximum speed");
    c.path(&points[1..points.len() - 1], &ShapeStyle::line(BLUE, 3.0));
    c.line(
        [end_s, 0.0],
        [end_s, profile.end_speed()],
        &dashed(BLUE, 1.3),
    );
    c.arrow([0.0, 0.0], [2.0, 0.0], SOFT, 1.5);
    c.text([2.0, -5.0], Anchor::Right, INK, "time");
    c.arrow([0.0, 0.0], [0.0, 60.0], SOFT, 1.5);
    c.note([-0.06, profile.start_speed()], Anchor::Right, "start");
    c.note([end_s + 0.06, profile.end_speed()], Anchor::Left, "end");
    c.note(
        [end_s / 2.0, -5.0],
        Anchor::Middle,
        &format!("{distance} mm"),
    );
}

fn axes(c: &mut Canvas) {
    c.arrow([0.0, 0.0], [340.0, 0.0], SOFT, 1.5);
    c.text([346.0, 0.0], Anchor::Left, INK, "X");
    c.arrow([0.0, -190.0], [0.0, 146.0], SOFT, 1.5);
    c.text([8.0, 146.0], Anchor::Left, INK, "Y");
    c.dot([0.0, 0.0], 7.0, PAPER, INK);
    c.note([-8.0, 12.0], Anchor::Right, "base axis");
}

fn track(c: &mut Canvas, pose_at: impl Fn(f64) -> Pose, duration_s: f64, color: &'static str) {
    let points: Vec<_> = times(duration_s, 0.005)
        .map(|t_s| above(pose_at(t_s)))
        .collect();
    c.path(&points, &ShapeStyle::line(color, 3.0));
    for t_s in times(duration_s, 0.1) {
        c.dot(above(pose_at(t_s)), 3.5, PAPER, color);
    }
}

fn times(duration_s: f64, step_s: f64) -> impl Iterator<Item = f64> {
    (0..)
        .map(move |n| f64::from(n) * step_s)
        .take_while(move |t_s| *t_s < duration_s)
        .chain([duration_s])
}

fn above(pose: Pose) -> [f64; 2] {
    [pose.position.x.0, pose.position.y.0]
}

fn pose(reach_mm: f64, base_deg: f64, z_mm: f64) -> Pose {
    Pose {
        position: Position::polar(Millimeters(reach_mm), Degrees(base_deg), Millimeters(z_mm)),
        rotation: Degrees(0.0),
    }
}

const TOOL: Tool = Tool::SuctionCup;
const SPEEDS: Speeds = Speeds::STOCK;
