//! Plays on this computer what the page in the browser plays, and prints for each choice what links call it, the checksum of the memory that the
//! display reads, and that of what is seen. `cargo xtask playground --check` compares them with the browser.
//!
//! Links may be given as arguments. Without them, it plays the choices that are checked.

use std::error::Error;

use playground::{player::BYTES, Choice, Memory, Player};

/// Refreshes until the checksums are taken: some frames have been drawn, and another one has been begun.
const REFRESHES: u32 = 4;

fn main() -> Result<(), Box<dyn Error>> {
    let mut bytes = vec![0; BYTES];
    let links: Vec<String> = std::env::args().skip(1).collect();
    if links.is_empty() {
        return Choice::checked().try_for_each(|numbers| play(&mut bytes, numbers, REFRESHES));
    }
    links.iter().try_for_each(|link| {
        let (numbers, refreshes) = read(link).ok_or_else(|| format!("not a link of the page: {link}"))?;
        play(&mut bytes, numbers, refreshes)
    })
}

/// The numbers of the names in a link, and the number of refreshes.
fn read(link: &str) -> Option<([usize; 7], u32)> {
    let value = |wanted: &str| link.split('&').find_map(|part| part.strip_prefix(wanted)?.strip_prefix('='));
    let mut numbers = [0; 7];
    for ((kind, names), number) in Choice::NAMES.iter().zip(&mut numbers) {
        *number = names.iter().position(|name| Some(*name) == value(kind))?;
    }
    Some((numbers, value("refresh")?.parse().ok()?))
}

fn play(bytes: &mut [u8], numbers: [usize; 7], refreshes: u32) -> Result<(), Box<dyn Error>> {
    let choice = Choice::from_numbers(numbers).ok_or("there is no such choice")?;
    let mut player = Player::new(Memory::new(bytes).ok_or("too little memory")?, choice);
    for _ in 0..refreshes {
        player.refresh()?;
    }
    for ((kind, names), number) in Choice::NAMES.iter().zip(numbers) {
        print!("{kind}={}&", names[number]);
    }
    println!("refresh={refreshes};{:08x};{:08x}", player.shown_crc32(), player.seen_crc32());
    Ok(())
}
