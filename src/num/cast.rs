//! The only casts of the crate: each names what it keeps.
#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "this is the one place that does it, under names that say what is lost"
)]

/// The low byte.
#[inline(always)]
pub(crate) const fn low_u8(bits: u32) -> u8 {
    bits as u8
}

/// The low half.
#[inline(always)]
pub(crate) const fn low_u16(bits: u32) -> u16 {
    bits as u16
}

/// The low word.
#[inline(always)]
pub(crate) const fn low_u32(bits: u64) -> u32 {
    bits as u32
}

/// The low 64 bits.
#[inline(always)]
pub(crate) const fn low_u64(bits: u128) -> u64 {
    bits as u64
}

/// A number that is known not to be negative, as an index.
#[inline(always)]
pub(crate) const fn index(n: i32) -> usize {
    n as u32 as usize
}

/// An index that is known to be below 2^16.
#[inline(always)]
pub(crate) const fn index_u16(i: usize) -> u16 {
    i as u16
}

/// A signed number to add to an index.
#[inline(always)]
pub(crate) const fn offset(n: i32) -> usize {
    n as isize as usize
}

/// The same 32 bits, read as a signed number.
#[inline(always)]
pub(crate) const fn signed(bits: u32) -> i32 {
    bits as i32
}

/// The same 32 bits, read as an unsigned number.
#[inline(always)]
pub(crate) const fn unsigned(n: i32) -> u32 {
    n as u32
}

/// The low 32 bits of a number that is known to fit.
#[inline(always)]
pub(crate) const fn narrow(n: i64) -> i32 {
    n as i32
}

/// The nearest `i32`.
#[inline]
pub(crate) const fn saturate(n: i64) -> i32 {
    if n > i32::MAX as i64 {
        i32::MAX
    } else if n < i32::MIN as i64 {
        i32::MIN
    } else {
        n as i32
    }
}

/// The bits of a number that is known not to be negative.
#[inline(always)]
pub(crate) const fn magnitude(n: i64) -> u64 {
    n as u64
}

/// A number that is known to be below 2^63, signed.
#[inline(always)]
pub(crate) const fn signed_wide(n: u64) -> i64 {
    n as i64
}
