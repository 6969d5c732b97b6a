//! What a linked program says of itself: functions, code and data, relocations, sizes of stack frames.

use std::collections::{BTreeMap, HashMap};

use object::elf::SHF_ALLOC;
use object::{
    Endianness, File, Object, ObjectSection, ObjectSymbol, RelocationFlags, RelocationTarget, SectionFlags,
    SectionKind, SymbolKind,
};

/// `R_ARM_NONE`, a relocation that only keeps something in the program.
const NOTHING: u32 = 0;

/// A function as the symbols name it.
#[derive(Clone, Debug)]
pub struct Function {
    pub name: String,
    pub start: u32,
    pub end: u32,
}

/// A place that holds the address of something, before the linker filled it in.
#[derive(Clone, Debug)]
pub struct Relocation {
    pub address: u32,
    /// As in the ELF of the Arm architecture (IHI 0044).
    pub kind: u32,
    /// The address of the symbol.
    pub symbol: u32,
    /// Whether the symbol lies in code.
    pub is_code: bool,
    /// The section with the place.
    pub section: String,
}

/// A linked program.
pub struct Image {
    /// By address.
    pub functions: BTreeMap<u32, Function>,
    /// All symbols.
    pub symbols: Vec<String>,
    /// In code and constants, by address.
    pub relocations: BTreeMap<u32, Relocation>,
    /// The stack frame of each function by its address, where the compiler has noted it (`-Z emit-stack-sizes`).
    pub stack_sizes: HashMap<u32, u32>,
    /// The sizes of the program's variables.
    pub variables: HashMap<String, u64>,
    /// Where code begins (`true`) and ends.
    marks: BTreeMap<u32, bool>,
    /// Contents by address.
    contents: Vec<(u32, Vec<u8>)>,
}

impl Image {
    pub fn read(bytes: &[u8]) -> Result<Self, String> {
        let file = File::parse(bytes).map_err(|error| error.to_string())?;
        let mut image = Self {
            functions: BTreeMap::new(),
            symbols: Vec::new(),
            relocations: BTreeMap::new(),
            stack_sizes: HashMap::new(),
            variables: HashMap::new(),
            marks: BTreeMap::new(),
            contents: Vec::new(),
        };
        image.read_symbols(&file);
        image.read_sections(&file)?;
        Ok(image)
    }

    fn read_symbols(&mut self, file: &File<'_>) {
        for symbol in file.symbols() {
            let (Ok(name), address) = (symbol.name(), symbol.address() as u32) else { continue };
            match name.get(..2) {
                // The mapping symbols of the Arm architecture's ELF.
                Some(mark @ ("$t" | "$d")) if is_in_code(file, &symbol) => _ = self.marks.insert(address, mark == "$t"),
                _ if name.is_empty() || symbol.is_undefined() => {}
                _ => self.symbols.push(name.to_owned()),
            }
            if symbol.kind() == SymbolKind::Text && symbol.size() > 0 && !name.starts_with('$') {
                let start = address & !1; // The lowest bit says that it is Thumb code.
                let function = Function { name: name.to_owned(), start, end: start + symbol.size() as u32 };
                self.functions.entry(start).or_insert(function);
            } else if symbol.kind() == SymbolKind::Data {
                self.variables.insert(name.to_owned(), symbol.size());
            }
        }
    }

    fn read_sections(&mut self, file: &File<'_>) -> Result<(), String> {
        for section in file.sections() {
            let text = |error: object::Error| error.to_string();
            let (name, address) = (section.name().map_err(text)?, section.address() as u32);
            let data = section.data().map_err(text)?;
            if name == ".stack_sizes" {
                self.stack_sizes = stack_sizes(data).ok_or("the section .stack_sizes ends early")?;
            }
            let SectionFlags::Elf { sh_flags, .. } = section.flags() else { continue };
            if !sh_flags.contains(SHF_ALLOC) {
                continue;
            }
            self.contents.push((address, data.to_vec()));
            for (place, relocation) in section.relocations() {
                let RelocationFlags::Elf { r_type } = relocation.flags() else { continue };
                let RelocationTarget::Symbol(index) = relocation.target() else { continue };
                if r_type.0 == NOTHING {
                    continue;
                }
                let symbol = file.symbol_by_index(index).map_err(text)?;
                let is_code = is_in_code(file, &symbol);
                let (address, symbol) = (place as u32, symbol.address() as u32);
                let relocation = Relocation { address, kind: r_type.0, symbol, is_code, section: name.to_owned() };
                self.relocations.insert(address, relocation);
            }
        }
        match file.endianness() {
            Endianness::Little => Ok(()),
            Endianness::Big => Err("the program is big-endian".to_owned()),
        }
    }

    /// The function that an address lies in.
    pub fn function_at(&self, address: u32) -> Option<&Function> {
        let (_, function) = self.functions.range(..=address).next_back()?;
        (address < function.end).then_some(function)
    }

    /// The function of this name.
    pub fn function_named(&self, name: &str) -> Option<&Function> {
        self.functions.values().find(|function| function.name == name)
    }

    /// Whether an address holds code, and not data between the code.
    pub fn is_code(&self, address: u32) -> bool {
        self.marks.range(..=address).next_back().is_some_and(|(_, &is_code)| is_code)
    }

    pub fn halfword(&self, address: u32) -> Option<u16> {
        self.bytes(address).map(u16::from_le_bytes)
    }

    pub fn word(&self, address: u32) -> Option<u32> {
        self.bytes(address).map(u32::from_le_bytes)
    }

    fn bytes<const N: usize>(&self, address: u32) -> Option<[u8; N]> {
        self.contents.iter().find_map(|(start, data)| {
            let place = address.checked_sub(*start)? as usize;
            data.get(place..)?.first_chunk().copied()
        })
    }
}

fn is_in_code<'d>(file: &File<'d>, symbol: &impl ObjectSymbol<'d>) -> bool {
    let section = symbol.section_index().and_then(|index| file.section_by_index(index).ok());
    section.is_some_and(|section| section.kind() == SectionKind::Text)
}

/// Pairs of an address and a size, as a number of seven bits a byte.
fn stack_sizes(mut data: &[u8]) -> Option<HashMap<u32, u32>> {
    let mut sizes = HashMap::new();
    while let Some((address, rest)) = data.split_first_chunk() {
        let length = rest.iter().position(|byte| byte & 0x80 == 0)? + 1;
        let (digits, rest) = rest.split_at(length);
        let size = digits.iter().rev().fold(0, |size, byte| size << 7 | u32::from(byte & 0x7F));
        sizes.insert(u32::from_le_bytes(*address) & !1, size);
        data = rest;
    }
    data.is_empty().then_some(sizes)
}
