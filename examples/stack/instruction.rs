//! What an instruction of Armv6-M or Armv7E-M does to the stack pointer and to the flow of control: here those of one
//! halfword, which are all but a few of Armv6-M's.
//!
//! Encodings: Armv7-M Architecture Reference Manual (DDI 0403), chapter A5. All that could write the stack pointer or
//! the program counter and is not understood here is an error, so nothing slips through.

/// A core register: 13 is the stack pointer, 14 holds the return address, 15 is the program counter.
pub type Register = u8;
pub const SP: Register = 13;
pub const LR: Register = 14;
pub const PC: Register = 15;
/// What the compiler uses as frame pointer.
pub const FRAME_POINTER: Register = 7;

/// The effect of an instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instruction {
    /// None.
    Plain,
    /// Does nothing at all: what gaps are filled with.
    Filler,
    /// Of the next so many instructions, those at the 1s of `then` (the first is the lowest) are carried out if a condition
    /// holds, and the others if it does not.
    If { count: u8, then: u8 },
    /// The stack grows by so many bytes, or shrinks.
    Grow(i32),
    /// The stack shrinks by what a register holds.
    ShrinkBy(Register),
    /// The stack pointer is restored from a register.
    Restore(Register),
    /// A register is set to so many bytes above the stack pointer.
    AboveStack(Register, i32),
    /// `to = from − bytes`
    Below { to: Register, from: Register, bytes: i32 },
    /// A register is loaded with the word at an address.
    Load(Register, u32),
    /// Goes on at an address, always or perhaps.
    Jump { target: u32, always: bool },
    /// Calls the function at an address.
    Call(u32),
    /// Takes so many bytes off the stack and goes back to the caller.
    Return(i32),
    /// Goes on where a table says that lies beside the code of the function.
    Table,
    /// Calls or jumps to whatever function a register holds.
    Indirect,
    /// Stops the processor.
    Trap,
}
use Instruction::*;

/// Whether an instruction takes two halfwords.
pub const fn is_wide(first: u16) -> bool {
    first >> 11 >= 0b11101
}

/// Reads the narrow instruction at an address.
pub fn narrow(address: u32, code: u16) -> Result<Instruction, String> {
    let low = |at: u32| (code >> at & 7) as Register;
    let byte = i32::from(code & 0xFF);
    Ok(match code >> 8 {
        _ if code == 0xBF00 || code == 0x46C0 || code == 0 => Filler,
        0x1E | 0x1F => Below { to: low(0), from: low(3), bytes: i32::from(low(6)) },
        0x38..=0x3F => Below { to: low(8), from: low(8), bytes: byte },
        0x44 | 0x46 => high_register(code),
        0x47 => match (code >> 7 & 1, (code >> 3 & 15) as Register) {
            (0, LR) => Return(0),
            _ => Indirect,
        },
        0x48..=0x4F => Load(low(8), ((address + 4) & !3) + 4 * byte as u32),
        0xA8..=0xAF => AboveStack(low(8), 4 * byte),
        0xB0 => Grow(if code & 0x80 == 0 { -4 } else { 4 } * i32::from(code & 0x7F)),
        0xB1 | 0xB3 | 0xB9 | 0xBB => {
            let distance = u32::from(code >> 3 & 0x1F) << 1 | u32::from(code >> 9 & 1) << 6;
            Jump { target: address + 4 + distance, always: false }
        }
        0xB4 | 0xB5 => Grow(4 * (code & 0x1FF).count_ones() as i32),
        0xBC => Grow(-4 * (code & 0xFF).count_ones() as i32),
        0xBD => Return(4 * (code & 0x1FF).count_ones() as i32),
        0xBF if code & 15 != 0 => if_then(code),
        0xD0..=0xDD => Jump { target: offset(address, u32::from(code & 0xFF) << 1, 9), always: false },
        0xDE => Trap,
        0xDF => return Err(format!("a system call, {code:#06x}")),
        0xE0..=0xE7 => Jump { target: offset(address, u32::from(code & 0x7FF) << 1, 12), always: true },
        _ => Plain,
    })
}

/// `IT`: the lowest 1 of the mask says how many instructions are meant, and a bit above it that is the condition's lowest
/// one that the instruction belongs to the first.
fn if_then(code: u16) -> Instruction {
    let (mask, condition) = (code & 15, code >> 4 & 1);
    let count = 4 - mask.trailing_zeros() as u8;
    let then = (1..count).filter(|at| mask >> (4 - at) & 1 == condition).fold(1, |then, at| then | 1 << at);
    If { count, then }
}

/// `ADD` and `MOV` between all registers.
fn high_register(code: u16) -> Instruction {
    let (to, from) = ((code >> 4 & 8 | code & 7) as Register, (code >> 3 & 15) as Register);
    match (code >> 8, to, from) {
        (0x44, SP, _) => ShrinkBy(from),
        (0x46, SP, _) => Restore(from),
        (0x46, PC, LR) => Return(0),
        (_, PC, _) => Table,
        (0x46, _, SP) => AboveStack(to, 0),
        _ => Plain,
    }
}

/// The target of a branch by a signed distance of so many bits.
pub fn offset(address: u32, distance: u32, bits: u32) -> u32 {
    let unused = 32 - bits;
    (address + 4).wrapping_add_signed((distance << unused).cast_signed() >> unused)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each as LLVM's assembler writes it, at address 0x1000.
    #[test]
    fn narrow_instructions_are_read() {
        let jump = |target, always| Jump { target, always };
        for (code, instruction) in [
            (0xB5F0, Grow(20)),                           // push {r4-r7, lr}
            (0xBC06, Grow(-8)),                           // pop {r1, r2}
            (0xBD90, Return(12)),                         // pop {r4, r7, pc}
            (0xB0FF, Grow(508)),                          // sub sp, #508
            (0xB006, Grow(-24)),                          // add sp, #24
            (0x44B5, ShrinkBy(6)),                        // add sp, r6
            (0x46A5, Restore(4)),                         // mov sp, r4
            (0xAF03, AboveStack(7, 12)),                  // add r7, sp, #12
            (0x466F, AboveStack(7, 0)),                   // mov r7, sp
            (0x1FFE, Below { to: 6, from: 7, bytes: 7 }), // subs r6, r7, #7
            (0x3E05, Below { to: 6, from: 6, bytes: 5 }), // subs r6, #5
            (0x4C04, Load(4, 0x1014)),                    // ldr r4, [pc, #16]
            (0xE7CE, jump(0xFA0, true)),                  // b #-100
            (0xE032, jump(0x1068, true)),                 // b #100
            (0xD1F6, jump(0xFF0, false)),                 // bne #-20
            (0xB3FB, jump(0x1082, false)),                // cbz r3, #126
            (0xB900, jump(0x1004, false)),                // cbnz r0, #0
            (0x4770, Return(0)),                          // bx lr
            (0x46F7, Return(0)),                          // mov pc, lr
            (0x4718, Indirect),                           // bx r3
            (0x4790, Indirect),                           // blx r2
            (0x4687, Table),                              // mov pc, r0
            (0x449F, Table),                              // add pc, r3
            (0xDEFE, Trap),                               // udf #254
            (0xBF00, Filler),                             // nop
            (0x46C0, Filler),                             // mov r8, r8
            (0xBF06, If { count: 3, then: 0b011 }),       // itte eq
            (0xBF3C, If { count: 2, then: 0b11 }),        // itt lo
            (0xBF18, If { count: 1, then: 1 }),           // it ne
            (0xBEAB, Plain),                              // bkpt #171
            (0x4608, Plain),                              // mov r0, r1
        ] {
            assert!(!is_wide(code));
            assert_eq!(narrow(0x1000, code), Ok(instruction), "{code:#06x}");
        }
        assert!(narrow(0x1000, 0xDF00).is_err()); // svc #0
    }
}
