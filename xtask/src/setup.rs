//! Setup of a fresh clone: the wasm target, the components of the toolchain, node_modules.

use crate::{shell, stamp};
use anyhow::{Context, Result, bail};
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::PathBuf;

const WASM_TARGET: &str = "wasm32-unknown-unknown";
/// The oldest version of Node in which `require()` accepts an ES module.
const MIN_NODE: (u32, u32) = (20, 19);

/// Installs the wasm target. rust-toolchain.toml names it, but has no effect if rustup's auto-install is off.
pub(crate) fn wasm_target() -> Result<()> {
    let sysroot = shell::output_of(&mut shell::command("rustc", &["--print", "sysroot"]));
    let sysroot = sysroot.context("rustc does not run: install Rust from https://rustup.rs")?;
    if PathBuf::from(sysroot)
        .join("lib/rustlib")
        .join(WASM_TARGET)
        .exists()
    {
        return Ok(());
    }
    println!("adding the Rust target {WASM_TARGET}");
    shell::run(&mut shell::command(
        "rustup",
        &["target", "add", WASM_TARGET],
    ))
}

/// Installs rustfmt and clippy, which a minimal toolchain does not include.
pub(crate) fn components() -> Result<()> {
    for (component, command) in [("rustfmt", "fmt"), ("clippy", "clippy")] {
        if shell::output_of(&mut shell::cargo(&[command, "--version"])).is_none() {
            shell::run(&mut shell::command(
                "rustup",
                &["component", "add", component],
            ))?;
        }
    }
    Ok(())
}

/// The oldest version of Rust that the crate supports.
pub(crate) fn oldest_rust() -> Result<String> {
    let manifest = fs::read_to_string(shell::root().join("Cargo.toml"))?;
    let mut lines = manifest.lines();
    let version = lines.find_map(|line| line.strip_prefix("rust-version = \"")?.strip_suffix('"'));
    Ok(version
        .context("Cargo.toml has no rust-version")?
        .to_owned())
}

/// Whether a version of Rust is there; installs it if it can.
pub(crate) fn has_rust(version: &str) -> bool {
    let mut rustc = shell::command("rustc", &["--version"]);
    rustc.env("RUSTUP_TOOLCHAIN", version);
    if shell::output_of(&mut rustc).is_some() {
        return true;
    }
    let install = [
        "toolchain",
        "install",
        version,
        "--profile",
        "minimal",
        "--no-self-update",
    ];
    shell::run(&mut shell::command("rustup", &install)).is_ok()
}

/// Runs `npm ci` unless node_modules was installed from the present package-lock.json.
pub(crate) fn node_modules() -> Result<()> {
    node_version()?;
    let _single = stamp::lock()?;
    let lockfile = fs::read(shell::root().join("package-lock.json"))?;
    let mut hasher = DefaultHasher::new();
    lockfile.hash(&mut hasher);
    let key = format!("{:016x}", hasher.finish());
    let stamp = shell::root().join("node_modules/.installed-from");
    if fs::read_to_string(&stamp).is_ok_and(|old| old == key) {
        return Ok(());
    }
    println!("installing the JavaScript tools (npm ci)");
    shell::run(&mut shell::npm(&[
        "ci",
        "--no-audit",
        "--no-fund",
        "--loglevel=error",
    ]))?;
    Ok(fs::write(stamp, key)?)
}

fn node_version() -> Result<()> {
    let version = shell::output_of(&mut shell::node(&["--version"]));
    let version = version
        .context("node does not run: install Node 20.19 or newer from https://nodejs.org")?;
    let mut numbers = version
        .trim_start_matches('v')
        .split('.')
        .map_while(|part| part.parse::<u32>().ok());
    let found = (numbers.next().unwrap_or(0), numbers.next().unwrap_or(0));
    if found < MIN_NODE {
        bail!("Node {version} is too old: 20.19 or newer is needed");
    }
    Ok(())
}
