//! `bench`: the JavaScript benchmarks against their peers, then the native ones.

use crate::{build, shell};
use anyhow::Result;

/// Further arguments go to benches/js/run.js.
pub(crate) fn bench(args: &[String]) -> Result<()> {
    build::build()?;
    if shell::root().join("benches/js/run.js").exists() {
        shell::run(shell::node(&["benches/js/run.js"]).args(args))?;
    } else {
        println!("benches/js/run.js does not exist yet");
    }
    shell::run(&mut shell::cargo(&[
        "bench",
        "--package",
        "casteljau",
        "--benches",
    ]))
}
