//! The sheet on a table, and what is on it.

use dobot_calibrate::{Marker, SHEET_POINTS, sheet_markers};
use dobot_geometry::Random;
use serde_json::{Value, json};

/// The sheet, objects and crosses, in mm in the frame of the sheet.
#[derive(Default)]
pub(crate) struct Scene {
    pub(crate) objects: Vec<Object>,
    pub(crate) crosses: Vec<[f64; 2]>,
    /// How far the sheet was moved forward and to the left.
    pub(crate) sheet_at: [f64; 2],
    /// Whether something covers two of the markers.
    pub(crate) is_covered: bool,
}

/// A block, with a marker on top or in a colour.
pub(crate) struct Object {
    marker: Option<u16>,
    at: [f64; 2],
    turn_deg: f64,
    bottom_mm: f64,
    height_mm: f64,
    /// Along X and Y before it is turned.
    sides_mm: [f64; 2],
    color: [f64; 3],
}

impl Object {
    /// A cube of 25 mm with a marker of 20 mm.
    pub(crate) const fn cube(marker: u16, at: [f64; 2], turn_deg: f64) -> Self {
        Self {
            marker: Some(marker),
            at,
            turn_deg,
            bottom_mm: 0.0,
            height_mm: 25.0,
            sides_mm: [25.0; 2],
            color: WHITE,
        }
    }

    pub(crate) fn random(marker: u16, random: &mut Random) -> Self {
        let at = [
            165.0 + 100.0 * random.share(),
            150.0 * random.share() - 75.0,
        ];
        Self {
            height_mm: 30.0 * random.share(),
            sides_mm: [27.0; 2],
            ..Self::cube(marker, at, 360.0 * random.share() - 180.0)
        }
    }

    pub(crate) fn json(&self) -> Value {
        json!({
            "marker": self.marker,
            "x_mm": self.at[0],
            "y_mm": self.at[1],
            "turn_deg": self.turn_deg,
            "height_mm": self.height_mm,
        })
    }

    /// The color where a ray meets its top or its sides, and how far that is.
    fn seen(&self, from: [f64; 3], ray: [f64; 3]) -> Option<(f64, [f64; 3])> {
        let (sin, cos) = self.turn_deg.to_radians().sin_cos();
        // In the frame of the block, whose top is level.
        let into = |x: f64, y: f64| [x * cos + y * sin, y * cos - x * sin];
        let [x, y] = into(from[0] - self.at[0], from[1] - self.at[1]);
        let [dx, dy] = into(ray[0], ray[1]);
        let [half_x, half_y] = self.sides_mm.map(|side| side / 2.0);
        let top_mm = self.bottom_mm + self.height_mm;
        let (mut near, mut far) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut is_top = false;
        for (axis, (start, step, low, high)) in [
            (x, dx, -half_x, half_x),
            (y, dy, -half_y, half_y),
            (from[2], ray[2], self.bottom_mm, top_mm),
        ]
        .into_iter()
        .enumerate()
        {
            let [a, b] = [(low - start) / step, (high - start) / step];
            if a.min(b) > near {
                near = a.min(b);
                is_top = axis == 2;
            }
            far = far.min(a.max(b));
        }
        if near > far {
            return None;
        }
        let color = if is_top {
            self.top([x + dx * near, y + dy * near])
        } else {
            self.color.map(|part| part * 0.6)
        };
        Some((near, color))
    }

    fn top(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let Some(marker) = self.marker.and_then(Marker::numbered) else {
            return self.color;
        };
        // X points up on the marker, Y to its left.
        let cell = MARKER_MM / 6.0;
        let [down, right] = [MARKER_MM / 2.0 - x, MARKER_MM / 2.0 - y];
        let is_on = (0.0..MARKER_MM).contains(&down) && (0.0..MARKER_MM).contains(&right);
        if is_on && !marker.is_white((down / cell) as u16, (right / cell) as u16) {
            BLACK
        } else if x.abs().max(y.abs()) < LABEL_MM / 2.0 {
            WHITE
        } else {
            self.color
        }
    }
}

/// The boxes of a world that its arm does not hold.
pub(crate) fn objects_of(world: &Value) -> Option<Vec<Object>> {
    let held = world["held"].as_array()?;
    let objects = world["objects"].as_array()?;
    let free = objects.iter().filter(|it| !held.contains(&it["name"]));
    free.map(box_of).collect()
}

fn box_of(object: &Value) -> Option<Object> {
    let pair = |of: &Value| Some([of[0].as_f64()?, of[1].as_f64()?]);
    let size_mm = &object["shape"]["size_mm"];
    let marker = object["name"].as_str()?.strip_prefix("marker ");
    let color = u32::from_str_radix(object["color"].as_str()?.strip_prefix('#')?, 16).ok()?;
    let [_, red, green, blue] = color.to_be_bytes();
    Some(Object {
        marker: marker.and_then(|number| number.parse().ok()),
        at: pair(&object["at_mm"])?,
        turn_deg: object["turn_deg"].as_f64()?,
        bottom_mm: object["bottom_mm"].as_f64()?,
        height_mm: size_mm[2].as_f64()?,
        sides_mm: pair(size_mm)?,
        color: [red, green, blue].map(|part| f64::from(part) / 255.0),
    })
}

impl Scene {
    /// A red block that does not touch the first object.
    pub(crate) fn apart(&self, random: &mut Random) -> Object {
        loop {
            let other = Object::random(0, random);
            let [first] = &self.objects[..] else {
                return other;
            };
            if (other.at[0] - first.at[0]).hypot(other.at[1] - first.at[1]) > 60.0 {
                return Object {
                    marker: None,
                    color: RED,
                    height_mm: 1.0,
                    ..other
                };
            }
        }
    }

    /// What a ray from the camera meets.
    pub(crate) fn seen(&self, from: [f64; 3], ray: [f64; 3]) -> [f64; 3] {
        let met = self
            .objects
            .iter()
            .filter_map(|object| object.seen(from, ray));
        let nearest = met.min_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((_, color)) = nearest {
            return color;
        }
        let far = -from[2] / ray[2];
        self.ground([from[0] + far * ray[0], from[1] + far * ray[1]])
    }

    fn ground(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        if self.is_covered && y > 70.0 {
            return SKIN;
        }
        let from_sheet = [x, y];
        let on_sheet = [x - self.sheet_at[0], y - self.sheet_at[1]];
        let [x, y] = on_sheet;
        if !(95.0..305.0).contains(&x) || y.abs() > 148.5 {
            return wood(from_sheet);
        }
        if is_black(on_sheet)
            || self
                .crosses
                .iter()
                .any(|at| is_cross([x - at[0], y - at[1]]))
        {
            BLACK
        } else {
            WHITE
        }
    }
}

/// The table: a camera that moves sees its grain move.
fn wood([x, y]: [f64; 2]) -> [f64; 3] {
    let grain = (y / 7.0 + (x / 40.0).sin() * 2.0).sin() * 0.25 + ((x + y) / 23.0).sin() * 0.2;
    TABLE.map(|part| part * (1.0 + grain))
}

/// Whether the print is black: its markers and the circles and crosses of its points.
fn is_black([x, y]: [f64; 2]) -> bool {
    for (marker, corners) in sheet_markers() {
        let side = corners[0][0] - corners[3][0];
        let [down, right] = [corners[0][0] - x, corners[0][1] - y];
        if (0.0..side).contains(&down) && (0.0..side).contains(&right) {
            return !marker.is_white((down / side * 6.0) as u16, (right / side * 6.0) as u16);
        }
    }
    SHEET_POINTS.iter().any(|point| {
        let [dx, dy] = [x - point[0], y - point[1]];
        let thin = 0.075;
        (dx.abs() < thin && dy.abs() < 6.0)
            || (dy.abs() < thin && dx.abs() < 6.0)
            || (dx.hypot(dy) - 3.0).abs() < thin
    })
}

/// A drawn cross, at 45 degrees to those of the print.
fn is_cross([dx, dy]: [f64; 2]) -> bool {
    let [a, b] = [(dx + dy).abs(), (dx - dy).abs()].map(|mm| mm / 2_f64.sqrt());
    a.min(b) < PEN_MM / 2.0 && a.max(b) < CROSS_MM / 2.0
}

const WHITE: [f64; 3] = [0.93, 0.93, 0.9];
const BLACK: [f64; 3] = [0.06, 0.06, 0.07];
const TABLE: [f64; 3] = [0.45, 0.36, 0.27];
const SKIN: [f64; 3] = [0.75, 0.55, 0.45];
const RED: [f64; 3] = [0.8, 0.1, 0.08];
/// The side of an object's marker.
const MARKER_MM: f64 = 20.0;
/// The side of the white paper around it.
const LABEL_MM: f64 = 26.0;
/// The line of a pen.
const PEN_MM: f64 = 0.6;
/// The length of a line of a cross.
const CROSS_MM: f64 = 8.0;
