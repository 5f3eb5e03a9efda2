//! [`RasterOp`]: the bits of what is there, masked and flipped.

use core::marker::PhantomData;

use super::traits::Paint;
use crate::{pixel::PixelFormat, span::ClippedSpan, surface::Readable};

/// A raster operation: every pixel of a shape becomes a function of what it was, bit by bit.
///
/// The bits are those of the colour, as [`PixelFormat::pack`] numbers them for the type of the colour: whether memory has them in
/// another order does not matter. As a shape names each of its pixels once, a shape that is drawn twice by [`xor`](Self::xor) or
/// [`invert`](Self::invert) is gone again: cursors, rubber bands and the chosen line of a menu are drawn so.
///
/// | operation | new bits | of an index or a grey, for example |
/// |---|---|---|
/// | [`and`](Self::and) | `old & color` | clears planes of bits |
/// | [`or`](Self::or) | `old \| color` | sets planes of bits |
/// | [`xor`](Self::xor) | `old ^ color` | flips planes of bits |
/// | [`invert`](Self::invert) | `!old` | the negative |
///
/// A pixel that a soft rim covers by half or more is one of the shape.
/// ```
/// use embedded_graphics_core::pixelcolor::BinaryColor;
/// use embedded_raster::{paint::RasterOp, raster::rectangle, Canvas, Framebuffer, Rect};
/// let mut ram = [0b1010_1100];
/// let mut frame = Framebuffer::<BinaryColor>::new(&mut ram, 8, 1)?;
/// let chosen = Rect::new(2, 0, 6, 1);
/// frame.paint(RasterOp::invert(), |window, brush| rectangle::fill(chosen, window, brush));
/// assert_eq!(frame.row_bytes(0..1), [0b1001_0000]);
/// frame.paint(RasterOp::invert(), |window, brush| rectangle::fill(chosen, window, brush));
/// assert_eq!(ram, [0b1010_1100]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
///
/// Source: D. Ingalls, "The Smalltalk Graphics Kernel", BYTE 6(8), 1981 (`BitBlt` and its combination rules).
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct RasterOp<C> {
    /// Bits of the old colour that stay.
    keep: u32,
    /// Bits that are flipped then.
    flip: u32,
    color: PhantomData<C>,
}

impl<C: PixelFormat<Color = C>> RasterOp<C> {
    const ALL: u32 = u32::MAX >> (32 - C::BITS);

    #[inline]
    const fn new(keep: u32, flip: u32) -> Self {
        Self { keep, flip, color: PhantomData }
    }

    /// Clears the bits that are not set in a colour.
    #[inline]
    pub fn and(color: C) -> Self {
        Self::new(C::pack(color), 0)
    }

    /// Sets the bits that are set in a colour.
    #[inline]
    pub fn or(color: C) -> Self {
        let set = C::pack(color);
        Self::new(!set, set)
    }

    /// Flips the bits that are set in a colour.
    #[inline]
    pub fn xor(color: C) -> Self {
        Self::new(Self::ALL, C::pack(color))
    }

    /// Flips all bits.
    #[inline]
    pub const fn invert() -> Self {
        Self::new(Self::ALL, Self::ALL)
    }

    /// What becomes of a colour.
    #[inline(always)]
    pub fn of(self, old: C) -> C {
        C::unpack((C::pack(old) & self.keep ^ self.flip) & Self::ALL)
    }
}

impl<S: Readable> Paint<S> for RasterOp<S::Color>
where
    S::Color: PixelFormat<Color = S::Color>,
{
    // Not inlined into the loops of shapes: they have no registers to spare.
    #[inline(never)]
    fn span(&mut self, on: &mut S, span: ClippedSpan) {
        let op = *self;
        on.edit_span(span, |_, old| op.of(old));
    }
}
