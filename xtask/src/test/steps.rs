//! The steps of `test`.

use super::step::{Context, Done, Lane, Step, run_all};
use super::{node, select};
use crate::stamp::files_below;
use crate::{build, setup, shell, wasm_test};
use anyhow::Result;
use std::process::Command;

/// The default values of a step.
const PLAIN: Step = Step {
    name: "",
    title: "",
    needs: &[],
    selects: false,
    lane: Lane::Rust,
    act: |_| Ok(Done::Passed),
};

pub(crate) const STEPS: [Step; 20] = [
    Step {
        name: "fmt",
        title: "Rust is formatted",
        act: fmt,
        ..PLAIN
    },
    Step {
        name: "structure",
        title: "No files of the crate import each other",
        act: |_| crate::structure::check().map(|()| Done::Passed),
        ..PLAIN
    },
    Step {
        name: "lint-js",
        title: "JavaScript is formatted; lints",
        act: lint_js,
        lane: Lane::JavaScript,
        ..PLAIN
    },
    Step {
        name: "clippy",
        title: "Lints, native",
        act: clippy,
        ..PLAIN
    },
    Step {
        name: "clippy-wasm",
        title: "Lints, wasm32",
        act: clippy_wasm,
        ..PLAIN
    },
    Step {
        name: "native",
        title: "Rust tests, native",
        selects: true,
        act: native,
        ..PLAIN
    },
    Step {
        name: "doc",
        title: "Examples in the Rust documentation",
        act: doc,
        ..PLAIN
    },
    Step {
        name: "reference",
        title: "Rust samples of the API reference",
        act: reference,
        ..PLAIN
    },
    Step {
        name: "xtask",
        title: "Tests of the driver",
        act: driver,
        ..PLAIN
    },
    Step {
        name: "msrv",
        title: "The crate with the oldest version of Rust that it supports",
        act: oldest_rust,
        ..PLAIN
    },
    Step {
        name: "wasm-node",
        title: "Rust tests as wasm, in Node",
        selects: true,
        act: |context| wasm_test::in_node(context.filters),
        ..PLAIN
    },
    Step {
        name: "build",
        title: "The npm package",
        act: |_| build::build().map(|()| Done::Passed),
        lane: Lane::JavaScript,
        ..PLAIN
    },
    Step {
        name: "types",
        title: "Types of the package, the site, tests and benchmarks, and of a program that uses the package",
        needs: &["build"],
        act: types,
        lane: Lane::JavaScript,
        ..PLAIN
    },
    Step {
        name: "size",
        title: "Sizes of the package's parts",
        needs: &["build"],
        act: size,
        lane: Lane::JavaScript,
        ..PLAIN
    },
    Step {
        name: "site",
        title: "The static site",
        needs: &["build"],
        act: |_| build::site().map(|()| Done::Passed),
        lane: Lane::JavaScript,
        ..PLAIN
    },
    Step {
        name: "js",
        title: "Tests of the npm package",
        needs: &["build"],
        selects: true,
        act: node::js,
        lane: Lane::JavaScript,
    },
    Step {
        name: "page",
        title: "Page tests, in Chromium",
        needs: &["build", "site"],
        selects: true,
        act: |context| node::page(context, &[]),
        lane: Lane::JavaScript,
    },
    Step {
        name: "page-firefox",
        title: "The main page tests, in Firefox",
        needs: &["build", "site"],
        selects: true,
        act: node::page_firefox,
        lane: Lane::JavaScript,
    },
    Step {
        name: "page-webkit",
        title: "The main page tests, in WebKitGTK",
        needs: &["build", "site"],
        selects: true,
        act: node::page_webkit,
        lane: Lane::JavaScript,
    },
    Step {
        name: "packaging",
        title: "The packed tarball in Node, bundlers and a browser",
        needs: &["build"],
        selects: true,
        act: node::packaging,
        lane: Lane::JavaScript,
    },
];

/// The samples of the site are modules that a macro declares, where `cargo fmt` does not find them.
fn fmt(_: &Context) -> Result<Done> {
    let mut samples = shell::command("rustfmt", &["--check", "--edition", "2024"]);
    let files = files_below(&shell::root().join("www/samples")).into_iter();
    samples.args(files.filter(|file| file.extension().is_some_and(|ending| ending == "rs")));
    run_all([shell::cargo(&["fmt", "--all", "--check"]), samples])
}

/// Checks the format and the lint rules of JavaScript and JSON, as biome.jsonc sets them.
fn lint_js(_: &Context) -> Result<Done> {
    setup::node_modules()?;
    let biome = "node_modules/@biomejs/biome/bin/biome";
    run_all([shell::node(&[biome, "check", "--error-on-warnings"])])
}

fn clippy(_: &Context) -> Result<Done> {
    let clippy = |packages: &[&str], options: &[&str]| {
        let mut command = shell::cargo(&["clippy", "--quiet", "--all-targets"]);
        for package in packages {
            command.args(["--package", package]);
        }
        command.args(options).args(["--", "--deny", "warnings"]);
        command
    };
    let mut curves_alone = shell::cargo(&["clippy", "--quiet", "--package", "casteljau", "--lib"]);
    curves_alone.args(["--no-default-features", "--", "--deny", "warnings"]);
    run_all([
        clippy(
            &["casteljau", "casteljau-benches", "casteljau-kernels"],
            &["--all-features"],
        ),
        // Curves alone, with the library only, because the tests need all features.
        curves_alone,
        clippy(&["xtask"], &[]),
    ])
}

/// The bindings, with the sources of the crate. The tests are the same as natively.
fn clippy_wasm(_: &Context) -> Result<Done> {
    let mut clippy = shell::cargo(&["clippy", "--quiet"]);
    clippy.args(wasm_test::TARGET).args(wasm_test::BINDINGS);
    clippy.args(["--", "--deny", "warnings"]);
    run_all([clippy])
}

fn native(context: &Context) -> Result<Done> {
    let chosen = select::tests(context.filters, &select::test_binaries());
    let tests = || {
        let mut tests = shell::cargo(&[
            "test",
            "--package",
            "casteljau",
            "--features",
            "casteljau/serde,casteljau/kurbo",
        ]);
        tests.arg("--no-fail-fast");
        if chosen.targets.is_empty() {
            tests.args(["--package", "casteljau-kernels"]);
            tests.args(["--lib", "--tests"]); // the examples are compiled by clippy
        }
        for target in &chosen.targets {
            tests.args(["--test", target]);
        }
        with_skipped(tests, context)
    };
    shell::run_tests(tests, &chosen.tests)?;
    Ok(Done::Passed)
}

fn doc(_: &Context) -> Result<Done> {
    // The same features as for the native tests, so that their compiled crate is reused.
    let package = ["--package", "casteljau", "--features", "serde,kurbo"];
    let mut examples = shell::cargo(&["test", "--doc"]);
    examples.args(package);
    run_all([examples, crate::rust_docs::command()])
}

fn reference(_: &Context) -> Result<Done> {
    // With the crate's own unit tests, and so with the features of its test dependencies: its compiled crates are reused.
    let packages = ["--package", "casteljau-reference", "--package", "casteljau"];
    let mut tests = shell::cargo(&["test", "--quiet", "--lib"]);
    tests.args(packages);
    tests.args(["--features", "casteljau/serde,casteljau/kurbo"]);
    run_all([tests])
}

/// Compiles the crate with the version that Cargo.toml names as `rust-version`.
fn oldest_rust(_: &Context) -> Result<Done> {
    let version = setup::oldest_rust()?;
    if !setup::has_rust(&version) {
        return Ok(Done::Skipped(format!(
            "Rust {version} is absent and cannot be installed"
        )));
    }
    let mut check = shell::cargo(&["check", "--quiet", "--package", "casteljau"]);
    check.args(["--features", "serde,kurbo,rayon"]);
    check.args([
        "--target-dir".as_ref(),
        shell::target_dir().join("msrv").as_os_str(),
    ]);
    check.env("RUSTUP_TOOLCHAIN", &version);
    run_all([check])
}

fn driver(_: &Context) -> Result<Done> {
    run_all([shell::cargo(&["test", "--quiet", "--package", "xtask"])])
}

fn size(_: &Context) -> Result<Done> {
    crate::size::size()?;
    Ok(Done::Passed)
}

/// Checks the types of the package, the site, the tests, the benchmarks, and a program that uses the package's declarations. The
/// build checks those of the package only if something changed; this step always does.
fn types(_: &Context) -> Result<Done> {
    build::build()?;
    let tsc = "node_modules/typescript/bin/tsc";
    let check_only = [
        "--emitDeclarationOnly",
        "false",
        "--declaration",
        "false",
        "--noEmit",
    ];
    let mut package = shell::node(&[tsc]);
    package.args(check_only);
    let project = |folder| shell::node(&[tsc, "--project", folder]);
    run_all([
        package,
        project("www"),
        project("tests"),
        project("benches"),
        project("tests/types"),
    ])
}

/// Passes the file for the list of skipped tests to a custom runner.
fn with_skipped(mut command: Command, context: &Context) -> Command {
    command.env("CASTELJAU_SKIPPED", &context.skipped);
    command
}
