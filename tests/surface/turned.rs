//! A turned drawing is the drawing, turned: all calls of the list, all eight ways; text and some shapes in every kind of layout.

use embedded_graphics_core::geometry::Point;
use embedded_graphics_core::pixelcolor::{BinaryColor, Gray2, Rgb565};
use embedded_raster::{
    pixel::{Lsb0, Rgb444},
    surface::{Packed12, Pages, Planes, Rows, Turn, Turned},
    text::Font,
    Bitmap, Canvas, Frame, Index1, Index4, Layout, PixelFormat, Readable, Rect, Surface,
};
use twins::{
    arguments::{Ground, Scratch},
    input::Input,
    rng::{cases, Rng},
    texts::{text, Letters, Setting},
};

const WIDTH: i32 = 23;
const HEIGHT: i32 = 16;

const TURNS: [Turn; 4] = [Turn::None, Turn::Quarter, Turn::Half, Turn::ThreeQuarters];

/// Columns and rows of a drawing that is turned onto the screen.
fn size(turn: Turn) -> (i32, i32) {
    match turn {
        Turn::None | Turn::Half => (WIDTH, HEIGHT),
        Turn::Quarter | Turn::ThreeQuarters => (HEIGHT, WIDTH),
    }
}

/// Where a pixel of a drawing falls, by the table of the documentation.
fn falls(turn: Turn, mirrored: bool, (x, y): (i32, i32)) -> (i32, i32) {
    let x = if mirrored { size(turn).0 - 1 - x } else { x };
    match turn {
        Turn::None => (x, y),
        Turn::Quarter => (WIDTH - 1 - y, x),
        Turn::Half => (WIDTH - 1 - x, HEIGHT - 1 - y),
        Turn::ThreeQuarters => (y, HEIGHT - 1 - x),
    }
}

fn memory<L: Layout>((width, height): (i32, i32)) -> (Vec<u8>, (u16, u16)) {
    let (width, height) = (width as u16, height as u16);
    let grid = embedded_raster::surface::Grid { stride: L::row_bytes(width), rows: height.into() };
    (vec![0; L::bytes(width, grid)], (width, height))
}

fn pixels(area: Rect) -> impl Iterator<Item = (i32, i32)> {
    (area.y0..area.y1).flat_map(move |y| (area.x0..area.x1).map(move |x| (x, y)))
}

/// A frame, and the same in a turned one.
type Pair<'a, 'b, 'c, L> = (&'a mut Frame<&'b mut [u8], L>, &'a mut Turned<'c, Frame<&'b mut [u8], L>>);

/// Does the same upright, and turned onto a clipped screen, which held other pixels before. What is done returns what both answer.
fn check<L: Layout, F: PixelFormat<Color = L::Color>>(
    rng: &mut Rng,
    what: &str,
    mut draw: impl FnMut(Pair<'_, '_, '_, L>, Rect) -> [usize; 2],
) {
    for turn in TURNS {
        for mirrored in [false, true] {
            let (upright_size, screen_size) = (size(turn), (WIDTH, HEIGHT));
            let (mut upright_ram, (width, height)) = memory::<L>(upright_size);
            let mut upright = Frame::<_, L>::new(&mut upright_ram[..], width, height).expect("the right size");
            let (mut screen_ram, (width, height)) = memory::<L>(screen_size);
            let mut screen = Frame::<_, L>::new(&mut screen_ram[..], width, height).expect("the right size");
            for p in pixels(Rect::new(0, 0, upright_size.0, upright_size.1)) {
                let color = F::unpack(rng.bits() as u32 & (u32::MAX >> (32 - F::BITS)));
                let color = if rng.one_in(2) { F::unpack(1) } else { color };
                upright.set(p.into(), color);
                screen.set(falls(turn, mirrored, p).into(), color);
            }
            let clip = if rng.one_in(2) {
                Rect::new(0, 0, WIDTH, HEIGHT)
            } else {
                Rect::new(rng.int(0, 9), rng.int(0, 6), rng.int(10, WIDTH), rng.int(7, HEIGHT))
            };
            let area = Rect::new(0, 0, WIDTH, HEIGHT);
            // What of the drawing falls into the clipped part.
            let seen = pixels(Rect::new(0, 0, upright_size.0, upright_size.1))
                .filter(|&p| {
                    let (x, y) = falls(turn, mirrored, p);
                    clip.contains(x, y)
                })
                .fold(Rect::default(), |seen, (x, y)| seen.union(Rect::new(x, y, x + 1, y + 1)));

            let mut clipped = screen.clipped(clip);
            let turned = Turned::of_area(&mut clipped, turn, area);
            let mut turned = if mirrored { turned.mirrored() } else { turned };
            assert_eq!(turned.window(), seen, "{turn:?}, mirrored: {mirrored}");
            let mut part = upright.clipped(seen);
            let [first, second] = draw((&mut part, &mut turned), seen);
            assert_eq!(first, second, "{what}: {turn:?} answers");
            for (x, y) in pixels(seen) {
                assert!(turned.color_at(x, y) == part.color_at(x, y), "{what}: ({x}, {y}) is read");
            }
            let whole = Rect::new(0, 0, upright_size.0, upright_size.1);
            for p in pixels(whole) {
                let (x, y) = falls(turn, mirrored, p);
                assert!(
                    screen.get((x, y)) == upright.get(p),
                    "{what}: {p:?} of {whole:?}, {turn:?}, mirrored: {mirrored}, in {clip:?}"
                );
            }
        }
    }
}

/// All calls of the list.
fn every_call<L: Layout, F: PixelFormat<Color = L::Color>>(seed: u64) {
    let (mut rng, mut scratch) = (Rng::new(seed), Scratch::new(seed));
    for number in 0..calls::COUNT {
        let name = calls::name(number);
        // A shortcut that a surface may have or not: called by itself, it tells which.
        if name == "Readable::fill_corridor" {
            continue;
        }
        for _ in 0..cases(20) {
            let bytes: Vec<u8> = (0..400).map(|_| rng.bits() as u8).collect();
            let colors = [0, 1].map(|_| F::unpack(rng.bits() as u32 & (u32::MAX >> (32 - F::BITS))));
            check::<L, F>(&mut rng, name, |(upright, turned), seen| {
                let mut arguments = scratch.arguments::<L>(&mut Input(&bytes), Ground::Near(seen), colors);
                let answers =
                    [calls::call(upright, &mut arguments, number), calls::call(turned, &mut arguments, number)];
                // How many slots a flood wants depends on its shortcuts.
                if name.contains("flood") {
                    [0; 2]
                } else {
                    answers
                }
            });
        }
    }
}

/// Shapes of each kind: spans, areas, steps, octants, pictures, and text in any font.
fn shapes<L: Layout, F: PixelFormat<Color = L::Color>>(seed: u64) {
    fn draw<S: Surface>(on: &mut S, [a, b, c]: [Point; 3], color: S::Color, mask: &Bitmap<'_, Index1>) {
        let side = (c.x - a.x).abs();
        let area = Rect::new(a.x, a.y, b.x, b.y);
        on.draw_line(a, b, color);
        on.fill_triangle([a, b, c], color);
        on.fill_rectangle(area.translate(7, 2), color);
        on.draw_ellipse(Rect::new(a.x, a.y, a.x + side, a.y + side), color);
        on.blit_mask(c, mask, color, None);
    }
    let mut rng = Rng::new(seed);
    let noise: Vec<u8> = (0..40).map(|_| rng.bits() as u8).collect();
    let mask = Bitmap::<Index1>::new(&noise, 14, 11).expect("enough bytes");
    for _ in 0..cases(200) {
        let bytes: Vec<u8> = (0..900).map(|_| rng.bits() as u8).collect();
        let mut input = Input(&bytes);
        let (letters, setting, text) = (Letters::of(&mut input), Setting::of(&mut input), text(&mut input));
        let bytes = letters.bytes();
        let font = Font::read(&bytes).expect("a font");
        let [color, ground] = [0, 1].map(|_| F::unpack(rng.bits() as u32 & (u32::MAX >> (32 - F::BITS))));
        let points = [(); 3].map(|()| Point::new(rng.int(-9, 25), rng.int(-9, 25)));
        let style = setting.style(&font, color, ground);
        check::<L, F>(&mut rng, "text", |(upright, turned), _| {
            style.draw(upright, points[0], &text);
            style.draw(turned, points[0], &text);
            [0; 2]
        });
        check::<L, F>(&mut rng, "shapes", |(upright, turned), _| {
            draw(upright, points, color, &mask);
            draw(turned, points, color, &mask);
            [0; 2]
        });
    }
}

#[test]
fn all_that_can_be_drawn_and_read() {
    every_call::<Rows<Index4>, Index4>(1_810);
}

macro_rules! layouts {
    ($($name:ident: $layout:ty, $format:ty, $seed:literal;)*) => {$(
        #[test]
        fn $name() {
            shapes::<$layout, $format>($seed);
        }
    )*};
}

layouts! {
    index1: Rows<Index1>, Index1, 1_800;
    index4_lsb0: Rows<Lsb0<Index4>>, Index4, 1_801;
    rgb565: Rows<Rgb565>, Rgb565, 1_802;
    pages: Pages<Lsb0<BinaryColor>>, BinaryColor, 1_803;
    planes: Planes<Gray2>, Gray2, 1_804;
    packed12: Packed12, Rgb444, 1_805;
}

/// Far away all sums are right modulo 2^32.
#[test]
fn windows_may_lie_anywhere() {
    use embedded_raster::surface::Counter;
    for area in [Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX), Rect::new(i32::MAX - 9, -4, i32::MAX, 5)] {
        for turn in TURNS {
            let mut counter = Counter::<Index1>::new(area);
            let mut turned = Turned::new(&mut counter, turn).mirrored();
            let window = turned.window();
            assert_eq!((window.x0, window.y0), (0, 0));
            turned.fill_rectangle(Rect::new(2, 1, 8, 4), Index1::new(1));
            turned.draw_line((i32::MIN, 7), (i32::MAX, 7), Index1::new(1));
            assert_eq!(counter.pixels, 18 + u64::from(window.width()), "{turn:?} of {area:?}");
        }
    }
}
