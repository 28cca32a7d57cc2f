//! The Rust tests as wasm: cargo builds them and starts this very executable to run each.

use crate::test::{Done, binaries, mentions, test_targets};
use crate::{browser, shell};
use anyhow::Result;
use std::process::Command;

/// The hidden command by which cargo starts the driver as the runner of wasm tests.
pub(crate) const RUNNER: &str = "run-wasm-test";

/// Overrides the runner of .cargo/config.toml.
const RUNNER_SETTING: &str = "CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER";

/// What selects wasm32.
pub(crate) const TARGET: [&str; 2] = ["--target", "wasm32-unknown-unknown"];
/// The package of the bindings.
pub(crate) const BINDINGS: [&str; 2] = ["--package", "casteljau-wasm"];
/// For one wasm test binary in one browser; the runner's own 20 s are short for a shared machine.
const WASM_TIMEOUT_S: &str = "300";

/// The Rust tests as wasm in Node.
pub(crate) fn in_node(filters: &[String]) -> Result<Done> {
    shell::run(&mut tests(filters)?)?;
    Ok(Done::Passed)
}

/// The Rust tests as wasm in Chromium, through its driver.
pub(crate) fn in_chromium(filters: &[String]) -> Result<Done> {
    let browser = browser::find_with_driver()?;
    let Some(driver) = &browser.driver else {
        let chrome = browser.chrome.display();
        let reason = format!("no chromedriver for {chrome}; install it or set CHROMEDRIVER");
        return Ok(Done::Skipped(reason));
    };
    let settings = browser::driver_settings(&browser)?;
    let mut command = tests(filters)?;
    command.env("WASM_BINDGEN_USE_BROWSER", "1");
    command.env("WASM_BINDGEN_TEST_WEBDRIVER_JSON", settings);
    shell::run(command.env("CHROMEDRIVER", driver))?;
    Ok(Done::Passed)
}

/// The test binaries with tests that also run as wasm.
fn wasm_targets() -> Vec<String> {
    let targets = test_targets().into_iter();
    targets
        .filter(|(_, root)| mentions(root, "wasm_bindgen_test"))
        .map(|(name, _)| name)
        .collect()
}

/// The options that choose these binaries.
pub(crate) fn target_options() -> Vec<String> {
    let options = wasm_targets().into_iter();
    options
        .flat_map(|name| ["--test".to_owned(), name])
        .collect()
}

/// `cargo test` for wasm32 with this executable as the runner.
fn tests(filters: &[String]) -> Result<Command> {
    let exe = std::env::current_exe()?;
    // Cargo splits the setting at blanks and takes a relative path from the root: so blanks in the root do no harm.
    let exe = exe.strip_prefix(shell::root()).unwrap_or(&exe).display();
    let chosen = binaries(filters, &wasm_targets());
    let mut tests = shell::cargo(&["test", "--package", "casteljau", "--no-fail-fast"]);
    if chosen.targets.is_empty() {
        tests.args(target_options());
    }
    for target in &chosen.targets {
        tests.args(["--test", target]);
    }
    tests.args(TARGET).env_remove("RUSTFLAGS"); // it would replace those of .cargo/config.toml
    tests.env(RUNNER_SETTING, format!("{exe} {RUNNER}"));
    tests.env("WASM_BINDGEN_TEST_TIMEOUT", WASM_TIMEOUT_S);
    tests.arg("--").args(chosen.tests);
    Ok(tests)
}

/// The other end of [`tests`].
pub(crate) fn run(args: &[String]) -> Result<()> {
    let name = String::from("wasm-bindgen-test-runner");
    let all = std::iter::once(name).chain(args.iter().cloned());
    wasm_bindgen_cli::wasm_bindgen_test_runner::run_cli_with_args(all)
}
