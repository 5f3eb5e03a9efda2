//! What LTDC reads with the registers of a layer, as RM0090 describes it.

use embedded_graphics_core::pixelcolor::{Rgb565, Rgb888};
use embedded_raster::{
    pixel::{Xrgb8888, EGA},
    surface::Rows,
    Frame, Index8, Palette,
};
use embedded_raster_displays::ltdc::{clut, Bus, Layer, LayerFormat};
use twins::rng::Rng;

use crate::pictures;

/// The pixel of a place on the glass: the raw bits that the layer reads from memory; `None` outside of the layer.
fn read(layer: &Layer, porch: (u32, u32), memory: &[u8], (x, y): (u32, u32)) -> Option<u32> {
    let ends = |register: u32| (register & 0xffff, register >> 16);
    let (columns, rows) = (ends(layer.horizontal_position), ends(layer.vertical_position));
    // The first pixel of the active area comes one clock after the back porch.
    let (x, y) = (x + porch.0 + 1, y + porch.1 + 1);
    if x < columns.0 || x > columns.1 || y < rows.0 || y > rows.1 {
        return None;
    }
    let bytes = [4, 3, 2, 0, 0, 1][layer.pixel_format as usize];
    let (pitch, length) = (layer.line_length >> 16, (layer.line_length & 0xffff) - 3);
    assert_eq!(length, (columns.1 - columns.0 + 1) * bytes, "bytes of a line");
    assert_eq!(layer.line_number, rows.1 - rows.0 + 1, "lines");
    let at = ((y - rows.0) * pitch + (x - columns.0) * bytes) as usize;
    let pixel = &memory[at..at + bytes as usize];
    Some(pixel.iter().rev().fold(0, |bits, &byte| bits << 8 | u32::from(byte)))
}

fn check<F: LayerFormat>(seed: u64) {
    let mut rng = Rng::new(seed);
    for case in 0..40 {
        let size = pictures::sizes(&mut rng);
        let memory = pictures::memory::<Rows<F>>(&mut rng, size);
        let frame = pictures::frame::<Rows<F>>(&memory, size);
        let at = (rng.int(0, 30) as u16, rng.int(0, 30) as u16);
        let porch = (rng.int(0, 200) as u16, rng.int(0, 200) as u16);
        let layer = Layer::of(&frame, at, porch, Bus::Bits32);
        for (y, x) in (0..60).flat_map(|y| (0..80).map(move |x| (y, x))) {
            let read = read(&layer, (porch.0.into(), porch.1.into()), &memory.0, (x, y));
            let read = read.map(|bits| F::pack(F::unpack(bits)));
            let wanted = frame.get((x as i32 - i32::from(at.0), y as i32 - i32::from(at.1))).map(F::pack);
            assert_eq!(read, wanted, "case {case}: ({x}, {y})");
        }
        let wide = Layer::of(&frame, at, porch, Bus::Bits64);
        assert_eq!(wide, Layer { line_length: layer.line_length + 4, ..layer }, "case {case}: a wider bus");
    }
}

#[test]
fn layers_show_frames() {
    check::<Index8>(1560);
    check::<Rgb565>(1561);
    check::<Rgb888>(1562);
    check::<Xrgb8888>(1563);
}

#[test]
fn tables_hold_palettes() {
    let words: Vec<u32> = clut(&EGA).collect();
    for (index, word) in (0..).zip(&words) {
        let [at, r, g, b] = word.to_be_bytes();
        assert_eq!((at, Some(Rgb888::new(r, g, b))), (index, EGA.get(index)));
    }
    let all = Palette::rgb332();
    assert_eq!(clut(&all).count(), 256);
    assert_eq!(clut(&all).last().map(|word| word >> 24), Some(255));
    // Few colours take the nearest levels.
    assert_eq!(clut(&Palette::new([Rgb565::new(31, 0, 31)])).next(), Some(0x00ff_00ff));
}

#[test]
fn a_layer_of_a_static_screen() {
    static PIXELS: [u8; 800 * 480] = [0; 800 * 480];
    let frame = Frame::<_, Rows<Index8>>::new(&PIXELS[..], 800, 480).expect("the right size");
    let layer = Layer::of(&frame, (0, 0), (47, 25), Bus::Bits32);
    assert_eq!(layer.horizontal_position, (47 + 800) << 16 | (47 + 1));
    assert_eq!(layer.vertical_position, (25 + 480) << 16 | (25 + 1));
}
