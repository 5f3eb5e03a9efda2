//! What an instruction of Thumb code costs, given the one before it: tables for memory without wait states.
//!
//! | | Cortex-M4 | Cortex-M0+ |
//! |---|---|---|
//! | data processing, multiplication | 1 | 1 |
//! | `sdiv`, `udiv` | 12 | |
//! | `vdiv`, `vsqrt` | 14 | |
//! | `vmla`, `vfma` | 3 | |
//! | load | 2, or 1 after a load or a store | 2 |
//! | store, `[r, #n]` | 1 | 2 |
//! | store, `[r, r]` | 2, or 1 after a load | 2 |
//! | `ldrd`, `strd` | 3 | |
//! | `ldm`, `stm`, `push`, `pop` of N | 1 + N | 1 + N |
//! | `pop` with `pc` | 1 + N + 2 | 3 + N |
//! | jump, taken | 1 + 2 | 2 |
//! | jump, not taken | 1 | 1 |
//! | `bl` | 1 + 2 | 3 |
//! | `tbb`, `tbh` | 6 | |
//! | special registers, barriers | 2 | 3 |
//!
//! On Cortex-M4 moreover:
//!
//! - A load costs 2 when its address comes from the load before it, and after a store with two registers, which nothing can
//!   overlap with. So do loads after `ldm`, `stm`, `ldrd` and `strd`.
//! - An address that the instruction just before it computed costs 1 more: there is no forwarding path.
//! - A word at an odd halfword, or a halfword at an odd byte, costs 1 more, a word at an odd byte 2.
//! - An instruction of an `it` block that is not executed costs 1.
//!
//! RISC-V is in [`hazard3`](crate::hazard3).
//!
//! What cannot be known is taken as follows. A division takes 2 to 12, fewer when its quotient is small; registers are
//! not seen, so it takes the most. A result of floating point costs 1 more when the next instruction asks for it; its
//! registers are not seen, so it does not. Filling the pipeline takes 1 to 3; it takes 2, but `ldr pc` and the jump
//! through a table, which are said to block, take 3. An `it` that is folded onto another instruction would cost nothing;
//! it costs 1. The multiplier of Cortex-M0+ is the fast one. Left out are wait states, and fetches that contend with
//! literals or that straddle words.
//!
//! Sources: Cortex-M4 Technical Reference Manual (100166), 3.3.1 and 3.3.2; Cortex-M0+ Technical Reference Manual (DDI 0484C),
//! 3.3.

use crate::hazard3::Hazard3;
use crate::instruction::{Instruction, Kind, Outcome, Registers, PC};
use crate::{riscv, thumb};

/// Whose table.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Core {
    /// Cortex-M0+.
    M0,
    /// Cortex-M4.
    M4,
    /// Hazard3, the RISC-V core of RP2350.
    Hazard3,
}

impl Core {
    /// An instruction that begins with these halfwords, and how many bytes it has.
    pub const fn decode(self, first: u16, second: u16) -> (Instruction, u8) {
        match self {
            Self::M0 | Self::M4 => (thumb::decode(first, second), thumb::size(first)),
            Self::Hazard3 => (riscv::decode(first, second), riscv::size(first)),
        }
    }
}

/// Cycles more for an access of `1 << shift` bytes at this address.
pub const fn unaligned(address: u64, shift: u32) -> u32 {
    match (shift, address & 3) {
        (1, 1 | 3) | (2, 2) => 1,
        (2, 1 | 3) => 2,
        _ => 0,
    }
}

/// The instruction before.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
enum Before {
    /// It computed these registers.
    Computed(Registers),
    /// It loaded these.
    Loaded(Registers),
    /// It stored one register, at an immediate offset.
    Stored,
    /// Nothing overlaps with it.
    Other,
}

/// Cycles of one instruction after the other.
#[derive(Clone, Debug)]
pub struct Model {
    core: Core,
    before: Before,
    hazard3: Hazard3,
}

/// Cycles that fill the pipeline after a jump of Cortex-M4.
const FILL: u32 = 2;
/// Of those that block.
const BLOCKING_FILL: u32 = 3;
/// The most that a division takes.
const DIVISION: u32 = 12;
/// A division of floats, and a product of them that is added to something.
const FLOAT_DIVISION: u32 = 14;
const FLOAT_MULTIPLY_ADD: u32 = 3;

impl Model {
    /// For this core.
    pub const fn new(core: Core) -> Self {
        Self { core, before: Before::Other, hazard3: Hazard3::new() }
    }

    /// Cycles of an instruction that has come to its end.
    pub fn cycles(&mut self, instruction: Instruction, outcome: Outcome) -> u32 {
        match self.core {
            Core::M0 => m0(instruction, outcome),
            Core::M4 => self.m4(instruction, outcome),
            Core::Hazard3 => self.hazard3.cycles(instruction, outcome),
        }
    }

    fn m4(&mut self, instruction: Instruction, outcome: Outcome) -> u32 {
        let Instruction { kind, writes, needs } = instruction;
        let memory = matches!(kind, Kind::Load | Kind::Store { .. } | Kind::Double | Kind::Multiple { .. });
        if memory && !outcome.accessed {
            self.before = Before::Other;
            return 1;
        }
        let stall = u32::from(matches!(self.before, Before::Computed(before) if before & needs != 0));
        let after_load = matches!(self.before, Before::Loaded(before) if before & needs == 0);
        let overlaps = u32::from(after_load || self.before == Before::Stored);
        let fill = if outcome.taken { FILL } else { 0 };
        let (cycles, before) = match kind {
            Kind::Data => (1, Before::Computed(writes)),
            Kind::Divide { .. } => (DIVISION, Before::Computed(writes)),
            Kind::FloatDivide => (FLOAT_DIVISION, Before::Other),
            Kind::FloatMultiplyAdd => (FLOAT_MULTIPLY_ADD, Before::Other),
            Kind::System => (2, Before::Computed(writes)),
            Kind::Load if writes & PC != 0 => (2 + BLOCKING_FILL, Before::Other),
            Kind::Load => (2 - overlaps, Before::Loaded(writes)),
            Kind::Store { by_register: false } => (1, Before::Stored),
            Kind::Store { by_register: true } => (2 - u32::from(after_load), Before::Other),
            Kind::Double => (3, Before::Other),
            Kind::Multiple { count } if writes & PC != 0 => (1 + u32::from(count) + FILL, Before::Other),
            Kind::Multiple { count } => (1 + u32::from(count), Before::Other),
            Kind::Jump | Kind::Branch | Kind::Link => (1 + fill, Before::Other),
            Kind::Table => (3 + BLOCKING_FILL, Before::Other),
        };
        self.before = before;
        cycles + stall + outcome.unaligned
    }
}

fn m0(instruction: Instruction, outcome: Outcome) -> u32 {
    let taken = u32::from(outcome.taken);
    match instruction.kind {
        // It divides by a function of many instructions, and has no floats.
        Kind::Data | Kind::Divide { .. } | Kind::FloatDivide | Kind::FloatMultiplyAdd => 1,
        Kind::System | Kind::Link => 3,
        Kind::Load | Kind::Store { .. } | Kind::Double => 2,
        Kind::Multiple { count } if instruction.writes & PC != 0 => 3 + u32::from(count),
        Kind::Multiple { count } => 1 + u32::from(count),
        Kind::Jump | Kind::Branch | Kind::Table => 1 + taken,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::thumb::decode;

    /// Cycles of some instructions that follow each other; those above 16 bits are of 32. All go to memory that shall, at
    /// aligned addresses, and the last is a jump that is taken, if it is one.
    fn cycles(core: Core, codes: &[u32]) -> u32 {
        let mut model = Model::new(core);
        let last = codes.len() - 1;
        let cycles = |(at, &code): (usize, &u32)| {
            let [first, second] = [code >> 16, code & 0xFFFF].map(|half| u16::try_from(half).expect("16 bits"));
            let instruction = if first == 0 { decode(second, 0) } else { decode(first, second) };
            model.cycles(instruction, Outcome { taken: at == last, accessed: true, ..Outcome::default() })
        };
        codes.iter().enumerate().map(cycles).sum()
    }

    fn m4(codes: &[u32]) -> u32 {
        cycles(Core::M4, codes)
    }

    fn m0(codes: &[u32]) -> u32 {
        cycles(Core::M0, codes)
    }

    const STR: u32 = 0x6051; // str r1, [r2, #4]
    const STRD: u32 = 0xE9C3_1202; // strd r1, r2, [r3, #8]
    const STM_8: u32 = 0xE8A9_00FF; // stm.w r9!, {r0-r7}
    const NOP: u32 = 0xBF00;

    #[test]
    fn sixteen_stores_are_cheaper_than_two_of_eight() {
        assert_eq!(m4(&[STR; 16]), 16);
        assert_eq!(m4(&[STM_8, STM_8]), 18, "the manual: an eight element store takes nine");
        assert_eq!(m4(&[STRD]), 3, "one more than two stores");
        assert_eq!(m0(&[STR; 16]), 32);
        assert_eq!(m0(&[0xC1FF, 0xC1FF]), 18, "there a store of many is better: stm r1!, {{r0-r7}}");
    }

    /// The examples of 3.3.2.
    #[test]
    fn loads_overlap() {
        assert_eq!(m4(&[0x6808, 0x6811]), 3, "ldr r0, [r1]; ldr r1, [r2]");
        assert_eq!(m4(&[0x5888, 0x6158]), 3, "ldr r0, [r1, r2]; str r0, [r3, #20]");
        assert_eq!(m4(&[0x5888, 0x5099]), 3, "ldr r0, [r1, r2]; str r1, [r3, r2]");
        assert_eq!(m4(&[0x5948, 0x6811, 0x685A]), 4, "ldr r0, [r1, r5]; ldr r1, [r2]; ldr r2, [r3, #4]");
        assert_eq!(m4(&[0xE891_000D]), 4, "ldm.w r1, {{r0, r2, r3}}: a three element load takes 2+1+1");
        assert_eq!(m0(&[0x6808, 0x6811]), 4, "not on the small core");
    }

    #[test]
    fn what_does_not_overlap() {
        assert_eq!(m4(&[0x6808, 0x6800]), 4, "ldr r0, [r1]; ldr r0, [r0]: the links of a list");
        assert_eq!(m4(&[0x50D1, 0x6811]), 4, "str r1, [r2, r3]; ldr r1, [r2]");
        assert_eq!(m4(&[0x50D1, 0x50D1]), 4, "nor two stores with two registers");
        assert_eq!(m4(&[STRD, 0x6811]), 5, "strd; ldr r1, [r2]");
        assert_eq!(m4(&[STM_8, 0x6811]), 11, "stm; ldr r1, [r2]");
        assert_eq!(m4(&[STR, 0x6811]), 2, "but after str r1, [r2, #4] a load does");
        assert_eq!(m4(&[0x6808, NOP, 0x6811]), 5, "they must be neighbours");
    }

    #[test]
    fn an_address_just_computed_waits() {
        assert_eq!(m4(&[0x3204, STR]), 3, "adds r2, #4; str r1, [r2, #4]");
        assert_eq!(m4(&[0x3204, NOP, STR]), 3, "with another instruction between");
        assert_eq!(m4(&[0x3104, STR]), 2, "what is stored may be new: adds r1, #4");
        assert_eq!(m0(&[0x3204, STR]), 3, "the small core has no such thing");
    }

    #[test]
    fn loops_and_calls() {
        let turn = [0x3801, 0xD1FD]; // subs r0, #1; bne
        assert_eq!((m4(&turn), m0(&turn)), (1 + 3, 1 + 2), "taken");
        let end = [0x3801, 0xD1FD, NOP]; // the last instruction is no jump
        assert_eq!((m4(&end), m0(&end)), (3, 3), "not taken");
        assert_eq!((m4(&[0xF000_F800]), m0(&[0xF000_F800])), (3, 3), "bl");
        assert_eq!((m4(&[0x4770]), m0(&[0x4770])), (3, 2), "bx lr");
        assert_eq!((m4(&[0xB530]), m0(&[0xB530])), (4, 4), "push {{r4, r5, lr}}");
        assert_eq!((m4(&[0xBD30]), m0(&[0xBD30])), (6, 6), "pop {{r4, r5, pc}}");
        assert_eq!(m4(&[0xE8DF_F000]), 6, "tbb: at least six cycles");
        assert_eq!(m4(&[0xF852_F023]), 5, "ldr pc: at least five");
        assert_eq!(m4(&[0xFBB1_F9F2]), 12, "udiv");
        assert_eq!((m4(&[0x4351]), m0(&[0x4351])), (1, 1), "muls");
    }

    #[test]
    fn what_is_skipped_costs_one() {
        let outcome = Outcome::default();
        assert_eq!(Model::new(Core::M4).cycles(decode(0xE9C3, 0x1202), outcome), 1);
    }

    #[test]
    fn addresses_that_are_not_aligned() {
        let words = [0, 1, 2, 3].map(|at| unaligned(0x2000_0000 + at, 2));
        let halfwords = [0, 1, 2, 3].map(|at| unaligned(0x2000_0000 + at, 1));
        assert_eq!((words, halfwords), ([0, 2, 1, 2], [0, 1, 0, 1]));
        assert_eq!(unaligned(1, 0), 0, "bytes are aligned everywhere");
        let outcome = Outcome { accessed: true, unaligned: 2, ..Outcome::default() };
        assert_eq!(Model::new(Core::M4).cycles(decode(0x6051, 0), outcome), 3, "str r1, [r2, #4]");
    }
}
