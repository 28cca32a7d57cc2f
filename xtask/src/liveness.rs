//! Liveness analysis of a wasm module: the functions and constants that a set of exports needs, exactly.
//!
//! The linker leaves its relocations in the module (`--emit-relocs`): the positions in functions and constants that
//! refer to other ones. They give everything that is reachable from a set of exports, also through tables of functions
//! and of constants, which an optimiser must keep entirely. Format: tool-conventions of WebAssembly, Linking.md.

use anyhow::{Context, Result, bail};
use serde::Serialize;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::ops::Range;
use wasmparser::{
    ConstExpr, DataKind, Element, ElementItems, ElementKind, ExternalKind, KnownCustom, Linking,
    LinkingSectionReader, Operator, Parser, Payload, RelocSectionReader, RelocationEntry,
    RelocationType, SymbolInfo, TypeRef,
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
    /// The references, sorted: the position in the file, the index of the symbol, and whether a function is referred to by
    /// its index in the table of functions.
    names: Vec<(usize, usize, bool)>,
    /// The addresses of the data segments.
    addresses: Vec<usize>,
    /// The index of each function in the table of functions.
    slots: HashMap<usize, usize>,
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

/// What an export needs besides functions that are called by name: ranges of addresses, ascending and without overlaps, and
/// indices in the table of functions.
#[derive(Default, Serialize)]
pub(crate) struct Needs {
    data: Vec<usize>,
    table: Vec<usize>,
}

/// The needs of all exports, and the addresses of all constants; `custom/cut.js` uses them.
#[derive(Default, Serialize)]
pub(crate) struct ModuleNeeds {
    data: Vec<usize>,
    exports: BTreeMap<String, Needs>,
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
                Payload::ElementSection(elements) => {
                    for element in elements {
                        linked.read_elements(element?)?;
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
                        let DataKind::Active { offset_expr, .. } = &segment.kind else {
                            bail!("expected data segments with an address");
                        };
                        linked.addresses.push(constant(offset_expr)?);
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

    fn read_elements(&mut self, element: Element) -> Result<()> {
        let ElementKind::Active { offset_expr, .. } = element.kind else {
            bail!("expected a table of functions that is filled at the start");
        };
        let ElementItems::Functions(functions) = element.items else {
            bail!("expected a table of functions");
        };
        let first = constant(&offset_expr)?;
        for (k, function) in functions.into_iter().enumerate() {
            self.slots.insert(function? as usize, first + k);
        }
        Ok(())
    }

    fn read_relocations(&mut self, section: &RelocSectionReader, start: usize) -> Result<()> {
        use RelocationType::{
            GlobalIndexI32, GlobalIndexLeb, TableIndexI32, TableIndexSleb, TableNumberLeb,
            TypeIndexLeb,
        };
        for entry in section.entries() {
            let RelocationEntry {
                ty, offset, index, ..
            } = entry?;
            // These relocations refer to no symbol, or to one without a body.
            if !matches!(
                ty,
                TypeIndexLeb | GlobalIndexLeb | GlobalIndexI32 | TableNumberLeb
            ) {
                let in_table = matches!(ty, TableIndexI32 | TableIndexSleb);
                self.names
                    .push((start + offset as usize, index as usize, in_table));
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
            let first = self.names.partition_point(|&(at, ..)| at < position.start);
            let &(at, symbol, _) = self.names.get(first)?;
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
        Ok(self.rest(&self.reached(roots, empty)?.0))
    }

    /// The needs of each export, if the bodies of the functions in `empty` are removed. The optimiser removes, merges and
    /// inlines functions, but it changes neither addresses nor indices in the table of functions, and the code of an export
    /// contains no others than in the linked module.
    ///
    /// `public_name` is the name that wasm-bindgen gives an export; none for those that it removes.
    pub(crate) fn needs(
        &self,
        empty: &HashSet<usize>,
        public_name: impl Fn(&str) -> Option<String>,
    ) -> Result<ModuleNeeds> {
        let mut needs = ModuleNeeds {
            data: self.ranges(self.symbols.iter().flatten())?,
            ..ModuleNeeds::default()
        };
        for (name, root) in &self.exports {
            let Some(name) = public_name(name) else {
                continue;
            };
            let (items, functions) = self.reached(std::iter::once(*root), empty)?;
            let mut table: Vec<usize> = functions
                .iter()
                .map(|function| self.slots.get(function).copied())
                .collect::<Option<_>>()
                .context("a function that is not in the table")?;
            table.sort_unstable();
            let data = self.ranges(items.iter())?;
            needs.exports.insert(name, Needs { data, table });
        }
        Ok(needs)
    }

    /// The addresses of constants: start and length of each range.
    fn ranges<'a>(&self, items: impl Iterator<Item = &'a Item>) -> Result<Vec<usize>> {
        let mut ranges: Vec<Range<usize>> = Vec::new();
        for item in items {
            if let Item::Bytes(segment, bytes) = item {
                let address = self
                    .addresses
                    .get(*segment)
                    .context("an index of no segment")?;
                ranges.push(address + bytes.start..address + bytes.end);
            }
        }
        ranges.sort_unstable_by_key(|range| (range.start, range.end));
        let mut merged: Vec<Range<usize>> = Vec::new();
        for range in ranges {
            match merged.last_mut() {
                Some(last) if range.start <= last.end => last.end = last.end.max(range.end),
                _ => merged.push(range),
            }
        }
        Ok(merged
            .into_iter()
            .flat_map(|range| [range.start, range.len()])
            .collect())
    }

    /// The items that are reached from the roots, and the functions among them that are referred to by their index in the
    /// table.
    fn reached(
        &self,
        roots: impl Iterator<Item = usize>,
        empty: &HashSet<usize>,
    ) -> Result<(HashSet<Item>, HashSet<usize>)> {
        let names = &self.names;
        let mut waiting: Vec<Item> = roots.chain(self.start).map(Item::Function).collect();
        let mut reached: HashSet<Item> = waiting.iter().cloned().collect();
        let mut in_table = HashSet::new();
        while let Some(item) = waiting.pop() {
            if matches!(&item, Item::Function(index) if empty.contains(index)) {
                continue;
            }
            let Some(position) = self.position(&item) else {
                continue; // an imported function
            };
            let from = names.partition_point(|&(at, ..)| at < position.start);
            for &(_, symbol, by_slot) in names[from..]
                .iter()
                .take_while(|&&(at, ..)| at < position.end)
            {
                let named = self
                    .symbols
                    .get(symbol)
                    .context("a relocation of no symbol")?;
                if let Some(named) = named.clone()
                    && !self.locations.contains(&named)
                {
                    if let Item::Function(index) = named
                        && by_slot
                    {
                        in_table.insert(index);
                    }
                    if reached.insert(named.clone()) {
                        waiting.push(named);
                    }
                }
            }
        }
        Ok((reached, in_table))
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

/// The number of a constant expression.
fn constant(expression: &ConstExpr) -> Result<usize> {
    match expression.get_operators_reader().read()? {
        Operator::I32Const { value } => Ok(usize::try_from(value)?),
        _ => bail!("expected a constant"),
    }
}
