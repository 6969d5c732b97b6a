//! What the instructions of a program are of, by its tables of lines.

use std::collections::BTreeMap;

use addr2line::Context;
use addr2line::gimli::{Dwarf, EndianSlice, LittleEndian, SectionId};
use object::{File, Object, ObjectSection, ObjectSymbol, SymbolKind};
use rustc_demangle::demangle;

/// The source of an instruction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// Below `src`; of other things than the library's source, what they are.
    pub file: String,
    /// As the compiler knows it; 0 if it does not.
    pub line: u32,
    pub function: String,
    /// The same as `file`, but of a file in `math` the one outside of it that calls it, where the call is compiled into it.
    pub user: String,
}

/// The tables of a program.
pub struct Places<'p> {
    lines: Context<EndianSlice<'p, LittleEndian>>,
    /// By where they begin.
    functions: BTreeMap<u32, String>,
}

struct Frame {
    file: String,
    line: u32,
    function: String,
}

impl<'p> Places<'p> {
    pub fn of(program: &'p [u8]) -> Result<Self, String> {
        let file = File::parse(program).map_err(|error| error.to_string())?;
        let section = |id: SectionId| {
            let data = file.section_by_name(id.name()).map_or(Ok(&[][..]), |section| section.data())?;
            Ok::<_, object::Error>(EndianSlice::new(data, LittleEndian))
        };
        let tables = Dwarf::load(section).map_err(|error| error.to_string())?;
        let lines = Context::from_dwarf(tables).map_err(|error| error.to_string())?;
        let functions = file.symbols().filter(|symbol| symbol.kind() == SymbolKind::Text);
        // The lowest bit of the address of a function says which kind of instructions it has.
        let function =
            |symbol: object::Symbol<'_, '_>| Some((symbol.address() as u32 & !1, symbol.name().ok()?.to_owned()));
        Ok(Self { lines, functions: functions.filter_map(function).collect() })
    }

    /// Where a function begins.
    pub fn address(&self, function: &str) -> Result<u32, String> {
        let found = self.functions.iter().find(|(_, name)| *name == function);
        found.map(|(address, _)| *address).ok_or_else(|| format!("there is no function `{function}`"))
    }

    /// What the instruction at an address is of.
    pub fn find(&self, address: u32) -> Result<Place, String> {
        let frames = self.frames(address).map_err(|error| error.to_string())?;
        let own: Vec<_> = frames.iter().filter(|frame| frame.file.starts_with("src/")).collect();
        let symbol = self.functions.range(..=address).next_back().map_or("?", |(_, name)| name);
        let symbol = format!("{:#}", demangle(symbol));
        let Some(&inner) = own.first() else {
            let file = if frames.iter().any(|frame| frame.file.starts_with("examples/")) {
                "the firmware"
            } else {
                package(&symbol)
            };
            return Ok(Place { file: file.to_owned(), line: 0, function: symbol, user: file.to_owned() });
        };
        let user = own.iter().find(|frame| !frame.file.starts_with("src/math/")).unwrap_or(&inner);
        let below = |frame: &Frame| frame.file.trim_start_matches("src/").to_owned();
        Ok(Place { file: below(inner), line: inner.line, function: inner.function.clone(), user: below(user) })
    }

    /// The functions that an instruction is in: from the one that was compiled into the others outwards.
    fn frames(&self, address: u32) -> Result<Vec<Frame>, addr2line::gimli::Error> {
        let root = concat!(env!("CARGO_MANIFEST_DIR"), "/");
        let mut found = self.lines.find_frames(u64::from(address)).skip_all_loads()?;
        let mut frames = Vec::new();
        while let Some(frame) = found.next()? {
            let (file, line) = frame.location.map_or((None, None), |place| (place.file, place.line));
            let file = file.unwrap_or_default();
            let function =
                frame.function.map(|function| function.raw_name().map(|name| name.into_owned())).transpose()?;
            let function = format!("{:#}", demangle(&function.unwrap_or_default()));
            frames.push(Frame {
                file: file.trim_start_matches(root).to_owned(),
                line: line.unwrap_or_default(),
                function,
            });
        }
        Ok(frames)
    }
}

/// What a function belongs to of which there are no lines: these are kept for the library alone.
fn package(symbol: &str) -> &'static str {
    let begins = |name: &str| symbol.trim_start_matches('<').starts_with(name);
    if begins("libm::") {
        "`libm`"
    } else if begins("core::") {
        "`core`"
    } else if begins("whit::") {
        "the library, in no known line"
    } else {
        "the compiler's own functions"
    }
}
