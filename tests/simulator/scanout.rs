//! What a display shows over time: the tear of one buffer, and its absence with two and three.

use embedded_graphics::pixelcolor::{raw::RawU16, Rgb565, Rgb888, RgbColor};
use embedded_raster::{buffer_bytes, pixel::Be, Canvas, Framebuffer, Index4, Palette, Rect};
use embedded_raster_simulator::{
    scanout::{play, Flips, Played, Scanout},
    Picture,
};

const WIDTH: u16 = 32;
const HEIGHT: u16 = 48;
const MILLISECOND: u64 = 1_000_000;

/// Pixels, and the palette that belongs to them.
type Screen = (Vec<u8>, Palette<Rgb565, 16>);

fn screen() -> Screen {
    let mut palette = Palette::new([Rgb565::BLACK; 16]);
    palette.set(1, Rgb565::YELLOW);
    (vec![0; buffer_bytes::<Index4>(WIDTH, HEIGHT)], palette)
}

/// The column of a bar that moves.
fn column(frame: u32) -> i32 {
    i32::try_from(frame * 3 % 28).expect("a column")
}

/// Parts of a frame: it is cleared, and then the bar is drawn, from the bottom up.
const PARTS: usize = 8;

/// Draws a part of a frame.
fn draw(screen: &mut Screen, frame: u32, part: usize) {
    let (height, x) = (i32::from(HEIGHT), column(frame));
    let mut bar = |y0: i32, y1: i32| fill(screen, Rect::new(x, y0, x + 4, y1), 1);
    match i32::try_from(part).expect("a few parts") {
        0 => fill(screen, Rect::new(0, 0, WIDTH.into(), height), 0),
        part => bar(height - height * part / 7, height - height * (part - 1) / 7),
    }
}

/// Sends a row of a frame to a display that keeps it.
fn send(screen: &mut Screen, frame: u32, row: usize) {
    let (y, x) = (i32::try_from(row).expect("a row"), column(frame));
    fill(screen, Rect::new(0, y, WIDTH.into(), y + 1), 0);
    fill(screen, Rect::new(x, y, x + 4, y + 1), 1);
}

fn fill(screen: &mut Screen, area: Rect, index: u8) {
    let mut frame = Framebuffer::<Index4>::new(&mut screen.0, WIDTH, HEIGHT).expect("the right size");
    frame.fill_rectangle(area, Index4::new(index));
}

/// A row as it goes to a display: expanded through the palette.
fn row((pixels, palette): &Screen, y: usize) -> Vec<Rgb888> {
    let bytes = usize::from(WIDTH) / 2;
    let mut line = [0; WIDTH as usize * 2];
    palette.expand::<Index4, Be<Rgb565>>(&pixels[y * bytes..][..bytes], &mut line);
    let color = |pixel: &[u8]| Rgb565::from(RawU16::new(u16::from_be_bytes([pixel[0], pixel[1]])));
    line.chunks_exact(2).map(|pixel| color(pixel).into()).collect()
}

/// Whether rows are of different frames: the bar is not in the same columns everywhere.
fn is_torn(picture: &Picture) -> bool {
    let row = |y: usize| (0..picture.width()).map(|x| picture.color(x, y)).collect::<Vec<_>>();
    (1..picture.height()).any(|y| row(y) != row(0))
}

/// What is seen of a program that draws a frame in that time.
fn seen<const N: usize>(milliseconds: u64, flips: Flips) -> (Vec<Picture>, Played) {
    let mut display = Scanout::new(WIDTH.into(), HEIGHT.into(), 60);
    let draw = |screen: &mut Screen, frame, part| {
        (part < PARTS).then(|| {
            draw(screen, frame, part);
            milliseconds * MILLISECOND / PARTS as u64
        })
    };
    let played = play(&mut display, [(); N].map(|()| screen()), flips, 120, draw, row);
    (display.take(), played)
}

fn torn(pictures: &[Picture]) -> usize {
    pictures.iter().filter(|picture| is_torn(picture)).count()
}

/// Faster than the display, as fast, and slower.
const TIMES: [u64; 7] = [1, 4, 9, 16, 17, 23, 40];

#[test]
fn one_buffer_tears_unless_it_is_drawn_while_nothing_is_shown() {
    for milliseconds in TIMES {
        let count = |flips| torn(&seen::<1>(milliseconds, flips).0);
        assert!(count(Flips::AtOnce) > 20, "{milliseconds} ms, without waiting");
        // A millisecond is about what the display pauses.
        assert_eq!(count(Flips::AtRefresh) > 20, milliseconds > 1, "{milliseconds} ms, from the refresh on");
    }
}

#[test]
fn two_and_three_buffers_do_not() {
    for milliseconds in TIMES {
        for (pictures, _) in [seen::<2>(milliseconds, Flips::AtRefresh), seen::<3>(milliseconds, Flips::AtRefresh)] {
            assert!(pictures.len() >= 120 && torn(&pictures) == 0, "{milliseconds} ms");
        }
    }
}

#[test]
fn a_flip_in_the_middle_of_a_refresh_tears() {
    for milliseconds in TIMES {
        for (pictures, _) in [seen::<2>(milliseconds, Flips::AtOnce), seen::<3>(milliseconds, Flips::AtOnce)] {
            assert!(torn(&pictures) > 20, "{milliseconds} ms: {} of {}", torn(&pictures), pictures.len());
        }
    }
}

#[test]
fn three_buffers_do_not_wait() {
    // A frame that is a bit too late waits for a whole refresh with two buffers, and not with three.
    let ([two, three], both) =
        ([seen::<2>(23, Flips::AtRefresh).1, seen::<3>(23, Flips::AtRefresh).1], 120 * 1000 / 60);
    assert!((59..=61).contains(&two.frames) && two.dropped == 0, "one in two refreshes: {two:?}");
    assert!(three.waited == 0 && three.frames >= both / 23, "as many as it can draw: {three:?}");
    assert!(two.waited > 500 * MILLISECOND, "{two:?}");
    // One that is early is dropped: the newest is shown.
    let early = seen::<3>(4, Flips::AtRefresh).1;
    assert!(early.waited == 0 && early.dropped > 300, "{early:?}");
}

/// The pixels stay, the palette turns: where it is exchanged with its buffer nothing tears, and elsewhere colours do.
#[test]
fn a_palette_is_exchanged_with_its_pixels() {
    let turn = |screen: &mut Screen, frame: u32, part: usize| {
        let level = u8::try_from(frame % 32).expect("five bits");
        screen.1 = Palette::new([Rgb565::new(level, 0, 31 - level); 16]);
        (part == 0).then_some(5 * MILLISECOND)
    };
    let mut display = Scanout::new(WIDTH.into(), HEIGHT.into(), 60);
    play(&mut display, [screen(), screen()], Flips::AtRefresh, 60, turn, row);
    assert_eq!(torn(&display.take()), 0, "both at once");
    play(&mut display, [screen(), screen()], Flips::AtOnce, 60, turn, row);
    assert!(torn(&display.take()) > 20, "both at once, in mid-frame");
    play(&mut display, [screen()], Flips::AtOnce, 60, turn, row);
    assert!(torn(&display.take()) > 20, "the palette of what is shown");
}

/// A display with a memory of its own, which a bus fills row by row. A bus that is faster than the display begins with the refresh, and the
/// rows that are shown stay behind those that are sent. A slower one begins when the first row has been shown: what it sends stays behind,
/// and is not overtaken as long as it takes less than two refreshes.
#[test]
fn sending_follows_the_tearing_effect() {
    let period = 1_000_000_000 / 60;
    let rows = usize::from(HEIGHT);
    for (time, delay, flips, tears) in [
        (period * 3 / 4, 0, Flips::AtRefresh, false),
        (period * 3 / 4, period / 8, Flips::AtRefresh, true),
        (period * 5 / 4, period / 11, Flips::AtRefresh, false),
        (period * 5 / 4, 0, Flips::AtRefresh, true),
        (period * 7 / 4, period / 11, Flips::AtRefresh, false),
        (period * 9 / 4, period / 11, Flips::AtRefresh, true),
        (period * 5 / 4, period / 11, Flips::AtOnce, true),
    ] {
        let mut display = Scanout::new(WIDTH.into(), HEIGHT.into(), 60);
        let send = |screen: &mut Screen, frame, part: usize| match part.checked_sub(1) {
            None => Some(delay),
            Some(row) if row < rows => {
                send(screen, frame, row);
                Some(time / rows as u64)
            }
            Some(_) => None,
        };
        play(&mut display, [screen()], flips, 120, send, row);
        let pictures = display.take();
        // Before the first frame is sent there is none.
        assert_eq!(torn(&pictures[4..]) > 0, tears, "{time} ns a frame after {delay}: {} torn", torn(&pictures));
    }
}
