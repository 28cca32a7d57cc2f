//! `test`: every test there is, step by step, with the command to repeat the one that failed.

use crate::{browser, build, setup, shell, stamp, wasm_test};
use anyhow::{Context, Result, bail};
use std::path::PathBuf;
use std::process::Command;
use std::time::Instant;

struct Step {
    name: &'static str,
    title: &'static str,
    act: fn() -> Result<()>,
}

const STEPS: [Step; 15] = [
    Step {
        name: "fmt",
        title: "Rust is formatted",
        act: fmt,
    },
    Step {
        name: "clippy",
        title: "Lints, native",
        act: clippy,
    },
    Step {
        name: "clippy-wasm",
        title: "Lints, wasm32",
        act: clippy_wasm,
    },
    Step {
        name: "native",
        title: "Rust tests, native",
        act: native,
    },
    Step {
        name: "doc",
        title: "Examples in the Rust documentation",
        act: doc,
    },
    Step {
        name: "xtask",
        title: "Tests of the driver",
        act: driver,
    },
    Step {
        name: "wasm-node",
        title: "Rust tests as wasm, in Node",
        act: wasm_test::in_node,
    },
    Step {
        name: "wasm-chromium",
        title: "Rust tests as wasm, in Chromium",
        act: wasm_test::in_chromium,
    },
    Step {
        name: "build",
        title: "The npm package",
        act: build::build,
    },
    Step {
        name: "types",
        title: "JSDoc types of the package's sources",
        act: types,
    },
    Step {
        name: "js",
        title: "Tests of the npm package",
        act: js,
    },
    Step {
        name: "page",
        title: "Page tests, in Chromium",
        act: page,
    },
    Step {
        name: "page-firefox",
        title: "The main page tests, in Firefox",
        act: page_firefox,
    },
    Step {
        name: "page-webkit",
        title: "The main page tests, in WebKitGTK",
        act: page_webkit,
    },
    Step {
        name: "packaging",
        title: "The packed tarball in Node, bundlers and a browser",
        act: packaging,
    },
];

/// All steps in order, or the named ones; stops at the first that fails.
pub(crate) fn test(names: &[String]) -> Result<()> {
    let known = STEPS.map(|step| step.name);
    if let Some(unknown) = names.iter().find(|name| !known.contains(&name.as_str())) {
        bail!("no step {unknown}; there are: {}", known.join(", "));
    }
    setup::wasm_target()?;
    setup::components()?;
    setup::node_modules()?;
    let start = Instant::now();
    let mut lines = Vec::new();
    for step in STEPS
        .iter()
        .filter(|step| names.is_empty() || names.iter().any(|name| name == step.name))
    {
        println!("\n━━ {} ({})", step.title, step.name);
        let begin = Instant::now();
        (step.act)().with_context(|| {
            format!("{}; to repeat: cargo xtask test {}", step.title, step.name)
        })?;
        lines.push(format!(
            "  {:>6.1} s  {}",
            begin.elapsed().as_secs_f64(),
            step.title
        ));
    }
    println!(
        "\n━━ All passed\n{}\n  {:>6.1} s  together",
        lines.join("\n"),
        start.elapsed().as_secs_f64()
    );
    Ok(())
}

/// The same tests with many more cases; they read CASTELJAU_DEEP.
pub(crate) fn deep() -> Result<()> {
    let args = ["test", "--release", "--package", "casteljau", "--tests"];
    shell::run(shell::cargo(&args).env("CASTELJAU_DEEP", "1"))
}

fn fmt() -> Result<()> {
    shell::run(&mut shell::cargo(&["fmt", "--all", "--check"]))
}

fn clippy() -> Result<()> {
    let package = [
        "--quiet",
        "--package",
        "casteljau",
        "--all-targets",
        "--all-features",
    ];
    let deny = ["--", "--deny", "warnings"];
    shell::run(shell::cargo(&["clippy"]).args(package).args(deny))?;
    // The driver in its own profile, whose dependencies are built already.
    shell::run(
        shell::cargo(&[
            "clippy",
            "--quiet",
            "--package",
            "xtask",
            "--profile",
            "xtask",
        ])
        .args(deny),
    )
}

fn clippy_wasm() -> Result<()> {
    let targets = ["--quiet", "--package", "casteljau", "--lib", "--tests"];
    shell::run(
        shell::cargo(&["clippy"])
            .args(wasm_test::TARGET)
            .args(targets)
            .args(["--", "--deny", "warnings"]),
    )
}

fn native() -> Result<()> {
    shell::run(&mut shell::cargo(&[
        "test",
        "--package",
        "casteljau",
        "--features",
        "serde",
        "--lib",
        "--tests",
        "--examples",
    ]))
}

fn doc() -> Result<()> {
    shell::run(&mut shell::cargo(&[
        "test",
        "--package",
        "casteljau",
        "--doc",
    ]))?;
    let mut docs = shell::cargo(&["doc", "--quiet", "--package", "casteljau", "--no-deps"]);
    shell::run(docs.env("RUSTDOCFLAGS", "--deny warnings"))
}

fn driver() -> Result<()> {
    shell::run(&mut shell::cargo(&[
        "test",
        "--quiet",
        "--package",
        "xtask",
        "--profile",
        "xtask",
    ]))
}

/// The build has checked the types already; here they are checked whether or not something changed.
fn types() -> Result<()> {
    build::build()?;
    let tsc = "node_modules/typescript/bin/tsc";
    shell::run(&mut shell::node(&[
        tsc,
        "--emitDeclarationOnly",
        "false",
        "--declaration",
        "false",
        "--noEmit",
    ]))
}

fn js() -> Result<()> {
    build::build()?;
    node_tests("tests/js", &[])
}

fn page() -> Result<()> {
    build::site()?;
    in_chromium("tests/page/run.js")
}

fn page_firefox() -> Result<()> {
    in_other_browser("firefox", "FIREFOX_PATH", browser::firefox())
}

fn page_webkit() -> Result<()> {
    in_other_browser("webkit", "WEBKIT_DRIVER", browser::webkit())
}

/// The tests of tests/browsers. Where the browser cannot be had (no Debian, no root) they are left out, in so many words:
/// the same pages have passed in Chromium.
fn in_other_browser(name: &str, variable: &str, path: Option<PathBuf>) -> Result<()> {
    let Some(path) = path else {
        println!(
            "!! LEFT OUT: {name} is not here and cannot be installed; {variable} can say where it is"
        );
        return Ok(());
    };
    build::site()?;
    let mut tests = shell::node(&["tests/browsers/run.js"]);
    tests.env_remove("FIREFOX_PATH").env_remove("WEBKIT_DRIVER");
    shell::run(tests.env(variable, path))
}

fn packaging() -> Result<()> {
    build::build()?;
    in_chromium("tests/packaging/run.js")
}

/// A script that starts one Chromium for its tests.
fn in_chromium(script: &str) -> Result<()> {
    let mut tests = shell::node(&[script]);
    shell::run(tests.env("CHROME_PATH", browser::find()?.chrome))
}

fn node_test() -> Command {
    shell::node(&["--test", "--test-reporter=spec"])
}

/// The files are listed here because Node 20 and 22 read a folder's name differently.
fn test_files(folder: &str) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = stamp::files_below(&shell::root().join(folder));
    files.retain(|file| file.to_string_lossy().ends_with(".test.js"));
    files
}

fn node_tests(folder: &str, options: &[&str]) -> Result<()> {
    let files = test_files(folder);
    if files.is_empty() {
        println!("no tests yet in {folder}");
        return Ok(());
    }
    shell::run(node_test().args(options).args(files))
}
