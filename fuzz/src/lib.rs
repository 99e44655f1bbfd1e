//! What the fuzz targets do with an input. `cargo test` tries their seeds and some damaged ones; `./ci.sh fuzz` builds
//! them with coverage instrumentation and searches on from there.
//!
//! A seed is a file in `seeds/TARGET`. Most targets take a text as it is where its first byte is even, such as the
//! space that those seeds begin with, and else as a list of words of the format.

#![expect(
    clippy::missing_panics_doc,
    reason = "a panic is what a target looks for"
)]

mod artwork;
mod controller;
mod dxf;
mod files;
mod firmware_1_1;
mod gcode;
mod hpgl;
mod lightburn;
mod mcap;
mod pictures;
mod points;
mod policy;
mod programs;
mod requests;
mod specification;
mod svg;
mod texts;
mod vendor_files;
mod words;

pub use dxf::dxf;
pub use files::files;
pub use firmware_1_1::firmware_1_1;
pub use gcode::gcode;
pub use hpgl::hpgl;
pub use lightburn::lightburn;
pub use mcap::mcap;
pub use pictures::pictures;
pub use points::points;
pub use policy::policy;
pub use programs::programs;
pub use requests::requests;
pub use specification::specification;
pub use svg::svg;
pub use texts::texts;
pub use vendor_files::vendor_files;

use artwork::{file, lies_on, read};
use controller::drive;
use words::spelled;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use std::fs;
    use std::path::PathBuf;

    use dobot_geometry::Random;

    macro_rules! tests {
        ($($target:ident)*) => {
            const TARGETS: &[&str] = &[$(stringify!($target)),*];

            $(
                #[test]
                fn $target() {
                    try_inputs(stringify!($target), super::$target);
                }
            )*
        };
    }

    tests! {
        dxf
        files
        firmware_1_1
        gcode
        hpgl
        lightburn
        mcap
        pictures
        points
        policy
        programs
        requests
        specification
        svg
        texts
        vendor_files
    }

    #[test]
    fn each_folder_of_seeds_belongs_to_a_target() {
        let folders = fs::read_dir(seeds()).unwrap();
        let folders = folders.map(|folder| folder.unwrap().file_name().into_string().unwrap());
        let mut folders: Vec<String> = folders.collect();
        folders.sort();
        assert_eq!(folders, TARGETS);
    }

    /// The seeds of a target, then damaged ones, then bytes at random: always the same. A failing test shows the input.
    fn try_inputs(name: &str, target: fn(&[u8])) {
        let files = fs::read_dir(seeds().join(name)).unwrap();
        let mut files: Vec<PathBuf> = files.map(|file| file.unwrap().path()).collect();
        files.sort();
        assert!(!files.is_empty(), "{name} has no seeds");
        let mut seeds = Vec::new();
        for file in files {
            println!("{}", file.display());
            let seed = fs::read(file).unwrap();
            target(&seed);
            seeds.push(seed);
        }
        let mut random = Random::new(1);
        for number in 0..INPUTS {
            let input = if number % 2 == 0 {
                damaged(&seeds[below(&mut random, seeds.len())], &mut random)
            } else {
                bytes(&mut random, LONGEST)
            };
            println!("{input:?}");
            target(&input);
        }
    }

    /// An input with some bytes changed, and some left out or put in.
    fn damaged(seed: &[u8], random: &mut Random) -> Vec<u8> {
        let mut input = seed.to_vec();
        for _ in 0..=random.below(8) {
            let start = below(random, input.len() + 1);
            let end = (start + below(random, 9)).min(input.len());
            let new = bytes(random, 8);
            input.splice(start..end, new);
        }
        input
    }

    fn bytes(random: &mut Random, longest: usize) -> Vec<u8> {
        let count = below(random, longest + 1);
        (0..count)
            .map(|_| random.number().to_le_bytes()[0])
            .collect()
    }

    fn below(random: &mut Random, count: usize) -> usize {
        random.below(u32::try_from(count).unwrap()) as usize
    }

    fn seeds() -> PathBuf {
        PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("seeds")
    }

    const INPUTS: usize = 400;
    /// In bytes.
    const LONGEST: usize = 200;
}
