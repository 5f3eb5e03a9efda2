//! [`Pictures`]: pictures on surfaces of other colours, sizes and directions.

use embedded_graphics_core::geometry::Point;

use crate::{
    error::MapTooLarge,
    geom::Affine,
    num::{
        cast::{narrow, saturate, signed},
        divisor::WideDivisor,
    },
    raster::mapped::{self, Texels},
    span::{ClippedSpan, Rect},
    surface::{blit_mapped, blit_mixed, Frame, Layout, Readable, Sheet, Surface},
};

/// Draws pictures on any [`Surface`], whatever colours they have: of each texel, `color` makes the colour of the pixel, or `None` to
/// leave what is there.
///
/// | a picture of | `color` |
/// |---|---|
/// | indices, through a [`Palette`](crate::Palette) | `\|index: Index4\| palette.get(index.into())` |
/// | colours, onto others | `\|color: Rgb888\| Some(color.into())` |
/// | one bit, in one colour | `\|bit: BinaryColor\| bit.is_on().then_some(ink)` |
/// | colours, one of them a key | `\|color\| (color != key).then_some(color)` |
///
/// Where colours are the same, [`Canvas::blit`](crate::Canvas::blit) is faster, and so is
/// [`Canvas::blit_mask`](crate::Canvas::blit_mask) for one bit.
///
/// A picture is what the window of its frame shows; its places count from the top left corner of that.
///
/// **Size.** A picture is drawn as it is, stretched to a box, or under any [`Affine`] map; always with the nearest texel, exactly, so
/// that pictures side by side neither gap nor overlap: see [`mapped`](crate::raster::mapped).
/// ```
/// use embedded_graphics_core::{geometry::Point, pixelcolor::{Rgb565, Rgb888, RgbColor}};
/// use embedded_raster::{pixel::EGA, Affine, Angle, Bitmap, Framebuffer, Index4, Palette, Pictures, Rect, fixed::types::I16F16};
/// let arrow = Bitmap::<Index4>::new(&[0xce, 0xc0], 2, 2)?; // red and yellow, red and nothing
/// let palette: Palette<Rgb565, 16> = EGA.map(Rgb565::from);
/// let color = |index: Index4| palette.get(index.into()).filter(|_| index.index() != 0);
///
/// let mut ram = [0; 2 * 8 * 4];
/// let mut frame = Framebuffer::<Rgb565>::new(&mut ram, 8, 4)?;
/// frame.blit_mapped((0, 0), &arrow, color);
/// frame.blit_stretched(Rect::new(2, 0, 5, 4), &arrow, color);
/// let turned = Affine::rotate(Angle::degrees(90)).then(Affine::translate(I16F16::from_num(8), I16F16::ZERO));
/// frame.blit_affine(&turned, &arrow, color)?;
/// let seen = |x, y| frame.get(Point::new(x, y)).map_or(' ', |c| match c.g() { 0 => '.', n if n > 40 => 'y', _ => 'r' });
/// let rows: Vec<String> = (0..4).map(|y| (0..8).map(|x| seen(x, y)).collect()).collect();
/// assert_eq!(rows, ["ryryy.rr", "r.ryy..y", "..r.....", "..r....."]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
pub trait Pictures: Surface {
    /// Draws a picture so that its top left pixel falls on `at`.
    #[doc(alias("pushImage", "drawRGBBitmap", "blit_convert", "sprite"))]
    fn blit_mapped<M, L>(
        &mut self,
        at: impl Into<Point>,
        picture: &Frame<M, L>,
        color: impl FnMut(L::Color) -> Option<Self::Color>,
    ) where
        Self: Sized,
        M: AsRef<[u8]>,
        L: Layout,
    {
        blit_mapped(self, at.into(), picture, color);
    }

    /// Paints a picture so that its top left pixel falls on `at`, each pixel in the colour that `mix` makes of that of the picture and
    /// the old one. What lies outside is clipped. The picture may have any layout, and colours of any type.
    ///
    /// With [`Argb8888::over`](crate::pixel::Argb8888::over), or `over_premultiplied` where channels were multiplied by alpha before, this is
    /// *source over*: sprites with soft rims, shadows, glass. With indices, `mix` looks for the [nearest](crate::Palette::nearest) entry.
    /// ```
    /// use embedded_graphics_core::pixelcolor::{Rgb565, Rgb888};
    /// use embedded_raster::{pixel::{Argb8888, EGA}, Bitmap, Framebuffer, Index4, Pictures};
    /// // Blue, green, red, alpha: a white pixel, a half of a red one, and none.
    /// let sprite = [255, 255, 255, 255, 0, 0, 255, 128, 9, 9, 9, 0];
    /// let sprite = Bitmap::<Argb8888>::new(&sprite, 3, 1)?;
    /// let mut ram = [0x10, 0x84].repeat(4);
    /// let mut frame = Framebuffer::<Rgb565>::new(&mut ram, 4, 1)?;
    /// frame.blit_with((1, 0), &sprite, Argb8888::over);
    /// let colors = [0, 1, 2, 3].map(|x| frame.get((x, 0)));
    /// let grey = Rgb565::new(16, 32, 16);
    /// assert_eq!(colors, [grey, Rgb565::new(31, 63, 31), Rgb565::new(24, 16, 8), grey].map(Some));
    ///
    /// let mut ram = [0x22; 2];
    /// let mut frame = Framebuffer::<Index4>::new(&mut ram, 4, 1)?;
    /// frame.blit_with((1, 0), &sprite, |source, old: Index4| {
    ///     let under = EGA.get(old.index()).unwrap_or_default();
    ///     Index4::new(EGA.nearest(source.over(under)))
    /// });
    /// assert_eq!(ram, [0x2f, 0x62]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[doc(alias("blend", "composite", "source_over", "alpha", "sprite", "pushImage"))]
    #[inline]
    fn blit_with<M, L>(
        &mut self,
        at: impl Into<Point>,
        picture: &Frame<M, L>,
        mix: impl FnMut(L::Color, Self::Color) -> Self::Color,
    ) where
        Self: Readable + Sized,
        M: AsRef<[u8]>,
        L: Layout,
    {
        blit_mixed(self, at.into(), picture, mix);
    }

    /// Draws a picture stretched to a box, which may be smaller or larger: as often as large, or by any ratio. The middle of a pixel
    /// takes the texel under it.
    #[doc(alias("scale", "zoom", "pushImageScaled", "StretchBlt"))]
    fn blit_stretched<M, L>(
        &mut self,
        area: impl Into<Rect>,
        picture: &Frame<M, L>,
        mut color: impl FnMut(L::Color) -> Option<Self::Color>,
    ) where
        Self: Sized,
        M: AsRef<[u8]>,
        L: Layout,
    {
        let window = self.window();
        let size = picture.window().size();
        mapped::stretch(area.into(), size, window, |span, texels| draw(self, span, texels, picture, &mut color));
    }

    /// Draws a picture under a map, which takes places in the picture, in texels from its top left corner, to places on the surface.
    ///
    /// # Errors
    /// [`MapTooLarge`] if the map makes something 64 times as large, or more. Nothing is drawn then.
    #[doc(alias("rotate", "pushRotateZoom", "drawRotated", "rotozoom", "lv_image_set_rotation"))]
    fn blit_affine<M, L>(
        &mut self,
        map: &Affine,
        picture: &Frame<M, L>,
        mut color: impl FnMut(L::Color) -> Option<Self::Color>,
    ) -> Result<(), MapTooLarge>
    where
        Self: Sized,
        M: AsRef<[u8]>,
        L: Layout,
    {
        let window = self.window();
        let size = picture.window().size();
        mapped::fill(map, size, window, |span, texels| draw(self, span, texels, picture, &mut color))
    }

    /// Draws a frame of any size out of a small picture: a nine-patch. `middle` is the part of the picture, from its top left corner,
    /// that is stretched both ways. The corners around it are drawn as they are, and the sides are stretched along themselves. In a
    /// box that is too small for the corners, these shrink, in the ratio of their sizes.
    #[doc(alias("nine_slice", "9-patch", "ninepatch", "button"))]
    fn blit_nine_patch<M, L>(
        &mut self,
        area: impl Into<Rect>,
        picture: &Frame<M, L>,
        middle: Rect,
        mut color: impl FnMut(L::Color) -> Option<Self::Color>,
    ) where
        Self: Sized,
        M: AsRef<[u8]>,
        L: Layout,
    {
        let (area, seen, picture) = (area.into(), picture.window(), picture.as_bitmap());
        let columns = thirds(seen.width(), (middle.x0, middle.x1), (area.x0, area.x1));
        let rows = thirds(seen.height(), (middle.y0, middle.y1), (area.y0, area.y1));
        for ((from_y0, to_y0), (from_y1, to_y1)) in rows.into_iter().zip(rows.into_iter().skip(1)) {
            for ((from_x0, to_x0), (from_x1, to_x1)) in columns.into_iter().zip(columns.into_iter().skip(1)) {
                let part = picture.view(Rect::new(from_x0, from_y0, from_x1, from_y1).translate(seen.x0, seen.y0));
                self.blit_stretched(Rect::new(to_x0, to_y0, to_x1, to_y1), &part, &mut color);
            }
        }
    }

    /// Draws the visible part of a map made of tiles. `tile_at` says which tile of the sheet lies in a column and a row of the map, or
    /// `None` where there is none; it is asked for those cells only that meet the window, from left to right, then from top to bottom.
    /// `at` is where the top left corner of cell (0, 0) falls: to scroll, move it.
    #[doc(alias("tilemap", "scroll", "background"))]
    fn draw_tile_map<L>(
        &mut self,
        at: impl Into<Point>,
        sheet: &Sheet<'_, L>,
        mut tile_at: impl FnMut(i32, i32) -> Option<usize>,
        mut color: impl FnMut(L::Color) -> Option<Self::Color>,
    ) where
        Self: Sized,
        L: Layout,
    {
        let (at, window, size) = (at.into(), self.window(), sheet.tile_size());
        let cells = |low: i32, high: i32, at: i32, size: u32| {
            // Of a window that may be as far away as numbers go.
            let tile = WideDivisor::new(size.into());
            let cell = |pixel: i64| saturate(tile.quotient(pixel).0);
            let (low, high) = (i64::from(low).wrapping_sub(at.into()), i64::from(high).wrapping_sub(at.into()));
            if size == 0 || low >= high {
                0..0
            } else {
                cell(low)..cell(high.wrapping_sub(1)).saturating_add(1)
            }
        };
        let columns = cells(window.x0, window.x1, at.x, size.width);
        let rows = cells(window.y0, window.y1, at.y, size.height);
        let place =
            |at: i32, cell: i32, size: u32| narrow(i64::from(cell).wrapping_mul(size.into()).wrapping_add(at.into()));
        for row in rows {
            for column in columns.clone() {
                if let Some(tile) = tile_at(column, row).and_then(|number| sheet.tile(number)) {
                    let to = (place(at.x, column, size.width), place(at.y, row, size.height));
                    self.blit_mapped(to, &tile, &mut color);
                }
            }
        }
    }
}

impl<S: Surface + ?Sized> Pictures for S {}

/// A run of pixels, each in the colour of its texel.
#[inline(always)]
fn draw<S, M, L>(
    on: &mut S,
    span: ClippedSpan,
    mut texels: Texels,
    picture: &Frame<M, L>,
    color: &mut impl FnMut(L::Color) -> Option<S::Color>,
) where
    S: Surface,
    M: AsRef<[u8]>,
    L: Layout,
{
    let window = picture.window();
    on.write_some(span, |_| {
        let (column, row) = texels.texel();
        color(picture.at(window.x0.wrapping_add(column), window.y0.wrapping_add(row)))
    });
}

/// Where a picture is cut, and where the cuts fall in a box: its start, the start and the end of the middle, and its end.
fn thirds(size: u32, (start, end): (i32, i32), (low, high): (i32, i32)) -> [(i32, i32); 4] {
    // Pictures are below 2^16, boxes may be as large as numbers go.
    let size = signed(size);
    // Not `clamp`, which has a panic in it.
    let start = start.max(0).min(size);
    let end = end.max(start).min(size);
    let (before, after) = (i64::from(start), i64::from(size.wrapping_sub(end)));
    let length = i64::from(high).wrapping_sub(low.into()).max(0);
    let both = before.wrapping_add(after);
    let (before, after) = if both <= length {
        (before, after)
    } else {
        // Below 2^17 each: the product has 34 bits, and the box is small.
        let (before, _) = WideDivisor::new(both.unsigned_abs()).quotient(before.wrapping_mul(length));
        (before, length.wrapping_sub(before))
    };
    let to = |along: i64| narrow(i64::from(low).wrapping_add(along));
    [(0, low), (start, to(before)), (end, to(length.wrapping_sub(after))), (size, to(length))]
}
