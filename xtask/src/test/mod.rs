//! `test` and `test-deep`: all steps or some, each on its own, with a summary that names what failed and was skipped.

mod args;
mod beside;
mod deep;
mod node;
mod runner;
mod select;
mod step;
mod steps;
mod summary;

use crate::setup;
use anyhow::Result;
use args::{Request, StepName};
pub(crate) use beside::RUN_STEP;
pub(crate) use select::{binaries, mentions, test_targets};
pub(crate) use step::Done;
use step::{Command, Step};

/// All steps in order, or the chosen ones; a failed one does not keep the others from running.
pub(crate) fn test(args: &[String]) -> Result<()> {
    let request = args::parse(args, &names(&steps::STEPS))?;
    run("test", &steps::STEPS, &request)
}

/// The long sweeps and the soak tests, many times as many cases as in [`test`].
pub(crate) fn deep(args: &[String]) -> Result<()> {
    let request = args::parse_deep(args, &names(&deep::STEPS))?;
    run("test-deep", &deep::STEPS, &request)
}

/// The other end of a step that runs beside another; only `test` has such steps.
pub(crate) fn run_step(args: &[String]) -> Result<()> {
    let request = args::parse(args, &names(&steps::STEPS))?;
    beside::run_by_itself(&steps::STEPS, &request)
}

fn run(name: &'static str, steps: &[Step], request: &Request) -> Result<()> {
    setup::wasm_target()?;
    setup::components()?;
    setup::node_modules()?;
    let cases = request.cases;
    runner::run(&Command { name, cases }, steps, &request.choices)
}

fn names(steps: &[Step]) -> Vec<StepName> {
    let name = |step: &Step| StepName {
        name: step.name,
        selects: step.selects,
    };
    steps.iter().map(name).collect()
}
