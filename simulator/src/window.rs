//! Pictures in a window, as large as whole pixels get, with keys that every such program has.
//!
//! | key | what it does |
//! |---|---|
//! | F2 | writes what is shown as a PNG file |
//! | F3, F4 | begins a film, GIF or APNG; ends it and writes it |
//! | F5 | lines between pixels |
//! | F6 | a line that says what the pixel under the mouse is, and how long a frame took |
//! | F7, F8, the wheel | zoom out and in, around the mouse; the middle button moves what does not fit |
//! | F9 | the zoom at which all fits |
//! | Esc | ends |

pub use crate::desktop::{Event, Key, WindowError};
use crate::{
    desktop::{drive, Glass, Input, Shown},
    picture::Picture,
};

/// One picture in the window, with what the title says of it.
#[derive(Clone, Debug)]
pub struct Shot {
    /// What is shown.
    pub picture: Picture,
    /// What it is, in a few words.
    pub caption: String,
    /// Bytes of memory that a microcontroller would spend on it.
    pub ram: usize,
    /// Pixels written to draw it, each time anew; 0 if nobody has counted.
    pub drawn: u64,
}

impl From<Shot> for Shown {
    fn from(Shot { picture, caption, ram, drawn }: Shot) -> Self {
        let drawn = if drawn == 0 { String::new() } else { format!(" | {drawn} pixels drawn") };
        Self { picture, caption: format!("{caption} | {ram} bytes of RAM{drawn}") }
    }
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
    let first = Shown::from(first);
    let mut window = Glass::open(&first.title_of(title), first.first_size())?;
    drive(&mut window, title, ".", first, |input: &mut Input| Ok(shoot(input.events())?.map(Shown::from)))
}

#[cfg(test)]
mod tests {
    use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};

    use super::*;

    #[test]
    fn the_title_says_what_it_costs() {
        let picture = Picture::from_colors(1, 1, vec![Rgb888::BLACK]);
        let shot = Shot { picture, caption: "4 bits".into(), ram: 38_400, drawn: 77 };
        let uncounted = Shot { drawn: 0, ..shot.clone() };
        let title = |shot| Shown::from(shot).title_of("map");
        assert_eq!(title(shot), "map | 4 bits | 38400 bytes of RAM | 77 pixels drawn");
        assert_eq!(title(uncounted), "map | 4 bits | 38400 bytes of RAM");
    }
}
