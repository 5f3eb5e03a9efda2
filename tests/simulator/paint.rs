//! The paint program: its demonstration against pictures in `tests/golden`, scripts that are wrong, steps back and forth, and
//! what keys and mouse are. `BLESS=1 cargo test --test simulator` writes the pictures anew.

use std::path::Path;

use crate::pictures::compare;
use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
use embedded_raster::{pixel::EGA, EdgeTableFull};
use embedded_raster_simulator::{
    paint::{parse, replay, Command, Desk, Done, Failure, Paint, FORMS},
    Event, Key, Picture,
};

const DEMO: &str = include_str!("../../assets/paint-demo.txt");

fn paint(bits: u8) -> Paint {
    Paint::new((320, 240), bits)
}

/// A paint program after a script of a small picture.
fn after(bits: u8, script: &str) -> Paint {
    let mut paint = Paint::new((33, 20), bits);
    replay(script, &mut paint).unwrap_or_else(|error| panic!("{script}: {error}"));
    paint
}

/// The demonstration without the palette entries that a depth does not have, and with its colors cut to the depth.
fn demo(bits: u8) -> String {
    let number = |line: &str, name: &str| line.strip_prefix(name)?.split(' ').next()?.parse::<u32>().ok();
    let is_there = |line: &&str| number(line, "palette ").is_none_or(|index| index < 1 << bits);
    let cut = |line: &str| match number(line, "color ") {
        Some(index) => format!("color {}\n", index & ((1 << bits) - 1)),
        None => format!("{line}\n"),
    };
    DEMO.lines().filter(is_there).map(cut).collect()
}

#[test]
fn the_demonstration_at_every_depth() {
    let wrong: Vec<_> = [1, 2, 4, 8]
        .into_iter()
        .filter_map(|bits| {
            let (mut paint, demo) = (paint(bits), demo(bits));
            let summary = replay(&demo, &mut paint).expect("it can be carried out");
            assert_eq!(summary.commands, parse(&demo).expect("a script").len(), "commands at {bits} bits");
            assert!((1..=64).contains(&summary.slots), "{} slots at {bits} bits", summary.slots);
            compare(&format!("paint-{bits}"), &paint.picture())
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Where depths have all colours that a script uses, they have the same indices.
#[test]
fn the_same_script_is_the_same_picture() {
    let script =
        "color 1\nellipse 2 2 17 12\nfill 9 9\ncolor 0\nfilled\npolygon 5 4 14 5 9 11\ncolor 1\npencil -4 19 20 9 \
                  28 14 40 -3\nrectangle 20 15 31 18\noutline\nrectangle 1 1 30 17\nline 32 0 0 25\nfill 25 3\n";
    let indices = |bits| {
        let picture = after(bits, script).picture();
        (0..20).flat_map(|y| (0..33).map(move |x| (x, y))).map(|(x, y)| picture.index(x, y)).collect::<Vec<_>>()
    };
    let expected = indices(1);
    let painted = expected.iter().filter(|&&index| index == Some(1)).count();
    assert!((100..600).contains(&painted), "{painted} pixels");
    for bits in [2, 4, 8] {
        assert!(indices(bits) == expected, "{bits} bits");
    }
}

#[test]
fn every_step_back_and_forth() {
    for bits in [1, 2, 4, 8] {
        let mut paint = paint(bits);
        let mut sheets = vec![paint.sheet().clone()];
        for (_, command) in parse(&demo(bits)).expect("a script") {
            if !matches!(command, Command::Undo | Command::Palette(..)) {
                paint.apply(&command).expect("it can be carried out");
            }
            if paint.sheet() != sheets.last().expect("the first one") {
                sheets.push(paint.sheet().clone());
            }
        }
        assert!(sheets.len() > 40, "{} steps at {bits} bits", sheets.len());
        let steps = 32;
        for expected in sheets.iter().rev().skip(1).take(steps) {
            let done = paint.apply(&Command::Undo).expect("there is a step");
            assert!(paint.sheet() == expected && done.pixels > 0, "back at {bits} bits");
        }
        assert_eq!(paint.apply(&Command::Undo), Err(Failure::NoStep("undo")), "the last step is {steps} back");
        for expected in &sheets[sheets.len() - steps..] {
            paint.apply(&Command::Redo).expect("there is a step");
            assert!(paint.sheet() == expected, "forth at {bits} bits");
        }
        assert_eq!(paint.apply(&Command::Redo), Err(Failure::NoStep("redo")), "the end");
    }
}

#[test]
fn steps_are_what_changes_the_sheet() {
    let mut paint =
        after(4, "palette 3 0 0 17\npalette 3 0 0 34\npalette 3 0 0 51\ncycle 5\ncolor 3\nfill 9 9\nfill 9 9\n");
    let blue = |paint: &Paint| paint.sheet().palette.get(3).map(|c| c.b());
    paint.apply(&Command::Undo).expect("the first fill; the second one changed nothing");
    assert_eq!((paint.sheet().ram.iter().max(), blue(&paint)), (Some(&0), Some(51)), "colours stay");
    paint.apply(&Command::Undo).expect("all changes of entry 3");
    assert_eq!(blue(&paint), Some(EGA.colors()[3].b()), "as it was");
    assert_eq!(paint.apply(&Command::Undo), Err(Failure::NoStep("undo")), "cycling is no step");
    paint.apply(&Command::Line([Point::new(1, 1), Point::new(5, 5)])).expect("lines cannot fail");
    assert_eq!(paint.apply(&Command::Redo), Err(Failure::NoStep("redo")), "after something new");
    // A new size and a new depth are steps, too.
    for command in [Command::Size(7, 5), Command::Bits(1), Command::Clear] {
        let before = paint.sheet().clone();
        paint.apply(&command).expect("it cannot fail");
        assert!(paint.sheet() != &before, "{command:?} changes the sheet");
        paint.apply(&Command::Undo).expect("a step");
        assert!(paint.sheet() == &before, "{command:?} can be undone");
        paint.apply(&Command::Redo).expect("a step");
    }
}

#[test]
fn colors_cycle_without_a_pixel() {
    let mut paint = after(4, "range 2 4\ncycle 1\n");
    let shown = |paint: &Paint| [1, 2, 3, 4, 5].map(|i| paint.shown_palette().get(i));
    let ega = |indices: [u8; 5]| indices.map(|i| EGA.get(i));
    assert_eq!(shown(&paint), ega([1, 4, 2, 3, 5]), "one up");
    paint.apply(&Command::Cycle(-3)).expect("it cannot fail");
    assert_eq!(shown(&paint), ega([1, 4, 2, 3, 5]), "once around");
    paint.apply(&Command::Cycle(i32::MAX)).expect("it cannot fail");
    paint.apply(&Command::Palette(1, EGA.colors()[1])).expect("it cannot fail");
    assert_eq!(shown(&paint), ega([1, 2, 3, 4, 5]), "back");
    assert!(paint.sheet() == after(4, "").sheet(), "not a byte");
    // Of a range beyond the depth, nothing cycles.
    assert_eq!(after(2, "range 9 12\ncycle 1").shown_palette(), after(2, "").shown_palette(), "no entry");
}

#[test]
fn wrong_lines_say_what_was_expected() {
    let cases = [
        ("lime 1 2", "no command `lime`; expected one of size, bits, clear, color,"),
        ("size 320", "1 numbers instead of 2; expected `size WIDTH HEIGHT`"),
        ("size 0 240", "0 is not in 1 to 1024; expected `size WIDTH HEIGHT`"),
        ("size 1025 240", "1025 is not in 1 to 1024; expected"),
        ("bits 3", "there are no 3 bits; expected `bits 1|2|4|8`"),
        ("bits 16", "16 is not in 1 to 8; expected `bits 1|2|4|8`"),
        ("clear 3", "1 numbers instead of 0; expected `clear`"),
        ("color", "0 numbers instead of 1; expected `color INDEX`"),
        ("color 256", "256 is not in 0 to 255; expected `color INDEX`"),
        (
            "color 99999999999999999999999999999999999999999999",
            "99999999999999999999999999999999999999999999 is not in 0 to",
        ),
        ("color 1e2", "`1e2` is no whole number; expected `color INDEX`"),
        ("color -", "`-` is no whole number; expected `color INDEX`"),
        ("color -1", "-1 is not in 0 to 255; expected `color INDEX`"),
        ("filled yes", "`yes` is no whole number; expected `filled`"),
        ("outline 1", "1 numbers instead of 0; expected `outline`"),
        ("pencil", "0 numbers instead of at least 1 pairs; expected `pencil X Y [X Y ...]`"),
        ("pencil 1 2 3", "3 numbers instead of at least 1 pairs; expected"),
        ("line 1 2 3 4.5", "`4.5` is no whole number; expected `line X Y X Y`"),
        ("line 1 2 3", "3 numbers instead of 4; expected `line X Y X Y`"),
        ("line 1 2 3 2147483648", "2147483648 is not in -2147483648 to 2147483647; expected `line X Y X Y`"),
        ("ellipse 1 2 3 4 5", "5 numbers instead of 4; expected `ellipse X Y X Y`"),
        ("rectangle 1,2 3,4", "`1,2` is no whole number; expected `rectangle X Y X Y`"),
        ("polygon 1 2 3 4", "4 numbers instead of at least 3 pairs; expected `polygon X Y X Y X Y [X Y ...]`"),
        ("fill 1", "1 numbers instead of 2; expected `fill X Y`"),
        ("palette 1 2 3 256", "256 is not in 0 to 255; expected `palette INDEX R G B`"),
        ("range 5 4", "5 comes after 4; expected `range FIRST LAST`"),
        ("cycle", "0 numbers instead of 1; expected `cycle STEPS`"),
        ("scratch 1 1025", "1025 is not in 0 to 1024; expected `scratch SLOTS EDGES`"),
        ("undo 2", "1 numbers instead of 0; expected `undo`"),
        ("redo all", "`all` is no whole number; expected `redo`"),
        ("save # nothing", "the name of the file is missing; expected `save FILE`"),
    ];
    let untouched = paint(4);
    for (text, expected) in cases {
        let mut paint = paint(4);
        let script = format!("# a script\n\nfill 1 1\n{text}\nfill 5 5\n");
        let error = replay(&script, &mut paint).expect_err(text);
        assert!(error.line == 4 && error.problem.starts_with(expected), "{text}: {error}");
        assert!(paint.sheet() == untouched.sheet(), "nothing is done: {text}");
    }
    for name in FORMS.iter().filter_map(|form| form.split(' ').next()) {
        assert!(cases.iter().any(|(text, _)| text.starts_with(name)), "{name} has a case");
    }
}

#[test]
fn palettes_have_as_many_entries_as_the_depth_has_colors() {
    for bits in [1, 2, 4] {
        let (last, beyond) = ((1 << bits) - 1, 1 << bits);
        let mut paint = after(bits, &format!("palette {last} 1 2 3\n"));
        let before = paint.sheet().clone();
        for index in [beyond, 99, u8::MAX] {
            let error = replay(&format!("\npalette {index} 0 0 0\n"), &mut paint).expect_err("no such entry");
            let expected = format!("line 2: there is no entry {index} among the {beyond} of the palette");
            assert_eq!(error.to_string(), expected);
            assert!(paint.sheet() == &before, "nothing is done");
        }
    }
    after(8, "palette 255 1 2 3\n");
}

#[test]
fn colors_that_a_depth_does_not_have_are_errors() {
    for bits in [1, 2, 4] {
        let last = (1_u8 << bits) - 1;
        let mut paint = after(bits, &format!("color {last}\n"));
        for index in [last + 1, 200, u8::MAX] {
            let error = replay(&format!("clear\n\ncolor {index}\nclear\n"), &mut paint).expect_err("no such color");
            let plural = if bits == 1 { "" } else { "s" };
            let expected = format!("line 3: color {index} is not in 0 to {last}, the colors of {bits} bit{plural}");
            assert_eq!(error.to_string(), expected);
            assert_eq!(paint.color, last, "the color that was chosen");
        }
        assert_eq!(after(bits, &format!("color {last}\nclear\n")).picture().index(5, 5), Some(last), "the last one");
    }
    assert_eq!(after(8, "color 200\nclear\n").picture().index(5, 5), Some(200), "8 bits have them all");
    // What was chosen at another depth is cut to the bits of the sheet.
    assert_eq!(after(8, "color 200\nbits 4\nclear\n").picture().index(5, 5), Some(8), "200 = 12 * 16 + 8");
}

#[test]
fn a_command_that_fails_leaves_the_picture() {
    let mut paint = after(4, "filled\nscratch 8 4\nellipse 3 3 20 15\n");
    let before = paint.sheet().clone();
    let comb = Command::Polygon((0..6).map(|i| Point::new(4 * i, 2 + 15 * (i % 2))).collect());
    let failure = paint.apply(&comb).expect_err("the table holds four");
    assert_eq!(
        failure,
        Failure::Draw(EdgeTableFull { capacity: 4, needed: 6, row: 2, enough: 6 }.into()),
        "the numbers"
    );
    let words = "edge table full: 6 edges cross row 2, the table holds 4, 6 are enough for all rows";
    assert_eq!(failure.to_string(), words, "in words");
    assert!(paint.sheet() == &before, "the picture");
    let script = "color 3\npolygon 0 2 4 17 8 2 12 17 16 2 20 17";
    let error = replay(script, &mut paint).expect_err("the table holds four");
    assert_eq!(error.to_string(), format!("line 2: {words}"), "in a script");
    assert!(paint.sheet() == &before, "the picture, still");
    paint.apply(&Command::Scratch(8, 6)).expect("it cannot fail");
    paint.apply(&comb).expect("six are enough");
}

#[test]
fn flood_fills_say_what_they_need() {
    let comb = "pencil 3 3 3 16 6 16 6 3 9 3 9 16 12 16 12 3 15 3 15 16 18 16 18 3 21 3 21 16\ncolor 5\n";
    let fill = Command::Fill(Point::zero());
    let mut all = after(4, comb);
    let done = all.apply(&fill).expect("fills cannot fail");
    let Done { pixels, slots: Some((needed, 64)) } = done else { panic!("{done:?}") };
    assert_eq!(done.to_string(), format!("{pixels} px, {needed} of 64 slots"), "in words");
    assert!(needed > 1, "{needed} slots");
    for slots in 0..=needed {
        let mut few = after(4, comb);
        few.apply(&Command::Scratch(slots, 0)).expect("it cannot fail");
        let done = few.apply(&fill).expect("fills cannot fail");
        assert_eq!(done, Done { pixels, slots: Some((needed, slots)) }, "{slots} slots");
        assert!(few.sheet() == all.sheet(), "the same pixels with {slots} slots");
        assert_eq!(done.to_string().contains("slower"), slots < needed, "{done}");
    }
}

#[test]
fn files_have_the_palette_that_is_shown() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("saved paint.png");
    let script = format!("ellipse 2 2 20 15\nrange 14 15\ncycle 1\nsave {}\n", path.display());
    let paint = after(4, &script);
    let saved = Picture::read_png(&path).expect("a file");
    assert_eq!(saved, paint.picture(), "what is shown");
    assert_eq!(saved.color(2, 8), EGA.get(14), "the colour of index 15");
    let nowhere = "/no/such/folder/x.png".to_string();
    let failure = paint_error(paint, &Command::Save(nowhere.clone()));
    assert!(failure.starts_with(&nowhere), "{failure}");
}

fn paint_error(mut paint: Paint, command: &Command) -> String {
    paint.apply(command).expect_err("it fails").to_string()
}

/// A point of the sheet as one of the window.
fn at(x: i32, y: i32) -> Point {
    Point::new(x, y + 24)
}

fn key(key: Key) -> Event {
    Event::Key(key, false)
}

/// The commands that events are, carried out one after the other.
fn commands(desk: &mut Desk, events: &[Event]) -> Vec<Command> {
    let all = events.iter().filter_map(|&event| {
        let command = desk.command(event)?;
        desk.apply(&command);
        Some(command)
    });
    all.collect()
}

#[test]
fn drags_and_clicks_are_commands() {
    let mut desk = Desk::new(paint(4), "x.png");
    let [a, b, c] = [(10, 20), (60, 70), (30, 90)].map(Point::from);
    let on = |p: Point| at(p.x, p.y);
    let drag = [Event::Press(on(a)), Event::Move(on(c)), Event::Move(on(b)), Event::Release(on(b))];
    assert_eq!(commands(&mut desk, &drag), [Command::Pencil(vec![a, a, c, b])], "a pencil");
    let tools = [
        (Key::Key2, Command::Line([a, b])),
        (Key::Key3, Command::Ellipse([a, b])),
        (Key::Key4, Command::Rectangle([a, b])),
    ];
    for (tool, expected) in tools {
        assert_eq!(commands(&mut desk, &[key(tool)]), [], "a tool is none");
        assert_eq!(commands(&mut desk, &drag), [expected], "the last place counts");
    }
    let outside = [Event::Press(on(a)), Event::Release(Point::new(-5, 999))];
    assert_eq!(commands(&mut desk, &outside), [Command::Rectangle([a, Point::new(-5, 975)])], "beyond the sheet");
    let dropped = [Event::Press(on(a)), Event::Move(on(b)), key(Key::Backspace), Event::Release(on(b))];
    assert_eq!(commands(&mut desk, &dropped), [], "dropped");
    let fill = [key(Key::Key6), Event::Press(on(a)), Event::Move(on(b)), Event::Release(on(b))];
    assert_eq!(commands(&mut desk, &fill), [Command::Fill(a)], "a click");
}

#[test]
fn polygons_are_closed() {
    let mut desk = Desk::new(paint(4), "x.png");
    let corners = [(10, 20), (60, 70), (30, 90)].map(Point::from);
    let clicks = corners.map(|p| [Event::Move(at(p.x, p.y)), Event::Press(at(p.x, p.y)), Event::Release(at(p.x, p.y))]);
    for close in [Event::Menu(at(99, 99)), key(Key::Enter)] {
        let mut events = vec![key(Key::Key5)];
        events.extend(clicks.concat());
        events.extend([Event::Move(at(99, 99)), close]);
        assert_eq!(commands(&mut desk, &events), [Command::Polygon(corners.to_vec())], "three clicks");
    }
    let two = [&clicks[..2].concat()[..], &[key(Key::Enter)]].concat();
    assert_eq!(commands(&mut desk, &two), [], "two corners");
    let third = [Event::Press(at(30, 90)), key(Key::Enter)];
    assert_eq!(commands(&mut desk, &third), [Command::Polygon(corners.to_vec())], "the two were kept");
    assert_eq!(commands(&mut desk, &[key(Key::Key1), Event::Menu(at(9, 9))]), [], "no polygon to close");
}

#[test]
fn keys_buttons_and_swatches_are_commands() {
    let file = concat!(env!("CARGO_TARGET_TMPDIR"), "/pressed.png");
    let mut desk = Desk::new(paint(4), file);
    let pressed = |desk: &mut Desk, k| commands(desk, &[key(k)]);
    assert_eq!(pressed(&mut desk, Key::O), [Command::Filled(true)], "filled");
    assert_eq!(pressed(&mut desk, Key::O), [Command::Filled(false)], "and not");
    assert_eq!(pressed(&mut desk, Key::S), [Command::Save(file.into())], "save");
    let events = [key(Key::U), key(Key::Y), key(Key::N), key(Key::Right), key(Key::Left)];
    let expected = [Command::Undo, Command::Redo, Command::Clear, Command::Color(0), Command::Color(15)];
    assert_eq!(commands(&mut desk, &events), expected, "one each");
    // The second row of buttons, and the palette below the sheet: 20 pixels for each of 16 colours.
    let click = |x, y| Event::Press(Point::new(x, y));
    assert_eq!(commands(&mut desk, &[click(60, 14)]), [Command::Undo], "a button");
    assert_eq!(commands(&mut desk, &[click(4 * 20, 24 + 240)]), [Command::Color(4)], "a swatch");
    assert_eq!(commands(&mut desk, &[click(5, 24 + 240 + 16)]), [], "the status");
    let edits = [Event::Key(Key::R, false), Event::Key(Key::B, false), Event::Key(Key::R, true)];
    let red = |r, b| Command::Palette(4, Rgb888::new(r, 0, b));
    assert_eq!(commands(&mut desk, &edits), [red(187, 0), red(187, 17), red(170, 17)], "the palette editor");
    let range = [key(Key::LeftBracket), click(9 * 20, 24 + 240), key(Key::RightBracket)];
    assert_eq!(commands(&mut desk, &range), [Command::Range(4, 255), Command::Color(9), Command::Range(4, 9)], "ends");
    // 256 colours: 64 in a row.
    let mut desk = Desk::new(paint(8), "x.png");
    assert_eq!(commands(&mut desk, &[click(12, 24 + 240 + 9)]), [Command::Color(2 * 64 + 2)], "the third row");
}

#[test]
fn the_window_shows_what_is_drawn() {
    let mut desk = Desk::new(paint(4), "x.png");
    assert!(!desk.go(&[]) && !desk.go(&[Event::Move(at(3, 4))]), "nothing new");
    let color = |desk: &Desk, x: usize, y: usize| desk.shot().picture.color(x, y + 24);
    assert!(desk.go(&[key(Key::Key2), Event::Press(at(10, 20)), Event::Move(at(60, 70))]), "a drag");
    assert_eq!((color(&desk, 40, 50), desk.paint().sheet().ram.iter().max()), (EGA.get(15), Some(&0)), "a preview");
    desk.go(&[Event::Release(at(10, 70))]);
    assert_eq!([color(&desk, 40, 50), color(&desk, 10, 50)], [EGA.get(0), EGA.get(15)], "the line");
    assert_eq!(desk.shot().drawn, 51, "its pixels");
    desk.go(&[key(Key::C)]);
    assert_eq!((0..12).filter(|_| desk.go(&[])).count(), 2, "two turns in a fifth of a second");
    assert_eq!(color(&desk, 10, 50), EGA.get(13), "of the colours of the sheet");
    // A failure is shown: the status is not what it was.
    let before = desk.shot().picture;
    desk.apply(&Command::Save("/no/such/folder/x.png".into()));
    assert_ne!(desk.shot().picture, before, "the status");
}
