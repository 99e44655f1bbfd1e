//! Features of shared libraries; see `Cargo.toml`.
