//! What can be laid over a frame: how often each pixel was drawn, what was sent to the display, and how long frames took.
//!
//! ```text
//!   heat      pixels that were drawn: blue once, red seven times, white from eight times on; the others as a dark grey picture
//!   damage    a frame around each rectangle that was sent
//!   time      a chart in the lower left corner: a column for each frame, the last one on the right
//! ```
//! They come one over the other, in this order, and need no window: the same pictures go to files.

use std::{collections::VecDeque, str::FromStr, time::Duration};

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use embedded_raster::{
    buffer_bytes,
    text::{Style, Vertical, FONT_6X10},
    Canvas, Framebuffer, Rect,
};

use crate::{heat::color_of, moment::Moment, picture::Picture};

/// Which of them are shown.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Overlays {
    /// How often each pixel was drawn, where somebody counted.
    pub heat: bool,
    /// What was sent to the display.
    pub damage: bool,
    /// How long the last frames took on this computer.
    pub time: bool,
}

impl FromStr for Overlays {
    type Err = &'static str;

    /// Names between commas.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let mut overlays = Self::default();
        for name in text.split(',') {
            match name {
                "heat" => overlays.heat = true,
                "damage" => overlays.damage = true,
                "time" => overlays.time = true,
                _ => return Err("heat, damage, time, or several with commas between them"),
            }
        }
        Ok(overlays)
    }
}

impl Overlays {
    /// The picture of a frame with what is laid over it.
    pub fn over(self, moment: &Moment, times: &Times) -> Picture {
        let mut picture = moment.picture.clone();
        if self.heat && !moment.drawn.is_empty() {
            picture = warmed(&picture, &moment.drawn);
        }
        if self.damage {
            picture = picture.outlined(&moment.sent, Rgb888::MAGENTA);
        }
        if self.time {
            picture = times.over(&picture);
        }
        picture
    }
}

/// Heat where something was drawn, and a quarter of the brightness elsewhere.
fn warmed(picture: &Picture, drawn: &[u16]) -> Picture {
    let dark = |color: Rgb888| {
        let [r, g, b] = [color.r(), color.g(), color.b()].map(u16::from);
        let grey = u8::try_from((r + 2 * g + b) / 16).unwrap_or(u8::MAX);
        Rgb888::new(grey, grey, grey)
    };
    let counts = drawn.iter().copied().chain(std::iter::repeat(0));
    let colors = picture.colors().zip(counts).map(|(color, n)| if n == 0 { dark(color) } else { color_of(n) });
    Picture::from_colors(picture.width(), picture.height(), colors.collect())
}

/// How long the last frames took.
#[derive(Clone, Debug, Default)]
pub struct Times(VecDeque<Duration>);

impl Times {
    /// Frames that are remembered.
    const MOST: usize = 120;
    /// Rows of the chart: one of them is a millisecond.
    const HEIGHT: u16 = 34;
    /// A frame that takes longer misses its turn at 60 a second.
    const TURN: Duration = Duration::from_nanos(16_666_667);

    /// One frame more.
    pub fn add(&mut self, took: Duration) {
        if self.0.len() == Self::MOST {
            self.0.pop_front();
        }
        self.0.push_back(took);
    }

    /// The last one; 0 if there is none.
    pub fn last(&self) -> Duration {
        self.0.back().copied().unwrap_or_default()
    }

    /// The mean and the longest of those that are remembered.
    fn mean_and_longest(&self) -> (Duration, Duration) {
        let count = u32::try_from(self.0.len()).unwrap_or(u32::MAX).max(1);
        (self.0.iter().sum::<Duration>() / count, self.0.iter().copied().max().unwrap_or_default())
    }

    /// The picture with the chart in its lower left corner: green are frames that are in time, red others.
    fn over(&self, picture: &Picture) -> Picture {
        let most = u16::try_from(Self::MOST).unwrap_or(u16::MAX);
        let width = u16::try_from(picture.width()).unwrap_or(u16::MAX).min(most);
        let height = u16::try_from(picture.height()).unwrap_or(u16::MAX).min(Self::HEIGHT + 11);
        let mut memory = vec![0; buffer_bytes::<Rgb888>(width, height)];
        let Ok(mut chart) = Framebuffer::<Rgb888>::new(&mut memory, width, height) else { return picture.clone() };
        let (right, bottom) = (i32::from(width), i32::from(height));
        let rows = |took: Duration| {
            i32::try_from(took.as_micros().div_ceil(1000)).unwrap_or(i32::MAX).min(Self::HEIGHT.into())
        };
        for (x, &took) in (0..right).rev().zip(self.0.iter().rev()) {
            let color = if took > Self::TURN { Rgb888::RED } else { Rgb888::GREEN };
            chart.fill_rectangle(Rect::new(x, bottom - rows(took), x + 1, bottom), color);
        }
        let turn = bottom - rows(Self::TURN);
        chart.draw_line((0, turn), (right - 1, turn), Rgb888::new(96, 96, 96));
        let (mean, longest) = self.mean_and_longest();
        let text = format!("{} mean {} most", milliseconds(mean), milliseconds(longest));
        Style::new(&FONT_6X10, Rgb888::WHITE).vertical(Vertical::Top).draw(&mut chart, (1, 0), &text);
        let top = picture.height() - usize::from(height);
        let place = |n: usize| i32::try_from(n).unwrap_or(i32::MAX);
        let all = (0..picture.height()).flat_map(|y| (0..picture.width()).map(move |x| (x, y)));
        let colors = all
            .zip(picture.colors())
            .map(|((x, y), color)| y.checked_sub(top).and_then(|y| chart.get((place(x), place(y)))).unwrap_or(color));
        Picture::from_colors(picture.width(), picture.height(), colors.collect())
    }
}

/// With two digits behind the point.
fn milliseconds(time: Duration) -> String {
    let micros = time.as_micros();
    format!("{}.{:02}", micros / 1000, micros % 1000 / 10)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moment() -> Moment {
        let picture = Picture::from_colors(3, 2, vec![Rgb888::WHITE; 6]);
        Moment { picture, sent: vec![Rect::new(0, 0, 2, 1)], drawn: vec![0, 1, 9, 0, 0, 0], crc32: 0, ram: 0 }
    }

    #[test]
    fn names_stand_between_commas() {
        assert_eq!("heat,time".parse(), Ok(Overlays { heat: true, damage: false, time: true }));
        assert!(["", "heat,", "Heat", "heat damage"].iter().all(|text| text.parse::<Overlays>().is_err()), "no names");
    }

    #[test]
    fn heat_is_over_a_dark_picture() {
        let shown = Overlays { heat: true, ..Overlays::default() }.over(&moment(), &Times::default());
        let dark = Some(Rgb888::new(63, 63, 63));
        assert_eq!((shown.color(0, 0), shown.color(2, 1)), (dark, dark), "not drawn");
        assert_eq!((shown.color(1, 0), shown.color(2, 0)), (Some(color_of(1)), Some(Rgb888::WHITE)), "drawn");
        let nobody_counts = Moment { drawn: vec![], ..moment() };
        let shown = Overlays { heat: true, ..Overlays::default() }.over(&nobody_counts, &Times::default());
        assert_eq!(shown, nobody_counts.picture, "nobody counts");
    }

    #[test]
    fn damage_is_framed() {
        let all = Overlays { heat: true, damage: true, time: false };
        let shown = all.over(&moment(), &Times::default());
        assert_eq!([0, 1, 2].map(|x| shown.color(x, 0) == Some(Rgb888::MAGENTA)), [true, true, false]);
    }

    #[test]
    fn frames_that_are_late_are_red() {
        let mut times = Times::default();
        (0..200).for_each(|_| times.add(Duration::from_millis(3)));
        times.add(Duration::from_millis(20));
        times.add(Duration::from_secs(9));
        assert_eq!((times.0.len(), times.last()), (Times::MOST, Duration::from_secs(9)), "the last ones");
        let picture = Picture::from_colors(200, 100, vec![Rgb888::WHITE; 20_000]);
        let shown = times.over(&picture);
        let column = |x| (0..100).map(|y| shown.color(x, y)).collect::<Vec<_>>();
        let of = |x, color| column(x).iter().filter(|&&c| c == Some(color)).count();
        assert_eq!(
            (of(117, Rgb888::GREEN), of(118, Rgb888::RED), of(119, Rgb888::RED)),
            (3, 19, 33),
            "one row is the turn"
        );
        assert!(column(120).iter().all(|&color| color == Some(Rgb888::WHITE)), "beside the chart");
        let tiny = Picture::from_colors(1, 1, vec![Rgb888::WHITE]);
        assert_eq!((times.over(&tiny).width(), times.over(&tiny).height()), (1, 1), "cut off");
    }
}
