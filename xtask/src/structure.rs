//! The structure of the crate: no file imports another one that imports it, directly or indirectly, and only the bindings know
//! of wasm. Re-exports are followed to
//! the file that defines the item, so that a `mod.rs` counts with what it uses, not with what it re-exports.

use crate::shell;
use crate::shell::files_below;
use anyhow::{Result, ensure};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The path of a module, as `curve`, `flatten`.
type Module = Vec<String>;

/// The paths that a file imports or names, and those that it re-exports, each with the segments `crate`, `super` or `self`.
#[derive(Default)]
struct Paths {
    used: Vec<Vec<String>>,
    exported: Vec<Vec<String>>,
}

/// What no source has outside the bindings in `src/wasm`: conditions on wasm, modules in other folders, excuses for them.
const FORBIDDEN: [&str; 4] = [
    "target_family = \"wasm\"",
    "feature = \"wasm\"",
    "#[path",
    "unreachable_pub",
];

/// The line of `src/lib.rs` that declares the bindings; the package of the bindings has the feature, the crate has not.
const BINDINGS: &str = "#[cfg(feature = \"wasm\")]\nmod wasm;\n";

/// Fails with the cycles of the crate and of its kernels, and with conditions on wasm. The bindings in `src/wasm` are a
/// package of their own.
pub(crate) fn check() -> Result<()> {
    for folder in ["src", "kernels/src"] {
        let root = shell::root().join(folder);
        let mut files = BTreeMap::new();
        for path in files_below(&root) {
            let relative = path.strip_prefix(&root)?;
            if relative.extension().is_some_and(|ending| ending == "rs")
                && !relative.starts_with("wasm")
            {
                let text = fs::read_to_string(&path)?;
                let found = forbidden(&text);
                ensure!(found.is_none(), "{}: {found:?}", path.display());
                files.insert(module_of(relative), paths(&text));
            }
        }
        let cycles = cycles(&graph(&files));
        let text: Vec<String> = cycles.iter().map(|cycle| cycle.join(" → ")).collect();
        ensure!(
            cycles.is_empty(),
            "files that import each other:\n  {}",
            text.join("\n  ")
        );
        println!("{folder}: {} files without a cycle", files.len());
    }
    Ok(())
}

fn forbidden(source: &str) -> Option<&'static str> {
    let source = source.replacen(BINDINGS, "", 1);
    FORBIDDEN.into_iter().find(|text| source.contains(text))
}

fn module_of(file: &Path) -> Module {
    let names = file.with_extension("");
    let names = names.iter().map(|name| name.to_string_lossy().into_owned());
    let mut module: Module = names.collect();
    module.pop_if(|last| last == "mod" || last == "lib");
    module
}

/// The paths in a source text, without its comments and its unit tests.
fn paths(source: &str) -> Paths {
    let code = source.split("#[cfg(test)]\nmod ").next().unwrap_or(source);
    let lines = code
        .lines()
        .map(|line| line.split("//").next().unwrap_or(line));
    let code: String = lines.flat_map(|line| [line, "\n"]).collect();
    let mut paths = Paths::default();
    let mut rest = code.as_str();
    let mut others = String::new();
    while let Some((before, after)) = rest.split_once("use ") {
        let line = before.rsplit('\n').next().unwrap_or(before).trim();
        let is_import = line.is_empty() || line.starts_with("pub");
        others.push_str(before);
        rest = after;
        if let Some((tree, after)) = after.split_once(';').filter(|_| is_import) {
            let list = if line.is_empty() {
                &mut paths.used
            } else {
                &mut paths.exported
            };
            expand(&[], tree, list);
            rest = after;
        }
    }
    others.push_str(rest);
    let is_path = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    for word in others.split(|c| !is_path(c)) {
        if word.starts_with("crate::") || word.starts_with("super::") {
            paths
                .used
                .push(word.split("::").map(str::to_owned).collect());
        }
    }
    paths
}

/// Expands `a::{b, c::{d, e as f}}`.
fn expand(prefix: &[String], tree: &str, paths: &mut Vec<Vec<String>>) {
    let tree = tree.trim();
    let Some((first, list)) = tree.split_once('{') else {
        let name = tree.split(" as ").next().unwrap_or(tree);
        let names = name.split("::").map(|name| name.trim().to_owned());
        paths.push(prefix.iter().cloned().chain(names).collect());
        return;
    };
    let names = first.split("::").map(|name| name.trim().to_owned());
    let inner: Vec<String> = prefix
        .iter()
        .cloned()
        .chain(names.filter(|name| !name.is_empty()))
        .collect();
    let (mut depth, mut start) = (0, 0);
    let list = list.trim_end().trim_end_matches('}');
    for (at, c) in list.char_indices().chain([(list.len(), ',')]) {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                if !list[start..at].trim().is_empty() {
                    expand(&inner, &list[start..at], paths);
                }
                start = at + 1;
            }
            _ => {}
        }
    }
}

/// The path from the root of the crate; `None` for a path into another crate.
fn absolute(
    module: &Module,
    path: &[String],
    files: &BTreeMap<Module, Paths>,
) -> Option<Vec<String>> {
    let mut base = module.clone();
    let mut rest = path;
    match path.first()?.as_str() {
        "crate" => return Some(path[1..].to_vec()),
        "self" => rest = &path[1..],
        "super" => {
            while let Some(("super", after)) = rest.split_first().map(|(a, b)| (a.as_str(), b)) {
                base.pop()?;
                rest = after;
            }
        }
        child => {
            let inner: Module = base.iter().cloned().chain([child.to_owned()]).collect();
            files.get(&inner)?;
        }
    }
    base.extend_from_slice(rest);
    Some(base)
}

/// The file that defines the item of a path. `depth` limits the number of re-exports.
fn resolve(path: &[String], files: &BTreeMap<Module, Paths>, depth: usize) -> Option<Module> {
    let length = (0..=path.len())
        .rev()
        .find(|&n| files.contains_key(&path[..n]))?;
    let (module, rest) = (path[..length].to_vec(), &path[length..]);
    let exports = rest
        .first()
        .filter(|_| depth > 0)
        .map(|item| (item, &files[&module].exported));
    if let Some((item, exported)) = exports {
        for export in exported {
            if export.last() == Some(item) {
                // An item of another crate is in no file.
                let mut target = absolute(&module, export, files)?;
                target.extend_from_slice(&rest[1..]);
                return resolve(&target, files, depth - 1);
            }
        }
    }
    Some(module)
}

/// The files that each file imports.
fn graph(files: &BTreeMap<Module, Paths>) -> BTreeMap<Module, BTreeSet<Module>> {
    let mut graph = BTreeMap::new();
    for (module, paths) in files {
        let targets = paths.used.iter().filter_map(|path| {
            let mut path = absolute(module, path, files)?;
            path.pop_if(|last| last == "*" || last == "self");
            resolve(&path, files, 6)
        });
        graph.insert(
            module.clone(),
            targets.filter(|target| target != module).collect(),
        );
    }
    graph
}

/// One cycle through each file that is in one, each found once.
fn cycles(graph: &BTreeMap<Module, BTreeSet<Module>>) -> Vec<Vec<String>> {
    let mut found: Vec<Vec<String>> = Vec::new();
    for start in graph.keys() {
        // The shortest way from the file back to it, by breadth-first search.
        let mut before: BTreeMap<&Module, &Module> = BTreeMap::new();
        let mut front = vec![start];
        while !front.is_empty() && !before.contains_key(start) {
            let mut next = Vec::new();
            for module in front {
                for target in &graph[module] {
                    if !before.contains_key(target) {
                        before.insert(target, module);
                        next.push(target);
                    }
                }
            }
            front = next;
        }
        let Some(&last) = before.get(start) else {
            continue;
        };
        let (mut way, mut at) = (vec![start.join("::")], last);
        while at != start {
            way.insert(0, at.join("::"));
            at = before[at];
        }
        way.insert(0, start.join("::"));
        let is_known = |known: &Vec<String>| known[1..].iter().all(|name| way.contains(name));
        if !found.iter().any(is_known) {
            found.push(way);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn module(path: &str) -> Module {
        path.split("::")
            .filter(|name| !name.is_empty())
            .map(str::to_owned)
            .collect()
    }

    fn cycles_of(sources: &[(&str, &str)]) -> Vec<String> {
        let files = sources
            .iter()
            .map(|&(name, source)| (module(name), paths(source)));
        let cycles = cycles(&graph(&files.collect()));
        cycles.iter().map(|cycle| cycle.join(" → ")).collect()
    }

    #[test]
    fn cycles_are_found_through_re_exports_and_paths_in_code() {
        let root = ("", "");
        let parent = ("a", "pub mod b;\npub(crate) use b::Item;\n");
        let user = ("c", "use crate::a::{self, Item};\n");
        assert_eq!(cycles_of(&[root, parent, ("a::b", ""), user]), [""; 0]);
        let back = ("a::b", "fn f() { super::super::c::g() }\n");
        assert_eq!(cycles_of(&[root, parent, back, user]), ["a::b → c → a::b"]);
        let comment = (
            "a::b",
            "// use crate::c;\n#[cfg(test)]\nmod tests { use crate::c; }\n",
        );
        assert_eq!(cycles_of(&[root, parent, comment, user]), [""; 0]);
        let other_crate = ("a", "mod b;\npub(crate) use kernels::d;\nuse b::B;\n");
        let user_of_it = ("a::b", "use super::d::D;\n");
        assert_eq!(cycles_of(&[root, other_crate, user_of_it]), [""; 0]);
        let nested = ("a::b", "use crate::{\n    a,\n    c::{d, e as f},\n};\n");
        assert_eq!(
            cycles_of(&[root, parent, nested, user]),
            ["a::b → c → a::b"]
        );
    }

    #[test]
    fn only_the_declaration_of_the_bindings_depends_on_wasm() {
        assert_eq!(forbidden(BINDINGS), None);
        for source in [
            format!("{BINDINGS}{BINDINGS}"),
            "if cfg!(not(target_family = \"wasm\")) {}".to_owned(),
            "#[path = \"../b.rs\"]\nmod b;".to_owned(),
            "#![allow(unreachable_pub)]".to_owned(),
        ] {
            assert!(forbidden(&source).is_some(), "{source}");
        }
    }
}
