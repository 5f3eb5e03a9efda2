//! Plays some choices of the playground and prints, for each, what links of the page call it, the checksum of the memory that the display
//! reads, and that of what is seen. The page in the browser and the host print the same.
#![no_std]
#![no_main]

use core::cell::UnsafeCell;

use board::{crc32, exit, println};
use playground::{player::BYTES, Choice, Memory, Player};

/// Refreshes until the checksums are taken.
const REFRESHES: u32 = 3;

/// The memory of the player: more than a chip has, as the display is in it.
struct Static(UnsafeCell<[u8; BYTES]>);

// SAFETY: this program has one thread.
unsafe impl Sync for Static {}

static MEMORY: Static = Static(UnsafeCell::new([0; BYTES]));

board::entry!(main);

fn main() {
    // SAFETY: the only reference.
    let bytes = unsafe { &mut *MEMORY.0.get() };
    for numbers in Choice::on_chips() {
        let (Some(choice), Some(memory)) = (Choice::from_numbers(numbers), Memory::new(bytes)) else { exit(1) };
        let mut player = Player::new(memory, choice);
        for _ in 0..REFRESHES {
            if player.refresh().is_err() {
                exit(1);
            }
        }
        let names: [&str; 7] = core::array::from_fn(|kind| Choice::NAMES[kind].1[numbers[kind]]);
        let [scene, depth, colors, dither, buffers, band, time] = names;
        println!(
            "scene={scene}&depth={depth}&colors={colors}&dither={dither}&buffers={buffers}&band={band}&time={time}\
             &refresh={REFRESHES};{:08x};{:08x}",
            player.shown_crc32(),
            crc32(player.seen())
        );
    }
}
