//! `cargo run -p dobot-calibrate --example photos -- target/photos look 3`
//!
//! Renders photos of a calibration sheet with objects or with the crosses that an arm drew, as a
//! camera sees them: tilted, distorted, blurred, noisy. Each photo is a PPM file, beside a JSON file
//! with what is true. The same arguments give the same photos. The tests of the page and of the
//! Python package use them. The set `world` shows the objects of a virtual arm's world, whose state
//! (`GET /api/v1/world`) is read from stdin; objects named `marker 7` carry that marker.

#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "pixels and colours are small numbers"
)]

#[path = "../../tests/it/arms.rs"]
#[expect(dead_code, reason = "of the module only the arms are used")]
mod arms;
mod camera;
mod scene;

use std::error::Error;
use std::path::Path;
use std::{fs, io};

use dobot_geometry::Random;
use serde_json::{Value, json};

use self::camera::{Camera, Film};
use self::scene::{Object, Scene};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments
        .next()
        .unwrap_or_else(|| "target/photos".to_owned());
    let set = arguments.next().unwrap_or_else(|| "look".to_owned());
    let count: u64 = arguments.next().map_or(Ok(3), |count| count.parse())?;
    let (wide, high) = match arguments.next() {
        Some(size) => {
            let (wide, high) = size.split_once('x').ok_or("the size is WIDTHxHEIGHT")?;
            (wide.parse()?, high.parse()?)
        }
        None => (640, 480),
    };
    fs::create_dir_all(&folder)?;
    for seed in 0..count {
        let (pixels, truth) = photo(&set, seed, [wide, high])?;
        let name = Path::new(&folder).join(format!("{set}-{seed:03}"));
        let mut file = format!("P6\n{wide} {high}\n255\n").into_bytes();
        file.extend(pixels);
        fs::write(name.with_extension("ppm"), file)?;
        fs::write(name.with_extension("json"), truth.to_string())?;
    }
    println!("{folder}: {count} photos");
    Ok(())
}

/// A photo and what is true.
fn photo(set: &str, seed: u64, size: [usize; 2]) -> Result<(Vec<u8>, Value), Box<dyn Error>> {
    let mut random = Random::sequence(49, seed);
    let mut camera = Camera::random(size, &mut random);
    let mut film = Film::random(&mut random);
    let mut scene = Scene::default();
    let markers = dobot_calibrate::sheet_markers().map(|(_, corners)| corners);
    let mut truth = json!({ "sheet": markers });
    match set {
        // One object with a marker, and a block without one.
        "look" => {
            scene.objects = vec![Object::random(7, &mut random)];
            scene.objects.push(scene.apart(&mut random));
        }
        "blurred" => film.blur_px = 4.0 * size[0] as f64 / 640.0,
        "glare" => film.glare = true,
        // A hand covers two of the corners.
        "covered" => scene.is_covered = true,
        // The crosses of an arm without errors.
        "drawn" => {
            let place = |n: u8| [f64::from(n / 5).mul_add(30.0, 140.0), f64::from(n % 5).mul_add(45.0, -90.0)];
            scene.crosses = (0..25).map(place).collect();
        }
        // The crosses of an arm with errors.
        "crosses" => {
            let (crosses, checks) = arms::crosses(seed);
            scene.crosses = crosses.iter().map(|cross| cross.0).collect();
            truth["crosses"] = crosses
                .iter()
                .map(|(at, raw)| json!({"at_mm": at, "raw_deg": raw}))
                .collect();
            truth["checks"] = checks
                .iter()
                .map(|(raw, at)| json!({"raw_mm": raw, "at_mm": at}))
                .collect();
        }
        "world" => {
            (camera, film) = standing(size, seed);
            let world: Value = serde_json::from_reader(io::stdin())?;
            scene.objects = scene::objects_of(&world).ok_or("stdin is not the state of a world")?;
        }
        // A camera that stands still, and the same cube each time: the number of the photo is that of
        // a frame. In the second set the sheet lies 8 mm ahead and 5 mm to the left.
        "still" | "shifted" => {
            (camera, film) = standing(size, seed);
            scene.objects = vec![Object::cube(7, [215.0, 60.0], 30.0)];
            if set == "shifted" {
                scene.sheet_at = [8.0, 5.0];
            }
        }
        _ => return Err(format!(
            "the set is {set:?}; allowed: look, blurred, glare, covered, crosses, drawn, still, shifted, world"
        )
        .into()),
    }
    truth["objects"] = scene.objects.iter().map(Object::json).collect();
    Ok((film.develop(&camera, &scene), truth))
}

/// A camera that stands still.
fn standing(size: [usize; 2], seed: u64) -> (Camera, Film) {
    let mut random = Random::sequence(49, 7);
    let camera = Camera::random(size, &mut random);
    let mut film = Film::random(&mut random);
    film.seed = seed;
    (camera, film)
}
