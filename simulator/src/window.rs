//! Pictures in a window, as large as whole pixels get.

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Rgb888, RgbColor},
};
pub use minifb::{Error as WindowError, Key};
use minifb::{KeyRepeat, MouseButton, MouseMode, ScaleMode, Window, WindowOptions};

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

/// What someone did to the window. Places are pixels of the picture, which may lie outside of it.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Event {
    /// A key was pressed, or repeats; and whether a shift key is down.
    Key(Key, bool),
    /// The left button went down.
    Press(Point),
    /// The mouse has moved.
    Move(Point),
    /// The left button was let go.
    Release(Point),
    /// The right button went down.
    Menu(Point),
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
    watch(title, first, |events| {
        let key = |event: &Event| if let Event::Key(key, _) = event { Some(*key) } else { None };
        shoot(&events.iter().filter_map(key).collect::<Vec<_>>())
    })
}

/// The same, with the mouse: `shoot` is called with all that was done since the last call, keys first.
///
/// # Errors
/// As [`show`].
pub fn watch<E: From<WindowError>>(
    title: &str,
    first: Shot,
    mut shoot: impl FnMut(&[Event]) -> Result<Option<Shot>, E>,
) -> Result<(), E> {
    let (width, height) = first_size(&first.picture);
    let options = WindowOptions { resize: true, scale_mode: ScaleMode::UpperLeft, ..WindowOptions::default() };
    let mut window = Window::new(&title_of(title, &first), width, height, options)?;
    window.set_target_fps(60);
    let (mut shot, mut shown_size, mut mouse) = (first, None, Mouse::default());
    while window.is_open() && !window.is_key_down(Key::Escape) {
        let size @ (width, height) = window.get_size();
        if shown_size == Some(size) {
            window.update();
        } else {
            window.update_with_buffer(&fitted(&shot.picture, width, height), width, height)?;
            shown_size = Some(size);
        }
        let has_shift = window.is_key_down(Key::LeftShift) || window.is_key_down(Key::RightShift);
        let keys = window.get_keys_pressed(KeyRepeat::Yes).into_iter().map(|key| Event::Key(key, has_shift));
        let now = Mouse::of(&window, |x, y| place(&shot.picture, size, (x, y)));
        let events: Vec<_> = keys.chain(mouse.go(now)).collect();
        if let Some(new) = shoot(&events)? {
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

/// Where the mouse is, and its buttons.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
struct Mouse {
    at: Point,
    left: bool,
    right: bool,
}

impl Mouse {
    fn of(window: &Window, place: impl Fn(f32, f32) -> Point) -> Self {
        let at = window.get_mouse_pos(MouseMode::Pass).map_or(Point::zero(), |(x, y)| place(x, y));
        let [left, right] = [MouseButton::Left, MouseButton::Right].map(|button| window.get_mouse_down(button));
        Self { at, left, right }
    }

    /// What has happened up to `now`. A button that was let go goes up where the mouse is by then.
    fn go(&mut self, now: Self) -> impl Iterator<Item = Event> {
        let before = std::mem::replace(self, now);
        let Self { at, left, right } = now;
        let moved = (before.at != at).then_some(Event::Move(at));
        let pressed = match (before.left, left) {
            (false, true) => Some(Event::Press(at)),
            (true, false) => Some(Event::Release(at)),
            _ => None,
        };
        let menu = (right && !before.right).then_some(Event::Menu(at));
        [moved, pressed, menu].into_iter().flatten()
    }
}

/// The pixel of a picture that is shown at a place of a window.
fn place(picture: &Picture, (width, height): (usize, usize), (x, y): (f32, f32)) -> Point {
    let zoom = zoom(picture, width, height);
    let [left, top] = [margin(width, picture.width() * zoom), margin(height, picture.height() * zoom)];
    #[expect(clippy::cast_possible_truncation, reason = "casts of floats stop at the ends of the range")]
    let pixel = |at: f32, margin: usize| {
        let [margin, zoom] = [margin, zoom].map(|n| i32::try_from(n).unwrap_or(i32::MAX));
        (at.floor() as i32).saturating_sub(margin).div_euclid(zoom)
    };
    Point::new(pixel(x, left), pixel(y, top))
}

/// What is left and right, or above and below, of a picture in the middle of a window.
fn margin(window: usize, side: usize) -> usize {
    window.saturating_sub(side) / 2
}

/// The pixels of a window of `width` x `height`: the picture zoomed, in the middle, cut off where it is too large.
fn fitted(picture: &Picture, width: usize, height: usize) -> Vec<u32> {
    const AROUND: u32 = 0x0020_2428;
    let zoom = zoom(picture, width, height);
    let (left, top) = (margin(width, picture.width() * zoom), margin(height, picture.height() * zoom));
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
    fn places_are_those_that_are_shown() {
        let picture = Picture::from_colors(2, 1, vec![Rgb888::RED, Rgb888::BLUE]);
        let at = |x, y| place(&picture, (7, 3), (x, y));
        assert_eq!([at(0.0, 0.0), at(2.9, 2.9), at(3.0, 0.0)], [(0, 0), (0, 0), (1, 0)].map(Point::from), "zoom 3");
        assert_eq!([at(-0.5, -0.5), at(6.5, 3.0)], [(-1, -1), (2, 1)].map(Point::from), "outside");
        assert_eq!(place(&picture, (8, 6), (1.0, 0.0)), Point::new(0, -1), "above the picture");
    }

    #[test]
    fn the_mouse_tells_what_is_new() {
        let (a, b) = (Point::new(3, 4), Point::new(5, 4));
        let mut mouse = Mouse::default();
        let mut go = |at, left, right| mouse.go(Mouse { at, left, right }).collect::<Vec<_>>();
        assert_eq!(go(a, true, false), [Event::Move(a), Event::Press(a)], "down where it went");
        assert_eq!(go(a, true, false), [], "nothing new");
        assert_eq!(go(b, true, false), [Event::Move(b)], "a drag");
        assert_eq!(go(b, false, true), [Event::Release(b), Event::Menu(b)], "the other button");
    }

    #[test]
    fn the_title_says_what_it_costs() {
        let picture = Picture::from_colors(1, 1, vec![Rgb888::BLACK]);
        let shot = Shot { picture, caption: "4 bits".into(), ram: 38_400, drawn: 77 };
        assert_eq!(title_of("map", &shot), "map | 4 bits | 38400 bytes of RAM | 77 pixels drawn");
    }
}
