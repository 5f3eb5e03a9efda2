//! Work, counted: what a line costs that lies above or below a band, and one that lies in it.

use std::{string::String, vec};

use embedded_graphics_core::pixelcolor::Gray8;

use super::{style::Style, Font, Horizontal};
use crate::{
    num::tally::{self, Work},
    surface::Framebuffer,
};

/// Cells of 4 x 4; all characters look the same.
const BYTES: [u8; 31] = *b"erf1\x04\x03\x04\0\0\x03\x03\0\x01\0\0\0\x01\0\0\0x\0\0\0\x01\0\0\0\xa0\x40\xa0";

/// Lines that were compared, and characters that were looked up, for 200 lines of 30 on a band of 120 columns.
fn steps(horizontal: Horizontal, rows: core::ops::Range<u16>) -> usize {
    let font = Font::read(&BYTES).expect("a font");
    let mut text = String::new();
    for _ in 0..200 {
        text.push_str("abcdefghijklmnopqrstuvwxyz1234\n");
    }
    let style = Style::new(&font, Gray8::new(9)).horizontal(horizontal).line_height(5);
    let mut ram = vec![0; 120 * rows.len()];
    let mut band = Framebuffer::<Gray8>::band(&mut ram, 120, 2_000, rows).expect("the right size");
    tally::of(|| style.draw(&mut band, (if horizontal == Horizontal::Left { 0 } else { 60 }, 2), &text))
        [Work::Step as usize]
}

/// Line `n` has the rows from `5 n` to `5 n + 3`.
#[test]
fn a_line_that_does_not_meet_a_band_costs_one_comparison() {
    // Ten lines above, two in the band, and the comparison that ends the text.
    assert_eq!(steps(Horizontal::Left, 50..60), 10 + 2 * (1 + 30) + 1, "two lines");
    // A row between two lines.
    assert_eq!(steps(Horizontal::Left, 54..55), 11 + 1, "no line");
    assert_eq!(steps(Horizontal::Left, 1_900..1_910), 201, "below all lines, of which the last is empty");
    // Where lines have to be measured, those that are seen are.
    assert_eq!(steps(Horizontal::Center, 50..60), 10 + 2 * (1 + 60) + 1, "two lines in the middle");
}

/// What lies on the right of the window is not looked up, but for letters that may lean back into it.
#[test]
fn characters_on_the_right_are_not_looked_up() {
    let font = Font::read(&BYTES).expect("a font");
    let text: String = core::iter::repeat_n('x', 100_000).collect();
    let style = Style::new(&font, Gray8::new(9));
    let mut ram = vec![0; 120 * 4];
    let mut frame = Framebuffer::<Gray8>::new(&mut ram, 120, 4).expect("the right size");
    let steps = tally::of(|| style.draw(&mut frame, (0, 3), &text))[Work::Step as usize];
    assert_eq!(steps, 1 + (120 + 128) / 4);
}
