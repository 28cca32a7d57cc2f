//! The steps that run JavaScript tests in Node and in browsers.

use super::select;
use super::step::run_all;
use super::step::{Context, Done};
use crate::{browser, build, shell, stamp};
use anyhow::Result;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The environment variables that name a browser. Each step passes only those that it sets.
const BROWSERS: [&str; 3] = ["CHROME_PATH", "FIREFOX_PATH", "WEBKIT_DRIVER"];

pub(crate) fn js(context: &Context) -> Result<Done> {
    build::build()?;
    node_tests(context, "tests/js", &[], &[])
}

pub(crate) fn page(context: &Context, options: &[&str]) -> Result<Done> {
    build::site()?;
    let chrome = browser::find()?.chrome;
    node_tests(context, "tests/page", options, &[("CHROME_PATH", &chrome)])
}

pub(crate) fn page_firefox(context: &Context) -> Result<Done> {
    in_other_browser(context, "FIREFOX_PATH", browser::firefox())
}

pub(crate) fn page_webkit(context: &Context) -> Result<Done> {
    in_other_browser(context, "WEBKIT_DRIVER", browser::webkit())
}

/// Runs the tests of tests/browsers. If the browser is not available (not Debian, not root) the step is skipped; the
/// same pages are tested in Chromium.
fn in_other_browser(context: &Context, variable: &str, path: Option<PathBuf>) -> Result<Done> {
    let Some(path) = path else {
        let reason = "the browser is absent and cannot be installed";
        return Ok(Done::Skipped(format!(
            "{reason}; {variable} can name its path"
        )));
    };
    build::site()?;
    node_tests(context, "tests/browsers", &[], &[(variable, &path)])
}

pub(crate) fn packaging(context: &Context) -> Result<Done> {
    build::build()?;
    let chrome = browser::find()?.chrome;
    node_tests(context, "tests/packaging", &[], &[("CHROME_PATH", &chrome)])
}

/// Runs the tests of a folder, with the folder's run.js if it has one.
fn node_tests(
    context: &Context,
    folder: &str,
    options: &[&str],
    browsers: &[(&str, &Path)],
) -> Result<Done> {
    let runner = format!("{folder}/run.js");
    let mut tests = if shell::root().join(&runner).exists() {
        let mut own = shell::node(&[&runner]);
        own.args(options).args(context.filters);
        own
    } else {
        plain_runner(context, folder)?
    };
    for browser in BROWSERS {
        tests.env_remove(browser);
    }
    tests.envs(browsers.iter().copied());
    tests.env("CASTELJAU_SKIPPED", &context.skipped);
    run_all([tests])
}

/// Node's test runner with two files at a time; its default would use only one of two cores.
fn plain_runner(context: &Context, folder: &str) -> Result<Command> {
    let chosen = select::files(context.filters, &test_files(folder))?;
    let skipped = context.skipped.display();
    let mut tests = shell::node(&["--test", "--test-concurrency=2"]);
    tests.args(["--test-reporter=spec", "--test-reporter-destination=stdout"]);
    tests.arg("--test-reporter=./xtask/skipped.js");
    tests.arg(format!("--test-reporter-destination={skipped}"));
    let patterns = chosen.patterns.iter();
    tests.args(patterns.map(|pattern| format!("--test-name-pattern={pattern}")));
    tests.args(chosen.files);
    Ok(tests)
}

/// The test files of a folder. They are listed explicitly because Node 20 and 22 treat folder arguments differently.
fn test_files(folder: &str) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = stamp::files_below(&shell::root().join(folder));
    files.retain(|file| {
        let name = file.to_string_lossy();
        name.ends_with(".test.js") && !name.ends_with(".deep.test.js")
    });
    files
}
