//! [`Owned`]: a screen together with its memory.

use core::{fmt, marker::PhantomData};

use super::{
    frame::Frame,
    layout::Layout,
    packed12::Packed12,
    pages::{paged_bytes, Pages},
    planes::Planes,
    rows::Rows,
};
use crate::pixel::{buffer_bytes, Index1, PixelFormat};

/// A screen of `WIDTH` x `HEIGHT` pixels that holds its own memory, all zero at first: what a firmware puts into a `static`.
///
/// [`frame`](Self::frame) lends it out as a [`Frame`], which all drawing is for. That cannot fail: the compiler checks that `BYTES` are
/// as many as the screen has. [`framebuffer!`](crate::framebuffer) counts them, for rows of a format:
/// ```
/// use embedded_raster::{framebuffer, Canvas, Index4};
/// use static_cell::ConstStaticCell;
/// type Screen = framebuffer!(Index4, 64, 48);
/// static SCREEN: ConstStaticCell<Screen> = ConstStaticCell::new(Screen::new());
/// let screen = SCREEN.take();
/// screen.frame().draw_line((0, 0), (63, 47), Index4::new(14));
/// assert_eq!((screen.bytes().len(), screen.bytes()[0]), (1_536, 0xe0));
/// ```
/// Any layout that this crate has can be owned:
/// ```
/// use embedded_graphics_core::pixelcolor::BinaryColor;
/// use embedded_raster::{pixel::Lsb0, surface::{paged_bytes, Owned, Pages}};
/// type Oled = Owned<Pages<Lsb0<BinaryColor>>, 128, 64, { paged_bytes(128, 64) }>;
/// static mut OLED: Oled = Oled::new();
/// ```
/// Another number of bytes does not compile:
/// ```compile_fail
/// use embedded_raster::{surface::{Owned, Rows}, Index4};
/// let screen = Owned::<Rows<Index4>, 64, 48, 1_535>::new();
/// ```
/// A `static` that is all zero takes no flash: nothing but the pixels is stored. They are aligned to words, as DMA and fast fills want
/// them.
#[repr(C, align(4))]
pub struct Owned<L, const WIDTH: u16, const HEIGHT: u16, const BYTES: usize> {
    memory: [u8; BYTES],
    // Whatever the layout is, memory can be sent and shared.
    layout: PhantomData<fn() -> L>,
}

/// Prints the sizes, not the pixels.
impl<L, const WIDTH: u16, const HEIGHT: u16, const BYTES: usize> fmt::Debug for Owned<L, WIDTH, HEIGHT, BYTES> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Owned")
            .field("width", &WIDTH)
            .field("height", &HEIGHT)
            .field("bytes", &BYTES)
            .finish_non_exhaustive()
    }
}

/// How many bytes a layout takes has to be known to the compiler, which a function of a trait cannot tell it.
macro_rules! owned {
    ($([$($generics:tt)*] $layout:ty: $bytes:expr;)*) => {$(
        impl<$($generics)* const WIDTH: u16, const HEIGHT: u16, const BYTES: usize> Owned<$layout, WIDTH, HEIGHT, BYTES> {
            /// All pixels zero.
            #[inline]
            #[expect(clippy::new_without_default, reason = "a constant, which `default` is not")]
            pub const fn new() -> Self {
                const { assert!(BYTES == $bytes, "BYTES are not those of WIDTH x HEIGHT pixels in this layout") };
                Self { memory: [0; BYTES], layout: PhantomData }
            }
        }
    )*};
}

owned! {
    [F: PixelFormat,] Rows<F>: buffer_bytes::<F>(WIDTH, HEIGHT);
    [F: PixelFormat,] Pages<F>: paged_bytes(WIDTH, HEIGHT);
    [F: PixelFormat,] Planes<F>: buffer_bytes::<Index1>(WIDTH, HEIGHT).saturating_mul(2);
    [] Packed12: Packed12::bytes_of(WIDTH, HEIGHT);
}

impl<L: Layout, const WIDTH: u16, const HEIGHT: u16, const BYTES: usize> Owned<L, WIDTH, HEIGHT, BYTES> {
    /// The screen, to be drawn on and read.
    #[inline]
    pub fn frame(&mut self) -> Frame<&mut [u8], L> {
        Frame::of_its_size(&mut self.memory, WIDTH, HEIGHT)
    }

    /// The screen, to be read: as the source of a blit, for example.
    #[inline]
    pub fn as_bitmap(&self) -> Frame<&[u8], L> {
        Frame::of_its_size(&self.memory, WIDTH, HEIGHT)
    }

    /// Its memory, from the first row to the last without gaps.
    #[inline]
    pub const fn bytes(&self) -> &[u8; BYTES] {
        &self.memory
    }
}

/// The type of a framebuffer that holds its own memory: of a pixel format, a width and a height.
///
/// It is [`Owned`](crate::surface::Owned) rows of that format, with their bytes counted.
/// ```
/// use embedded_raster::{framebuffer, Canvas, Index4};
/// type Screen = framebuffer!(Index4, 64, 48); // 1,536 bytes
/// let mut screen = Screen::new();
/// let mut frame = screen.frame();
/// frame.draw_line((0, 0), (63, 47), Index4::new(14));
/// ```
#[macro_export]
macro_rules! framebuffer {
    ($format:ty, $width:expr, $height:expr) => {
        $crate::surface::Owned<
            $crate::surface::Rows<$format>,
            { $width },
            { $height },
            { $crate::buffer_bytes::<$format>($width, $height) },
        >
    };
}
