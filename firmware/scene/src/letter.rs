//! A page of text: a title on a bar, and 20 lines in cells of 6 x 10 pixels.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::text::{Style, Vertical, FONT_6X10};
use embedded_raster::{Canvas, Framebuffer, Rect};

use crate::WIDTH;

const PAPER: Rgb565 = Rgb565::new(30, 61, 28);
const INK: Rgb565 = Rgb565::new(3, 6, 5);
const BAR: Rgb565 = Rgb565::new(4, 18, 16);

const TITLE: &str = "How a screen fits into 16 kilobytes";
const BODY: &str = "\
A screen of 320 x 240 pixels with 16 bits each takes
153,600 bytes. Many chips have less, and a program
wants some of it for other things.

So the screen is drawn in bands. A band is a frame
like any other, but it has memory for its own rows
only. It takes the coordinates of the whole screen,
and what lies elsewhere is cut off:

    rows      bytes     the scene is gone through
    240     153,600                          once
    120      76,800                         twice
     60      38,400                    four times
     16      10,240                      15 times

Two such bands, and one is on the wire while the
next one is drawn. No pixel differs.

Lines that lie above a band, or below it, cost one
comparison each. The more is left out so, the less
it matters how often the scene is gone through.";

/// Draws the page on the whole screen, or on a band of it.
pub fn draw(frame: &mut Framebuffer<'_, Rgb565>) {
    frame.clear(PAPER);
    frame.fill_rectangle(Rect::new(0, 0, WIDTH.into(), 16), BAR);
    Style::new(&FONT_6X10, PAPER).vertical(Vertical::Top).draw(frame, (4, 3), TITLE);
    Style::new(&FONT_6X10, INK).vertical(Vertical::Top).draw(frame, (4, 21), BODY);
}
