//! A picture in a window: how large, where, and with what over it.

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Rgb888, RgbColor},
};

use crate::picture::Picture;

/// What is around a picture.
const AROUND: u32 = 0x0020_2428;
/// From this zoom on, lines between pixels leave something to see of them.
const GRID_ZOOM: i32 = 4;
/// The largest zoom.
const LARGEST: i32 = 64;

/// How somebody looks at a picture.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct View {
    /// Columns and rows of a pixel; `None` for the largest whole number at which the picture fits.
    zoom: Option<i32>,
    /// Where the corner of the picture lies in the window, if it does not fit.
    corner: (i32, i32),
    /// Whether there are lines between pixels.
    pub(super) has_grid: bool,
}

/// Where a picture lies in a window.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) struct Placed {
    pub(super) zoom: i32,
    left: i32,
    top: i32,
}

impl View {
    /// Where a picture of this size lies in a window of that one.
    pub(super) fn placed(&self, picture: &Picture, window: (usize, usize)) -> Placed {
        let zoom = self.zoom.unwrap_or_else(|| fitting((picture.width(), picture.height()), window));
        let [width, height] = sides(picture);
        let (left, top) = self.corner;
        Placed {
            zoom,
            left: side(int(window.0), width.saturating_mul(zoom), left),
            top: side(int(window.1), height.saturating_mul(zoom), top),
        }
    }

    /// One step larger, or smaller; what is under `at` of the window stays there.
    pub(super) fn zoom(&mut self, is_larger: bool, at: (i32, i32), picture: &Picture, window: (usize, usize)) {
        let Placed { zoom, left, top } = self.placed(picture, window);
        let new = if is_larger { zoom + 1 } else { zoom - 1 }.clamp(1, LARGEST.max(zoom));
        let corner = |at: i32, corner: i32| {
            let inside = i64::from(at) - i64::from(corner);
            at.saturating_sub(i32::try_from(inside * i64::from(new) / i64::from(zoom)).unwrap_or(i32::MAX))
        };
        (self.zoom, self.corner) = (Some(new), (corner(at.0, left), corner(at.1, top)));
    }

    /// As large as it fits.
    pub(super) fn fit(&mut self) {
        self.zoom = None;
    }

    /// Moves a picture that does not fit.
    pub(super) fn drag(&mut self, by: (i32, i32), picture: &Picture, window: (usize, usize)) {
        let Placed { left, top, .. } = self.placed(picture, window);
        self.corner = (left.saturating_add(by.0), top.saturating_add(by.1));
    }
}

impl Placed {
    /// The pixel that is shown at a place of the window, which may lie outside of the picture.
    pub(super) fn pixel(&self, (x, y): (i32, i32)) -> Point {
        let cell = |at: i32, corner: i32| at.saturating_sub(corner).div_euclid(self.zoom);
        Point::new(cell(x, self.left), cell(y, self.top))
    }

    /// The first place of a pixel in the window.
    fn corner(&self, p: Point) -> (i32, i32) {
        let at = |cell: i32, corner: i32| cell.saturating_mul(self.zoom).saturating_add(corner);
        (at(p.x, self.left), at(p.y, self.top))
    }

    /// Columns or rows of the picture, one for each of the window, and whether it is the last one of its pixel; `None` around it.
    fn cells(&self, corner: i32, window: usize, cells: i32) -> Vec<Option<(usize, bool)>> {
        let cell = |at: i32| {
            let inside = at.checked_sub(corner).filter(|&inside| inside >= 0)?;
            let (cell, rest) = (inside / self.zoom, inside % self.zoom);
            (cell < cells).then(|| (usize::try_from(cell).unwrap_or(0), rest == self.zoom - 1))
        };
        (0..int(window)).map(cell).collect()
    }

    /// The pixels of the window.
    pub(super) fn compose(&self, picture: &Picture, window: (usize, usize), has_grid: bool) -> Vec<u32> {
        let [width, height] = sides(picture);
        let columns = self.cells(self.left, window.0, width);
        let has_grid = has_grid && self.zoom >= GRID_ZOOM;
        let (mut pixels, mut line, mut last) = (Vec::with_capacity(window.0 * window.1), vec![], None);
        for row in self.cells(self.top, window.1, height) {
            let Some((y, is_line)) = row else {
                pixels.resize(pixels.len() + window.0, AROUND);
                continue;
            };
            if last != Some(y) {
                line.clear();
                line.extend(columns.iter().map(|column| match column {
                    Some((x, true)) if has_grid => between(word(picture, *x, y)),
                    Some((x, _)) => word(picture, *x, y),
                    None => AROUND,
                }));
                last = Some(y);
            }
            if has_grid && is_line {
                let inside = |column: &Option<_>, color: &u32| if column.is_some() { between(*color) } else { *color };
                pixels.extend(columns.iter().zip(&line).map(|(column, color)| inside(column, color)));
            } else {
                pixels.extend_from_slice(&line);
            }
        }
        pixels
    }

    /// Draws a frame around a pixel, so that somebody sees which one is meant.
    pub(super) fn mark(&self, p: Point, pixels: &mut [u32], width: usize) {
        let ((x, y), last) = (self.corner(p), self.zoom - 1);
        let square = (0..=last).flat_map(|dy| (0..=last).map(move |dx| (dx, dy)));
        let is_frame = |(dx, dy): &(i32, i32)| last > 1 && ([0, last].contains(dx) || [0, last].contains(dy));
        for (dx, dy) in square.filter(is_frame) {
            let place = |n: i32| usize::try_from(n).ok();
            let (Some(x), Some(y)) = (place(x + dx), place(y + dy)) else { continue };
            if let Some(pixel) = pixels.get_mut(y * width + x).filter(|_| x < width) {
                *pixel = if luma(*pixel) < 128 { 0x00ff_ffff } else { 0 };
            }
        }
    }
}

/// A picture of this size at the largest zoom that stays within 1280 x 960, at least 1.
pub(crate) fn first_size(size @ (width, height): (usize, usize)) -> (usize, usize) {
    let zoom = fitting(size, (1280, 960)).unsigned_abs() as usize;
    ((width * zoom).max(1), (height * zoom).max(1))
}

/// The largest whole zoom at which a picture of this size fits, at least 1.
fn fitting((columns, rows): (usize, usize), (width, height): (usize, usize)) -> i32 {
    int((width / columns.max(1)).min(height / rows.max(1)).max(1))
}

/// Where the first column or row lies: in the middle if all fit, else where it is wanted, but without a margin.
fn side(window: i32, picture: i32, wanted: i32) -> i32 {
    if picture <= window {
        (window - picture) / 2
    } else {
        wanted.clamp(window - picture, 0)
    }
}

fn sides(picture: &Picture) -> [i32; 2] {
    [picture.width(), picture.height()].map(int)
}

fn int(n: usize) -> i32 {
    i32::try_from(n).unwrap_or(i32::MAX)
}

fn word(picture: &Picture, x: usize, y: usize) -> u32 {
    picture.color(x, y).map_or(AROUND, rgb)
}

pub(super) fn rgb(c: Rgb888) -> u32 {
    u32::from_be_bytes([0, c.r(), c.g(), c.b()])
}

/// The colour of a line between pixels: lighter than black, darker than white.
fn between(color: u32) -> u32 {
    (color >> 1 & 0x007f_7f7f) + 0x0020_2020
}

fn luma(color: u32) -> u32 {
    let [_, r, g, b] = color.to_be_bytes().map(u32::from);
    (2 * r + 5 * g + b) / 8
}

#[cfg(test)]
mod tests {
    use super::*;

    const R: u32 = 0x00ff_0000;
    const B: u32 = 0x0000_00ff;
    const O: u32 = AROUND;

    fn picture() -> Picture {
        Picture::from_colors(2, 1, vec![Rgb888::RED, Rgb888::BLUE])
    }

    fn shown(view: &View, window: (usize, usize)) -> Vec<u32> {
        view.placed(&picture(), window).compose(&picture(), window, view.has_grid)
    }

    #[test]
    fn whole_pixels_in_the_middle() {
        let view = View::default();
        #[rustfmt::skip]
        assert_eq!(shown(&view, (5, 3)), [
            R, R, B, B, O,
            R, R, B, B, O,
            O, O, O, O, O,
        ], "twice as large");
        assert_eq!(shown(&view, (1, 2)), [R, O], "cut off");
        assert_eq!(first_size((2, 1)), (1280, 640), "at first");
        assert_eq!(first_size((2000, 9)), (2000, 9), "never smaller");
    }

    #[test]
    fn places_are_those_that_are_shown() {
        let at = |window, place| View::default().placed(&picture(), window).pixel(place);
        let points = [(0, 0), (2, 2), (3, 0)].map(|place| at((7, 3), place));
        assert_eq!(points, [(0, 0), (0, 0), (1, 0)].map(Point::from), "zoom 3");
        let points = [(-1, -1), (6, 3)].map(|place| at((7, 3), place));
        assert_eq!(points, [(-1, -1), (2, 1)].map(Point::from), "outside");
        assert_eq!(at((8, 6), (1, 0)), Point::new(0, -1), "above the picture");
    }

    #[test]
    fn what_is_under_the_mouse_stays_there() {
        let (picture, window) = (Picture::from_colors(40, 30, vec![Rgb888::RED; 1200]), (80, 60));
        for at in [(0, 0), (33, 17), (79, 59), (40, 30)] {
            let mut view = View::default();
            let before = view.placed(&picture, window).pixel(at);
            for zoom in 3..=LARGEST {
                view.zoom(true, at, &picture, window);
                let placed = view.placed(&picture, window);
                let moved = placed.pixel(at) - before;
                assert!(moved.x.abs() <= 1 && moved.y.abs() <= 1, "{at:?} at {zoom} is {moved} away");
                assert_eq!(placed.zoom, zoom, "one step");
            }
            view.zoom(true, at, &picture, window);
            assert_eq!(view.placed(&picture, window).zoom, LARGEST, "the last step");
            for _ in 0..200 {
                view.zoom(false, at, &picture, window);
            }
            assert_eq!(view.placed(&picture, window), Placed { zoom: 1, left: 20, top: 15 }, "in the middle");
            view.fit();
            assert_eq!(view.placed(&picture, window), Placed { zoom: 2, left: 0, top: 0 }, "as at first");
        }
    }

    #[test]
    fn there_is_no_margin_beside_what_does_not_fit() {
        let (picture, window) = (Picture::from_colors(40, 30, vec![Rgb888::RED; 1200]), (80, 60));
        let mut view = View::default();
        view.zoom(true, (0, 0), &picture, window);
        for (by, expected) in [((-7, -9), (-7, -9)), ((99, 99), (0, 0)), ((-9999, -9999), (-40, -30))] {
            view.drag(by, &picture, window);
            let Placed { left, top, .. } = view.placed(&picture, window);
            assert_eq!((left, top), expected, "dragged by {by:?}");
        }
    }

    #[test]
    fn lines_between_pixels_and_around_one() {
        let view = View { has_grid: true, ..View::default() };
        assert_eq!(shown(&view, (6, 3))[..6], [R, R, R, B, B, B], "none where they would hide the picture");
        let (r, b) = (0x009f_2020, 0x0020_209f);
        #[rustfmt::skip]
        assert_eq!(shown(&view, (8, 4)), [
            R, R, R, r, B, B, B, b,
            R, R, R, r, B, B, B, b,
            R, R, R, r, B, B, B, b,
            r, r, r, 0x006f_3030, b, b, b, 0x0030_306f,
        ], "lines");
        let placed = View::default().placed(&picture(), (6, 3));
        let mut pixels = placed.compose(&picture(), (6, 3), false);
        placed.mark(Point::new(1, 0), &mut pixels, 6);
        placed.mark(Point::new(-1, 9), &mut pixels, 6);
        let w = 0x00ff_ffff;
        assert_eq!(pixels, [R, R, R, w, w, w, R, R, R, w, B, w, R, R, R, w, w, w], "a frame");
    }
}
