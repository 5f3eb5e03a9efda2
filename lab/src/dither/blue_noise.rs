//! A table of thresholds whose patterns have no course that the eye would follow: void and cluster.
//!
//! A block of pixels is repeated all over the plane. Each of its places gets a rank; the places below any rank are as evenly spread, and as
//! irregular, as they can be. How crowded it is around a place is a sum of weights over all places that are taken, which fall with
//! their distance as a bell does: around `2^20 e^(-d^2 / 2 s^2)`, with s of 1.5 pixels.
//!
//! Source: R. Ulichney, "The Void-and-Cluster Method for Dither Array Generation", Proceedings of SPIE 1913, 1993.

use twins::rng::Rng;

/// A block that is being filled.
struct Block {
    side: usize,
    taken: Vec<bool>,
    /// How crowded it is around each place.
    crowd: Vec<i64>,
    /// The weight of a place that is so many columns and rows away.
    weights: Vec<i64>,
}

impl Block {
    fn new(side: usize) -> Self {
        let away = |n: usize| n.min(side - n) as f64;
        let weight = |n: usize| {
            let square = away(n % side).powi(2) + away(n / side).powi(2);
            (f64::from(1 << 20) * (-square / (2.0 * 1.5 * 1.5)).exp()).round() as i64
        };
        let count = side * side;
        Self { side, taken: vec![false; count], crowd: vec![0; count], weights: (0..count).map(weight).collect() }
    }

    /// Takes a place that is free, or frees one that is taken.
    fn flip(&mut self, at: usize) {
        let (side, sign) = (self.side, if self.taken[at] { -1 } else { 1 });
        self.taken[at] = !self.taken[at];
        for (to, crowd) in self.crowd.iter_mut().enumerate() {
            let (dx, dy) = ((to % side + side - at % side) % side, (to / side + side - at / side) % side);
            *crowd += sign * self.weights[dy * side + dx];
        }
    }

    /// The free place with the most room around it, the first one at a tie.
    fn void(&self) -> usize {
        let free = (0..self.taken.len()).filter(|&at| !self.taken[at]);
        free.min_by_key(|&at| self.crowd[at]).expect("a free place")
    }

    /// The taken place that is most crowded, the first one at a tie.
    fn cluster(&self) -> usize {
        let taken = (0..self.taken.len()).filter(|&at| self.taken[at]);
        taken.min_by_key(|&at| -self.crowd[at]).expect("a taken place")
    }
}

/// The rank of each place of a block of `side` x `side` pixels, row by row: all numbers from 0 on.
pub(super) fn ranks(side: usize, seed: u64) -> Vec<u16> {
    let (mut block, mut rng) = (Block::new(side), Rng::new(seed));
    let first = side * side / 10;
    while block.taken.iter().filter(|&&taken| taken).count() < first {
        let at = rng.below((side * side) as u64) as usize;
        if !block.taken[at] {
            block.flip(at);
        }
    }
    // Spread evenly: what is most crowded goes where most room is, until that is the place that it came from.
    loop {
        let from = block.cluster();
        block.flip(from);
        let to = block.void();
        block.flip(to);
        if from == to {
            break;
        }
    }
    let mut ranks = vec![0; side * side];
    // The ranks below are those in which they are freed again, the most crowded first; those above take the largest void.
    let start = block.taken.clone();
    for rank in (0..first).rev() {
        let at = block.cluster();
        ranks[at] = rank as u16;
        block.flip(at);
    }
    for (at, _) in start.iter().enumerate().filter(|(_, &taken)| taken) {
        block.flip(at);
    }
    for rank in first..side * side {
        let at = block.void();
        ranks[at] = rank as u16;
        block.flip(at);
    }
    ranks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_rank_is_there_once() {
        for side in [4, 8, 16] {
            let mut ranks = ranks(side, 1);
            ranks.sort_unstable();
            assert!(ranks.iter().copied().eq(0..(side * side) as u16), "{side}");
        }
    }

    /// Of any number of places that are taken, no two touch as long as there is room: a sixteenth are 3 pixels apart at least.
    #[test]
    fn places_are_spread() {
        let ranks = ranks(16, 1);
        let first: Vec<_> = (0..256).filter(|&at| ranks[at] < 16).map(|at| (at % 16, at / 16)).collect();
        let away = |a: usize, b: usize| a.abs_diff(b).min(16 - a.abs_diff(b)).pow(2);
        for (i, a) in first.iter().enumerate() {
            for b in &first[..i] {
                assert!(away(a.0, b.0) + away(a.1, b.1) >= 9, "{a:?} and {b:?}");
            }
        }
    }
}
