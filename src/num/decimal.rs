//! 24.8 numbers as decimal fractions, for `defmt`, which does not know the types of `fixed`.

use fixed::types::I24F8;

/// A number in decimal digits: its sign, the whole part, and the thousandths.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct Decimal {
    is_negative: bool,
    whole: u32,
    thousandths: u32,
}

impl Decimal {
    /// Rounded to the nearest thousandth. As 1/256 is more than that, different numbers stay different.
    pub(crate) const fn new(n: I24F8) -> Self {
        let bits = n.to_bits().unsigned_abs();
        // At most 255 * 1000 / 256, which is rounded to 996.
        Self { is_negative: n.to_bits() < 0, whole: bits >> 8, thousandths: ((bits & 255) * 1000 + 128) >> 8 }
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Decimal {
    fn format(&self, f: defmt::Formatter<'_>) {
        let sign = if self.is_negative { "-" } else { "" };
        defmt::write!(f, "{=str}{=u32}.{=u32:03}", sign, self.whole, self.thousandths);
    }
}

#[cfg(test)]
mod tests {
    use std::{collections::HashSet, format, string::String};

    use super::*;

    fn text(n: I24F8) -> String {
        let Decimal { is_negative, whole, thousandths } = Decimal::new(n);
        format!("{}{whole}.{thousandths:03}", if is_negative { "-" } else { "" })
    }

    #[test]
    fn digits_are_those_of_the_number() {
        for bits in (-70_000..70_000).chain([i32::MIN, i32::MIN + 1, i32::MAX]) {
            let (n, text) = (I24F8::from_bits(bits), text(I24F8::from_bits(bits)));
            let distance = text.parse::<f64>().expect("a number") - n.to_num::<f64>();
            assert!(distance.abs() < 0.000_501, "{n} is written {text}");
            assert_eq!(text.starts_with('-'), bits < 0, "{n} is written {text}");
        }
        let all: HashSet<String> = (-600..600).map(|bits| text(I24F8::from_bits(bits))).collect();
        assert_eq!(all.len(), 1200, "some have the same digits");
        assert_eq!(text(I24F8::from_bits(-1)), "-0.004");
    }
}
