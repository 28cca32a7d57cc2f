//! `serve`: builds everything and serves the site on localhost.

use crate::{build, shell};
use anyhow::Result;

/// Runs until it is stopped; further arguments go to Vite (`--port 8080`).
pub(crate) fn serve(args: &[String]) -> Result<()> {
    build::build()?;
    let vite = [
        "node_modules/vite/bin/vite.js",
        "--config",
        "www/vite.config.js",
    ];
    shell::run(shell::node(&vite).args(args))
}
