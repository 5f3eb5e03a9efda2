//! Textures at any place, of any size and layout, against a sum over four texels.

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{BinaryColor, Gray4, Gray8, GrayColor, PixelColor, Rgb565, Rgb888, RgbColor},
};
use embedded_raster::{
    geom::Fast,
    pixel::{Be, Channels, Lsb0, Rgb444},
    surface::{
        texture::{AddressMode, Clamp, Mirror, Repeat, Texture, Tile},
        Grid, Packed12, Pages, Planes, Rows,
    },
    Canvas, Frame, Framebuffer, Index2, Index4, Index8, Layout, Palette, PixelFormat, PointFx, Rect,
};
use fixed::types::I16F16;
use twins::{
    corners, planes,
    rng::{cases, Rng},
    textures, triangle_has,
};

/// Sizes that are powers of two, and others.
const SIZES: [(u16, u16); 8] = [(1, 1), (2, 4), (8, 8), (64, 1), (3, 5), (7, 16), (37, 21), (1, 300)];

/// Any place, many of them around texels of a picture, at their borders and centres, and at the ends of the type.
fn place(rng: &mut Rng, size: u16) -> i32 {
    let near = rng.int(-3 * i32::from(size), 4 * i32::from(size)).wrapping_shl(16);
    match rng.below(6) {
        0 => rng.bits() as i32,
        1 => near,
        2 => near.wrapping_add(0x8000),
        3 => near.wrapping_add(rng.pick(&[-1, 1, 0x7fff, 0x8001])),
        4 => rng.pick(&[i32::MIN, i32::MIN + 1, i32::MIN + 0x8000, i32::MAX - 0x7fff, i32::MAX - 0x8000, i32::MAX]),
        _ => near.wrapping_add(rng.int(0, 0xffff)),
    }
}

/// Random pictures on a layout, whole or the window of a view or a clip, at random places.
fn each_place<L: Layout>(
    seed: u64,
    color: impl Fn(u32) -> L::Color,
    mut check: impl FnMut(&dyn Sample<L>, (i32, i32), &dyn Fn(i64, i64) -> L::Color, &mut Rng),
) {
    let mut rng = Rng::new(seed);
    for (round, (width, height)) in (0..cases(6)).flat_map(|round| SIZES.map(move |size| (round, size))) {
        // With a border around it, which is not part of it.
        let (full_width, full_height) = (width + 5, height + 4);
        let (outer, part) = match round % 3 {
            0 => ((width, height), Rect::new(0, 0, width.into(), height.into())),
            _ => ((full_width, full_height), Rect::new(3, 1, 3 + i32::from(width), 1 + i32::from(height))),
        };
        let grid = Grid { stride: L::row_bytes(outer.0), rows: outer.1.into() };
        let mut ram = vec![0; L::bytes(outer.0, grid)];
        let mut frame = Frame::<_, L>::new(&mut ram[..], outer.0, outer.1).unwrap();
        for at in (0..outer.1).flat_map(|y| (0..outer.0).map(move |x| Point::new(x.into(), y.into()))) {
            frame.draw_point(at, color(rng.bits() as u32));
        }
        let all = Frame::<_, L>::new(&ram[..], outer.0, outer.1).unwrap();
        let picture = if round % 3 == 1 { all.view(part) } else { all.clipped(part) };
        let mut with = |texture: Option<&dyn Sample<L>>, kind: [usize; 2]| {
            let Some(texture) = texture else { return };
            let texel = |i: i64, j: i64| {
                let x = textures::column(i, width.into(), kind[0]) as i32;
                let y = textures::column(j, height.into(), kind[1]) as i32;
                all.get(Point::new(part.x0 + x, part.y0 + y)).unwrap()
            };
            for _ in 0..cases(300) {
                let at = (place(&mut rng, width), place(&mut rng, height));
                check(texture, at, &texel, &mut rng);
            }
        };
        let tile = Texture::new(&picture, (Tile, Tile));
        let is_tile = width.is_power_of_two() && height.is_power_of_two() && round % 3 == 0;
        assert_eq!(tile.is_some(), is_tile, "{width} x {height}");
        with(some(tile.as_ref()), [1, 1]);
        with(some(Texture::new(&picture, (Clamp, Clamp)).as_ref()), [0, 0]);
        with(some(Texture::new(&picture, (Repeat, Repeat)).as_ref()), [1, 1]);
        with(some(Texture::new(&picture, (Mirror, Mirror)).as_ref()), [2, 2]);
        with(some(Texture::new(&picture, (Clamp, Repeat)).as_ref()), [0, 1]);
        with(some(Texture::new(&picture, (Repeat, Mirror)).as_ref()), [1, 2]);
    }
}

fn some<T: Sample<L>, L: Layout>(texture: Option<&T>) -> Option<&dyn Sample<L>> {
    texture.map(|texture| texture as &dyn Sample<L>)
}

/// A texture of any kind.
trait Sample<L: Layout>: core::fmt::Debug {
    fn nearest(&self, at: (i32, i32)) -> L::Color;
    fn nearest_keyed(&self, at: (i32, i32), key: L::Color) -> Option<L::Color>;
    fn bilinear(&self, at: (i32, i32)) -> L::Color
    where
        L::Color: Channels;
    fn bilinear_keyed(&self, at: (i32, i32), key: L::Color) -> Option<L::Color>
    where
        L::Color: Channels;
    fn nearest_through(&self, at: (i32, i32), palette: &Palette<Rgb565, 11>) -> Option<Rgb565>
    where
        L::Color: Into<u8>;
    fn bilinear_through(&self, at: (i32, i32), palette: &Palette<Rgb565, 11>) -> Option<Rgb565>
    where
        L::Color: Into<u8>;
}

impl<L: Layout, U: AddressMode, V: AddressMode> Sample<L> for Texture<'_, L, U, V> {
    fn nearest(&self, at: (i32, i32)) -> L::Color {
        self.nearest(fixed(at).0, fixed(at).1)
    }

    fn nearest_keyed(&self, at: (i32, i32), key: L::Color) -> Option<L::Color> {
        self.nearest_keyed(fixed(at).0, fixed(at).1, key)
    }

    fn bilinear(&self, at: (i32, i32)) -> L::Color
    where
        L::Color: Channels,
    {
        self.bilinear(fixed(at).0, fixed(at).1)
    }

    fn bilinear_keyed(&self, at: (i32, i32), key: L::Color) -> Option<L::Color>
    where
        L::Color: Channels,
    {
        self.bilinear_keyed(fixed(at).0, fixed(at).1, key)
    }

    fn nearest_through(&self, at: (i32, i32), palette: &Palette<Rgb565, 11>) -> Option<Rgb565>
    where
        L::Color: Into<u8>,
    {
        self.nearest_through(fixed(at).0, fixed(at).1, palette)
    }

    fn bilinear_through(&self, at: (i32, i32), palette: &Palette<Rgb565, 11>) -> Option<Rgb565>
    where
        L::Color: Into<u8>,
    {
        self.bilinear_through(fixed(at).0, fixed(at).1, palette)
    }
}

fn fixed((u, v): (i32, i32)) -> (I16F16, I16F16) {
    (I16F16::from_bits(u), I16F16::from_bits(v))
}

fn nearest<L: Layout>(seed: u64, color: impl Fn(u32) -> L::Color)
where
    L::Color: PixelColor + core::fmt::Debug,
{
    each_place::<L>(seed, &color, |texture, at, texel, rng| {
        let wanted = texel((at.0 >> 16).into(), (at.1 >> 16).into());
        assert_eq!(texture.nearest(at), wanted, "{at:?} of {texture:?}");
        let key = color(rng.bits() as u32);
        let keyed = (wanted != key).then_some(wanted);
        assert_eq!(texture.nearest_keyed(at, key), keyed, "{at:?} of {texture:?} without {key:?}");
    });
}

#[test]
fn nearest_texels_of_every_layout() {
    fn bits<F: PixelFormat>(n: u32) -> F::Color {
        F::unpack(n & (u32::MAX >> (32 - F::BITS)))
    }
    nearest::<Rows<BinaryColor>>(1, bits::<BinaryColor>);
    nearest::<Rows<Lsb0<Index2>>>(2, bits::<Index2>);
    nearest::<Rows<Index4>>(3, bits::<Index4>);
    nearest::<Rows<Index8>>(4, bits::<Index8>);
    nearest::<Rows<Rgb565>>(5, bits::<Rgb565>);
    nearest::<Rows<Be<Rgb888>>>(6, bits::<Rgb888>);
    nearest::<Pages<BinaryColor>>(7, bits::<BinaryColor>);
    nearest::<Planes<Index2>>(8, bits::<Index2>);
    nearest::<Packed12>(9, bits::<Rgb444>);
}

/// Each channel by itself, from texels that a function may replace.
fn bilinear<L: Layout>(seed: u64, color: impl Fn(u32) -> L::Color, channels: &[fn(&L::Color) -> u8])
where
    L::Color: Channels + core::fmt::Debug,
{
    each_place::<L>(seed, &color, |texture, at, texel, rng| {
        let (wide_u, wide_v) = (i64::from(at.0), i64::from(at.1));
        let here = texel((at.0 >> 16).into(), (at.1 >> 16).into());
        let key = if rng.one_in(4) { here } else { texel(rng.range(-9, 9), rng.range(-9, 9)) };
        let (plain, keyed) = (texture.bilinear(at), texture.bilinear_keyed(at, key));
        assert_eq!(keyed.is_none(), here == key, "{at:?} of {texture:?}");
        for channel in channels {
            let level = |i, j| i128::from(channel(&texel(i, j)));
            let wanted = textures::bilinear(wide_u, wide_v, level);
            assert_eq!(i128::from(channel(&plain)), wanted, "{at:?} of {texture:?}");
            let level = |i, j| i128::from(channel(&Some(texel(i, j)).filter(|&c| c != key).unwrap_or(here)));
            let wanted = textures::bilinear(wide_u, wide_v, level);
            assert!(keyed.is_none_or(|c| i128::from(channel(&c)) == wanted), "{at:?} of {texture:?} without {key:?}");
        }
    });
}

#[test]
fn means_of_four_texels_are_the_nearest_levels() {
    let rgb: [fn(&Rgb888) -> u8; 3] = [Rgb888::r, Rgb888::g, Rgb888::b];
    bilinear::<Rows<Rgb888>>(20, |n| Rgb888::new(n as u8, (n >> 8) as u8, (n >> 16) as u8), &rgb);
    let rgb: [fn(&Rgb565) -> u8; 3] = [Rgb565::r, Rgb565::g, Rgb565::b];
    bilinear::<Rows<Be<Rgb565>>>(21, |n| Rgb565::new(n as u8, (n >> 8) as u8, (n >> 16) as u8), &rgb);
    let rgb: [fn(&Rgb444) -> u8; 3] = [Rgb444::r, Rgb444::g, Rgb444::b];
    bilinear::<Packed12>(22, |n| Rgb444::new(n as u8, (n >> 8) as u8, (n >> 16) as u8), &rgb);
    // Black and white: the largest sums.
    bilinear::<Rows<Gray8>>(23, |n| Gray8::new(if n % 3 > 0 { 255 } else { n as u8 }), &[Gray8::luma]);
    bilinear::<Rows<Gray4>>(24, |n| Gray4::new(n as u8), &[Gray4::luma]);
}

/// Indices through a palette that lacks some: as if these texels had the key.
#[test]
fn indices_are_mixed_as_colors() {
    let mut rng = Rng::new(30);
    let palette = Palette::new([(); 11].map(|()| Rgb565::new(rng.bits() as u8, rng.bits() as u8, rng.bits() as u8)));
    each_place::<Rows<Index4>>(
        31,
        |n| Index4::new(n as u8),
        |texture, at, texel, _| {
            let color = |i, j| palette.get(texel(i, j).index());
            let here = color((at.0 >> 16).into(), (at.1 >> 16).into());
            assert_eq!(texture.nearest_through(at, &palette), here, "{at:?} of {texture:?}");
            let wanted = here.map(|here| {
                let channel = |channel: fn(&Rgb565) -> u8| {
                    let level = |i, j| i128::from(channel(&color(i, j).unwrap_or(here)));
                    textures::bilinear(at.0.into(), at.1.into(), level) as u8
                };
                Rgb565::new(channel(Rgb565::r), channel(Rgb565::g), channel(Rgb565::b))
            });
            assert_eq!(texture.bilinear_through(at, &palette), wanted, "{at:?} of {texture:?}");
        },
    );
}

/// Rows with bytes between them: a tile is one where these are whole pixels, any other texture whatever they are. The last row ends with its
/// pixels.
fn rows_apart<F: PixelFormat>(seed: u64, color: impl Fn(u32) -> F::Color)
where
    F::Color: PartialEq + core::fmt::Debug,
{
    let (mut rng, (width, height)) = (Rng::new(seed), (8_u16, 4_u16));
    for more in 0..7 {
        let row = <Rows<F> as Layout>::row_bytes(width);
        let stride = row + more;
        let mut ram: Vec<u8> = (0..stride * 3 + row).map(|_| rng.bits() as u8).collect();
        let mut frame = Framebuffer::<F>::with_stride(&mut ram[..], width, height, stride).unwrap();
        for at in (0..height).flat_map(|y| (0..width).map(move |x| Point::new(x.into(), y.into()))) {
            frame.draw_point(at, color(rng.bits() as u32));
        }
        let picture = Frame::<_, Rows<F>>::with_stride(&ram[..], width, height, stride).unwrap();
        let tile = Texture::new(&picture, (Tile, Tile));
        let is_whole = F::BITS < 8 || stride.is_multiple_of(F::BITS as usize / 8);
        assert_eq!(tile.is_some(), is_whole, "{} bits, {stride} bytes a row", F::BITS);
        let repeat = Texture::new(&picture, (Repeat, Repeat)).unwrap();
        for (i, j) in (-9..18).flat_map(|i| (-9..9).map(move |j| (i, j))) {
            let wanted = picture.get(Point::new(i & 7, j & 3)).unwrap();
            let (u, v) = (I16F16::from_num(i), I16F16::from_num(j));
            assert_eq!(repeat.nearest(u, v), wanted, "{} bits, {stride} bytes a row, ({i}, {j})", F::BITS);
            if let Some(tile) = tile {
                assert_eq!(tile.nearest(u, v), wanted, "{} bits, {stride} bytes a row, ({i}, {j})", F::BITS);
            }
        }
    }
}

#[test]
fn tiles_whose_rows_are_apart() {
    rows_apart::<Gray4>(21, |bits| Gray4::new(bits as u8 & 15));
    rows_apart::<Gray8>(22, |bits| Gray8::new(bits as u8));
    rows_apart::<Rgb565>(23, |bits| Rgb565::new(bits as u8 & 31, (bits >> 8) as u8 & 63, (bits >> 16) as u8 & 31));
    rows_apart::<Rgb888>(24, |bits| Rgb888::new(bits as u8, (bits >> 8) as u8, (bits >> 16) as u8));
}

#[test]
fn a_picture_without_texels_is_no_texture() {
    let empty = Framebuffer::<Gray8>::new(&mut [], 0, 7).map(|frame| Texture::new(&frame, (Repeat, Clamp)).is_none());
    assert_eq!(empty, Ok(true));
    let mut ram = [0; 4];
    let frame = Framebuffer::<Gray8>::new(&mut ram, 2, 2).unwrap();
    assert!(Texture::new(&frame.as_bitmap().clipped(Rect::new(5, 5, 9, 9)), (Repeat, Clamp)).is_none());
}

/// A triangle shows the texels at the nearest 16.16 numbers to the exact places: in fast mode, next to them.
#[test]
fn textured_triangles() {
    let mut rng = Rng::new(40);
    let bytes: Vec<u8> = (0..13 * 9).map(|_| rng.bits() as u8).collect();
    let picture = Frame::<_, Rows<Index8>>::new(&bytes[..], 13, 9).unwrap();
    let texture = Texture::new(&picture, (Repeat, Mirror)).unwrap();
    let mut off = 0;
    for _ in 0..cases(400) {
        let reach = rng.pick(&[0, 2_000, 200_000]);
        let units = [(); 3].map(|()| (rng.int(-reach, 45 * 256 + reach), rng.int(-reach, 32 * 256 + reach)));
        let at = [(); 3].map(|()| (place(&mut rng, 40), place(&mut rng, 40)));
        let (mut exact, mut fast) = (vec![0; 45 * 32], vec![0; 45 * 32]);
        let places = units.map(|(x, y)| PointFx::from_bits(x, y));
        let mut frame = Framebuffer::<Index8>::new(&mut exact, 45, 32).unwrap();
        frame.shade_triangle_fx(places, at.map(fixed), |(u, v)| texture.nearest(u, v)).unwrap();
        let mut quick = Framebuffer::<Index8>::new(&mut fast, 45, 32).unwrap();
        let values = at.map(|at| Fast(fixed(at)));
        let mut inside = true;
        let range = |of: fn((i32, i32)) -> i32, n: I16F16| {
            at.iter().any(|&at| of(at) <= n.to_bits()) && at.iter().any(|&at| of(at) >= n.to_bits())
        };
        quick
            .shade_triangle_fx(places, values, |Fast((u, v))| {
                inside &= range(|at| at.0, u) && range(|at| at.1, v);
                texture.nearest(u, v)
            })
            .unwrap();
        assert!(inside, "{units:?} {at:?}");
        for p in (0..32).flat_map(|y| (0..45).map(move |x| Point::new(x, y))) {
            let wanted = if triangle_has(units, p.x, p.y) {
                let value =
                    |of: fn((i32, i32)) -> i32| planes::nearest(units, at.map(|at| of(at).into()), p.x, p.y) as i32;
                let (u, v) = fixed((value(|at| at.0), value(|at| at.1)));
                texture.nearest(u, v)
            } else {
                Index8::new(0)
            };
            assert_eq!(frame.get(p), Some(wanted), "{:?} {at:?} at {p}", corners(units));
            off += u32::from(quick.get(p) != Some(wanted));
        }
    }
    assert!(off < 45 * 32 * cases(400) as u32 / 100, "{off} pixels are others in fast mode");
}
