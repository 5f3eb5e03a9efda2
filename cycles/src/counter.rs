//! Cycles of a section of a program, from what the emulator sees of it.

use crate::instruction::{Instruction, Outcome};
use crate::model::{unaligned, Core, Model};

/// An instruction at its place.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// Where it is.
    pub address: u64,
    /// How many bytes it has.
    pub size: u8,
    /// What it is.
    pub instruction: Instruction,
}

/// Adds up while a section lasts.
#[derive(Clone, Debug)]
pub struct Counter {
    core: Core,
    section: Option<Section>,
}

#[derive(Clone, Debug)]
struct Section {
    model: Model,
    cycles: u64,
    /// The instruction that has started, and what is known of it so far.
    current: Option<(Step, Outcome)>,
}

impl Counter {
    /// No section has begun.
    pub const fn new(core: Core) -> Self {
        Self { core, section: None }
    }

    /// An instruction starts: the one before has come to its end.
    pub fn start(&mut self, step: Step) {
        if let Some(section) = &mut self.section {
            section.end(step);
            section.current = Some((step, Outcome::default()));
        }
    }

    /// The instruction that has started goes to memory, for `1 << shift` bytes.
    pub fn access(&mut self, address: u64, shift: u32) {
        if let Some(Section { current: Some((_, outcome)), .. }) = &mut self.section {
            outcome.accessed = true;
            outcome.unaligned += unaligned(address, shift);
        }
    }

    /// A section begins before this instruction, or ends there: then it returns its cycles.
    pub fn mark(&mut self, step: Step) -> Option<u64> {
        let Some(mut section) = self.section.take() else {
            self.section = Some(Section { model: Model::new(self.core), cycles: 0, current: None });
            return None;
        };
        section.end(step);
        Some(section.cycles)
    }
}

impl Section {
    /// The current instruction ends, and this one comes next.
    fn end(&mut self, next: Step) {
        if let Some((step, outcome)) = self.current.take() {
            let taken = next.address != step.address + u64::from(step.size);
            let (address, next, next_size) = (step.address, next.address, next.size);
            let outcome = Outcome { address, next, next_size, taken, ..outcome };
            self.cycles += u64::from(self.model.cycles(step.instruction, outcome));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::thumb::decode;

    /// Runs instructions of 16 bits at these halfwords between two marks.
    fn section(core: Core, codes: &[u16], places: &[u16]) -> Option<u64> {
        let mut counter = Counter::new(core);
        let step = |place: u16, code| Step { address: 2 * u64::from(place), size: 2, instruction: decode(code, 0) };
        assert_eq!(counter.mark(step(0, NOP)), None, "it begins");
        for &place in places {
            counter.start(step(place, codes[usize::from(place)]));
            counter.access(0x2000_0000, 2);
        }
        counter.mark(step(u16::try_from(codes.len()).expect("few"), NOP))
    }

    const NOP: u16 = 0xBF00;

    /// Fills four words: str r1, [r2]; adds r2, #4; subs r0, #1; bne.
    const FILL: [u16; 4] = [0x6011, 0x3204, 0x3801, 0xD1FB];

    #[test]
    fn a_loop_of_four_turns() {
        let turns: Vec<u16> = (0..4).flat_map(|_| 0..4).collect();
        assert_eq!(section(Core::M4, &FILL, &turns), Some(3 * 6 + 4), "the last branch is not taken");
        assert_eq!(section(Core::M0, &FILL, &turns), Some(3 * 6 + 5));
    }

    #[test]
    fn nothing_counts_outside() {
        let mut counter = Counter::new(Core::M4);
        let nop = |address| Step { address, size: 2, instruction: decode(NOP, 0) };
        counter.start(nop(0));
        counter.access(0, 2);
        counter.mark(nop(0));
        assert_eq!(counter.mark(nop(0)), Some(0), "an empty section");
        counter.start(nop(0));
        counter.mark(nop(0));
        counter.start(nop(0));
        assert_eq!(counter.mark(nop(2)), Some(1), "the second section starts anew");
    }

    #[test]
    fn addresses_matter() {
        let mut counter = Counter::new(Core::M4);
        let step = |address, code| Step { address, size: 2, instruction: decode(code, 0) };
        counter.mark(step(0, NOP));
        counter.start(step(0, 0x6011));
        counter.access(0x2000_0001, 2);
        assert_eq!(counter.mark(step(2, NOP)), Some(3), "a word at an odd byte");
    }
}
