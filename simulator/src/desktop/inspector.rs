//! The inspector: a line at the bottom of a window that says what the pixel under the mouse is, and how long a frame took.

use std::time::Duration;

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Rgb888, RgbColor},
};
use embedded_raster::{
    buffer_bytes,
    text::{Style, Vertical, FONT_6X10},
    Canvas, Framebuffer, Rect,
};

use super::view::rgb;
use crate::picture::Picture;

/// Rows of the line.
const HEIGHT: u16 = 14;

/// What the line says: place, index, colour, time.
pub(super) fn text(picture: &Picture, at: Point, took: Duration, rate: u32) -> String {
    let place = |n: i32| usize::try_from(n).unwrap_or(usize::MAX);
    let pixel = picture.color(place(at.x), place(at.y)).map(|color| {
        let index = picture.index(place(at.x), place(at.y)).map_or(String::new(), |index| format!("  index {index}"));
        format!("{}, {}{index}  #{:06x}  ", at.x, at.y, rgb(color))
    });
    let micros = took.as_micros();
    format!("{}{}.{:02} ms  {rate} frames/s", pixel.unwrap_or_default(), micros / 1000, micros % 1000 / 10)
}

/// Draws the line over the last rows of a window: a square of the colour, and the text.
pub(super) fn draw(text: &str, color: Option<Rgb888>, pixels: &mut [u32], (width, height): (usize, usize)) {
    let columns = u16::try_from(width).unwrap_or(u16::MAX);
    let mut memory = vec![0; buffer_bytes::<Rgb888>(columns, HEIGHT)];
    let Ok(mut line) = Framebuffer::<Rgb888>::new(&mut memory[..], columns, HEIGHT) else { return };
    line.fill_window(Rgb888::new(16, 18, 20));
    if let Some(color) = color {
        line.fill_rectangle(Rect::new(2, 2, 12, 12), color);
        line.draw_rectangle(Rect::new(2, 2, 12, 12), Rgb888::new(128, 128, 128));
    }
    Style::new(&FONT_6X10, Rgb888::WHITE).vertical(Vertical::Top).draw(&mut line, (16, 2), text);
    let rows = height.min(HEIGHT.into());
    let Some(last) = pixels.get_mut((height - rows) * width..) else { return };
    let places = (0..rows).flat_map(|y| (0..width).map(move |x| (x, y)));
    for (pixel, (x, y)) in last.iter_mut().zip(places) {
        let [x, y] = [x, y].map(|n| i32::try_from(n).unwrap_or(i32::MAX));
        *pixel = line.get((x, y)).map_or(*pixel, rgb);
    }
}

#[cfg(test)]
mod tests {
    use embedded_raster::pixel::EGA;

    use super::*;

    #[test]
    fn a_pixel_is_told_with_its_index() {
        let took = Duration::from_micros(12_345);
        let indexed = Picture::from_indices(2, 1, 4, EGA.colors().to_vec(), vec![3, 14]);
        let said = |x, y| text(&indexed, Point::new(x, y), took, 60);
        assert_eq!(said(1, 0), "1, 0  index 14  #ffff55  12.34 ms  60 frames/s");
        assert_eq!(said(0, 0), "0, 0  index 3  #00aaaa  12.34 ms  60 frames/s");
        for (x, y) in [(-1, 0), (2, 0), (0, 1)] {
            assert_eq!(said(x, y), "12.34 ms  60 frames/s", "outside");
        }
        let colors = Picture::from_colors(1, 1, vec![Rgb888::new(1, 2, 255)]);
        assert_eq!(text(&colors, Point::zero(), Duration::ZERO, 0), "0, 0  #0102ff  0.00 ms  0 frames/s");
    }

    #[test]
    fn the_line_lies_at_the_bottom_of_any_window() {
        for (width, height) in [(0, 0), (1, 1), (9, 5), (200, 40)] {
            let mut pixels = vec![7; width * height];
            draw("1, 2", Some(Rgb888::RED), &mut pixels, (width, height));
            let rows = height.min(HEIGHT.into());
            let (above, line) = pixels.split_at((height - rows) * width);
            assert!(
                above.iter().all(|&pixel| pixel == 7) && line.iter().all(|&pixel| pixel != 7),
                "{width} x {height}"
            );
        }
        let mut pixels = vec![7; 200 * 40];
        draw("1, 2", Some(Rgb888::RED), &mut pixels, (200, 40));
        assert_eq!(pixels[(26 + 5) * 200 + 5], 0x00ff_0000, "the colour");
        assert!(pixels.contains(&0x00ff_ffff), "letters");
    }
}
