//! Thumb instructions: their kind, what they write, and which registers their address comes from.
//!
//! Source: `ARMv7-M` Architecture Reference Manual (DDI 0403E), A5.2 (16 bits) and A5.3 (32 bits). `ARMv6-M` is a part of it.

use crate::instruction::{Instruction, Kind, Registers, PC};

const SP: Registers = 1 << 13;

impl Instruction {
    /// With an address from these registers.
    const fn at(self, address: Registers) -> Self {
        self.needing(address & !PC)
    }

    /// A result of data processing: a jump when it goes to the program counter.
    const fn data(writes: Registers) -> Self {
        Self::new(if writes & PC == 0 { Kind::Data } else { Kind::Jump }).writing(writes)
    }
}

/// How many bytes an instruction has whose first halfword this is.
pub const fn size(first: u16) -> u8 {
    if first >= 0xE800 {
        4
    } else {
        2
    }
}

/// An instruction of 16 bits, or of 32: then `second` is its second halfword.
pub const fn decode(first: u16, second: u16) -> Instruction {
    if size(first) == 2 {
        narrow(first)
    } else {
        wide(first, second)
    }
}

/// The register whose number starts at this bit; three bits of it, or four.
const fn low(code: u16, bit: u16) -> Registers {
    1 << (code >> bit & 7)
}

const fn high(code: u16, bit: u16) -> Registers {
    1 << (code >> bit & 15)
}

/// A list of the lower eight.
const fn list(code: u16) -> Registers {
    (code & 0xFF) as Registers
}

#[allow(clippy::cast_possible_truncation, reason = "at most 16")]
const fn several(registers: Registers) -> Kind {
    Kind::Multiple { count: registers.count_ones() as u8 }
}

const STORE: Kind = Kind::Store { by_register: false };

const fn narrow(code: u16) -> Instruction {
    match code >> 12 {
        // Shifts and sums of three operands.
        0 | 1 => Instruction::data(low(code, 0)),
        // `cmp`.
        2 if code >> 11 == 0b00101 => Instruction::new(Kind::Data),
        // With an immediate of 8 bits; addresses near the program counter and on the stack.
        2 | 3 | 10 => Instruction::data(low(code, 8)),
        4 => match code >> 10 & 3 {
            // `tst`, `cmp`, `cmn` are 8, 10 and 11.
            0 if matches!(code >> 6 & 15, 8 | 10 | 11) => Instruction::new(Kind::Data),
            0 => Instruction::data(low(code, 0)),
            1 if code >> 8 & 3 == 3 => Instruction::new(Kind::Jump),
            1 if code >> 8 & 3 == 1 => Instruction::new(Kind::Data),
            1 => Instruction::data(high(code >> 4 & 8 | code & 7, 0)),
            _ => Instruction::new(Kind::Load).writing(low(code, 8)),
        },
        5 => {
            let address = low(code, 3) | low(code, 6);
            // Three stores, then five loads.
            if code >> 9 & 7 < 3 {
                Instruction::new(Kind::Store { by_register: true }).at(address)
            } else {
                Instruction::new(Kind::Load).writing(low(code, 0)).at(address)
            }
        }
        6..=8 if code & 0x0800 == 0 => Instruction::new(STORE).at(low(code, 3)),
        6..=8 => Instruction::new(Kind::Load).writing(low(code, 0)).at(low(code, 3)),
        9 if code & 0x0800 == 0 => Instruction::new(STORE).at(SP),
        9 => Instruction::new(Kind::Load).writing(low(code, 8)).at(SP),
        11 => miscellaneous(code),
        12 if code & 0x0800 == 0 => Instruction::new(several(list(code))).at(low(code, 8)),
        12 => Instruction::new(several(list(code))).writing(list(code)).at(low(code, 8)),
        // Conditional branches, `svc`, and branches.
        _ => Instruction::new(Kind::Jump),
    }
}

const fn miscellaneous(code: u16) -> Instruction {
    match code >> 8 & 15 {
        0 => Instruction::data(SP),
        1 | 3 | 9 | 11 => Instruction::new(Kind::Jump),
        2 | 10 => Instruction::data(low(code, 0)),
        4 | 5 => Instruction::new(several((code & 0x1FF) as Registers)).at(SP),
        12 | 13 => {
            // Bit 8 is the program counter.
            let registers = list(code) | ((code & 0x100) as Registers) << 7;
            Instruction::new(several(registers)).writing(registers).at(SP)
        }
        // `cps`, `bkpt`, `it` and hints.
        _ => Instruction::new(Kind::Data),
    }
}

const fn wide(first: u16, second: u16) -> Instruction {
    match (first >> 11 & 3, first >> 9 & 3) {
        (1, 0) if first & 0x40 == 0 => {
            let all = second as Registers;
            let registers = if first & 0x10 == 0 { 0 } else { all };
            Instruction::new(several(all)).writing(registers).at(high(first, 0))
        }
        (1, 0) => double(first, second),
        // Data processing with a shifted register.
        (1, 1) => result(second),
        (1, _) | (3, 2 | 3) => float(first, second),
        (2, _) if second & 0x8000 == 0 => result(second),
        (2, _) => branch(first, second),
        (3, 0) if first & 0x10 == 0 => single(first, second, false),
        (3, 0) => single(first, second, true),
        // Multiplications; those with two results, and divisions.
        (3, 1) if first & 0xFF80 == 0xFB80 => {
            if second & 0xF0 == 0xF0 {
                return Instruction::new(Kind::Divide { signed: first & 0x20 == 0 }).writing(high(second, 8));
            }
            Instruction::data(high(second, 8) | high(second, 12))
        }
        _ => result(second),
    }
}

/// Data processing into bits 8 to 11. Comparisons have the program counter there, which nothing else may have.
const fn result(second: u16) -> Instruction {
    Instruction::new(Kind::Data).writing(high(second, 8) & !PC)
}

/// `ldrd`, `strd`, `tbb`, `tbh`, and exclusive accesses.
const fn double(first: u16, second: u16) -> Instruction {
    let (base, loads) = (high(first, 0), first & 0x10 != 0);
    // With an offset that is written back, or subtracted or added: bits 8 and 5 are P and W.
    if first & 0x0120 != 0 {
        let both = if loads { high(second, 12) | high(second, 8) } else { 0 };
        return Instruction::new(Kind::Double).writing(both).at(base);
    }
    match (first & 0x80 != 0, loads) {
        (true, true) if second & 0xE0 == 0 => Instruction::new(Kind::Table).at(base | high(second, 0)),
        (_, true) => Instruction::new(Kind::Load).writing(high(second, 12)).at(base),
        // It is as a load.
        (_, false) => Instruction::new(Kind::Load).at(base),
    }
}

const fn branch(first: u16, second: u16) -> Instruction {
    match second & 0xD000 {
        0xD000 | 0xC000 => Instruction::new(Kind::Link),
        0x8000 if first >> 7 & 7 == 7 => match first >> 4 & 15 {
            // `mrs`, and hints.
            14 | 15 => Instruction::new(Kind::System).writing(high(second, 8) & !PC),
            10 => Instruction::new(Kind::Data),
            _ => Instruction::new(Kind::System),
        },
        _ => Instruction::new(Kind::Jump),
    }
}

/// One register. Bit 7 of the first halfword, or bit 11 of the second, is an immediate offset.
const fn single(first: u16, second: u16, loads: bool) -> Instruction {
    let by_register = first & 0x80 == 0 && second & 0x0800 == 0 && first & 15 != 15;
    let address = high(first, 0) | if by_register { high(second, 0) } else { 0 };
    let to = high(second, 12);
    if !loads {
        Instruction::new(Kind::Store { by_register }).at(address)
    } else if to == PC && first >> 5 & 3 != 2 {
        // A hint: `pld`.
        Instruction::new(Kind::Data)
    } else {
        Instruction::new(Kind::Load).writing(to).at(address)
    }
}

/// Coprocessor 10 and 11. This crate has none of it; what it is compared with has.
#[allow(clippy::cast_possible_truncation, reason = "8 bits")]
const fn float(first: u16, second: u16) -> Instruction {
    if first & 0xFE00 == 0xEC00 && first & 0x01A0 != 0 {
        // A load or a store of one register is one of some, without a list.
        let words = second as u8;
        let count = if first & 0x0120 == 0x0100 { 1 + (second >> 8 & 1) as u8 } else { words };
        return Instruction::new(Kind::Multiple { count }).at(high(first, 0));
    }
    // Data processing: bits 7, 5 and 4 say what, and bit 4 of the second halfword is clear.
    if first & 0xFF00 == 0xEE00 && second & 0x10 == 0 {
        let kind = match first & 0xB0 {
            0x80 => Kind::FloatDivide,
            0xB0 if first & 0xF == 1 && second & 0xC0 == 0xC0 => Kind::FloatDivide,
            0x00 | 0x10 | 0x90 | 0xA0 => Kind::FloatMultiplyAdd,
            _ => Kind::Data,
        };
        return Instruction::new(kind);
    }
    // `vmov`, to a register of the processor.
    let moves = first & 0xFF10 == 0xEE10 && second & 0x10 != 0;
    Instruction::new(Kind::Data).writing(if moves { high(second, 12) & !PC } else { 0 })
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn registers(numbers: &[u8]) -> Registers {
        let (mut set, mut at) = (0, 0);
        while at < numbers.len() {
            set |= 1 << numbers[at];
            at += 1;
        }
        set
    }

    /// The kind, what is written, and where the address comes from.
    #[track_caller]
    fn check(first: u16, second: u16, kind: Kind, writes: &[u8], address: &[u8]) {
        let expected = Instruction { kind, writes: registers(writes), needs: registers(address) };
        assert_eq!(decode(first, second), expected, "{first:04x} {second:04x}");
    }

    const BY_REGISTER: Kind = Kind::Store { by_register: true };

    /// As the assembler of LLVM encodes them.
    #[test]
    fn sixteen_bits() {
        let check = |code, kind, writes: &[u8], address: &[u8]| check(code, 0xFFFF, kind, writes, address);
        check(0x2001, Kind::Data, &[0], &[]); // movs r0, #1
        check(0x2B04, Kind::Data, &[], &[]); // cmp r3, #4
        check(0x18D1, Kind::Data, &[1], &[]); // adds r1, r2, r3
        check(0x00D1, Kind::Data, &[1], &[]); // lsls r1, r2, #3
        check(0x4211, Kind::Data, &[], &[]); // tst r1, r2
        check(0x4351, Kind::Data, &[1], &[]); // muls r1, r2, r1
        check(0x4691, Kind::Data, &[9], &[]); // mov r9, r2
        check(0x4697, Kind::Jump, &[15], &[]); // mov pc, r2
        check(0x4488, Kind::Data, &[8], &[]); // add r8, r1
        check(0x4588, Kind::Data, &[], &[]); // cmp r8, r1
        check(0x4770, Kind::Jump, &[], &[]); // bx lr
        check(0x4798, Kind::Jump, &[], &[]); // blx r3
        check(0x4A02, Kind::Load, &[2], &[]); // ldr r2, [pc, #8]
        check(0x50D1, BY_REGISTER, &[], &[2, 3]); // str r1, [r2, r3]
        check(0x54D1, BY_REGISTER, &[], &[2, 3]); // strb r1, [r2, r3]
        check(0x56D1, Kind::Load, &[1], &[2, 3]); // ldrsb r1, [r2, r3]
        check(0x58D1, Kind::Load, &[1], &[2, 3]); // ldr r1, [r2, r3]
        check(0x5ED1, Kind::Load, &[1], &[2, 3]); // ldrsh r1, [r2, r3]
        check(0x6051, STORE, &[], &[2]); // str r1, [r2, #4]
        check(0x6851, Kind::Load, &[1], &[2]); // ldr r1, [r2, #4]
        check(0x7111, STORE, &[], &[2]); // strb r1, [r2, #4]
        check(0x8891, Kind::Load, &[1], &[2]); // ldrh r1, [r2, #4]
        check(0x9101, STORE, &[], &[13]); // str r1, [sp, #4]
        check(0x9901, Kind::Load, &[1], &[13]); // ldr r1, [sp, #4]
        check(0xA901, Kind::Data, &[1], &[]); // add r1, sp, #4
        check(0xB082, Kind::Data, &[13], &[]); // sub sp, #8
        check(0xB111, Kind::Jump, &[], &[]); // cbz r1
        check(0xB530, Kind::Multiple { count: 3 }, &[], &[13]); // push {r4, r5, lr}
        check(0xBD30, Kind::Multiple { count: 3 }, &[4, 5, 15], &[13]); // pop {r4, r5, pc}
        check(0xB2D1, Kind::Data, &[1], &[]); // uxtb r1, r2
        check(0xBA11, Kind::Data, &[1], &[]); // rev r1, r2
        check(0xBF08, Kind::Data, &[], &[]); // it eq
        check(0xC11C, Kind::Multiple { count: 3 }, &[], &[1]); // stm r1!, {r2, r3, r4}
        check(0xC91C, Kind::Multiple { count: 3 }, &[2, 3, 4], &[1]); // ldm r1!, {r2, r3, r4}
        check(0xD0FE, Kind::Jump, &[], &[]); // beq
        check(0xE7FE, Kind::Jump, &[], &[]); // b
    }

    #[test]
    fn thirty_two_bits() {
        check(0xEB02, 0x0183, Kind::Data, &[1], &[]); // add.w r1, r2, r3, lsl #2
        check(0xEBB1, 0x0F09, Kind::Data, &[], &[]); // cmp.w r1, r9
        check(0xF240, 0x41D2, Kind::Data, &[1], &[]); // movw r1, #1234
        check(0xF3C2, 0x01C3, Kind::Data, &[1], &[]); // ubfx r1, r2, #3, #4
        check(0xF501, 0x7980, Kind::Data, &[9], &[]); // add.w r9, r1, #256
        check(0xFB01, 0x3902, Kind::Data, &[9], &[]); // mla r9, r1, r2, r3
        check(0xFB82, 0x1903, Kind::Data, &[1, 9], &[]); // smull r1, r9, r2, r3
        check(0xFBE3, 0x1204, Kind::Data, &[1, 2], &[]); // umlal r1, r2, r3, r4
        check(0xFBB1, 0xF9F2, Kind::Divide { signed: false }, &[9], &[]); // udiv r9, r1, r2
        check(0xFB92, 0xF1F3, Kind::Divide { signed: true }, &[1], &[]); // sdiv r1, r2, r3
        check(0xFAB2, 0xF182, Kind::Data, &[1], &[]); // clz r1, r2
        check(0xF000, 0xF800, Kind::Link, &[], &[]); // bl
        check(0xF000, 0xB800, Kind::Jump, &[], &[]); // b.w
        check(0xF000, 0x8190, Kind::Jump, &[], &[]); // beq.w
        check(0xF3BF, 0x8F5F, Kind::System, &[], &[]); // dmb sy
        check(0xF3EF, 0x8110, Kind::System, &[1], &[]); // mrs r1, primask
        check(0xF3AF, 0x8000, Kind::Data, &[], &[]); // nop.w
        check(0xEE10, 0x1A10, Kind::Data, &[1], &[]); // vmov r1, s0
        check(0xEE00, 0x1A10, Kind::Data, &[], &[]); // vmov s0, r1
    }

    #[test]
    fn floats() {
        check(0xEE30, 0x1A01, Kind::Data, &[], &[]); // vadd.f32 s2, s0, s2
        check(0xEE20, 0x1A01, Kind::Data, &[], &[]); // vmul.f32 s2, s0, s2
        check(0xEEB4, 0x0A60, Kind::Data, &[], &[]); // vcmp.f32 s0, s1
        check(0xEEBD, 0x0AC0, Kind::Data, &[], &[]); // vcvt.s32.f32 s0, s0
        check(0xEEF1, 0xFA10, Kind::Data, &[], &[]); // vmrs APSR_nzcv, fpscr
        check(0xEE80, 0x0A20, Kind::FloatDivide, &[], &[]); // vdiv.f32 s0, s0, s1
        check(0xEEC0, 0x0A20, Kind::FloatDivide, &[], &[]); // vdiv.f32 s1, s0, s1
        check(0xEEB1, 0x0AC0, Kind::FloatDivide, &[], &[]); // vsqrt.f32 s0, s0
        check(0xEEB1, 0x0A40, Kind::Data, &[], &[]); // vneg.f32 s0, s0
        check(0xEE00, 0x0A20, Kind::FloatMultiplyAdd, &[], &[]); // vmla.f32 s0, s0, s1
        check(0xEEA0, 0x0A20, Kind::FloatMultiplyAdd, &[], &[]); // vfma.f32 s0, s0, s1
        check(0xEEE0, 0x0A20, Kind::FloatMultiplyAdd, &[], &[]); // vfma.f32 s1, s0, s1
    }

    #[test]
    fn thirty_two_bits_of_memory() {
        check(0xF8C9, 0x1004, STORE, &[], &[9]); // str.w r1, [r9, #4]
        check(0xF842, 0x1B04, STORE, &[], &[2]); // str r1, [r2], #4
        check(0xF842, 0x1D04, STORE, &[], &[2]); // str r1, [r2, #-4]!
        check(0xF842, 0x1023, BY_REGISTER, &[], &[2, 3]); // str.w r1, [r2, r3, lsl #2]
        check(0xF829, 0x1003, BY_REGISTER, &[], &[3, 9]); // strh.w r1, [r9, r3]
        check(0xF8D9, 0x1004, Kind::Load, &[1], &[9]); // ldr.w r1, [r9, #4]
        check(0xF852, 0x1B04, Kind::Load, &[1], &[2]); // ldr r1, [r2], #4
        check(0xF852, 0x1023, Kind::Load, &[1], &[2, 3]); // ldr.w r1, [r2, r3, lsl #2]
        check(0xF81F, 0x9003, Kind::Load, &[9], &[]); // ldrb.w r9, [pc, #-3]
        check(0xF852, 0xF023, Kind::Load, &[15], &[2, 3]); // ldr.w pc, [r2, r3, lsl #2]
        check(0xF891, 0xF000, Kind::Data, &[], &[]); // pld [r1]
        check(0xE9D3, 0x1202, Kind::Double, &[1, 2], &[3]); // ldrd r1, r2, [r3, #8]
        check(0xE9C3, 0x1202, Kind::Double, &[], &[3]); // strd r1, r2, [r3, #8]
        check(0xE8E3, 0x1202, Kind::Double, &[], &[3]); // strd r1, r2, [r3], #8
        check(0xE852, 0x1F00, Kind::Load, &[1], &[2]); // ldrex r1, [r2]
        check(0xE843, 0x2100, Kind::Load, &[], &[3]); // strex r1, r2, [r3]
        check(0xE8DF, 0xF000, Kind::Table, &[], &[0]); // tbb [pc, r0]
        check(0xE8D1, 0xF010, Kind::Table, &[], &[0, 1]); // tbh [r1, r0, lsl #1]
        check(0xE8A9, 0x0106, Kind::Multiple { count: 3 }, &[], &[9]); // stm.w r9!, {r1, r2, r8}
        check(0xE92D, 0x4110, Kind::Multiple { count: 3 }, &[], &[13]); // push.w {r4, r8, lr}
        check(0xE8BD, 0x8110, Kind::Multiple { count: 3 }, &[4, 8, 15], &[13]); // pop.w {r4, r8, pc}
        check(0xED91, 0x0A01, Kind::Multiple { count: 1 }, &[], &[1]); // vldr s0, [r1, #4]
        check(0xED91, 0x0B01, Kind::Multiple { count: 2 }, &[], &[1]); // vldr d0, [r1, #4]
        check(0xED2D, 0x8B04, Kind::Multiple { count: 4 }, &[], &[13]); // vpush {d8, d9}
        check(0xECB1, 0x0A03, Kind::Multiple { count: 3 }, &[], &[1]); // vldmia r1!, {s0, s1, s2}
    }
}
