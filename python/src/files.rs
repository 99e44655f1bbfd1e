//! The files that a station stores, and the audio that its pages send.

use std::future::Future;

use dobot_api::{ConnectError, StationAddress, StationSearch, delete, fetch, fetch_bytes, post};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use serde_json::{Value, json};
use tokio::runtime;

use crate::failure::{Failure, exception, lost};
use crate::place::{ConnectOptions, place};
use crate::worker::Where;

/// The files that a station stores.
#[pyclass(frozen)]
pub(crate) struct Files {
    search: StationSearch,
}

#[pymethods]
impl Files {
    #[new]
    fn new(at: &str, options: ConnectOptions) -> PyResult<Self> {
        let search = station(at, options)?;
        Ok(Self { search })
    }

    /// Returns all files as JSON.
    fn list(&self, py: Python<'_>) -> PyResult<String> {
        let files = ask(&self.search, py, async |station| {
            fetch::<Value>(&station, FILES).await
        })?;
        Ok(files.to_string())
    }

    /// Stores a file; returns it as JSON.
    fn put(&self, py: Python<'_>, name: &str, content: &str, existing: &str) -> PyResult<String> {
        let new = json!({"name": name, "content": content, "existing": existing});
        let stored = ask(&self.search, py, async |station| {
            post::<Value>(&station, FILES, &new).await
        })?;
        Ok(stored.to_string())
    }

    /// Returns the content of a file.
    fn get(&self, py: Python<'_>, number: u64) -> PyResult<Vec<u8>> {
        let path = format!("{FILES}/{number}/content");
        ask(&self.search, py, async |station| {
            fetch_bytes(&station, &path).await
        })
    }

    /// Deletes a file.
    fn remove(&self, py: Python<'_>, number: u64) -> PyResult<()> {
        let path = format!("{FILES}/{number}");
        ask(&self.search, py, async |station| {
            delete::<()>(&station, &path).await
        })
    }
}

/// The audio that pages of a station send to a listener.
#[pyclass(frozen)]
pub(crate) struct TalkAudio {
    search: StationSearch,
}

#[pymethods]
impl TalkAudio {
    #[new]
    fn new(at: &str, options: ConnectOptions) -> PyResult<Self> {
        let search = station(at, options)?;
        Ok(Self { search })
    }

    /// Returns what has arrived since the last call as JSON; waits up to a second.
    fn fetch(&self, py: Python<'_>) -> PyResult<String> {
        const AUDIO: &str = "/api/v1/talk/audio";
        let pieces = ask(&self.search, py, async |station| {
            fetch::<Value>(&station, AUDIO).await
        })?;
        Ok(pieces.to_string())
    }
}

fn station(at: &str, options: ConnectOptions) -> PyResult<StationSearch> {
    match place(at, options)? {
        Where::Station(search) => Ok(search),
        _ => Err(PyValueError::new_err(format!(
            "there is no station at `{at}`; allowed are station and http://HOST:PORT"
        ))),
    }
}

/// Sends a request to the station, in the calling thread.
fn ask<T: Send, F: Future<Output = Result<T, ConnectError>>>(
    search: &StationSearch,
    py: Python<'_>,
    request: impl FnOnce(StationAddress) -> F + Send,
) -> PyResult<T> {
    let search = search.clone();
    let asked = py.detach(move || {
        let runtime = runtime::Builder::new_current_thread().enable_all().build();
        let runtime = runtime.map_err(|error| lost(&error, None))?;
        runtime.block_on(async {
            let found = search.find().await.map_err(|error| lost(&error, None))?;
            let station = found.ok_or_else(|| Failure::LinkLost {
                text: "no station runs on this machine".to_owned(),
                hint: Some("start one with `dobot up`".to_owned()),
            })?;
            Ok(request(station).await?)
        })
    });
    asked.map_err(|failure: Failure| exception(py, &failure))
}

const FILES: &str = "/api/v1/files";
