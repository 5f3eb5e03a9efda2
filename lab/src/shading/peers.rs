//! The peers: euc and retrofire-core in `f32`, embedded-3dgfx between whole pixels. Each on its own buffers, by the calls next to
//! its rasterizer: what comes before that, such as clipping, is not asked for.

use std::convert::Infallible;

use embedded_3dgfx::pipeline::{
    assemble::primitive::DrawPrimitive,
    rasterize::{
        draw::{draw, draw_zbuffered, draw_zbuffered_with_textures},
        texture::{Texture, TextureManager},
    },
};
use embedded_graphics::{
    pixelcolor::{
        raw::{RawData, RawU16},
        Rgb565,
    },
    prelude::*,
};
use euc::{
    buffer::Buffer2d,
    rasterizer::{BackfaceCullingDisabled, Triangles},
    DepthStrategy, Pipeline, Rasterizer, Target as _,
};
use nalgebra::Point2;
use retrofire_core::{
    geom::{vertex, Vertex},
    math::{pt3, rgb, rgba, Color3f, Color4},
    render::{
        raster::{tri_fill, Frag, ScreenPt},
        target::{Colorbuf, Framebuf, Target},
        tex::{uv, SamplerRepeatPot, TexCoord, Texture as Picture},
        Context, FragmentShader,
    },
    util::{pixfmt, Buf2, Dims},
};
use textbook::scene::{Corner, Triangle};

use super::{
    engine::{read, texels, Peers, PIXELS, TEXTURE},
    Drawn, Kind, Shaded, Ways, UNPAINTED,
};
use crate::{
    engine::{entry, Engine, Origin},
    frame::{HEIGHT, WIDTH},
};

pub(super) fn all() -> Peers {
    let entries = |kind: Kind, depth_bits: u32| -> Ways {
        let mut retro = entry("retrofire", "retrofire-core", Origin::Peer, Retro::new(kind, depth_bits));
        // Its rows must lie on its buffer.
        retro.can_hard = false;
        vec![
            entry("euc", "euc", Origin::Peer, Euc::new(kind)),
            retro,
            entry("3dgfx", "embedded-3dgfx", Origin::Peer, Embedded::new(kind)),
        ]
    };
    let (gouraud, depth16, perspective) =
        (entries(Kind::Levels, 16), entries(Kind::Depth, 16), entries(Kind::Texels, 16));
    let mut depth32 = entries(Kind::Depth, 32);
    // What its depths gain from pixel to pixel has 16 bits before the point.
    depth32.retain(|entry| entry.key != "3dgfx");
    Peers { gouraud, depth16, depth32, perspective }
}

/// Everybody's pixel of three levels.
fn rgb565(r: f32, g: f32, b: f32) -> u16 {
    let level = |n: f32, most: f32| (n + 0.5).clamp(0.0, most) as u16;
    level(r, 31.0) << 11 | level(g, 63.0) << 5 | level(b, 31.0)
}

/// A corner in the space of clipping.
fn clip_space(corner: &Corner) -> [f32; 4] {
    let w = corner.w as f32;
    let [x, y] = corner.at.map(|n| n as f32 / 256.0);
    [(2.0 * x / WIDTH as f32 - 1.0) * w, (1.0 - 2.0 * y / HEIGHT as f32) * w, corner.depth as f32, w]
}

struct Euc {
    kind: Kind,
    frame: Buffer2d<u16>,
    depths: Buffer2d<f32>,
    texels: Vec<u16>,
}

impl Euc {
    fn new(kind: Kind) -> Self {
        let size = [WIDTH as usize, HEIGHT as usize];
        let (frame, depths) = (Buffer2d::new(size, u16::MAX), Buffer2d::new(size, f32::INFINITY));
        Self { kind, frame, depths, texels: texels() }
    }
}

/// Colours.
struct Levels(DepthStrategy);

type LevelVertex = ([f32; 4], (f32, f32, f32));

impl Pipeline for Levels {
    type Vertex = LevelVertex;
    type VsOut = (f32, f32, f32);
    type Pixel = u16;

    fn vert(&self, vertex: &LevelVertex) -> ([f32; 4], (f32, f32, f32)) {
        *vertex
    }

    fn frag(&self, &(r, g, b): &(f32, f32, f32)) -> u16 {
        rgb565(r, g, b)
    }

    fn get_depth_strategy(&self) -> DepthStrategy {
        self.0
    }
}

/// A texture.
struct Texels<'a>(&'a [u16]);

impl Pipeline for Texels<'_> {
    type Vertex = ([f32; 4], (f32, f32));
    type VsOut = (f32, f32);
    type Pixel = u16;

    fn vert(&self, vertex: &Self::Vertex) -> ([f32; 4], (f32, f32)) {
        *vertex
    }

    fn frag(&self, &(u, v): &(f32, f32)) -> u16 {
        let mask = (1 << TEXTURE) - 1;
        self.0[((v.floor() as i32 & mask) << TEXTURE | u.floor() as i32 & mask) as usize]
    }

    fn get_depth_strategy(&self) -> DepthStrategy {
        DepthStrategy::None
    }
}

type Flat<'a> = Triangles<'a, (f32,), BackfaceCullingDisabled>;
type Deep<'a> = Triangles<'a, Buffer2d<f32>, BackfaceCullingDisabled>;

impl Engine<Shaded, Drawn> for Euc {
    fn draw(&mut self, shapes: &[Shaded]) {
        let levels = |corner: &Corner| {
            let [r, g, b] = corner.levels.map(|n| n as f32);
            (clip_space(&Corner { w: 1, ..*corner }), (r, g, b))
        };
        if self.kind == Kind::Depth {
            self.depths.clear(f32::INFINITY);
        }
        for Shaded { corners, .. } in shapes {
            match self.kind {
                Kind::Levels => {
                    let corners = corners.each_ref().map(levels);
                    Flat::draw(&Levels(DepthStrategy::None), &corners, &mut self.frame, None);
                }
                Kind::Depth => {
                    let corners = corners.each_ref().map(levels);
                    let pipeline = Levels(DepthStrategy::IfLessWrite);
                    Deep::draw(&pipeline, &corners, &mut self.frame, Some(&mut self.depths));
                }
                Kind::Texels => {
                    let place = |c: &Corner| (clip_space(c), (c.texel[0] as f32, c.texel[1] as f32));
                    Flat::draw(&Texels(&self.texels), &corners.each_ref().map(place), &mut self.frame, None);
                }
            }
        }
    }

    fn clear(&mut self) {
        self.frame.clear(u16::MAX);
        self.depths.clear(f32::INFINITY);
    }

    fn painted(&self) -> Drawn {
        match self.kind {
            Kind::Depth => self.depths.as_ref().iter().map(|&depth| number(depth)).collect(),
            _ => read(self.frame.as_ref().iter().copied()),
        }
    }
}

/// A depth in floats; infinity is none.
fn number(depth: f32) -> u32 {
    if depth.is_finite() {
        (f64::from(depth) + 0.5) as u32
    } else {
        UNPAINTED
    }
}

/// Depths are kept as what is larger the nearer it is.
struct Retro {
    kind: Kind,
    /// Above all depths.
    farthest: f32,
    frame: Framebuf<Colorbuf<Buf2<u16>, pixfmt::Rgb565>, Buf2<f32>>,
    /// Texels would not fit into 16 bits by way of 8 for each channel.
    wide: Colorbuf<Buf2<u32>, pixfmt::Xrgb8888>,
    texture: Picture<Buf2<Color4>>,
}

/// Where nothing is.
const NOWHERE: f32 = f32::NEG_INFINITY;

impl Retro {
    fn new(kind: Kind, depth_bits: u32) -> Self {
        let size = Dims(WIDTH as u32, HEIGHT as u32);
        let color_buf = Colorbuf::new(Buf2::new_with(size, |_, _| u16::MAX));
        let frame = Framebuf { color_buf, depth_buf: Buf2::new_with(size, |_, _| NOWHERE) };
        let wide = Colorbuf::new(Buf2::new_with(size, |_, _| UNPAINTED));
        let side = 1 << TEXTURE;
        let texture = Buf2::new_with(Dims(side, side), |x, y| rgba(0, y as u8, x as u8, 255)).into();
        Self { kind, farthest: (1_u64 << depth_bits) as f32, frame, wide, texture }
    }

    /// Levels in the middle of what becomes them when bits are cut off.
    fn levels(&self, corner: &Corner) -> Vertex<ScreenPt, Color3f> {
        let [x, y] = corner.at.map(|n| n as f32 / 256.0);
        let [r, g, b] = corner.levels.map(|n| n as f32);
        let color = rgb((8.0 * r + 4.0) / 256.0, (4.0 * g + 2.0) / 256.0, (8.0 * b + 4.0) / 256.0);
        vertex(pt3(x, y, self.farthest - corner.depth as f32), color)
    }

    fn place(corner: &Corner) -> Vertex<ScreenPt, TexCoord> {
        let [x, y] = corner.at.map(|n| n as f32 / 256.0);
        let (nearness, [u, v]) = (1.0 / corner.w as f32, corner.texel.map(|n| n as f32));
        vertex(pt3(x, y, nearness), uv(u * nearness, v * nearness))
    }
}

/// Triangles to rows, rows to pixels.
fn rasterize<V: retrofire_core::math::Vary>(
    corners: [Vertex<ScreenPt, V>; 3],
    target: &mut impl Target,
    shader: &impl FragmentShader<V, ()>,
    context: &Context,
) {
    tri_fill(corners, |line| target.rasterize(line, shader, (), context));
}

impl Engine<Shaded, Drawn> for Retro {
    fn draw(&mut self, shapes: &[Shaded]) {
        let context = Context::default();
        let color = |frag: Frag<Color3f>, ()| frag.var.to_color4();
        if self.kind == Kind::Depth {
            self.frame.depth_buf.data_mut().fill(NOWHERE);
        }
        let sampler = SamplerRepeatPot::new(&self.texture);
        for Shaded { corners, .. } in shapes {
            match self.kind {
                Kind::Levels => {
                    let corners = corners.each_ref().map(|corner| self.levels(corner));
                    rasterize(corners, &mut self.frame.color_buf, &color, &context);
                }
                Kind::Depth => {
                    let corners = corners.each_ref().map(|corner| self.levels(corner));
                    rasterize(corners, &mut self.frame, &color, &context);
                }
                Kind::Texels => {
                    let texture = &self.texture;
                    let color = |frag: Frag<TexCoord>, ()| sampler.sample_abs(texture, frag.var);
                    rasterize(corners.each_ref().map(Self::place), &mut self.wide, &color, &context);
                }
            }
        }
    }

    fn clear(&mut self) {
        self.frame.color_buf.buf.data_mut().fill(u16::MAX);
        self.frame.depth_buf.data_mut().fill(NOWHERE);
        self.wide.buf.data_mut().fill(UNPAINTED);
    }

    fn painted(&self) -> Drawn {
        match self.kind {
            Kind::Levels => read(self.frame.color_buf.buf.data().iter().copied()),
            Kind::Depth => {
                let depth =
                    |&nearness: &f32| if nearness == NOWHERE { f32::INFINITY } else { self.farthest - nearness };
                self.frame.depth_buf.data().iter().map(|nearness| number(depth(nearness))).collect()
            }
            Kind::Texels => self.wide.buf.data().to_vec(),
        }
    }
}

/// Its frame: what it draws on is whatever takes the pixels of embedded-graphics.
struct Pixels(Vec<u16>);

impl DrawTarget for Pixels {
    type Color = Rgb565;
    type Error = Infallible;

    #[inline]
    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(at, color) in pixels {
            if (at.x as u32) < WIDTH as u32 && (at.y as u32) < HEIGHT as u32 {
                self.0[(at.y * WIDTH + at.x) as usize] = RawU16::from(color).into_inner();
            }
        }
        Ok(())
    }
}

impl OriginDimensions for Pixels {
    fn size(&self) -> Size {
        Size::new(WIDTH as u32, HEIGHT as u32)
    }
}

struct Embedded {
    kind: Kind,
    frame: Pixels,
    depths: Vec<u32>,
    textures: TextureManager<1>,
    texture: u32,
}

impl Embedded {
    fn new(kind: Kind) -> Self {
        let side = 1 << TEXTURE;
        let texels: &'static [Rgb565] =
            texels().into_iter().map(|texel| RawU16::new(texel).into()).collect::<Vec<_>>().leak();
        let mut textures = TextureManager::new();
        let texture = textures.add_texture(Texture::new(texels, side, side)).expect("there is room for one");
        Self { kind, frame: Pixels(vec![u16::MAX; PIXELS]), depths: vec![u32::MAX; PIXELS], textures, texture }
    }

    fn primitive(&self, corners: &Triangle) -> DrawPrimitive {
        let points = corners.each_ref().map(|c| Point2::new(c.at[0] >> 8, c.at[1] >> 8));
        let colors = corners.each_ref().map(|c| {
            let [r, g, b] = c.levels.map(|n| n as u8);
            Rgb565::new(r, g, b)
        });
        // They are kept with 16 bits of fraction, which are all that is used here, and cut off behind that.
        let depths = corners.each_ref().map(|c| (c.depth as f32 + 0.5) / 65_536.0);
        let side = (1 << TEXTURE) as f32;
        match self.kind {
            Kind::Levels => DrawPrimitive::GouraudTriangle { points, colors },
            Kind::Depth => DrawPrimitive::GouraudTriangleWithDepth { points, depths, colors },
            Kind::Texels => DrawPrimitive::TexturedTriangleWithDepth {
                points,
                depths: [0.0; 3],
                ws: corners.each_ref().map(|c| c.w as f32),
                uvs: corners.each_ref().map(|c| c.texel.map(|n| n as f32 / side)),
                texture_id: self.texture,
            },
        }
    }
}

impl Engine<Shaded, Drawn> for Embedded {
    fn draw(&mut self, shapes: &[Shaded]) {
        if self.kind != Kind::Levels {
            self.depths.fill(u32::MAX);
        }
        for Shaded { corners, .. } in shapes {
            let primitive = self.primitive(corners);
            match self.kind {
                Kind::Levels => draw(primitive, &mut self.frame),
                Kind::Depth => draw_zbuffered(primitive, &mut self.frame, &mut self.depths, WIDTH as usize),
                Kind::Texels => draw_zbuffered_with_textures(
                    primitive,
                    &mut self.frame,
                    &mut self.depths,
                    WIDTH as usize,
                    &self.textures,
                    None,
                    None,
                ),
            }
        }
    }

    fn clear(&mut self) {
        self.frame.0.fill(u16::MAX);
        self.depths.fill(u32::MAX);
    }

    fn painted(&self) -> Drawn {
        match self.kind {
            Kind::Depth => self.depths.clone(),
            _ => read(self.frame.0.iter().copied()),
        }
    }
}
