//! Size of the image, by its symbol and debug tables.

use std::borrow::Cow;
use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::Path;

use bica::Tree;
use bica_player::Forward;
use gimli::constants as dwarf_names;
use gimli::{DW_AT_byte_size, DW_AT_name, EndianSlice, LittleEndian};
use object::{Object, ObjectSection, ObjectSymbol, SectionFlags};

use crate::limits::{self, Limits};
use crate::session;

/// First address of the board's memory.
const MEMORY_START: u64 = 0x2000_0000;
/// Flag of a section that occupies memory at run time (ELF, `SHF_ALLOC`).
const SHF_ALLOC: u64 = 2;
/// Number of the largest symbols that are printed.
const LARGEST: usize = 10;

/// Flash and static memory of an image, bytes.
pub(crate) struct Sections {
    pub(crate) flash: u64,
    pub(crate) memory: u64,
}

/// Adds up the sections of an image. Initialised memory (`.data`) occupies flash too.
pub(crate) fn sections(image: &Path) -> Result<Sections, Box<dyn Error>> {
    let bytes = fs::read(image)?;
    let file = object::File::parse(&*bytes)?;
    let mut sum = Sections { flash: 0, memory: 0 };
    for section in file.sections() {
        let SectionFlags::Elf { sh_flags } = section.flags() else { continue };
        if sh_flags & SHF_ALLOC == 0 {
            continue;
        }
        let in_memory = section.address() >= MEMORY_START;
        sum.memory += if in_memory { section.size() } else { 0 };
        sum.flash += if !in_memory || section.name()? == ".data" { section.size() } else { 0 };
    }
    Ok(sum)
}

/// Prints flash, memory and stack with their limits, each component's memory and the largest symbols.
pub(crate) fn print(image: &Path) -> Result<(), Box<dyn Error>> {
    let frame = session::frame(image)?;
    let played = crate::game::play(image, 0, frame)?;
    limits::check(&sections(image)?, &played, &Limits::of(frame, true))?;
    let sizes = structures(image)?;
    println!("\nstatic memory of each component, bytes");
    for node in Forward::GRAPH.nodes {
        let size = sizes.get(node.name).map_or_else(|| "?".to_owned(), u64::to_string);
        println!("{size:>9}  {}", node.name);
    }
    println!("\nlargest symbols, bytes");
    for (size, place, name) in largest(image)? {
        println!("{size:>9}  {place:<6}  {name}");
    }
    Ok(())
}

/// A symbol: size in bytes, kind of memory, and demangled name.
type Symbol = (u64, &'static str, String);

/// Returns the largest symbols.
fn largest(image: &Path) -> Result<Vec<Symbol>, Box<dyn Error>> {
    let bytes = fs::read(image)?;
    let file = object::File::parse(&*bytes)?;
    let mut symbols: Vec<_> = file.symbols().map(|symbol| (symbol.size(), symbol.address(), symbol.name())).collect();
    symbols.sort_by_key(|symbol| Reverse(symbol.0));
    let symbols = symbols.into_iter().take(LARGEST).map(|(size, address, name)| {
        let place = if address >= MEMORY_START { "memory" } else { "flash" };
        Ok((size, place, format!("{:#}", rustc_demangle::demangle(name?))))
    });
    symbols.collect()
}

/// Returns the sizes of the player's types by their names.
fn structures(image: &Path) -> Result<BTreeMap<String, u64>, Box<dyn Error>> {
    let bytes = fs::read(image)?;
    let file = object::File::parse(&*bytes)?;
    let load = |id: gimli::SectionId| -> Result<Cow<'_, [u8]>, object::Error> {
        file.section_by_name(id.name()).map_or(Ok(Cow::default()), |section| section.uncompressed_data())
    };
    let sections = gimli::DwarfSections::load(load)?;
    let dwarf = sections.borrow(|section| EndianSlice::new(section, LittleEndian));
    let mut sizes = BTreeMap::new();
    let mut headers = dwarf.units();
    while let Some(header) = headers.next()? {
        let unit = dwarf.unit(header)?;
        let (mut entries, mut depth, mut path) = (unit.entries(), 0, Vec::new());
        while let Some((change, entry)) = entries.next_dfs()? {
            depth += change;
            path.retain(|(at, _)| *at < depth);
            let Some(name) = entry.attr_value(DW_AT_name)? else { continue };
            let name = dwarf.attr_string(&unit, name)?.to_string_lossy().into_owned();
            let is_player = path.first().is_some_and(|(_, top)| top == "bica_player");
            match (entry.tag(), entry.attr_value(DW_AT_byte_size)?.and_then(|size| size.udata_value())) {
                (dwarf_names::DW_TAG_namespace, _) => path.push((depth, name)),
                (dwarf_names::DW_TAG_structure_type, Some(size)) if is_player => drop(sizes.insert(name, size)),
                _ => {}
            }
        }
    }
    Ok(sizes)
}
