//! What the build needs in Rust: wasm-bindgen's libraries, and tools for the sources of the crate. The scripts in `scripts/`
//! call it.

mod compare;
mod encode;
mod glue;
mod liveness;
mod shell;
mod strip_panics;
mod structure;
mod wasm_tests;

use anyhow::{Result, bail};
use std::path::Path;
use std::process::ExitCode;

const USAGE: &str = "\
cargo xtask <command>

  compare                   the generated calls with the library of another revision, and the results that differ: REVISION
                            [FUNCTION] [--cases N] [--distance D]; D: the largest relative distance that counts as equal (0)
  structure                 that no files of the crate import each other

called by the scripts in scripts/:

  glue WASM                 js/glue for a release, from the compiled bindings
  development-glue WASM     js/glue with one module as it was compiled
  wasm-tests WASM [NAME …]  the tests of a binary for wasm32, in Node";

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
    let words: Vec<&str> = args.iter().map(String::as_str).collect();
    match words.as_slice() {
        ["compare", ..] => compare::compare(&args[1..]),
        ["structure"] => structure::check(),
        ["glue", compiled] => glue::generate(Path::new(compiled)),
        ["development-glue", compiled] => glue::generate_for_development(Path::new(compiled)),
        ["wasm-tests", binary, ..] => wasm_tests::run(Path::new(binary), &args[2..]),
        [] | ["help" | "--help" | "-h"] => {
            println!("{USAGE}");
            Ok(())
        }
        others => bail!("expected a command, got {}\n\n{USAGE}", others.join(" ")),
    }
}
