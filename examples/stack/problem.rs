//! What a program must not have.

use std::fmt;

/// Something that breaks a promise, or that keeps it from being checked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Problem {
    /// A panic is linked in.
    Panic { symbol: String, path: Vec<String> },
    /// Functions that call each other in a circle.
    Recursion(Vec<String>),
    /// A call or a jump to whatever a register holds.
    Indirect { function: String, address: u32 },
    /// The address of a function is kept, so that it may be called from anywhere.
    AddressTaken { function: String, place: String },
    /// An instruction that stops the processor.
    Trap { function: String, address: u32 },
    /// The compiler and the code do not agree on a stack frame.
    Sizes { function: String, compiler: u32, code: u32 },
    /// Code that cannot be followed.
    Unclear { function: String, address: u32, what: String },
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Panic { symbol, path } if path.is_empty() => write!(f, "panic: {symbol} is linked in"),
            Self::Panic { symbol, path } => write!(f, "panic: {symbol} is linked in, called by {}", path.join(" → ")),
            Self::Recursion(functions) => write!(f, "recursion: {}", functions.join(" → ")),
            Self::Indirect { function, address } => {
                write!(f, "function pointer: {function} calls what a register holds, at {address:#x}")
            }
            Self::AddressTaken { function, place } => {
                write!(f, "function pointer: the address of {function} is kept in {place}")
            }
            Self::Trap { function, address } => write!(f, "trap: {function} stops the processor, at {address:#x}"),
            Self::Sizes { function, compiler, code } => {
                write!(f, "stack frame of {function}: {compiler} bytes says the compiler, {code} the code")
            }
            Self::Unclear { function, address, what } => write!(f, "unclear: {function}, at {address:#x}: {what}"),
        }
    }
}
