//! Lines of glyphs against their pixels.

use embedded_graphics::{
    mono_font::{ascii, MonoFont, MonoTextStyleBuilder},
    prelude::*,
    text::{Alignment, Baseline, Text, TextStyleBuilder},
};
use embedded_graphics_core::pixelcolor::{BinaryColor, Gray2, Gray8, Rgb565, Rgb888};
use embedded_raster::{
    buffer_bytes,
    eg::draw_on,
    pixel::{Be, Lsb0, Rgb444, Xrgb8888},
    surface::{Grid, Packed12, Pages, Planes, Rows},
    text::{Font, Horizontal, Style, Vertical, FONT_6X10, FONT_8X13},
    Frame, Framebuffer, Index1, Index2, Index4, Index8, Layout, PixelFormat, Rect, Surface,
};
use twins::{
    input::Input,
    rng::{cases, Rng},
    texts::{text, Letters, Setting},
    watched::Watched,
};

const WIDTH: u16 = 61;
const HEIGHT: u16 = 47;

/// Random text, in random fonts, in clipped frames: whole, through a wrapper that knows spans only, and in bands.
fn check<L: Layout, F: PixelFormat<Color = L::Color>>(seed: u64) {
    let mut rng = Rng::new(seed);
    let grid = Grid { stride: L::row_bytes(WIDTH), rows: HEIGHT.into() };
    let needed = L::bytes(WIDTH, grid);
    for round in 0..cases(700) {
        let bytes: Vec<u8> = (0..900).map(|_| rng.bits() as u8).collect();
        let mut input = Input(&bytes);
        let (letters, setting, text) = (Letters::of(&mut input), Setting::of(&mut input), text(&mut input));
        let bytes = letters.bytes();
        let font = Font::read(&bytes).expect("a font");
        let at = Point::new(rng.int(-20, 60), rng.int(-20, 60));
        let clip = if rng.one_in(2) {
            Rect::new(0, 0, WIDTH.into(), HEIGHT.into())
        } else {
            Rect::new(rng.int(0, 30), rng.int(0, 20), rng.int(20, 61), rng.int(15, 47))
        };
        let [color, ground] = [0, 1].map(|_| F::unpack(rng.bits() as u32 & (u32::MAX >> (32 - F::BITS))));
        let style = setting.style(&font, color, ground);

        let before: Vec<u8> = (0..needed).map(|_| rng.bits() as u8).collect();
        let mut wanted = before.clone();
        let mut frame = Frame::<_, L>::new(&mut wanted[..], WIDTH, HEIGHT).expect("the right size");
        for ((x, y), is_set) in letters.pixels(&setting, at, &text) {
            let p = Point::new(i32::try_from(x).expect("near"), i32::try_from(y).expect("near"));
            frame.clipped(clip).set(p, if is_set { color } else { ground });
        }

        let what = || format!("round {round}: {text:?} at {at} in {clip:?}, {setting:?}, {letters:?}");
        let mut got = before.clone();
        let mut frame = Frame::<_, L>::new(&mut got[..], WIDTH, HEIGHT).expect("the right size");
        style.draw(&mut frame.clipped(clip), at, &text);
        assert!(got == wanted, "{}", what());

        let mut got = before.clone();
        let mut frame = Frame::<_, L>::new(&mut got[..], WIDTH, HEIGHT).expect("the right size");
        style.draw(&mut Watched::new(frame.clipped(clip)), at, &text);
        assert!(got == wanted, "by spans, {}", what());

        let whole = Frame::<_, L>::new(&wanted[..], WIDTH, HEIGHT).expect("the right size").clipped(clip);
        for rows in [8, 24] {
            for start in (0..HEIGHT).step_by(rows) {
                let end = HEIGHT.min(start + rows as u16);
                let mut ram = vec![0; needed];
                let mut band = Frame::<_, L>::band(&mut ram[..], WIDTH, HEIGHT, start..end).expect("whole pages");
                let old = Frame::<_, L>::new(&before[..], WIDTH, HEIGHT).expect("the right size");
                let lines = Rect::new(0, start.into(), WIDTH.into(), end.into());
                for p in pixels(lines) {
                    band.set(p, old.get(p).expect("inside"));
                }
                style.draw(&mut band.clipped(clip), at, &text);
                assert!(pixels(lines.intersection(clip)).all(|p| band.get(p) == whole.get(p)), "in bands, {}", what());
            }
        }
    }
}

fn pixels(area: Rect) -> impl Iterator<Item = Point> {
    (area.y0..area.y1).flat_map(move |y| (area.x0..area.x1).map(move |x| Point::new(x, y)))
}

macro_rules! layouts {
    ($($name:ident: $layout:ty, $format:ty, $seed:literal;)*) => {$(
        #[test]
        fn $name() {
            check::<$layout, $format>($seed);
        }
    )*};
}

layouts! {
    index1: Rows<Index1>, Index1, 1_600;
    index1_lsb0: Rows<Lsb0<Index1>>, Index1, 1_601;
    index2: Rows<Index2>, Index2, 1_602;
    gray2_lsb0: Rows<Lsb0<Gray2>>, Gray2, 1_603;
    index4: Rows<Index4>, Index4, 1_604;
    index4_lsb0: Rows<Lsb0<Index4>>, Index4, 1_605;
    index8: Rows<Index8>, Index8, 1_606;
    rgb565: Rows<Rgb565>, Rgb565, 1_607;
    rgb565_be: Rows<Be<Rgb565>>, Rgb565, 1_608;
    rgb888: Rows<Rgb888>, Rgb888, 1_609;
    xrgb8888: Rows<Xrgb8888>, Xrgb8888, 1_610;
    pages: Pages<Index1>, Index1, 1_611;
    pages_lsb0: Pages<Lsb0<BinaryColor>>, BinaryColor, 1_612;
    planes: Planes<Index2>, Index2, 1_613;
    planes_lsb0: Planes<Lsb0<Gray2>>, Gray2, 1_614;
    packed12: Packed12, Rgb444, 1_615;
}

/// Two fonts that are the same fonts there.
fn as_in_embedded_graphics(font: &Font<'_>, theirs: &MonoFont<'_>) {
    let texts = ["The quick brown fox", "jumps over\nthe lazy dog", "(){}[]<>|\\/~^`'\"", "\u{df}?", "", "gjpqy,;"];
    let alignments = [
        (Horizontal::Left, Alignment::Left),
        (Horizontal::Center, Alignment::Center),
        (Horizontal::Right, Alignment::Right),
    ];
    let baselines = [
        (Vertical::Baseline, Baseline::Alphabetic),
        (Vertical::Top, Baseline::Top),
        (Vertical::Middle, Baseline::Middle),
        (Vertical::Bottom, Baseline::Bottom),
    ];
    let all: String = (' '..='~').collect();
    let chars: Vec<String> = all.chars().collect::<Vec<_>>().chunks(12).map(|part| part.iter().collect()).collect();
    for text in texts.into_iter().chain(chars.iter().map(String::as_str)) {
        for (horizontal, alignment) in alignments {
            for (vertical, baseline) in baselines {
                // There, a block of lines has the baseline, the middle or the bottom of its first line.
                if text.contains('\n') && matches!(vertical, Vertical::Middle | Vertical::Bottom) {
                    continue;
                }
                for opaque in [false, true] {
                    let at = Point::new(70, 23);
                    let [mut ours, mut other] = [(); 2].map(|()| vec![0; buffer_bytes::<Gray8>(150, 50)]);
                    let style = Style::new(font, Gray8::new(200)).horizontal(horizontal).vertical(vertical);
                    let style = if opaque { style.opaque(Gray8::new(80)) } else { style };
                    let mut frame = Framebuffer::<Gray8>::new(&mut ours, 150, 50).expect("the right size");
                    style.draw(&mut frame, at, text);
                    let mut frame = Framebuffer::<Gray8>::new(&mut other, 150, 50).expect("the right size");
                    let letters = MonoTextStyleBuilder::new().font(theirs).text_color(Gray8::new(200));
                    let letters = if opaque { letters.background_color(Gray8::new(80)) } else { letters }.build();
                    let place = TextStyleBuilder::new().alignment(alignment).baseline(baseline).build();
                    let Ok(_) = Text::with_text_style(text, at, letters, place).draw(&mut frame);
                    assert!(ours == other, "{text:?}, {horizontal:?}, {vertical:?}, opaque: {opaque}");
                }
            }
        }
    }
}

#[test]
fn the_fonts_draw_what_embedded_graphics_draws() {
    as_in_embedded_graphics(&FONT_6X10, &ascii::FONT_6X10);
    as_in_embedded_graphics(&FONT_8X13, &ascii::FONT_8X13);
}

/// A display driver is sent runs, not pixels.
#[test]
fn a_draw_target_gets_runs() {
    struct Runs(Vec<(i32, i32, u32)>);
    impl Dimensions for Runs {
        fn bounding_box(&self) -> Rectangle {
            Rectangle::new(Point::zero(), Size::new(30, 20))
        }
    }
    impl DrawTarget for Runs {
        type Color = BinaryColor;
        type Error = core::convert::Infallible;
        fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, _: I) -> Result<(), Self::Error> {
            unreachable!("runs are areas")
        }
        fn fill_solid(&mut self, area: &Rectangle, _: BinaryColor) -> Result<(), Self::Error> {
            self.0.push((area.top_left.y, area.top_left.x, area.size.width));
            Ok(())
        }
    }
    use embedded_graphics::primitives::Rectangle;
    let mut runs = Runs(vec![]);
    let Ok(()) = draw_on(&mut runs, |surface| {
        Style::new(&FONT_6X10, BinaryColor::On).vertical(Vertical::Top).draw(surface, (0, 0), "=");
    });
    assert_eq!(runs.0, [(3, 0, 5), (5, 0, 5)]);
}

/// A line of millions of columns, of which the last letters are seen.
#[test]
fn a_line_may_be_longer_than_its_numbers() {
    let (before, seen) = ("A\t".repeat(100), "Ag");
    let style = Style::new(&FONT_8X13, Gray8::new(9)).opaque(Gray8::new(3)).tab(65_000);
    let [mut whole, mut end] = [(); 2].map(|()| vec![0; buffer_bytes::<Gray8>(40, 20)]);
    let mut frame = Framebuffer::<Gray8>::new(&mut end, 40, 20).expect("the right size");
    style.draw(&mut frame, (4, 12), &format!("\t{seen}"));
    assert!(frame.colors(frame.window()).all(|color| color == Gray8::new(0) || color == Gray8::new(3)), "a tab alone");
    frame.clear(Gray8::new(0));
    style.draw(&mut frame, (4, 12), seen);
    frame.fill_area(Rect::new(0, 2, 4, 15), Gray8::new(3));
    let text = format!("{before}{seen}");
    assert_eq!(style.size(&text), Size::new(6_500_016, 13));
    for style in [style, style.horizontal(Horizontal::Right)] {
        let x = if style == style.horizontal(Horizontal::Right) { 4 + 15 } else { 4 - 6_500_000 };
        whole.fill(0);
        let mut frame = Framebuffer::<Gray8>::new(&mut whole, 40, 20).expect("the right size");
        style.draw(&mut frame, (x, 12), &text);
        assert!(whole == end, "{x}");
    }
}
