//! [`Heat`]: how often each pixel is drawn.

use embedded_graphics_core::pixelcolor::Rgb888;
use embedded_raster::{ClippedSpan, Readable, Rect, Surface};

use crate::picture::Picture;

/// A surface around a surface that counts how often each pixel is painted: what is drawn over is work for nothing.
///
/// It sees everything as spans, so it is slow; what is drawn is the same.
/// ```
/// use embedded_raster::{Canvas, Framebuffer, Index4, Rect};
/// use embedded_raster_simulator::heat::{heat, Heat};
/// let mut ram = [0; 8];
/// let mut frame = Framebuffer::<Index4>::new(&mut ram, 4, 4)?;
/// let mut drawn = vec![0; 16];
/// let mut counted = Heat::new(&mut frame, 4, &mut drawn);
/// counted.fill_window(Index4::new(1));
/// counted.fill_rectangle(Rect::new(0, 0, 2, 1), Index4::new(2));
/// assert_eq!(drawn[..5], [2, 2, 1, 1, 1]);
/// println!("{}", heat(4, &drawn).preview(4));
/// # Ok::<(), embedded_raster::Error>(())
/// ```
pub struct Heat<'a, S> {
    surface: &'a mut S,
    width: usize,
    drawn: &'a mut [u16],
}

impl<'a, S> Heat<'a, S> {
    /// Adds to `drawn`, which has a number for each pixel of a screen of so many columns, row by row. Pixels elsewhere are not counted.
    pub fn new(surface: &'a mut S, width: usize, drawn: &'a mut [u16]) -> Self {
        Self { surface, width, drawn }
    }
}

impl<S: Surface> Surface for Heat<'_, S> {
    type Color = S::Color;

    fn window(&self) -> Rect {
        self.surface.window()
    }

    fn fill_span(&mut self, span: ClippedSpan, color: S::Color) {
        let place = |n: i32| usize::try_from(n).unwrap_or(0);
        let row = place(span.y()) * self.width;
        let columns = place(span.x0()).min(self.width)..place(span.x1()).min(self.width);
        let counts = self.drawn.get_mut(row + columns.start..row + columns.end).unwrap_or_default();
        for count in counts {
            *count = count.saturating_add(1);
        }
        self.surface.fill_span(span, color);
    }
}

impl<S: Readable> Readable for Heat<'_, S> {
    fn color_at(&self, x: i32, y: i32) -> S::Color {
        self.surface.color_at(x, y)
    }
}

/// A picture of such numbers: black where nothing was drawn, then from blue to red, and white from eight times on.
///
/// # Panics
/// If there is no column.
pub fn heat(width: usize, drawn: &[u16]) -> Picture {
    Picture::from_colors(width, drawn.len() / width, drawn.iter().copied().map(color_of).collect())
}

/// The colour of a pixel that was drawn so often.
pub fn color_of(times: u16) -> Rgb888 {
    const COLORS: [(u8, u8, u8); 9] = [
        (0, 0, 0),
        (24, 32, 96),
        (0, 96, 160),
        (0, 144, 96),
        (96, 176, 0),
        (224, 192, 0),
        (240, 112, 0),
        (224, 0, 0),
        (255, 255, 255),
    ];
    let (r, g, b) = COLORS[usize::from(times).min(COLORS.len() - 1)];
    Rgb888::new(r, g, b)
}
