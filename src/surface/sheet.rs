//! [`Sheet`]: many small pictures of one size in a large one.

use core::fmt;

use embedded_graphics_core::geometry::Size;

use super::{frame::Frame, layout::Layout};
use crate::{num::cast::signed, span::Rect};

/// A picture cut into tiles of one size, which are numbered from left to right, then from top to bottom, from 0. What is left over
/// at the right and at the bottom is no tile.
///
/// The frames of a sprite that moves, and the ground that a map is made of, are kept so: one picture in flash, one name.
/// ```
/// use embedded_graphics_core::{geometry::Point, pixelcolor::Gray8};
/// use embedded_raster::{surface::Sheet, Bitmap, Canvas, Framebuffer};
/// let picture = Bitmap::<Gray8>::new(&[1, 2, 3, 4, 5, 6, 7, 8, 9, 10], 5, 2)?;
/// let sheet = Sheet::new(&picture, 2, 1);
/// assert_eq!(sheet.len(), 4);
/// let tile = sheet.tile(3).expect("one of four");
/// let mut ram = [0; 3];
/// Framebuffer::<Gray8>::new(&mut ram, 3, 1)?.blit(Point::new(1, 0), &tile);
/// assert_eq!(ram, [0, 8, 9]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
pub struct Sheet<'a, L> {
    picture: Frame<&'a [u8], L>,
    tile: (u16, u16),
    columns: u32,
    rows: u32,
}

impl<L> Copy for Sheet<'_, L> {}

impl<L> Clone for Sheet<'_, L> {
    fn clone(&self) -> Self {
        *self
    }
}

/// Prints the sizes.
impl<L> fmt::Debug for Sheet<'_, L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { picture, tile, columns, rows } = self;
        let mut sheet = f.debug_struct("Sheet");
        sheet.field("picture", picture).field("tile", tile).field("columns", columns).field("rows", rows).finish()
    }
}

impl<'a, L: Layout> Sheet<'a, L> {
    /// Of tiles that are so wide and so high, from the top left corner of what the window of a picture shows. If either is 0, there
    /// are none.
    pub fn new<M: AsRef<[u8]>>(picture: &'a Frame<M, L>, width: u16, height: u16) -> Self {
        let picture = picture.as_bitmap();
        let window = picture.window();
        let count = |pixels: u32, tile: u16| pixels.checked_div(tile.into()).unwrap_or(0);
        let (columns, rows) = (count(window.width(), width), count(window.height(), height));
        Self { picture, tile: (width, height), columns, rows }
    }

    /// How many tiles there are.
    #[inline]
    pub const fn len(&self) -> usize {
        // Each is below 2^16.
        self.columns.wrapping_mul(self.rows) as usize
    }

    /// Whether there are none.
    #[inline]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The size of each tile.
    #[inline]
    pub fn tile_size(&self) -> Size {
        Size::new(self.tile.0.into(), self.tile.1.into())
    }

    /// The tile of a number, whose top left pixel is at (0, 0); `None` if there is none.
    #[inline]
    pub fn tile(&self, number: usize) -> Option<Frame<&'a [u8], L>> {
        let number = u32::try_from(number).ok().filter(|_| number < self.len())?;
        let row = number.checked_div(self.columns)?;
        let column = number.wrapping_sub(row.wrapping_mul(self.columns));
        let (width, height) = self.tile;
        let window = self.picture.window();
        let x = window.x0.wrapping_add(signed(column.wrapping_mul(width.into())));
        let y = window.y0.wrapping_add(signed(row.wrapping_mul(height.into())));
        Some(self.picture.view(Rect::new(x, y, x.wrapping_add(width.into()), y.wrapping_add(height.into()))))
    }
}
