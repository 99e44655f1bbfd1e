//! Where recordings are kept unless told otherwise.

use std::path::PathBuf;

use directories::ProjectDirs;

/// The folder of the station's recordings, in the place that the system has for a program's data;
/// `None` where there is no such place, as for a user without a home.
#[must_use]
pub fn default_folder() -> Option<PathBuf> {
    let places = ProjectDirs::from("", "", "dobot")?;
    Some(places.data_local_dir().join("recordings"))
}
