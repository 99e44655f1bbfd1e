//! The camera, its lens and its sensor.

use dobot_geometry::Random;

use crate::scene::Scene;

/// A camera above the sheet, in mm.
pub(crate) struct Camera {
    size: [usize; 2],
    at: [f64; 3],
    /// Right, down and ahead in the picture.
    axes: [[f64; 3]; 3],
    focal_px: f64,
    /// The radial distortion at a distance of one focal length from the middle.
    distortion: f64,
}

impl Camera {
    /// Tilted by 15 to 45 degrees, 38 to 48 cm away, from any side behind which the arm is not.
    pub(crate) fn random(size: [usize; 2], random: &mut Random) -> Self {
        let tilt = (15.0 + 30.0 * random.share()).to_radians();
        // Seen from the far side of the sheet, up to 40 degrees to either side, or from behind the arm.
        let side = (80.0 * random.share() - 40.0).to_radians();
        let away = 380.0 + 100.0 * random.share();
        let flip = if random.chance(50.0) { 1.0 } else { -1.0 };
        let ahead = [
            -flip * tilt.sin() * side.cos(),
            -tilt.sin() * side.sin(),
            -tilt.cos(),
        ];
        let target = [
            MIDDLE[0] + 8.0 * random.share(),
            MIDDLE[1] + 8.0 * random.share(),
            0.0,
        ];
        let at = [0, 1, 2].map(|i| target[i] - away * ahead[i]);
        // Level at first, then turned a little.
        let right = normal(cross(ahead, [0.0, 0.0, 1.0]));
        let down = cross(ahead, right);
        let turn = (16.0 * random.share() - 8.0).to_radians();
        let turned = |a: [f64; 3], b: [f64; 3], sign: f64| {
            [0, 1, 2].map(|i| a[i] * turn.cos() + sign * b[i] * turn.sin())
        };
        // Wide enough for the sheet.
        let focal_px = size[0] as f64 * (0.86 + 0.08 * random.share()) * away / 430.0;
        Self {
            size,
            at,
            axes: [turned(right, down, 1.0), turned(down, right, -1.0), ahead],
            focal_px: focal_px * (size[1] as f64 / size[0] as f64 / 0.75).min(1.0),
            distortion: -0.05 - 0.03 * random.share(),
        }
    }

    /// The direction of the ray through a place in the picture.
    fn ray(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let [wide, high] = self.size.map(|px| px as f64);
        let seen = [
            (x - wide / 2.0) / self.focal_px,
            (y - high / 2.0) / self.focal_px,
        ];
        // Undistorted, by iteration.
        let mut straight = seen;
        for _ in 0..6 {
            let r2 = straight[0].powi(2) + straight[1].powi(2);
            straight = seen.map(|number| number / (1.0 + self.distortion * r2));
        }
        let [right, down, ahead] = self.axes;
        normal([0, 1, 2].map(|i| straight[0] * right[i] + straight[1] * down[i] + ahead[i]))
    }
}

/// Light and sensor.
pub(crate) struct Film {
    pub(crate) seed: u64,
    pub(crate) blur_px: f64,
    pub(crate) glare: bool,
    light: f64,
    noise: f64,
}

impl Film {
    pub(crate) fn random(random: &mut Random) -> Self {
        Self {
            seed: random.number(),
            blur_px: 0.5 + 0.4 * random.share(),
            glare: false,
            light: 0.6 + 0.4 * random.share(),
            noise: 2.0 + 2.0 * random.share(),
        }
    }

    /// Returns the pixels, red, green and blue.
    pub(crate) fn develop(&self, camera: &Camera, scene: &Scene) -> Vec<u8> {
        let [wide, high] = camera.size;
        let mut light = vec![[0.0_f64; 3]; wide * high];
        for (index, pixel) in light.iter_mut().enumerate() {
            let (x, y) = ((index % wide) as f64, (index / wide) as f64);
            for ray in 0..RAYS * RAYS {
                let sub = [ray % RAYS, ray / RAYS].map(|part| (part as f64 + 0.5) / RAYS as f64);
                let at = [x + sub[0], y + sub[1]];
                let seen = scene.seen(camera.at, camera.ray(at));
                let glare = if self.glare {
                    glare_at(at, [wide as f64, high as f64])
                } else {
                    0.0
                };
                for (sum, part) in pixel.iter_mut().zip(seen) {
                    *sum += (part * self.light + glare) / (RAYS * RAYS) as f64;
                }
            }
        }
        blur(&mut light, wide, self.blur_px);
        let mut random = Random::new(self.seed);
        let mut noisy = |part: f64| {
            // Nearly normal.
            let grain: f64 = (0..4).map(|_| random.share() - 0.5).sum::<f64>() * 1.73;
            (part * 255.0 + self.noise * grain)
                .round()
                .clamp(0.0, 255.0) as u8
        };
        light
            .iter()
            .flat_map(|pixel| pixel.map(&mut noisy))
            .collect()
    }
}

/// A lamp's reflection: a bright disc that covers a corner and fades out.
fn glare_at([x, y]: [f64; 2], [wide, high]: [f64; 2]) -> f64 {
    let away = ((x - wide * 0.3) / wide).hypot((y - high * 0.3) / wide);
    (1.6 - away * 6.0).clamp(0.0, 1.0)
}

/// Blurs by a normal distribution, along both axes in turn.
fn blur(light: &mut [[f64; 3]], wide: usize, deviation_px: f64) {
    let reach = (deviation_px * 3.0).ceil() as isize;
    let weight = |away: isize| (-(away as f64 / deviation_px).powi(2) / 2.0).exp();
    let whole: f64 = (-reach..=reach).map(weight).sum();
    let high = light.len() / wide;
    for [step_x, step_y] in [[1, 0], [0, 1]] {
        let sharp = light.to_vec();
        for (index, pixel) in light.iter_mut().enumerate() {
            *pixel = [0.0; 3];
            for away in -reach..=reach {
                let x = ((index % wide) as isize + step_x * away).clamp(0, wide as isize - 1);
                let y = ((index / wide) as isize + step_y * away).clamp(0, high as isize - 1);
                let from = sharp[y as usize * wide + x as usize];
                for (sum, part) in pixel.iter_mut().zip(from) {
                    *sum += part * weight(away) / whole;
                }
            }
        }
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn normal(a: [f64; 3]) -> [f64; 3] {
    let length = a.iter().map(|part| part * part).sum::<f64>().sqrt();
    a.map(|part| part / length)
}

/// The middle of the sheet.
const MIDDLE: [f64; 2] = [196.0, -4.0];
/// The rays of a pixel along each axis.
const RAYS: usize = 2;
