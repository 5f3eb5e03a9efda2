//! Ways to fill a connected region. Each first loads the picture, which all of them are charged for.

use embedded_graphics::{
    geometry::Point,
    pixelcolor::{Rgb565, RgbColor},
};
use embedded_raster::raster::flood::{Connectivity, FloodSlot};

use super::{entry, ink, own, plain, Entry, Origin};
use crate::{
    frame::{Frame, HEIGHT, WIDTH},
    shape::Pool,
};

pub(crate) fn entries() -> Vec<Entry<Pool>> {
    use Origin::{Crate, Textbook};
    vec![
        entry("stack", "a stack of pixels, any length", Textbook, plain(|f, p: &Pool| by_pixels(f, p))),
        entry("runs", "a stack of runs, any length", Textbook, plain(|f, p: &Pool| by_runs(f, p))),
        entry("canvas64", "`Canvas::flood_fill`, 64 slots", Crate, own(|f, p: &Pool| ours::<64>(f, p))),
        entry("canvas4", "the same with 4 slots", Crate, own(|f, p: &Pool| ours::<4>(f, p))),
        entry("canvas1", "the same with 1 slot", Crate, own(|f, p: &Pool| ours::<1>(f, p))),
    ]
}

type Own<'a> = embedded_raster::Framebuffer<'a, Rgb565>;

fn ours<const SLOTS: usize>(frame: &mut Own<'_>, pool: &Pool) {
    use embedded_raster::{Bitmap, Canvas, Index1};
    let walls = Bitmap::<Index1>::new(&pool.bits, WIDTH as u16, HEIGHT as u16).expect("a bit a pixel");
    frame.blit_mask(Point::new(0, 0), &walls, Rgb565::WHITE, Rgb565::BLACK);
    frame.flood_fill(pool.seed, Connectivity::Sides, &mut [FloodSlot::EMPTY; SLOTS], ink());
}

/// Pushes the four neighbours of every pixel.
fn by_pixels(frame: &mut Frame, pool: &Pool) {
    frame.load(&pool.walls);
    let mut stack = vec![pool.seed];
    while let Some(p) = stack.pop() {
        if frame.is_empty(p.x, p.y) {
            frame.put(p.x, p.y);
            stack.extend([(1, 0), (-1, 0), (0, 1), (0, -1)].map(|step| p + Point::from(step)));
        }
    }
}

/// Paints a run at a time and pushes where runs begin above and below.
fn by_runs(frame: &mut Frame, pool: &Pool) {
    frame.load(&pool.walls);
    let mut stack = vec![pool.seed];
    while let Some(Point { x, y }) = stack.pop() {
        let mut left = x;
        while frame.is_empty(left - 1, y) {
            left -= 1;
        }
        let (mut above, mut below) = (false, false);
        let mut x = left;
        while frame.is_empty(x, y) {
            frame.put(x, y);
            for (open, y) in [(&mut above, y - 1), (&mut below, y + 1)] {
                let is_open = frame.is_empty(x, y);
                if is_open && !*open {
                    stack.push(Point::new(x, y));
                }
                *open = is_open;
            }
            x += 1;
        }
    }
}
