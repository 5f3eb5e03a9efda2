//! Masks and stencils against loops over all pixels: masks of every depth and layout, on frames of every kind, for shapes with hard and
//! with soft rims.

use embedded_graphics_core::pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, Rgb565, Rgb888};
use embedded_raster::{
    paint::{Cover, Dithered, Masked},
    pixel::{Be, Channels, Lsb0, Rgb444, Xrgb8888},
    raster::{coverage, triangle},
    surface::{Packed12, Pages, Planes, Rows, Stencil},
    Antialias, Canvas, Frame, Index1, Index2, Index4, Index8, Layout, Paint, PixelFormat, PointFx, Rect, Solid,
    Surface,
};
use twins::{
    coverage::Levels,
    relay::Relay,
    rng::{cases, Rng},
};

use crate::cover::{nearest, UnpackLow};

const SIZE: (u16, u16) = (45, 11);

fn window() -> Rect {
    Rect::new(0, 0, SIZE.0.into(), SIZE.1.into())
}

fn pixels() -> impl Iterator<Item = (i32, i32)> {
    (0..window().y1).flat_map(|y| (0..window().x1).map(move |x| (x, y)))
}

/// Frames of the same random bytes, runs of one byte among them.
fn frames<L: Layout, const N: usize>(rng: &mut Rng, (width, height): (u16, u16)) -> [Frame<Vec<u8>, L>; N] {
    let stride = L::row_bytes(width) + rng.index(3);
    // Planes and pages take more than rows do.
    let mut byte = 0;
    let memory: Vec<u8> = (0..2 * (stride + 1) * (usize::from(height) + 8))
        .map(|_| {
            if rng.one_in(3) {
                let any = rng.bits() as u8;
                byte = rng.pick(&[0, 255, any]);
            }
            byte
        })
        .collect();
    [(); N].map(|()| Frame::with_stride(memory.clone(), width, height, stride).expect("enough memory"))
}

/// The level of a pixel of a mask: its bits, of as many as there are.
fn level<L: Layout>(mask: &Frame<&[u8], L>, x: i32, y: i32) -> u8
where
    L::Color: PixelFormat<Color = L::Color>,
{
    let most = (1 << <L::Color as PixelFormat>::BITS) - 1;
    mask.get((x, y)).map_or(0, |color| (<L::Color as PixelFormat>::pack(color) * 255 / most) as u8)
}

fn dithered<C>(old: C, new: C, level: u8, (x, y): (i32, i32)) -> C {
    let threshold = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]][(y & 3) as usize][(x & 3) as usize];
    if i32::from(level) * 32 + (2 * threshold + 1) * 255 >= 32 * 255 {
        new
    } else {
        old
    }
}

/// What a paint makes of the old colour, by the level.
type Wanted<'a, C> = &'a dyn Fn(C, u8, (i32, i32)) -> C;

fn check<L: Layout, K: Layout>(
    rng: &mut Rng,
    paint: &(impl Paint<Frame<Vec<u8>, L>> + Clone),
    wanted: Wanted<'_, L::Color>,
) where
    K::Color: PixelFormat<Color = K::Color>,
{
    let name = std::any::type_name::<(L, K)>();
    let size = (rng.int(20, 50) as u16, rng.int(6, 14) as u16);
    let [mask] = frames::<K, 1>(rng, size);
    let mut clip = rng.pick(&[Rect::new(0, 0, 60, 20), Rect::new(3, 1, 40, 9)]);
    let mut mask = mask.as_bitmap().clipped(clip);
    if rng.one_in(2) {
        clip = Rect::new(rng.int(0, 9), rng.int(0, 3), 70, 20);
        mask = mask.view(clip);
    }
    let corners = [(); 3].map(|()| PointFx::from_bits(rng.int(-3_000, 15_000), rng.int(-900, 3_600)));
    let mut soft = Levels::new(window());
    coverage::triangle(corners, &mut [], window(), &mut soft);
    let mut hard = Levels::new(window());
    triangle::fill(corners, window(), &mut hard);
    let [before, first, second] = frames::<L, 3>(rng, SIZE);
    for (mut after, levels, is_soft) in [(first, soft, true), (second, hard, false)] {
        let paint = Masked::new(mask, paint.clone());
        if is_soft {
            after.paint(paint, |window, mut brush| coverage::triangle(corners, &mut [], window, Relay(&mut brush)));
        } else {
            after.paint(paint, |window, mut brush| triangle::fill(corners, window, Relay(&mut brush)));
        }
        for (x, y) in pixels() {
            let (old, got) = (before.get((x, y)).expect("a pixel"), after.get((x, y)).expect("a pixel"));
            let (covered, through) = (levels.at(x, y), level(&mask, x, y));
            let level = nearest(0, covered, through.into(), 255);
            let wanted = if level == 0 { old } else { wanted(old, level, (x, y)) };
            assert!(got == wanted, "{name}: ({x}, {y}), covered by {covered}, let through by {through}");
        }
    }
}

/// On any layout.
fn hard<L: Layout, K: Layout>(rng: &mut Rng, color: impl Fn(u32) -> L::Color)
where
    K::Color: PixelFormat<Color = K::Color>,
{
    for _ in 0..cases(150) {
        let new = color(rng.bits() as u32);
        check::<L, K>(rng, &Solid(new), &|old, level, _| if level < 128 { old } else { new });
        check::<L, K>(rng, &Dithered::<_, 4>(new), &|old, level, at| dithered(old, new, level, at));
    }
}

/// On those whose colours can be mixed.
fn soft<L: Layout<Color: Channels>, K: Layout>(rng: &mut Rng, color: impl Fn(u32) -> L::Color)
where
    K::Color: PixelFormat<Color = K::Color>,
{
    for _ in 0..cases(150) {
        let new = color(rng.bits() as u32);
        check::<L, K>(rng, &Cover(new), &|old, level, _| {
            L::Color::mixed([old, new], |[a, b]| nearest(a, b, level.into(), 255))
        });
    }
}

macro_rules! kinds {
    ($check:ident $rng:ident: $($layout:ty, $format:ty, $mask:ty;)*) => {
        $($check::<$layout, $mask>(&mut $rng, <$format as UnpackLow>::unpack_low);)*
    };
}

#[test]
fn masks_on_every_layout() {
    let mut rng = Rng::new(1_730);
    kinds! { hard rng:
        Rows<Index1>, Index1, Rows<Index1>;
        Rows<Lsb0<Index1>>, Index1, Rows<Gray8>;
        Pages<Lsb0<BinaryColor>>, BinaryColor, Pages<Lsb0<BinaryColor>>;
        Pages<Index1>, Index1, Rows<Gray4>;
        Planes<Gray2>, Gray2, Planes<Gray2>;
        Planes<Lsb0<Index2>>, Index2, Rows<Index1>;
        Rows<Index2>, Index2, Rows<Lsb0<Gray2>>;
        Rows<Lsb0<Index4>>, Index4, Rows<Lsb0<Index4>>;
        Rows<Index4>, Index4, Pages<Index1>;
        Rows<Index8>, Index8, Rows<Lsb0<Index1>>;
        Packed12, Rgb444, Rows<Index8>;
        Rows<Be<Rgb565>>, Rgb565, Rows<Index1>;
        Rows<Rgb888>, Rgb888, Rows<Gray8>;
    }
    kinds! { soft rng:
        Rows<Gray2>, Gray2, Rows<Gray8>;
        Rows<Lsb0<Gray4>>, Gray4, Rows<Gray4>;
        Rows<Gray8>, Gray8, Planes<Gray2>;
        Packed12, Rgb444, Rows<Index1>;
        Rows<Rgb565>, Rgb565, Rows<Gray8>;
        Rows<Be<Rgb888>>, Rgb888, Rows<Lsb0<Gray4>>;
        Rows<Xrgb8888>, Xrgb8888, Rows<BinaryColor>;
    }
}

/// All that is drawn on a stencil is what would be drawn without it, where its bits are set.
fn stencils<L: Layout, K: Layout>(rng: &mut Rng, color: impl Fn(u32) -> L::Color)
where
    K::Color: PixelFormat<Color = K::Color>,
{
    fn draw<S: Surface>(
        on: &mut S,
        which: u64,
        corners: [PointFx; 3],
        color: S::Color,
        picture: &Frame<&[u8], Rows<Index1>>,
    ) {
        let [a, b, c] = corners.map(PointFx::pixel);
        match which {
            0 => on.fill_triangle_fx(corners, color),
            1 => on.draw_line(a, b, color),
            2 => on.draw_ellipse(Rect::new(a.x.min(b.x), a.y.min(b.y), a.x.max(b.x), a.y.max(b.y)), color),
            3 => on.fill_triangle_aa(corners, &mut [], Dithered::<_, 4>(color)),
            4 => on.blit_mask(c, picture, color, None),
            5 => on.fill_rectangle(Rect::new(a.x, a.y, b.x, b.y), color),
            _ => on.draw_polyline([a, b, c], color),
        }
    }
    for i in 0..cases(150) {
        let size = (rng.int(20, 50) as u16, rng.int(6, 14) as u16);
        let [mask] = frames::<K, 1>(rng, size);
        let mut mask = mask.as_bitmap();
        if rng.one_in(2) {
            mask = mask.view(Rect::new(rng.int(0, 9), rng.int(0, 3), 70, 20));
        }
        let [picture] = frames::<Rows<Index1>, 1>(rng, (20, 9));
        let corners = [(); 3].map(|()| PointFx::from_bits(rng.int(-2_000, 13_000), rng.int(-900, 3_600)));
        let ([before, mut all, mut some], color) = (frames::<L, 3>(rng, SIZE), color(rng.bits() as u32));
        draw(&mut all, i as u64 % 7, corners, color, &picture.as_bitmap());
        draw(&mut Stencil::new(&mut some, mask), i as u64 % 7, corners, color, &picture.as_bitmap());
        for (x, y) in pixels() {
            let from = if level(&mask, x, y) > 0 { &all } else { &before };
            let name = std::any::type_name::<(L, K)>();
            assert!(some.get((x, y)) == from.get((x, y)), "{name}: ({x}, {y}) of {corners:?}, {}", i % 7);
        }
    }
}

#[test]
fn stencils_clip_all_that_is_drawn() {
    let mut rng = Rng::new(1_740);
    kinds! { stencils rng:
        Rows<Index1>, Index1, Rows<Index1>;
        Pages<Lsb0<BinaryColor>>, BinaryColor, Pages<Lsb0<BinaryColor>>;
        Planes<Gray2>, Gray2, Rows<Lsb0<Index1>>;
        Rows<Index4>, Index4, Pages<Index1>;
        Packed12, Rgb444, Rows<Index1>;
        Rows<Be<Rgb565>>, Rgb565, Rows<Lsb0<BinaryColor>>;
    }
}

/// A mask as a shape of its own: a glyph.
fn glyphs<L: Layout, K: Layout>(
    rng: &mut Rng,
    paint: &(impl Paint<Frame<Vec<u8>, L>> + Clone),
    wanted: Wanted<'_, L::Color>,
) where
    K::Color: PixelFormat<Color = K::Color>,
{
    for _ in 0..cases(200) {
        let size = (rng.int(0, 50) as u16, rng.int(0, 9) as u16);
        let [glyph] = frames::<K, 1>(rng, size);
        let part = Rect::new(rng.int(0, 9), rng.int(0, 3), rng.int(3, 60), rng.int(3, 9));
        let (glyph, at) = (glyph.as_bitmap().view(part), (rng.int(-40, 50), rng.int(-9, 12)));
        let clip = Rect::new(rng.int(0, 9), rng.int(0, 3), rng.int(20, 50), rng.int(5, 12));
        let [before, mut after, mut again] = frames::<L, 3>(rng, SIZE);
        let (whole, clip) = if rng.one_in(2) { (after.window(), after.window()) } else { (after.window(), clip) };
        let clip = clip.intersection(whole);
        after.paint(paint.clone(), |_, brush| glyph.tell_levels(at.into(), clip, brush));
        for (x, y) in pixels() {
            let (old, got) = (before.get((x, y)).expect("a pixel"), after.get((x, y)).expect("a pixel"));
            let level = if clip.contains(x, y) { level(&glyph, x - at.0, y - at.1) } else { 0 };
            let wanted = if level == 0 { old } else { wanted(old, level, (x, y)) };
            assert!(got == wanted, "{}: ({x}, {y}) at {at:?}", std::any::type_name::<(L, K)>());
        }
        again.blit_mask_aa(at, &glyph, paint.clone());
        assert!(clip != whole || pixels().all(|at| again.get(at) == after.get(at)), "by the method of canvas");
    }
}

#[test]
fn glyphs_of_every_depth() {
    let mut rng = Rng::new(1_750);
    let (on, grey, red) = (BinaryColor::On, Gray4::new(11), Rgb565::new(30, 3, 9));
    let threshold = |old, level, _: (i32, i32)| if level < 128 { old } else { on };
    glyphs::<Pages<Lsb0<BinaryColor>>, Rows<Gray8>>(&mut rng, &Solid(on), &threshold);
    glyphs::<Rows<BinaryColor>, Rows<Lsb0<Gray4>>>(&mut rng, &Dithered::<_, 4>(on), &|old, level, at| {
        dithered(old, on, level, at)
    });
    let mix =
        |old: Gray4, level: u8, _: (i32, i32)| Gray4::mixed([old, grey], |[a, b]| nearest(a, b, level.into(), 255));
    glyphs::<Rows<Gray4>, Rows<Gray4>>(&mut rng, &Cover(grey), &mix);
    glyphs::<Rows<Lsb0<Gray4>>, Rows<Gray2>>(&mut rng, &Cover(grey), &mix);
    let mix =
        |old: Rgb565, level: u8, _: (i32, i32)| Rgb565::mixed([old, red], |[a, b]| nearest(a, b, level.into(), 255));
    glyphs::<Rows<Rgb565>, Rows<Gray8>>(&mut rng, &Cover(red), &mix);
    glyphs::<Rows<Be<Rgb565>>, Rows<Lsb0<Gray2>>>(&mut rng, &Cover(red), &mix);
    glyphs::<Rows<Be<Rgb565>>, Pages<Index1>>(&mut rng, &Cover(red), &mix);
}
