//! `serve`: builds everything and serves the site on localhost.

use crate::{build, shell};
use anyhow::Result;

/// Runs until stopped; further arguments are passed to Vite (`--port 8080`).
pub(crate) fn serve(args: &[String]) -> Result<()> {
    build::build()?;
    let mut vite = shell::node(&[
        "node_modules/vite/bin/vite.js",
        "--config",
        "www/vite.config.js",
    ]);
    become_it(vite.args(args))
}

/// On Unix the server replaces the process of the driver, so that stopping the driver stops the server.
#[cfg(unix)]
fn become_it(server: &mut std::process::Command) -> Result<()> {
    use std::os::unix::process::CommandExt;
    Err(server.exec().into())
}

#[cfg(not(unix))]
fn become_it(server: &mut std::process::Command) -> Result<()> {
    shell::run(server)
}
