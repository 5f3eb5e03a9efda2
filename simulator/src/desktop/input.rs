//! What is done to a window, as a program is told it: [`Event`], [`Input`], and the keyboard and the mouse that they come from.

use std::time::Duration;

use embedded_graphics_core::geometry::Point;
pub use minifb::Key;

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

/// What was done since the last frame, and what is down now.
///
/// A key that was down for less than a frame is there as any other. So is a click, unless it came and went while the frame was drawn: no window
/// tells of buttons, and they are looked at every four milliseconds while a frame waits for the next one.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Input {
    pub(super) events: Vec<Event>,
    pub(super) pressed: Vec<Key>,
    pub(super) released: Vec<Key>,
    pub(super) held: Vec<Key>,
    pub(super) mouse: Point,
    pub(super) has_left: bool,
    pub(super) closes: bool,
}

impl Input {
    /// One frame in which these keys are pressed and let go: for scripts.
    pub fn keys(keys: &[Key]) -> Self {
        let events = keys.iter().map(|&key| Event::Key(key, false)).collect();
        Self { events, pressed: keys.to_vec(), released: keys.to_vec(), ..Self::default() }
    }

    /// All that was done, in order, keys first. A key that is held repeats.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// Whether a key went down, however short.
    pub fn is_pressed(&self, key: Key) -> bool {
        self.pressed.contains(&key)
    }

    /// Whether a key was let go.
    pub fn is_released(&self, key: Key) -> bool {
        self.released.contains(&key)
    }

    /// Whether a key is down, or was for a moment.
    pub fn is_down(&self, key: Key) -> bool {
        self.held.contains(&key) || self.is_pressed(key)
    }

    /// The pixel that the mouse is on, which may lie outside of the picture.
    pub fn mouse(&self) -> Point {
        self.mouse
    }

    /// Whether the left button is down, or was for a moment.
    pub fn is_mouse_down(&self) -> bool {
        self.has_left
    }

    /// Ends the program after this frame.
    pub fn close(&mut self) {
        self.closes = true;
    }
}

/// How long a key is held until it repeats, and how long until it does again.
const REPEATS: (Duration, Duration) = (Duration::from_millis(250), Duration::from_millis(50));

/// The keys that are down, each with the moment at which it repeats.
#[derive(Clone, Debug, Default)]
pub(super) struct Keyboard {
    held: Vec<(Key, Duration)>,
}

impl Keyboard {
    /// Takes the keys that went down and up, in order, into account.
    ///
    /// A system that repeats keys by itself says several times that one goes down: only the first time counts.
    pub(super) fn go(&mut self, changes: &[(Key, bool)], now: Duration, input: &mut Input) {
        for &(key, is_down) in changes {
            let before = self.held.iter().position(|(held, _)| *held == key);
            match (is_down, before) {
                (true, None) => {
                    self.held.push((key, now + REPEATS.0));
                    input.pressed.push(key);
                    input.events.push(Event::Key(key, self.has_shift()));
                }
                (false, Some(at)) => {
                    self.held.remove(at);
                    input.released.push(key);
                }
                _ => {}
            }
        }
        let has_shift = self.has_shift();
        // Once a frame at most, however long the frame took.
        for (key, next) in self.held.iter_mut().filter(|(_, next)| *next <= now) {
            *next = now + REPEATS.1;
            input.events.push(Event::Key(*key, has_shift));
        }
        input.held = self.held.iter().map(|(key, _)| *key).collect();
    }

    /// Lets go of all keys: a window that is not in front is not told what happens to them.
    pub(super) fn let_go(&mut self, input: &mut Input) {
        input.released.extend(self.held.drain(..).map(|(key, _)| key));
        input.held.clear();
    }

    fn has_shift(&self) -> bool {
        self.held.iter().any(|(key, _)| matches!(key, Key::LeftShift | Key::RightShift))
    }
}

/// Where the mouse is, and its buttons.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub(super) struct Mouse {
    pub(super) at: Point,
    pub(super) left: bool,
    pub(super) right: bool,
}

impl Mouse {
    /// What has happened up to `now`. A button that was let go goes up where the mouse is by then.
    pub(super) fn go(&mut self, now: Self) -> impl Iterator<Item = Event> {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The keys that a program is told of, and those that are down after that.
    fn go(keyboard: &mut Keyboard, changes: &[(Key, bool)], millis: u64) -> (Vec<Event>, Vec<Key>) {
        let mut input = Input::default();
        keyboard.go(changes, Duration::from_millis(millis), &mut input);
        (input.events, input.held)
    }

    #[test]
    fn a_key_shorter_than_a_frame_is_not_lost() {
        let (mut keyboard, mut input) = (Keyboard::default(), Input::default());
        keyboard.go(&[(Key::A, true), (Key::A, false), (Key::A, true), (Key::A, false)], Duration::ZERO, &mut input);
        assert_eq!(input.events(), [Event::Key(Key::A, false); 2], "twice");
        assert!(input.is_pressed(Key::A) && input.is_released(Key::A) && input.is_down(Key::A), "in this frame");
        assert_eq!(go(&mut keyboard, &[], 16), (vec![], vec![]), "and no longer");
    }

    #[test]
    fn keys_that_are_held_repeat() {
        let mut keyboard = Keyboard::default();
        let told = (vec![Event::Key(Key::A, false)], vec![Key::A]);
        let quiet = (vec![], vec![Key::A]);
        assert_eq!(go(&mut keyboard, &[(Key::A, true)], 0), told, "it goes down");
        assert_eq!(go(&mut keyboard, &[(Key::A, true)], 249), quiet, "a system that repeats by itself");
        assert_eq!(go(&mut keyboard, &[], 250), told, "a quarter of a second");
        assert_eq!(go(&mut keyboard, &[], 299), quiet, "not yet");
        assert_eq!(go(&mut keyboard, &[], 5_000), told, "once a frame");
        assert_eq!(go(&mut keyboard, &[(Key::A, false)], 5_001), (vec![], vec![]), "it goes up");
        assert_eq!(go(&mut keyboard, &[], 9_000), (vec![], vec![]), "and is quiet");
    }

    #[test]
    fn shift_is_what_it_was_when_the_key_went_down() {
        let mut keyboard = Keyboard::default();
        let changes = [(Key::A, true), (Key::LeftShift, true), (Key::B, true), (Key::LeftShift, false), (Key::C, true)];
        let (events, _) = go(&mut keyboard, &changes, 0);
        let is_told = |key, shift| events.contains(&Event::Key(key, shift));
        assert!(is_told(Key::A, false) && is_told(Key::B, true) && is_told(Key::C, false), "{events:?}");
    }

    #[test]
    fn a_window_behind_others_holds_no_keys() {
        let mut keyboard = Keyboard::default();
        go(&mut keyboard, &[(Key::A, true)], 0);
        let mut input = Input::default();
        keyboard.let_go(&mut input);
        assert!(input.is_released(Key::A) && !input.is_down(Key::A), "it is up");
        assert_eq!(go(&mut keyboard, &[], 9_000), (vec![], vec![]), "nothing repeats");
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
}
