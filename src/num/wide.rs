//! Products of more than 64 bits.

use super::cast::{low_u32, signed_wide};

/// `(2^32 high + low) factor`, in the same form. The caller knows that the product fits into 96 bits.
#[inline(always)]
pub(crate) fn times((high, low): (i64, u32), factor: u32) -> (i64, u32) {
    let product = u64::from(low).wrapping_mul(u64::from(factor));
    (high.wrapping_mul(i64::from(factor)).wrapping_add(signed_wide(product >> 32)), low_u32(product))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_keep_their_carries() {
        for high in [0_i64, 1, -1, 1 << 40, -(1 << 40) - 7] {
            for low in [0_u32, 1, 0x8000_0000, u32::MAX] {
                for factor in [0_u32, 1, 3, 1 << 20, 0x003f_ffff] {
                    let (h, l) = times((high, low), factor);
                    let wanted = ((i128::from(high) << 32) + i128::from(low)) * i128::from(factor);
                    assert_eq!((i128::from(h) << 32) + i128::from(l), wanted, "{high} {low} {factor}");
                }
            }
        }
    }
}
