//! [`to_target`]: frames to any driver that embedded-graphics draws on.
//!
//! All such drivers take rectangles of colours. Most are slower with them than with bytes, as they go from colours to bytes again; but
//! nothing has to be known of the display.

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_raster::{
    surface::{Frame, Layout},
    Rect,
};

/// Sends areas of a frame of any layout to a display; `convert` turns its colours into those of the display, a palette for example.
/// `[frame.window()]` is all of a frame, or of a band. What lies outside is left out.
///
/// ```
/// use embedded_graphics_core::pixelcolor::{Rgb565, Rgb888};
/// use embedded_raster::{pixel::EGA, Bitmap, Framebuffer, Index4, Rect};
/// use embedded_raster_displays::to_target;
/// let picture = Bitmap::<Index4>::new(&[0x04, 0x2f], 4, 1)?;
/// let mut ram = [0; 4 * 2];
/// let mut display = Framebuffer::<Rgb565>::new(&mut ram, 4, 1)?; // or a driver
/// let palette = EGA.map(Rgb565::from);
/// to_target(&picture, [Rect::new(1, 0, 3, 1)], |index| palette.get(index.index()).unwrap_or_default(), &mut display);
/// assert_eq!(display.get((1, 0)), palette.get(4));
/// # Ok::<(), embedded_raster::BufferError>(())
/// ```
/// # Errors
/// The first one of the display.
pub fn to_target<M: AsRef<[u8]>, L: Layout, D: DrawTarget>(
    frame: &Frame<M, L>,
    areas: impl IntoIterator<Item = Rect>,
    mut convert: impl FnMut(L::Color) -> D::Color,
    display: &mut D,
) -> Result<(), D::Error> {
    for area in areas {
        let area = area.intersection(frame.window());
        if !area.is_empty() {
            display.fill_contiguous(&area.into(), frame.colors(area).map(&mut convert))?;
        }
    }
    Ok(())
}
