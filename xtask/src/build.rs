//! `build`: builds dist/, the published package, from the Rust sources and js/.

use crate::stamp::{self, Work, files_below};
use crate::{glue, rust_docs, setup, shell, wasm_test};
use anyhow::Result;
use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

/// Builds all of dist/ except what is up to date.
pub(crate) fn build() -> Result<()> {
    setup::wasm_target()?;
    setup::node_modules()?;
    let _single = stamp::lock()?;
    bindings()?;
    bundles()?;
    types()
}

/// Builds js/glue: the bindings and the optimised modules.
fn bindings() -> Result<()> {
    shell::run(&mut compilation())?;
    let compiled = shell::target_dir().join("wasm32-unknown-unknown/wasm/casteljau.wasm");
    let outputs = [
        "casteljau.js",
        "casteljau.d.ts",
        "casteljau.wasm",
        "curves.wasm",
        "curves-bytes.js",
        "surfaces.wasm",
        "surfaces-bytes.js",
        "core.wasm",
        "core-bytes.js",
        "core-surfaces.wasm",
        "core-surfaces-bytes.js",
        "applet.wasm",
        "applet-bytes.js",
        "functions.d.ts",
    ]
    .map(|name| glue::folder().join(name));
    let work = Work {
        name: "glue",
        inputs: std::slice::from_ref(&compiled),
        outputs: &outputs,
    };
    stamp::unless_current(&work, || glue::generate(&compiled))
}

/// The cargo command that compiles the bindings. Panic messages contain source paths; the path remapping removes the
/// folders of this machine.
fn compilation() -> Command {
    let home = env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home
        .or_else(|| Some(env::home_dir()?.join(".cargo")))
        .unwrap_or_default();
    let remap = format!("--remap-path-prefix={}=cargo", home.display());
    let mut cargo = shell::cargo(&["build", "--lib", "--profile", "wasm"]);
    cargo.args(wasm_test::BINDINGS).args(wasm_test::TARGET);
    // Cargo adds these flags to those of .cargo/config.toml; the environment variables would replace them.
    cargo
        .env_remove("RUSTFLAGS")
        .env_remove("CARGO_ENCODED_RUSTFLAGS");
    cargo.arg("--config").arg(format!(
        "target.wasm32-unknown-unknown.rustflags=[{remap:?},\"-Clink-arg=--emit-relocs\"]"
    ));
    cargo
}

/// The bundles that the site uses.
const SITE_SCRIPTS: [&str; 7] = [
    "index.js",
    "applet.js",
    "surfaces.js",
    "elements.js",
    "elements-surface.js",
    "elements-applet.js",
    "bezier-app.js",
];

/// Builds the bundles and the scripts in target/js/, and copies the wasm file.
fn bundles() -> Result<()> {
    let root = shell::root();
    let mut inputs = files_below(&root.join("js"));
    inputs.extend(
        [
            "xtask/bundle.js",
            "xtask/manifest.js",
            "xtask/no-dom.js",
            "xtask/notices.js",
            "xtask/source-map.js",
            "xtask/texts.js",
            "package.json",
            "package-lock.json",
            "Cargo.lock",
        ]
        .map(|name| root.join(name)),
    );
    let others = [
        "core.js",
        "paths.js",
        "slim.js",
        "casteljau.wasm",
        "custom-elements.json",
        "texts.json",
        "easing.js",
        "casteljau.global.js",
        "THIRD-PARTY-NOTICES.txt",
    ];
    let outputs: Vec<PathBuf> = SITE_SCRIPTS
        .iter()
        .chain(&others)
        .map(|name| root.join("dist").join(name))
        .chain([root.join("target/js/index.js")])
        .collect();
    stamp::unless_current(
        &Work {
            name: "bundles",
            inputs: &inputs,
            outputs: &outputs,
        },
        || {
            fs::create_dir_all(root.join("dist"))?;
            shell::run(&mut shell::node(&["xtask/bundle.js"]))?;
            shell::run(&mut shell::node(&["xtask/manifest.js"]))?;
            shell::run(&mut shell::node(&["xtask/texts.js"]))?;
            fs::copy(
                glue::folder().join("casteljau.wasm"),
                root.join("dist/casteljau.wasm"),
            )?;
            Ok(())
        },
    )
}

/// Builds dist/types from js/; a type error fails the build.
fn types() -> Result<()> {
    let root = shell::root();
    let mut inputs: Vec<PathBuf> = files_below(&root.join("js"));
    // These files do not affect the types.
    inputs.retain(|path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        !(name.ends_with("-bytes.js") || name.ends_with(".wasm"))
    });
    inputs.extend(
        ["tsconfig.json", "package-lock.json", "xtask/types.js"].map(|name| root.join(name)),
    );
    let outputs = [
        root.join("dist/types/index.d.ts"),
        root.join("dist/types/paths.d.ts"),
        root.join("dist/types/core.d.ts"),
        root.join("dist/types/surfaces.d.ts"),
        root.join("dist/types/easing.d.ts"),
        root.join("dist/types/applet/classic.d.ts"),
    ];
    stamp::unless_current(
        &Work {
            name: "types",
            inputs: &inputs,
            outputs: &outputs,
        },
        || {
            if root.join("dist/types").exists() {
                fs::remove_dir_all(root.join("dist/types"))?; // removes declarations of deleted files
            }
            shell::run(&mut shell::node(&[
                "node_modules/typescript/bin/tsc",
                "--project",
                "tsconfig.json",
            ]))?;
            shell::run(&mut shell::node(&["xtask/types.js"]))
        },
    )
}

/// Builds the static site, with relative URLs, in site/, and the Rust documentation in site/rust/.
pub(crate) fn site() -> Result<()> {
    build()?;
    let root = shell::root();
    let mut inputs = files_below(&root.join("www"));
    inputs.extend(files_below(&root.join("src")));
    inputs.extend(files_below(&root.join("kernels/src")));
    inputs.extend(SITE_SCRIPTS.map(|name| root.join("dist").join(name)));
    inputs.push(root.join("package-lock.json"));
    let work = Work {
        name: "site",
        inputs: &inputs,
        outputs: &[root.join("site/index.html")],
    };
    let _single = stamp::lock()?;
    stamp::unless_current(&work, || {
        shell::run(&mut shell::node(&[
            "node_modules/vite/bin/vite.js",
            "build",
            "--config",
            "www/vite.config.js",
        ]))?;
        rust_docs::add_to_site()
    })
}
