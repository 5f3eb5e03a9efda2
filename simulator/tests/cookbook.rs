//! The pictures of the cookbook: what the programs on the page draw, in `docs/cookbook`.
//!
//! `cargo xtask tour` writes them anew: look at each before committing it.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::missing_assert_message,
    reason = "the numbers of the pictures are small, and programs on a page have no room for reasons"
)]

use std::{env, fs, path::Path};

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use embedded_raster::{
    buffer_bytes,
    paint::{
        pattern::{self, Pattern},
        RasterOp,
    },
    pixel::{ColorCube, FloydSteinberg, EGA},
    raster::{arc, rectangle},
    surface::{Sheet, Turn, Turned},
    text::{Horizontal, Style, Vertical, FONT_6X10},
    Bitmap, Canvas, Ellipse, Error, Framebuffer, Index1, Index4, Palette, Pictures, Rect, Sector, Surface,
};
use embedded_raster_simulator::Picture;

/// How many times as large as its pixels a picture is shown.
const ZOOM: usize = 4;

/// White with black on it.
const PAPER: Palette<Rgb888, 2> = Palette::new([Rgb888::WHITE, Rgb888::BLACK]);

/// Draws a picture.
type Program = fn() -> Result<Picture, Error>;

const PROGRAMS: [(&str, Program); 8] = [
    ("text", text),
    ("menu", menu),
    ("list", list),
    ("chart", chart),
    ("game", game),
    ("photo", photo),
    ("parts", parts),
    ("turned", turned),
];

fn text() -> Result<Picture, Error> {
    let mut ram = [0; buffer_bytes::<Index4>(96, 32)];
    let mut frame = Framebuffer::<Index4>::new(&mut ram, 96, 32)?;
    frame.fill_window(Index4::new(1));
    let style = Style::new(&FONT_6X10, Index4::new(15)).horizontal(Horizontal::Center);
    style.draw(&mut frame, (48, 13), "21.5 °C\nhumidity 40 %");
    Ok(Picture::indexed(&frame, &EGA))
}

fn menu() -> Result<Picture, Error> {
    let mut ram = [0; buffer_bytes::<Index1>(128, 40)];
    let mut frame = Framebuffer::<Index1>::new(&mut ram, 128, 40)?;
    let (items, chosen) = (["Start", "Settings", "About"], 1);
    let style = Style::new(&FONT_6X10, Index1::new(1)).vertical(Vertical::Top);
    for (line, item) in (0..).zip(items) {
        style.draw(&mut frame, (4, 3 + 12 * line), item);
    }
    let line = Rect::new(0, 2 + 12 * chosen, 128, 14 + 12 * chosen);
    frame.paint(RasterOp::invert(), |window, brush| rectangle::fill(line, window, brush));
    Ok(Picture::indexed(&frame, &PAPER))
}

fn list() -> Result<Picture, Error> {
    let mut ram = [0; buffer_bytes::<Index1>(96, 40)];
    let mut frame = Framebuffer::<Index1>::new(&mut ram, 96, 40)?;
    let list = Rect::new(2, 2, 94, 38); // three lines of twelve rows, inside of a border
    frame.draw_rectangle(Rect::new(0, 0, 96, 40), Index1::new(1));
    let style = Style::new(&FONT_6X10, Index1::new(1)).vertical(Vertical::Top);
    for number in 0..5 {
        let mut list = frame.view(list);
        list.move_area(Rect::new(0, 12, 92, 36), (0, 0));
        list.fill_area(Rect::new(0, 24, 92, 36), Index1::new(0));
        style.draw(&mut list, (2, 25), &format!("event {number}"));
    }
    Ok(Picture::indexed(&frame, &PAPER))
}

fn chart() -> Result<Picture, Error> {
    let mut ram = [0; buffer_bytes::<Index1>(128, 64)];
    let mut frame = Framebuffer::<Index1>::new(&mut ram, 128, 64)?;
    let (ink, values) = (Index1::new(1), [12, 30, 22, 41]);
    let patterns = [pattern::DIAGONAL, pattern::CHECKER, pattern::DOTS, pattern::VERTICAL];
    for ((x, height), rows) in (2..).step_by(14).zip(values).zip(patterns) {
        let bar = Rect::new(x, 60 - height, x + 12, 60);
        frame.paint(Pattern::new(rows, ink, None), |window, brush| rectangle::fill(bar, window, brush));
        frame.draw_rectangle(bar, ink);
    }
    frame.draw_polyline((8..).step_by(14).zip(values.map(|height| 55 - height)), ink);

    let pie = Rect::new(70, 5, 124, 59);
    let (mut start, whole) = (0, values.iter().sum::<i32>() as u16);
    for (value, rows) in values.into_iter().zip(patterns) {
        let (part, paint) = (Sector::slice(start, value as u32, whole), Pattern::new(rows, ink, None));
        frame.paint(paint, |window, brush| arc::fill(Ellipse::in_box(pie), part, window, brush));
        start += value as u32;
    }
    frame.draw_ellipse(pie, ink);
    Ok(Picture::indexed(&frame, &PAPER))
}

fn game() -> Result<Picture, Error> {
    /// Grass, water, a stone and a ghost: 8 x 8 pixels each, side by side.
    const PICTURE: [u8; 128] = [
        0x22, 0x22, 0x22, 0x22, 0x11, 0x11, 0x11, 0x11, 0x22, 0x22, 0x22, 0x22, 0x00, 0xff, 0xff, 0x00, //
        0x22, 0xa2, 0x22, 0x22, 0x11, 0x11, 0x11, 0x11, 0x22, 0x77, 0x77, 0x22, 0x0f, 0xff, 0xff, 0xf0, //
        0x22, 0xa2, 0x2a, 0x22, 0x19, 0x91, 0x11, 0x91, 0x27, 0x77, 0x77, 0x72, 0x0f, 0x0f, 0xf0, 0xf0, //
        0x22, 0x22, 0x2a, 0x22, 0x91, 0x19, 0x99, 0x19, 0x27, 0x7f, 0x77, 0x82, 0x0f, 0x0f, 0xf0, 0xf0, //
        0x22, 0x22, 0x22, 0x22, 0x11, 0x11, 0x11, 0x11, 0x27, 0x77, 0x78, 0x82, 0x0f, 0xff, 0xff, 0xf0, //
        0x2a, 0x22, 0x22, 0xa2, 0x11, 0x11, 0x11, 0x11, 0x28, 0x88, 0x88, 0x82, 0x0f, 0xff, 0xff, 0xf0, //
        0x2a, 0x22, 0x22, 0xa2, 0x19, 0x91, 0x11, 0x91, 0x22, 0x88, 0x88, 0x22, 0x0f, 0xff, 0xff, 0xf0, //
        0x22, 0x22, 0x22, 0x22, 0x91, 0x19, 0x99, 0x19, 0x22, 0x22, 0x22, 0x22, 0x0f, 0x0f, 0xf0, 0xf0, //
    ];
    let picture = Bitmap::<Index4>::new(&PICTURE, 32, 8)?;
    let tiles = Sheet::new(&picture, 8, 8);
    let mut ram = [0; buffer_bytes::<Index4>(96, 64)];
    let mut frame = Framebuffer::<Index4>::new(&mut ram, 96, 64)?;
    // A river without end, and stones beside it.
    let tile = |column: i32, row: i32| match (column - row / 2).rem_euclid(9) {
        0..=2 => Some(1),
        5 if row % 3 == 0 => Some(2),
        _ => Some(0),
    };
    for time in 0..20 {
        frame.draw_tile_map((-time, -time / 2), &tiles, tile, Some);
        for number in 0..6 {
            let (x, y) = ((number * 37 + time * 2) % 104 - 8, 4 + number * 10 + (time + number) % 4);
            if let Some(ghost) = tiles.tile(3) {
                frame.blit_keyed((x, y), &ghost, Index4::new(0));
            }
        }
    }
    Ok(Picture::indexed(&frame, &EGA))
}

fn photo() -> Result<Picture, Error> {
    let sky = |n: i32| [255 - n / 96 * 3, 40 + n / 96, n % 96 * 2].map(|level| level as u8);
    let pixels: Vec<u8> = (0..96 * 64).flat_map(sky).collect();
    let photo = Bitmap::<Rgb888>::new(&pixels, 96, 64)?;
    let mut ram = [0; buffer_bytes::<Index4>(96, 64)];
    let mut frame = Framebuffer::<Index4>::new(&mut ram, 96, 64)?;
    let (cube, mut row) = (ColorCube::<4096>::new(&EGA), [[0; 3]; 96]);
    let mut diffusion = FloydSteinberg::new(&mut row);
    frame.blit_mapped((0, 0), &photo, |color: Rgb888| {
        Some(diffusion.next([color.r(), color.g(), color.b()], |[r, g, b]| {
            let index = cube.nearest(Rgb888::new(r, g, b));
            let shown = EGA.get(index).unwrap_or_default();
            (Index4::new(index), [shown.r(), shown.g(), shown.b()])
        }))
    });
    Ok(Picture::indexed(&frame, &EGA))
}

fn parts() -> Result<Picture, Error> {
    let mut ram = [0; buffer_bytes::<Index4>(96, 64)];
    let mut frame = Framebuffer::<Index4>::new(&mut ram, 96, 64)?;
    frame.fill_window(Index4::new(1));
    let mut window = frame.view(Rect::new(12, 8, 84, 56));
    window.draw_rectangle(Rect::new(0, 0, 72, 48), Index4::new(15));
    {
        let mut inside = window.clipped(Rect::new(1, 1, 71, 47)); // same (0, 0), fewer pixels
        inside.fill_window(Index4::new(0));
        inside.fill_ellipse(Rect::new(30, 14, 110, 94), Index4::new(4));
        let mut corner = inside.view(Rect::new(-4, 30, 24, 60)); // a part outside does no harm
        corner.fill_ellipse(Rect::new(0, 0, 28, 30), Index4::new(14));
    }
    window.draw_line((0, 8), (71, 8), Index4::new(15)); // the border is not clipped any more
    Ok(Picture::indexed(&frame, &EGA))
}

fn turned() -> Result<Picture, Error> {
    let mut ram = [0; buffer_bytes::<Index1>(32, 96)];
    let mut screen = Framebuffer::<Index1>::new(&mut ram, 32, 96)?;
    let mut upright = Turned::new(&mut screen, Turn::Quarter); // 96 x 32
    upright.draw_line((0, 14), (95, 14), Index1::new(1));
    Style::new(&FONT_6X10, Index1::new(1)).vertical(Vertical::Top).draw(&mut upright, (2, 2), "this way up");
    Ok(Picture::indexed(&screen, &PAPER))
}

fn docs() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs")
}

/// The page, with lines as they are everywhere.
fn page() -> String {
    fs::read_to_string(docs().join("cookbook.md")).expect("the page").replace("\r\n", "\n")
}

/// Every picture is what its program draws today. With `BLESS=1`, writes them.
#[test]
fn pictures_are_up_to_date() {
    let is_blessed = env::var_os("BLESS").is_some_and(|bless| bless == "1");
    for (name, program) in PROGRAMS {
        let (path, picture) =
            (docs().join("cookbook").join(format!("{name}.png")), program().expect(name).zoomed(ZOOM));
        if is_blessed {
            picture.write_png(&path).expect("it can be written");
        }
        let shown = Picture::read_png(&path).map_err(|error| error.to_string());
        assert!(shown == Ok(picture), "{name} is not what is drawn today: run `cargo xtask tour`, and look at it");
    }
    let shown = page().matches("](cookbook/").count();
    assert_eq!(shown, PROGRAMS.len(), "each picture on the page is drawn");
}

/// The program above a picture is the one that draws it: line by line, but for imports and what the page hides.
#[test]
fn programs_draw_the_pictures_below_them() {
    let trimmed = |text: &str| text.lines().map(|line| line.trim().to_owned() + "\n").collect::<String>();
    let (page, here) = (page(), trimmed(include_str!("cookbook.rs")));
    for (name, _) in PROGRAMS {
        let above = page.split_once(&format!("](cookbook/{name}.png)")).expect("it is shown").0;
        let block = above.rsplit("```").nth(1).expect("a program stands above it");
        let shown = block.lines().filter(|line| !line.starts_with("# "));
        // Imports stand at the top, up to an empty line.
        let program = shown.skip(1).skip_while(|line| !line.is_empty()).skip(1);
        let program = trimmed(&program.collect::<Vec<_>>().join("\n"));
        assert!(program.lines().count() > 4, "a program: {program}");
        assert!(here.contains(program.trim()), "{name} is drawn by another program than\n{program}");
    }
}
