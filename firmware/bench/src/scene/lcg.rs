//! Numbers without pattern, the same on every chip.

use super::Ink;

/// The linear congruential generator of "Numerical Recipes".
pub struct Lcg(u32);

impl Lcg {
    /// From a seed.
    pub fn new(seed: u32) -> Self {
        Self(seed)
    }

    /// The upper 16 bits, which have the long period.
    pub fn bits(&mut self) -> u16 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.0 >> 16) as u16
    }

    /// One of `low..high`; at most 65,536 numbers.
    pub fn between(&mut self, low: i32, high: i32) -> i32 {
        low + ((i32::from(self.bits()) * (high - low)) >> 16)
    }

    /// Any ink.
    pub fn ink(&mut self) -> Ink {
        Ink(self.bits() | 1)
    }
}
