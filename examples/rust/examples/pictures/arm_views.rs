//! The arm from the side and from above.

use dobot_arm::{FOREARM, Joints, Limits, REAR_ARM, Tool, forward};

use dobot_lettering::{Anchor, ShapeStyle};

use crate::canvas::{
    BLUE, Canvas, FAINT, GREEN, INK, ORANGE, PURPLE, RED, SHADE, SOFT, dashed, polar,
};

/// Rear arm, forearm and tool in the plane of reach and z, with their angles.
pub(crate) fn side() -> String {
    let mut c = Canvas::new(820, 560);
    c.place([200.0, 350.0], [1.6, 1.6]);
    let joints = Joints::new(0.0, 28.0, 24.0, 0.0);
    let tool = forward(&joints, Tool::SuctionCup).position;
    let [reach, z] = [tool.reach().0, tool.z.0];
    let wrist = [reach - Tool::SuctionCup.reach().0, z];
    let elbow = polar([0.0, 0.0], REAR_ARM.0, 90.0 - joints.rear.0);
    table_and_base(&mut c);
    axes(&mut c);

    c.line([0.0, 0.0], [0.0, 168.0], &dashed(BLUE, 1.5));
    c.angle([0.0, 0.0], 88.0, [90.0, 90.0 - joints.rear.0], BLUE);
    c.text(polar([0.0, 0.0], 101.0, 77.0), Anchor::Middle, BLUE, "rear");
    c.line(elbow, [elbow[0] + 130.0, elbow[1]], &dashed(ORANGE, 1.5));
    c.angle(elbow, 100.0, [0.0, -joints.fore.0], ORANGE);
    c.text(polar(elbow, 106.0, -10.0), Anchor::Left, ORANGE, "fore");

    links(&mut c, &[[0.0, 0.0], elbow, wrist, [reach, z]]);
    c.text([46.0, 50.0], Anchor::Left, BLUE, "135 mm");
    let middle = polar(elbow, FOREARM.0 / 2.0, -joints.fore.0);
    c.text(
        [middle[0] - 6.0, middle[1] - 17.0],
        Anchor::Right,
        ORANGE,
        "160 mm",
    );
    c.text([reach - 27.0, z + 14.0], Anchor::Middle, GREEN, "L");

    c.measure([reach + 34.0, 0.0], [reach + 34.0, z]);
    c.line(
        [reach + 4.0, z],
        [reach + 40.0, z],
        &ShapeStyle::line(FAINT, 1.3),
    );
    c.text([reach + 40.0, z / 2.0], Anchor::Left, INK, "z");
    c.measure([0.0, -38.0], [reach, -38.0]);
    c.line(
        [reach, z - 26.0],
        [reach, -44.0],
        &ShapeStyle::line(FAINT, 1.3),
    );
    c.text(
        [reach / 2.0, -48.0],
        Anchor::Middle,
        INK,
        "reach = √(x² + y²)",
    );
    c.note([wrist[0] + 2.0, z - 16.0], Anchor::Middle, "wrist");
    c.note([elbow[0] - 4.0, elbow[1] + 17.0], Anchor::Middle, "elbow");
    c.note([-14.0, 6.0], Anchor::Right, "pivot");
    c.finish()
}

/// Base, servo and rotation seen from above, over the ring of reach.
pub(crate) fn top() -> String {
    let mut c = Canvas::new(820, 690);
    c.place([245.0, 360.0], [0.98, 0.98]);
    let joints = Joints::new(38.0, 35.0, 12.0, 32.0);
    let pose = forward(&joints, Tool::SuctionCup);
    let tool = [pose.position.x.0, pose.position.y.0];
    let wrist = polar(
        [0.0, 0.0],
        pose.position.reach().0 - Tool::SuctionCup.reach().0,
        joints.base.0,
    );
    ring(&mut c);

    c.arrow([0.0, 0.0], [395.0, 0.0], SOFT, 1.5);
    c.text([404.0, 0.0], Anchor::Left, INK, "X, ahead");
    c.arrow([0.0, 0.0], [0.0, 338.0], SOFT, 1.5);
    c.text([12.0, 336.0], Anchor::Left, INK, "Y, to the left");

    let far = polar(tool, 118.0, joints.base.0);
    c.line(tool, far, &dashed(BLUE, 1.5));
    c.line(tool, [tool[0] + 150.0, tool[1]], &dashed(SOFT, 1.5));
    c.line(
        tool,
        polar(tool, 150.0, pose.rotation.0),
        &ShapeStyle::line(PURPLE, 3.0),
    );
    c.angle([0.0, 0.0], 92.0, [0.0, joints.base.0], BLUE);
    c.text(polar([0.0, 0.0], 104.0, 17.0), Anchor::Left, BLUE, "base");
    c.angle(tool, 84.0, [joints.base.0, pose.rotation.0], GREEN);
    c.text(polar(tool, 80.0, 77.0), Anchor::Right, GREEN, "servo");
    c.angle(tool, 126.0, [0.0, pose.rotation.0], PURPLE);
    c.text(
        [tool[0] + 132.0, tool[1] + 62.0],
        Anchor::Left,
        PURPLE,
        "rotation (rHead)",
    );
    c.text(
        [tool[0] + 132.0, tool[1] + 42.0],
        Anchor::Left,
        PURPLE,
        "= base + servo",
    );

    links(&mut c, &[[0.0, 0.0], wrist, wrist, tool]);
    c.text([tool[0] - 4.0, tool[1] - 22.0], Anchor::Left, INK, "tool");
    c.note([-12.0, -16.0], Anchor::Right, "base axis");
    c.finish()
}

fn table_and_base(c: &mut Canvas) {
    c.area(
        &[
            [-46.0, -103.0],
            [46.0, -103.0],
            [30.0, -14.0],
            [-30.0, -14.0],
        ],
        "#e5e7eb",
    );
    c.area(
        &[
            [-120.0, -103.0],
            [375.0, -103.0],
            [375.0, -112.0],
            [-120.0, -112.0],
        ],
        "#f3e8d8",
    );
    c.line(
        [-120.0, -103.0],
        [375.0, -103.0],
        &ShapeStyle::line("#b08968", 2.0),
    );
    c.note(
        [375.0, -95.0],
        Anchor::Right,
        "table, about 103 mm below the pivot",
    );
}

fn axes(c: &mut Canvas) {
    c.arrow([0.0, 0.0], [335.0, 0.0], SOFT, 1.5);
    c.text([341.0, 0.0], Anchor::Left, INK, "reach");
    c.arrow([0.0, 0.0], [0.0, 196.0], SOFT, 1.5);
    c.text([10.0, 194.0], Anchor::Left, INK, "Z, up");
}

/// Pivot, elbow, wrist and tool, connected.
fn links(c: &mut Canvas, points: &[[f64; 2]; 4]) {
    let [pivot, elbow, wrist, tool] = *points;
    c.line(pivot, elbow, &ShapeStyle::line(BLUE, 9.0));
    c.line(elbow, wrist, &ShapeStyle::line(ORANGE, 9.0));
    c.line(wrist, tool, &ShapeStyle::line(GREEN, 9.0));
    for joint in [pivot, elbow, wrist] {
        c.dot(joint, 7.0, "#ffffff", INK);
    }
    c.dot(tool, 6.0, RED, "#ffffff");
}

/// The ring that the tool can reach, within the base's range in the manual.
fn ring(c: &mut Canvas) {
    let Limits { reach, .. } = Limits::STOCK;
    let arc = |radius: f64, turn: f64| -> Vec<[f64; 2]> {
        (0..=90)
            .map(|n| polar([0.0, 0.0], radius, turn * (f64::from(n) / 45.0 - 1.0)))
            .collect()
    };
    let mut outline = arc(reach.max.0, 135.0);
    outline.extend(arc(reach.min.0, -135.0));
    c.area(&outline, SHADE);
    for (radius, direction, words) in [
        (reach.min.0, -100.0, "129 mm"),
        (reach.max.0, -48.0, "321 mm"),
    ] {
        let end = polar([0.0, 0.0], radius, direction);
        c.arrow([0.0, 0.0], end, SOFT, 1.3);
        let middle = polar([0.0, 0.0], 0.62 * radius, direction);
        c.note([middle[0] + 10.0, middle[1] + 2.0], Anchor::Left, words);
    }
}
