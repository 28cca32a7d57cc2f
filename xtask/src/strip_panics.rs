//! Removes unneeded code from wasm modules: panic messages, and all functions and constants that no selected export
//! reaches.
//!
//! A panic ends in a trap: there is no unwinding, and the message is not printed. So every function that only prepares
//! a message is replaced by a bare trap, and so is every function that formats one; nothing else in the module formats
//! anything. The code that only these functions need is removed too (a quarter of the module), and so are the places in
//! the sources that the messages name. Bounds are still checked.

use crate::liveness::{Linked, Unreached};
use anyhow::{Context, Result};
use std::collections::HashSet;
use std::path::Path;
use walrus::{ExportId, FunctionBuilder, FunctionId, FunctionKind, Module};

/// The module in which functions that panic, and functions that no selected export reaches, are bare traps.
pub(crate) fn reduced(
    compiled: &Path,
    linked: &Linked,
    wanted: impl Fn(&str) -> bool,
) -> Result<Module> {
    let mut module = Module::from_file(compiled)?;
    let functions = in_order(&module);
    let panicking = panicking(&module);
    let roots = linked.exports().iter().filter(|(name, _)| wanted(name));
    let unreached = linked.unreached(roots.map(|&(_, index)| index), &panicking)?;
    for &k in unreached.functions.union(&panicking) {
        trap(
            &mut module,
            *functions.get(k).context("an index of no function")?,
        );
    }
    erase(&mut module, &unreached)?;
    Ok(module)
}

/// The functions in the order of their indices.
fn in_order(module: &Module) -> Vec<FunctionId> {
    module.funcs.iter().map(|f| f.id()).collect()
}

/// The indices of the functions that only panic or format.
pub(crate) fn panicking(module: &Module) -> HashSet<usize> {
    let functions = in_order(module);
    (0..functions.len())
        .filter(|&k| {
            let name = module.funcs.get(functions[k]).name.as_deref();
            name.is_some_and(|name| {
                let path = without_hashes(&format!("{:#}", rustc_demangle::demangle(name)));
                panics_only(&path) || formats(&path)
            })
        })
        .collect()
}

/// Overwrites unreachable constants with zeros, which the optimiser removes, and deletes the relocations, which are no
/// longer valid.
fn erase(module: &mut Module, unreached: &Unreached) -> Result<()> {
    let segments: Vec<_> = module.data.iter().map(|data| data.id()).collect();
    for (segment, bytes) in &unreached.bytes {
        let id = *segments
            .get(*segment)
            .context("an index of no data segment")?;
        let position = module.data.get_mut(id).value.get_mut(bytes.clone());
        position
            .context("a constant outside of its segment")?
            .fill(0);
    }
    for name in ["linking", "reloc.CODE", "reloc.DATA"] {
        module.customs.remove_raw(name);
    }
    Ok(())
}

/// The module without some of its exports and the code that only these exports need.
pub(crate) fn without(bound: &Path, unwanted: impl Fn(&str) -> bool) -> Result<Module> {
    let mut module = Module::from_file(bound)?;
    let exports: Vec<ExportId> = module
        .exports
        .iter()
        .filter(|export| unwanted(&export.name))
        .map(|export| export.id())
        .collect();
    for id in exports {
        module.exports.delete(id);
    }
    walrus::passes::gc::run(&mut module);
    Ok(module)
}

/// Removes crate hashes from a demangled name: `core[c5930c85a12de822]::fmt` becomes `core::fmt`.
fn without_hashes(path: &str) -> String {
    let mut parts = path.split('[');
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |plain, part| match part.split_once(']') {
        Some((hash, rest)) if hash.len() == 16 && hash.chars().all(|c| c.is_ascii_hexdigit()) => {
            plain + rest
        }
        _ => plain + "[" + part,
    })
}

/// Whether the path names a function of the standard library that never returns.
fn panics_only(path: &str) -> bool {
    let of_std = ["core", "alloc", "std", "__rustc"]
        .iter()
        .any(|name| path.starts_with(name));
    let name = path.rsplit("::").next().unwrap_or(path);
    let never = |name: &str| {
        name.starts_with("panic")
            || name.ends_with("_fail")
            || name.ends_with("_failed")
            || [
                "handle_error",
                "handle_alloc_error",
                "capacity_overflow",
                "rust_begin_unwind",
            ]
            .contains(&name)
    };
    of_std && (never(name) || path.contains("::panicking::"))
}

/// Whether a function belongs to message formatting: `core::fmt`, the methods of its traits, panic payloads.
fn formats(path: &str) -> bool {
    ["core::fmt::", "core::num::flt2dec::", "std::panicking::"]
        .iter()
        .any(|part| path.contains(part))
}

fn trap(module: &mut Module, id: FunctionId) {
    let ty = module.types.get(module.funcs.get(id).ty());
    let (params, results) = (ty.params().to_vec(), ty.results().to_vec());
    let mut builder = FunctionBuilder::new(&mut module.types, &params, &results);
    builder.func_body().unreachable();
    let args = params.iter().map(|&ty| module.locals.add(ty)).collect();
    module.funcs.get_mut(id).kind = FunctionKind::Local(builder.local_func(args));
}
