//! Plain functions for a page, over one player in static memory. A page calls them from one thread.
//!
//! Numbers and memory are all that passes: what is chosen goes in as the numbers of names, pictures are read from memory. Functions that can
//! be asked for what is not there answer 0.
#![no_std]

use core::cell::UnsafeCell;

use playground::{chips, player, Choice, Memory, Player};

/// Memory of the page's one thread.
struct Room<T>(UnsafeCell<T>);

// SAFETY: a page has one thread, and what it is called from is not called by what it calls.
unsafe impl<T> Sync for Room<T> {}

/// The player's, as soon as there is one. Apart from what is not zero at first, so that it takes no place in the file.
static MEMORY: Room<[u8; player::BYTES]> = Room(UnsafeCell::new([0; player::BYTES]));
static PLAYER: Room<Option<Player<'static>>> = Room(UnsafeCell::new(None));
/// What the frames of the firmwares are drawn on, and their checksums.
static CHIPS: Room<([u8; chips::BYTES], [u32; 64])> = Room(UnsafeCell::new(([0; chips::BYTES], [0; 64])));

/// The player, if something has been chosen.
fn player() -> Option<&'static mut Player<'static>> {
    // SAFETY: no function of this file keeps it beyond its end.
    unsafe { (*PLAYER.0.get()).as_mut() }
}

/// What is called `name` among the names of a kind, from 1 on; the name of the kind itself for 0. Empty if there is no such name.
fn name(kind: usize, number: usize) -> &'static str {
    let Some((kind, names)) = Choice::NAMES.get(kind) else { return "" };
    match number.checked_sub(1) {
        None => kind,
        Some(number) => names.get(number).copied().unwrap_or(""),
    }
}

/// Where a name is, in UTF-8.
#[no_mangle]
pub extern "C" fn name_at(kind: usize, number: usize) -> *const u8 {
    name(kind, number).as_ptr()
}

/// Bytes of a name; 0 if there is none.
#[no_mangle]
pub extern "C" fn name_len(kind: usize, number: usize) -> usize {
    name(kind, number).len()
}

/// Whether there is such a choice.
#[no_mangle]
pub extern "C" fn exists(
    scene: usize,
    depth: usize,
    colors: usize,
    dither: usize,
    buffers: usize,
    band: usize,
    time: usize,
) -> bool {
    Choice::from_numbers([scene, depth, colors, dither, buffers, band, time]).is_some()
}

/// Begins anew with a choice. Whether there is such a choice; if not, nothing is changed.
#[no_mangle]
pub extern "C" fn choose(
    scene: usize,
    depth: usize,
    colors: usize,
    dither: usize,
    buffers: usize,
    band: usize,
    time: usize,
) -> bool {
    let Some(choice) = Choice::from_numbers([scene, depth, colors, dither, buffers, band, time]) else { return false };
    if let Some(player) = player() {
        player.choose(choice);
        return true;
    }
    // SAFETY: there is no player yet, who would have the memory.
    let (memory, place) = unsafe { (&mut *MEMORY.0.get(), &mut *PLAYER.0.get()) };
    *place = Memory::new(memory).map(|memory| Player::new(memory, choice));
    place.is_some()
}

/// The display is refreshed once. Whether nothing went wrong.
#[no_mangle]
pub extern "C" fn refresh() -> bool {
    player().is_some_and(|player| player.refresh().is_ok())
}

/// Draws a frame where nobody looks. Whether nothing went wrong.
#[no_mangle]
pub extern "C" fn draw() -> bool {
    player().is_some_and(|player| player.draw().is_ok())
}

/// Columns of the display.
#[no_mangle]
pub extern "C" fn width() -> u32 {
    player().map_or(0, |player| player.size()[0].into())
}

/// Rows of the display.
#[no_mangle]
pub extern "C" fn height() -> u32 {
    player().map_or(0, |player| player.size()[1].into())
}

/// Where what was seen is: red, green, blue and 255 of each pixel, row by row.
#[no_mangle]
pub extern "C" fn seen() -> *const u8 {
    player().map_or(core::ptr::null(), |player| player.seen().as_ptr())
}

/// The checksum of what was seen.
#[no_mangle]
pub extern "C" fn seen_crc32() -> u32 {
    player().map_or(0, |player| player.seen_crc32())
}

/// The checksum of the memory that the display reads.
#[no_mangle]
pub extern "C" fn shown_crc32() -> u32 {
    player().map_or(0, |player| player.shown_crc32())
}

/// A number that tells what the program did, or a number of bytes: in the order below.
#[no_mangle]
pub extern "C" fn fact(number: usize) -> u32 {
    let Some(player) = player() else { return 0 };
    let (played, ram) = (player.played(), player.ram());
    let ram = [ram.frames, ram.depths, ram.tables, ram.dither, ram.palette].map(|bytes| bytes as u32);
    let played = [played.refreshes, played.frames, played.shown, played.waited, played.painted];
    played.into_iter().chain(ram).nth(number).unwrap_or(0)
}

/// Draws the frames of the firmwares. How many there are; 0 if something went wrong.
#[no_mangle]
pub extern "C" fn chip_frames() -> usize {
    // SAFETY: nobody else has it.
    let (memory, sums) = unsafe { &mut *CHIPS.0.get() };
    let mut count = 0;
    let drawn = chips::draw(memory, |_, _, sum| {
        if let Some(place) = sums.get_mut(count) {
            *place = sum;
            count += 1;
        }
    });
    if drawn.is_ok() {
        count
    } else {
        0
    }
}

/// The checksum of one of them.
#[no_mangle]
pub extern "C" fn chip_crc32(number: usize) -> u32 {
    // SAFETY: nobody changes it meanwhile.
    let (_, sums) = unsafe { &*CHIPS.0.get() };
    sums.get(number).copied().unwrap_or(0)
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
