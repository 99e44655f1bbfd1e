//! `cargo run -p dobot-examples --example sample_photo -- target/still-life.jpg`
//!
//! Renders the photo of examples/drawings: a sphere, a cone and a cube on a table, lit by a window
//! on the left. Rays are traced from the camera to objects, and from there to window and room.

use std::error::Error;
use std::f64::consts::TAU;
use std::ops::{Add, Mul, Sub};

use jpeg_encoder::{ColorType, Encoder};

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1);
    let path = path.unwrap_or_else(|| "target/still-life.jpg".to_owned());
    let mut random = Random(7);
    let places = (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y)));
    let pixels: Vec<u8> = places.map(|(x, y)| pixel(x, y, &mut random)).collect();
    Encoder::new_file(&path, QUALITY)?.encode(&pixels, WIDTH, HEIGHT, ColorType::Luma)?;
    println!("{path}");
    Ok(())
}

/// A pixel as on film: bright light saturates, the corners are slightly darker, and there is some
/// grain.
fn pixel(x: u16, y: u16, random: &mut Random) -> u8 {
    let mut light = 0.0;
    for _ in 0..RAYS {
        let [x, y] = [f64::from(x), f64::from(y)].map(|mm| mm + random.share());
        let [right, up] = [x - f64::from(WIDTH) / 2.0, f64::from(HEIGHT) / 2.0 - y];
        light += seen(CAMERA, towards(right, up), random, 1) / f64::from(RAYS);
    }
    let corner = (f64::from(x) / f64::from(WIDTH) - 0.5).powi(2)
        + (f64::from(y) / f64::from(HEIGHT) - 0.5).powi(2);
    let toned = 1.0 - (-EXPOSURE * light * (1.0 - 0.35 * corner)).exp();
    let film = toned.powf(1.0 / 2.2);
    let film = film * film * (3.0 - 2.0 * film);
    let grain = GRAIN * (random.share() + random.share() - 1.0);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped"
    )]
    let value = (255.0 * film + grain).clamp(0.0, 255.0) as u8;
    value
}

fn towards(right: f64, up: f64) -> V {
    let forward = (AIM - CAMERA).unit();
    let side = forward.cross(V(0.0, 0.0, 1.0)).unit();
    let top = side.cross(forward);
    (forward * (1.72 * f64::from(WIDTH)) + side * right + top * up).unit()
}

/// Returns the light that reaches a point from a direction.
fn seen(from: V, way: V, random: &mut Random, bounces: u32) -> f64 {
    let Some(hit) = hit(from, way) else {
        return ROOM * (0.6 + 0.4 * way.2);
    };
    let place = from + way * hit.far + hit.normal * 1e-6;
    let window = from_window(place, hit.normal, random);
    let around = if bounces == 0 {
        0.35 * ROOM
    } else {
        // Directions are sampled by their contribution.
        let way = (hit.normal + random.direction()).unit();
        seen(place, way, random, bounces - 1)
    };
    hit.white * (window + around)
}

fn from_window(place: V, normal: V, random: &mut Random) -> f64 {
    let [right, up] = [random.share() - 0.5, random.share() - 0.5];
    let pane = WINDOW + V(0.6, -0.8, 0.0) * (WINDOW_WIDE * right) + V(0.0, 0.0, WINDOW_HIGH * up);
    let (way, far) = ((pane - place).unit(), (pane - place).length());
    if normal.dot(way) <= 0.0 || hit(place, way).is_some_and(|hit| hit.far < far) {
        return 0.0;
    }
    normal.dot(way) * BRIGHT / (far * far)
}

struct Hit {
    far: f64,
    normal: V,
    /// The reflected share of the light.
    white: f64,
}

/// Returns the first object that a ray meets.
fn hit(from: V, way: V) -> Option<Hit> {
    let hits = [
        plane(from.2, way.2, V(0.0, 0.0, 1.0), 0.62),
        wall(from, way),
        sphere(from - SPHERE, way),
        cone(from - CONE, way),
        cube(from - CUBE, way),
    ];
    let ahead = hits.into_iter().flatten().filter(|hit| hit.far > 1e-5);
    ahead.min_by(|a, b| a.far.total_cmp(&b.far))
}

fn plane(above: f64, rise: f64, normal: V, white: f64) -> Option<Hit> {
    let far = -above / rise;
    (rise.abs() > 1e-9).then_some(Hit { far, normal, white })
}

/// A graded backdrop, as in photography: dark behind light objects, light behind dark ones.
fn wall(from: V, way: V) -> Option<Hit> {
    let hit = plane(WALL - from.1, -way.1, V(0.0, -1.0, 0.0), 1.0)?;
    let across = (from.0 + way.0 * hit.far) / 7.5 + 0.55;
    let across = across.clamp(0.0, 1.0);
    let white = 0.22 + 0.7 * across * across * (3.0 - 2.0 * across);
    Some(Hit { white, ..hit })
}

fn sphere(from: V, way: V) -> Option<Hit> {
    let far = first_root(
        1.0,
        from.dot(way),
        from.dot(from) - SPHERE_RADIUS.powi(2),
        |_| true,
    )?;
    let normal = (from + way * far).unit();
    Some(Hit {
        far,
        normal,
        white: 0.86,
    })
}

/// A cone with its tip at the origin.
fn cone(from: V, way: V) -> Option<Hit> {
    let slope2 = (CONE_RADIUS / CONE.2).powi(2);
    let flat = |a: V, b: V| a.0 * b.0 + a.1 * b.1 - slope2 * a.2 * b.2;
    let on_it = |far: f64| (-CONE.2..=0.0).contains(&(from.2 + way.2 * far));
    let far = first_root(flat(way, way), flat(from, way), flat(from, from), on_it)?;
    let at = from + way * far;
    let normal = V(at.0, at.1, -slope2 * at.2).unit();
    Some(Hit {
        far,
        normal,
        white: 0.8,
    })
}

/// Returns the smallest positive root of a t^2 + 2 b t + c that satisfies `wanted`.
fn first_root(a: f64, b: f64, c: f64, wanted: impl Fn(f64) -> bool) -> Option<f64> {
    let root = (b * b - a * c).sqrt();
    let mut roots = [(-b - root) / a, (-b + root) / a];
    roots.sort_by(f64::total_cmp);
    roots.into_iter().find(|&far| far > 1e-5 && wanted(far))
}

/// A cube around the origin, rotated about the vertical.
fn cube(from: V, way: V) -> Option<Hit> {
    let (sin, cos) = CUBE_TURN.sin_cos();
    let turned = |v: V| V(v.0 * cos + v.1 * sin, v.1 * cos - v.0 * sin, v.2);
    let back = |v: V| V(v.0 * cos - v.1 * sin, v.0 * sin + v.1 * cos, v.2);
    let (from, way) = (turned(from), turned(way));
    let (mut near, mut far, mut normal) = (f64::NEG_INFINITY, f64::INFINITY, V(0.0, 0.0, 0.0));
    let sides = [V(1.0, 0.0, 0.0), V(0.0, 1.0, 0.0), V(0.0, 0.0, 1.0)];
    for side in sides {
        let (at, along) = (side.dot(from), side.dot(way));
        let [a, b] = [(-CUBE.2 - at) / along, (CUBE.2 - at) / along];
        if a.min(b) > near {
            (near, normal) = (a.min(b), side * -along.signum());
        }
        far = far.min(a.max(b));
    }
    let normal = back(normal);
    (near < far).then_some(Hit {
        far: near,
        normal,
        white: 0.83,
    })
}

#[derive(Clone, Copy)]
struct V(f64, f64, f64);

impl V {
    fn dot(self, other: Self) -> f64 {
        self.0 * other.0 + self.1 * other.1 + self.2 * other.2
    }

    fn cross(self, other: Self) -> Self {
        Self(
            self.1 * other.2 - self.2 * other.1,
            self.2 * other.0 - self.0 * other.2,
            self.0 * other.1 - self.1 * other.0,
        )
    }

    fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    fn unit(self) -> Self {
        self * (1.0 / self.length())
    }
}

impl Add for V {
    type Output = Self;
    fn add(self, by: Self) -> Self {
        Self(self.0 + by.0, self.1 + by.1, self.2 + by.2)
    }
}

impl Sub for V {
    type Output = Self;
    fn sub(self, by: Self) -> Self {
        self + by * -1.0
    }
}

impl Mul<f64> for V {
    type Output = Self;
    fn mul(self, by: f64) -> Self {
        Self(self.0 * by, self.1 * by, self.2 * by)
    }
}

struct Random(u64);

impl Random {
    /// A random number from 0 to below 1.
    fn share(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let high = u32::try_from(self.0 >> 40).expect("24 bits");
        f64::from(high) / f64::from(1 << 24)
    }

    fn direction(&mut self) -> V {
        let (sin, cos) = (TAU * self.share()).sin_cos();
        let up = 2.0 * self.share() - 1.0;
        let flat = (1.0 - up * up).sqrt();
        V(flat * cos, flat * sin, up)
    }
}

const WIDTH: u16 = 720;
const HEIGHT: u16 = 480;
const QUALITY: u8 = 82;
const RAYS: u32 = 64;
const EXPOSURE: f64 = 1.5;
/// In steps of 255.
const GRAIN: f64 = 5.0;

const CAMERA: V = V(0.3, -11.0, 3.9);
const AIM: V = V(0.2, 0.0, 1.2);
/// The centre of the window, its light, and its width and height.
const WINDOW: V = V(-6.0, -4.5, 6.0);
const BRIGHT: f64 = 78.0;
const WINDOW_WIDE: f64 = 1.8;
const WINDOW_HIGH: f64 = 2.2;
/// The ambient light of the room.
const ROOM: f64 = 0.15;
/// The distance of the wall behind the objects.
const WALL: f64 = 4.5;

const SPHERE: V = V(-1.35, -0.9, 0.95);
const SPHERE_RADIUS: f64 = 0.95;
/// The tip.
const CONE: V = V(0.3, 1.1, 2.8);
const CONE_RADIUS: f64 = 0.95;
/// Half of its side is its height above the table.
const CUBE: V = V(1.75, -0.75, 0.68);
const CUBE_TURN: f64 = 0.55;
