//! The build driver: `cargo xtask build | site | serve | test | test-deep | bench | size`.

mod bench;
mod browser;
mod build;
mod compare;
mod encode;
mod glue;
mod liveness;
mod rust_docs;
mod serve;
mod setup;
mod shell;
mod size;
mod stamp;
mod strip_panics;
mod structure;
mod test;
mod wasm_test;

use anyhow::{Result, bail};
use std::process::ExitCode;

const USAGE: &str = "\
cargo xtask <command>

  build            dist/, the npm package
  site             site/, the static site
  serve            build, and serve the site on localhost
  test             all tests; [STEP [FILE_OR_NAME …] …] [--from STEP] [--only STEP[,STEP]]
  test-deep        the long sweeps and soak tests; the same options, and [--cases N]
  compare          the generated calls with the library of another revision, and the results that differ: REVISION
                   [FUNCTION] [--cases N] [--distance D]; D: the largest relative distance that counts as equal (0)
  bench            the benchmarks: JavaScript and native
  size             the gzip size of each part, against the limit";

fn main() -> ExitCode {
    match dispatch(&std::env::args().skip(1).collect::<Vec<_>>()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("\nerror: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn dispatch(args: &[String]) -> Result<()> {
    let (command, rest) = args
        .split_first()
        .map_or(("help", &[][..]), |(first, rest)| (first.as_str(), rest));
    match command {
        "build" => build::build(),
        "site" => build::site(),
        "serve" => serve::serve(rest),
        "test" => test::test(rest),
        "test-deep" => test::deep(rest),
        test::RUN_STEP => test::run_step(rest),
        "compare" => compare::compare(rest),
        "bench" => bench::bench(rest),
        "size" => size::size(),
        "help" | "--help" | "-h" => {
            println!("{USAGE}");
            Ok(())
        }
        other => bail!("no command {other}\n\n{USAGE}"),
    }
}
