//! Running the Rust tests as wasm: cargo builds them and starts this executable as the runner of each test binary.

use crate::test::{Done, binaries, mentions, test_targets};
use crate::{browser, shell};
use anyhow::Result;
use std::process::Command;

/// The hidden command with which cargo starts the driver as the runner of wasm tests.
pub(crate) const RUNNER: &str = "run-wasm-test";

/// The environment variable that overrides the runner of .cargo/config.toml.
const RUNNER_SETTING: &str = "CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER";

/// The cargo options that select wasm32.
pub(crate) const TARGET: [&str; 2] = ["--target", "wasm32-unknown-unknown"];
/// The cargo options that select the package of the bindings.
pub(crate) const BINDINGS: [&str; 2] = ["--package", "casteljau-wasm"];
/// Timeout for one wasm test binary in one browser; the runner's default of 20 s is too short on a shared machine.
const WASM_TIMEOUT_S: &str = "300";

/// Runs the Rust tests as wasm in Node.
pub(crate) fn in_node(filters: &[String]) -> Result<Done> {
    shell::run(&mut tests(filters)?)?;
    Ok(Done::Passed)
}

/// Runs the Rust tests as wasm in Chromium, through chromedriver.
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

/// The test binaries that contain tests that also run as wasm.
fn wasm_targets() -> Vec<String> {
    let targets = test_targets().into_iter();
    targets
        .filter(|(_, root)| mentions(root, "wasm_bindgen_test"))
        .map(|(name, _)| name)
        .collect()
}

/// The cargo options that select these binaries.
pub(crate) fn target_options() -> Vec<String> {
    let options = wasm_targets().into_iter();
    options
        .flat_map(|name| ["--test".to_owned(), name])
        .collect()
}

/// `cargo test` for wasm32 with this executable as the runner.
fn tests(filters: &[String]) -> Result<Command> {
    let exe = std::env::current_exe()?;
    // Cargo splits the setting at blanks and resolves a relative path from the root, so the root may contain blanks.
    let exe = exe.strip_prefix(shell::root()).unwrap_or(&exe).display();
    let chosen = binaries(filters, &wasm_targets());
    let mut tests = shell::cargo(&["test", "--package", "casteljau", "--no-fail-fast"]);
    if chosen.targets.is_empty() {
        tests.args(target_options());
    }
    for target in &chosen.targets {
        tests.args(["--test", target]);
    }
    tests.args(TARGET).env_remove("RUSTFLAGS"); // it would replace the flags of .cargo/config.toml
    tests.env(RUNNER_SETTING, format!("{exe} {RUNNER}"));
    tests.env("WASM_BINDGEN_TEST_TIMEOUT", WASM_TIMEOUT_S);
    tests.arg("--").args(chosen.tests);
    Ok(tests)
}

/// Runs one test binary; cargo calls this by the command that [`tests`] sets.
pub(crate) fn run(args: &[String]) -> Result<()> {
    let name = String::from("wasm-bindgen-test-runner");
    let all = std::iter::once(name).chain(args.iter().cloned());
    wasm_bindgen_cli::wasm_bindgen_test_runner::run_cli_with_args(all)
}
