//! Running the Rust tests as wasm: cargo builds them and starts the package `wasm-test-runner` with each test binary.

use crate::test::{Binary, Done, select_tests, test_binaries};
use crate::{browser, shell};
use anyhow::Result;
use std::process::Command;

/// The package of the runner.
const RUNNER: &str = "wasm-test-runner";

/// The environment variable that overrides the runner of .cargo/config.toml.
const RUNNER_SETTING: &str = "CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER";

/// The cargo options that select wasm32.
pub(crate) const TARGET: [&str; 2] = ["--target", "wasm32-unknown-unknown"];
/// The cargo options that select the package of the bindings.
pub(crate) const BINDINGS: [&str; 2] = ["--package", "casteljau-wasm"];
/// Timeout for one wasm test binary in one browser; the runner's default of 20 s is too short on a shared machine.
const WASM_TIMEOUT_S: &str = "120";

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

/// The cargo options that select the test binaries with tests that also run as wasm.
pub(crate) fn target_options() -> Vec<String> {
    let binaries = test_binaries().into_iter().filter(Binary::runs_in_wasm);
    binaries
        .flat_map(|binary| ["--test".to_owned(), binary.name])
        .collect()
}

/// `cargo test` for wasm32 with the runner, which is built first: cargo must not start cargo.
fn tests(filters: &[String]) -> Result<Command> {
    shell::run(&mut shell::cargo(&[
        "build",
        "--quiet",
        "--package",
        RUNNER,
    ]))?;
    let exe = shell::target_dir().join("debug").join(RUNNER);
    let exe = exe.with_extension(std::env::consts::EXE_EXTENSION);
    // Cargo splits the setting at blanks and resolves a relative path from the root, so the root may contain blanks.
    let exe = exe.strip_prefix(shell::root()).unwrap_or(&exe).display();
    let chosen = select_tests(filters, &test_binaries());
    let mut tests = shell::cargo(&["test", "--package", "casteljau"]);
    tests.args(target_options()).args(TARGET);
    tests.env_remove("RUSTFLAGS"); // it would replace the flags of .cargo/config.toml
    tests.env(RUNNER_SETTING, exe.to_string());
    tests.env("WASM_BINDGEN_TEST_TIMEOUT", WASM_TIMEOUT_S);
    tests.arg("--").args(chosen.tests);
    Ok(tests)
}
