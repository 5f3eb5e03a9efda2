//! embedded-graphics on our surfaces, and our shapes on its targets, compared with its own framebuffer pixel by pixel.

use std::fmt::Debug;

use embedded_graphics::{
    framebuffer::{buffer_size, Framebuffer as TheirFramebuffer},
    image::{GetPixel, Image},
    mono_font::{ascii::FONT_6X10, MonoTextStyle, MonoTextStyleBuilder},
    pixelcolor::{
        raw::{LittleEndian, RawU1, RawU16, RawU2, RawU24, RawU32, RawU4, RawU8},
        BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb888,
    },
    prelude::*,
    primitives::{Circle, PrimitiveStyle, Rectangle},
    text::Text,
};
use embedded_raster::{
    eg::{self, draw_on, recolored},
    pixel::{Be, Lsb0, Rgb332, Xrgb8888, EGA},
    surface::Paged,
    Canvas, EdgeSlot, FillRule, Framebuffer, Index1, Index2, Index4, Index8, PixelFormat, PointFx, Rect, Surface,
};
use embedded_text::{
    alignment::{HorizontalAlignment, VerticalAlignment},
    style::TextBoxStyleBuilder,
    TextBox,
};
use tinybmp::Bmp;
use u8g2_fonts::{
    fonts::{u8g2_font_6x12_mr, u8g2_font_helvB08_tr},
    types::{FontColor, VerticalPosition},
    FontRenderer,
};

const WIDTH: u16 = 61;
const HEIGHT: u16 = 40;

/// Draws with `$draw` into embedded-graphics' framebuffer and into ours: no pixel and no byte may differ.
macro_rules! same_in_both {
    ($($draw:ident in $color:ty as $raw:ty;)*) => {
        $({
            const BYTES: usize = buffer_size::<$color>(WIDTH as usize, HEIGHT as usize);
            let mut theirs =
                TheirFramebuffer::<$color, $raw, LittleEndian, { WIDTH as usize }, { HEIGHT as usize }, BYTES>::new();
            let mut ram = [0; BYTES];
            let mut ours = Framebuffer::<$color>::new(&mut ram, WIDTH, HEIGHT).expect("it has the bytes that it needs");
            $draw(&mut theirs).expect("memory takes everything");
            $draw(&mut ours).expect("memory takes everything");
            let what = concat!(stringify!($draw), " in ", stringify!($color));
            assert_same(&theirs, &ours, what);
            assert_eq!(theirs.data()[..], ram[..], "bytes of {what}");
        })*
    };
}

/// Compares all pixels, and that some were drawn.
fn assert_same<C: PixelColor + Debug>(
    theirs: &(impl GetPixel<Color = C> + OriginDimensions),
    ours: &(impl GetPixel<Color = C> + OriginDimensions),
    what: &str,
) {
    assert_eq!(theirs.size(), ours.size(), "sizes of {what}");
    let area = Rectangle::new(Point::zero(), ours.size());
    for p in area.points() {
        assert_eq!(ours.pixel(p), theirs.pixel(p), "{what} at {p}");
    }
    let first = ours.pixel(Point::zero());
    assert!(area.points().any(|p| ours.pixel(p) != first), "{what} drew nothing");
}

/// The lightest and another colour of a target, made from RGB.
fn colors<C: From<Rgb888>>() -> (C, C) {
    (Rgb888::WHITE.into(), Rgb888::new(0xaa, 0x55, 0x00).into())
}

fn mono_text<D: DrawTarget<Color: From<Rgb888>>>(target: &mut D) -> Result<(), D::Error> {
    let (light, other) = colors::<D::Color>();
    let plain = MonoTextStyle::new(&FONT_6X10, light);
    let inverse = MonoTextStyleBuilder::new().font(&FONT_6X10).text_color(light).background_color(other).build();
    Text::new("Quick fox\njumps over", Point::new(-2, 9), plain).draw(target)?;
    Text::new("lazy dogs", Point::new(15, 33), inverse).draw(target)?;
    Text::new("off", Point::new(50, 45), inverse).draw(target)?;
    Ok(())
}

#[expect(clippy::unnecessary_wraps, reason = "as the others that are drawn in both")]
fn u8g2_text<D: DrawTarget<Color: From<Rgb888>, Error: Debug>>(target: &mut D) -> Result<(), D::Error> {
    let (narrow, fixed) = (FontRenderer::new::<u8g2_font_helvB08_tr>(), FontRenderer::new::<u8g2_font_6x12_mr>());
    let (light, other) = colors::<D::Color>();
    let inverse = FontColor::WithBackground { fg: light, bg: other };
    for (font, text, at, color) in [
        (&narrow, "Hamburgefons", Point::new(-4, 3), FontColor::Transparent(light)),
        (&fixed, "Qwertz 17", Point::new(9, 17), inverse),
        (&narrow, "below", Point::new(40, 34), FontColor::Transparent(other)),
    ] {
        font.render(text, at, VerticalPosition::Top, color, target).expect("the font has these letters");
    }
    Ok(())
}

/// A text that is wrapped, in a box that leaves the screen on three sides.
fn text_box<D: DrawTarget<Color: From<Rgb888>>>(target: &mut D) -> Result<(), D::Error> {
    let (light, other) = colors::<D::Color>();
    let inverse = MonoTextStyleBuilder::new().font(&FONT_6X10).text_color(light).background_color(other).build();
    let plain = MonoTextStyle::new(&FONT_6X10, light);
    let area = |x, y, width, height| Rectangle::new(Point::new(x, y), Size::new(width, height));
    let justified = TextBoxStyleBuilder::new().alignment(HorizontalAlignment::Justified).build();
    TextBox::with_textbox_style("Quick fox is on\nit", area(-3, -4, 52, 30), plain, justified).draw(target)?;
    let low = TextBoxStyleBuilder::new()
        .alignment(HorizontalAlignment::Right)
        .vertical_alignment(VerticalAlignment::Bottom)
        .build();
    TextBox::with_textbox_style("and on a ground", area(20, 18, 45, 24), inverse, low).draw(target)?;
    Ok(())
}

fn images<D>(target: &mut D) -> Result<(), D::Error>
where
    D: DrawTarget<Color: From<Rgb555> + From<Rgb565> + From<Rgb888>>,
{
    for (file, at) in [
        (&include_bytes!("assets/boat-4.bmp")[..], Point::new(2, 3)),
        (&include_bytes!("assets/boat-24.bmp")[..], Point::new(45, 11)),
        (&include_bytes!("assets/boat-24.bmp")[..], Point::new(-9, 30)),
    ] {
        let image = Bmp::<D::Color>::from_slice(file).expect("a picture");
        Image::new(&image, at).draw(target)?;
    }
    Ok(())
}

fn primitives<D: DrawTarget<Color: From<Rgb888>>>(target: &mut D) -> Result<(), D::Error> {
    let (light, other) = colors::<D::Color>();
    target.clear(other)?;
    Circle::new(Point::new(-5, -5), 40).into_styled(PrimitiveStyle::with_fill(light)).draw(target)?;
    Rectangle::new(Point::new(20, 10), Size::new(60, 9)).into_styled(PrimitiveStyle::with_stroke(light, 3)).draw(target)
}

#[test]
fn text_is_the_same_in_both() {
    same_in_both! {
        mono_text in Index1 as RawU1;
        mono_text in Index2 as RawU2;
        mono_text in Index4 as RawU4;
        mono_text in Index8 as RawU8;
        mono_text in Rgb332 as RawU8;
        mono_text in Rgb565 as RawU16;
        mono_text in Rgb888 as RawU24;
        mono_text in Xrgb8888 as RawU32;
        u8g2_text in Index1 as RawU1;
        u8g2_text in Index2 as RawU2;
        u8g2_text in Index4 as RawU4;
        u8g2_text in Index8 as RawU8;
        u8g2_text in Rgb565 as RawU16;
        text_box in Index1 as RawU1;
        text_box in Index2 as RawU2;
        text_box in Index4 as RawU4;
        text_box in Rgb565 as RawU16;
        text_box in Rgb888 as RawU24;
    }
}

#[test]
fn images_and_primitives_are_the_same_in_both() {
    same_in_both! {
        images in Index1 as RawU1;
        images in Index2 as RawU2;
        images in Index4 as RawU4;
        images in Index8 as RawU8;
        images in Rgb555 as RawU16;
        images in Rgb888 as RawU24;
        images in Xrgb8888 as RawU32;
        primitives in Index1 as RawU1;
        primitives in Index4 as RawU4;
        primitives in Gray2 as RawU2;
        primitives in Gray4 as RawU4;
        primitives in Gray8 as RawU8;
        primitives in Rgb888 as RawU24;
    }
}

#[test]
fn pages_take_text_and_images() {
    const BYTES: usize = buffer_size::<Index1>(61, 40);
    let mut ram = [0; 61 * 5];
    let mut pages = Paged::<Index1>::new(&mut ram, 61, 40).expect("five pages");
    let mut theirs = TheirFramebuffer::<Index1, RawU1, LittleEndian, 61, 40, BYTES>::new();
    images(&mut pages).and(mono_text(&mut pages)).expect("memory takes everything");
    images(&mut theirs).and(mono_text(&mut theirs)).expect("memory takes everything");
    assert_same(&theirs, &pages, "text and images");
}

#[test]
fn an_image_through_a_palette_of_its_own() {
    let image = Bmp::<Rgb888>::from_slice(include_bytes!("assets/boat-24.bmp")).expect("a picture");
    let mut ram = [0; 12 * 16];
    let mut frame = Framebuffer::<Index4>::new(&mut ram, 24, 16).expect("it has the bytes that it needs");
    let mut calls = recolored(&mut frame, |color| Index4::new(EGA.nearest(color)));
    Image::new(&image, Point::zero()).draw(&mut calls).expect("memory takes everything");
    for Pixel(p, color) in image.pixels() {
        assert_eq!(frame.get(p).map(Index4::index), Some(EGA.nearest(color)), "at {p}");
    }
}

/// Numbers that are skipped in no time, as a fill from far outside needs. Asking again after the end is an error.
struct Colors<C> {
    next: u64,
    end: u64,
    over: bool,
    color: fn(u64) -> C,
}

impl<C> Iterator for Colors<C> {
    type Item = C;

    fn next(&mut self) -> Option<C> {
        self.nth(0)
    }

    fn nth(&mut self, n: usize) -> Option<C> {
        assert!(!self.over, "asked after the end");
        let at = self.next.saturating_add(n as u64);
        self.next = at.saturating_add(1);
        self.over = at >= self.end;
        (!self.over).then(|| (self.color)(at))
    }
}

/// The pixel of `p` within an area counted row by row; `None` outside. In wide numbers: areas may end beyond i32.
fn place(area: Rectangle, p: Point) -> Option<u64> {
    let column = u64::try_from(i64::from(p.x) - i64::from(area.top_left.x)).ok()?;
    let row = u64::try_from(i64::from(p.y) - i64::from(area.top_left.y)).ok()?;
    let (width, height) = (u64::from(area.size.width), u64::from(area.size.height));
    (column < width && row < height).then(|| row * width + column)
}

/// Areas inside, across and around a screen of 61 x 40, empty ones, and ones at the ends of i32.
fn areas() -> Vec<Rectangle> {
    let starts = [i32::MIN, -1_000_000, -70, -9, -1, 0, 1, 7, 8, 30, 39, 60, 61, 1000, i32::MAX];
    let sizes = [0, 1, 2, 9, 33, 80, 1_000_100, 1 << 31, u32::MAX];
    let mut areas = vec![];
    for (i, x) in starts.into_iter().enumerate() {
        for (j, width) in sizes.into_iter().enumerate() {
            // Each column range with three row ranges; all pairs of starts and of sizes occur.
            for k in 0..3 {
                let (y, height) = (starts[(i + j + 5 * k) % starts.len()], sizes[(i + 2 * j + 4 * k) % sizes.len()]);
                areas.push(Rectangle::new(Point::new(x, y), Size::new(width, height)));
            }
        }
    }
    areas
}

/// Checks what `draw` does to each pixel of a target that shows `window` of a screen.
fn check_pixels<D: DrawTarget<Color: PartialEq + Debug, Error: Debug> + GetPixel<Color = <D as DrawTarget>::Color>>(
    target: &mut D,
    window: Rect,
    what: &str,
    color: fn(u64) -> <D as DrawTarget>::Color,
) {
    let screen = Rectangle::new(Point::new(-3, -3), Size::new(67, 46));
    let ground = color(1);
    let expect =
        |target: &D, area: Rectangle, call: &str, wanted: &dyn Fn(Point) -> Option<<D as DrawTarget>::Color>| {
            for p in screen.points() {
                let wanted = window.contains(p.x, p.y).then(|| wanted(p).unwrap_or(ground));
                assert_eq!(target.pixel(p), wanted, "{what}: {call} {area:?} at {p}");
            }
        };
    for area in areas() {
        target.clear(ground).expect("memory takes everything");
        expect(target, area, "clear", &|_| None);
        target.fill_solid(&area, color(0)).expect("memory takes everything");
        expect(target, area, "fill_solid", &|p| place(area, p).map(|_| color(0)));

        let all = u64::from(area.size.width) * u64::from(area.size.height);
        for end in [0, 1, 100, all / 2, all, u64::MAX] {
            target.clear(ground).expect("memory takes everything");
            let colors = Colors { next: 0, end, over: false, color };
            target.fill_contiguous(&area, colors).expect("memory takes everything");
            let call = format!("fill_contiguous of {end}");
            expect(target, area, &call, &|p| place(area, p).filter(|&at| at < end).map(color));
        }
    }
}

/// Calls that say one pixel at a time.
fn check_draw_iter<
    D: DrawTarget<Color: PartialEq + Debug, Error: Debug> + GetPixel<Color = <D as DrawTarget>::Color>,
>(
    target: &mut D,
    color: fn(u64) -> <D as DrawTarget>::Color,
) {
    let coordinates = [i32::MIN, -1, 0, 1, 7, 38, 39, 40, 60, 61, i32::MAX];
    let points = || coordinates.into_iter().flat_map(move |x| coordinates.map(|y| Point::new(x, y)));
    target.clear(color(1)).expect("memory takes everything");
    target.draw_iter(points().map(|p| Pixel(p, color(0)))).expect("memory takes everything");
    let painted =
        Rectangle::new(Point::zero(), Size::new(61, 40)).points().filter(|&p| target.pixel(p) == Some(color(0)));
    let expected = points().filter(|p| (0..61).contains(&p.x) && (0..40).contains(&p.y));
    assert_eq!(painted.count(), expected.clone().count(), "pixels");
    assert!(expected.into_iter().all(|p| target.pixel(p) == Some(color(0))), "all that lie inside");
}

/// In a whole screen, in a band, in a part, and in a view of an odd pixel.
fn check_overrides<F: PixelFormat<Color: PartialEq + Debug>>(color: fn(u64) -> F::Color) {
    let mut ram = vec![0; 61 * 40 * 4];
    let mut whole = Framebuffer::<F>::new(&mut ram, 61, 40).expect("four bytes a pixel are enough");
    check_pixels(&mut whole, Rect::new(0, 0, 61, 40), "screen", color);
    check_draw_iter(&mut whole, color);
    let window = Rect::new(7, 3, 30, 38);
    check_pixels(&mut whole.clipped(window), window, "part", color);
    let mut view = whole.view(Rect::new(5, 4, 38, 50));
    check_pixels(&mut view, Rect::new(0, 0, 33, 36), "view", color);
    let mut band = Framebuffer::<F>::band(&mut ram, 61, 40, 8..23).expect("four bytes a pixel are enough");
    check_pixels(&mut band, Rect::new(0, 8, 61, 23), "band", color);
}

fn low(n: u64) -> u8 {
    n.wrapping_mul(37).to_le_bytes()[0]
}

#[test]
fn fills_of_packed_pixels_are_those_of_single_pixels() {
    check_overrides::<Index1>(|n| Index1::new(low(n)));
    check_overrides::<Lsb0<Index2>>(|n| Index2::new(low(n)));
    check_overrides::<Index4>(|n| Index4::new(low(n)));
}

#[test]
fn fills_of_whole_bytes_are_those_of_single_pixels() {
    check_overrides::<Index8>(|n| Index8::new(low(n)));
    check_overrides::<Be<Rgb565>>(|n| Rgb565::new(low(n), low(n + 1), low(n + 2)));
    check_overrides::<Rgb888>(|n| Rgb888::new(low(n), low(n + 1), low(n + 2)));
    check_overrides::<Xrgb8888>(|n| Xrgb8888::new(low(n), low(n + 1), low(n + 2)));
}

#[test]
fn fills_of_pages_are_those_of_single_pixels() {
    let color = |n| BinaryColor::from(low(n) & 1 != 0);
    let mut ram = [0; 61 * 5];
    let mut pages = Paged::<BinaryColor>::new(&mut ram, 61, 40).expect("five pages");
    check_pixels(&mut pages, Rect::new(0, 0, 61, 40), "pages", color);
    check_draw_iter(&mut pages, color);
    let window = Rect::new(7, 3, 30, 38);
    check_pixels(&mut pages.clipped(window), window, "part of pages", color);
}

/// Every shape there is, partly outside.
fn shapes<S: Surface<Color = Index4>>(surface: &mut S) {
    let color = Index4::new;
    let mut table = [EdgeSlot::EMPTY; 8];
    surface.fill_window(color(1));
    surface.fill_area(Rect::new(50, 30, i32::MAX, i32::MAX), color(2));
    surface.fill_rectangle_fx(PointFx::from_bits(700, 900), PointFx::from_bits(4000, 2000), color(3));
    surface.fill_triangle_fx([PointFx::px(-9, 20), PointFx::px(30, -5), PointFx::px(70, 60)], color(4));
    let star = [(30, 2), (42, 38), (11, 15), (49, 15), (18, 38)].map(|(x, y)| PointFx::px(x, y));
    surface.fill_polygon_fx(&star, FillRule::EvenOdd, &mut table, color(5)).expect("eight edges are enough");
    let inner = [(2, 25), (9, 25), (9, 36), (2, 36)].map(|(x, y)| PointFx::px(x, y));
    let outer = [(0, 22), (12, 22), (12, 70), (0, 70)].map(|(x, y)| PointFx::px(x, y));
    surface.fill_contours_fx([outer, inner], FillRule::EvenOdd, &mut table, color(6)).expect("eight edges are enough");
    surface.draw_line(Point::new(-1000, -700), Point::new(1000, 730), color(7));
    surface.draw_line(Point::new(40, 3), Point::new(44, 300), color(8));
    surface.draw_polyline([(3, 3), (58, 8), (55, 37), (3, 3)].map(Point::from), color(9));
    surface.draw_point_fx(PointFx::from_bits(15_000, 9_000), color(10));
    surface.draw_point_fx(PointFx::px(-1, 0), color(11));
}

#[test]
fn shapes_on_another_target_are_those_on_ours() {
    const BYTES: usize = buffer_size::<Index4>(61, 40);
    let mut ram = [0; 31 * 40];
    let mut ours = Framebuffer::<Index4>::new(&mut ram, WIDTH, HEIGHT).expect("it has the bytes that it needs");
    shapes(&mut ours);
    let mut theirs = TheirFramebuffer::<Index4, RawU4, LittleEndian, 61, 40, BYTES>::new();
    draw_on(&mut theirs, |canvas| shapes(canvas)).expect("memory takes everything");
    assert_same(&theirs, &ours, "shapes");

    // A part of a target: its window is that part.
    let part = Rectangle::new(Point::new(9, 4), Size::new(33, 21));
    ours.clear(Index4::new(15));
    shapes(&mut ours.clipped(part));
    DrawTarget::clear(&mut theirs, Index4::new(15)).expect("memory takes everything");
    draw_on(&mut theirs.clipped(&part), |canvas| shapes(canvas)).expect("memory takes everything");
    assert_same(&theirs, &ours, "shapes in a part");

    // A target with its origin elsewhere.
    let shift = Point::new(-5, 7);
    draw_on(&mut theirs.translated(shift), |canvas| {
        canvas.draw_line(Point::new(5, -7), Point::new(9, -5), Index4::new(12));
    })
    .expect("memory takes everything");
    assert_eq!(theirs.pixel(Point::new(4, 2)), Some(Index4::new(12)), "translated");
}

/// A display that fails after some calls and counts those it gets.
struct Flaky {
    calls: u32,
    good: u32,
}

impl OriginDimensions for Flaky {
    fn size(&self) -> Size {
        Size::new(61, 40)
    }
}

impl DrawTarget for Flaky {
    type Color = Index4;
    type Error = u32;

    fn draw_iter<I: IntoIterator<Item = Pixel<Index4>>>(&mut self, _: I) -> Result<(), u32> {
        self.calls += 1;
        if self.calls > self.good {
            return Err(self.calls);
        }
        Ok(())
    }
}

#[test]
fn the_first_error_of_a_target_is_passed_on() {
    let mut perfect = Flaky { calls: 0, good: u32::MAX };
    assert_eq!(draw_on(&mut perfect, |canvas| shapes(canvas)), Ok(()), "no error");
    assert!(perfect.calls > 100, "most spans are calls");
    for good in 0..perfect.calls {
        let mut flaky = Flaky { calls: 0, good };
        assert_eq!(draw_on(&mut flaky, |canvas| shapes(canvas)), Err(good + 1), "the first error");
        assert_eq!(flaky.calls, good + 1, "no call after it");
    }
    // Translated colours pass errors on too.
    for good in 0..3 {
        let mut flaky = Flaky { calls: 0, good };
        let mut target = recolored(&mut flaky, |color: Rgb888| Index4::from(color));
        let calls = target
            .clear(Rgb888::WHITE)
            .and_then(|()| target.fill_solid(&Rectangle::new(Point::zero(), Size::new(3, 3)), Rgb888::RED))
            .and_then(|()| target.draw_iter([Pixel(Point::zero(), Rgb888::RED)]));
        assert_eq!(calls, Err(good + 1), "the first error");
    }
}

const GRAY: Gray8 = Gray8::new(0x5a);

/// A target that claims to be as large as any, and counts what it is asked for.
struct Claim {
    calls: usize,
    pixels: u64,
}

impl OriginDimensions for Claim {
    fn size(&self) -> Size {
        Size::new(65_535, 65_535)
    }
}

impl DrawTarget for Claim {
    type Color = Gray8;
    type Error = std::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray8>>>(&mut self, _: I) -> Result<(), Self::Error> {
        panic!("all is filled")
    }

    fn fill_solid(&mut self, area: &Rectangle, _: Gray8) -> Result<(), Self::Error> {
        self.calls += 1;
        self.pixels += u64::from(area.size.width) * u64::from(area.size.height);
        Ok(())
    }
}

/// What a target claims to have is not walked row by row where one call says it all. Other shapes send a call for each of their
/// own rows, at most.
#[test]
fn calls_to_a_target_depend_on_the_shape() {
    type Draw = fn(&mut eg::Target<'_, Claim>, &mut [EdgeSlot]);
    let draws: [(&str, usize, u64, Draw); 10] = [
        ("window", 1, 65_535 * 65_535, |on, _| on.fill_window(GRAY)),
        ("rectangle", 1, 65_525 * 9, |on, _| on.fill_rectangle(Rect::new(-5, 10, 9, 99_999), GRAY)),
        ("column", 1, 65_535, |on, _| on.draw_line(Point::new(7, -9), Point::new(7, i32::MAX), GRAY)),
        ("row", 1, 65_535, |on, _| on.draw_line(Point::new(-7, 9), Point::new(i32::MAX, 9), GRAY)),
        ("steep line", 4, 65_535, |on, _| on.draw_line(Point::new(5, 0), Point::new(8, 65_534), GRAY)),
        ("tall box", 4, 2 * 65_535 + 2 * 4, |on, _| on.draw_rectangle(Rect::new(3, 0, 9, 65_535), GRAY)),
        ("tall polygon", 1, 65_535 * 70, |on, table| {
            let tall = [(30, -9), (100, -9), (100, 99_999), (30, 99_999)].map(|(x, y)| Point::new(x, y));
            on.fill_polygon(&tall, FillRule::EvenOdd, table, GRAY).expect("enough slots");
        }),
        ("tall rounded", 2 * 20 + 1, 65_000 * 60 - 4 * 84, |on, _| {
            on.fill_rounded(Rect::new(9, 100, 69, 65_100), 20.into(), GRAY);
        }),
        ("low triangle", 8, 8 * 60_000 - 4 * 60_000, |on, _| {
            on.fill_triangle_fx([PointFx::px(0, 0), PointFx::px(60_000, 0), PointFx::px(0, 8)], GRAY);
        }),
        ("far away", 0, 0, |on, _| on.fill_triangle([(-9, -9), (-9, 99_999), (-50, 7)].map(Point::from), GRAY)),
    ];
    for (name, calls, pixels, draw) in draws {
        let mut claim = Claim { calls: 0, pixels: 0 };
        let mut table = [EdgeSlot::EMPTY; 4];
        draw_on(&mut claim, |canvas| draw(canvas, &mut table)).expect("it takes everything");
        assert!(claim.calls <= calls, "{name}: {} calls", claim.calls);
        assert_eq!(claim.pixels, pixels, "{name}");
    }
    // What follows is not mixed up: other columns, another colour, a row between.
    let mut claim = Claim { calls: 0, pixels: 0 };
    draw_on(&mut claim, |canvas| {
        for (y, x1, color) in [(0, 9, 1), (1, 9, 1), (2, 8, 1), (3, 8, 2), (5, 8, 2), (5, 8, 2)] {
            canvas.fill_rectangle(Rect::new(0, y, x1, y + 1), Gray8::new(color));
        }
    })
    .expect("it takes everything");
    assert_eq!((claim.calls, claim.pixels), (5, 9 + 9 + 4 * 8));
}

#[test]
fn a_result_comes_back_from_the_closure() {
    let mut display = Flaky { calls: 0, good: u32::MAX };
    let full = draw_on(&mut display, |canvas| {
        let square = [(0, 0), (9, 0), (9, 9), (0, 9)].map(|(x, y)| PointFx::px(x, y));
        canvas.fill_polygon_fx(&square, FillRule::NonZero, &mut [EdgeSlot::EMPTY; 1], Index4::new(3))
    });
    let expected = embedded_raster::EdgeTableFull { capacity: 1, needed: 2, row: 0, enough: 2 };
    assert_eq!((full, display.calls), (Ok(Err(expected)), 0), "the table is full before anything is painted");
}
