//! Every shape on one page, at any depth, whole or band by band.
//!
//! `cargo run --release --example shapes` writes `shapes.png` and shows it in the terminal; `-- --help` tells the rest. What is
//! drawn stands in `page.rs`, which chips draw too.

mod hatched;
mod page;
#[cfg(test)]
#[path = "../../tests/golden/compare.rs"]
mod pictures;

use std::{error::Error, process::ExitCode};

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_raster::{
    buffer_bytes, pixel::row_bytes, pixel::Xrgb8888, raster::flood::FloodSlot, EdgeSlot, Framebuffer, Index1, Index2,
    Index4, Index8, Palette, PixelFormat,
};
use embedded_raster_simulator::{finish, Picture};
use page::{Ink, COLORS, EDGES, HEIGHT, WIDTH};

const USAGE: &str = "\
usage: shapes [--bits 1|2|4|8|16|24|32] [--band ROWS] [--out FILE.png]

--out FILE.png     where the picture goes; shapes.png unless told
--band ROWS        draws in bands of that many rows: the same pixels with less memory, but for what reads the page (flood fills)";

fn main() -> ExitCode {
    finish("shapes", run(lexopt::Parser::from_env()))
}

/// Does what the arguments say, and returns what there is to say of it.
fn run(mut arguments: lexopt::Parser) -> Result<String, Box<dyn Error>> {
    let (mut bits, mut band, mut output) = (4, None, String::from("shapes.png"));
    while let Some(argument) = arguments.next()? {
        use lexopt::prelude::*;
        match argument {
            Long("bits") => bits = arguments.value()?.parse_with(parse_bits)?,
            Long("band") => band = Some(arguments.value()?.parse_with(parse_rows)?),
            Long("out" | "output") => output = arguments.value()?.string()?,
            Long("help") | Short('h') => return Ok(format!("{USAGE}\n")),
            _ => return Err(argument.unexpected().into()),
        }
    }
    let picture = match bits {
        1 => indexed::<Index1, 2>(drawn_by(band, hatched::draw, hatched::pour)?)?,
        2 => indexed::<Index2, 4>(drawn(band, index::<Index2>)?)?,
        4 => indexed::<Index4, 16>(drawn(band, index::<Index4>)?)?,
        8 => indexed::<Index8, 256>(drawn(band, index::<Index8>)?)?,
        16 => Picture::of(&Framebuffer::<Rgb565>::new(&mut drawn(band, color::<Rgb565>)?, WIDTH, HEIGHT)?),
        24 => Picture::of(&Framebuffer::<Rgb888>::new(&mut drawn(band, color::<Rgb888>)?, WIDTH, HEIGHT)?),
        _ => Picture::of(&Framebuffer::<Xrgb8888>::new(&mut drawn(band, color::<Xrgb8888>)?, WIDTH, HEIGHT)?),
    };
    picture.write_png(&output)?;
    picture.show(100);
    let plural = if bits == 1 { "" } else { "s" };
    let edges = format!("{EDGES} edges of {} bytes", size_of::<EdgeSlot>());
    Ok(format!("{output}: {WIDTH} x {HEIGHT} at {bits} bit{plural} per pixel, {edges}\n"))
}

fn parse_bits(text: &str) -> Result<u32, &'static str> {
    let bits = text.parse().ok().filter(|bits| [1, 2, 4, 8, 16, 24, 32].contains(bits));
    bits.ok_or("--bits takes one of 1, 2, 4, 8, 16, 24, 32")
}

fn parse_rows(text: &str) -> Result<u16, &'static str> {
    text.parse().ok().filter(|&rows| rows > 0).ok_or("--band takes rows from 1 to 65535")
}

/// The bytes of the page in colours.
fn drawn<C>(band: Option<u16>, ink: impl Fn(Ink) -> C) -> Result<Vec<u8>, embedded_raster::Error>
where
    C: PixelFormat<Color = C>,
{
    drawn_by::<C>(band, |page, table| page::draw(page, table, &ink), |page, table| page::pour(page, table, &ink))
}

/// The bytes of the page; drawn in bands, they are put together as a display would.
fn drawn_by<C: PixelFormat>(
    band: Option<u16>,
    draw: impl Fn(&mut Framebuffer<'_, C>, &mut [EdgeSlot]) -> Result<(), embedded_raster::Error>,
    pour: impl Fn(&mut Framebuffer<'_, C>, &mut [FloodSlot]) -> Result<(), embedded_raster::Error>,
) -> Result<Vec<u8>, embedded_raster::Error> {
    let mut table = [EdgeSlot::EMPTY; EDGES];
    let mut screen = vec![0; buffer_bytes::<C>(WIDTH, HEIGHT)];
    let Some(rows) = band else {
        let mut frame = Framebuffer::<C>::new(&mut screen, WIDTH, HEIGHT)?;
        draw(&mut frame, &mut table)?;
        pour(&mut frame, &mut [FloodSlot::EMPTY; 16])?;
        return Ok(screen);
    };
    let mut ram = vec![0; buffer_bytes::<C>(WIDTH, rows)];
    let bytes = row_bytes::<C>(WIDTH) * usize::from(rows);
    for (start, part) in (0..HEIGHT).step_by(rows.into()).zip(screen.chunks_mut(bytes)) {
        let end = HEIGHT.min(start.saturating_add(rows));
        let mut frame = Framebuffer::<C>::band(&mut ram, WIDTH, HEIGHT, start..end)?;
        draw(&mut frame, &mut table)?;
        part.copy_from_slice(frame.row_bytes(start..end));
    }
    Ok(screen)
}

/// An index into [`COLORS`], or of the last color that there is.
fn index<C: PixelFormat<Color = C>>(ink: Ink) -> C {
    let colors = (1 << C::BITS) - 1;
    C::unpack(if ink == 0 { 0 } else { (u32::from(ink) - 1) % colors + 1 })
}

fn color<C: From<Rgb888>>(ink: Ink) -> C {
    COLORS[usize::from(ink)].into()
}

/// What indices show through a palette of so many colours.
fn indexed<C, const N: usize>(mut memory: Vec<u8>) -> Result<Picture, Box<dyn Error>>
where
    C: PixelFormat<Color = C> + embedded_graphics::pixelcolor::PixelColor + Into<u8>,
{
    let colors: [Rgb888; N] = std::array::from_fn(|i| COLORS.get(i).copied().unwrap_or_default());
    Ok(Picture::indexed(&Framebuffer::<C>::new(&mut memory, WIDTH, HEIGHT)?, &Palette::new(colors)))
}

#[cfg(test)]
mod tests {
    use embedded_raster::{Bitmap, Rect};

    use super::*;

    #[test]
    fn wrong_arguments_are_told_in_a_line() {
        for (arguments, expected) in [
            ("--band 0", r#"cannot parse argument "0": --band takes rows from 1 to 65535"#),
            ("--band 65536", r#"cannot parse argument "65536": --band takes rows from 1 to 65535"#),
            ("--bits 3", r#"cannot parse argument "3": --bits takes one of 1, 2, 4, 8, 16, 24, 32"#),
            ("--bits x", r#"cannot parse argument "x": --bits takes one of 1, 2, 4, 8, 16, 24, 32"#),
            ("--bits", "missing argument for option '--bits'"),
            ("--size 3x3", "invalid option '--size'"),
            ("page.png", r#"unexpected argument "page.png""#),
            ("--out /no/such/folder/x.png", "/no/such/folder/x.png: "),
        ] {
            let error = run(lexopt::Parser::from_args(arguments.split(' '))).expect_err(arguments).to_string();
            assert!(error.starts_with(expected) && !error.contains('\n'), "{arguments}: {error}");
        }
        let help = run(lexopt::Parser::from_args(["--help"])).expect("help");
        assert!(help.starts_with("usage: shapes"), "{help}");
    }

    /// `BLESS=1 cargo test --example shapes` writes them anew.
    #[test]
    fn pages_are_as_they_were() {
        let one = drawn_by(None, hatched::draw, hatched::pour).unwrap();
        let four = drawn(None, index::<Index4>).unwrap();
        let pages = [("page-1", indexed::<Index1, 2>(one)), ("page-4", indexed::<Index4, 16>(four))];
        for (name, page) in pages {
            assert_eq!(pictures::compare(name, &page.unwrap()), None);
        }
    }

    /// At one bit, areas are neither black nor white, and no two of them look alike.
    #[test]
    fn patterns_tell_colours_apart() {
        let memory = drawn_by(None, hatched::draw, hatched::pour).unwrap();
        let page = Bitmap::<Index1>::new(&memory, WIDTH, HEIGHT).unwrap();
        // In the middle of each of six sectors of the pie: the seventh tile.
        let places = [(48, 40), (36, 48), (20, 44), (12, 28), (20, 14), (46, 16)];
        let blocks = places.map(|(x, y)| {
            let block = Rect::new(64 + x - 4, 60 + y - 4, 64 + x + 4, 60 + y + 4);
            let rows: Vec<bool> = page.colors(block).map(|color| color == Index1::new(1)).collect();
            assert!(rows.contains(&true) && rows.contains(&false), "{block:?} has a pattern");
            rows
        });
        let different: std::collections::HashSet<_> = blocks.iter().collect();
        assert_eq!(different.len(), blocks.len(), "of their own");
    }

    #[test]
    fn bands_of_one_bit_are_the_whole() {
        let whole = drawn_by(None, hatched::draw, |_, _| Ok(())).unwrap();
        for rows in [1, 7, 64, 239, 240] {
            assert!(drawn_by(Some(rows), hatched::draw, hatched::pour).unwrap() == whole, "bands of {rows} rows");
        }
    }

    /// Bands of any height show the page, but for what is poured.
    #[test]
    fn bands_are_the_whole() {
        let mut table = [EdgeSlot::EMPTY; EDGES];
        let mut whole = vec![0; buffer_bytes::<Index4>(WIDTH, HEIGHT)];
        let mut frame = Framebuffer::<Index4>::new(&mut whole, WIDTH, HEIGHT).unwrap();
        page::draw(&mut frame, &mut table, index::<Index4>).unwrap();
        for rows in [1, 7, 64, 239, 240] {
            assert!(drawn(Some(rows), index::<Index4>).unwrap() == whole, "bands of {rows} rows");
        }
    }
}
