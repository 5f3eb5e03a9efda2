//! The entries: all calls of the lists.

use core::slice;

use calls::{blending, call, computing, frames, shading, texts, Arguments};
#[cfg(feature = "bits")]
use embedded_graphics_core::pixelcolor::BinaryColor;
#[cfg(feature = "others")]
use embedded_graphics_core::pixelcolor::Gray2;
use embedded_graphics_core::pixelcolor::{Rgb565, Rgb888};
#[cfg(feature = "words")]
use embedded_raster::pixel::Be;
#[cfg(feature = "bits")]
use embedded_raster::{pixel::Lsb0, surface::Pages};
#[cfg(feature = "others")]
use embedded_raster::{
    pixel::Xrgb8888,
    surface::{Packed12, Planes},
    Index1, Index8,
};
use embedded_raster::{
    surface::{Damage, Rows},
    Frame, Index4, Layout, Palette, Rect,
};

/// A framebuffer as a driver hands it over.
#[repr(C)]
pub struct Memory {
    bytes: *mut u8,
    len: usize,
    width: u16,
    height: u16,
    stride: usize,
    /// Of a band.
    rows: [u16; 2],
    /// A window in it.
    area: [i32; 4],
}

impl Memory {
    fn area(&self) -> Rect {
        let [x0, y0, x1, y1] = self.area;
        Rect { x0, y0, x1, y1 }
    }

    unsafe fn bytes(&self) -> &mut [u8] {
        slice::from_raw_parts_mut(self.bytes, self.len)
    }

    unsafe fn frame<L: Layout>(&self) -> Option<Frame<&mut [u8], L>> {
        Frame::with_stride(self.bytes(), self.width, self.height, self.stride).ok()
    }

    unsafe fn band<L: Layout>(&self) -> Option<Frame<&mut [u8], L>> {
        Frame::band(self.bytes(), self.width, self.height, self.rows[0]..self.rows[1]).ok()
    }
}

/// All calls of the list, by number, and what frames do besides.
macro_rules! layouts {
    ($($layout:ty: $draw:ident $frame:ident $text:ident;)*) => {$(
        #[no_mangle]
        pub unsafe extern "C" fn $draw(m: &Memory, a: &mut Arguments<'_, $layout>, number: usize) -> usize {
            let Some(mut frame) = m.frame::<$layout>() else { return 0 };
            call(&mut frame.clipped(m.area()), a, number)
        }
        #[no_mangle]
        pub unsafe extern "C" fn $frame(m: &Memory, a: &mut Arguments<'_, $layout>, number: usize) -> usize {
            let Some(mut band) = m.band::<$layout>() else { return 0 };
            frames::call(&mut band.view(m.area()), a, number)
        }
        #[no_mangle]
        pub unsafe extern "C" fn $text(m: &Memory, a: &mut Arguments<'_, $layout>, number: usize) -> usize {
            let Some(mut frame) = m.frame::<$layout>() else { return 0 };
            texts::call(&mut frame.clipped(m.area()), a, number)
        }
    )*};
}

#[cfg(feature = "bits")]
layouts! {
    Rows<Index4>: draw4 frame4 text4;
    Pages<Lsb0<BinaryColor>>: draw_pages frame_pages text_pages;
}

#[cfg(feature = "words")]
layouts! {
    Rows<Rgb565>: draw16 frame16 text16;
    Rows<Be<Rgb888>>: draw24 frame24 text24;
}

// Some of each kind are enough for a chip, and for every change: the linker has twice as much to do with all of them.
#[cfg(feature = "others")]
layouts! {
    Rows<Index1>: draw1 frame1 text1;
    Rows<Lsb0<Gray2>>: draw2 frame2 text2;
    Rows<Index8>: draw8 frame8 text8;
    Rows<Xrgb8888>: draw32 frame32 text32;
    Planes<Gray2>: draw_planes frame_planes text_planes;
    Packed12: draw_packed12 frame_packed12 text_packed12;
}

#[no_mangle]
pub extern "C" fn compute(on: &mut Palette<Rgb888, 16>, a: &mut Arguments<'_, Rows<Index4>>, number: usize) -> usize {
    computing::call(on, a, number)
}

#[no_mangle]
pub unsafe extern "C" fn paths(text: &Memory, a: &mut Arguments<'_, Rows<Index4>>, number: usize) -> usize {
    core::str::from_utf8(text.bytes()).map_or(0, |text| calls::paths::call(text, a, number))
}

#[no_mangle]
pub unsafe extern "C" fn shade(m: &Memory, a: &mut Arguments<'_, Rows<Index4>>, number: usize) -> usize {
    let Some(frame) = m.frame::<Rows<Rgb565>>() else { return 0 };
    shading::call(&frame.as_bitmap(), a, number)
}

#[no_mangle]
pub unsafe extern "C" fn blend(m: &Memory, a: &mut Arguments<'_, Rows<Index4>>, number: usize) -> usize {
    let Some(mut frame) = m.frame::<Rows<Rgb565>>() else { return 0 };
    blending::call(&mut frame, a, number)
}

#[no_mangle]
pub extern "C" fn space(a: &calls::space::Arguments, number: usize) -> u32 {
    calls::space::call(a, number)
}

#[no_mangle]
pub extern "C" fn changed(on: &mut Damage<2>, a: &mut Arguments<'_, Rows<Index4>>, number: usize) -> usize {
    calls::damage::call(on, a, number)
}

#[no_mangle]
pub extern "C" fn hand_over(a: &calls::present::Arguments, number: usize) -> u32 {
    calls::present::call(a, number)
}
