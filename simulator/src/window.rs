//! Pictures in a window, as large as whole pixels get.

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
pub use minifb::{Error as WindowError, Key};
use minifb::{KeyRepeat, ScaleMode, Window, WindowOptions};

use crate::picture::Picture;

/// One picture in the window, with what the title says of it.
#[derive(Clone, Debug)]
pub struct Shot {
    /// What is shown.
    pub picture: Picture,
    /// What it is, in a few words.
    pub caption: String,
    /// Bytes of memory that a microcontroller would spend on it.
    pub ram: usize,
    /// Pixels written to draw it, each time anew.
    pub drawn: u64,
}

/// Opens a window, shows `first` and then what `shoot` returns, until Esc is pressed or the window is closed.
///
/// `shoot` is called sixty times a second with the keys pressed since the last call; `None` leaves the picture as it is. It
/// is drawn at the largest integer zoom that fits the window, which can be resized.
///
/// # Errors
/// If no window can be opened, such as without a display, and those of `shoot`.
pub fn show<E: From<WindowError>>(
    title: &str,
    first: Shot,
    mut shoot: impl FnMut(&[Key]) -> Result<Option<Shot>, E>,
) -> Result<(), E> {
    let (width, height) = first_size(&first.picture);
    let options = WindowOptions { resize: true, scale_mode: ScaleMode::UpperLeft, ..WindowOptions::default() };
    let mut window = Window::new(&title_of(title, &first), width, height, options)?;
    window.set_target_fps(60);
    let (mut shot, mut shown_size) = (first, None);
    while window.is_open() && !window.is_key_down(Key::Escape) {
        let size @ (width, height) = window.get_size();
        if shown_size == Some(size) {
            window.update();
        } else {
            window.update_with_buffer(&fitted(&shot.picture, width, height), width, height)?;
            shown_size = Some(size);
        }
        if let Some(new) = shoot(&window.get_keys_pressed(KeyRepeat::Yes))? {
            window.set_title(&title_of(title, &new));
            (shot, shown_size) = (new, None);
        }
    }
    Ok(())
}

/// The picture at the largest zoom that stays within 1280 x 960, at least 1.
fn first_size(picture: &Picture) -> (usize, usize) {
    let zoom = zoom(picture, 1280, 960);
    ((picture.width() * zoom).max(1), (picture.height() * zoom).max(1))
}

/// The largest integer zoom at which the picture fits, at least 1.
fn zoom(picture: &Picture, width: usize, height: usize) -> usize {
    (width / picture.width().max(1)).min(height / picture.height().max(1)).max(1)
}

fn title_of(title: &str, shot: &Shot) -> String {
    let Shot { caption, ram, drawn, .. } = shot;
    format!("{title} | {caption} | {ram} bytes of RAM | {drawn} pixels drawn")
}

/// The pixels of a window of `width` x `height`: the picture zoomed, in the middle, cut off where it is too large.
fn fitted(picture: &Picture, width: usize, height: usize) -> Vec<u32> {
    const AROUND: u32 = 0x0020_2428;
    let zoom = zoom(picture, width, height);
    let margin = |window: usize, side: usize| window.saturating_sub(side * zoom) / 2;
    let (left, top) = (margin(width, picture.width()), margin(height, picture.height()));
    let color = |x: usize, y: usize| {
        let (x, y) = (x.checked_sub(left)? / zoom, y.checked_sub(top)? / zoom);
        picture.color(x, y).map(word)
    };
    (0..height).flat_map(|y| (0..width).map(move |x| color(x, y).unwrap_or(AROUND))).collect()
}

fn word(c: Rgb888) -> u32 {
    u32::from_be_bytes([0, c.r(), c.g(), c.b()])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_pixels_in_the_middle() {
        let (red, blue) = (Rgb888::RED, Rgb888::BLUE);
        let picture = Picture::from_colors(2, 1, vec![red, blue]);
        let (r, b, o) = (0x00ff_0000, 0x0000_00ff, 0x0020_2428);
        #[rustfmt::skip]
        assert_eq!(fitted(&picture, 5, 3), [
            r, r, b, b, o,
            r, r, b, b, o,
            o, o, o, o, o,
        ], "twice as large");
        assert_eq!(fitted(&picture, 1, 2), [r, o], "cut off");
        assert_eq!(first_size(&picture), (1280, 640), "at first");
        assert_eq!(first_size(&Picture::from_colors(2000, 9, vec![red; 18_000])), (2000, 9), "never smaller");
    }

    #[test]
    fn the_title_says_what_it_costs() {
        let picture = Picture::from_colors(1, 1, vec![Rgb888::BLACK]);
        let shot = Shot { picture, caption: "4 bits".into(), ram: 38_400, drawn: 77 };
        assert_eq!(title_of("map", &shot), "map | 4 bits | 38400 bytes of RAM | 77 pixels drawn");
    }
}
