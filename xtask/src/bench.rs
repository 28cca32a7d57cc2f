//! `bench`: runs the native benchmarks and the JavaScript ones against peer libraries, and prints one table of both.

use crate::{build, shell};
use anyhow::Result;

/// Further arguments are passed to both; they accept `--quick` and a substring of a row's name.
pub(crate) fn bench(args: &[String]) -> Result<()> {
    build::build()?;
    let native = ["bench", "--package", "casteljau-benches", "--benches", "--"];
    shell::run(shell::cargo(&native).args(args))?;
    // The JavaScript benchmarks run last, because their table includes the native results.
    shell::run(shell::node(&["benches/js/run.js"]).args(args))
}
