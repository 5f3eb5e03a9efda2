//! [`Host`]: what the loop asks of a window, and [`Glass`], a window. Tests have one that follows a script.

use std::{
    cell::RefCell,
    rc::Rc,
    time::{Duration, Instant},
};

pub use minifb::Error as WindowError;
use minifb::{InputCallback, Key, MouseButton, MouseMode, ScaleMode, Window, WindowOptions};

/// What has happened to a window since the last time.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Happened {
    /// Time since the window was opened.
    pub(crate) now: Duration,
    /// Columns and rows of the window.
    pub(crate) size: (usize, usize),
    /// Keys that went down (`true`) and up, in order. None is left out, however short it was down.
    pub(crate) keys: Vec<(Key, bool)>,
    /// Whether the window is in front: if not, it is not told of keys.
    pub(crate) is_active: bool,
    /// The place of the mouse in the window.
    pub(crate) mouse: (i32, i32),
    /// Left, middle and right button.
    pub(crate) buttons: [bool; 3],
    /// Steps of the wheel, positive away from the hand.
    pub(crate) wheel: i32,
}

/// A window, as the loop needs it.
pub(crate) trait Host {
    /// `false` from when somebody has closed it.
    fn is_open(&self) -> bool;

    /// Columns and rows.
    fn size(&self) -> (usize, usize);

    /// Time since it was opened.
    fn now(&self) -> Duration;

    /// Shows pixels, as many as the window has; `None` if they have not changed. Returns when the next frame is due.
    fn show(&mut self, pixels: Option<(&[u32], (usize, usize))>) -> Result<(), WindowError>;

    /// What has happened since the last call.
    fn happened(&mut self) -> Happened;

    /// Changes the title.
    fn title(&mut self, title: &str);

    /// Says in a line what was done.
    fn say(&mut self, line: &str);
}

/// A window of the system.
pub(crate) struct Glass {
    window: Window,
    opened: Instant,
    keys: Rc<RefCell<Vec<(Key, bool)>>>,
}

/// Hears of every key. Asking the window which keys are down would miss those that are up again by then.
struct Listener(Rc<RefCell<Vec<(Key, bool)>>>);

impl InputCallback for Listener {
    fn add_char(&mut self, _: u32) {}

    fn set_key_state(&mut self, key: Key, is_down: bool) {
        self.0.borrow_mut().push((key, is_down));
    }
}

impl Glass {
    /// Opens a window that can be resized, and shows sixty frames a second at most.
    pub(crate) fn open(title: &str, (width, height): (usize, usize)) -> Result<Self, WindowError> {
        let options = WindowOptions { resize: true, scale_mode: ScaleMode::UpperLeft, ..WindowOptions::default() };
        let mut window = Window::new(title, width, height, options)?;
        window.set_target_fps(60);
        let keys = Rc::default();
        window.set_input_callback(Box::new(Listener(Rc::clone(&keys))));
        Ok(Self { window, opened: Instant::now(), keys })
    }
}

impl Host for Glass {
    fn is_open(&self) -> bool {
        self.window.is_open()
    }

    fn size(&self) -> (usize, usize) {
        self.window.get_size()
    }

    fn now(&self) -> Duration {
        self.opened.elapsed()
    }

    fn show(&mut self, pixels: Option<(&[u32], (usize, usize))>) -> Result<(), WindowError> {
        if let Some((pixels, (width, height))) = pixels {
            self.window.update_with_buffer(pixels, width, height)
        } else {
            self.window.update();
            Ok(())
        }
    }

    fn happened(&mut self) -> Happened {
        let button = |button| self.window.get_mouse_down(button);
        #[expect(clippy::cast_possible_truncation, reason = "casts of floats stop at the ends of the range")]
        let whole = |n: f32| n.floor() as i32;
        Happened {
            now: self.now(),
            size: self.size(),
            keys: self.keys.take(),
            is_active: self.window.is_active(),
            mouse: self.window.get_mouse_pos(MouseMode::Pass).map_or((0, 0), |(x, y)| (whole(x), whole(y))),
            buttons: [MouseButton::Left, MouseButton::Middle, MouseButton::Right].map(button),
            wheel: self.window.get_scroll_wheel().map_or(0, |(_, y)| i32::from(y > 0.0) - i32::from(y < 0.0)),
        }
    }

    fn title(&mut self, title: &str) {
        self.window.set_title(title);
    }

    fn say(&mut self, line: &str) {
        eprintln!("{line}");
    }
}
