//! Modules that import each other.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use syn::visit::{self, Visit};

type Module = Vec<String>;

/// The modules of a crate, and what each takes from which other.
#[derive(Default)]
struct Graph {
    modules: BTreeSet<Module>,
    /// Names that a module passes on, and the paths where they come from.
    passed_on: BTreeMap<(Module, String), Module>,
    /// Paths that a module mentions.
    mentions: Vec<(Module, Module)>,
    here: Module,
}

/// The modules below a folder that lie on a cycle of imports, each import followed to the module that defines the name.
pub(super) fn modules(folder: &Path) -> Vec<String> {
    let mut graph = Graph::default();
    let files = super::rust_files(folder);
    graph.modules = files.iter().map(|file| module_of(file, folder)).collect();
    for file in &files {
        graph.here = module_of(file, folder);
        let text = std::fs::read_to_string(file).expect("a source file");
        graph.visit_file(&syn::parse_file(&text).expect("Rust"));
    }
    graph.on_cycles()
}

fn module_of(file: &Path, folder: &Path) -> Module {
    let path = file
        .strip_prefix(folder)
        .expect("a file below")
        .with_extension("");
    let mut module: Module = path
        .iter()
        .map(|part| part.to_string_lossy().into_owned())
        .collect();
    if module
        .last()
        .is_some_and(|last| ["mod", "lib", "main"].contains(&last.as_str()))
    {
        module.pop();
    }
    module
}

impl Graph {
    /// An absolute path within the crate, if it is one.
    fn resolve(&self, path: &[String]) -> Option<Module> {
        let mut base = self.here.clone();
        let mut rest = path;
        match rest.first()?.as_str() {
            "crate" => (base, rest) = (Vec::new(), &rest[1..]),
            "self" => rest = &rest[1..],
            "super" => {
                while rest.first().is_some_and(|part| part == "super") {
                    base.pop()?;
                    rest = &rest[1..];
                }
            }
            first => {
                let mut child = base.clone();
                child.push(first.to_owned());
                if !self.modules.contains(&child) {
                    return None;
                }
            }
        }
        base.extend_from_slice(rest);
        Some(base)
    }

    /// The module that defines what a path names.
    fn definer(&self, path: &[String]) -> Module {
        let length = (0..=path.len())
            .rev()
            .find(|&k| self.modules.contains(&path[..k]))
            .unwrap_or(0);
        let module = path[..length].to_vec();
        let Some(name) = path.get(length) else {
            return module;
        };
        match self.passed_on.get(&(module.clone(), name.clone())) {
            Some(source) if source[..] != path[..] => self.definer(source),
            _ => module,
        }
    }

    fn on_cycles(&self) -> Vec<String> {
        let mut edges: BTreeMap<&Module, BTreeSet<Module>> = BTreeMap::new();
        for (from, path) in &self.mentions {
            let to = self.definer(path);
            if to != *from {
                edges.entry(from).or_default().insert(to);
            }
        }
        let reaches = |start: &Module| {
            let mut seen = BTreeSet::new();
            let mut next: Vec<&Module> = edges.get(start).into_iter().flatten().collect();
            while let Some(module) = next.pop() {
                if seen.insert(module) {
                    next.extend(edges.get(module).into_iter().flatten());
                }
            }
            seen.contains(start)
        };
        self.modules
            .iter()
            .filter(|module| reaches(module))
            .map(|module| module.join("::"))
            .collect()
    }

    fn import(&mut self, tree: &syn::UseTree, mut path: Vec<String>, is_public: bool) {
        match tree {
            syn::UseTree::Path(part) => {
                path.push(part.ident.to_string());
                self.import(&part.tree, path, is_public);
            }
            syn::UseTree::Group(group) => {
                for tree in &group.items {
                    self.import(tree, path.clone(), is_public);
                }
            }
            syn::UseTree::Name(name) => self.imported(path, &name.ident, &name.ident, is_public),
            syn::UseTree::Rename(name) => self.imported(path, &name.ident, &name.rename, is_public),
            syn::UseTree::Glob(_) => self.mention(&path),
        }
    }

    fn imported(
        &mut self,
        mut path: Vec<String>,
        name: &syn::Ident,
        known_as: &syn::Ident,
        is_public: bool,
    ) {
        if name != "self" {
            path.push(name.to_string());
        }
        if is_public {
            if let Some(source) = self.resolve(&path) {
                self.passed_on
                    .insert((self.here.clone(), known_as.to_string()), source);
            }
        } else {
            self.mention(&path);
        }
    }

    fn mention(&mut self, path: &[String]) {
        if let Some(path) = self.resolve(path) {
            self.mentions.push((self.here.clone(), path));
        }
    }
}

impl<'a> Visit<'a> for Graph {
    fn visit_item_use(&mut self, item: &'a syn::ItemUse) {
        self.import(
            &item.tree,
            Vec::new(),
            !matches!(item.vis, syn::Visibility::Inherited),
        );
    }

    fn visit_path(&mut self, path: &'a syn::Path) {
        if path.segments.len() > 1 {
            let parts: Vec<String> = path
                .segments
                .iter()
                .map(|part| part.ident.to_string())
                .collect();
            self.mention(&parts);
        }
        visit::visit_path(self, path);
    }
}
