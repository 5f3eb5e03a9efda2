//! Text: bitmap fonts, and lines of them on any surface.
//! ```
//! # #[cfg(feature = "font-6x10")] {
//! use embedded_raster::{text::{Style, FONT_6X10}, Frame, Framebuffer, Index4};
//! # let mut ram = [0; 64 / 2 * 16];
//! # let mut frame = Framebuffer::<Index4>::new(&mut ram, 64, 16)?;
//! let style = Style::new(&FONT_6X10, Index4::new(15));
//! style.draw(&mut frame, (2, 10), "Hello");
//! # assert_eq!(frame.get((2, 4)), Some(Index4::new(15)));
//! # }
//! # Ok::<(), embedded_raster::Error>(())
//! ```
//! A [`Font`] is data: glyphs of one bit per pixel, in flash or on a card. A [`Style`] is a font with colours, and with where lines lie
//! beside the point that they are drawn at. The crate has two fonts, behind the features `font-6x10` and `font-8x13`; the tool
//! `fontbake` makes others, from BDF and TrueType files. embedded-graphics and the crates around it draw text too, with fonts
//! of their own: a [`Frame`](crate::Frame) is a `DrawTarget`.
//!
//! **Words.** A *glyph* is the picture of a character. Each has a *cell*: as many columns as the glyph *advances*, and the rows of the
//! font. The *pen* is the column where the next cell begins. Letters stand on the *baseline*; some reach below it.
//! ```text
//!          pen   pen + advance
//!           |     |
//!     row 0 +-----+       - the cell begins
//!           |.....|
//!           |..#..|
//!           |.#.#.|         the box of the glyph: rows and columns that have bits
//!           |.###.|
//!   row 4   |.#.#.|       - baseline: the last row above what reaches below
//!           |.....|
//!           +-----+       - the cell ends: 6 rows
//! ```
//! **Which pixels.** *Transparent* text paints the set pixels of its glyphs. *Opaque* text paints its cells as well, in the colour of
//! the ground, and the set pixels over them: no glyph is cut by the cell of the next one. Lines come one after the other, from
//! the top down; where the cells of two lines have pixels in common, the lower line is on top. A newline begins a line, a tab goes
//! to the next tab stop, and a carriage return does nothing. Any other character that the font lacks has the replacement
//! glyph.
//!
//! Text is clipped exactly, and may lie anywhere: each pixel in the window is what it is without a window. There is no wrapping,
//! no kerning and no shaping: that is layout, for crates such as `embedded-text`.
//!
//! **Work.** Each byte of the text is looked at once, or twice where lines are not aligned to the left or the block not by its first
//! line. A line that lies above or below the window costs one comparison, and the way to its end; of others, glyphs on the right
//! of the window are not looked up. Pixels cost what their layout makes of them: eight at a time for one bit per
//! pixel, pairs for opaque text in 16 bits.

mod draw;
mod font;
#[cfg(any(feature = "font-6x10", feature = "font-8x13"))]
mod fonts;
mod line;
mod style;
#[cfg(test)]
mod work;

#[cfg(feature = "font-6x10")]
pub use self::fonts::FONT_6X10;
#[cfg(feature = "font-8x13")]
pub use self::fonts::FONT_8X13;
pub use self::{
    font::{Font, Glyph},
    style::{Horizontal, Style, Vertical},
};
