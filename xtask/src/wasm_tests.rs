//! Runs a test binary for wasm32 in Node, as wasm-bindgen-test-runner does, whose other half (browsers, servers) would be 120 more crates.
//! Cargo starts it with the binary.

use crate::shell;
use anyhow::{Context, Result, ensure};
use std::fs;
use std::path::Path;
use wasm_bindgen_cli_support::Bindgen;

/// The start of the name of an export that is a test: `__wbgt_MODIFIERS_BINARY::PATH`.
const TEST: &str = "__wbgt_";

/// The tests of a binary, with the names that wasm-bindgen-test gives them.
const SCRIPT: &str = r#"
globalThis.__wbg_test_invoke = (test) => test();
globalThis.__wbgtest_og_console_log = console.log;
globalThis.__wbgtest_og_console_error = console.error;
const wasm = require("./tests.js");
const context = new wasm.WasmBindgenTestContext(false);
context.include_ignored(false);
context.filtered_count(FILTERED);
context.run(TESTS.map((name) => wasm.__wasm[name])).then(
  (passed) => process.exit(passed ? 0 : 1),
  (error) => {
    console.error(error);
    process.exit(1);
  },
);
"#;

/// Runs the tests whose names contain one of the filters, or all; fails if no name matches.
pub(crate) fn run(binary: &Path, filters: &[String]) -> Result<()> {
    let wasm = fs::read(binary).with_context(|| binary.display().to_string())?;
    let module = walrus::Module::from_buffer(&wasm)?;
    let name_of = |export: &str| Some(export.strip_prefix(TEST)?.split_once("::")?.1.to_owned());
    let exports = module.exports.iter().map(|export| export.name.clone());
    let all: Vec<String> = exports.filter(|name| name_of(name).is_some()).collect();
    let wanted = |export: &&String| {
        let name = name_of(export).unwrap_or_default();
        filters.is_empty() || filters.iter().any(|filter| name.contains(filter))
    };
    let chosen: Vec<&String> = all.iter().filter(wanted).collect();
    ensure!(
        !chosen.is_empty(),
        "expected a part of a test's name, got {filters:?}"
    );
    let folder = shell::target_dir().join("wasm-tests");
    fs::create_dir_all(&folder)?;
    fs::write(folder.join("package.json"), r#"{ "type": "commonjs" }"#)?;
    Bindgen::new()
        .nodejs(true)?
        .debug(true)
        .export_wasm(true)
        .input_module("tests", module)
        .emit_start(false)
        .generate(&folder)
        .context("generating the bindings")?;
    let script = SCRIPT
        .replace("FILTERED", &(all.len() - chosen.len()).to_string())
        .replace("TESTS", &format!("{chosen:?}"));
    let path = folder.join("run.cjs");
    fs::write(&path, script)?;
    shell::run(shell::node(&[]).arg(path))
}
