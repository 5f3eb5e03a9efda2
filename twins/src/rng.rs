//! Random numbers from a seed: the same shapes on every machine.

/// How many random cases a test takes that usually takes `usual`: as many per cent of them as the variable
/// `EMBEDDED_RASTER_CASES` says, but at least one.
pub fn cases(usual: usize) -> usize {
    (usual * percent() / 100).max(1)
}

fn percent() -> usize {
    match std::env::var("EMBEDDED_RASTER_CASES") {
        Ok(text) => {
            text.parse().unwrap_or_else(|_| panic!("EMBEDDED_RASTER_CASES is `{text}`: it is a number of per cent"))
        }
        Err(_) => 100,
    }
}

/// `SplitMix64` (G. Steele, D. Lea, C. Flood, 2014).
#[derive(Clone)]
pub struct Rng(u64);

impl Rng {
    /// From a seed; seeds may be small and follow each other.
    pub const fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x2545_f491_4f6c_dd1d) ^ 0x9e37_79b9_7f4a_7c15)
    }

    /// From a state as it is: the shapes of the lab, whose numbers are printed, have been made so.
    pub const fn with_state(state: u64) -> Self {
        Self(state)
    }

    /// Any 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// `0..n`.
    pub fn below(&mut self, n: u64) -> u64 {
        ((u128::from(self.bits()) * u128::from(n)) >> 64) as u64
    }

    /// `0..n`, as an index.
    pub fn index(&mut self, n: usize) -> usize {
        self.below(n as u64) as usize
    }

    /// `low..=high`.
    pub fn range(&mut self, low: i64, high: i64) -> i64 {
        low + self.below((high - low + 1) as u64) as i64
    }

    /// `low..=high`.
    pub fn int(&mut self, low: i32, high: i32) -> i32 {
        self.range(low.into(), high.into()) as i32
    }

    /// `0.0..1.0`.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// True once in `n` times.
    pub fn one_in(&mut self, n: u64) -> bool {
        self.below(n) == 0
    }

    /// For a test that goes through a list of cases: whether it takes the next one. It takes as large a share of them as [`cases`] does of
    /// random ones; all, unless the variable asks for less.
    pub fn takes_case(&mut self) -> bool {
        self.index(100) < percent()
    }

    /// One of some.
    pub fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.index(from.len())]
    }

    /// Into any order.
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            items.swap(i, self.index(i + 1));
        }
    }
}
