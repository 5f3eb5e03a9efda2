//! Flood fills of surfaces whose pixels can be read.

use embedded_graphics_core::{geometry::Point, pixelcolor::PixelColor};

use crate::{
    pixel::PixelFormat,
    raster::flood::{self, Connectivity, FloodSlot, FloodTarget},
    rect::Rect,
    span::ClippedSpan,
    surface::{Framebuffer, Paged, Surface},
};

impl<F: PixelFormat> Framebuffer<'_, F> {
    /// Paints the pixels of the seed's colour that are connected with it. A seed outside of the window, or one that has
    /// the new colour already, paints nothing.
    ///
    /// `table` is scratch memory of any length; what it holds does not matter. See [`flood`](crate::raster::flood) for how
    /// long it should be.
    /// ```
    /// use embedded_graphics_core::{geometry::Point, pixelcolor::BinaryColor};
    /// use embedded_raster::{raster::flood::{FloodSlot, Connectivity}, Framebuffer};
    /// let mut ram = [0b0010_0000, 0b0101_0000, 0b0010_0000];
    /// let mut frame = Framebuffer::<BinaryColor>::new(&mut ram, 8, 3)?;
    /// frame.flood_fill(Point::new(0, 0), Connectivity::Sides, BinaryColor::On, &mut [FloodSlot::EMPTY; 8]);
    /// assert_eq!(ram, [0b1110_0000, 0b1101_0000, 0b1110_0000]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    pub fn flood_fill(&mut self, seed: Point, reach: Connectivity, color: F::Color, table: &mut [FloodSlot]) {
        let Some(old) = self.get(seed) else { return };
        let (old, new) = (F::pack(old), F::pack(color));
        if old != new {
            let mut area = Area { frame: self, color, is_open: |bits| bits == old };
            flood::fill(&mut area, seed, reach, table);
        }
    }

    /// Paints the pixels of any colour that are connected with the seed, up to pixels of the colour `boundary`. Pixels that
    /// have the new colour already are a boundary too: nothing tells them from painted ones.
    ///
    /// `table` is scratch memory, as for [`flood_fill`](Self::flood_fill).
    pub fn flood_fill_to(
        &mut self,
        seed: Point,
        boundary: F::Color,
        reach: Connectivity,
        color: F::Color,
        table: &mut [FloodSlot],
    ) {
        let (boundary, new) = (F::pack(boundary), F::pack(color));
        let mut area = Area { frame: self, color, is_open: |bits| bits != boundary && bits != new };
        flood::fill(&mut area, seed, reach, table);
    }
}

/// A framebuffer of which pixels with certain bits are open.
struct Area<'f, 'a, F: PixelFormat, P> {
    frame: &'f mut Framebuffer<'a, F>,
    color: F::Color,
    is_open: P,
}

impl<F: PixelFormat, P: Fn(u32) -> bool> FloodTarget for Area<'_, '_, F, P> {
    fn window(&self) -> Rect {
        self.frame.window()
    }

    #[inline]
    fn is_open(&self, x: i32, y: i32) -> bool {
        (self.is_open)(self.frame.bits(x, y))
    }

    #[inline]
    fn paint(&mut self, span: ClippedSpan) {
        self.frame.fill_span(span, self.color);
    }

    #[inline]
    fn paint_pixel(&mut self, x: i32, y: i32) {
        self.frame.put(x, y, F::pack(self.color));
    }

    #[inline]
    fn find(&self, y: i32, x0: i32, x1: i32, open: bool) -> i32 {
        if open {
            self.frame.find(y, x0, x1, |bits| (self.is_open)(bits))
        } else {
            self.frame.find(y, x0, x1, |bits| !(self.is_open)(bits))
        }
    }

    #[inline]
    fn start(&self, y: i32, x0: i32, x: i32) -> i32 {
        self.frame.start(y, x0, x, |bits| (self.is_open)(bits))
    }

    #[inline]
    fn corridor(&mut self, x: i32, y: i32, down: i32) -> i32 {
        let bits = F::pack(self.color);
        match self.frame.corridor((x, y), down > 0, bits, |bits| (self.is_open)(bits)) {
            Some(end) => end,
            None => flood::corridor(self, x, y, down),
        }
    }
}

impl<C: PixelColor + PixelFormat<Color = C>> Paged<'_, C> {
    /// Paints the pixels of the seed's colour that are connected with it: as
    /// [`Framebuffer::flood_fill`](Framebuffer::flood_fill).
    pub fn flood_fill(&mut self, seed: Point, reach: Connectivity, color: C, table: &mut [FloodSlot]) {
        let Some(old) = self.get(seed) else { return };
        if old != color {
            flood::fill(&mut Pages { paged: self, old, color }, seed, reach, table);
        }
    }
}

/// Pages of which the pixels of one colour are open.
struct Pages<'f, 'a, C> {
    paged: &'f mut Paged<'a, C>,
    old: C,
    color: C,
}

impl<C: PixelColor + PixelFormat<Color = C>> FloodTarget for Pages<'_, '_, C> {
    fn window(&self) -> Rect {
        self.paged.window()
    }

    #[inline]
    fn is_open(&self, x: i32, y: i32) -> bool {
        self.paged.get(Point::new(x, y)) == Some(self.old)
    }

    #[inline]
    fn paint(&mut self, span: ClippedSpan) {
        self.paged.fill_span(span, self.color);
    }
}
