//! The instructions of two halfwords.

use crate::instruction::{Instruction, Instruction::*, PC, Register, SP, offset};

/// Reads the wide instruction at an address.
pub fn wide(address: u32, first: u16, second: u16) -> Result<Instruction, String> {
    let rn = (first & 15) as Register;
    let unknown = || format!("{first:#06x} {second:#06x}, which is not understood");
    match first >> 9 {
        0x74 if first & 0x40 == 0 => multiple(first, second).ok_or_else(unknown),
        0x74 => dual(first, second).ok_or_else(unknown),
        0x75 => shifted_register(first, second).ok_or_else(unknown),
        0x76 | 0x77 => coprocessor(first, second).ok_or_else(unknown),
        0x78..=0x7B if second & 0x8000 != 0 => branch(address, first, second).ok_or_else(unknown),
        0x78..=0x7B => immediate(first, second).ok_or_else(unknown),
        // PC is a base only for loads of constants.
        0x7C if rn == PC && first & 0x70 == 0x50 && second >> 12 != 15 => {
            let distance = u32::from(second & 0xFFF);
            let base = (address + 4) & !3;
            let place = if first & 0x80 != 0 { base + distance } else { base - distance };
            destination((second >> 12) as Register).map(|to| Load(to, place)).ok_or_else(unknown)
        }
        0x7C => single(first, second).ok_or_else(unknown),
        0x7D => destination((second >> 8 & 15) as Register).map(|_| Plain).ok_or_else(unknown),
        _ => Err(unknown()),
    }
}

/// `LDM` and `STM`.
fn multiple(first: u16, second: u16) -> Option<Instruction> {
    let bytes = 4 * second.count_ones() as i32;
    match (first, first & 0x10 != 0, first & 15 == 13 && first & 0x20 != 0) {
        (0xE92D, ..) => Some(Grow(bytes)),
        (0xE8BD, ..) if second & 0x8000 != 0 => Some(Return(bytes)),
        (0xE8BD, ..) => Some(Grow(-bytes)),
        (_, is_load, false) if !is_load || second & 0xA000 == 0 => Some(Plain),
        _ => None,
    }
}

/// `LDRD`, `STRD`, exclusive access and `TBB`, `TBH`.
fn dual(first: u16, second: u16) -> Option<Instruction> {
    if first & 0xFFF0 == 0xE8D0 && second & 0xFFE0 == 0xF000 {
        return Some(Table);
    }
    let bytes = 4 * i32::from(second & 0xFF);
    let is_exclusive = first & 0x120 == 0;
    let writes_back = !is_exclusive && first & 0x20 != 0;
    match (writes_back && first & 15 == 13, first & 0x1B0) {
        (true, 0x120) => Some(Grow(bytes)),
        (true, 0x0B0) => Some(Grow(-bytes)),
        (true, _) => None,
        (false, _) if is_exclusive || first & 0x10 == 0 => Some(Plain),
        (false, _) => {
            destination((second >> 12) as Register).and(destination((second >> 8 & 15) as Register)).map(|_| Plain)
        }
    }
}

/// `ADD`, `SUB`, `MOV` and the like with a shifted register.
fn shifted_register(first: u16, second: u16) -> Option<Instruction> {
    let (operation, from) = (first >> 5 & 15, (first & 15) as Register);
    let (to, operand) = ((second >> 8 & 15) as Register, (second & 15) as Register);
    let is_shifted = second & 0x70F0 != 0;
    match (operation, from, to) {
        // Comparisons.
        (0 | 4 | 8 | 13, _, PC) if first & 0x10 != 0 => Some(Plain),
        (2, PC, SP) if !is_shifted => Some(Restore(operand)),
        (8, SP, SP) if !is_shifted => Some(ShrinkBy(operand)),
        (2, PC, _) if !is_shifted && operand == SP => destination(to).map(|to| AboveStack(to, 0)),
        _ => destination(to).map(|_| Plain),
    }
}

/// Instructions of the FPU.
fn coprocessor(first: u16, second: u16) -> Option<Instruction> {
    if second >> 9 & 7 != 0b101 || first & 0x100 != 0 && first & 0x200 != 0 {
        return None;
    }
    let bytes = 4 * i32::from(second & 0xFF);
    if first >> 9 == 0x76 {
        return match (first & 0x20 != 0 && first & 15 == 13, first & 0x1B0) {
            (true, 0x120) => Some(Grow(bytes)),
            (true, 0x0B0) => Some(Grow(-bytes)),
            (true, _) => None,
            (false, _) => Some(Plain),
        };
    }
    // A transfer to a core register; the flags have the number 15.
    let is_transfer = first & 0x100 == 0 && second & 0x10 != 0 && first & 0x10 != 0;
    if is_transfer && second >> 12 == 13 { None } else { Some(Plain) }
}

/// Calculations with a constant.
fn immediate(first: u16, second: u16) -> Option<Instruction> {
    let (from, to) = ((first & 15) as Register, (second >> 8 & 15) as Register);
    let operation = first >> 5 & 15;
    let is_modified = first & 0x200 == 0;
    let bits = u32::from(first >> 10 & 1) << 11 | u32::from(second >> 12 & 7) << 8 | u32::from(second & 0xFF);
    let constant = if is_modified { expand(bits) } else { bits } as i32;
    let (adds, subtracts) = if is_modified { (8, 13) } else { (0, 5) };
    match (from, to) {
        (_, PC) if is_modified && first & 0x10 != 0 && [0, 4, 8, 13].contains(&operation) => Some(Plain),
        (SP, SP) if operation == adds => Some(Grow(-constant)),
        (SP, SP) if operation == subtracts => Some(Grow(constant)),
        _ => destination(to).map(|to| match from {
            SP if operation == adds => AboveStack(to, constant),
            _ if operation == subtracts => Below { to, from, bytes: constant },
            _ => Plain,
        }),
    }
}

/// The constant that twelve bits stand for (ThumbExpandImm).
fn expand(bits: u32) -> u32 {
    let byte = bits & 0xFF;
    match bits >> 8 {
        0 => byte,
        1 => byte | byte << 16,
        2 => byte << 8 | byte << 24,
        3 => byte * 0x0101_0101,
        _ => (0x80 | bits & 0x7F).rotate_right(bits >> 7),
    }
}

/// Branches, and what has to do with the state of the processor.
fn branch(address: u32, first: u16, second: u16) -> Option<Instruction> {
    let (first, second) = (u32::from(first), u32::from(second));
    let sign = first >> 10 & 1;
    let (j1, j2) = (second >> 13 & 1, second >> 11 & 1);
    let far = || {
        let (i1, i2) = (1 ^ j1 ^ sign, 1 ^ j2 ^ sign);
        offset(address, sign << 24 | i1 << 23 | i2 << 22 | (first & 0x3FF) << 12 | (second & 0x7FF) << 1, 25)
    };
    match second & 0xD000 {
        0xD000 => Some(Call(far())),
        0x9000 => Some(Jump { target: far(), always: true }),
        0x8000 if first >> 6 & 15 < 14 => {
            let distance = sign << 20 | j2 << 19 | j1 << 18 | (first & 0x3F) << 12 | (second & 0x7FF) << 1;
            Some(Jump { target: offset(address, distance, 21), always: false })
        }
        0x8000 => match first & 0xFFF0 {
            // To the flags; other special registers may be the stack pointer.
            0xF380 if second & 0xF3FF == 0x8000 => Some(Plain),
            0xF3A0 if second & 0xFF == 0 => Some(Filler),
            0xF3A0 | 0xF3B0 => Some(Plain),
            0xF3E0 => destination((second >> 8 & 15) as Register).map(|_| Plain),
            0xF7F0 if second & 0xF000 == 0xA000 => Some(Trap),
            _ => None,
        },
        _ => None,
    }
}

/// Loads and stores of one register.
fn single(first: u16, second: u16) -> Option<Instruction> {
    let (is_load, register) = (first & 0x10 != 0, (second >> 12) as Register);
    let is_word = first & 0x60 == 0x40;
    let has_index = first & 0x80 == 0 && second & 0x800 != 0;
    let bytes = i32::from(second & 0xFF);
    if has_index && second & 0x100 != 0 && first & 15 == 13 {
        return match (is_load, second & 0x600) {
            (false, 0x400) => Some(Grow(bytes)),
            (true, 0x200) if is_word && register == PC => Some(Return(bytes)),
            (true, 0x200) => destination(register).map(|_| Grow(-bytes)),
            _ => None,
        };
    }
    match register {
        // A load of less than a word to this number is only a hint to the cache.
        PC if is_load && is_word => Some(Indirect),
        SP if is_load => None,
        _ => Some(Plain),
    }
}

/// A register that is no more than a register.
fn destination(register: Register) -> Option<Register> {
    (register != SP && register != PC).then_some(register)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::instruction::is_wide;

    /// Each as LLVM's assembler writes it, at address 0x100000.
    #[test]
    fn wide_instructions_are_read() {
        let jump = |target, always| Jump { target, always };
        for (first, second, instruction) in [
            (0xE92D, 0x0B00, Grow(12)),                            // push.w {r8, r9, r11}
            (0xE8BD, 0x8110, Return(12)),                          // pop.w {r4, r8, pc}
            (0xE8BD, 0x0300, Grow(-8)),                            // pop.w {r8, r9}
            (0xF84D, 0x8D04, Grow(4)),                             // str r8, [sp, #-4]!
            (0xF85D, 0x8B04, Grow(-4)),                            // ldr r8, [sp], #4
            (0xF85D, 0xFB04, Return(4)),                           // ldr pc, [sp], #4
            (0xE96D, 0x4504, Grow(16)),                            // strd r4, r5, [sp, #-16]!
            (0xE8FD, 0x4504, Grow(-16)),                           // ldrd r4, r5, [sp], #16
            (0xED2D, 0x8B06, Grow(24)),                            // vpush {d8-d10}
            (0xECBD, 0x8B04, Grow(-16)),                           // vpop {d8, d9}
            (0xF5AD, 0x6D8C, Grow(1120)),                          // sub.w sp, sp, #1120
            (0xF2AD, 0x4DD3, Grow(1235)),                          // subw sp, sp, #1235
            (0xF50D, 0x7D00, Grow(-512)),                          // add.w sp, sp, #512
            (0xEA4F, 0x0D0B, Restore(11)),                         // mov.w sp, r11
            (0xF10D, 0x0B18, AboveStack(11, 24)),                  // add.w r11, sp, #24
            (0xF1A7, 0x0440, Below { to: 4, from: 7, bytes: 64 }), // sub.w r4, r7, #64
            (0xF85F, 0x4010, Load(4, 0xF_FFF4)),                   // ldr.w r4, [pc, #-16]
            (0xF000, 0x81F4, jump(0x10_03EC, false)),              // beq.w #1000
            (0xF7E7, 0xBCB0, jump(0x10_0004 - 100_000, true)),     // b.w #-100000
            (0xF001, 0xF800, Call(0x10_1004)),                     // bl #4096
            (0xF7FF, 0xF800, Call(0xF_F004)),                      // bl #-4096
            (0xE8DF, 0xF000, Table),                               // tbb [pc, r0]
            (0xE8DF, 0xF010, Table),                               // tbh [pc, r0, lsl #1]
            (0xF8D0, 0xF004, Indirect),                            // ldr.w pc, [r0, #4]
            (0xF851, 0xF002, Indirect),                            // ldr.w pc, [r1, r2]
            (0xF7F0, 0xA001, Trap),                                // udf.w #1
            (0xF3AF, 0x8000, Filler),                              // nop.w
            (0xF3EF, 0x8008, Plain),                               // mrs r0, msp
            (0xF380, 0x8800, Plain),                               // msr APSR_nzcvq, r0
            (0xED9D, 0x0A01, Plain),                               // vldr s0, [sp, #4]
            (0xED20, 0x8B02, Plain),                               // vstmdb r0!, {d8}
            (0xEEF1, 0xFA10, Plain),                               // vmrs APSR_nzcv, fpscr
            (0xEEB1, 0x0AC0, Plain),                               // vsqrt.f32 s0, s0
            (0xE920, 0x0006, Plain),                               // stmdb r0!, {r1, r2}
            (0xE851, 0x0F00, Plain),                               // ldrex r0, [r1]
            (0xE9CD, 0x0102, Plain),                               // strd r0, r1, [sp, #8]
            (0xE8F2, 0x0102, Plain),                               // ldrd r0, r1, [r2], #8
            (0xF010, 0x0F01, Plain),                               // tst.w r0, #1
            (0xEBB0, 0x0F01, Plain),                               // cmp.w r0, r1
            (0xFBA2, 0x0103, Plain),                               // umull r0, r1, r2, r3
            (0xFA5F, 0xF089, Plain),                               // uxtb.w r0, r9
            (0xF3BF, 0x8F4F, Plain),                               // dsb sy
            (0xF890, 0xF000, Plain),                               // pld [r0]
            (0xF240, 0x40D2, Plain),                               // movw r0, #1234
        ] {
            assert!(is_wide(first));
            assert_eq!(wide(0x10_0000, first, second), Ok(instruction), "{first:#06x} {second:#06x}");
        }
    }

    #[test]
    fn what_could_move_the_stack_unseen_is_refused() {
        for (first, second) in [
            (0xEBAD, 0x0D04), // sub.w sp, sp, r4
            (0xF8D0, 0xD000), // ldr.w sp, [r0]
            (0xF380, 0x8808), // msr msp, r0
            (0xE8B0, 0x8002), // ldm.w r0!, {r1, pc}
            (0xF02D, 0x0D07), // bic sp, sp, #7
        ] {
            assert!(wide(0x10_0000, first, second).is_err(), "{first:#06x} {second:#06x}");
        }
    }
}
