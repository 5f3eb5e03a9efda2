//! Random numbers from a seed: the same shapes on every machine.

/// `SplitMix64` (G. Steele, D. Lea, C. Flood, 2014).
pub(crate) struct Rng(u64);

impl Rng {
    pub(crate) const fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// `low..=high`.
    pub(crate) fn range(&mut self, low: i64, high: i64) -> i64 {
        low + ((u128::from(self.bits()) * (high - low + 1) as u128) >> 64) as i64
    }

    /// `low..=high`.
    pub(crate) fn int(&mut self, low: i32, high: i32) -> i32 {
        self.range(low.into(), high.into()) as i32
    }

    /// `0.0..1.0`.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }
}
