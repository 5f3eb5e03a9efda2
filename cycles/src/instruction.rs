//! An instruction, as far as its time depends on it: what kind it is, what it writes, which registers it needs early, and what came
//! of it.

/// A set of registers: bit `n` is register `n`.
pub type Registers = u32;

/// The program counter of Thumb code, as a set of registers.
pub const PC: Registers = 1 << 15;

/// What an instruction does, as far as time is concerned.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Data processing, multiplication, hints.
    Data,
    /// A division, of signed numbers or not.
    Divide {
        /// Of signed numbers.
        signed: bool,
    },
    /// `vdiv`, `vsqrt`.
    FloatDivide,
    /// `vmla`, `vfma` and their like: a product and a sum.
    FloatMultiplyAdd,
    /// Special registers and barriers.
    System,
    /// One register, from memory.
    Load,
    /// One register, to memory.
    Store {
        /// Its address is the sum of two registers.
        by_register: bool,
    },
    /// `ldrd`, `strd`.
    Double,
    /// `ldm`, `stm`, `push`, `pop`, and those of floating point.
    Multiple {
        /// Words.
        count: u8,
    },
    /// Any jump that is not one of the following. It may be taken or not.
    Jump,
    /// A jump under a condition, on RISC-V.
    Branch,
    /// `bl`.
    Link,
    /// `tbb`, `tbh`.
    Table,
}

/// One instruction.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Instruction {
    /// What it does.
    pub kind: Kind,
    /// What it writes: the result of data processing, or what a load loads. A base that is written back is not among them.
    pub writes: Registers,
    /// What it needs early. In Thumb code: where the address of its memory comes from, but for the program counter. On RISC-V: all
    /// that it reads, but for what it stores.
    pub needs: Registers,
}

impl Instruction {
    pub(crate) const fn new(kind: Kind) -> Self {
        Self { kind, writes: 0, needs: 0 }
    }

    pub(crate) const fn writing(self, writes: Registers) -> Self {
        Self { writes, ..self }
    }

    pub(crate) const fn needing(self, needs: Registers) -> Self {
        Self { needs, ..self }
    }
}

/// What is known of an instruction when the next one starts.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Outcome {
    /// Where it is.
    pub address: u64,
    /// Where the next one is.
    pub next: u64,
    /// How many bytes that one has.
    pub next_size: u8,
    /// The next instruction is not the one that follows it in memory.
    pub taken: bool,
    /// It went to memory. What should have, and did not, was in an `it` block.
    pub accessed: bool,
    /// Cycles for an address that is not aligned: see [`unaligned`](crate::model::unaligned).
    pub unaligned: u32,
}
