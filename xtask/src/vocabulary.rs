//! Counts what a reader stumbles over in the Rust sources: private words in names, long functions, cycles of modules.
//!
//! Temporary: the counts may only fall (see `LIMITS`). When they are zero, this module goes.

mod cycles;

use proc_macro2::{TokenStream, TokenTree};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

/// Words with a meaning of their own in this project, which appear in identifiers.
const PRIVATE_WORDS: &[&str] = &[
    "alone", "bends", "bent", "chain", "chains", "cutter", "doors", "dusted", "facing", "facts",
    "filler", "gather", "given", "hands", "lattice", "least", "lens", "made", "meet", "meeting",
    "meetings", "most", "paper", "place", "places", "promise", "put", "rail", "railway", "ruler",
    "scaffold", "settle", "settled", "snip", "told", "trail", "truth", "way", "ways", "wild",
    "zone", "zones",
];

/// The folders whose sources are read.
const FOLDERS: [&str; 6] = [
    "src",
    "kernels",
    "xtask/src",
    "tests",
    "benches/native",
    "examples",
];

/// The longest function, in lines.
const LONGEST_FUNCTION: usize = 60;

/// What was counted last. A change may lower a count; then it lowers the number here, too.
const LIMITS: Counts = Counts {
    private_words: 1,
    long_functions: 0,
    modules_in_cycles: 49,
};

#[derive(Debug)]
struct Counts {
    /// Pairs of a file and an identifier with a private word.
    private_words: usize,
    /// Functions above [`LONGEST_FUNCTION`].
    long_functions: usize,
    /// Modules of the crates that lie on a cycle of imports.
    modules_in_cycles: usize,
}

#[test]
fn counts_only_fall() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let files: Vec<PathBuf> = FOLDERS
        .iter()
        .flat_map(|folder| rust_files(&root.join(folder)))
        .collect();
    let mut found = Findings::default();
    for file in &files {
        found.read(file, &root);
    }
    for crate_root in ["src", "kernels/src", "xtask/src"] {
        found.cycles.extend(cycles::modules(&root.join(crate_root)));
    }
    let counts = Counts {
        private_words: found.words.len(),
        long_functions: found.functions.len(),
        modules_in_cycles: found.cycles.len(),
    };
    let pairs = [
        (
            counts.private_words,
            LIMITS.private_words,
            format!("{:#?}", found.words),
        ),
        (
            counts.long_functions,
            LIMITS.long_functions,
            format!("{:#?}", found.functions),
        ),
        (
            counts.modules_in_cycles,
            LIMITS.modules_in_cycles,
            format!("{:#?}", found.cycles),
        ),
    ];
    for (count, limit, list) in pairs {
        assert!(count <= limit, "{count} instead of at most {limit}: {list}");
        assert!(
            count == limit,
            "{count} is less than {limit}: lower LIMITS to {counts:?}"
        );
    }
}

#[derive(Default)]
struct Findings {
    words: BTreeSet<(String, String)>,
    functions: Vec<String>,
    cycles: Vec<String>,
    file: String,
}

impl Findings {
    fn read(&mut self, path: &Path, root: &Path) {
        let text = std::fs::read_to_string(path).expect("a source file");
        self.file = path
            .strip_prefix(root)
            .unwrap_or(path)
            .display()
            .to_string();
        self.identifiers(TokenStream::from_str(&text).expect("Rust"));
        self.visit_file(&syn::parse_file(&text).expect("Rust"));
    }

    fn identifiers(&mut self, tokens: TokenStream) {
        for token in tokens {
            match token {
                TokenTree::Group(group) => self.identifiers(group.stream()),
                TokenTree::Ident(ident) if has_private_word(&ident.to_string()) => {
                    self.words.insert((self.file.clone(), ident.to_string()));
                }
                _ => {}
            }
        }
    }

    fn function(&mut self, name: &syn::Ident, whole: impl Spanned) {
        let span = whole.span();
        let lines = span.end().line - span.start().line + 1;
        if lines > LONGEST_FUNCTION {
            self.functions
                .push(format!("{}: {name}, {lines} lines", self.file));
        }
    }
}

impl<'a> Visit<'a> for Findings {
    fn visit_item_fn(&mut self, item: &'a syn::ItemFn) {
        self.function(&item.sig.ident, &item.block);
        visit::visit_item_fn(self, item);
    }

    fn visit_impl_item_fn(&mut self, item: &'a syn::ImplItemFn) {
        self.function(&item.sig.ident, &item.block);
        visit::visit_impl_item_fn(self, item);
    }
}

/// Whether a part of a name in snake case or camel case is a private word; `Iterator::chain` is not ours.
fn has_private_word(name: &str) -> bool {
    if name == "chain" {
        return false;
    }
    let mut words = vec![String::new()];
    for c in name.chars() {
        if c == '_' || c.is_ascii_uppercase() && name.contains(char::is_lowercase) {
            words.push(String::new());
        }
        if c != '_' {
            words
                .last_mut()
                .expect("a word")
                .push(c.to_ascii_lowercase());
        }
    }
    words
        .iter()
        .any(|word| PRIVATE_WORDS.contains(&word.as_str()))
}

/// All Rust sources in a folder and below.
fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path());
    let mut files: Vec<PathBuf> = entries
        .flat_map(|path| match path.is_dir() {
            true if path.file_name().is_some_and(|name| name == "target") => Vec::new(),
            true => rust_files(&path),
            false if path.extension().is_some_and(|extension| extension == "rs") => vec![path],
            false => Vec::new(),
        })
        .collect();
    files.sort();
    files
}
