//! What `embassy-stm32` is told to show a frame of embedded-raster: a layer's window and format, and the table of its colours.
//!
//! ```no_run
//! # use embassy_layers::{layer, table};
//! # use embassy_stm32::ltdc::{Instance, Ltdc, LtdcLayer};
//! # use embedded_raster::{pixel::EGA, Bitmap, Index8};
//! # async fn show<T: Instance>(ltdc: &mut Ltdc<'_, T>) {
//! static PIXELS: [u8; 480 * 272] = [0; 480 * 272];
//! let frame = Bitmap::<Index8>::new(&PIXELS, 480, 272).expect("as large as the display");
//! let layer = layer(LtdcLayer::Layer1, &frame, (0, 0)).expect("nothing between its rows");
//! ltdc.init_layer(&layer, Some(&table(&EGA)));
//! let shown = ltdc.set_buffer(LtdcLayer::Layer1, frame.memory().as_ptr().cast()).await;
//! # drop(shown);
//! # }
//! ```
#![no_std]
#![forbid(unsafe_code)]

use embassy_stm32::ltdc::{LtdcLayer, LtdcLayerConfig, PixelFormat, RgbColor};
use embedded_graphics_core::pixelcolor::{Rgb565, Rgb888, RgbColor as Channels};
use embedded_raster::{
    surface::{Frame, Rows},
    Index8, Layout, Palette,
};
use embedded_raster_displays::ltdc::{colors, LayerFormat};

/// A format that `embassy-stm32` has a name for. `Xrgb8888` has none, as its first byte may be anything and is an alpha there.
pub trait Named: LayerFormat {
    /// That name.
    const NAME: PixelFormat;
}

impl Named for Rgb888 {
    const NAME: PixelFormat = PixelFormat::RGB888;
}

impl Named for Rgb565 {
    const NAME: PixelFormat = PixelFormat::RGB565;
}

impl Named for Index8 {
    const NAME: PixelFormat = PixelFormat::L8;
}

/// A layer that shows a frame, its first pixel at a column and a row of the display. Ends beyond 65,535 are cut. `None` if there is
/// something between the rows in memory: `embassy-stm32` has no word for that.
pub fn layer<M: AsRef<[u8]>, F: Named>(
    layer: LtdcLayer,
    frame: &Frame<M, Rows<F>>,
    (x, y): (u16, u16),
) -> Option<LtdcLayerConfig> {
    let size = frame.size();
    let row = u16::try_from(size.width).ok()?;
    if frame.stride() != Rows::<F>::row_bytes(row) {
        return None;
    }
    let end = |start: u16, count: u32| start.saturating_add(u16::try_from(count).unwrap_or(u16::MAX));
    Some(LtdcLayerConfig {
        layer,
        pixel_format: F::NAME,
        window_x0: x,
        window_x1: end(x, size.width),
        window_y0: y,
        window_y1: end(y, size.height),
    })
}

/// The table of all 256 indices that a layer is started with; what the palette lacks is black.
pub fn table<C: Channels + Into<Rgb888>, const N: usize>(palette: &Palette<C, N>) -> [RgbColor; 256] {
    let mut colors = colors(palette);
    core::array::from_fn(|_| {
        let [red, green, blue] = colors.next().unwrap_or_default();
        RgbColor { red, green, blue }
    })
}

#[cfg(test)]
mod tests {
    use embedded_raster::{pixel::EGA, Bitmap};
    use embedded_raster_displays::ltdc::{clut, Bus, Layer};

    use super::*;

    #[test]
    fn formats_have_the_same_codes() {
        fn same<F: Named>() {
            assert_eq!(F::NAME as u32, F::CODE);
        }
        same::<Rgb888>();
        same::<Rgb565>();
        same::<Index8>();
    }

    /// `clut` writes what `embassy-stm32` writes for the table: index, red, green, blue.
    #[test]
    fn tables_have_the_same_colours() {
        let table = table(&EGA);
        let words = (0..).zip(&table).map(|(index, c)| u32::from_be_bytes([index, c.red, c.green, c.blue]));
        assert!(words.take(16).eq(clut(&EGA)));
        assert!(table[16..].iter().all(|&c| c == RgbColor { red: 0, green: 0, blue: 0 }));
    }

    #[test]
    fn a_window_has_the_pixels_of_its_frame() {
        static PIXELS: [u8; 31 * 17 * 2] = [0; 31 * 17 * 2];
        let frame = Bitmap::<Rgb565>::new(&PIXELS, 31, 17).expect("the right size");
        let config = layer(LtdcLayer::Layer2, &frame, (5, 9)).expect("nothing between its rows");
        assert_eq!((config.window_x0, config.window_x1), (5, 36));
        assert_eq!((config.window_y0, config.window_y1), (9, 26));
        // In registers the last column and row are those before the end, counted from 1 after the porch.
        let registers = Layer::of(&frame, (5, 9), (42, 11), Bus::Bits32);
        assert_eq!(registers.horizontal_position, (42 + u32::from(config.window_x1)) << 16 | (42 + 5 + 1));
        assert!(layer(
            LtdcLayer::Layer2,
            &Bitmap::<Rgb565>::with_stride(&PIXELS, 15, 17, 62).expect("it fits"),
            (0, 0)
        )
        .is_none());
        assert_eq!(registers.vertical_position, (11 + u32::from(config.window_y1)) << 16 | (11 + 9 + 1));
    }
}
