//! What is shown is what the scenes draw, whole frames where there are buffers enough, and no pixel differs in bands.

#![expect(
    clippy::redundant_closure_for_method_calls,
    reason = "a method of a type with a lifetime is no function for every lifetime"
)]

use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use embedded_raster::{buffer_bytes, surface::Counter, EdgeSlot, Framebuffer, Index4, Index8, Rect};
use playground::{
    choice::{Buffers, Choice, Colors, Dither, Scene, BANDS, DEPTHS},
    crc::crc32,
    player::BYTES,
    Memory, Player,
};
use scene::{page, plasma, scope};

const CHOICE: Choice = Choice {
    scene: Scene::Scope,
    depth: 4,
    colors: Colors::Own,
    dither: Dither::None,
    buffers: Buffers::Two,
    band: 0,
    time: 4,
};

/// Plays for some refreshes.
fn play<T>(choice: Choice, refreshes: u32, look: impl FnOnce(&Player<'_>) -> T) -> T {
    let mut bytes = vec![0; BYTES];
    let mut player = Player::new(Memory::new(&mut bytes).expect("as long as it says"), choice);
    for _ in 0..refreshes {
        player.refresh().expect("enough memory");
    }
    look(&player)
}

/// The first palette that a scene has at a depth.
fn colors(scene: Scene, depth: u8) -> Colors {
    *Colors::ALL.iter().rev().find(|colors| colors.exist(scene, depth)).expect("greys")
}

#[test]
fn too_little_memory_is_seen_at_once() {
    assert!(Memory::new(&mut vec![0; BYTES - 1]).is_none(), "one byte short");
}

/// The memory of a frame of the oscilloscope, drawn as firmwares draw it.
fn oscilloscope(number: u32) -> Vec<u8> {
    let size = [scope::WIDTH, scope::HEIGHT];
    let mut memory = vec![0; buffer_bytes::<Index4>(size[0], size[1])];
    let mut frame = Framebuffer::<Index4>::new(&mut memory, size[0], size[1]).expect("enough");
    scope::grid(&mut frame, size);
    scope::trace(&mut frame, size, &scope::Signals::new(), number);
    memory
}

#[test]
fn inks_are_stored_as_firmwares_store_them() {
    let (number, sum) = play(CHOICE, 3, |player| (player.played().number, player.shown_crc32()));
    assert_eq!(sum, crc32(&oscilloscope(number)), "frame {number} of the oscilloscope");

    let choice = Choice { scene: Scene::Plasma, depth: 8, ..CHOICE };
    let mut memory = vec![0; buffer_bytes::<Index8>(plasma::WIDTH, plasma::HEIGHT)];
    let mut frame = Framebuffer::<Index8>::new(&mut memory, plasma::WIDTH, plasma::HEIGHT).expect("enough");
    plasma::draw(&mut frame, [plasma::WIDTH, plasma::HEIGHT], &plasma::Sines::new());
    let (played, sum) = play(choice, 5, |player| (player.played(), player.shown_crc32()));
    assert_eq!(sum, crc32(&memory), "the plasma");
    assert_eq!(played.painted, 0, "only its palette changes");
}

#[test]
fn pixels_are_counted_as_a_counter_does() {
    let mut counter = Counter::<Index4>::new(Rect::new(0, 0, page::WIDTH.into(), page::HEIGHT.into()));
    page::draw(&mut counter, &mut [EdgeSlot::EMPTY; page::EDGES], Index4::new).expect("slots enough");
    let choice = Choice { scene: Scene::Page, ..CHOICE };
    assert_eq!(u64::from(play(choice, 1, |player| player.played().painted)), counter.pixels, "the page");
}

/// The frame of each number is the same, drawn in parts or in bands of any height.
#[test]
fn bands_are_the_whole() {
    for (scene, depth) in Scene::ALL.into_iter().flat_map(|scene| DEPTHS.map(|depth| (scene, depth))) {
        for dither in [Dither::Bayer4, Dither::FloydSteinberg] {
            let choice = Choice { scene, depth, colors: colors(scene, depth), dither, ..CHOICE };
            // A slow program: its second frame is shown in the fourth refresh.
            let slow = Choice { time: 24, ..choice };
            let whole = play(slow, 4, |player| (player.played().number, player.shown_crc32()));
            for band in BANDS {
                // A band is on the display when it is drawn: after the second refresh all of the second frame is.
                if !(1..scene.size()[1]).contains(&band) {
                    continue;
                }
                let bands = play(Choice { band, ..choice }, 2, |player| (player.played().number, player.shown_crc32()));
                assert_eq!(bands, whole, "{choice:?} in bands of {band} rows");
            }
        }
    }
}

/// One buffer shows frames that are half drawn. With two or three, exchanged at a refresh, what is seen is always one of the whole frames.
#[test]
fn one_buffer_tears_and_two_do_not() {
    let seen = |number| {
        let colors = oscilloscope(number).into_iter().flat_map(|byte| [byte >> 4, byte & 15]);
        let colors = colors.map(|index| scope::PALETTE[usize::from(index)]);
        crc32(&colors.flat_map(|color| [color.r(), color.g(), color.b(), 255]).collect::<Vec<u8>>())
    };
    let whole: Vec<u32> = (1..20).map(seen).collect();
    let torn = |buffers| {
        let choice = Choice { buffers, time: 14, ..CHOICE };
        (3..12).filter(|&refreshes| !whole.contains(&play(choice, refreshes, |player| player.seen_crc32()))).count()
    };
    assert!(torn(Buffers::One) > 6, "one");
    assert!(torn(Buffers::TwoAtOnce) > 6, "two, exchanged at once");
    assert_eq!([torn(Buffers::Two), torn(Buffers::Three)], [0, 0], "exchanged at a refresh");
}

#[test]
fn memory_is_what_a_chip_needs() {
    let ram = |choice| play(choice, 0, |player| player.ram());
    let cube = Choice { scene: Scene::Cube, depth: 16, ..CHOICE };
    let whole = ram(cube);
    assert_eq!((whole.frames, whole.depths), (2 * buffer_bytes::<Rgb565>(160, 128), 160 * 128 * 2), "whole");
    let band = ram(Choice { band: 16, buffers: Buffers::One, ..cube });
    assert_eq!((band.frames, band.depths, band.palette), (160 * 16 * 2, 160 * 16 * 2, 0), "a band");
    let diffused = ram(Choice { depth: 4, colors: Colors::Ega, dither: Dither::FloydSteinberg, band: 16, ..cube });
    assert_eq!((diffused.dither, diffused.palette), (160 * 16 * 3 + 160 * 6, 32), "rows in 24 bits, and a palette");
}
