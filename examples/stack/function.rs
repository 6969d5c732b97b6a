//! The stack frame of one function and the calls that it makes, read off its code.
//!
//! All ways through the function are followed with the number of bytes that are on the stack. Each instruction must be
//! reached with one such number only, and a return must find what the function was entered with.

use std::collections::BTreeMap;

use crate::image::{Function, Image};
use crate::instruction::{self, FRAME_POINTER, Instruction, Register};
use crate::names::short;
use crate::problem::Problem;
use crate::wide::wide;

/// What the code of a function says.
#[derive(Debug, Default)]
pub struct Code {
    /// The most bytes that it has on the stack.
    pub frame: u32,
    pub calls: Vec<Call>,
    pub problems: Vec<Problem>,
}

/// A call, or a jump to another function.
#[derive(Clone, Copy, Debug)]
pub struct Call {
    /// The address of the instruction.
    pub place: u32,
    pub target: u32,
    /// Bytes that the caller has on the stack at that moment.
    pub depth: u32,
}

/// Follows the code of a function.
pub fn read(image: &Image, function: &Function) -> Code {
    let mut reader = Reader {
        image,
        function,
        code: Code::default(),
        depths: BTreeMap::new(),
        waiting: vec![Way::at(function.start, 0)],
        frame_pointer: None,
        at_table: None,
    };
    reader.follow_all();
    reader.code
}

struct Reader<'i> {
    image: &'i Image,
    function: &'i Function,
    code: Code,
    /// Bytes on the stack before each instruction that was reached.
    depths: BTreeMap<u32, i32>,
    /// Ways that are still to be followed.
    waiting: Vec<Way>,
    /// Bytes on the stack above the frame pointer.
    frame_pointer: Option<i32>,
    /// Bytes on the stack at jumps through tables.
    at_table: Option<i32>,
}

/// A way through the code, from an address on.
#[derive(Clone, Copy)]
struct Way {
    address: u32,
    /// Bytes on the stack.
    depth: i32,
    /// A bit for each of the next instructions, from the lowest: whether it is left out.
    skipped: u8,
}

impl Way {
    const fn at(address: u32, depth: i32) -> Self {
        Self { address, depth, skipped: 0 }
    }
}

/// What is known of one register: that it was just set.
#[derive(Clone, Copy)]
enum Known {
    Nothing,
    Constant(Register, u32),
    /// To the address that the stack pointer has with so many bytes on the stack.
    Stack(Register, i32),
}

impl Reader<'_> {
    fn follow_all(&mut self) {
        loop {
            while let Some(way) = self.waiting.pop() {
                self.follow(way);
            }
            // A jump through a table reaches all that nothing else does. That takes in more than what is in the table,
            // and needs no table of which the end would have to be guessed.
            match (self.first_left_out(), self.at_table) {
                (None, _) => return,
                (Some(address), Some(depth)) => self.waiting.push(Way::at(address, depth)),
                (Some(address), None) => return self.unclear(address, "nothing leads here"),
            }
        }
    }

    fn first_left_out(&self) -> Option<u32> {
        let mut address = self.function.start;
        while address < self.function.end {
            let is_gap = || matches!(self.instruction(address), Ok((_, Instruction::Filler | Instruction::Trap)));
            if self.image.is_code(address) {
                if !self.depths.contains_key(&address) && !is_gap() {
                    return Some(address);
                }
                address += self.instruction(address).map_or(2, |(length, _)| length);
            } else {
                address += 2;
            }
        }
        None
    }

    /// The instruction at an address, after its length.
    fn instruction(&self, address: u32) -> Result<(u32, Instruction), String> {
        let halfword = |address| match self.image.halfword(address) {
            Some(code) if self.image.is_code(address) => Ok(code),
            _ => Err("there is no code".to_owned()),
        };
        let first = halfword(address)?;
        if instruction::is_wide(first) {
            Ok((4, wide(address, first, halfword(address + 2)?)?))
        } else {
            Ok((2, instruction::narrow(address, first)?))
        }
    }

    /// Follows the code on one way, until it jumps, returns or meets what is known.
    fn follow(&mut self, way: Way) {
        let Way { mut address, mut depth, mut skipped } = way;
        let mut known = Known::Nothing;
        loop {
            let (length, instruction) = match self.instruction(address) {
                Ok(found) => found,
                Err(what) => {
                    self.depths.insert(address, depth); // Not to come here again.
                    return self.unclear(address, &what);
                }
            };
            let is_skipped = skipped & 1 != 0;
            skipped >>= 1;
            if is_skipped {
                address += length;
                continue;
            }
            match self.depths.insert(address, depth) {
                Some(before) if before == depth => return,
                Some(before) => {
                    return self.unclear(address, &format!("reached with {before} and {depth} bytes on the stack"));
                }
                None => {}
            }
            match self.step(address, instruction, depth, &mut known) {
                Ok(Some(after)) => depth = after,
                Ok(None) => return,
                Err(what) => return self.unclear(address, &what),
            }
            address += length;
            if let Instruction::If { count, then } = instruction {
                let all = (1 << count) - 1;
                self.waiting.push(Way { address, depth, skipped: then });
                skipped = all & !then;
            }
            self.code.frame = self.code.frame.max(depth.unsigned_abs());
        }
    }

    /// What an instruction does, with so many bytes on the stack: the number of bytes with which the next one is reached,
    /// or `None` where that is not reached.
    fn step(
        &mut self,
        address: u32,
        instruction: Instruction,
        depth: i32,
        known: &mut Known,
    ) -> Result<Option<i32>, String> {
        let before = std::mem::replace(known, Known::Nothing);
        let mut after = depth;
        match instruction {
            Instruction::Plain | Instruction::Filler | Instruction::If { .. } => {}
            Instruction::Grow(bytes) => after += bytes,
            Instruction::ShrinkBy(register) => match before {
                Known::Constant(set, bytes) if set == register => after -= bytes.cast_signed(),
                _ => return Err("the stack grows by what a register holds".to_owned()),
            },
            Instruction::Restore(register) => after = self.restored(register, before)?,
            Instruction::AboveStack(FRAME_POINTER, bytes) => {
                if self.frame_pointer.replace(depth - bytes).is_some_and(|set| set != depth - bytes) {
                    return Err("the frame pointer is set twice".to_owned());
                }
            }
            Instruction::AboveStack(..) => {}
            Instruction::Below { to, from, bytes } => {
                if let Ok(start) = self.restored(from, before) {
                    *known = Known::Stack(to, start + bytes);
                }
            }
            Instruction::Load(register, place) => {
                *known = self.image.word(place).map_or(Known::Nothing, |word| Known::Constant(register, word));
            }
            Instruction::Jump { target, always } => {
                if (self.function.start..self.function.end).contains(&target) {
                    self.waiting.push(Way::at(target, depth));
                } else {
                    self.call(address, target, depth);
                }
                if always {
                    return Ok(None);
                }
            }
            // Armv6-M has no other jump as far as this.
            Instruction::Call(target) if (self.function.start + 1..self.function.end).contains(&target) => {
                self.waiting.push(Way::at(target, depth));
                return Ok(None);
            }
            Instruction::Call(target) => self.call(address, target, depth),
            Instruction::Return(bytes) if bytes == depth => return Ok(None),
            Instruction::Return(bytes) => return Err(format!("returns with {} bytes on the stack", depth - bytes)),
            Instruction::Table if self.has_table(address) => {
                if self.at_table.replace(depth).is_some_and(|other| other != depth) {
                    return Err("tables are used with different numbers of bytes on the stack".to_owned());
                }
                return Ok(None);
            }
            Instruction::Indirect | Instruction::Table => {
                self.code.problems.push(Problem::Indirect { function: short(&self.function.name), address });
            }
            Instruction::Trap => {
                self.code.problems.push(Problem::Trap { function: short(&self.function.name), address });
                return Ok(None);
            }
        }
        if after < 0 { Err("takes more off the stack than it put there".to_owned()) } else { Ok(Some(after)) }
    }

    /// The bytes on the stack when the stack pointer is what a register holds.
    fn restored(&self, register: Register, known: Known) -> Result<i32, String> {
        match (known, self.frame_pointer) {
            (Known::Stack(set, depth), _) if set == register => Ok(depth),
            (_, Some(depth)) if register == FRAME_POINTER => Ok(depth),
            _ => Err("the stack pointer is set to what a register holds".to_owned()),
        }
    }

    /// Whether a table lies behind a jump, after a gap of at most a halfword.
    fn has_table(&self, jump: u32) -> bool {
        (jump + 2..=jump + 6).step_by(2).any(|place| place < self.function.end && !self.image.is_code(place))
    }

    fn call(&mut self, place: u32, target: u32, depth: i32) {
        self.code.calls.push(Call { place, target, depth: depth.unsigned_abs() });
    }

    fn unclear(&mut self, address: u32, what: &str) {
        let function = short(&self.function.name);
        self.code.problems.push(Problem::Unclear { function, address, what: what.to_owned() });
    }
}
