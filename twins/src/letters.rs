//! [`Letters`]: a picture to flood, and how a breadth-first search floods it.

use std::collections::VecDeque;

use embedded_raster::{
    raster::flood::{Connectivity, FloodTarget},
    ClippedSpan, Rect,
};

/// A picture of letters: what is not asked for stays, what was painted is `#`.
#[derive(Clone, PartialEq)]
pub struct Letters {
    /// Pixels in a row.
    pub width: i32,
    /// Rows.
    pub height: i32,
    /// Row by row.
    pub pixels: Vec<u8>,
}

impl Letters {
    /// Of each pixel by its number, row by row: is it open?
    pub fn new(width: i32, height: i32, open: impl FnMut(i32) -> bool) -> Self {
        let pixels = (0..width * height).map(open).map(|open| if open { b'.' } else { b'#' }).collect();
        Self { width, height, pixels }
    }

    /// Rows of letters.
    pub fn parse(rows: &[&str]) -> Self {
        let pixels = rows.concat().into_bytes();
        Self { width: rows[0].len() as i32, height: rows.len() as i32, pixels }
    }

    /// `None` outside.
    pub fn at(&self, x: i32, y: i32) -> Option<u8> {
        let inside = (0..self.width).contains(&x) && (0..self.height).contains(&y);
        inside.then(|| self.pixels[(y * self.width + x) as usize])
    }

    /// To read in a failure.
    pub fn text(&self) -> String {
        let rows = self.pixels.chunks(self.width as usize);
        rows.map(|row| String::from_utf8_lossy(row).into_owned() + "\n").collect()
    }

    /// The twin: a breadth-first search for the pixels of the seed's letter.
    pub fn flooded(&self, seed: (i32, i32), reach: Connectivity) -> Self {
        let mut result = self.clone();
        let mut queue = VecDeque::from([seed]);
        while let Some((x, y)) = queue.pop_front() {
            if result.at(x, y) != Some(b'.') {
                continue;
            }
            result.pixels[(y * self.width + x) as usize] = b'#';
            queue.extend([(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)]);
            if reach == Connectivity::Corners {
                queue.extend([(x - 1, y - 1), (x + 1, y - 1), (x - 1, y + 1), (x + 1, y + 1)]);
            }
        }
        result
    }
}

impl FloodTarget for Letters {
    fn window(&self) -> Rect {
        Rect::new(0, 0, self.width, self.height)
    }

    fn is_open(&self, x: i32, y: i32) -> bool {
        self.at(x, y).expect("inside") == b'.'
    }

    fn paint(&mut self, span: ClippedSpan) {
        for x in span.x0()..span.x1() {
            let pixel = &mut self.pixels[(span.y() * self.width + x) as usize];
            assert_eq!(*pixel, b'.', "({x}, {}) was not open", span.y());
            *pixel = b'#';
        }
    }
}
