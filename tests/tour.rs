//! Pages of the documentation with pictures: the page of the crate, `src/tour.md`, and those of some modules. Pictures stand as data
//! at the end of a page, or in a file of their own beside a module, and are what the programs above them draw.
//!
//! `cargo xtask tour` writes the pictures anew: look at each before committing it.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::missing_assert_message,
    reason = "the numbers of the pictures are small, and programs on a page have no room for reasons"
)]

use std::{env, fs, path::Path};

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{BinaryColor, Gray4, Gray8, GrayColor, Rgb565, Rgb888, RgbColor},
};
use embedded_raster::{
    buffer_bytes, framebuffer,
    geom::At,
    paint::{Bayer, Cover, Linear, Masked, Outside, Radial},
    pipeline::{Pipeline, Vertex},
    pixel::{Channels, EGA},
    px,
    raster::{
        coverage, ellipse,
        flood::{Connectivity, FloodSlot},
        line, rectangle, triangle,
    },
    surface::texture::{Clamp, Mirror, Repeat, Texture},
    Antialias, Bitmap, Canvas, ClippedSpan, CoverageSlot, EdgeSlot, Ellipse, Error, FillRule, Framebuffer, Index1,
    Index2, Index4, Index8, Paint, Palette, PointFx, Rect, Stroke, Surface, Vec3,
};
use embedded_raster_simulator::{
    teapot::{draw, Camera, Patches, View},
    Picture,
};
use fixed::types::I16F16;

/// How many times as large as its pixels a picture is shown.
const ZOOM: usize = 4;

/// Draws a picture.
type Program = fn() -> Result<Picture, Error>;

/// A page with pictures.
struct Page {
    /// The file that is read.
    text: &'static str,
    /// The file that has the pictures as data.
    data: &'static str,
    /// Pictures whose program stands above them.
    programs: &'static [(&'static str, Program)],
    /// Other pictures.
    others: &'static [(&'static str, Program)],
    /// Pictures that are files.
    files: &'static [(&'static str, &'static str)],
}

const PAGES: [Page; 4] = [
    Page {
        text: "src/tour.md",
        data: "src/tour.md",
        programs: &[
            ("first-program", first_program),
            ("paints", paints),
            ("dither", dither),
            ("soft-rims", soft_rims),
            ("reading", reading),
        ],
        others: &[("places", places)],
        files: &[("world-map", "docs/world_map.png"), ("shapes", "docs/shapes.png"), ("teapots", "docs/teapot.png")],
    },
    Page {
        text: "src/paint/mod.rs",
        data: "src/paint/pictures.md",
        programs: &[("gradients", gradients), ("masks", masks)],
        others: &[],
        files: &[],
    },
    Page {
        text: "src/surface/texture.rs",
        data: "src/surface/texture.md",
        programs: &[("address-modes", address_modes)],
        others: &[],
        files: &[],
    },
    Page {
        text: "src/pipeline/mod.rs",
        data: "src/pipeline/pictures.md",
        programs: &[("blue-triangle", blue_triangle)],
        others: &[
            ("teapot-gouraud", || teapot(View::Gouraud)),
            ("teapot-textured", || teapot(View::Textured)),
            ("teapot-depth", || teapot(View::Depth)),
            ("teapot-id", || teapot(View::Id)),
        ],
        files: &[],
    },
];

fn first_program() -> Result<Picture, Error> {
    type Screen = framebuffer!(Index4, 64, 48); // 1,536 bytes
    let mut screen = Screen::new();
    let mut frame = screen.frame();
    let (sea, land, border) = (Index4::new(1), Index4::new(2), Index4::new(15));

    frame.clear(sea);
    let island = [(8, 30), (20, 9), (37, 16), (56, 12), (49, 40), (24, 44)].map(|(x, y)| PointFx::px(x, y));
    let mut table = [EdgeSlot::EMPTY; 8]; // scratch memory: at most 8 sides of the outline cross a row
    frame.fill_polygon_fx(&island, FillRule::EvenOdd, &mut table, land)?;
    frame.draw_line(Point::new(20, 9), Point::new(49, 40), border);
    assert_eq!(frame.get(Point::new(30, 25)), Some(land));
    Ok(Picture::indexed(&frame, &EGA).zoomed(ZOOM))
}

fn paints() -> Result<Picture, Error> {
    /// Colours 1 to 15 from top to bottom. Between two of them, every other pixel has the next one.
    struct Dusk;

    impl<S: Surface<Color = Index4>> Paint<S> for Dusk {
        fn span(&mut self, on: &mut S, span: ClippedSpan) {
            let y = span.y();
            on.write_span(span, |x| Index4::new(((2 * y + 3 * ((x + y) & 1)) / 6) as u8));
        }
    }

    let mut ram = [0; buffer_bytes::<Index4>(64, 48)];
    let mut frame = Framebuffer::<Index4>::new(&mut ram, 64, 48)?;
    let sun = Ellipse::in_box(Rect::new(11, 3, 53, 45));
    frame.paint(Dusk, |window, brush| ellipse::fill(sun, window, brush));

    // From yellow to a dark red, before a night sky.
    let palette = Palette::<Rgb888, 16>::new(std::array::from_fn(|i| {
        let part = |from: usize, to: usize| u8::try_from((from * (15 - i) + to * (i - 1)) / 14).unwrap_or(0);
        if i == 0 {
            Rgb888::new(20, 16, 48)
        } else {
            Rgb888::new(part(255, 120), part(226, 20), part(120, 60))
        }
    }));
    Ok(Picture::indexed(&frame, &palette).zoomed(ZOOM))
}

fn dither() -> Result<Picture, Error> {
    let mut ram = [0; buffer_bytes::<Gray4>(128, 48)];
    let mut frame = Framebuffer::<Gray4>::new(&mut ram, 128, 48)?;
    let corners = |x: i32| [(x + 4, 44), (x + 30, 3), (x + 60, 40)].map(|(x, y)| PointFx::px(x, y));
    let levels = [20, 250, 90].map(|level: u8| (level, At::default()));
    frame.shade_triangle_fx(corners(0), levels, |(level, _)| Gray4::new(level >> 4))?;
    frame.shade_triangle_fx(corners(64), levels, |(level, At(at))| Gray4::new(Bayer::<4>::shade(level, 15, at)))?;
    Ok(Picture::of(&frame).zoomed(ZOOM))
}

fn soft_rims() -> Result<Picture, Error> {
    let mut ram = [0; buffer_bytes::<Gray8>(64, 48)];
    let mut frame = Framebuffer::<Gray8>::new(&mut ram, 64, 48)?;
    let mut table = [CoverageSlot::EMPTY; 16]; // the sides that touch a row
    let mut cells = [0; coverage::cells(64)]; // a row of pixels; with fewer, a row is drawn in parts
    let (dial, hand) = (Ellipse::circle(PointFx::px(32, 24), px(21)), [PointFx::px(32, 24), PointFx::px(46, 12)]);
    frame.fill_ellipse_aa(dial, Cover(Gray8::new(120)));
    frame.stroke_line_aa(hand, &Stroke::px(3), &mut table, &mut cells, Cover(Gray8::WHITE))?;
    frame.draw_line_aa(PointFx::px(32, 24), PointFx::px(25, 8), Cover(Gray8::WHITE));
    Ok(Picture::of(&frame).zoomed(ZOOM))
}

fn reading() -> Result<Picture, Error> {
    static ARROW: [u8; 7] = [0x08, 0x0c, 0xfe, 0xff, 0xfe, 0x0c, 0x08]; // eight pixels of one bit to a byte
    let arrow = Bitmap::<Index1>::new(&ARROW, 8, 7)?;

    let mut ram = [0; buffer_bytes::<Index4>(64, 48)];
    let mut frame = Framebuffer::<Index4>::new(&mut ram, 64, 48)?;
    frame.draw_ellipse(Rect::new(2, 2, 40, 46), Index4::new(15));
    frame.draw_ellipse(Rect::new(22, 2, 62, 46), Index4::new(15));
    let mut table = [FloodSlot::EMPTY; 16];
    frame.flood_fill(Point::new(31, 24), Connectivity::Sides, &mut table, Index4::new(2));
    frame.blit_mask(Point::new(8, 20), &arrow, Index4::new(14), None);
    frame.move_area(Rect::new(8, 20, 16, 27), Point::new(46, 20)); // copies the arrow
    assert_eq!(frame.get(Point::new(53, 23)), Some(Index4::new(14)));
    Ok(Picture::indexed(&frame, &EGA).zoomed(ZOOM))
}

fn gradients() -> Result<Picture, Error> {
    let mut ram = [0; buffer_bytes::<Rgb565>(144, 48)];
    let mut frame = Framebuffer::<Rgb565>::new(&mut ram, 144, 48)?;
    let mix = |level, _| Rgb565::between([Rgb565::YELLOW, Rgb565::BLUE], level);

    let sky = Linear::new([PointFx::px(4, 4), PointFx::px(44, 44)], Outside::Clamp, mix);
    frame.paint(sky, |window, brush| rectangle::fill(Rect::new(4, 4, 44, 44), window, brush));

    let ball = Radial::new(PointFx::px(64, 16), px(32), Outside::Clamp, mix);
    let disc = Ellipse::in_box(Rect::new(52, 4, 92, 44));
    frame.paint(ball, |window, brush| ellipse::fill(disc, window, brush));

    let corners = [(100, 44), (120, 4), (140, 44)].map(|(x, y)| PointFx::px(x, y));
    frame.shade_triangle_fx(corners, [Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE], |color| color)?;
    Ok(Picture::of(&frame).zoomed(ZOOM))
}

fn masks() -> Result<Picture, Error> {
    let (mut bits, mut shades) = ([0; buffer_bytes::<BinaryColor>(144, 48)], [0; 144 * 48]);
    let (mut table, mut cells) = ([CoverageSlot::EMPTY; 16], [0; coverage::cells(144)]);
    let disc = |x| Ellipse::circle(PointFx::px(x, 24), px(21));
    let mut hard = Framebuffer::<BinaryColor>::new(&mut bits, 144, 48)?;
    hard.fill_ellipse_fx(disc(24), BinaryColor::On);
    let mut soft = Framebuffer::<Gray8>::new(&mut shades, 144, 48)?;
    soft.fill_ellipse_aa(disc(72), Cover(Gray8::WHITE));
    let fade = Linear::new([PointFx::px(99, 0), PointFx::px(141, 0)], Outside::Clamp, |level, _| Gray8::new(level));
    soft.paint(fade, |window, brush| rectangle::fill(Rect::new(99, 3, 141, 45), window, brush));

    let mut ram = [0; buffer_bytes::<Rgb565>(144, 48)];
    let mut frame = Framebuffer::<Rgb565>::new(&mut ram, 144, 48)?;
    for x in (-48..144).step_by(12) {
        let stripe = [(x, 48), (x + 48, 0), (x + 54, 0), (x + 6, 48)].map(|(x, y)| PointFx::px(x, y));
        let (rule, yellow) = (FillRule::NonZero, Cover(Rgb565::YELLOW));
        frame.fill_polygon_aa(&stripe, rule, &mut table, &mut cells, Masked::new(hard.as_bitmap(), yellow))?;
        frame.fill_polygon_aa(&stripe, rule, &mut table, &mut cells, Masked::new(soft.as_bitmap(), yellow))?;
    }
    Ok(Picture::of(&frame).zoomed(ZOOM))
}

fn address_modes() -> Result<Picture, Error> {
    // The letter F, 8 x 8 pixels of 4 bits.
    const F: [u8; 32] = [
        0x44, 0x44, 0x44, 0x44, 0x4f, 0xff, 0xff, 0xf4, 0x4f, 0x44, 0x44, 0x44, 0x4f, 0xff, 0xf4, 0x44, //
        0x4f, 0x44, 0x44, 0x44, 0x4f, 0x44, 0x44, 0x44, 0x4f, 0x44, 0x44, 0x44, 0x44, 0x44, 0x44, 0x44, //
    ];
    let letter = Bitmap::<Gray4>::new(&F, 8, 8)?;
    let repeat = Texture::new(&letter, (Repeat, Repeat)).expect("it has texels");
    let mirror = Texture::new(&letter, (Mirror, Mirror)).expect("it has texels");
    let clamp = Texture::new(&letter, (Clamp, Clamp)).expect("it has texels");

    let mut ram = [0; buffer_bytes::<Gray4>(204, 68)];
    let mut frame = Framebuffer::<Gray4>::new(&mut ram, 204, 68)?;
    // A square of two triangles, 64 pixels wide, shows 24 texels: from 8 before the picture to 8 behind it.
    let mut square = |left: i32, color: &dyn Fn(I16F16, I16F16) -> Gray4| {
        let place = |(x, y)| PointFx::px(left + 64 * x, 2 + 64 * y);
        let texel = |(x, y)| (I16F16::from_num(24 * x - 8), I16F16::from_num(24 * y - 8));
        for corners in [[(0, 0), (1, 0), (0, 1)], [(1, 1), (0, 1), (1, 0)]] {
            frame.shade_triangle_fx(corners.map(place), corners.map(texel), |(u, v)| color(u, v))?;
        }
        Ok::<(), Error>(())
    };
    square(2, &|u, v| repeat.nearest(u, v))?;
    square(70, &|u, v| mirror.nearest(u, v))?;
    square(138, &|u, v| clamp.bilinear(u, v))?;
    Ok(Picture::of(&frame).zoomed(ZOOM))
}

fn blue_triangle() -> Result<Picture, Error> {
    let mut ram = [0; buffer_bytes::<Rgb565>(64, 64)];
    let mut frame = Framebuffer::<Rgb565>::new(&mut ram, 64, 64)?;
    let corners = [(-1, 0), (0, -1), (-1, -1)].map(|(x, y)| Vec3::whole(x, y, 0));
    Pipeline::new(64, 64)?.triangles(
        [corners],
        |place| Vertex::new(place.with_w(I16F16::ONE), ()),
        |triangle| triangle.fill(&mut frame, |_| Some(Rgb565::BLUE)),
    );
    Ok(Picture::of(&frame).zoomed(ZOOM))
}

/// The teapot, 160 x 120 pixels of 4 bits.
fn teapot(view: View) -> Result<Picture, Error> {
    let camera = Camera { zoom: I16F16::from_num(1.25), ..Camera::new(160, 120) };
    let patches = Patches::parse(include_str!("../assets/teapot-patches.txt")).expect("they are well-formed");
    Ok(draw(4, &patches.mesh(camera.tolerance(view)), view, &camera, None)?.picture)
}

/// A triangle between places and a line between pixels, on a grid whose cells stand for pixels.
fn places() -> Result<Picture, Error> {
    const CELL: i32 = 16;
    const COLUMNS: i32 = 26;
    const ROWS: i32 = 9;
    let (grid, pixel, ink) = (Index2::new(1), Index2::new(2), Index2::new(3));
    let mut ram = [0; buffer_bytes::<Index2>((CELL * COLUMNS + 1) as u16, (CELL * ROWS + 1) as u16)];
    let mut frame = Framebuffer::<Index2>::new(&mut ram, (CELL * COLUMNS + 1) as u16, (CELL * ROWS + 1) as u16)?;

    // In quarters of a pixel.
    let corners = [(5, 27), (18, 3), (46, 33)].map(|(x, y)| PointFx::from_bits(64 * x, 64 * y));
    let ends = [Point::new(14, 7), Point::new(24, 2)];
    let window = Rect::new(0, 0, COLUMNS, ROWS);
    let cell = |x: i32, y: i32| Rect::new(CELL * x, CELL * y, CELL * (x + 1), CELL * (y + 1));
    let mut color_in = |span: ClippedSpan| {
        (span.x0()..span.x1()).for_each(|x| frame.fill_rectangle(cell(x, span.y()), pixel));
    };
    triangle::fill(corners, window, &mut color_in);
    line::draw(ends[0], ends[1], window, &mut color_in);

    for x in 0..=COLUMNS {
        frame.draw_line(Point::new(CELL * x, 0), Point::new(CELL * x, CELL * ROWS), grid);
    }
    for y in 0..=ROWS {
        frame.draw_line(Point::new(0, CELL * y), Point::new(CELL * COLUMNS, CELL * y), grid);
    }
    for (x, y) in (0..COLUMNS).flat_map(|x| (0..ROWS).map(move |y| (x, y))) {
        frame.fill_rectangle(cell(x, y).inset(CELL / 2 - 1), grid);
    }
    let enlarged = |at: PointFx| PointFx::from_bits(at.x.to_bits() * CELL, at.y.to_bits() * CELL);
    let mut table = [EdgeSlot::EMPTY; 32];
    frame.stroke_polyline_fx(&corners.map(enlarged), true, &Stroke::px(2), &mut table, ink)?;
    frame.stroke_line_fx(ends.map(|end| enlarged(PointFx::centre_of(end))), &Stroke::px(2), &mut table, ink)?;
    let palette = Palette::new([0xff_ff_ff, 0xb8_bc_c4, 0xff_c8_57, 0x1d_33_4a].map(rgb));
    Ok(Picture::indexed(&frame, &palette))
}

fn rgb(color: u32) -> Rgb888 {
    let [_, r, g, b] = color.to_be_bytes();
    Rgb888::new(r, g, b)
}

impl Page {
    /// Its pictures: their names, and PNG files.
    fn pictures(&self) -> Vec<(&'static str, Vec<u8>)> {
        let drawn = self.programs.iter().chain(self.others).map(|&(name, draw)| {
            let picture = draw().unwrap_or_else(|error| panic!("{name}: {error}"));
            (name, picture.to_png().expect("it has pixels"))
        });
        let read =
            self.files.iter().map(|&(name, file)| (name, fs::read(project().join(file)).expect("it is readable")));
        drawn.chain(read).collect()
    }

    /// Its text, without the marks of comments.
    fn text(&self) -> String {
        let text = read(self.text);
        let line =
            |line: &str| line.strip_prefix("//! ").or(line.strip_prefix("//!")).unwrap_or(line).to_owned() + "\n";
        text.lines().map(line).collect()
    }
}

fn project() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

fn read(file: &str) -> String {
    fs::read_to_string(project().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// What the definition of a picture begins with: `[name]: data:...`.
fn definition(name: &str) -> String {
    format!("[{name}]: data:image/png;base64,")
}

/// The base64 of RFC 4648.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let digits = bytes.chunks(3).flat_map(|chunk| {
        let byte = |i: usize| u32::from(chunk.get(i).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        let digit = move |i: usize| char::from(DIGITS[(bits >> (18 - 6 * i) & 63) as usize]);
        (0..4).map(move |i| if i <= chunk.len() { digit(i) } else { '=' })
    });
    digits.collect()
}

/// Every definition is the picture as it is drawn today. With `BLESS=1`, writes them.
#[test]
fn pictures_are_up_to_date() {
    let is_blessed = env::var_os("BLESS").is_some_and(|bless| bless == "1");
    for page in PAGES {
        let (pictures, data, text) = (page.pictures(), read(page.data), page.text());
        let new: String = data
            .lines()
            .map(|line| match pictures.iter().find(|(name, _)| line.starts_with(&definition(name))) {
                Some((name, file)) => format!("{}{}\n", definition(name), base64(file)),
                None => format!("{line}\n"),
            })
            .collect();
        if is_blessed {
            fs::write(project().join(page.data), new).expect("it can be written");
            continue;
        }
        for (name, file) in &pictures {
            assert!(text.contains(&format!("][{name}]")), "{name} is shown in {}", page.text);
            let is_new = data.contains(&format!("{}{}\n", definition(name), base64(file)));
            assert!(is_new, "{name} is not what is drawn today: run `cargo xtask tour`, and look at it");
        }
        assert_eq!(data.matches("]: data:").count(), pictures.len(), "each picture of {} is drawn", page.data);
        assert_eq!(data, new, "the rest stays as it is");
    }
}

/// The program above a picture is the one that draws it: line by line, but for imports and what the page hides.
#[test]
fn programs_draw_the_pictures_below_them() {
    let trimmed = |text: &str| text.lines().map(|line| line.trim().to_owned() + "\n").collect::<String>();
    let here = trimmed(include_str!("tour.rs"));
    for page in PAGES {
        let text = page.text();
        for (name, _) in page.programs {
            let above = text.split_once(&format!("][{name}]")).expect("it is shown").0;
            let block = above.rsplit("```").nth(1).expect("a program stands above it");
            let shown = block.lines().filter(|line| !line.starts_with("# "));
            // Imports stand at the top, up to an empty line.
            let program = shown.skip_while(|line| !line.is_empty()).skip(1).skip_while(|line| !line.is_empty()).skip(1);
            let program = trimmed(&program.collect::<Vec<_>>().join("\n"));
            assert!(program.lines().count() > 5, "a program: {program}");
            assert!(here.contains(program.trim()), "{name} is drawn by another program than\n{program}");
        }
    }
}

/// Bytes of screens, as the table of the page has them.
#[test]
fn the_table_of_memory() {
    let page = read("src/tour.md");
    for (width, height) in [(128, 64), (200, 200), (240, 240), (320, 240), (480, 320), (800, 480)] {
        let bytes = [
            buffer_bytes::<Index1>(width, height),
            buffer_bytes::<Index2>(width, height),
            buffer_bytes::<Index4>(width, height),
            buffer_bytes::<Index8>(width, height),
            buffer_bytes::<Rgb565>(width, height),
            buffer_bytes::<Rgb888>(width, height),
        ];
        let row = format!("| {width} x {height} | {} |\n", bytes.map(grouped).join(" | "));
        assert!(page.contains(&row), "{row}");
    }
}

/// With a comma before every three digits.
fn grouped(n: usize) -> String {
    if n < 1000 {
        n.to_string()
    } else {
        format!("{},{:03}", grouped(n / 1000), n % 1000)
    }
}

#[test]
fn base64_of_the_standard() {
    let examples = [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")];
    assert!(examples.iter().all(|(text, expected)| base64(text.as_bytes()) == *expected), "RFC 4648, section 10");
}
