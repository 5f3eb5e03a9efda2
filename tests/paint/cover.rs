//! Means of colours against wide integers, exhaustively; and paints with soft rims against what a naive painter makes of the same
//! coverage, on frames of many formats.

use embedded_graphics_core::pixelcolor::{Gray2, Gray4, Gray8, GrayColor, Rgb555, Rgb565, Rgb666, Rgb888};
use embedded_raster::{
    paint::{Alpha, Cover, CoverIndex, Dithered, Over, Ramp},
    pixel::{Be, Channels, Lsb0, Rgb332, Rgb444, Xrgb8888, EGA},
    raster::coverage,
    surface::Packed12,
    Antialias, Canvas, ClippedSpan, Frame, Index4, Layout, Paint, PixelFormat, PointFx, Rect, Solid, Surface,
};
use twins::{
    coverage::Levels,
    relay::Relay,
    rng::{cases, Rng},
};

/// The nearest whole number to `(a (most - part) + b part) / most`, found without a division.
pub(crate) fn nearest(a: u8, b: u8, part: u32, most: u32) -> u8 {
    let sum = u64::from(a) * u64::from(most - part) + u64::from(b) * u64::from(part);
    let mut low = 0_u64;
    for bit in (0..8).rev() {
        // Twice the mean of two neighbours is odd: it is passed when twice the sum is above it.
        if 2 * sum > (2 * (low + (1 << bit)) - 1) * u64::from(most) {
            low += 1 << bit;
        }
    }
    low as u8
}

#[test]
fn means_by_a_level_are_the_nearest() {
    for (a, b) in (0..=255).flat_map(|a| (0..=255).map(move |b| (a, b))) {
        for level in 0..=255 {
            let got = Gray8::between([Gray8::new(a), Gray8::new(b)], level).luma();
            assert_eq!(got, nearest(a, b, level.into(), 255), "{level} of 255 from {a} to {b}");
        }
    }
}

#[test]
fn means_by_a_product_are_the_nearest() {
    // Every product of two levels, for ends that make trouble, and for all ends of four bits.
    let ends = [0, 1, 2, 100, 127, 128, 129, 253, 254, 255];
    for (a, b) in ends.iter().flat_map(|&a| ends.map(|b| (a, b))) {
        for share in 0..=65_025 {
            let got = Gray8::between_fine([Gray8::new(a), Gray8::new(b)], share).luma();
            assert_eq!(got, nearest(a, b, share.into(), 65_025), "{share} of 65,025 from {a} to {b}");
        }
    }
    for (a, b) in (0..16).flat_map(|a| (0..16).map(move |b| (a, b))) {
        for share in 0..=65_025 {
            let got = Gray4::between_fine([Gray4::new(a), Gray4::new(b)], share).luma();
            assert_eq!(got, nearest(a, b, share.into(), 65_025), "{share} of 65,025 from {a} to {b}");
        }
    }
}

const SIZE: (u16, u16) = (13, 9);

fn window() -> Rect {
    Rect::new(0, 0, SIZE.0.into(), SIZE.1.into())
}

/// A triangle, and how much of each pixel it covers.
fn triangle(rng: &mut Rng) -> ([PointFx; 3], Levels) {
    let corners = [(); 3].map(|()| PointFx::from_bits(rng.int(-900, 4_000), rng.int(-900, 3_000)));
    let mut levels = Levels::new(window());
    coverage::triangle(corners, &mut [], window(), &mut levels);
    (corners, levels)
}

/// Paints a triangle over anything, and compares every pixel with what `wanted` makes of the old colour and the level.
fn check<L: Layout>(
    rng: &mut Rng,
    name: &str,
    paint: impl Paint<Frame<Vec<u8>, L>>,
    wanted: impl Fn(L::Color, u8, (i32, i32)) -> L::Color,
) {
    let (corners, levels) = triangle(rng);
    let stride = L::row_bytes(SIZE.0) + rng.index(3);
    let memory: Vec<u8> = (0..stride * usize::from(SIZE.1)).map(|_| rng.bits() as u8).collect();
    let before = Frame::<_, L>::with_stride(memory.clone(), SIZE.0, SIZE.1, stride).expect("enough memory");
    let mut after = Frame::<_, L>::with_stride(memory, SIZE.0, SIZE.1, stride).expect("enough memory");
    after.paint(paint, |window, mut brush| coverage::triangle(corners, &mut [], window, Relay(&mut brush)));
    for (x, y) in (0..window().y1).flat_map(|y| (0..window().x1).map(move |x| (x, y))) {
        let (old, got) = (before.get((x, y)).expect("a pixel"), after.get((x, y)).expect("a pixel"));
        let level = levels.at(x, y);
        assert!(got == wanted(old, level, (x, y)), "{name}: ({x}, {y}), covered by {level}");
    }
}

fn formats<L: Layout<Color: Channels>>(rng: &mut Rng, color: impl Fn(u32) -> L::Color) {
    let name = std::any::type_name::<L>();
    for _ in 0..cases(300) {
        let (new, under, alpha) = (color(rng.bits() as u32), color(rng.bits() as u32), rng.bits() as u8);
        let by = |old: L::Color, new: L::Color, part: u32, most: u32| {
            L::Color::mixed([old, new], |[a, b]| nearest(a, b, part, most))
        };
        // What is not covered keeps all its bits, even those that no channel has.
        check::<L>(rng, name, Cover(new), |old, level, _| match level {
            0 => old,
            level => by(old, new, level.into(), 255),
        });
        check::<L>(rng, name, Alpha { color: new, alpha }, |old, level, _| match level {
            0 => old,
            level => by(old, new, u32::from(level) * u32::from(alpha), 65_025),
        });
        check::<L>(rng, name, Over { color: new, background: under }, |old, level, _| match level {
            0 => old,
            level => by(under, new, level.into(), 255),
        });
        check::<L>(rng, name, Solid(new), |old, level, _| if level < 128 { old } else { new });
        check::<L>(rng, name, Dithered::<_, 4>(new), |old, level, (x, y)| {
            // Of the sixteen thresholds of a block, so many are passed as levels are nearest to.
            let threshold =
                [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]][(y & 3) as usize][(x & 3) as usize];
            if i32::from(level) * 32 + (2 * threshold + 1) * 255 >= 32 * 255 {
                new
            } else {
                old
            }
        });
    }
}

macro_rules! formats {
    ($rng:ident: $($format:ty),*) => {
        $(formats::<embedded_raster::surface::Rows<$format>>(&mut $rng, <$format as UnpackLow>::unpack_low);)*
    };
}

/// Colours of any bits.
pub(crate) trait UnpackLow: PixelFormat {
    fn unpack_low(bits: u32) -> Self::Color {
        Self::unpack(bits & (u32::MAX >> (32 - Self::BITS.min(24))))
    }
}

impl<F: PixelFormat> UnpackLow for F {}

#[test]
fn soft_rims_are_exact_in_every_format() {
    let mut rng = Rng::new(1_600);
    formats!(rng: Gray2, Lsb0<Gray2>, Gray4, Lsb0<Gray4>, Gray8, Rgb332, Rgb444, Rgb555, Rgb565, Be<Rgb565>, Rgb666, Rgb888);
    formats!(rng: Be<Rgb888>, Xrgb8888);
    formats::<Packed12>(&mut rng, |bits| Rgb444::new(bits as u8, (bits >> 8) as u8, (bits >> 16) as u8));
}

#[test]
fn indices_get_entries_between() {
    let mut rng = Rng::new(1_610);
    let palette = EGA;
    let mean = |a: Index4, b: Index4, level: u8| {
        let ends = [a, b].map(|index| palette.get(index.index()).expect("an entry"));
        Index4::new(palette.nearest(Rgb888::between(ends, level)))
    };
    for _ in 0..cases(300) {
        let [new, under] = [(); 2].map(|()| Index4::new(rng.bits() as u8));
        let paint = CoverIndex::new(&palette, new, Index4::new);
        check::<embedded_raster::surface::Rows<Index4>>(&mut rng, "entries", paint, |old, level, _| match level {
            0 => old,
            255 => new,
            level => mean(old, new, level),
        });
        let ramp = Ramp::<_, 256>::of_palette(&palette, [under.index(), new.index()], Index4::new);
        check::<embedded_raster::surface::Rows<Index4>>(&mut rng, "a ramp", ramp, |old, level, _| match level {
            0 => old,
            255 => new,
            level => mean(under, new, level),
        });
    }
}

/// A surface that gives nothing back.
struct Blind(Vec<(i32, i32, Gray8)>);

impl Surface for Blind {
    type Color = Gray8;

    fn window(&self) -> Rect {
        window()
    }

    fn fill_span(&mut self, span: ClippedSpan, color: Gray8) {
        self.0.extend((span.x0()..span.x1()).map(|x| (x, span.y(), color)));
    }
}

#[test]
fn what_cannot_be_read_is_painted_over_a_background() {
    let mut rng = Rng::new(1_620);
    for _ in 0..cases(200) {
        let (corners, levels) = triangle(&mut rng);
        let mut blind = Blind(vec![]);
        blind.fill_triangle_aa(corners, &mut [], Over { color: Gray8::new(250), background: Gray8::new(20) });
        assert_eq!(blind.0.len(), levels.levels.iter().filter(|&&level| level > 0).count(), "each pixel once");
        for (x, y, color) in blind.0 {
            assert_eq!(color.luma(), nearest(20, 250, levels.at(x, y).into(), 255), "({x}, {y})");
        }
    }
}

/// A view moves what is drawn, and its rims with it; clips of a view cut levels off on the left.
#[test]
fn views_and_clips_keep_levels_in_place() {
    let mut rng = Rng::new(1_630);
    for _ in 0..cases(200) {
        let (corners, levels) = triangle(&mut rng);
        let mut ram = vec![0; 13 * 9];
        let mut frame = embedded_raster::Framebuffer::<Gray8>::new(&mut ram, 13, 9).expect("enough memory");
        let clip = Rect::new(rng.int(0, 6), rng.int(0, 4), rng.int(5, 13), rng.int(3, 9));
        // The brush is given more than the clip has.
        let whole = frame.window();
        frame
            .clipped(clip)
            .paint(Cover(Gray8::new(255)), |_, brush| coverage::triangle(corners, &mut [], whole, brush));
        for (x, y) in (0..9).flat_map(|y| (0..13).map(move |x| (x, y))) {
            let wanted = if clip.contains(x, y) { levels.at(x, y) } else { 0 };
            assert_eq!(ram[(y * 13 + x) as usize], wanted, "({x}, {y}) in {clip:?}");
        }
    }
}
