//! [`Host`]: what the loop asks of a window, and [`Glass`], a window. Tests have one that follows a script.

use std::{
    cell::RefCell,
    mem::take,
    rc::Rc,
    thread,
    time::{Duration, Instant},
};

pub use minifb::Error as WindowError;
use minifb::{InputCallback, Key, MouseButton, MouseMode, ScaleMode, Window, WindowOptions};

/// From a frame to the next: sixty a second.
const FRAME: Duration = Duration::from_nanos(16_666_667);

/// From a look at the mouse to the next. Nobody clicks in less than some ten milliseconds.
const LOOK: Duration = Duration::from_millis(4);

/// The mouse as it was when it was looked at.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub(crate) struct Hand {
    /// Its place in the window.
    pub(crate) at: (i32, i32),
    /// Left, middle and right button.
    pub(crate) buttons: [bool; 3],
    /// A step of the wheel since the look before: positive away from the hand.
    pub(crate) wheel: i32,
}

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
    /// The mouse, each time that it was looked at, in order.
    pub(crate) mouse: Vec<Hand>,
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
///
/// It calls back for each key, and for no button: those can only be asked for. So the mouse is looked at while a window waits for the next
/// frame, and a click is seen if it is down at one of these moments. It is not if it comes and goes while a program draws.
pub(crate) struct Glass {
    window: Window,
    opened: Instant,
    keys: Rc<RefCell<Vec<(Key, bool)>>>,
    mouse: Vec<Hand>,
    /// When the next frame is due.
    due: Duration,
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
    /// Opens a window that can be resized. It shows sixty frames a second at most.
    pub(crate) fn open(title: &str, (width, height): (usize, usize)) -> Result<Self, WindowError> {
        let options = WindowOptions { resize: true, scale_mode: ScaleMode::UpperLeft, ..WindowOptions::default() };
        let mut window = Window::new(title, width, height, options)?;
        // It does not wait by itself.
        window.set_target_fps(0);
        let keys = Rc::default();
        window.set_input_callback(Box::new(Listener(Rc::clone(&keys))));
        Ok(Self { window, opened: Instant::now(), keys, mouse: vec![], due: Duration::ZERO })
    }

    /// The mouse, after the window has been updated.
    fn hand(&self) -> Hand {
        #[expect(clippy::cast_possible_truncation, reason = "casts of floats stop at the ends of the range")]
        let whole = |n: f32| n.floor() as i32;
        Hand {
            at: self.window.get_mouse_pos(MouseMode::Pass).map_or((0, 0), |(x, y)| (whole(x), whole(y))),
            buttons: [MouseButton::Left, MouseButton::Middle, MouseButton::Right]
                .map(|b| self.window.get_mouse_down(b)),
            wheel: self.window.get_scroll_wheel().map_or(0, |(_, y)| i32::from(y > 0.0) - i32::from(y < 0.0)),
        }
    }
}

/// Waits until a frame is due, and looks every few milliseconds, for the last time then.
fn wait(due: Duration, now: impl Fn() -> Duration, mut sleep: impl FnMut(Duration), mut look: impl FnMut()) {
    while let Some(rest) = due.checked_sub(now()).filter(|rest| !rest.is_zero()) {
        sleep(rest.min(LOOK));
        look();
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
        let shown = if let Some((pixels, (width, height))) = pixels {
            self.window.update_with_buffer(pixels, width, height)
        } else {
            self.window.update();
            Ok(())
        };
        self.mouse.push(self.hand());
        let opened = self.opened;
        wait(
            self.due,
            || opened.elapsed(),
            thread::sleep,
            || {
                self.window.update();
                self.mouse.push(self.hand());
            },
        );
        self.due = self.now() + FRAME;
        shown
    }

    fn happened(&mut self) -> Happened {
        Happened {
            now: self.now(),
            size: self.size(),
            keys: self.keys.take(),
            is_active: self.window.is_active(),
            mouse: take(&mut self.mouse),
        }
    }

    fn title(&mut self, title: &str) {
        self.window.set_title(title);
    }

    fn say(&mut self, line: &str) {
        eprintln!("{line}");
    }
}

#[cfg(test)]
pub(super) mod tests {
    use std::cell::Cell;

    use super::*;

    /// When somebody looks who draws for so long, from a moment on: two frames of them. A look takes half a millisecond.
    pub(in super::super) fn looks(start: Duration, drawing: Duration) -> Vec<Vec<Duration>> {
        let clock = Cell::new(start);
        let mut due = start + FRAME;
        let frame = |_| {
            clock.set(clock.get() + drawing);
            let mut seen = vec![clock.get()];
            wait(
                due,
                || clock.get(),
                |by| clock.set(clock.get() + by),
                || {
                    clock.set(clock.get() + Duration::from_micros(500));
                    seen.push(clock.get());
                },
            );
            due = clock.get() + FRAME;
            seen
        };
        [0, 1].map(frame).into()
    }

    #[test]
    fn the_mouse_is_looked_at_every_few_milliseconds() {
        for drawing in [0, 3, 9] {
            let looks = looks(Duration::from_millis(100), Duration::from_millis(drawing)).concat();
            let gaps = looks.windows(2).map(|two| two[1].saturating_sub(two[0]));
            let longest = Duration::from_millis(drawing).max(LOOK) + Duration::from_micros(500);
            assert!(gaps.clone().all(|gap| gap <= longest), "{drawing}: {:?}", gaps.collect::<Vec<_>>());
            assert!(looks.len() > 2 * (16 - usize::try_from(drawing).expect("small")) / 5, "{drawing}");
        }
    }

    #[test]
    fn who_is_late_looks_once() {
        let looks = looks(Duration::from_millis(100), Duration::from_millis(40));
        assert_eq!(looks, [[Duration::from_millis(140)], [Duration::from_millis(180)]]);
    }
}
