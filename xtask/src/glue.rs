//! From the compiler's wasm to the files of js/glue: bindings, optimised module, bytes as text.

use crate::{encode, shell, snip};
use anyhow::{Context, Result};
use std::fs;
use std::path::{Path, PathBuf};
use wasm_bindgen_cli_support::Bindgen;

/// For speed: the kernels are what the package is for, and -Os saves only a few per cent.
const OPTIMISE: &str = "-O3";

/// What rustc and the bindings use, given explicitly because the optimiser's own default is less.
const FEATURES: [&str; 7] = [
    "--enable-simd",
    "--enable-bulk-memory",
    "--enable-nontrapping-float-to-int",
    "--enable-sign-ext",
    "--enable-mutable-globals",
    "--enable-reference-types",
    "--enable-multivalue",
];

/// The generated part of the JavaScript sources.
pub(crate) fn folder() -> PathBuf {
    shell::root().join("js/glue")
}

/// Makes everything in js/glue from the wasm that cargo built.
pub(crate) fn generate(compiled: &Path) -> Result<()> {
    bindings(compiled)?;
    optimise(
        &folder().join("casteljau_bg.wasm"),
        &folder().join("casteljau.wasm"),
    )?;
    let wasm = fs::read(folder().join("casteljau.wasm"))?;
    fs::write(folder().join("bytes.js"), encode::module(&wasm))?;
    Ok(fs::write(folder().join("bytes.d.ts"), BYTES_TYPES)?)
}

/// The default module path is omitted: `import.meta` would break IIFE bundles and `require()`.
fn bindings(compiled: &Path) -> Result<()> {
    Bindgen::new()
        .web(true)?
        .typescript(true)
        .omit_default_module_path(true)
        .remove_name_section(true)
        .remove_producers_section(true)
        .input_module("casteljau", snip::panics(compiled)?)
        .generate(folder())
        .context("generating the bindings")
}

fn optimise(from: &Path, to: &Path) -> Result<()> {
    let mut wasm_opt = shell::node(&["node_modules/binaryen/bin/wasm-opt", OPTIMISE]);
    wasm_opt.args(FEATURES).args([
        "--strip-debug",
        "--strip-producers",
        "--strip-target-features",
    ]);
    shell::run_quietly(wasm_opt.arg(from).arg("-o").arg(to))?;
    Ok(fs::remove_file(from)?)
}

const BYTES_TYPES: &str = "\
export declare const length: number;
export declare const frequent: number[];
export declare const alphabet: string;
export declare const text: string;
";
