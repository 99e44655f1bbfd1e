//! `cargo run -p dobot-examples --example pictures` updates the pictures of `docs/kinematics.md`.
//!
//! Everything in them is computed by `dobot-arm` and `dobot-motion`: a picture that looks wrong
//! shows a wrong formula.

mod arm_views;
mod canvas;
mod motion_views;
mod workspace;

use std::fs;
use std::path::Path;

fn main() -> std::io::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/pictures");
    fs::create_dir_all(&folder)?;
    let pictures = [
        ("side-view.svg", arm_views::side()),
        ("top-view.svg", arm_views::top()),
        ("workspace.svg", workspace::cross_section()),
        ("speed-profile.svg", motion_views::profiles()),
        ("jump.svg", motion_views::jump()),
        ("ways-to-move.svg", motion_views::ways()),
    ];
    for (name, picture) in pictures {
        fs::write(folder.join(name), picture)?;
        println!("docs/pictures/{name}");
    }
    Ok(())
}
