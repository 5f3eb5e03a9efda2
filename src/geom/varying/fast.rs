//! [`Fast`]: what is found in 32 bits along each row, and two numbers at once in 64.

use fixed::types::I16F16;

use super::{
    numbers::{NumberRow, Slopes},
    traits::Varying,
};
use crate::{
    geom::{facet::Facet, small::NoSmall},
    num::{
        cast::{low_u16, low_u32, low_u8, signed, unsigned},
        mixed::Mixed,
    },
};

/// A varying in its fast mode: in 32 bits along each row. The values of some pixels are not the nearest ones: see the
/// [module](super).
///
/// It is there for chips. A computer takes no less time for it: exact colours are even faster where the compiler makes vectors of them.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Fast<V>(pub V);

/// A number of up to 16 bits, in 32 bits.
#[derive(Copy, Clone, Debug)]
pub struct Short {
    at: u32,
    by: u32,
}

impl Short {
    #[inline(always)]
    pub(crate) fn new(slopes: &Slopes, row: Mixed, right: u32) -> Self {
        let cut = |n: Mixed| low_u32(n.cut(16) >> 32);
        // Towards zero, so that no value gets away from where the row began by more than it should.
        let up = u32::from(slopes.right.whole < 0);
        Self { at: cut(slopes.at(row, right)), by: cut(slopes.right).wrapping_add(up) }
    }

    #[inline(always)]
    pub(crate) fn value(self) -> u32 {
        self.at >> 16
    }

    #[inline(always)]
    pub(crate) fn step(&mut self) {
        self.at = self.at.wrapping_add(self.by);
    }
}

macro_rules! fast {
    ($($type:ty, |$n:ident| $value:expr;)*) => {
        $(impl Varying for Fast<$type> {
            type Slopes = Slopes;
            type Row = NumberRow;
            type Run = Short;
            type Small = NoSmall;

            #[inline(always)]
            fn slopes(facet: &Facet, corners: [Self; 3]) -> Slopes {
                Slopes::new(facet, corners.map(|n| n.0.into()), false)
            }

            #[inline(always)]
            fn row(slopes: &Slopes, down: u32) -> NumberRow {
                NumberRow(slopes.row(down))
            }

            #[inline(always)]
            fn below(slopes: &Slopes, row: &mut NumberRow) {
                row.0 += slopes.down;
            }

            #[inline(always)]
            fn run(slopes: &Slopes, row: &NumberRow, right: u32) -> Short {
                Short::new(slopes, row.0, right)
            }

            #[inline(always)]
            fn value(run: &Short) -> Self {
                let $n = run.value();
                Self($value)
            }

            #[inline(always)]
            fn step(run: &mut Short) {
                run.step();
            }
        })*
    };
}

fast! {
    u8, |n| low_u8(n);
    u16, |n| low_u16(n);
    i16, |n| low_i16(signed(n));
}

/// Two numbers of 32 bits at one pixel as one of 64, and what is added to it: the first one, and `2^32` times the second.
///
/// So the high word is the second number, or one less where the first is negative. Two separate numbers would take too many
/// registers: of each the compiler keeps four values, as the loop does four pixels in a turn.
#[derive(Copy, Clone, Debug)]
pub struct Pair {
    at: u64,
    by: u64,
}

impl Pair {
    #[inline(always)]
    pub(crate) fn new([first, second]: [i32; 2], [first_by, second_by]: [i32; 2]) -> Self {
        let join = |low: i32, high: i32| i64::from(high).wrapping_shl(32).wrapping_add(low.into()).cast_unsigned();
        Self { at: join(first, second), by: join(first_by, second_by) }
    }

    #[inline(always)]
    pub(crate) fn value(self) -> [i32; 2] {
        let (low, high) = (low_u32(self.at), low_u32(self.at >> 32));
        [signed(low), signed(high.wrapping_add(low >> 31))]
    }

    #[inline(always)]
    pub(crate) fn step(&mut self) {
        self.at = self.at.wrapping_add(self.by);
    }
}

impl Varying for Fast<(I16F16, I16F16)> {
    type Slopes = [Slopes; 2];
    type Row = [NumberRow; 2];
    type Run = Pair;
    type Small = NoSmall;

    #[inline(always)]
    fn slopes(facet: &Facet, corners: [Self; 3]) -> [Slopes; 2] {
        let of = |number: fn(Self) -> I16F16| Slopes::new(facet, corners.map(|n| number(n).to_bits().into()), true);
        [of(|n| n.0 .0), of(|n| n.0 .1)]
    }

    #[inline(always)]
    fn row([first, second]: &[Slopes; 2], down: u32) -> [NumberRow; 2] {
        [NumberRow(first.row(down)), NumberRow(second.row(down))]
    }

    #[inline(always)]
    fn below([first, second]: &[Slopes; 2], [first_row, second_row]: &mut [NumberRow; 2]) {
        first_row.0 += first.down;
        second_row.0 += second.down;
    }

    #[inline(always)]
    fn run([first, second]: &[Slopes; 2], [first_row, second_row]: &[NumberRow; 2], right: u32) -> Pair {
        // Towards zero, as above.
        let by = |slopes: &Slopes| slopes.right.whole.wrapping_add((slopes.right.whole < 0).into());
        let at = [first.at(first_row.0, right).whole, second.at(second_row.0, right).whole];
        Pair::new(at, [by(first), by(second)])
    }

    #[inline(always)]
    fn value(run: &Pair) -> Self {
        let [first, second] = run.value();
        Self((I16F16::from_bits(first), I16F16::from_bits(second)))
    }

    #[inline(always)]
    fn step(run: &mut Pair) {
        run.step();
    }
}

/// The low half.
#[inline(always)]
fn low_i16(n: i32) -> i16 {
    i16::from_le_bytes(low_u16(unsigned(n)).to_le_bytes())
}
