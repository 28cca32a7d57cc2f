//! Panics without their words.
//!
//! A panic ends in a trap: nothing unwinds, and nothing prints the message. So every function that only prepares a
//! message becomes a bare trap here, and so does every function that formats one: nothing else in the module formats
//! anything. The optimiser then drops all that only these functions needed (a quarter of the module). Bounds are checked
//! as before.

use anyhow::Result;
use std::path::Path;
use walrus::{ExportId, FunctionBuilder, FunctionId, FunctionKind, Module};

/// The module with the bodies of all panicking functions replaced.
pub(crate) fn panics(compiled: &Path) -> Result<Module> {
    let mut module = Module::from_file(compiled)?;
    let panicking: Vec<FunctionId> = module
        .funcs
        .iter_local()
        .map(|(id, _)| id)
        .filter(|&id| {
            let name = module.funcs.get(id).name.as_deref();
            name.is_some_and(|name| {
                let path = without_hashes(&format!("{:#}", rustc_demangle::demangle(name)));
                panics_only(&path) || formats(&path)
            })
        })
        .collect();
    for id in panicking {
        trap(&mut module, id);
    }
    Ok(module)
}

/// The names of all exports.
pub(crate) fn exports(bound: &Path) -> Result<Vec<String>> {
    let module = Module::from_file(bound)?;
    Ok(module.exports.iter().map(|e| e.name.clone()).collect())
}

/// The module without some of its exports and all that only these needed.
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

/// `core[c5930c85a12de822]::fmt` is `core::fmt`: names come demangled already, with the hashes of crates.
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

/// Whether a function of the standard library, by its path, never returns.
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

/// Whether a function belongs to the formatting of messages: `core::fmt`, its traits' methods, payloads of panics.
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
