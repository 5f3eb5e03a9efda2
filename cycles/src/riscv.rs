//! RISC-V instructions, RV32IMC: their kind, what they write, and what they read early.
//!
//! Source: The RISC-V Instruction Set Manual, volume I (20191213), chapters 2, 7, 16 and 24.

use crate::instruction::{Instruction, Kind, Registers};

/// The return address, and the stack pointer.
const RA: Registers = 1 << 1;
const SP: Registers = 1 << 2;

/// How many bytes an instruction has whose first halfword this is.
pub const fn size(first: u16) -> u8 {
    if first & 3 == 3 {
        4
    } else {
        2
    }
}

/// An instruction of 16 bits, or of 32: then `second` is its second halfword.
pub const fn decode(first: u16, second: u16) -> Instruction {
    let Instruction { kind, writes, needs } =
        if size(first) == 2 { compressed(first as u32) } else { base(first as u32 | (second as u32) << 16) };
    // Register 0 is always 0: nobody waits for it.
    Instruction { kind, writes: writes & !1, needs: needs & !1 }
}

/// The register whose number starts at this bit.
const fn register(code: u32, bit: u32) -> Registers {
    1 << (code >> bit & 31)
}

/// One of registers 8 to 15.
const fn popular(code: u32, bit: u32) -> Registers {
    1 << (8 + (code >> bit & 7))
}

const STORE: Kind = Kind::Store { by_register: false };

const fn base(code: u32) -> Instruction {
    let (rd, rs1, rs2) = (register(code, 7), register(code, 15), register(code, 20));
    let function = code >> 12 & 7;
    match code >> 2 & 31 {
        0b00000 => Instruction::new(Kind::Load).writing(rd).needing(rs1),
        // Immediates, and those with the program counter.
        0b00100 => Instruction::new(Kind::Data).writing(rd).needing(rs1),
        0b00101 | 0b01101 => Instruction::new(Kind::Data).writing(rd),
        0b01000 => Instruction::new(STORE).needing(rs1),
        0b01100 => {
            // Multiplications come first.
            let divides = code >> 25 == 1 && function >= 4;
            let kind = if divides { Kind::Divide { signed: function & 1 == 0 } } else { Kind::Data };
            Instruction::new(kind).writing(rd).needing(rs1 | rs2)
        }
        0b11000 => Instruction::new(Kind::Branch).needing(rs1 | rs2),
        0b11001 => Instruction::new(Kind::Jump).writing(rd).needing(rs1),
        0b11011 => Instruction::new(Kind::Jump).writing(rd),
        // Traps; then control and status registers, with a register or an immediate.
        0b11100 if function == 0 => Instruction::new(Kind::System),
        0b11100 => Instruction::new(Kind::Data).writing(rd).needing(if function < 4 { rs1 } else { 0 }),
        // Fences, and what RV32IM lacks.
        _ => Instruction::new(Kind::Data),
    }
}

const fn compressed(code: u32) -> Instruction {
    let (rd, rs2) = (register(code, 7), register(code, 2));
    let (low, high) = (popular(code, 2), popular(code, 7));
    let data = Instruction::new(Kind::Data);
    match (code & 3, code >> 13) {
        // `c.addi4spn`, `c.lw`, `c.sw`.
        (0, 0) => data.writing(low).needing(SP),
        (0, 2) => Instruction::new(Kind::Load).writing(low).needing(high),
        (0, 6) => Instruction::new(STORE).needing(high),
        // `c.addi`, `c.slli`; `c.jal`, `c.li`.
        (1 | 2, 0) => data.writing(rd).needing(rd),
        (1, 1) => Instruction::new(Kind::Jump).writing(RA),
        (1, 2) => data.writing(rd),
        // `c.addi16sp`, `c.lui`.
        (1, 3) => data.writing(rd).needing(if rd == SP { SP } else { 0 }),
        // Shifts and `c.andi`; then `c.sub`, `c.xor`, `c.or`, `c.and`.
        (1, 4) => data.writing(high).needing(if code >> 10 & 3 == 3 { high | low } else { high }),
        (1, 5) => Instruction::new(Kind::Jump),
        (1, _) => Instruction::new(Kind::Branch).needing(high),
        (2, 2) => Instruction::new(Kind::Load).writing(rd).needing(SP),
        (2, 4) => match (code >> 12 & 1, rd, rs2) {
            (0, _, 1) => Instruction::new(Kind::Jump).needing(rd),
            (0, ..) => data.writing(rd).needing(rs2),
            (_, 1, 1) => Instruction::new(Kind::System),
            (_, _, 1) => Instruction::new(Kind::Jump).writing(RA).needing(rd),
            _ => data.writing(rd).needing(rd | rs2),
        },
        (2, 6) => Instruction::new(STORE).needing(SP),
        // Floating point, which RV32IMC lacks.
        _ => data,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn registers(numbers: &[u32]) -> Registers {
        numbers.iter().fold(0, |set, number| set | 1 << number)
    }

    /// The kind, what is written, and what is read early, of a code of so many bytes.
    #[track_caller]
    #[allow(clippy::cast_possible_truncation, reason = "cut in two")]
    fn check(bytes: u8, code: u32, kind: Kind, writes: &[u32], needs: &[u32]) {
        let expected = Instruction { kind, writes: registers(writes), needs: registers(needs) };
        assert_eq!(decode(code as u16, (code >> 16) as u16), expected, "{code:08x}");
        assert_eq!(size(code as u16), bytes, "{code:08x}");
    }

    /// As the assembler of LLVM encodes them.
    #[test]
    fn thirty_two_bits() {
        let check = |code, kind, writes: &[u32], needs: &[u32]| check(4, code, kind, writes, needs);
        check(0x1234_52B7, Kind::Data, &[5], &[]); // lui t0, 0x12345
        check(0x0000_0297, Kind::Data, &[5], &[]); // auipc t0, 0
        check(0x0045_8513, Kind::Data, &[10], &[11]); // addi a0, a1, 4
        check(0x00C5_8533, Kind::Data, &[10], &[11, 12]); // add a0, a1, a2
        check(0x02C5_8533, Kind::Data, &[10], &[11, 12]); // mul a0, a1, a2
        check(0x02C5_B533, Kind::Data, &[10], &[11, 12]); // mulhu a0, a1, a2
        check(0x02C5_C533, Kind::Divide { signed: true }, &[10], &[11, 12]); // div a0, a1, a2
        check(0x02C5_D533, Kind::Divide { signed: false }, &[10], &[11, 12]); // divu a0, a1, a2
        check(0x02C5_E533, Kind::Divide { signed: true }, &[10], &[11, 12]); // rem a0, a1, a2
        check(0x02C5_F533, Kind::Divide { signed: false }, &[10], &[11, 12]); // remu a0, a1, a2
        check(0x0045_A503, Kind::Load, &[10], &[11]); // lw a0, 4(a1)
        check(0x0045_C503, Kind::Load, &[10], &[11]); // lbu a0, 4(a1)
        check(0x00A5_A223, STORE, &[], &[11]); // sw a0, 4(a1)
        check(0x00B5_0463, Kind::Branch, &[], &[10, 11]); // beq a0, a1, 8
        check(0x0080_00EF, Kind::Jump, &[1], &[]); // jal ra, 8
        check(0x0000_806F, Kind::Jump, &[], &[]); // j, by the register 0
        check(0x0005_80E7, Kind::Jump, &[1], &[11]); // jalr ra, a1
        check(0x0010_0073, Kind::System, &[], &[]); // ebreak
        check(0xC020_2573, Kind::Data, &[10], &[]); // csrr a0, instret
        check(0x0000_0013, Kind::Data, &[], &[]); // nop
    }

    #[test]
    fn sixteen_bits() {
        let check = |code, kind, writes: &[u32], needs: &[u32]| check(2, code, kind, writes, needs);
        check(0x0808, Kind::Data, &[10], &[2]); // c.addi4spn a0, sp, 16
        check(0x41C8, Kind::Load, &[10], &[11]); // c.lw a0, 4(a1)
        check(0xC1C8, STORE, &[], &[11]); // c.sw a0, 4(a1)
        check(0x0001, Kind::Data, &[], &[]); // c.nop
        check(0x0505, Kind::Data, &[10], &[10]); // c.addi a0, 1
        check(0x2021, Kind::Jump, &[1], &[]); // c.jal 8
        check(0x4505, Kind::Data, &[10], &[]); // c.li a0, 1
        check(0x6141, Kind::Data, &[2], &[2]); // c.addi16sp sp, 16
        check(0x6505, Kind::Data, &[10], &[]); // c.lui a0, 1
        check(0x8105, Kind::Data, &[10], &[10]); // c.srli a0, 1
        check(0x8905, Kind::Data, &[10], &[10]); // c.andi a0, 1
        check(0x8D0D, Kind::Data, &[10], &[10, 11]); // c.sub a0, a1
        check(0xA021, Kind::Jump, &[], &[]); // c.j 8
        check(0xC501, Kind::Branch, &[], &[10]); // c.beqz a0, 8
        check(0xE501, Kind::Branch, &[], &[10]); // c.bnez a0, 8
        check(0x0506, Kind::Data, &[10], &[10]); // c.slli a0, 1
        check(0x4512, Kind::Load, &[10], &[2]); // c.lwsp a0, 4
        check(0x8082, Kind::Jump, &[], &[1]); // c.jr ra
        check(0x852E, Kind::Data, &[10], &[11]); // c.mv a0, a1
        check(0x9002, Kind::System, &[], &[]); // c.ebreak
        check(0x9582, Kind::Jump, &[1], &[11]); // c.jalr a1
        check(0x952E, Kind::Data, &[10], &[10, 11]); // c.add a0, a1
        check(0xC22A, STORE, &[], &[2]); // c.swsp a0, 4
    }
}
