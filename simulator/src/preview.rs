//! Pictures in a terminal, two pixels to a character: the upper one in the foreground of `▀`, the lower one behind it.

use std::{
    fmt::Write,
    io::{stdout, IsTerminal, Write as _},
};

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};

use crate::picture::Picture;

impl Picture {
    /// Prints the [`preview`](Self::preview) if the program writes to a terminal: a pipe or a file wants no colours.
    pub fn show(&self, columns: usize) {
        if stdout().is_terminal() {
            // A terminal that has gone needs no preview.
            _ = stdout().write_all(self.preview(columns).as_bytes());
        }
    }

    /// The picture for a terminal of 24-bit colours, averaged down to at most `columns` characters a line.
    pub fn preview(&self, columns: usize) -> String {
        let columns = columns.min(self.width()).max(1);
        let rows = (self.height() * columns).div_ceil(self.width().max(1));
        let mut text = String::new();
        for row in (0..rows).step_by(2) {
            let mut last = None;
            for column in 0..columns {
                let pair = [row, row + 1].map(|row| self.average((column, columns), (row, rows)));
                if last != Some(pair) {
                    text.push_str(&colors(pair));
                }
                text.push('▀');
                last = Some(pair);
            }
            text.push_str("\x1b[0m\n");
        }
        text
    }

    /// The mean colour of a cell of a grid over the picture, given as (cell, cells) across and down; `None` below it.
    fn average(&self, across: (usize, usize), down: (usize, usize)) -> Option<Rgb888> {
        let range = |(cell, cells): (usize, usize), size: usize| {
            let start = (cell * size / cells).min(size);
            start..((cell + 1) * size / cells).clamp(start, size)
        };
        let (xs, ys) = (range(across, self.width()), range(down, self.height()));
        let area = xs.len() * ys.len();
        let mut sum = [area / 2; 3];
        for color in ys.flat_map(|y| xs.clone().filter_map(move |x| self.color(x, y))) {
            for (sum, channel) in sum.iter_mut().zip([color.r(), color.g(), color.b()]) {
                *sum += usize::from(channel);
            }
        }
        let [r, g, b] = sum.map(|sum| sum.checked_div(area).and_then(|mean| u8::try_from(mean).ok()));
        Some(Rgb888::new(r?, g?, b?))
    }
}

/// The escape sequence that sets foreground and background.
fn colors([upper, lower]: [Option<Rgb888>; 2]) -> String {
    let mut text = String::new();
    for (color, ground) in [(upper, 38), (lower, 48)] {
        match color {
            Some(c) => write!(text, "\x1b[{ground};2;{};{};{}m", c.r(), c.g(), c.b()),
            None => write!(text, "\x1b[{}m", ground + 1),
        }
        .expect("strings take everything");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_rows_to_a_line() {
        let (red, blue) = (Rgb888::RED, Rgb888::BLUE);
        let picture = Picture::from_colors(2, 3, vec![red, red, blue, blue, blue, red]);
        let first = "\x1b[38;2;255;0;0m\x1b[48;2;0;0;255m▀▀\x1b[0m\n";
        let second = "\x1b[38;2;0;0;255m\x1b[49m▀\x1b[38;2;255;0;0m\x1b[49m▀\x1b[0m\n";
        assert_eq!(picture.preview(80), [first, second].concat(), "three rows");
    }

    #[test]
    fn smaller_by_averaging() {
        let picture = Picture::from_colors(2, 2, vec![Rgb888::BLACK, Rgb888::WHITE, Rgb888::WHITE, Rgb888::WHITE]);
        assert_eq!(picture.preview(1), "\x1b[38;2;191;191;191m\x1b[49m▀\x1b[0m\n", "the mean of four");
        assert_eq!(Picture::from_colors(0, 0, vec![]).preview(9), "", "nothing to see");
    }
}
