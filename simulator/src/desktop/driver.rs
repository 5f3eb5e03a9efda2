//! [`drive`]: the loop of a window. It shows what a program draws, tells it what was done, and has keys of its own.

use std::{io, path::Path, path::PathBuf, time::Duration};

use super::{
    host::{Hand, Happened, Host, WindowError},
    input::{Event, Input, Key, Keyboard, Mouse},
    inspector,
    recorder::{Kind, Recorder},
    view::{first_size, View},
};
use crate::picture::Picture;

/// For how long the title says what was written.
const NOTE: Duration = Duration::from_secs(3);

/// What a window shows, and what its title says of it.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    pub(crate) picture: Picture,
    pub(crate) caption: String,
}

impl Shown {
    pub(crate) fn title_of(&self, title: &str) -> String {
        format!("{title} | {}", self.caption)
    }

    /// Columns and rows of the window that it opens.
    pub(crate) fn first_size(&self) -> (usize, usize) {
        first_size((self.picture.width(), self.picture.height()))
    }
}

/// Shows `first` and then what `shoot` returns, until Esc is pressed, the window is closed, or the program closes it.
///
/// * `folder`: where the files go that somebody asks for by a key.
/// * `shoot`: called sixty times a second; `None` leaves the picture as it is.
pub(crate) fn drive<E: From<WindowError>>(
    host: &mut impl Host,
    title: &str,
    folder: impl AsRef<Path>,
    first: Shown,
    mut shoot: impl FnMut(&mut Input) -> Result<Option<Shown>, E>,
) -> Result<(), E> {
    let mut desk = Desk::new(host, title, Recorder::new(folder, title), first);
    while host.is_open() {
        desk.show(host)?;
        let mut input = desk.input(host);
        if input.is_down(Key::Escape) {
            break;
        }
        let start = host.now();
        let new = shoot(&mut input)?;
        desk.timed(start, host.now());
        if let Some(new) = new {
            desk.take(host, new);
        }
        if input.closes {
            break;
        }
    }
    let written = desk.recorder.finish(host.now());
    desk.tell(host, written);
    Ok(())
}

/// What a loop remembers from frame to frame.
struct Desk<'a> {
    title: &'a str,
    recorder: Recorder,
    shown: Shown,
    view: View,
    keyboard: Keyboard,
    mouse: Mouse,
    /// The place of the mouse in the window, and the state of the middle button.
    pointer: ((i32, i32), bool),
    inspects: bool,
    /// The size of the window for which the pixels were made, until they change.
    composed: Option<(usize, usize)>,
    took: Duration,
    /// When the last frames were begun, the latest one last: at most one second of them.
    frames: Vec<Duration>,
    /// When the title says again what is shown.
    note_ends: Option<Duration>,
}

impl<'a> Desk<'a> {
    fn new(host: &mut impl Host, title: &'a str, recorder: Recorder, shown: Shown) -> Self {
        host.title(&shown.title_of(title));
        Self {
            title,
            recorder,
            shown,
            view: View::default(),
            keyboard: Keyboard::default(),
            mouse: Mouse::default(),
            pointer: ((0, 0), false),
            inspects: false,
            composed: None,
            took: Duration::ZERO,
            frames: vec![],
            note_ends: None,
        }
    }

    fn show(&mut self, host: &mut impl Host) -> Result<(), WindowError> {
        let size = host.size();
        // The line of the inspector changes with every frame.
        if self.composed == Some(size) && !self.inspects {
            return host.show(None);
        }
        let pixels = self.pixels(size);
        self.composed = Some(size);
        host.show(Some((&pixels, size)))
    }

    fn pixels(&self, size: (usize, usize)) -> Vec<u32> {
        let picture = &self.shown.picture;
        let placed = self.view.placed(picture, size);
        let mut pixels = placed.compose(picture, size, self.view.has_grid);
        if self.inspects {
            let at = placed.pixel(self.pointer.0);
            let [x, y] = [at.x, at.y].map(|n| usize::try_from(n).unwrap_or(usize::MAX));
            let color = picture.color(x, y);
            if color.is_some() {
                placed.mark(at, &mut pixels, size.0);
            }
            let rate = u32::try_from(self.frames.len()).unwrap_or(u32::MAX);
            inspector::draw(&inspector::text(picture, at, self.took, rate), color, &mut pixels, size);
        }
        pixels
    }

    /// What was done, without what the loop keeps for itself.
    fn input(&mut self, host: &mut impl Host) -> Input {
        let (happened, mut input) = (host.happened(), Input::default());
        if self.note_ends.is_some_and(|end| end <= happened.now) {
            self.note_ends = None;
            host.title(&self.shown.title_of(self.title));
        }
        self.keyboard.go(&happened.keys, happened.now, &mut input);
        if !happened.is_active {
            self.keyboard.let_go(&mut input);
        }
        let pointer = happened.mouse.last().map_or(self.pointer.0, |hand| hand.at);
        for key in own_keys(&mut input) {
            self.key(host, key, pointer, &happened);
        }
        for hand in &happened.mouse {
            self.look(hand, happened.size);
            let [left, _, right] = hand.buttons;
            let at = self.view.placed(&self.shown.picture, happened.size).pixel(hand.at);
            input.events.extend(self.mouse.go(Mouse { at, left, right }));
            input.has_left |= left;
        }
        // A window that has not looked knows nothing new.
        input.has_left |= self.mouse.left;
        input.mouse = self.mouse.at;
        input
    }

    /// Moves and zooms as the mouse says.
    fn look(&mut self, hand: &Hand, size: (usize, usize)) {
        let [_, middle, _] = hand.buttons;
        let (before, was_down) = std::mem::replace(&mut self.pointer, (hand.at, middle));
        let by = (hand.at.0.saturating_sub(before.0), hand.at.1.saturating_sub(before.1));
        if middle && was_down && by != (0, 0) {
            self.view.drag(by, &self.shown.picture, size);
            self.composed = None;
        }
        if hand.wheel != 0 {
            self.zoom(hand.wheel > 0, hand.at, size);
        }
    }

    fn zoom(&mut self, is_larger: bool, around: (i32, i32), size: (usize, usize)) {
        self.view.zoom(is_larger, around, &self.shown.picture, size);
        self.composed = None;
    }

    /// Does what a key of the loop asks for.
    fn key(&mut self, host: &mut impl Host, key: Key, pointer: (i32, i32), happened: &Happened) {
        let picture = &self.shown.picture;
        match key {
            Key::F2 => {
                let written = self.recorder.screenshot(picture).map(Some);
                self.tell(host, written);
            }
            Key::F3 | Key::F4 => {
                let kind = if key == Key::F3 { Kind::Gif } else { Kind::Apng };
                let written = self.recorder.toggle(kind, picture, happened.now);
                self.tell(host, written);
                if self.recorder.is_filming() {
                    self.note(host, "filming");
                }
            }
            Key::F5 => self.view.has_grid = !self.view.has_grid,
            Key::F6 => self.inspects = !self.inspects,
            Key::F7 | Key::F8 => self.zoom(key == Key::F8, pointer, happened.size),
            _ => self.view.fit(),
        }
        self.composed = None;
    }

    fn timed(&mut self, start: Duration, end: Duration) {
        self.took = end.saturating_sub(start);
        self.frames.retain(|frame| start.saturating_sub(*frame) < Duration::from_secs(1));
        self.frames.push(start);
    }

    fn take(&mut self, host: &mut impl Host, new: Shown) {
        let written = self.recorder.see(&new.picture, host.now());
        self.tell(host, written);
        if new.caption != self.shown.caption && self.note_ends.is_none() {
            host.title(&new.title_of(self.title));
        }
        (self.shown, self.composed) = (new, None);
    }

    /// Says what was written, if anything was, or why not.
    fn tell(&mut self, host: &mut impl Host, written: io::Result<Option<PathBuf>>) {
        match written {
            Ok(None) => {}
            Ok(Some(path)) => self.note(host, &format!("{} written", path.display())),
            Err(error) => self.note(host, &error.to_string()),
        }
    }

    fn note(&mut self, host: &mut impl Host, line: &str) {
        host.say(&format!("{}: {line}", self.title));
        host.title(&format!("{} | {line}", self.title));
        self.note_ends = Some(host.now() + NOTE);
    }
}

/// Takes the keys of the loop out of what a program is told, and returns those that do something. Only zooming repeats.
fn own_keys(input: &mut Input) -> Vec<Key> {
    let is_own = |key| matches!(key, Key::F2 | Key::F3 | Key::F4 | Key::F5 | Key::F6 | Key::F7 | Key::F8 | Key::F9);
    let repeats = |key| matches!(key, Key::F7 | Key::F8);
    let (mut own, pressed) = (vec![], input.pressed.clone());
    input.events.retain(|event| match *event {
        Event::Key(key, _) if is_own(key) => {
            own.extend(Some(key).filter(|key| repeats(*key) || pressed.contains(key)));
            false
        }
        _ => true,
    });
    for keys in [&mut input.pressed, &mut input.released, &mut input.held] {
        keys.retain(|key| !is_own(*key));
    }
    own
}

#[cfg(test)]
mod tests {
    use std::fs;

    use embedded_graphics_core::{
        geometry::Point,
        pixelcolor::{Rgb888, RgbColor},
    };

    use super::{super::host::tests::looks, *};

    /// A window that follows a script: what happens in each frame, 20 ms apart.
    struct Script {
        steps: Vec<Happened>,
        frame: usize,
        /// What was shown last, and in how many frames it was new.
        pixels: Vec<u32>,
        composed: usize,
        titles: Vec<String>,
        said: Vec<String>,
    }

    const SIZE: (usize, usize) = (40, 30);

    impl Script {
        fn new(steps: Vec<Happened>) -> Self {
            Self { steps, frame: 0, pixels: vec![], composed: 0, titles: vec![], said: vec![] }
        }
    }

    impl Host for Script {
        fn is_open(&self) -> bool {
            self.frame < self.steps.len()
        }

        fn size(&self) -> (usize, usize) {
            self.steps.get(self.frame).map_or(SIZE, |step| step.size)
        }

        fn now(&self) -> Duration {
            Duration::from_millis(20 * self.frame as u64)
        }

        fn show(&mut self, pixels: Option<(&[u32], (usize, usize))>) -> Result<(), WindowError> {
            if let Some((pixels, (width, height))) = pixels {
                assert_eq!(pixels.len(), width * height, "as many pixels as the window has");
                (self.pixels, self.composed) = (pixels.to_vec(), self.composed + 1);
            }
            Ok(())
        }

        fn happened(&mut self) -> Happened {
            let now = self.now();
            self.frame += 1;
            Happened { now, ..self.steps[self.frame - 1].clone() }
        }

        fn title(&mut self, title: &str) {
            self.titles.push(title.into());
        }

        fn say(&mut self, line: &str) {
            self.said.push(line.into());
        }
    }

    /// A frame in which nothing happens.
    fn quiet() -> Happened {
        Happened { size: SIZE, is_active: true, ..Happened::default() }
    }

    /// A frame in which keys go down and up.
    fn tapped(keys: &[Key]) -> Happened {
        let keys = keys.iter().flat_map(|&key| [(key, true), (key, false)]).collect();
        Happened { keys, ..quiet() }
    }

    /// A frame in which the mouse is looked at.
    fn pointed(mouse: &[Hand]) -> Happened {
        Happened { mouse: mouse.to_vec(), ..quiet() }
    }

    fn shown(red: u8) -> Shown {
        let picture = Picture::from_colors(4, 3, vec![Rgb888::new(red, 0, 0); 12]);
        Shown { picture, caption: format!("{red}") }
    }

    /// Plays a script; a program that changes nothing. Returns the window, and what the program was told.
    fn play(steps: Vec<Happened>, folder: &Path) -> (Script, Vec<Input>) {
        let (mut script, mut told) = (Script::new(steps), vec![]);
        let shoot = |input: &mut Input| {
            told.push(input.clone());
            Ok::<_, WindowError>(None)
        };
        drive(&mut script, "game", folder, shown(255), shoot).expect("no error");
        (script, told)
    }

    #[test]
    fn a_program_is_told_all_but_the_keys_of_the_loop() {
        let pressed = Hand { at: (25, 12), buttons: [true, false, false], wheel: 0 };
        let steps = vec![
            tapped(&[Key::A, Key::F6, Key::B]),
            pointed(&[pressed]),
            Happened { keys: vec![(Key::A, true)], ..pointed(&[pressed]) },
            Happened { is_active: false, ..pointed(&[Hand { at: (25, 12), ..Hand::default() }]) },
        ];
        let (_, told) = play(steps, Path::new("."));
        assert_eq!(told[0].events(), [Event::Key(Key::A, false), Event::Key(Key::B, false)], "keys");
        assert!(!told[0].is_down(Key::F6) && !told[0].is_released(Key::F6), "not this one");
        let at = Point::new(2, 1);
        assert_eq!(told[1].events(), [Event::Move(at), Event::Press(at)], "pixels of ten by ten");
        assert!(told[2].is_mouse_down() && told[2].is_down(Key::A), "both are down");
        assert_eq!(told[3].events(), [Event::Release(at)], "it goes up");
        assert!(told[3].is_released(Key::A) && !told[3].is_down(Key::A), "the window is not in front any more");
    }

    #[test]
    fn a_click_between_two_frames_is_not_lost() {
        let hand = |x, left, right| Hand { at: (x, 12), buttons: [left, false, right], wheel: 0 };
        let click = [hand(5, false, false), hand(25, true, false), hand(25, true, false), hand(35, false, false)];
        let menu = [hand(35, false, false), hand(35, false, true), hand(35, false, false)];
        let (_, told) = play(vec![pointed(&click), pointed(&menu), quiet()], Path::new("."));
        let [a, b, c] = [0, 2, 3].map(|x| Point::new(x, 1));
        let events = [Event::Move(a), Event::Move(b), Event::Press(b), Event::Move(c), Event::Release(c)];
        assert_eq!(told[0].events(), events, "where and in which order it was");
        assert!(told[0].is_mouse_down() && told[0].mouse() == c, "for a moment");
        assert!(told[1].events() == [Event::Menu(c)] && !told[1].is_mouse_down(), "the other button");
        assert!(told[2].events().is_empty() && told[2].mouse() == c, "nobody has looked");
    }

    /// Ten milliseconds, from any moment on, with a program that draws for nine.
    #[test]
    fn a_click_of_ten_milliseconds_is_seen() {
        for start in (0..20_000).step_by(250) {
            let click = Duration::from_micros(start)..Duration::from_micros(start + 10_000);
            let frames = looks(Duration::ZERO, Duration::from_millis(9)).into_iter().map(|frame| {
                let hands =
                    frame.iter().map(|now| Hand { buttons: [click.contains(now), false, false], ..Hand::default() });
                pointed(&hands.collect::<Vec<_>>())
            });
            let (_, told) = play(frames.collect(), Path::new("."));
            let presses = told.iter().flat_map(Input::events).filter(|event| matches!(event, Event::Press(_)));
            assert_eq!(presses.count(), 1, "{start}");
        }
    }

    #[test]
    fn what_does_not_change_is_not_composed_again() {
        let (script, _) = play(vec![quiet(), quiet(), quiet()], Path::new("."));
        assert_eq!((script.composed, script.titles), (1, vec!["game | 255".to_owned()]), "once");
        let larger = Happened { size: (80, 60), ..quiet() };
        let (script, _) = play(vec![quiet(), larger.clone(), larger], Path::new("."));
        assert_eq!(script.composed, 2, "once for each size");
        let (script, _) = play(vec![tapped(&[Key::F6]), quiet(), quiet()], Path::new("."));
        assert_eq!(script.composed, 3, "the inspector changes with time");
    }

    #[test]
    fn esc_and_the_program_end_it() {
        let (_, told) = play(vec![quiet(), tapped(&[Key::Escape]), quiet()], Path::new("."));
        assert_eq!(told.len(), 1, "even if it was short");
        let (mut script, mut frames) = (Script::new(vec![quiet(); 9]), 0);
        let shoot = |input: &mut Input| {
            frames += 1;
            if frames == 3 {
                input.close();
            }
            Ok::<_, WindowError>(Some(shown(frames)))
        };
        drive(&mut script, "game", ".", shown(255), shoot).expect("no error");
        assert_eq!(script.titles, ["game | 255", "game | 1", "game | 2", "game | 3"], "three frames");
        assert_eq!(script.composed, 3, "the last one is not shown");
    }

    #[test]
    fn an_error_of_the_program_ends_it() {
        let mut script = Script::new(vec![quiet(); 9]);
        let error = drive(&mut script, "game", ".", shown(1), |_| Err(Box::<dyn std::error::Error>::from("too large")));
        assert_eq!(error.map_err(|error| error.to_string()), Err("too large".into()));
    }

    #[test]
    fn zoom_and_grid_change_what_is_shown() {
        let red = 0x00ff_0000;
        let count = |script: &Script| script.pixels.iter().filter(|&&pixel| pixel == red).count();
        let (script, _) = play(vec![quiet(), quiet()], Path::new("."));
        assert_eq!(count(&script), 1200, "all of it");
        let (script, _) = play(vec![tapped(&[Key::F7, Key::F7]), quiet()], Path::new("."));
        assert_eq!(count(&script), 12 * 64, "eight by eight");
        let (script, _) = play(vec![tapped(&[Key::F5]), quiet()], Path::new("."));
        assert_eq!(count(&script), 12 * 81, "a column and a row of each are lines");
        let wheel = pointed(&[Hand { wheel: 1, ..Hand::default() }]);
        let corner = pointed(&[Hand { at: (39, 29), ..Hand::default() }]);
        let (script, told) = play(vec![wheel.clone(), corner, quiet()], Path::new("."));
        assert_eq!((count(&script), told[1].mouse()), (1200, Point::new(3, 2)), "11 by 11");
        let drag = |x| pointed(&[Hand { at: (x, 0), buttons: [false, true, false], wheel: 0 }]);
        let (_, told) = play(vec![wheel, drag(9), drag(0), quiet()], Path::new("."));
        assert_eq!(told.last().map(Input::mouse), Some(Point::new(0, 0)), "moved by four columns at most");
        let (script, _) = play(vec![tapped(&[Key::F7, Key::F7, Key::F9]), quiet()], Path::new("."));
        assert_eq!(count(&script), 1200, "as at first");
    }

    #[test]
    fn files_are_written_by_keys() {
        let folder = std::env::temp_dir().join(format!("embedded-raster-desk-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        // F2 is held: one picture. F3 begins a film that the end of the program ends.
        let held = Happened { keys: vec![(Key::F2, true)], ..quiet() };
        let mut steps = vec![held];
        steps.resize(40, quiet());
        steps.push(tapped(&[Key::F3]));
        steps.resize(45, quiet());
        let (script, _) = play(steps, &folder);
        let mut names: Vec<_> = fs::read_dir(&folder)
            .expect("it is there")
            .map(|file| file.expect("a file").file_name().into_string().expect("plain"))
            .collect();
        names.sort();
        assert_eq!(names, ["game-1.gif", "game-1.png"]);
        let picture = Picture::read_png(folder.join("game-1.png")).expect("a picture");
        assert!(picture.colors().all(|color| color == Rgb888::RED) && picture.width() == 4, "as drawn, not as zoomed");
        assert_eq!(script.said.len(), 3, "{:?}", script.said);
        let told: Vec<_> = script.titles.iter().map(|title| title.rsplit(' ').next().unwrap_or_default()).collect();
        assert_eq!(told, ["255", "written", "filming", "written"], "{:?}", script.titles);
        fs::remove_dir_all(folder).expect("it is there");
    }

    #[test]
    fn a_note_goes_after_a_while() {
        let mut steps = vec![tapped(&[Key::F2])];
        steps.resize(200, quiet());
        let (script, _) = play(steps, Path::new("/no/such/folder"));
        assert!(script.titles[1].contains("/no/such/folder"), "{:?}", script.titles);
        assert_eq!(script.titles.last().map(String::as_str), Some("game | 255"), "as before");
    }
}
