//! `bench`: the native benchmarks, then the JavaScript ones against their peers, and one table of both.

use crate::{build, shell};
use anyhow::Result;

/// Further arguments go to both halves, which understand `--quick` and a part of a row's name.
pub(crate) fn bench(args: &[String]) -> Result<()> {
    build::build()?;
    let native = ["bench", "--package", "casteljau-benches", "--benches", "--"];
    shell::run(shell::cargo(&native).args(args))?;
    // Last, because its table takes up what the native half has found.
    shell::run(shell::node(&["benches/js/run.js"]).args(args))
}
