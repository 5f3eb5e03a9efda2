//! A page of text: every glyph of both fonts, transparent and opaque; every alignment; tabs, and characters that a font lacks.

use embedded_raster::{
    buffer_bytes,
    text::{Font, Horizontal, Style, Vertical, FONT_6X10, FONT_8X13},
    Canvas, Framebuffer, Rect, Surface,
};

use super::{compare, Ink, GREEN, GREY, GROUND, RED, YELLOW};

const WIDTH: u16 = 264;
const HEIGHT: u16 = 236;

/// All characters of a font, sixteen to a line.
fn alphabet() -> String {
    let all: Vec<char> = (' '..='~').chain(['°', '±', 'µ', '×']).collect();
    let lines: Vec<String> = all.chunks(16).map(|line| line.iter().collect()).collect();
    lines.join("\n")
}

/// Both fonts, left transparent and right opaque.
fn glyphs<C: Ink>(on: &mut impl Surface<Color = C>) {
    let fonts: [(&Font<'_>, i32); 2] = [(&FONT_6X10, 0), (&FONT_8X13, 71)];
    for (font, y) in fonts {
        let style = Style::new(font, C::ega(YELLOW)).vertical(Vertical::Top);
        style.draw(on, (0, y), &alphabet());
        style.color(C::ega(GROUND)).opaque(C::ega(GREY)).draw(on, (133, y), &alphabet());
    }
}

/// Two lines of which each is aligned, and the block too; the point that they are drawn at is marked.
fn alignments<C: Ink>(on: &mut impl Surface<Color = C>) {
    let columns = [(3, Horizontal::Left), (66, Horizontal::Center), (126, Horizontal::Right)];
    let rows = [(168, Vertical::Top), (192, Vertical::Middle), (209, Vertical::Baseline), (233, Vertical::Bottom)];
    for (x, horizontal) in columns {
        for (y, vertical) in rows {
            let style = Style::new(&FONT_6X10, C::ega(GREEN)).horizontal(horizontal).vertical(vertical).line_height(8);
            let text = if vertical == Vertical::Baseline { "gauge" } else { "top\nlower" };
            style.draw(on, (x, y), text);
            on.fill_rectangle(Rect::new(x - 2, y, x + 3, y + 1), C::ega(RED));
            on.fill_rectangle(Rect::new(x, y - 2, x + 1, y + 3), C::ega(RED));
        }
    }
}

/// Columns by tabs, with a ground and without; a carriage return; characters of two, three and four bytes.
fn tabs<C: Ink>(on: &mut impl Surface<Color = C>) {
    let plain = Style::new(&FONT_6X10, C::ega(YELLOW)).vertical(Vertical::Top).tab(40);
    plain.draw(on, (133, 164), "a\tbc\tdef\r\n\tghij\t|");
    let ground = plain.color(C::ega(GROUND)).opaque(C::ega(GREEN));
    ground.draw(on, (133, 186), "a\tbc\tdef\n\tghij\t|");
    plain.draw(on, (133, 208), "5±2 µm × 3°: é€😀\u{fffd}");
    ground.draw(on, (133, 220), "over the right side of the page");
}

fn check<C: Ink>(depth: &str) {
    let mut ram = vec![0; buffer_bytes::<C>(WIDTH, HEIGHT)];
    let mut frame = Framebuffer::<C>::new(&mut ram, WIDTH, HEIGHT).expect("it has the bytes that it needs");
    frame.fill_window(C::ega(GROUND));
    glyphs(&mut frame);
    alignments(&mut frame);
    tabs(&mut frame);
    assert_eq!(compare(&format!("letters-{depth}"), &C::picture(&frame)), None, "at {depth} bits");
}

#[test]
fn one_bit() {
    check::<embedded_raster::Index1>("1");
}

#[test]
fn four_bits() {
    check::<embedded_raster::Index4>("4");
}

#[test]
fn sixteen_bits() {
    check::<embedded_graphics::pixelcolor::Rgb565>("16");
}
