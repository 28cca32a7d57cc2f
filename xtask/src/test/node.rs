//! The steps that run JavaScript tests, in Node and in browsers.

use super::runner::{Context, Done};
use super::select;
use super::steps::{run_all, with_skipped};
use crate::{browser, build, shell, stamp};
use anyhow::Result;
use std::path::{Path, PathBuf};

pub(crate) fn js(context: &Context) -> Result<Done> {
    build::build()?;
    node_tests(context, "tests/js", 2, &[])
}

/// The page tests share one browser, which their own runner starts.
pub(crate) fn page(context: &Context, options: &[&str]) -> Result<Done> {
    build::site()?;
    // TODO until tests/page/run.js is merged: without it every file starts a browser.
    if !shell::root().join("tests/page/run.js").exists() {
        let chrome = browser::find()?.chrome;
        return node_tests(context, "tests/page", 2, &[("CHROME_PATH", &chrome)]);
    }
    let mut tests = shell::node(&["tests/page/run.js"]);
    tests.args(options).args(context.filters);
    tests.env("CHROME_PATH", browser::find()?.chrome);
    run_all([with_skipped(tests, context)])
}

pub(crate) fn page_firefox(context: &Context) -> Result<Done> {
    in_other_browser(context, "FIREFOX_PATH", browser::firefox())
}

pub(crate) fn page_webkit(context: &Context) -> Result<Done> {
    in_other_browser(context, "WEBKIT_DRIVER", browser::webkit())
}

/// The tests of tests/browsers. Where the browser cannot be had (no Debian, no root) the step is skipped: the same pages
/// have passed in Chromium.
fn in_other_browser(context: &Context, variable: &str, path: Option<PathBuf>) -> Result<Done> {
    let Some(path) = path else {
        let reason = "the browser is absent and cannot be installed";
        return Ok(Done::Skipped(format!(
            "{reason}; {variable} can name its path"
        )));
    };
    build::site()?;
    // One file after the other: each starts a browser.
    node_tests(context, "tests/browsers", 1, &[(variable, path.as_path())])
}

pub(crate) fn packaging(context: &Context) -> Result<Done> {
    build::build()?;
    let chrome = browser::find()?.chrome;
    node_tests(context, "tests/packaging", 2, &[("CHROME_PATH", &chrome)])
}

/// The files are listed here because Node 20 and 22 read a folder's name differently.
fn test_files(folder: &str) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = stamp::files_below(&shell::root().join(folder));
    files.retain(|file| file.to_string_lossy().ends_with(".test.js"));
    files
}

/// Tests under Node's own runner; of the variables that name a browser only the given ones are set.
fn node_tests(
    context: &Context,
    folder: &str,
    at_once: usize,
    variables: &[(&str, &Path)],
) -> Result<Done> {
    let chosen = select::files(context.filters, &test_files(folder))?;
    let mut tests = shell::node(&["--test", "--test-reporter=spec"]);
    tests.args([
        "--test-reporter-destination=stdout",
        "--test-reporter=./xtask/skipped.js",
    ]);
    tests.arg(format!(
        "--test-reporter-destination={}",
        context.skipped.display()
    ));
    tests.arg(format!("--test-concurrency={at_once}"));
    tests.args(
        chosen
            .patterns
            .iter()
            .map(|pattern| format!("--test-name-pattern={pattern}")),
    );
    tests.args(chosen.files).env("CASTELJAU_EXPECT_TESTS", "1");
    for browser in ["CHROME_PATH", "FIREFOX_PATH", "WEBKIT_DRIVER"] {
        tests.env_remove(browser);
    }
    tests.envs(variables.iter().copied());
    run_all([tests])
}
