//! What two pictures do not share.

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};

use crate::picture::Picture;

/// Where two pictures differ: see [`Picture::difference`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// How many pixels differ.
    pub pixels: usize,
    /// As large as the larger picture: what differs is red, what does not is the picture in pale grey.
    pub picture: Picture,
}

impl Picture {
    /// Compares pixel by pixel: colours, and indices where there are some. What only one of them covers differs.
    #[must_use]
    pub fn difference(&self, other: &Self) -> Difference {
        let (width, height) = (self.width().max(other.width()), self.height().max(other.height()));
        let mut pixels = 0;
        let points = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let colors = points.map(|(x, y)| {
            let (mine, others) = (self.color(x, y), other.color(x, y));
            if mine == others && self.index(x, y) == other.index(x, y) {
                mine.map_or(Rgb888::WHITE, pale)
            } else {
                pixels += 1;
                Rgb888::new(224, 0, 32)
            }
        });
        let colors = colors.collect();
        Difference { pixels, picture: Self::from_colors(width, height, colors) }
    }
}

/// A light grey, lighter for lighter colours.
fn pale(c: Rgb888) -> Rgb888 {
    let sum = u16::from(c.r()) + u16::from(c.g()) + u16::from(c.b());
    let grey = u8::try_from(160 + sum / 8).unwrap_or(u8::MAX);
    Rgb888::new(grey, grey, grey)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_counted_and_marked() {
        let (black, white) = (Rgb888::BLACK, Rgb888::WHITE);
        let a = Picture::from_colors(2, 1, vec![black, white]);
        let b = Picture::from_colors(2, 1, vec![black, black]);
        assert_eq!(a.difference(&a).pixels, 0, "the same");
        let Difference { pixels, picture } = a.difference(&b);
        assert_eq!(pixels, 1, "one pixel");
        assert_eq!(picture.color(0, 0), Some(Rgb888::new(160, 160, 160)), "the same in grey");
        assert_eq!(picture.color(1, 0), Some(Rgb888::new(224, 0, 32)), "the other in red");
        assert_eq!(a.difference(&Picture::from_colors(1, 2, vec![black, black])).pixels, 2, "sizes");
    }

    #[test]
    fn an_index_of_the_same_color_differs() {
        let palette = vec![Rgb888::BLACK; 2];
        let [a, b] = [0, 1].map(|index| Picture::from_indices(1, 1, 1, palette.clone(), vec![index]));
        assert_eq!(a.difference(&b).pixels, 1, "indices count");
    }
}
