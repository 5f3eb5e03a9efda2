//! What an instruction costs on Hazard3, the open RISC-V core of RP2350, whose designer publishes its timings.
//!
//! | | cycles |
//! |---|---|
//! | data processing, multiplication, loads, stores | 1 |
//! | the instruction after a load that needs what was loaded, but to store it | 1 more |
//! | `divu`, `remu` | 18 |
//! | `div`, `rem` | 19 |
//! | `jal`, `jalr` | 2 |
//! | branch, as predicted | 1 |
//! | branch, not as predicted | 2 |
//! | any jump to an instruction of 32 bits that does not begin at a word | 1 more |
//! | `ecall`, `ebreak` | 3 |
//!
//! One branch is predicted to be taken: the last one that was taken backwards, until it is not taken. All others are predicted
//! not to be.
//!
//! What cannot be known is taken as follows. A signed division takes 18 or 19, depending on signs that are not seen. Left out are
//! wait states, as elsewhere. The extensions for bits (Zba, Zbb, Zbs, Zcb, Zcmp) that RP2350 has too are not used by what is measured:
//! it is built for RV32IMC, which all chips of the kind run.
//!
//! Source: L. Wren, "Hazard3", section "Instruction Cycle Counts", for `MULDIV_UNROLL` 2 and all else set for performance, as in
//! RP2350.

use crate::instruction::{Instruction, Kind, Outcome, Registers};

/// Cycles of one instruction after the other.
#[derive(Clone, Debug)]
pub struct Hazard3 {
    /// What the instruction before loaded.
    loaded: Registers,
    /// Where the branch is that is predicted to be taken.
    predicted: Option<u64>,
}

impl Hazard3 {
    pub(crate) const fn new() -> Self {
        Self { loaded: 0, predicted: None }
    }

    /// Cycles of an instruction that has come to its end.
    pub(crate) fn cycles(&mut self, Instruction { kind, writes, needs }: Instruction, outcome: Outcome) -> u32 {
        let wait = u32::from(self.loaded & needs != 0);
        self.loaded = if kind == Kind::Load { writes } else { 0 };
        let split = u32::from(outcome.taken && outcome.next_size == 4 && outcome.next & 2 != 0);
        let cycles = match kind {
            Kind::Divide { signed } => 18 + u32::from(signed),
            Kind::Jump | Kind::Link => 2,
            Kind::Branch => 1 + u32::from(!self.foresees(outcome)),
            Kind::System => 3,
            // Data, loads and stores; all else is in Thumb code only.
            _ => 1,
        };
        cycles + wait + split
    }

    /// Whether this branch went as predicted; and learns from it.
    fn foresees(&mut self, Outcome { address, next, taken, .. }: Outcome) -> bool {
        let predicted = self.predicted == Some(address);
        if taken && next <= address {
            self.predicted = Some(address);
        } else if predicted && !taken {
            self.predicted = None;
        }
        predicted == taken
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::riscv::{decode, size};

    /// Cycles of instructions of which each is given with its address. After the last one comes one at `end`, of 16 bits.
    #[allow(clippy::cast_possible_truncation, reason = "cut in two")]
    fn cycles(program: &[(u64, u32)], end: u64) -> u32 {
        let mut model = Hazard3::new();
        let size = |code: u32| size(code as u16);
        let following = program[1..].iter().map(|&(address, code)| (address, size(code))).chain([(end, 2)]);
        let cycles = |(&(address, code), (next, next_size)): (&(u64, u32), _)| {
            let taken = next != address + u64::from(size(code));
            let outcome = Outcome { address, next, next_size, taken, ..Outcome::default() };
            model.cycles(decode(code as u16, (code >> 16) as u16), outcome)
        };
        program.iter().zip(following).map(cycles).sum()
    }

    const LW: u32 = 0x0045_A503; // lw a0, 4(a1)
    const ADD: u32 = 0x00C5_0533; // add a0, a0, a2
    const SW: u32 = 0x00A5_A223; // sw a0, 4(a1)
    const NOP: u32 = 0x0001; // c.nop
    const ADDI: u32 = 0x157D; // c.addi a0, -1
    const BNEZ: u32 = 0xFD7D; // c.bnez a0, -2

    #[test]
    fn loads_keep_waiting_only_who_needs_them() {
        assert_eq!(cycles(&[(0, LW), (4, ADD)], 8), 3, "lw a0; add a0, a0, a2");
        assert_eq!(cycles(&[(0, LW), (4, SW)], 8), 2, "lw a0; sw a0: it is stored late");
        assert_eq!(cycles(&[(0, LW), (4, NOP), (6, ADD)], 10), 3, "with another instruction between");
        assert_eq!(cycles(&[(0, 0x0005_A583), (4, 0x0005_A583)], 8), 3, "lw a1, (a1), twice: the links of a list");
    }

    #[test]
    fn divisions_and_jumps() {
        assert_eq!(cycles(&[(0, 0x02C5_D533)], 4), 18, "divu a0, a1, a2");
        assert_eq!(cycles(&[(0, 0x02C5_C533)], 4), 19, "div a0, a1, a2");
        assert_eq!(cycles(&[(0, 0x02C5_8533)], 4), 1, "mul a0, a1, a2");
        assert_eq!(cycles(&[(0, 0x8082)], 100), 2, "ret");
        assert_eq!(cycles(&[(0, 0xA021), (8, ADD)], 12), 2 + 1, "c.j to an instruction at a word");
        assert_eq!(cycles(&[(0, 0xA029), (10, ADD)], 14), 3 + 1, "c.j to one that straddles words");
        assert_eq!(cycles(&[(0, 0xA029), (10, NOP)], 12), 2 + 1, "a short one does not");
    }

    #[test]
    fn loops_are_foreseen() {
        let turn = [(0, ADDI), (2, BNEZ)];
        assert_eq!(cycles(&turn, 0), 1 + 2, "the first turn");
        assert_eq!(cycles(&turn, 4), 1 + 1, "no turn");
        let turns = [turn, turn, turn, turn].concat();
        assert_eq!(cycles(&turns, 4), (1 + 2) + 2 * (1 + 1) + (1 + 2), "until it ends");
        let forward = [(0, 0xE501), (8, 0xE501)]; // c.bnez a0, 8
        assert_eq!(cycles(&forward, 16), 4, "nobody foresees jumps forward");
    }
}
