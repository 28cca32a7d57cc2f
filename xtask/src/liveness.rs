//! Liveness analysis of a wasm module: the functions and constants that a set of exports needs, exactly.
//!
//! The linker leaves its relocations in the module (`--emit-relocs`): the positions in functions and constants that
//! refer to other ones. They give everything that is reachable from a set of exports, also through tables of functions
//! and of constants, which an optimiser must keep entirely. Format: tool-conventions of WebAssembly, Linking.md.

use anyhow::{Context, Result, bail};
use std::collections::HashSet;
use std::ops::Range;
use wasmparser::{
    ExternalKind, KnownCustom, Linking, LinkingSectionReader, Parser, Payload, RelocSectionReader,
    RelocationEntry, RelocationType, SymbolInfo, TypeRef,
};

/// A function by its index, or a byte range of a data segment.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Item {
    Function(usize),
    Bytes(usize, Range<usize>),
}

/// The size of a `core::panic::Location`: the address and the length of the file's name, the line, the column.
const LOCATION_SIZE: usize = 16;

/// A linked module that still has its relocations.
#[derive(Default)]
pub(crate) struct Linked {
    /// The item of each symbol; `None` for a symbol that is neither a function nor data.
    symbols: Vec<Option<Item>>,
    imported: usize,
    /// The positions of the local functions and of the data segments in the file.
    functions: Vec<Range<usize>>,
    segments: Vec<Range<usize>>,
    /// The references, sorted: the position in the file and the index of the symbol.
    names: Vec<(usize, usize)>,
    /// The constants of type `core::panic::Location`, which only messages of panics read.
    locations: HashSet<Item>,
    /// The functions that are exported.
    exports: Vec<(String, usize)>,
    start: Option<usize>,
}

/// The unreachable items: functions by their index, and byte ranges of data segments.
#[derive(Default)]
pub(crate) struct Unreached {
    pub(crate) functions: HashSet<usize>,
    pub(crate) bytes: Vec<(usize, Range<usize>)>,
}

impl Linked {
    pub(crate) fn read(wasm: &[u8]) -> Result<Self> {
        let mut linked = Self::default();
        let (mut code, mut data) = (0, 0);
        for payload in Parser::new(0).parse_all(wasm) {
            match payload? {
                Payload::ImportSection(imports) => {
                    for import in imports.into_imports() {
                        let function = matches!(import?.ty, TypeRef::Func(_));
                        linked.imported += usize::from(function);
                    }
                }
                Payload::ExportSection(exports) => {
                    for export in exports {
                        let export = export?;
                        if export.kind == ExternalKind::Func {
                            let name = export.name.to_owned();
                            linked.exports.push((name, export.index as usize));
                        }
                    }
                }
                Payload::StartSection { func, .. } => linked.start = Some(func as usize),
                Payload::CodeSectionStart { range, .. } => code = range.start,
                Payload::CodeSectionEntry(body) => linked.functions.push(body.range()),
                Payload::DataSection(segments) => {
                    data = segments.range().start;
                    for segment in segments {
                        let segment = segment?;
                        let end = segment.range.end;
                        linked.segments.push(end - segment.data.len()..end);
                    }
                }
                Payload::CustomSection(section) => match section.as_known() {
                    KnownCustom::Linking(linking) => linked.read_symbols(&linking)?,
                    KnownCustom::Reloc(relocations) => {
                        let start = match section.name() {
                            "reloc.CODE" => code,
                            "reloc.DATA" => data,
                            _ => continue,
                        };
                        linked.read_relocations(&relocations, start)?;
                    }
                    _ => {}
                },
                _ => {}
            }
        }
        if linked.symbols.is_empty() || linked.names.is_empty() {
            bail!("the module has no relocations: was it linked with --emit-relocs?");
        }
        linked.names.sort_unstable();
        linked.locations = linked.find_locations(wasm);
        Ok(linked)
    }

    fn read_symbols(&mut self, linking: &LinkingSectionReader) -> Result<()> {
        for part in linking.subsections() {
            let Linking::SymbolTable(symbols) = part? else {
                continue;
            };
            for symbol in symbols {
                self.symbols.push(match symbol? {
                    SymbolInfo::Func { index, .. } => Some(Item::Function(index as usize)),
                    SymbolInfo::Data {
                        symbol: Some(position),
                        ..
                    } => {
                        let from = position.offset as usize;
                        let bytes = from..from + position.size as usize;
                        Some(Item::Bytes(position.index as usize, bytes))
                    }
                    _ => None,
                });
            }
        }
        Ok(())
    }

    fn read_relocations(&mut self, section: &RelocSectionReader, start: usize) -> Result<()> {
        use RelocationType::{GlobalIndexI32, GlobalIndexLeb, TableNumberLeb, TypeIndexLeb};
        for entry in section.entries() {
            let RelocationEntry {
                ty, offset, index, ..
            } = entry?;
            // These relocations refer to no symbol, or to one without a body.
            if !matches!(
                ty,
                TypeIndexLeb | GlobalIndexLeb | GlobalIndexI32 | TableNumberLeb
            ) {
                self.names.push((start + offset as usize, index as usize));
            }
        }
        Ok(())
    }

    /// The constants that have the size of a `Location` and start with the address of the name of a Rust source.
    fn find_locations(&self, wasm: &[u8]) -> HashSet<Item> {
        let is_source_name = |symbol: usize| {
            let item = self.symbols.get(symbol)?.as_ref()?;
            let name = wasm.get(self.position(item)?)?;
            let is_data = matches!(item, Item::Bytes(..));
            Some(is_data && name.strip_suffix(b"\0").unwrap_or(name).ends_with(b".rs"))
        };
        let is_location = |item: &&Item| {
            let position = self.position(item)?;
            let first = self.names.partition_point(|&(at, _)| at < position.start);
            let &(at, symbol) = self.names.get(first)?;
            let has_size = matches!(item, Item::Bytes(_, bytes) if bytes.len() == LOCATION_SIZE);
            Some(has_size && at == position.start && is_source_name(symbol)?)
        };
        let items = self.symbols.iter().flatten();
        items
            .filter(|item| is_location(item).unwrap_or(false))
            .cloned()
            .collect()
    }

    /// The exported functions, by name and index.
    pub(crate) fn exports(&self) -> &[(String, usize)] {
        &self.exports
    }

    /// The items that cannot be reached from the roots, if the bodies of the functions in `empty` are removed.
    pub(crate) fn unreached(
        &self,
        roots: impl Iterator<Item = usize>,
        empty: &HashSet<usize>,
    ) -> Result<Unreached> {
        let names = &self.names;
        let mut waiting: Vec<Item> = roots.chain(self.start).map(Item::Function).collect();
        let mut reached: HashSet<Item> = waiting.iter().cloned().collect();
        while let Some(item) = waiting.pop() {
            if matches!(&item, Item::Function(index) if empty.contains(index)) {
                continue;
            }
            let Some(position) = self.position(&item) else {
                continue; // an imported function
            };
            let from = names.partition_point(|&(at, _)| at < position.start);
            for &(_, symbol) in names[from..]
                .iter()
                .take_while(|&&(at, _)| at < position.end)
            {
                let named = self
                    .symbols
                    .get(symbol)
                    .context("a relocation of no symbol")?;
                if let Some(named) = named.clone()
                    && !self.locations.contains(&named)
                    && reached.insert(named.clone())
                {
                    waiting.push(named);
                }
            }
        }
        Ok(self.rest(&reached))
    }

    /// The position of an item's bytes in the file.
    fn position(&self, item: &Item) -> Option<Range<usize>> {
        match item {
            Item::Function(index) => {
                let local = index.checked_sub(self.imported)?;
                self.functions.get(local).cloned()
            }
            Item::Bytes(segment, bytes) => {
                let start = self.segments.get(*segment)?.start;
                Some(start + bytes.start..start + bytes.end)
            }
        }
    }

    fn rest(&self, reached: &HashSet<Item>) -> Unreached {
        let mut rest = Unreached::default();
        let all = self.imported..self.imported + self.functions.len();
        rest.functions
            .extend(all.filter(|&k| !reached.contains(&Item::Function(k))));
        for symbol in self.symbols.iter().flatten() {
            if let Item::Bytes(segment, bytes) = symbol
                && !reached.contains(symbol)
                && !reached.iter().any(|other| shares(other, *segment, bytes))
            {
                rest.bytes.push((*segment, bytes.clone()));
            }
        }
        rest
    }
}

/// Whether a reached item contains some of these bytes; constants may share bytes.
fn shares(item: &Item, segment: usize, bytes: &Range<usize>) -> bool {
    matches!(item, Item::Bytes(k, other)
        if *k == segment && other.start < bytes.end && bytes.start < other.end)
}
